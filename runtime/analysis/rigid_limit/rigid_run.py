"""Run in the rigid limit: motion between impacts, which are located within the steps.

1. decide    which closed contacts press, stick or slide: the forces of one instant            rigid_impact
2. move      by SciPy's DOP853 until a contact closes, lifts off, sticks or slips              here
3. impact    impulses of all contacts that touch, at once or one by one                        rigid_impact
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from hertzwerk.runtime.analysis.rigid_limit.rigid_equations import Equations, State
from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import BoundImpact, Contact, NoSolutionError, solved
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.system.arrays import Array

PARTS = 8  # of a step, at whose ends events are looked for; between them the polynomial is followed by its extremes
LEAST_STEPS = 50  # of a run; one that it is compared with takes more, as equal steps would show no error
TOUCHES = 1e-9  # of the scene's length: gap that counts as closed
STILL = 1e-10  # of the scene's speed: velocity that counts as none
FORCE = 1e-10  # of the largest force so far: force that counts as none
WEAK = 1e-6  # of the scene's force: below, a largest force does not count
ACCUMULATED = 1e-9  # of the duration: sequences of impacts that end within it end at once
FLAT = 1e-11  # of the scene's length: a hop no higher is lost in the rounding of positions
MOST_IMPACTS = 100_000
ROUNDING = 1e-9  # of the duration: a smaller difference of onsets shows no order
OPEN, SLIDES, STICKS = "open", "slides", "sticks"


class RigidImpulse(NamedTuple):
    """Impact at an instant: approach and separation speed [m/s], normal and tangential impulse [N s].

    lost    energy that the contact takes up [J], half of impulse times the sum of the velocities before and after (Kelvin and Tait)
    """

    contact: str
    t: float
    speed: float
    separation: float
    normal_impulse: float
    tangential_impulse: float
    lost: float


class Accumulation(NamedTuple):
    """End of a sequence of impacts whose intervals shrink to nothing, at its limit t [s]."""

    contact: str
    t: float


@dataclass(frozen=True)
class RigidEvent:
    """Instant at which modes change: the start, or the end of the mode of the pair `ended`.

    which    margin of the pair that ends it
    y, y_after (nq + nu): the states; before, after: the run with its modes then, `after` with what happened
    repeated    whether the same pair's mode ended at the event before, at the same instant
    """

    t: float
    y: Array
    y_after: Array
    ended: int | None
    which: int
    repeated: bool
    before: RigidRun
    after: RigidRun


@dataclass
class Motion:
    """Motion of a scene in the rigid limit: steps, events, impulses, ends of sequences of impacts.

    t (n,), y (n, nq + nu) at the ends of steps, before and after impacts
    rubbed    energy [J] that friction dissipated between impacts
    work    energy [J] that drives and effects put in, less what effects dissipated; 0 without an `EnergyLedger`
    """

    t: list[float] = field(default_factory=list)
    y: list[Array] = field(default_factory=list)
    impulses: list[RigidImpulse] = field(default_factory=list)
    accumulations: list[Accumulation] = field(default_factory=list)
    segments: list[Any] = field(default_factory=list)
    events: list[RigidEvent] = field(default_factory=list)
    rubbed: float = 0.0
    work: float = 0.0
    outcome: Outcome = field(default_factory=lambda: Outcome("finished", "", ""))

    def at(self, times: Array) -> Array:
        """Return the states (n, nq + nu) at times within the run, after an impact at the same instant."""
        ends = np.array([segment.t_max for segment in self.segments])
        places = np.minimum(np.searchsorted(ends, times, side="right"), len(ends) - 1)
        return np.array([self.segments[k](t) for k, t in zip(places, times, strict=True)])


@dataclass
class RigidRun:
    """A run, but for its results.

    together    whether contacts that touch take their impulses at once, or one by one, the fastest first
    scale    of length [m], speed [m/s], force [N]; sizes (nq + nu) of the states; tolerance of a step relative to them; steps    least number
    """

    equations: Equations
    laws: Sequence[BoundImpact]
    names: Sequence[str]
    together: bool
    scale: Array
    sizes: Array
    tolerance: float
    duration: float
    steps: int
    progress: Callable[[float], object]
    mode: list[str] = field(default_factory=list)
    ways: list[Array] = field(default_factory=list)  # directions of sliding
    motion: Motion = field(default_factory=Motion)
    largest: float = 0.0  # force [N] so far
    last: tuple[float, int | None] = (-1.0, None)  # time and pair of the last event

    def run(self, y: Array) -> Motion:
        """Return the motion from a state."""
        motion, t = self.motion, 0.0
        self.mode, self.ways = [OPEN] * len(self.names), [np.zeros(0)] * len(self.names)
        try:
            y = self._through(t, y)
            self._keep(t, y)
            while t < self.duration:
                t, y, ended, which = self._moved(t, y)
                if t < self.duration:
                    y = self._through(t, y, ended, which)
                    self._keep(t, y)
                if len(motion.impulses) > MOST_IMPACTS:
                    motion.outcome = Outcome("too_many_impacts", f"{MOST_IMPACTS:,} impacts by t = {t:.9g} s",
                                             "take a smaller restitution or a shorter duration")  # fmt: skip
                    return motion
        except NoSolutionError as error:
            motion.outcome = Outcome("no_rigid_solution", f"at t = {t:.9g} s, {self.names[error.contact]}: {error.why}",
                                     "take less friction, or the compliant contact of the scene, which has a solution there")  # fmt: skip
            return motion
        motion.outcome = Outcome("finished", f"reached the end at t = {t:.6g} s", "")
        return motion

    def _keep(self, t: float, y: Array) -> None:
        self.motion.t.append(t)
        self.motion.y.append(y)
        self.progress(min(1.0, t / self.duration))

    def pattern(self) -> tuple[list[str], list[str], list[str]]:
        """Return the modes, and the contacts that collided and came to rest, of a run or an event of it."""
        motion = self.motion
        return self.mode, [one.contact for one in motion.impulses], [one.contact for one in motion.accumulations]

    # -- at an instant -------------------------------------------------------------------------------------------------

    def _through(self, t: float, y: Array, ended: int | None = None, which: int = 0) -> Array:
        """Return the state after an event, which the motion keeps."""
        motion, repeated, before = self.motion, self.last == (t, ended), replace(self, ways=list(self.ways))
        hit, rested = len(motion.impulses), len(motion.accumulations)
        after = self.settled(t, y, ended)
        here = Motion(impulses=motion.impulses[hit:], accumulations=motion.accumulations[rested:])
        then = replace(self, ways=list(self.ways), motion=here)
        motion.events.append(RigidEvent(t, y, after, ended, which, repeated, before, then))
        return after

    def settled(self, t: float, y: Array, ended: int | None = None) -> Array:
        """Return the state after all impacts at an instant, with the modes in which the motion goes on.

        ended    pair whose mode has just ended. Where it does again at the same instant, the forces there lie on the limit of the mode: a
                 contact that pressed lifts off, and one that stuck slides.
        """
        length, speed, _ = self.scale
        hit = ended if ended is not None and self.mode[ended] == OPEN else None
        left = self.mode[ended] if ended is not None and hit is None and self.last == (t, ended) else OPEN
        self.last = (t, ended)
        at = self.equations.at(t, y)
        normals = [n for n, _ in self.equations.rows]
        touching = [j for j, n in enumerate(normals) if j == hit or self.mode[j] != OPEN or (
            at.gap[j] <= TOUCHES * length and at.velocity[n] <= STILL * speed)]  # fmt: skip
        if any(at.velocity[normals[j]] < -STILL * speed for j in touching):
            y = self._hit(t, y, touching)
            at = self.equations.at(t, y)
            y, at = self._accumulated(t, y, at, touching)
        resting = [j for j in touching if abs(at.velocity[normals[j]]) <= STILL * speed]
        if ended is not None and left == SLIDES:
            resting.remove(ended)
        self._decide(at, resting, ended if left == STICKS else None)
        return self._onto(t, y)

    def _hit(self, t: float, y: Array, touching: Sequence[int]) -> Array:
        """Return the state after the impulses of contacts that touch."""
        speed, normals = self.scale[1], [n for n, _ in self.equations.rows]
        if self.together:
            return self._impulse(t, y, touching)
        for _ in range(MOST_IMPACTS):
            velocity = self.equations.at(t, y).velocity
            fastest = min(touching, key=lambda j: float(velocity[normals[j]]))
            if velocity[normals[fastest]] >= -STILL * speed:
                return y
            y = self._impulse(t, y, [fastest])
        raise NoSolutionError(fastest, "impacts one by one do not come to an end")

    def _impulse(self, t: float, y: Array, hit: Sequence[int]) -> Array:
        """Return the state after the impulses of some contacts, kept in the motion's list."""
        at, nq = self.equations.at(t, y), self.equations.model.nq
        e = [self.laws[j].e for j in hit]
        newton = [0.0 if self.laws[j].poisson else part for j, part in zip(hit, e, strict=True)]
        chosen, contacts = self._contacts(hit)
        D, v = at.D[np.ix_(chosen, chosen)], at.velocity[chosen]
        b = v.copy()
        for one, part in zip(contacts, newton, strict=True):
            b[one.n] += part * min(v[one.n], 0.0)
        impulse = self._solve(D, b, contacts, hit)
        if any(self.laws[j].poisson and part for j, part in zip(hit, e, strict=True)):
            back = [
                Contact(one.n, one.tangents, one.mu, part * impulse[one.n] if self.laws[j].poisson else 0.0)
                for j, one, part in zip(hit, contacts, e, strict=True)
            ]
            impulse = impulse + self._solve(D, v + D @ impulse, back, hit)
        after = v + D @ impulse
        for j, one in zip(hit, contacts, strict=True):
            if impulse[one.n] > 0:
                rows = list(one.tangents)
                lost = -sum(impulse[row] * (v[row] + after[row]) / 2 for row in (one.n, *rows))
                self.motion.impulses.append(RigidImpulse(
                    self.names[j], t, float(-v[one.n]), float(after[one.n]), float(impulse[one.n]),
                    float(np.linalg.norm(impulse[rows])), float(lost)))  # fmt: skip
        self._work(t, y, chosen, impulse)
        y = y.copy()
        y[nq:] += at.pushed[:, chosen] @ impulse
        return y

    def _work(self, t: float, y: Array, rows: Sequence[int], impulses: Any) -> None:
        """Add the work of drives at impulses along some rows."""
        if self.equations.booked:
            along = np.zeros(self.equations.m)
            along[rows] = impulses
            self.motion.work += self.equations.work(t, y, along)[1]

    def _contacts(self, pairs: Sequence[int]) -> tuple[list[int], list[Contact]]:
        """Return the rows of some pairs, and these as contacts by places in that list."""
        chosen = [row for j in pairs for row in (self.equations.rows[j][0], *self.equations.rows[j][1])]
        place = {row: i for i, row in enumerate(chosen)}
        contacts = [
            Contact(place[n], tuple(place[row] for row in tangents), self.laws[j].mu)
            for j, (n, tangents) in ((j, self.equations.rows[j]) for j in pairs)
        ]
        return chosen, contacts

    def _solve(self, D: Array, b: Array, contacts: Sequence[Contact], pairs: Sequence[int]) -> Array:
        try:
            return solved(D, b, contacts)
        except NoSolutionError as error:
            raise NoSolutionError(pairs[error.contact], error.why) from None

    def _accumulated(self, t: float, y: Array, at: State, hit: Sequence[int]) -> tuple[Array, State]:
        """End sequences of impacts whose limit is next to now: these contacts are at rest from then on."""
        self._decide(at, [j for j in hit if abs(at.velocity[self.equations.rows[j][0]]) <= STILL * self.scale[1]])
        _, rates, _ = self._accelerations(at)
        ended = []
        for j in hit:
            n = self.equations.rows[j][0]
            opening, closing = float(at.velocity[n]), -float(rates[n])
            if opening > STILL * self.scale[1] and closing > 0 and self.laws[j].e < 1:
                left = 2 * opening / closing / (1 - self.laws[j].e)
                if left <= ACCUMULATED * self.duration or opening**2 / closing < FLAT * self.scale[0]:
                    ended.append(j)
                    self.motion.accumulations.append(Accumulation(self.names[j], t + left))
        if not ended:
            return y, at
        normals = [self.equations.rows[j][0] for j in ended]
        self._work(t, y, normals, np.linalg.lstsq(at.D[np.ix_(normals, normals)], -at.velocity[normals])[0])
        y = self.equations.closed(t, y, [], normals, [])
        return y, self.equations.at(t, y)

    def _decide(self, at: State, resting: Sequence[int], slips: int | None = None) -> None:
        """Set the modes of all contacts, by the forces that those at rest along the normal need.

        slips    pair that may not stick
        """
        self.mode = [OPEN] * len(self.names)
        if not resting:
            return
        speed = self.scale[1]
        chosen, contacts = self._contacts(resting)
        ways = [at.velocity[list(self.equations.rows[j][1])] for j in resting]
        sliding = [way / np.linalg.norm(way) if np.linalg.norm(way) > STILL * speed else None for way in ways]
        contacts = [Contact(one.n, one.tangents, one.mu, slides=way if one.mu else None)
                    for one, way in zip(contacts, sliding, strict=True)]  # fmt: skip
        D, b = at.D[np.ix_(chosen, chosen)], at.bias[chosen]
        forces = self._solve(D, b, contacts, resting)
        rates = D @ forces + b
        self.largest = max(self.largest, WEAK * self.scale[2], float(np.max(np.abs(forces))))
        for j, one, way in zip(resting, contacts, sliding, strict=True):
            rows = list(one.tangents)
            if forces[one.n] <= 0 and rates[one.n] > FORCE / 2 * self.largest * D[one.n, one.n]:
                continue
            most, held = one.mu * forces[one.n], float(np.linalg.norm(forces[rows]))
            if not rows or not one.mu or way is not None:
                self.mode[j], self.ways[j] = SLIDES, np.zeros(len(rows)) if way is None or not one.mu else way
            elif (j != slips or not held) and (
                held < most * (1 - 1e-9) or np.linalg.norm(rates[rows]) <= FORCE / 2 * self.largest * D[one.n, one.n]
            ):
                self.mode[j] = STICKS
            else:
                self.mode[j], self.ways[j] = SLIDES, -forces[rows] / held

    # -- between impacts -----------------------------------------------------------------------------------------------

    def _pushes(self, at: State) -> tuple[Array, list[int]]:
        """Return the rows (m, n) that each unknown pushes along, and the rows (n,) that they hold."""
        columns, rows = [], []
        for j, (n, tangents) in enumerate(self.equations.rows):
            if self.mode[j] == OPEN:
                continue
            push = np.zeros(len(at.bias))
            push[n] = 1.0
            if self.mode[j] == SLIDES and self.laws[j].mu:
                push[list(tangents)] = -self.laws[j].mu * self._way(j, at)
            held = tangents if self.mode[j] == STICKS else ()
            columns += [push, *np.eye(len(at.bias))[list(held)]]
            rows += [n, *held]
        return np.array(columns).reshape(-1, len(at.bias)).T, rows

    def _accelerations(self, at: State) -> tuple[Array, Array, Array]:
        """Return accelerations (nu,), rates of the rows' velocities (m,), and forces along the rows (m,)."""
        pushes, rows = self._pushes(at)
        if not rows:
            return at.free, at.bias, np.zeros(len(at.bias))
        forces = pushes @ np.linalg.lstsq(at.D[rows] @ pushes, -at.bias[rows], rcond=1e-12)[0]
        return at.free + at.pushed @ forces, at.bias + at.D @ forces, forces

    def changes(self, t: float, y: Array, s: Array, dc: Array, dmu: Array) -> Array:
        """Return the changes (nq + nu,) of the rates by those of state, constants and friction (pairs,)."""
        at, by = self.equations.at(t, y), self.equations.changes(t, y, s, dc)
        pushes, rows = self._pushes(at)
        if not rows:
            return np.concatenate([by.rates, by.free])
        turned = np.zeros_like(pushes)
        for j, (n, tangents) in enumerate(self.equations.rows):
            if self.mode[j] == SLIDES and tangents:
                way, v, dv = self._way(j, at), at.velocity[list(tangents)], by.velocity[list(tangents)]
                turn = (dv - way * (way @ dv)) / max(float(np.linalg.norm(v)), STILL * self.scale[1])
                turned[list(tangents), rows.index(n)] = -self.laws[j].mu * turn - dmu[j] * way
        system = at.D[rows] @ pushes
        size = np.linalg.lstsq(system, -at.bias[rows], rcond=1e-12)[0]
        more = by.bias[rows] + (by.D[rows] @ pushes + at.D[rows] @ turned) @ size
        forces = turned @ size - pushes @ np.linalg.lstsq(system, more, rcond=1e-12)[0]
        return np.concatenate([by.rates, by.free + by.pushed @ (pushes @ size) + at.pushed @ forces])

    def _way(self, j: int, at: State) -> Array:
        """Return the direction in which a contact slides, also where it begins to."""
        v: Array = at.velocity[list(self.equations.rows[j][1])] + STILL * self.scale[1] * self.ways[j]
        size = float(np.linalg.norm(v))
        return v / size if size > 0 else v

    def rates(self, t: float, y: Array) -> Array:
        """Return the rates (nq + nu,) of a state in the modes of now."""
        at = self.equations.at(t, y)
        return np.concatenate([at.rates, self._accelerations(at)[0]])

    def _onto(self, t: float, y: Array) -> Array:
        """Return a state on the constraints of loops and of contacts that are closed."""
        closed = [j for j, mode in enumerate(self.mode) if mode != OPEN]
        normals = [self.equations.rows[j][0] for j in closed]
        tangents = [row for j in closed if self.mode[j] == STICKS for row in self.equations.rows[j][1]]
        return self.equations.closed(t, y, normals, [*normals, *tangents], closed)

    def _moved(self, t: float, y: Array) -> tuple[float, Array, int | None, int]:
        """Move until an event or the end; return time, state, the pair whose mode ends, and its margin."""
        from scipy.integrate import DOP853  # slow to import

        solver = DOP853(self.rates, t, y, self.duration, rtol=self.tolerance, atol=self.tolerance * self.sizes,
                        max_step=self.duration / self.steps)  # fmt: skip
        while True:
            solver.step()
            if solver.status == "failed":
                raise NoSolutionError(0, "no step above rounding meets the tolerance")
            dense = solver.dense_output()
            event = self._first_event(dense)
            end, pair, which = (solver.t, None, 0) if event is None else event
            self.motion.segments.append(_Segment(dense, end))
            self._book(dense, end)
            if event is not None:
                y = self._onto(end, dense(end))
                self._keep(end, y)
                return end, y, pair, which
            solver.y = self._onto(solver.t, solver.y)  # the next step begins on the constraints
            solver.f = self.rates(solver.t, solver.y)
            self._keep(solver.t, solver.y)
            if solver.status == "finished":
                return solver.t, solver.y, None, 0

    def _first_event(self, dense: Any) -> tuple[float, int, int] | None:
        """Return the first time within a step at which a mode ends, its pair and margin; or None."""
        times = np.linspace(dense.t_old, dense.t, PARTS + 1)
        before = self.margins(times[0], dense(times[0]))
        for left, right in pairwise(times.tolist()):
            after = self.margins(right, dense(right))
            crossings = [
                (at, j, which)
                for j in range(len(self.names))
                for at, which in self._crossing(dense, j, left, right, before[j], after[j])
            ]
            if crossings:
                return min(crossings)
            before = after
        return None

    def margins(self, t: float, y: Array) -> list[tuple[float, float]]:
        """Return for each contact the margins that end its mode below zero; of an open one its gap and rate."""
        at = self.equations.at(t, y)
        _, _, forces = self._accelerations(at)
        force, speed = FORCE * self.largest, STILL * self.scale[1]
        margins = []
        for j, (n, tangents) in enumerate(self.equations.rows):
            rows, mu = list(tangents), self.laws[j].mu
            if self.mode[j] == OPEN:
                margins.append((float(at.gap[j]), float(at.velocity[n])))
            elif self.mode[j] == STICKS:
                grip = mu * forces[n] - np.linalg.norm(forces[rows]) + force
                margins.append((min(float(forces[n]) + force, float(grip)), 0.0))
            else:
                slip = float(at.velocity[rows] @ self.ways[j]) + speed if rows and mu else math.inf
                margins.append((float(forces[n]) + force, slip))
        return margins

    def _crossing(
        self, dense: Any, j: int, left: float, right: float, before: tuple[float, float], after: tuple[float, float]
    ) -> Iterator[tuple[float, int]]:
        """Yield the times in a part of a step at which the mode of a contact ends, and its margins."""
        from scipy.optimize import brentq  # slow to import

        def root(which: int, a: float, b: float) -> float:
            return float(brentq(lambda t: self.margins(t, dense(t))[j][which], a, b, xtol=1e-300, rtol=8.9e-16))

        if self.mode[j] != OPEN:
            yield from ((root(which, left, right), which) for which in (0, 1) if before[which] > 0 > after[which])
            return
        if before[1] < 0 < after[1]:  # a dip: the gap is least where its rate rises through zero
            right = root(1, left, right)
        elif before[1] > 0 > after[1]:  # a hop
            left = root(1, left, right)
        elif after[1] >= 0:
            return
        if self.margins(left, dense(left))[j][0] > 0 > self.margins(right, dense(right))[j][0]:
            closing = root(0, left, right)
            if self.margins(closing, dense(closing))[j][1] < -STILL * self.scale[1]:
                yield closing, 0

    def _book(self, dense: Any, end: float) -> None:
        """Add the energies of a step, by Gauss's quadrature: of friction, and of drives and effects."""
        rubs = any(mode == SLIDES and law.mu for mode, law in zip(self.mode, self.laws, strict=True))
        if not rubs and not self.equations.booked:
            return
        half = (end - dense.t_old) / 2
        for place, weight in zip(*np.polynomial.legendre.leggauss(PARTS), strict=True):
            at = self.equations.at(t := dense.t_old + half * (1 + place), dense(t))
            forces = self._accelerations(at)[2]
            rows = [row for _, tangents in self.equations.rows for row in tangents]
            self.motion.rubbed -= float(half * weight * (forces[rows] @ at.velocity[rows])) if rubs else 0.0
            if self.equations.booked:
                self.motion.work += half * weight * self.equations.work(t, dense(t), forces)[0]


@dataclass(frozen=True)
class _Segment:
    """Part of a motion, up to an event or a step's end."""

    dense: Any
    t_max: float

    def __call__(self, t: float) -> Array:
        state: Array = self.dense(t)
        return state
