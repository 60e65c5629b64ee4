"""Quantities of a model that are searched: their ranges in SI, given or those of their laws."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from hertzwerk.derive.common.faults import Fault, among, shown, unknown
from hertzwerk.derive.common.units import UnitError
from hertzwerk.runtime.engine.model.binding import Value, read, read_parameters, read_state
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.ranges import Range, read_range
from hertzwerk.runtime.engine.model.si_values import si_of, si_units

Freed = str | tuple[Value, Value] | None  # "0.3..1", "1e6..1e9 N/m log", "log", (0.3, 1); None: the law's range

DECADES = 100.0  # ratio of a range's ends from which it is searched by ratios
WIDE = 100.0  # a positive quantity without a range is searched within this factor of the model's value
INSIDE = 1e-9  # part of a range by which an end stays off a value that a law does not have
EXPECTED = 'a range such as "0.3..1" or "1e6..1e9 N/m log", "log", or None for the range of its law'


@dataclass(frozen=True)
class Free(Range):
    """Quantity that is searched, in SI; value: the model's own, or one to begin with; nan without."""

    low: float
    high: float
    name: str
    value: float


def quantities(model: EngineModel) -> dict[str, str]:
    """Return the SI unit text of every parameter and initial state, "" of a number."""
    units = si_units(model)
    return {name: units[name] for name in (*model.parameters, *model.joints.coordinates, *model.joints.speeds)}


def derivative_faults(model: EngineModel, names: Sequence[str]) -> list[Fault]:
    """Return the faults of names of derivatives: none at all, and names of no parameter or initial state."""
    known = quantities(model)
    if not names:
        return [Fault("names", "none", "parameters or initial states", f"such as {next(iter(known))!r}")]
    return [unknown("parameter or initial state", name, known) for name in names if not among(name, *known)]


def read_quantity(model: EngineModel, name: str, value: Value, where: str, faults: list[Fault]) -> float:
    """Return a value of a parameter or initial state in SI; nan with faults appended."""
    if name not in model.parameters:
        si, fault = read_state(where, model.joints.units[name], value)
        wrong = [] if fault is None else [fault]
    else:
        reading = read_parameters(model.declared, {name: value})
        si = reading.si[name]
        wrong = [Fault(where, fault.found, fault.expected, fault.remedy) for fault in reading.faults]
    faults += wrong
    return math.nan if wrong else si


def read_free(
    model: EngineModel, searched: object, faults: list[Fault], *, argument: str = "free", decades: float = DECADES
) -> tuple[Free, ...]:
    """Read what is searched, by name, or names alone; bad input is appended to `faults`.

    argument    its name in faults; decades    ratio of a range's ends from which it is searched by ratios, unasked
    """
    if (
        isinstance(searched, Sequence)
        and not isinstance(searched, str)
        and all(isinstance(name, str) for name in searched)
    ):
        searched = dict.fromkeys(searched)
    if not isinstance(searched, Mapping) or not searched:
        example = 'ranges by name, such as {"restitution": (0.3, 1), "stiffness": "log"}'
        faults.append(Fault(argument, shown(searched), example))
        return ()
    known = quantities(model)
    free = []
    for name, text in searched.items():
        if name not in known:
            faults.append(unknown("parameter or initial state", name, tuple(known)))
            continue
        before = len(faults)
        one = _one(model, name, text, f"{argument}[{name!r}]", known[name] or "1", faults)
        if len(faults) == before and one is not None:
            free.append(replace(one, log=one.log or (one.low > 0 and one.high / one.low >= decades)))
    return tuple(free)


def _one(model: EngineModel, name: str, entry: object, where: str, unit: str, faults: list[Fault]) -> Free | None:
    port = model.parameters.get(name)
    value = si_of(model, name, (port.default, port.unit)) if port is not None else math.nan
    asked_log = among(entry, "log")
    if entry is None or asked_log:
        low, high = _ranges_of_law(model, name)
        bounded = math.isfinite(low) and math.isfinite(high)
        if not bounded or (asked_log and low <= 0):
            if not value > 0:
                faults.append(
                    Fault(where, "no range", 'a range, such as "-1..1 mm"', "neither its law nor its value gives one")
                )
                return None
            low, high = max(low, value / WIDE), min(high, value * WIDE)
            asked_log = True
    else:
        ends = _ends(where, entry, faults)
        if ends is None:
            return None
        texts, asked_log = ends
        low, high = (_end(model, name, text, where, faults) for text in texts)
    low, high = _off_open_ends(model, name, low, high)
    if not low < high:
        if math.isfinite(low + high):
            expected = "the smaller end first, within the range of its law"
            faults.append(Fault(where, f"{low:g}..{high:g} {unit}", expected))
        return None
    if asked_log and low <= 0:
        faults.append(Fault(where, shown(entry), "ends above zero, as the values have equal ratios"))
        return None
    return Free(low, high, unit, asked_log, name, value)


def _ends(where: str, entry: object, faults: list[Fault]) -> tuple[tuple[Value, Value], bool] | None:
    """Return both ends of a range with their units, and whether it is logarithmic."""
    if isinstance(entry, str) and ".." in entry:
        span = read_range(where, entry, True, faults)
        if not isinstance(span, Range):
            return None
        return ((float(span.low), span.unit), (float(span.high), span.unit)), span.log
    if isinstance(entry, tuple) and len(entry) == 2:
        try:
            for end in entry:
                read(end)
        except UnitError as error:
            faults.append(Fault(where, shown(entry), EXPECTED, str(error)))
            return None
        return entry, False
    faults.append(Fault(where, shown(entry), EXPECTED))
    return None


def _end(model: EngineModel, name: str, value: Value, where: str, faults: list[Fault]) -> float:
    """Return an end of a range in SI; one at an open end of the law's is no fault."""
    si = si_of(model, name, value)
    rows = _limits(model, name)
    if si in {end for row in rows for end, is_open in zip(row[2:4], row[4:6], strict=True) if is_open}:
        return si
    return read_quantity(model, name, value, where, faults)


def _limits(model: EngineModel, name: str) -> list[tuple[str, str, float | None, float | None, bool, bool, str]]:
    return [row for row in model.module.LIMITS if row[0] == name and row[1] == "defined"]


def _ranges_of_law(model: EngineModel, name: str) -> tuple[float, float]:
    """Return the range [SI] in which all laws of a parameter are defined; infinite where they say nothing."""
    rows = _limits(model, name)
    low = max((row[2] for row in rows if row[2] is not None), default=-math.inf)
    high = min((row[3] for row in rows if row[3] is not None), default=math.inf)
    return low, high


def _off_open_ends(model: EngineModel, name: str, low: float, high: float) -> tuple[float, float]:
    step = INSIDE * (high - low)
    for _, _, lower, upper, lower_open, upper_open, _ in _limits(model, name):
        low = low + step if lower_open and low == lower else low
        high = high - step if upper_open and high == upper else high
    return low, high
