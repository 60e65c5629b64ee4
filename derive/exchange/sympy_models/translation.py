"""Symbols of a SymPy model as those of a scene: parameters, coordinates, speeds, specified functions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import sympy as sp
from sympy.core.function import AppliedUndef

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.common.units import UnitError, parse_unit
from hertzwerk.derive.declare.effects.state_expression import T, coordinate_of, speed_of, states_in
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Port
from hertzwerk.derive.exchange.sympy_models.model_equations import Reading
from hertzwerk.derive.exchange.sympy_models.to_sympy import TIME
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension
from hertzwerk.derive.expressions.parameter import Parameter, is_number

METRE = Dimension.from_unit("m")
SECOND = Dimension.from_unit("s")
TURNING = Dimension.from_unit("rad/s")
SPEEDS = {Dimension.from_unit("m/s"): ("m/s", "N"), TURNING: ("rad/s", "N m")}
"""Unit of a speed, and of its generalised force, by the dimension."""
COORDINATES: dict[Dimension, tuple[str, Literal["turn", "slide"], str]] = {
    METRE: ("m", "slide", "travel"),
    ONE: ("rad", "turn", "angle"),
}
"""Unit, kind of freedom, and name of a coordinate, by the dimension."""


def name_of(symbol: Any) -> str:
    """Name of a symbol or a function of time."""
    return str(symbol.func.__name__ if isinstance(symbol, AppliedUndef) else symbol.name)


def parts_of(expressions: Iterable[Any]) -> Iterator[Any]:
    """Yield every part of expressions once, in order of appearance; functions of time are whole."""
    visited: set[Any] = set()
    pending = [*reversed(list(expressions))]
    while pending:
        node = pending.pop()
        if node in visited:
            continue
        visited.add(node)
        yield node
        if not isinstance(node, AppliedUndef):
            pending.extend(reversed(node.args))


def atoms_of(expressions: Iterable[Any]) -> list[Any]:
    """Symbols and functions of time in expressions, but for time, in order of appearance."""
    return [part for part in parts_of(expressions) if isinstance(part, sp.Symbol | AppliedUndef) and part != TIME]


@dataclass(frozen=True, eq=False)
class Names:
    """Dimensions of SymPy's symbols, and what stands for each in a scene.

    minimal  whether each speed is the derivative of one coordinate
    keys     name of the row of each speed: of its coordinate, where it is the derivative of one
    """

    table: Mapping[Any, Dimension]
    parameters: Mapping[str, Parameter]
    instead: Mapping[Any, Any]
    minimal: bool
    keys: Mapping[Any, str]
    freedoms: tuple[Freedom, ...]
    measured: tuple[Freedom, ...]
    uncounted: tuple[str, ...]
    moving: Mapping[Any, Any]
    """Functions of time that are specified."""

    def of(self, expression: Any) -> Any:
        """An expression of SymPy's in the scene's symbols."""
        return expression.xreplace(self.instead)


class Naming:
    """Translation of a reading by units, values and specified functions; faults are collected."""

    def __init__(
        self, reading: Reading, expressions: list[Any], units: Mapping[Any, str], values: Mapping[Any, float],
        specified: Mapping[Any, Any],
    ) -> None:  # fmt: skip
        self.reading, self.expressions = reading, expressions
        self.faults: list[Fault] = []
        self.unused: list[Fault] = []
        """Faults of entries for no symbol, beside which units can be judged."""
        self.units, self.values = self._by_name("units", units), self._by_name("values", values)
        self.specified = self._by_name("specified", specified)
        self.table: dict[Any, Dimension] = {TIME: SECOND}

    def _by_name(self, label: str, entries: Any) -> dict[str, Any]:
        """Entries by the name of a symbol; a text counts as the name."""
        if not isinstance(entries, Mapping):
            self.faults.append(Fault(label, shown(entries), "a mapping of symbols, {m: ...}"))
            return {}
        by_name: dict[str, Any] = {}
        for key, value in entries.items():
            if isinstance(key, str | sp.Symbol | AppliedUndef):
                by_name[key if isinstance(key, str) else name_of(key)] = value
            else:
                self.faults.append(Fault(label, shown(key), "a symbol of the model, or its name"))
        return by_name

    def names(self) -> Names:
        """The names, sound if there are no faults."""
        q, u = self.reading.q, self.reading.u
        minimal, partner = self._partners()
        speeds = [] if self.reading.lagrangian is not None else list(u)
        others = [a for a in atoms_of(self.expressions) if a not in q and a not in speeds]
        parameters: dict[str, Parameter] = {}
        instead: dict[Any, Any] = {TIME: T}
        for name, count in Counter(map(name_of, [*q, *speeds, *others])).items():
            if count > 1:
                self.faults.append(Fault(f"symbol {name}", f"{count} symbols of this name", "names that are unique"))
        moving: dict[Any, Any] = {}
        for atom in others:
            if isinstance(atom, AppliedUndef):
                moving[atom] = self._specified(atom)
            else:
                parameters[name_of(atom)] = instead[atom] = self._parameter(atom)
        for atom in q:
            self._coordinate(atom)
        if not minimal:
            for atom in speeds:
                self._dimension(atom)
        for atom, value in moving.items():
            instead[atom] = value
            if all(symbol == T for symbol in states_in(value)):
                instead |= {atom.diff(TIME, order): sp.diff(value, T, order) for order in (1, 2)}
        names = [name_of(s) for s in q] if minimal else [*map(name_of, q), *map(name_of, u)]
        for name in names:
            self.faults += name_faults(f"coordinate {name}", name)
        keys = {s: name_of(partner[s]) for s in u} if minimal else {s: name_of(s) for s in u}
        if minimal:
            for s in u:
                self.table[s] = self.table.get(partner[s], Dimension.from_unit("1")) / SECOND
        freedoms, measured, uncounted = self._freedoms(minimal, keys)
        instead |= {s: coordinate_of(name_of(s)) for s in q} | {s: speed_of(keys[s]) for s in u}
        derivatives = self.reading.derivatives
        self._unknown_derivatives({*instead, *derivatives})
        rates = {d: rate.xreplace(instead) for d, rate in derivatives.items() if d not in instead}
        self._unknown_entries([*q, *u, *others])
        return Names(self.table, parameters, instead | rates, minimal, keys, freedoms, measured, uncounted, moving)

    def _partners(self) -> tuple[bool, dict[Any, Any]]:
        """Whether each speed is the derivative of one coordinate, and of which."""
        partner = {rate: q for q, rate in self.reading.rates.items()}
        return set(partner) == set(self.reading.u) and len(partner) == len(self.reading.q), partner

    def _dimension(self, atom: Any) -> Dimension | None:
        name = name_of(atom)
        if name not in self.units:
            self.faults.append(
                Fault(f"symbol {name}", "no unit", "the unit of every symbol of the model", f"units={{{name}: ...}}")
            )
            return None
        try:
            unit = parse_unit(self.units[name])
        except UnitError as error:
            self.faults.append(Fault(f"symbol {name}", f"unit {shown(self.units[name])}", "a unit", str(error)))
            return None
        if unit.free_names:
            self.faults.append(
                Fault(f"symbol {name}", f"unit {self.units[name]}", "a unit without a symbolic exponent")
            )
            return None
        self.table[atom] = Dimension.from_unit(unit)
        return self.table[atom]

    def _coordinate(self, atom: Any) -> None:
        of = self._dimension(atom)
        if of is not None and of not in COORDINATES:
            self.faults.append(Fault(f"coordinate {name_of(atom)}", f"unit {self.units[name_of(atom)]}", "m or rad"))

    def _parameter(self, atom: Any) -> Parameter:
        name = name_of(atom)
        self._dimension(atom)
        self.faults += name_faults(f"symbol {name}", name)
        value = self.values.get(name, 0.0)
        if name not in self.values:
            self.faults.append(
                Fault(
                    f"symbol {name}",
                    "no value",
                    "the value of every symbol that is constant",
                    f"parameters={{{name}: ...}}",
                )
            )
        elif isinstance(value, bool) or not isinstance(value, int | float):
            self.faults.append(Fault(f"symbol {name}", f"value {shown(value)}", "a number, in the unit given"))
            value = 0.0
        return Parameter(name, self.units.get(name, "1") if isinstance(self.units.get(name), str) else "1", value)

    def _specified(self, atom: Any) -> Any:
        name = name_of(atom)
        self._dimension(atom)
        value = self.specified.get(name)
        if not is_number(value):
            actual = "neither a coordinate nor a speed, and not specified" if value is None else shown(value)
            self.faults.append(Fault(f"function {name}(t)", actual, "an expression of T, coordinates and Parameters, or an Input",
                                     f"specified={{{name}: ...}}"))  # fmt: skip
            return sp.S.Zero
        return sp.sympify(value)

    def _freedoms(
        self, minimal: bool, keys: Mapping[Any, str]
    ) -> tuple[tuple[Freedom, ...], tuple[Freedom, ...], tuple[str, ...]]:
        q = {s: COORDINATES.get(self.table.get(s, ONE), COORDINATES[ONE]) for s in self.reading.q}
        ports = {s: Port(f"{name_of(s)}.{label}", unit) for s, (unit, _, label) in q.items()}
        rates = {"m": (("m/s"), "N"), "rad": ("rad/s", "N m")}
        whole = []
        for s, (unit, kind, _) in q.items():
            key = name_of(s)
            pace, force = rates[unit]
            whole.append(Freedom(kind, key, None, (ports[s],), (Port(f"{key}.speed", pace),), (Port(key, force),)))
        if minimal:
            return tuple(whole), (), ()
        alone = [Freedom("given", freedom.key, None, freedom.coordinates, (), ()) for freedom in whole]
        for s in self.reading.u:
            of = self.table.get(s)
            if of is not None and of not in SPEEDS:
                self.faults.append(Fault(f"speed {keys[s]}", f"unit {self.units[keys[s]]}", "m/s or rad/s"))
            pace, force = SPEEDS.get(of or TURNING, SPEEDS[TURNING])
            alone.append(
                Freedom("given", keys[s], None, (), (Port(f"{keys[s]}.speed", pace),), (Port(keys[s], force),))
            )
            unit, kind, label = COORDINATES[ONE if pace == "rad/s" else METRE]
            whole.append(
                Freedom(kind, keys[s], None, (Port(f"{keys[s]}.{label}", unit),), alone[-1].speeds, alone[-1].forces)
            )
        return tuple(alone), tuple(whole), tuple(keys[s] for s in self.reading.u)

    def _unknown_derivatives(self, known: set[Any]) -> None:
        """Note derivatives that nothing determines."""
        derivatives = (
            part for part in parts_of(self.expressions) if isinstance(part, sp.Derivative) and part not in known
        )
        for derivative in sorted(derivatives, key=str):
            self.faults.append(Fault(f"derivative {derivative}", "no value", "derivatives of coordinates, and of functions of time alone",
                                     "A specified load may be an Input or vary with the motion; a specified motion is an "
                                     "expression of T, or a coordinate with a Drive."))  # fmt: skip

    def _unknown_entries(self, atoms: list[Any]) -> None:
        known = {name_of(atom) for atom in atoms if isinstance(atom, sp.Symbol | AppliedUndef)}
        for label, entries in (("values", self.values), ("specified", self.specified)):
            for name in entries:
                if name not in known:
                    self.unused.append(
                        Fault(f"{label}, {name}", "no such symbol in the model", "a symbol that it depends on")
                    )
