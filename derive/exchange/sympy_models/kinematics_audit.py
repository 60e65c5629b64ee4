"""Kinematics of a SymPy model: velocities as set, against those that follow from positions and axes.

SymPy forms equations with any velocity of a point and any angular velocity of a frame, whatever its position and its
orientation say. Both are compared at random states, in extended precision, positions and axes a little before and after
along the motion. What differs is named where it begins, not at the frames and points that inherit it.
"""

from __future__ import annotations

import math
import operator
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
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

DIGITS, STEP = 50, mpf(10) ** -16  # central differences are exact to 32 digits
TOLERANCE = 1e-9  # of the largest velocity: constants of a model may be floating-point numbers
STATES, TRIES, ROUNDS = 2, 12, 60
LONGEST = 200  # of a velocity in a message, in characters
WAY_OUT = 'from_sympy(..., kinematics="as given") takes it as it is.'
FUNCTIONS: Mapping[Any, Callable[..., Any]] = {
    sp.Add: lambda *terms: sum(terms), sp.Mul: lambda *factors: math.prod(factors), sp.Pow: operator.pow,
    sp.sin: mp.sin, sp.cos: mp.cos, sp.tan: mp.tan,
}  # fmt: skip

State = Mapping[Any, Any]
Vectors = Mapping[Any, Any]
"""Columns of three numbers along the inertial frame's axes."""
Wrong = Mapping[Any, tuple[Any, Any]]
"""Velocities as they were set, and as they follow, by a pair of frames or a point."""


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
            (frame, other): vector for frame in rank for other, vector in frame._ang_vel_dict.items()
            if rank.get(other, len(rank)) < rank[frame] and self._is_oriented(vector)
        }  # fmt: skip
        given = {point: point._vel_dict.get(reading.frame) for point in self.places}
        self.speeds = {point: vector for point, vector in given.items() if self._is_oriented(vector)}

    def _is_oriented(self, vector: Any) -> bool:
        return vector is not None and all(frame in self.axes for _, frame in vector.args)

    def faults(self) -> list[Fault]:
        """The faults: what differs at random states, and where constraints hold."""
        wrong = self._wrong()
        if wrong != {} and (self.reading.holonomic or self.reading.nonholonomic):
            held = self._wrong(held=True)
            wrong = wrong if held is None else held
        if wrong is None:
            found = f"expressions without a value at {TRIES} random states"
            return [Fault("kinematics", found, "velocities that can be compared with positions and axes", WAY_OUT)]
        return [self._fault(what, *pair) for what, pair in wrong.items()]

    # -- states --------------------------------------------------------------------------------------------------------

    def _state(self, seed: int) -> State:
        """Constants at their values; coordinates, speeds, functions of time and the rates of these at random."""
        source = random.Random(seed)
        state = {symbol: mpf(p.si) for symbol, p in self.names.instead.items() if isinstance(p, Parameter)}
        free = [TIME, *self.reading.q, *self.reading.u]
        for function, value in self.names.moving.items():
            if states_in(value):
                free += [function, function.diff(TIME)]
            else:
                state[function] = _value(value, {p: mpf(p.si) for p in value.free_symbols})
        return state | {atom: mpf(source.uniform(-1.3, 1.3)) for atom in free}

    def _rates(self, state: State) -> dict[Any, Any]:
        """Rates of the coordinates, of functions of time and of time itself."""
        rates = {q: _value(rate, dict(state)) for q, rate in self.reading.rates.items()}
        return rates | {f: state.get(f.diff(TIME), mpf(0)) for f in self.names.moving} | {TIME: mpf(1)}

    def _held(self, state: State) -> State:
        """State near a given one that fulfils the constraints, by Newton's method; raises ArithmeticError."""
        reading = self.reading
        on_speeds = (*(expression.diff(TIME) for expression in reading.holonomic), *reading.nonholonomic)

        def of_coordinates(at: State) -> Any:
            return _matrix([reading.holonomic], dict(at)).T

        def of_speeds(at: State) -> Any:
            rates = self._rates(at)
            return _matrix([on_speeds], {**at, **{s.diff(TIME): rate for s, rate in rates.items()}}).T

        placed = _solved(of_coordinates, reading.q, state) if reading.holonomic else state
        return _solved(of_speeds, reading.u, placed)

    # -- what differs --------------------------------------------------------------------------------------------------

    def _wrong(self, held: bool = False) -> Wrong | None:
        """Differences at the first states that have values, or at those next to them on the constraints.

        None where none has.
        """
        found: list[Wrong] = []
        for seed in range(TRIES):
            state = self._state(seed)
            try:
                found.append(self._compared(self._held(state) if held else state))
            except (ArithmeticError, ValueError, TypeError):  # an expression has no value there
                continue
            if len(found) == STATES:
                break
        return {what: pair for each in found for what, pair in each.items()} if found else None

    def _poses(self, state: State, axes: Vectors | None = None) -> tuple[Vectors, Vectors]:
        """Axes of frames, or the given ones, and positions of points."""
        known = dict(state)
        if axes is None:
            axes = {}
            for frame, other in self.axes.items():
                own = mp.eye(3) if other is None else _matrix(other._dcm_dict[frame].tolist(), known)
                axes[frame] = own if other is None else axes[other] * own
        places: dict[Any, Any] = {}
        for point, other in self.places.items():
            places[point] = mp.zeros(3, 1)
            if other is not None:
                places[point] = places[other] + _column(point._pos_dict[other], known, axes)
        return axes, places

    def _compared(self, state: State) -> Wrong:
        """Differences at a state: the turning of frames against each other, then the motion of points."""
        rates = self._rates(state)
        before, after = ({**state, **{s: state[s] + h * rate for s, rate in rates.items()}} for h in (-STEP, STEP))
        (axes, places), (first, back), (last, on) = map(self._poses, (state, before, after))
        known = {**state, **{s.diff(TIME): rate for s, rate in rates.items()}}
        turned, speeds = (
            {key: _column(vector, known, axes) for key, vector in given.items()} for given in (self.turns, self.speeds)
        )
        turning = {frame: _axial((last[frame] - first[frame]) * axes[frame].T) / (2 * STEP) for frame in axes}
        follow = {(frame, other): turning[frame] - turning[other] for frame, other in turned}
        differ = _differing(turned.values(), follow.values())
        wrong = {pair: (turned[pair], follow[pair]) for pair in turned if differ(turned[pair], follow[pair])}
        moving = carried = _rate(back, on)
        spins = self._spins(turned, turning)
        if wrong:  # points follow the frames as these were set
            tilted = ({f: axes[f] + h * _across(spins[f]) * axes[f] for f in axes} for h in (-STEP, STEP))
            carried = _rate(*(self._poses(*each)[1] for each in zip((before, after), tilted, strict=True)))
        differ = _differing(speeds.values(), moving.values())
        for point, speed in speeds.items():
            if differ(speed, moving[point]) and not self._rides(point, speeds, places, spins, differ):
                begin = self._begin(point, (speeds, moving, carried), differ)
                wrong |= {} if begin is None else {begin: (speeds[begin], moving[begin])}
        return wrong

    def _spins(self, turned: Vectors, turning: Vectors) -> Vectors:
        """Angular velocities of frames as they were set, by SymPy's way: the shortest from the inertial one."""
        spins = dict(turning)
        for frame, other in self.turned.items():
            if (frame, other) in turned:
                spins[frame] = spins[other] + turned[frame, other]
            elif (other, frame) in turned:
                spins[frame] = spins[other] - turned[other, frame]
        return spins

    def _rides(self, point: Any, speeds: Vectors, places: Vectors, spins: Vectors, differ: Any) -> bool:
        """Whether a point moves as a material point of a body; no mass centre may.

        A frame in which another point is fixed counts as well, and where no load acts any frame.
        """
        riders = [mass_centre(body) for body in self.reading.bodies]
        if point in [centre for centre, _ in riders]:
            return False
        loaded = point in [on for on, _ in self.reading.loads]
        riders += [
            (other, frame) for other in point._pos_dict for frame in spins
            if not loaded or other._vel_dict.get(frame) == 0
        ]  # fmt: skip
        return any(
            not differ(speeds[point] - speeds[other], _across(spins[frame]) * (places[point] - places[other]))
            for other, frame in riders if other in speeds and frame in spins
        )  # fmt: skip

    def _begin(self, point: Any, ways: Sequence[Vectors], differ: Any) -> Any:
        """The point on the way to the origin where a difference begins; None where it begins at a frame."""
        while point is not None:
            other = self.places[point]
            while other is not None and other not in self.speeds:
                other = self.places[other]
            own, *follow = (way[point] if other is None else way[point] - way[other] for way in ways)
            if all(differ(own, each) for each in follow):
                return point
            point = other
        return None

    # -- what is said --------------------------------------------------------------------------------------------------

    def _fault(self, what: Any, was_set: Any, follows: Any) -> Fault:
        """Fault of an angular velocity of a frame in another, or of the velocity of a point."""
        inertial = self.reading.frame.name
        if isinstance(what, tuple):
            frame, other = what
            way = frame._dict_list(other, 0)
            written = self.turns[what], sum((a._w_diff_dcm(b) for a, b in pairwise(way)), Vector(0))
            where, of, unit = f"angular velocity of {frame.name} in {other.name}", "orientation", "rad/s"
            remedy = f"Leave {frame.name}.set_ang_vel({other.name}, ...) out or orient the frame otherwise; {WAY_OUT}"
        else:
            written = self.speeds[what], what.pos_from(self.reading.origin).dt(self.reading.frame)
            where, of, unit = f"velocity of {what.name} in {inertial}", "position", "m/s"
            remedy = f"Look at signs, at the frame that it is fixed in, and at the origin; {WAY_OUT}"
        found, expected = (str(v.applyfunc(lambda e: e.xreplace(self.reading.derivatives))) for v in written)
        if max(len(found), len(expected)) > LONGEST:
            found, expected = (
                f"({', '.join(mp.nstr(mp.re(value), 4) for value in vector)}) {unit} along {inertial} at a random state"
                for vector in (was_set, follows)
            )
        return Fault(where, f"{found}, as it was set", f"{expected}, the derivative of its {of}", remedy)


def _value(expression: Any, known: dict[Any, Any]) -> Any:
    """Value of an expression, kept among the known ones.

    Functions of time that no equation has, such as auxiliary speeds, are 0.
    """
    if expression in known:
        return known[expression]
    if isinstance(expression, AppliedUndef | sp.Derivative):
        value = mpf(0)
    elif isinstance(expression, sp.Symbol):
        value = mpf("0.77")  # a constant that no equation has
    elif type(expression) in FUNCTIONS:
        value = FUNCTIONS[type(expression)](*(_value(part, known) for part in expression.args))
    else:
        parts = [sp.sympify(_value(part, known)) for part in expression.args]
        made = expression.func(*parts) if parts else expression
        value = made._to_mpmath(mp.prec) if made.is_number else made
    known[expression] = value
    return value


def _matrix(rows: Iterable[Iterable[Any]], known: dict[Any, Any]) -> Any:
    return mp.matrix([[_value(entry, known) for entry in row] for row in rows])


def _solved(function: Callable[[State], Any], unknowns: Iterable[Any], state: State) -> State:
    """State at which a function is zero, by Newton's method with the least changes of the unknowns."""
    for _ in range(ROUNDS):
        rest = function(state)
        if mp.norm(rest) < 1e-30:
            return state
        slopes = mp.matrix([list(function({**state, x: state[x] + STEP}) - rest) for x in unknowns]) / STEP
        change = slopes * mp.lu_solve(slopes.T * slopes + mpf(10) ** -30 * mp.eye(len(rest)), rest)
        change /= max(mpf(1), mp.norm(change))
        state = {**state, **{x: state[x] - d for x, d in zip(unknowns, change, strict=True)}}
    raise ArithmeticError("no state on the constraints")


def _column(vector: Any, known: dict[Any, Any], axes: Vectors) -> Any:
    """A vector of SymPy along the inertial frame's axes."""
    parts = (axes[frame] * _matrix(entries.tolist(), known) for entries, frame in vector.args)
    return sum(parts, mp.zeros(3, 1))


def _rate(before: Vectors, after: Vectors) -> Vectors:
    return {key: (after[key] - before[key]) / (2 * STEP) for key in after}


def _axial(m: Any) -> Any:
    """Vector of the skew part of a matrix."""
    return mp.matrix([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1]]) / 2


def _across(w: Any) -> Any:
    """Matrix of the vector product w x ..."""
    return mp.matrix([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def _differing(*groups: Iterable[Any]) -> Callable[[Any, Any], bool]:
    """Function of two vectors: whether they differ, beside the largest of some."""
    least = TOLERANCE * max((mp.norm(vector) for group in groups for vector in group), default=mpf(0)) + 1e-25

    def differ(one: Any, other: Any) -> bool:
        distance = mp.norm(one - other)
        if not mp.isfinite(distance):
            raise ValueError("a velocity without a value")
        return bool(distance > least)

    return differ
