"""Symbols that expressions of an effect may contain, and faults of such expressions.

T                     time
coordinate_of(joint)  coordinate of a joint, by its name [rad or m]
speed_of(joint)       its rate [rad/s or m/s]
state_of(name)        state of an effect, "motor.current" [its unit]
Input(name, unit)     value that a run is given over time: measured, tabulated or a function [its unit]
LENGTH, LENGTH_RATE   distance of the two ends of a `LineForce`, and its rate [m, m/s]
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Protocol

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError, one_of
from hertzwerk.derive.common.identifiers import name_faults, text_faults, unit_faults
from hertzwerk.derive.common.units import parse_unit, unit_text
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.notation import text_of
from hertzwerk.derive.expressions.algebra.splines import Table
from hertzwerk.derive.expressions.algebra.tagged import Tagged
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.dimension.walker import check
from hertzwerk.derive.expressions.parameter import TABLE, Parameter, Slot, is_number
from hertzwerk.derive.program.expression_text import EmitError, expression_text

TIME, COORDINATE, SPEED, STATE, REACH, REACH_RATE = "time", "coordinate", "speed", "state", "length", "length rate"
REACTION, NORMAL_FORCE = "reaction", "normal force"
INPUT = "input"
LOADS = (TIME, COORDINATE, SPEED, STATE, INPUT, REACTION, NORMAL_FORCE)
"""Quantities that a force may vary with; anything else that varies, varies with the first five at most."""
HISTORIES = ("t", "energy")
"""Names of histories that no input can have."""


_PLAIN = {
    TIME: "s",
    REACH: "m",
    REACH_RATE: "m/s",
    REACTION: "N",
    NORMAL_FORCE: "N",
}  # units of symbols that need no scene


class Scope(Protocol):
    """Protocol of a scene as expressions refer to it: freedoms with one coordinate, and states, by name."""

    @property
    def scalars(self) -> Mapping[str, Freedom]:
        """Freedoms with one coordinate."""

    @property
    def states(self) -> Mapping[str, Any]:
        """States of effects, which have a `unit`."""

    @property
    def uncounted(self) -> Sequence[str]:
        """Keys of speeds without a coordinate."""

    @property
    def carrying(self) -> Sequence[str]:
        """Joints whose reaction can be read."""

    @property
    def pressed(self) -> Sequence[str]:
        """Pairs with a contact."""


class StateSymbol(Tagged):
    """Time, a coordinate or a speed of a joint, or a state of an effect, in an expression of a scene."""

    __slots__ = ("joint", "quantity")
    tags = ("quantity", "joint")

    @classmethod
    def of(cls, quantity: str, joint: str, ending: str = "") -> StateSymbol:
        """Symbol of what is named; raises InputError if the name is no text."""
        if not isinstance(joint, str):
            expected = 'the name of a joint, or of one of its coordinates: "column.angle"'
            raise InputError(f"{quantity.replace(' ', '_')}_of", [Fault("joint", repr(joint), expected)])
        return cls(joint + ending, quantity, joint)


T = StateSymbol("t", TIME, "")
LENGTH, LENGTH_RATE = StateSymbol("length", REACH, ""), StateSymbol("length_rate", REACH_RATE, "")


class Input(StateSymbol):
    """Function of time that each run supplies, such as a measured torque; a symbol in expressions.

    `unit` is text, `meaning` what lists and tables say of it. Its history has its name:
    `simulate(model, inputs={"torque": ...})`, `run["torque"]`.
    """

    __slots__ = ("meaning", "unit")
    tags = ("unit", "meaning")
    quantity, joint = INPUT, ""

    def __new__(cls, name: str, unit: str, meaning: str = "") -> Input:
        """Make a new symbol; raises InputError for values that are no text."""
        cls.must_be_text("input", name, unit=unit, meaning=meaning)
        return super().__new__(cls, name, unit, meaning)

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of the declaration itself."""
        where = f"input {self.name}"
        yield from name_faults(where, self.name)
        yield from text_faults(f"{where}, meaning", self.meaning)
        if self.name in HISTORIES or self.name.endswith(TABLE):
            yield Fault(
                where, f"the name {self.name!r}", f"a name that is no history of every run, nor ends in {TABLE}"
            )
        yield from unit_faults(where, self.unit, constant=True)


def coordinate_of(joint: str) -> StateSymbol:
    """Coordinate of the joint of this name [rad or m]; raises InputError if the name is no text."""
    return StateSymbol.of(COORDINATE, joint, ".coordinate")


def speed_of(joint: str) -> StateSymbol:
    """Rate of the coordinate of the joint of this name [rad/s or m/s]; raises InputError if no text."""
    return StateSymbol.of(SPEED, joint, ".speed")


def state_of(name: str) -> StateSymbol:
    """State of an effect, such as "motor.current" [its unit]; raises InputError if the name is no text."""
    return StateSymbol.of(STATE, name)


def reaction_of(joint: str) -> StateSymbol:
    """Magnitude of the force that a joint carries [N]; raises InputError if the name is no text.

    Loads may depend on it linearly: it is solved with the accelerations, which depend on the loads.
    """
    return StateSymbol.of(REACTION, joint, ".reaction")


def normal_force_of(pair: str) -> StateSymbol:
    """Normal force of a contact [N], 0 while it is open; raises InputError if the name is no text."""
    return StateSymbol.of(NORMAL_FORCE, pair, ".normal_force")


@dataclass(frozen=True)
class Varying(Slot):
    """Quantity that may vary with some of time, coordinates, speeds, states and inputs."""

    on: tuple[str, ...] = (TIME, COORDINATE, SPEED, STATE, INPUT)
    derivatives: int = 0
    """Number of time derivatives that are taken of it."""


def as_choice(value: Any) -> Any:
    """SymPy expression with Piecewise replaced by differentiable branches; other values pass."""
    if not is_number(value):
        return value
    expression = sp.sympify(value)
    if expression.is_Atom:
        return expression
    return expression.replace(lambda node: isinstance(node, sp.Piecewise), _choice)


def _choice(piecewise: Any) -> Any:
    *earlier, (last, condition) = piecewise.args
    if condition != sp.true:
        return piecewise  # has no value elsewhere: a fault
    for value, condition in reversed(earlier):
        last = Where(condition, value, last)
    return last


def states_in(expression: Any) -> list[StateSymbol]:
    """List time, coordinates and speeds in an expression in order of appearance (never in hash order)."""
    return [node for node in _own_symbols(expression) if isinstance(node, StateSymbol)]


def _own_symbols(expression: Any) -> tuple[Any, ...]:
    """Time, coordinates, speeds and tables in an expression; none in what is no expression."""
    return _symbols_of(expression) if isinstance(expression, sp.Basic) else ()


@lru_cache(maxsize=4096)
def _symbols_of(expression: sp.Basic) -> tuple[Any, ...]:
    symbols = (node for node in sp.preorder_traversal(expression) if isinstance(node, StateSymbol | Table))
    return tuple(dict.fromkeys(symbols))


def inputs_in(expression: Any) -> list[Input]:
    """List the inputs in an expression in order of appearance."""
    return [symbol for symbol in states_in(expression) if isinstance(symbol, Input)]


def tables_in(expression: Any) -> list[Table]:
    """List the tables in an expression in order of appearance."""
    return [node for node in _own_symbols(expression) if isinstance(node, Table)]


def state_dimension(symbol: StateSymbol, scene: Scope) -> Dimension:
    """Dimension of time, of a coordinate or speed of a scene's freedom, or of an effect's state."""
    if symbol.quantity in _PLAIN:
        return Dimension.from_unit(_PLAIN[symbol.quantity])
    if isinstance(symbol, Input):
        return Dimension.from_unit(symbol.unit)
    if symbol.quantity == STATE:
        return Dimension.from_unit(scene.states[symbol.joint].unit)
    coordinate, speed, _ = scene.scalars[symbol.joint].units
    return Dimension.from_unit(coordinate if symbol.quantity == COORDINATE else speed)


_WITHOUT_DERIVATIVES = (
    "An input has no derivatives here: let it be a motion, Drive(position=...), the target of a SpeedController, "
    "or the rest of a spring, JointForce(joint, k*(input - coordinate_of(joint))); what is known beforehand is a Table of T."
)


def shown(value: Any) -> str:
    """Text of an expression for people."""
    return text_of(sp.sympify(value)) if is_number(value) else repr(value)


def expression_faults(
    slot: Varying,
    scene: Scope,
    table: Mapping[sp.Symbol, Dimension],
    constant: Callable[[Slot], Iterator[Fault]],
) -> Iterator[Fault]:
    """Yield faults of the expression in a slot.

    `table` has the dimensions of all sound parameters; `constant` checks quantities that do not vary.
    """
    if not is_number(slot.value) or not (states_in(slot.value) or tables_in(slot.value)):
        yield from constant(slot)
        return
    value, where = as_choice(slot.value), slot.where
    # which `table_faults` and `input_faults` report
    strange = [f for t in tables_in(value) for f in t.faults()] + [f for i in inputs_in(value) for f in i.faults()]
    for symbol in states_in(value):
        if symbol.quantity not in slot.on:
            of = " and ".join(slot.on) if slot.on else "parameters alone"
            way_out = _WITHOUT_DERIVATIVES if isinstance(symbol, Input) else ""
            yield Fault(where, f"{value}, which depends on {symbol}", f"an expression of {of}", way_out)
            return
        unmet = list(_unmet(where, symbol, scene))
        strange += unmet
        yield from unmet
    others = [symbol for symbol in value.free_symbols if not isinstance(symbol, Parameter | StateSymbol)]
    if others:
        named = ", ".join(sorted(map(str, others)))
        yield Fault(
            where,
            f"the symbol {named}",
            "an expression of Parameters, T, coordinate_of(joint), speed_of(joint), state_of(name), inputs and tables",
        )
        return
    if strange:
        return
    known = {**table, **{symbol: state_dimension(symbol, scene) for symbol in states_in(value)}}
    unit = parse_unit(slot.unit)
    fault = check(value, known, Dimension.from_unit(unit, {}), list(table))
    if fault is not None:
        yield Fault(where, f"{fault.subexpression} [{fault.found}]", f"a quantity in {unit_text(unit.exponents)}" if fault.subexpression == str(value)
                    else fault.expected, fault.repair or fault.reason)  # fmt: skip
        return
    yield from smoothness_faults(slot, value)


_NAMED = {
    STATE: ("state {!r}", "states", "a state of an effect, of which the scene has none"),
    REACTION: ("the reaction of {!r}", "carrying", "a joint that carries its body along two directions or more"),
    NORMAL_FORCE: ("the normal force of {!r}", "pressed", "a pair with a Contact, of which the scene has none"),
    **dict.fromkeys(
        (COORDINATE, SPEED),
        ("joint {!r}", "scalars", "a joint with one coordinate, of which the mechanism has none"),
    ),
}
"""Meaning of a symbol: how it is shown, those that a scene has, and what else is expected."""


def _unmet(where: str, symbol: StateSymbol, scene: Scope) -> Iterator[Fault]:
    """Fault of a symbol of what the scene does not have."""
    text, names, otherwise = _NAMED.get(symbol.quantity, ("", "", ""))
    if names and symbol.joint not in getattr(scene, names):
        yield Fault(where, text.format(symbol.joint), one_of(getattr(scene, names), otherwise))
    elif symbol.quantity == COORDINATE and symbol.joint in scene.uncounted:
        yield uncounted_fault(where, symbol.joint)


def uncounted_fault(where: str, key: str) -> Fault:
    """Fault of the coordinate of a speed that has none."""
    return Fault(where, f"the coordinate of {key}, a speed that is the rate of none", "its speed")


def table_faults(expressions: Iterable[Any]) -> Iterator[Fault]:
    """Yield faults of tables in these expressions, and of names that are equal in capitals.

    Modules write names of tables in capitals.
    """
    tables: dict[str, Table] = {}
    for table in (table for expression in expressions for table in tables_in(expression)):
        yield from table.faults()
        if tables.setdefault(str(table.name).upper(), table) != table:
            yield Fault(f"table {table.name}", "two different tables of this name", "names that are unique, in capitals too",
                        "Share one Table object, or rename one.")  # fmt: skip


def input_faults(expressions: Iterable[Any], parameters: Iterable[str]) -> Iterator[Fault]:
    """Yield faults of inputs in these expressions, and of names shared with others or parameters."""
    taken, known = set(parameters), dict[str, Input]()
    for signal in (signal for expression in expressions for signal in inputs_in(expression)):
        yield from signal.faults()
        if known.setdefault(signal.name, signal) != signal:
            yield Fault(f"input {signal.name}", "two different inputs of this name", "names that are unique",
                        "Share one Input object, or rename one.")  # fmt: skip
        if signal.name in taken:
            yield Fault(
                f"input {signal.name}", "a parameter of this name", "names that are unique", "Rename one of them."
            )


def smoothness_faults(slot: Slot, value: Any) -> Iterator[Fault]:
    """Yield faults of an expression or its time derivatives that generated code cannot contain."""
    derivatives, changing = getattr(slot, "derivatives", 0), (T, *inputs_in(value))
    for order in range(derivatives + 1):
        of = ("", "the first derivative of ", "the second derivative of ")[order]
        try:
            expression_text(value)
            value = sp.Add(*(sp.diff(value, by) for by in changing)) if order < derivatives else value
        except EmitError as error:
            yield Fault(slot.where, f"{of}{shown(slot.value)}: {error}", "an expression of known functions, as smooth as its use requires",
                        "A choice is Where(condition, a, b); a position must not jump.")  # fmt: skip
            return
        except ValueError as error:
            yield Fault(slot.where, f"{of}{shown(slot.value)}", "an expression that is smooth enough", str(error))
            return
