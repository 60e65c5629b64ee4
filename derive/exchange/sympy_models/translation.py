"""Symbols of a SymPy model as those of a scene: parameters, coordinates, speeds, specified functions."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

import sympy as sp
from sympy.core.function import AppliedUndef

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.identifiers import name_faults, unit_faults
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.declare.effects.state_expression import T, coordinate_of, speed_of, states_in
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Port
from hertzwerk.derive.exchange.sympy_models.model_equations import Reading
from hertzwerk.derive.exchange.sympy_models.to_sympy import TIME
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension
from hertzwerk.derive.expressions.parameter import Parameter, is_number

METRE = Dimension.from_unit("m")
SECOND = Dimension.from_unit("s")
TURNING = Dimension.from_unit("rad/s")
COORDINATES: dict[Dimension, tuple[Literal["turn", "slide"], str, str, str, str]] = {
    METRE: ("slide", "travel", "m", "m/s", "N"),
    ONE: ("turn", "angle", "rad", "rad/s", "N m"),
}
"""Kind of freedom, name of its coordinate, and units of coordinate, speed and force, by the dimension of the coordinate."""
SPEEDS = {METRE / SECOND, TURNING}


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
        partner = {rate: coordinate for coordinate, rate in self.reading.rates.items()}
        minimal = set(partner) == set(u) and len(partner) == len(q)
        keys = {s: name_of(partner[s] if minimal else s) for s in u}
        speeds = [] if self.reading.lagrangian is not None else list(u)
        others = [a for a in atoms_of(self.expressions) if a not in q and a not in speeds]
        for name, count in Counter(map(name_of, [*q, *speeds, *others])).items():
            if count > 1:
                self.faults.append(Fault(f"symbol {name}", f"{count} symbols of this name", "names that are unique"))
        moving = {atom: self._specified(atom) for atom in others if isinstance(atom, AppliedUndef)}
        constants = {atom: self._parameter(atom) for atom in others if atom not in moving}
        for atom in q:
            self._dimension_among(COORDINATES, "coordinate", atom, "m or rad")
        for atom in () if minimal else u:
            self._dimension_among(SPEEDS, "speed", atom, "m/s or rad/s")
        instead: dict[Any, Any] = {TIME: T, **constants, **moving}
        for atom, value in moving.items():
            if all(symbol == T for symbol in states_in(value)):
                instead |= {atom.diff(TIME, order): sp.diff(value, T, order) for order in (1, 2)}
        for name in dict.fromkeys([*map(name_of, q), *keys.values()]):
            self.faults += name_faults(f"coordinate {name}", name)
        if minimal:
            self.table |= {s: self.table.get(partner[s], ONE) / SECOND for s in u}
        instead |= {s: coordinate_of(name_of(s)) for s in q} | {s: speed_of(keys[s]) for s in u}
        derivatives = self.reading.derivatives
        self._unknown_derivatives({*instead, *derivatives})
        rates = {d: rate.xreplace(instead) for d, rate in derivatives.items() if d not in instead}
        self._unknown_entries([*q, *u, *others])
        parameters = {name_of(atom): parameter for atom, parameter in constants.items()}
        return Names(self.table, parameters, instead | rates, minimal, keys, *self._freedoms(minimal, keys), moving)

    def _dimension(self, atom: Any) -> Dimension | None:
        name = name_of(atom)
        if name not in self.units:
            expected = "the unit of every symbol of the model"
            self.faults.append(Fault(f"symbol {name}", "no unit", expected, f"units={{{name}: ...}}"))
        elif faults := [*unit_faults(f"symbol {name}", self.units[name], constant=True)]:
            self.faults += faults
        else:
            self.table[atom] = Dimension.from_unit(parse_unit(self.units[name]))
        return self.table.get(atom)

    def _dimension_among(self, known: Collection[Dimension], kind: str, atom: Any, expected: str) -> None:
        of = self._dimension(atom)
        if of is not None and of not in known:
            self.faults.append(Fault(f"{kind} {name_of(atom)}", f"unit {self.units[name_of(atom)]}", expected))

    def _parameter(self, atom: Any) -> Parameter:
        name = name_of(atom)
        self._dimension(atom)
        self.faults += name_faults(f"symbol {name}", name)
        value = self.values.get(name, 0.0)
        if name not in self.values:
            expected = "the value of every symbol that is constant"
            self.faults.append(Fault(f"symbol {name}", "no value", expected, f"parameters={{{name}: ...}}"))
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
        of_q = [_freedom(name_of(s), self.table.get(s, ONE)) for s in self.reading.q]
        if minimal:
            return tuple(of_q), (), ()
        of_u = [_freedom(key, self.table.get(s, TURNING) * SECOND) for s, key in keys.items()]
        unpaired = [replace(freedom, kind="given", speeds=(), forces=()) for freedom in of_q]
        unpaired += [replace(freedom, kind="given", coordinates=()) for freedom in of_u]
        return tuple(unpaired), (*of_q, *of_u), tuple(keys.values())

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
        self.unused += [
            Fault(f"{label}, {name}", "no such symbol in the model", "a symbol that it depends on")
            for label, entries in (("values", self.values), ("specified", self.specified))
            for name in entries
            if name not in known
        ]


def _freedom(key: str, dimension: Dimension) -> Freedom:
    """Freedom of one coordinate of this dimension, of an angle where it has none that is possible."""
    kind, label, unit, pace, force = COORDINATES.get(dimension, COORDINATES[ONE])
    return Freedom(kind, key, None, (Port(f"{key}.{label}", unit),), (Port(f"{key}.speed", pace),), (Port(key, force),))
