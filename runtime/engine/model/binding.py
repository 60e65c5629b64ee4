"""Numbers with units, read against a module's declarations, with every fault at once."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, shown, unknown
from hertzwerk.derive.common.units import Unit, UnitError, parse_unit, rate_remedy, split_quantity

Value: TypeAlias = str | float | tuple[float, str]  # "0.2 mm"; a bare number where dimensionless; (0.2, "mm")
Range: TypeAlias = tuple[str, float | None, float | None, bool, bool, str]
Limit: TypeAlias = tuple[str, *Range]  # a row of a module's LIMITS
SumLimit: TypeAlias = tuple[tuple[tuple[str, float], ...], *Range]  # a row of its SUM_LIMITS


@dataclass(frozen=True)
class Port:
    """Parameter as declared by a module; the default is in `unit`."""

    name: str
    unit: str
    default: float
    meaning: str


@dataclass(frozen=True)
class Reading:
    """Parameters as read: SI values and texts (value, unit), with warnings and faults."""

    si: Mapping[str, float]
    texts: Mapping[str, tuple[float, str]]
    warnings: tuple[str, ...]
    faults: tuple[Fault, ...]


class Declared:
    """Parameters and their limits as a module declares them, with the defaults read once.

    si, texts  defaults in SI, and as (value, unit)
    followers  parameters whose unit depends on another one, by the name of that one
    plain  parameters whose unit depends on none
    unsound  parameters whose default is no finite number, or outside a limit
    """

    def __init__(self, ports: Mapping[str, Port], limits: Sequence[Limit], sums: Sequence[SumLimit] = ()) -> None:
        self.ports, self.limits, self.sums = ports, limits, sums
        units = {name: parse_unit(port.unit) for name, port in ports.items()}
        self.si = {name: unit.to_si(ports[name].default) for name, unit in units.items()}
        self.texts = {name: (port.default, port.unit) for name, port in ports.items()}
        free = {name: unit.free_names for name, unit in units.items()}
        self.plain = {name for name in ports if not free[name]}
        self.followers = {name: tuple(other for other in ports if name in free[other]) for name in ports}
        self.unsound = {name for name, value in self.si.items() if not math.isfinite(value)}
        self.unsound |= {limit[0] for limit in limits if not _inside(self.si[limit[0]], limit)}


def read_parameters(declared: Declared, parameters: Mapping[str, Value]) -> Reading:
    """Read `parameters` over the defaults."""
    ports = declared.ports
    faults: list[Fault] = []
    stated: dict[str, tuple[float, Unit, str]] = {}
    for name, value in named_values("parameters", parameters, faults).items():
        if name not in ports:
            faults.append(unknown("parameter", name, ports))
            continue
        try:
            stated[name] = read(value)
        except UnitError as error:
            faults.append(Fault(name, shown(value), _value_in(ports[name].unit), str(error)))
    si, texts = dict(declared.si), dict(declared.texts)
    for name, (value, unit, text) in stated.items():
        si[name], texts[name] = unit.to_si(value), (value, text)
    concerned = {follower for name in stated for follower in declared.followers[name]}
    concerned |= {
        name for name, (_, _, text) in stated.items() if name not in declared.plain or text != ports[name].unit
    }
    judged = {*stated, *concerned, *declared.unsound}
    for name in filter(judged.__contains__, ports):
        fault = _unit_fault(ports[name], ports, stated, si) if name in concerned else None
        if fault is None and not math.isfinite(si[name]):
            fault = Fault(name, quantity_text(*texts[name]), "a finite number")
        if fault is not None:
            faults.append(fault)
    judged -= {fault.where for fault in faults}
    warnings = []
    for limit in declared.limits:
        if limit[0] not in judged or _inside(si[limit[0]], limit):
            continue
        name, kind, *_, why = limit
        actual, allowed = quantity_text(*texts[name]), _interval(limit, ports[name].unit)
        if kind == "defined":
            faults.append(Fault(name, actual, f"a value in {allowed}", why))
        else:
            warnings.append(f"{name} = {actual} is outside the recommended {allowed}. {why}")
    for sum_limit in declared.sums:
        terms, *_, quantity = sum_limit
        names = [name for name, _ in terms]
        value = sum(factor * si[name] for name, factor in terms)
        if judged.isdisjoint(names) or _inside(value, sum_limit) or not math.isfinite(value):
            continue
        declared_in = ports[names[0]].unit
        of = " and ".join(f"{name} = {quantity_text(*texts[name])}" for name in names)
        actual = f"{quantity_text(value, str(parse_unit(declared_in)))}, of {of}"
        faults.append(Fault(quantity, actual, f"a value in {_interval(sum_limit, declared_in)}", "Change one of them."))
    return Reading(si, texts, tuple(warnings), tuple(faults))


def _unit_fault(
    port: Port, ports: Mapping[str, Port], stated: Mapping[str, tuple[float, Unit, str]], si: Mapping[str, float]
) -> Fault | None:
    """Return the fault of a parameter whose unit is not the declared one; None if it is."""
    declared = parse_unit(port.unit)
    exponents = {name: si[name] for name in declared.free_names if name in si and math.isfinite(si[name])}
    if port.name not in stated:
        changed = [name for name in declared.free_names if name in stated and si[name] != ports[name].default]
        if not changed:
            return None
        now = declared.at(exponents)
        other = f"{changed[0]}={si[changed[0]]:g}"
        actual = f"its default in {declared.at(_exponents(ports))}, kept with {other}"
        remedy = f'give both: {port.name}="... {now}" and {other}; the same number in another unit is another stiffness'
        return Fault(port.name, actual, f"{port.name} given anew with its unit, {now}", remedy)
    value, unit, text = stated[port.name]
    if unit.free_names:
        named = [name for name in unit.free_names if name in stated or name not in ports]
        if named:
            return Fault(
                port.name, quantity_text(value, text), f"a number for {named[0]}, such as {declared.at(exponents)}"
            )
        unit = unit.at(_exponents(ports))
    expected = declared.at(exponents)
    if unit.exponents == expected.exponents:
        return _angle_fault(port.name, value, unit, text, port.unit)
    if not exponents or text == "1":
        return _wrong_unit(port.name, value, unit, text, port.unit)
    follows = ", ".join(f"{name} = {number:g}" for name, number in exponents.items())
    remedy = f"the exponent follows {follows}; set both so that they agree"
    return Fault(port.name, f"{quantity_text(value, text)}, which is {unit}", f"a value in {expected}", remedy)


def named_values(where: str, values: object, faults: list[Fault]) -> Mapping[str, Value]:
    """Return values by name; anything but a mapping is appended to `faults`."""
    if isinstance(values, Mapping):
        return values
    faults.append(Fault(where, shown(values), 'values by name, such as {"clearance": "0.2 mm"}'))
    return {}


def read_state(name: str, declared: str, value: Value) -> tuple[float, Fault | None]:
    """Return the SI value of a state declared in some unit, and its fault or None."""
    try:
        number, unit, text = read(value)
    except UnitError as error:
        return math.nan, Fault(name, shown(value), _value_in(declared), str(error))
    if unit.exponents != parse_unit(declared).exponents:
        return math.nan, _wrong_unit(name, number, unit, text, declared)
    mistaken = _angle_fault(name, number, unit, text, declared)
    if mistaken is not None:
        return math.nan, mistaken
    finite = math.isfinite(si := unit.to_si(number))
    return si, None if finite else Fault(name, quantity_text(number, text), "a finite number")


def si_of_all(where: str, unit: str, values: Any) -> np.ndarray:
    """Return one or more numbers, in an SI unit or with their own, as an array (n,); raises InputError."""
    value = plain_value(values)
    try:
        if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str):
            numbers, of = np.asarray(value[0], dtype=float), parse_unit(value[1])
        elif isinstance(value, str):
            number, of, _ = read(value)
            numbers = np.asarray(number)
        else:
            numbers, of = np.asarray(value, dtype=float), parse_unit(unit)
    except (UnitError, TypeError, ValueError) as error:
        raise InputError(
            where, [Fault(where, shown(values), f"numbers in {unit}, or values with a unit", str(error))]
        ) from None
    if of.exponents != parse_unit(unit).exponents:
        raise InputError(where, [Fault(where, f"{shown(values)}, which is {of}", f"a value in {unit}")])
    factor = of.to_si(1.0)
    return np.atleast_1d(np.asarray(factor * numbers if factor != 1 else numbers))


def times_within(times: Any, first: float, last: float) -> np.ndarray:
    """Return one or more times [s] of a run as an array (n,); raises InputError, also outside it."""
    read = si_of_all("times", "s", times)
    if read.ndim != 1 or not (read.min(initial=first) >= first and read.max(initial=last) <= last):
        expected = f"them within {first:g}..{last:g} s"
        raise InputError("times", [Fault("times", "some outside the run, or not in one row", expected)])
    return read


def read_time(where: str, text: str, expected: str, faults: list[Fault]) -> float:
    """Return the seconds of text such as "24 ms"; nan and a fault if it is no positive time."""
    try:
        value, unit, _ = read(text)
    except UnitError as error:
        faults.append(Fault(where, shown(text), expected, str(error)))
        return math.nan
    seconds = unit.to_si(value) if unit.exponents == parse_unit("s").exponents else math.nan
    if math.isfinite(seconds) and seconds > 0:
        return seconds
    faults.append(Fault(where, repr(text), expected))
    return math.nan


def whole_faults(**numbers: object) -> list[Fault]:
    """Return a fault for each of these that is no whole number from 0 on."""
    return [
        Fault(name, shown(value), "a whole number from 0 on")
        for name, value in numbers.items()
        if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value < 2**63
    ]


def flag_faults(**flags: object) -> list[Fault]:
    """Return a fault for each of these that is neither True nor False."""
    return [Fault(name, shown(value), "True or False") for name, value in flags.items() if not isinstance(value, bool)]


def _exponents(ports: Mapping[str, Port]) -> dict[str, float]:
    """Return the defaults of everything that may stand in an exponent."""
    return {name: port.default for name, port in ports.items() if parse_unit(port.unit).dimensionless}


def plain_value(value: Any) -> Any:
    """Return a quantity of pint or astropy, or a fitted value, as (number, unit text).

    Recognised by their attributes, so that neither is imported; other values are returned as they are.
    """
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return value.magnitude, f"{value.units:~C}" or "1"
    unit: Any = getattr(value, "unit", None)
    if hasattr(unit, "bases") and hasattr(value, "value"):
        powers = " ".join(f"{base}^({power})" for base, power in zip(unit.bases, unit.powers, strict=True))
        return value.value * unit.scale, powers or "1"
    return (value.value, unit or "1") if isinstance(unit, str) and hasattr(value, "value") else value


def read(value: Value) -> tuple[float, Unit, str]:
    """Read a value as (number, unit, unit text); a bare number has the unit "1". Raises UnitError."""
    value = plain_value(value)
    if isinstance(value, str):
        number, text = split_quantity(value)
        return number, parse_unit(text), text
    number, text = value if isinstance(value, tuple) and len(value) == 2 else (value, "1")
    real = isinstance(number, int | float | np.number) and not isinstance(number, bool)
    if not real or not isinstance(text, str):
        expected = "text with a unit such as '0.2 mm', (0.2, 'mm'), or a number where dimensionless"
        raise UnitError(f"found {shown(value)}, expected {expected}")
    try:
        return float(number), parse_unit(text), text
    except OverflowError as error:
        raise UnitError("found a number beyond the range of a double") from error


def _wrong_unit(name: str, value: float, unit: Unit, text: str, declared: str) -> Fault:
    if text == "1":
        actual = f"{value:g}, a number without a unit"
        remedy = f'write "{value:g} {declared}", or the unit that is meant'
    else:
        actual, remedy = f"{quantity_text(value, text)}, which is {unit}", ""
    return Fault(name, actual, _value_in(declared), remedy)


def _angle_fault(name: str, value: float, unit: Unit, text: str, declared: str) -> Fault | None:
    """Return the fault of a frequency given for an angular speed, or the reverse."""
    if not unit.mistaken_for(parse_unit(declared)):
        return None
    quantity = "an angular speed" if unit.angle else "a frequency"
    return Fault(name, f"{quantity_text(value, text)}, {quantity}", _value_in(declared), rate_remedy(unit, value))


def _value_in(unit: str) -> str:
    return "a number" if unit == "1" else f"a value in {unit}"


def _inside(value: float, limit: Limit | SumLimit) -> bool:
    _, _, lower, upper, lower_open, upper_open, _ = limit
    above = lower is None or (value > lower if lower_open else value >= lower)
    below = upper is None or (value < upper if upper_open else value <= upper)
    return above and below


def _interval(limit: Limit | SumLimit, unit: str) -> str:
    """Format bounds in SI: "(0, 1]"."""
    _, _, lower, upper, lower_open, upper_open, _ = limit
    left = "(-inf" if lower is None else f"{'(' if lower_open else '['}{lower:g}"
    right = "inf)" if upper is None else f"{upper:g}{')' if upper_open else ']'}"
    si = str(parse_unit(unit))
    return f"{left}, {right}{'' if si == '1' else ' ' + si}"


def quantity_text(value: float, unit: str) -> str:
    """Format a value with its unit."""
    return f"{value:g}" if unit == "1" else f"{value:g} {unit}"
