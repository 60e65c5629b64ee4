"""Surfaces that overlap at the start: faults and warnings, with the coordinate that separates them.

A change is tried on the whole start: loops are closed anew, and every pair that it moves has to end open. The gap of
curves that are deep in each other may jump to one of other places, as between teeth; a change beside a jump is none.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.start.intrusion import LIMIT, intrusions
from hertzwerk.runtime.engine.start.pair_values import pair_values
from hertzwerk.runtime.engine.start.start_values import assembled

STEPS = range(-6, 21)  # changes that are tried: these powers of two, times the scale of the coordinate
HALVINGS = 60
PRESSED = 1e-2  # part of the overlap that other pairs may have had before, as those at rest do
TURNS = np.linspace(0, math.pi / 4, 1025)  # rad, tried between teeth: a wheel with 8 teeth or more has its gap within


@np.errstate(all="ignore")
def overlaps(
    model: EngineModel, bound: BoundParameters, initial: Mapping[str, Value], q: np.ndarray, u: np.ndarray
) -> tuple[list[Fault], tuple[str, ...]]:
    """Return a fault for each pair that overlaps too deeply at the start, and warnings of the others.

    Those are pressed so deep that they separate faster than the scene moves.
    """
    faults, warnings = [], []
    held = ", and its damping, which has no approach speed, may hold it there" if model.latches else ""
    for overlap in intrusions(model, bound, q, u):
        way_out = separating_change(model, bound, initial, overlap.pair)
        if not overlap.too_deep:
            warnings.append(
                f"{overlap.pair} starts in overlap: start with a gap. Stiffness alone would throw its {overlap.depth:.3g} m apart at "
                f"{overlap.speed:.3g} m/s, faster than the scene is{held}; {way_out}"
            )
            continue
        if not overlap.in_range:
            why = f"a penetration of {overlap.depth:.3g} m, so deep that its law is not defined there"
            expected = "surfaces that are apart, or touch"
        else:
            why = f"a penetration of {overlap.depth:.3g} m, which would throw the surfaces apart at {overlap.speed:.3g} m/s"
            expected = f"at most about {overlap.allowed:.2g} m, where that is {LIMIT:g} times as fast as the scene"
        faults.append(Fault(f"start, {overlap.pair}", why, expected, way_out))
    return faults, tuple(warnings)


def separating_change(model: EngineModel, bound: BoundParameters, initial: Mapping[str, Value], pair: str) -> str:
    """Suggest the coordinate whose least change, in the scene's scales, separates a pair's surfaces."""
    start = _Start(model, bound, initial, model.pairs.index(pair))
    sizes = np.where(np.isfinite(start.sizes) & (start.sizes > 0), start.sizes, 1e-3)
    ways = []
    for i in start.candidates:
        change = _between_teeth(partial(start.room, i), start.depth) if start.turns_curve(i) else None
        if change is None:
            change = _least_change(partial(start.room, i), sizes[i], start.depth)
        if change is not None:
            ways.append((abs(change) / sizes[i], i, change))
    if not ways:
        return "no coordinate alone brings them apart: check the lengths of the mechanism, and what the start states"
    _, i, change = min(ways)
    joints, at = model.joints, start.stated[i]
    name, unit = joints.coordinates[i], joints.units[joints.coordinates[i]]
    touch = "touch" if start.room(i, change) < 1e-6 * start.depth else "are apart"
    return f"they {touch} with {name} at {at + change:.6g} {unit} in place of {at:.6g} {unit}, a change of {change:.3g} {unit}"


@dataclass(frozen=True)
class _Start:
    """A start in which the pair of number j overlaps."""

    model: EngineModel
    bound: BoundParameters
    initial: Mapping[str, Value]
    j: int

    @cached_property
    def stated(self) -> np.ndarray:
        """Coordinates of the joints (nq,)."""
        return assembled(self.model, self.bound, self.initial, [])[0]

    @cached_property
    def sizes(self) -> np.ndarray:
        """Scales of the coordinates (nq,)."""
        return self.model.joints.evaluate("scales", self.bound.p)[0]

    @cached_property
    def gaps(self) -> np.ndarray:
        """Gaps of all pairs [m]."""
        return self._gaps(self.stated, range(self.model.k))

    @property
    def depth(self) -> float:
        """Depth of the overlap [m]."""
        return -float(self.gaps[self.j])

    @cached_property
    def _in_loops(self) -> np.ndarray:
        """Whether loops or couplings move a coordinate (nq,)."""
        joints = self.model.joints
        if not joints.nl:
            return np.zeros(joints.nq, dtype=bool)
        from hertzwerk.runtime.engine.start.assembly import moved_by_loops

        return moved_by_loops(joints, self.bound, self.stated)

    @property
    def candidates(self) -> list[int]:
        """Coordinates that may be stated otherwise: the stated ones, and all that no loop moves."""
        joints, fixed = self.model.joints, {*(self.model.module.GIVEN or ()), *self.initial}
        moving = self.model.members[self.j][1] if self.model.members else range(joints.nq)
        names = joints.coordinates
        free = (i for i in moving if names[i] in fixed or not self._in_loops[i])
        return [i for i in free if joints.units[names[i]] != "1"]

    def turns_curve(self, i: int) -> bool:
        """Whether coordinate i is an angle outside loops and the pair two curves, which may have teeth."""
        joints, (_, kind) = self.model.joints, self.model.module.PAIRS[self.j]
        return kind == "curve_on_curve" and joints.units[joints.coordinates[i]] == "rad" and not self._in_loops[i]

    def room(self, i: int, change: float) -> float:
        """Least gap [m] of the pair and of those that a change of coordinate i moves.

        -inf where loops stay open. Of a pair that was pressed a little, the gap beyond that.
        """
        q = self.stated.copy()
        q[i] += change
        if self._in_loops[i]:
            name, faults = self.model.joints.coordinates[i], list[Fault]()
            value = (float(q[i]), self.model.joints.units[name])
            q, _ = assembled(self.model, self.bound, {**self.initial, name: value}, faults)
            if faults:
                return -math.inf
        members = self.model.members
        near = [k for k in range(self.model.k) if not members or i in members[k][1]]
        before, after = self.gaps[near], self._gaps(q, near)
        pressed = np.where((before < 0) & (before > -PRESSED * self.depth), before, 0.0)
        moved = (np.abs(after - before) > 1e-9 * self.depth) | (np.array(near) == self.j)
        return float(np.min((after - pressed)[moved]))

    def _gaps(self, q: np.ndarray, pairs: range | list[int]) -> np.ndarray:
        q, u = self.model.placed(self.bound, q, np.zeros(self.model.joints.nu))
        return pair_values(self.model, "gaps", pairs, {"t": 0.0, "q": q, "u": u, "c": self.bound.c})[0]


def _least_change(room: Callable[[float], float], size: float, depth: float) -> float | None:
    """Return the least change of a coordinate, up or down, that makes room; None if none does."""
    ways = []
    for sign in (1, -1):
        steps = [0.0, *(sign * size * 2.0**k for k in STEPS)]
        first = next((n for n in range(1, len(steps)) if room(steps[n]) >= 0), None)
        if first is not None and _continuous(room, change := _opening(room, *steps[first - 1 : first + 1]), depth):
            ways.append(change)
    return min(ways, key=abs, default=None)


def _between_teeth(room: Callable[[float], float], depth: float) -> float | None:
    """Return the least turn that leaves most room between surfaces that enclose each other."""
    from scipy.optimize import minimize_scalar  # slow to import

    def most(low: float, high: float) -> float:
        best = minimize_scalar(lambda turn: -room(turn), bounds=sorted((low, high)), options={"xatol": 1e-12})
        return float(best.x)

    ways = []
    for sign in (1, -1):
        turns = sign * TURNS
        rooms = [room(turn) for turn in turns]
        tops = (n for n in range(1, len(turns) - 1) if rooms[n] == max(rooms[n - 1 : n + 2]))
        tried = (most(turns[n - 1], turns[n + 1]) for n in tops)
        ways += [next((turn for turn in tried if room(turn) >= 0 and _continuous(room, turn, depth)), math.inf)]
    least = min(ways, key=abs)
    return None if math.isinf(least) else least


def _continuous(room: Callable[[float], float], change: float, depth: float) -> bool:
    return abs(room(change * (1 + 1e-6)) - room(change * (1 - 1e-6))) < 1e-2 * depth


def _opening(room: Callable[[float], float], closed: float, opened: float) -> float:
    for _ in range(HALVINGS):
        middle = (closed + opened) / 2
        closed, opened = (closed, middle) if room(middle) >= 0 else (middle, opened)
    return opened
