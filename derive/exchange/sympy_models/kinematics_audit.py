"""Kinematics of a SymPy model: velocities as set, against those that follow from positions and axes.

SymPy forms equations with any velocity of a point and any angular velocity of a frame, whatever its position and its
orientation say. Both are compared at random states, in extended precision, with positions and axes a little later along
the motion. What differs is named where it begins, not at the frames and points that inherit it.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from itertools import pairwise
from typing import Any

import sympy as sp
from mpmath import mp, mpf
from sympy.core.function import AppliedUndef
from sympy.physics.vector import Vector

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.state_expression import states_in
from hertzwerk.derive.exchange.sympy_models.model_equations import Reading, connected, mass_centre
from hertzwerk.derive.exchange.sympy_models.to_sympy import TIME
from hertzwerk.derive.exchange.sympy_models.translation import Names
from hertzwerk.derive.expressions.parameter import Parameter

DIGITS, STEP = 50, mpf(10) ** -25  # a difference is exact to about 25 digits
TOLERANCE = 1e-9  # of the largest velocity: constants of a model may be floating-point numbers
STATES, TRIES, ROUNDS = 2, 12, 60
LONGEST = 300  # of a velocity in a message, in characters
REMEDY = (
    "Check the signs, the order of rotations, the frame in which a point is fixed, and the origin; "
    'from_sympy(..., kinematics="as given") accepts it unchanged.'
)
FUNCTIONS: Mapping[Any, Callable[..., Any]] = {
    sp.Add: lambda *terms: sum(terms), sp.Mul: lambda *factors: mp.fprod(factors), sp.Pow: lambda a, b: a**b,
    sp.sin: mp.sin, sp.cos: mp.cos, sp.tan: mp.tan,
}  # fmt: skip

Numbers = Mapping[Any, Any]
"""Values of symbols and functions; columns of points, and matrices of axes or turning (the vector product w x ...) of frames."""


def kinematic_faults(reading: Reading, names: Names) -> list[Fault]:
    """Faults of angular velocities and velocities that do not follow from axes and positions.

    They need to follow only where the model's constraints hold. Points are compared if they have positions from the
    origin; other points than mass centres may move as material points of a frame, as where wheels touch.
    """
    if reading.frame is None:
        return []
    with mp.workdps(DIGITS):
        return _Kinematics(reading, names).faults()


class _Kinematics:
    """Frames and points of a model as functions of a state."""

    def __init__(self, reading: Reading, names: Names) -> None:
        self.reading, self.names = reading, names
        self.axes, self.turned = (connected([reading.frame], of) for of in ("_dcm_dict", "_ang_vel_dict"))
        self.places: dict[Any, Any] = {} if reading.origin is None else {reading.origin: None}
        for point, other in connected([*self.places], "_pos_dict").items():
            if other in self.places and self._is_oriented(point._pos_dict[other]):
                self.places[point] = other
        rank = {frame: i for i, frame in enumerate(self.axes)}
        self.turns = {
            (frame, other): vector for frame in self.axes for other, vector in frame._ang_vel_dict.items()
            if rank.get(other, len(rank)) < rank[frame] and self._is_oriented(vector)
        }  # fmt: skip
        velocities = {point: point._vel_dict.get(reading.frame) for point in self.places}
        self.speeds = {point: vector for point, vector in velocities.items() if self._is_oriented(vector)}

    def _is_oriented(self, vector: Any) -> bool:
        return vector is not None and all(frame in self.axes for _, frame in vector.args)

    def faults(self) -> list[Fault]:
        """The faults: what differs at random states, and where constraints hold."""
        wrong = self._wrong()
        if wrong != []:
            held = self._wrong(held=True)
            wrong = wrong if held is None else held
        if wrong is None:
            actual = f"expressions without a value at {TRIES} random states"
            return [Fault("kinematics", actual, "velocities that can be compared with positions and axes", REMEDY)]
        return [*map(self._fault, wrong)]

    # -- states --------------------------------------------------------------------------------------------------------

    def _state(self, seed: int) -> Numbers:
        """Constants at their values; coordinates, speeds, functions of time and the rates of these at random."""
        source, moving = random.Random(seed), self.names.moving
        values = {symbol: mpf(p.si) for symbol, p in self.names.instead.items() if isinstance(p, Parameter)}
        fixed = {f: value for f, value in moving.items() if not states_in(value)}
        values |= {f: self._value(v, {p: mpf(p.si) for p in v.free_symbols}) for f, v in fixed.items()}
        free = [each for f in moving if f not in fixed for each in (f, f.diff(TIME))]
        return values | {s: mpf(source.uniform(-1.3, 1.3)) for s in (TIME, *self.reading.q, *self.reading.u, *free)}

    def _held(self, state: Numbers) -> Numbers:
        """Numbers near a given one that fulfils the constraints; raises ArithmeticError."""
        reading = self.reading
        turns = [other._dcm_dict[frame] for frame, other in self.axes.items() if other is not None]
        unit = [entry for matrix in turns for entry in matrix.T * matrix - sp.eye(3)]  # of Euler parameters
        on_speeds = (*(expression.diff(TIME) for expression in reading.holonomic), *reading.nonholonomic)
        for expressions, unknowns in (((*reading.holonomic, *unit), reading.q), (on_speeds, reading.u)):
            state = self._solved(expressions, unknowns, state) if expressions else state
        return state

    def _solved(self, expressions: Iterable[Any], unknowns: Iterable[Any], state: Numbers) -> Numbers:
        """Numbers at which expressions are zero, by Newton's method with the least changes of the unknowns."""
        rows = [[expression] for expression in expressions]
        for _ in range(ROUNDS):
            rest = self._matrix(rows, {**state})
            if mp.norm(rest) < 1e-30:
                return state
            near = [self._matrix(rows, {**state, x: state[x] + STEP}) for x in unknowns]
            slopes = mp.matrix([list(other - rest) for other in near]) / STEP
            change = slopes * mp.lu_solve(slopes.T * slopes + mpf(10) ** -15 * mp.eye(len(rest)), rest)
            change /= max(mpf(1), mp.norm(change))
            state = {**state, **{x: state[x] - d for x, d in zip(unknowns, change, strict=True)}}
        raise ArithmeticError("no state on the constraints")

    def _value(self, expression: Any, known: dict[Any, Any]) -> Any:
        """Value of an expression, kept among the known ones; what no equation has, as auxiliary speeds, is 0."""
        if expression in known:
            return known[expression]
        if expression in self.reading.derivatives:
            value = self._value(self.reading.derivatives[expression], known)
        elif isinstance(expression, sp.Symbol | AppliedUndef | sp.Derivative):
            value = mpf(0)
        elif type(expression) in FUNCTIONS:
            value = FUNCTIONS[type(expression)](*(self._value(part, known) for part in expression.args))
        else:
            parts = [sp.sympify(self._value(part, known)) for part in expression.args]
            made = expression.func(*parts) if parts else expression
            value = made._to_mpmath(mp.prec) if made.is_number else made
        known[expression] = value
        return value

    def _matrix(self, rows: Iterable[Iterable[Any]], known: dict[Any, Any]) -> Any:
        return mp.matrix([[self._value(entry, known) for entry in row] for row in rows])

    def _column(self, vector: Any, known: dict[Any, Any], axes: Numbers) -> Any:
        parts = (axes[frame] * self._matrix(entries.tolist(), known) for entries, frame in vector.args)
        return sum(parts, mp.zeros(3, 1))

    # -- what differs --------------------------------------------------------------------------------------------------

    def _wrong(self, held: bool = False) -> list[Any] | None:
        """Pairs of frames and points that differ at random states, or next to these on the constraints.

        None where velocities have no values.
        """
        differences: list[Sequence[Any]] = []
        for seed in range(TRIES):
            with suppress(ArithmeticError, ValueError, TypeError):  # an expression has no value there
                differences.append(self._compared(self._held(self._state(seed)) if held else self._state(seed)))
            if len(differences) == STATES:
                return list(dict.fromkeys(item for each in differences for item in each))
        return None

    def _poses(self, state: Numbers, axes: Any = None) -> tuple[Numbers, Numbers]:
        """Axes of frames, or the given ones, and positions of points."""
        known, places = {**state}, {self.reading.origin: mp.zeros(3, 1)}
        if axes is None:
            axes = {self.reading.frame: mp.eye(3)}
            for frame, other in [*self.axes.items()][1:]:
                axes[frame] = axes[other] * self._matrix(other._dcm_dict[frame].tolist(), known)
        for point, other in [*self.places.items()][1:]:
            places[point] = places[other] + self._column(point._pos_dict[other], known, axes)
        return axes, places

    def _compared(self, state: Numbers) -> Sequence[Any]:
        """Differences at a state: the turning of frames against each other, then the motion of points."""
        known = {**state}
        rates = {q: self._value(rate, known) for q, rate in self.reading.rates.items()}
        rates |= {f: state.get(f.diff(TIME), mpf(0)) for f in self.names.moving} | {TIME: mpf(1)}
        later = {**state, **{symbol: state[symbol] + STEP * rate for symbol, rate in rates.items()}}
        (axes, places), (turned_axes, moved) = self._poses(state), self._poses(later)
        turned = {pair: _across(self._column(vector, known, axes)) for pair, vector in self.turns.items()}
        speeds = {point: self._column(vector, known, axes) for point, vector in self.speeds.items()}
        turning = {frame: (turned_axes[frame] - axes[frame]) / STEP * axes[frame].T for frame in axes}
        differ = _differing(turned, turning)
        wrong = [(one, other) for (one, other), turn in turned.items() if differ(turn, turning[one] - turning[other])]
        spins = dict(turning)
        moving = carried = {point: (moved[point] - places[point]) / STEP for point in moved}
        if wrong:  # points follow frames that turn as they were set, by the shortest way, which is SymPy's
            for frame, other in self.turned.items():
                if frame in axes and other in axes:
                    spins[frame] = spins[other] + turned.get((frame, other), -turned.get((other, frame), 0))
            _, beside = self._poses(state, {frame: (spins[frame] - turning[frame]) * axes[frame] for frame in axes})
            carried = {point: moving[point] + beside[point] for point in moving}
        return [*wrong, *self._wrong_points(speeds, (moving, carried), places, spins)]

    def _wrong_points(self, speeds: Numbers, ways: Sequence[Numbers], places: Numbers, spins: Numbers) -> Sequence[Any]:
        """Points that move otherwise than follows from the point before them that has a velocity of its own."""
        wrong: list[Any] = []
        riders: list[Any] = []
        differ = _differing(speeds, ways[0])
        for point in speeds:
            other = self.places[point]
            while other is not None and (other not in speeds or other in riders):
                other = self.places[other]
            own, *follow = (way[point] if other is None else way[point] - way[other] for way in (speeds, *ways))
            if all(differ(own, each) for each in follow):
                rides = any(
                    not differ(speeds[point] - speeds[at], spins[frame] * (places[point] - places[at]))
                    and (at in wrong or any(not differ(speeds[at], way[at]) for way in ways))
                    for at, frame in self._carriers(point, spins, speeds)
                )
                (riders if rides else wrong).append(point)
        return wrong

    def _carriers(self, point: Any, spins: Numbers, speeds: Numbers) -> Sequence[tuple[Any, Any]]:
        """Points, with frames, of which a point may be a material point: none of a mass centre.

        Of bodies, and of frames in which another point is fixed, or where no load acts of any frame.
        """
        bodies = [mass_centre(body) for body in self.reading.bodies]
        loaded = point in [on for on, _ in self.reading.loads]
        near = [(at, f) for at in point._pos_dict for f in spins if not loaded or at._vel_dict.get(f) == 0]
        own = point in [centre for centre, _ in bodies]
        return [] if own else [(at, frame) for at, frame in bodies + near if at in speeds and frame in spins]

    def _fault(self, item: Any) -> Fault:
        """Fault of an angular velocity of a frame in another, or of the velocity of a point."""
        if isinstance(item, tuple):
            frame, other = item
            ways = pairwise(frame._dict_list(other, 0))
            written = self.turns[item], sum((one._w_diff_dcm(next_) for one, next_ in ways), Vector(0))
            where, of = f"angular velocity of {frame.name} in {other.name}", "orientation"
        else:
            written = self.speeds[item], item.pos_from(self.reading.origin).dt(self.reading.frame)
            where, of = f"velocity of {item.name} in {self.reading.frame.name}", "position"
        texts = (str(v.applyfunc(lambda e: e.xreplace(self.reading.derivatives))) for v in written)
        actual, expected = (text if len(text) <= LONGEST else f"{text[: LONGEST - 4]} ..." for text in texts)
        return Fault(where, f"{actual}, as it was set", f"{expected}, the derivative of its {of}", REMEDY)


def _across(w: Any) -> Any:
    """Matrix of the vector product w x ..."""
    return mp.matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def _differing(*groups: Numbers) -> Callable[[Any, Any], bool]:
    """Function of two vectors: whether they differ, beside the largest of some; what has no value does."""
    least = TOLERANCE * max((mp.norm(vector) for group in groups for vector in group.values()), default=mpf(0)) + 1e-18
    return lambda one, other: not mp.norm(one - other) <= least
