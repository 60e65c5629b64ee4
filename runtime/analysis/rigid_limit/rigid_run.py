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
from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import Contact, NoSolutionError, solved
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

    t (n,), y (n, nq + nu) at the ends of steps, before and after impacts; segments: end [s] and state by time of each step
    rubbed    energy [J] that friction dissipated between impacts
    work    energy [J] that drives and effects put in, less what effects dissipated; 0 without an `EnergyLedger`
    """

    t: list[float] = field(default_factory=list)
    y: list[Array] = field(default_factory=list)
    impulses: list[RigidImpulse] = field(default_factory=list)
    accumulations: list[Accumulation] = field(default_factory=list)
    segments: list[tuple[float, Callable[[float], Array]]] = field(default_factory=list)
    events: list[RigidEvent] = field(default_factory=list)
    rubbed: float = 0.0
    work: float = 0.0
    outcome: Outcome = field(default_factory=lambda: Outcome("finished", "", ""))

    def at(self, times: Array) -> Array:
        """Return the states (n, nq + nu) at times within the run, after an impact at the same instant."""
        places = np.searchsorted([end for end, _ in self.segments[:-1]], times, side="right")
        return np.array([self.segments[k][1](t) for k, t in zip(places, times, strict=True)])


@dataclass
class RigidRun:
    """A run, but for its results.

    together    whether contacts that touch take their impulses at once, or one by one, the fastest first
    scale    of length [m], speed [m/s], force [N]; sizes (nq + nu) of the states; tolerance of a step relative to them; steps    least number
    """

    equations: Equations
    contacts: Sequence[Contact]
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
        self.mode, self.ways = [OPEN] * len(self.contacts), [np.zeros(0)] * len(self.contacts)
        ended, which = None, 0
        try:
            while t < self.duration and len(motion.impulses) <= MOST_IMPACTS:
                y = self._through(t, y, ended, which)
                self._keep(t, y)
                t, y, ended, which = self._moved(t, y)
        except NoSolutionError as error:
            motion.outcome = Outcome("no_rigid_solution", f"at t = {t:.9g} s, {error.pair}: {error.why}",
                                     "take less friction, or the compliant contact of the scene, which has a solution there")  # fmt: skip
            return motion
        motion.outcome = Outcome("finished", f"reached the end at t = {t:.6g} s", "")
        if t < self.duration:
            motion.outcome = Outcome("too_many_impacts", f"{MOST_IMPACTS:,} impacts by t = {t:.9g} s",
                                     "take a smaller restitution or a shorter duration")  # fmt: skip
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

    def _through(self, t: float, y: Array, ended: int | None, which: int) -> Array:
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
        normals = [one.n for one in self.contacts]
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
        contacts = [self.contacts[j] for j in touching]
        if self.together:
            return self._impulse(t, y, contacts)
        for _ in range(MOST_IMPACTS):
            velocity = self.equations.at(t, y).velocity
            fastest = min(contacts, key=lambda one: float(velocity[one.n]))
            if velocity[fastest.n] >= -STILL * self.scale[1]:
                return y
            y = self._impulse(t, y, [fastest])
        raise NoSolutionError(fastest.pair, "impacts one by one do not come to an end")

    def _impulse(self, t: float, y: Array, contacts: Sequence[Contact]) -> Array:
        """Return the state after the impulses of some contacts, kept in the motion's list."""
        at = self.equations.at(t, y)
        v, b = at.velocity, at.velocity.copy()
        for one in contacts:
            b[one.n] += 0.0 if one.poisson else one.e * min(v[one.n], 0.0)
        impulse = solved(at.D, b, contacts)
        if any(one.poisson and one.e for one in contacts):
            back = [replace(one, least=one.e * impulse[one.n] if one.poisson else 0.0) for one in contacts]
            impulse = impulse + solved(at.D, v + at.D @ impulse, back)
        after = v + at.D @ impulse
        for one in contacts:
            if impulse[one.n] > 0:
                lost = -sum(impulse[row] * (v[row] + after[row]) / 2 for row in (one.n, *one.tangents))
                self.motion.impulses.append(RigidImpulse(
                    one.pair, t, float(-v[one.n]), float(after[one.n]), float(impulse[one.n]),
                    float(np.linalg.norm(impulse[one.tangents])), float(lost)))  # fmt: skip
        return self._pushed(t, y, at, impulse)

    def _pushed(self, t: float, y: Array, at: State, impulse: Array) -> Array:
        """Return the state after impulses along the rows, and add the work of drives at them."""
        self.motion.work += self.equations.work(t, y, impulse)[1]
        nq = self.equations.model.nq
        return np.concatenate([y[:nq], y[nq:] + at.pushed @ impulse])

    def _accumulated(self, t: float, y: Array, at: State, hit: Sequence[int]) -> tuple[Array, State]:
        """End sequences of impacts whose limit is next to now: these contacts are at rest from then on.

        From now to the limit they would take what the load brings less what still opens them, and so would friction.
        """
        speed = STILL * self.scale[1]
        self._decide(at, [j for j in hit if abs(at.velocity[self.contacts[j].n]) <= speed])
        _, rates, _ = self._accelerations(at)
        normals, pushes = [], []
        for one in (self.contacts[j] for j in hit):
            opening, closing = float(at.velocity[one.n]), -float(rates[one.n])
            if opening > speed and closing > 0 and one.e < 1:
                left = 2 * opening / closing / (1 - one.e)
                if left <= ACCUMULATED * self.duration or opening**2 / closing < FLAT * self.scale[0]:
                    normals.append(one.n)
                    way, push = at.velocity[one.tangents], np.zeros(len(at.bias))
                    push[[one.n, *one.tangents]] = [1.0, *(-one.mu * way / max(float(np.linalg.norm(way)), speed))]
                    pushes.append(push)
                    self.motion.accumulations.append(Accumulation(one.pair, t + left))
        if not normals:
            return y, at
        columns: Array = np.transpose(pushes)
        impulse = columns @ np.linalg.lstsq(at.D[normals] @ columns, -at.velocity[normals])[0]
        self.motion.rubbed -= float(impulse @ (at.velocity + at.D @ impulse / 2))
        y = self._pushed(t, y, at, impulse)
        return y, self.equations.at(t, y)

    def _decide(self, at: State, resting: Sequence[int], slips: int | None = None) -> None:
        """Set the modes of all contacts, by the forces that those at rest along the normal need.

        slips    pair that may not stick
        """
        self.mode = [OPEN] * len(self.contacts)
        contacts = []
        for one in (self.contacts[j] for j in resting):
            size = float(np.linalg.norm(way := at.velocity[one.tangents]))
            contacts.append(replace(one, slides=way / size if one.mu and size > STILL * self.scale[1] else None))
        forces = solved(at.D, at.bias, contacts)
        rates = at.D @ forces + at.bias
        self.largest = max(self.largest, WEAK * self.scale[2], float(np.max(np.abs(forces))))
        for j, one in zip(resting, contacts, strict=True):
            none = FORCE / 2 * self.largest * at.D[one.n, one.n]
            if forces[one.n] <= 0 and rates[one.n] > none:
                continue
            most, held = one.mu * forces[one.n], float(np.linalg.norm(forces[one.tangents]))
            holds = held < most * (1 - 1e-9) or np.linalg.norm(rates[one.tangents]) <= none
            self.mode[j] = SLIDES
            if not one.tangents or not one.mu or one.slides is not None:
                self.ways[j] = np.zeros(len(one.tangents)) if one.slides is None else one.slides
            elif holds and (j != slips or not held):
                self.mode[j] = STICKS
            else:
                self.ways[j] = -forces[one.tangents] / held

    # -- between impacts -----------------------------------------------------------------------------------------------

    def _pushes(self, at: State) -> tuple[Array, list[int]]:
        """Return the rows (m, n) that each unknown pushes along, and the rows (n,) that they hold."""
        columns, rows = [], []
        for j, one in enumerate(self.contacts):
            if self.mode[j] == OPEN:
                continue
            push = np.zeros(len(at.bias))
            push[one.n] = 1.0
            if self.mode[j] == SLIDES and one.mu:
                push[one.tangents] = -one.mu * self._way(j, at)
            held = one.tangents if self.mode[j] == STICKS else []
            columns += [push, *np.eye(len(at.bias))[held]]
            rows += [one.n, *held]
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
        for j, one in enumerate(self.contacts):
            if self.mode[j] == SLIDES and one.tangents:
                way, v, dv = self._way(j, at), at.velocity[one.tangents], by.velocity[one.tangents]
                turn = (dv - way * (way @ dv)) / max(float(np.linalg.norm(v)), STILL * self.scale[1])
                turned[one.tangents, rows.index(one.n)] = -one.mu * turn - dmu[j] * way
        system = at.D[rows] @ pushes
        size = np.linalg.lstsq(system, -at.bias[rows], rcond=1e-12)[0]
        more = by.bias[rows] + (by.D[rows] @ pushes + at.D[rows] @ turned) @ size
        forces = turned @ size - pushes @ np.linalg.lstsq(system, more, rcond=1e-12)[0]
        return np.concatenate([by.rates, by.free + by.pushed @ (pushes @ size) + at.pushed @ forces])

    def _way(self, j: int, at: State) -> Array:
        """Return the direction in which a contact slides, also where it begins to."""
        v: Array = at.velocity[self.contacts[j].tangents] + STILL * self.scale[1] * self.ways[j]
        size = float(np.linalg.norm(v))
        return v / size if size > 0 else v

    def rates(self, t: float, y: Array) -> Array:
        """Return the rates (nq + nu,) of a state in the modes of now."""
        at = self.equations.at(t, y)
        return np.concatenate([at.rates, self._accelerations(at)[0]])

    def _onto(self, t: float, y: Array) -> Array:
        """Return a state on the constraints of loops and of contacts that are closed."""
        closed = [j for j, mode in enumerate(self.mode) if mode != OPEN]
        normals = [self.contacts[j].n for j in closed]
        tangents = [row for j in closed if self.mode[j] == STICKS for row in self.contacts[j].tangents]
        return self.equations.closed(t, y, normals, [*normals, *tangents], closed)

    def _moved(self, t: float, y: Array) -> tuple[float, Array, int | None, int]:
        """Move until an event or the end; return time, state, the pair whose mode ends, and its margin."""
        from scipy.integrate import DOP853  # slow to import

        solver = DOP853(self.rates, t, y, self.duration, rtol=self.tolerance, atol=self.tolerance * self.sizes,
                        max_step=self.duration / self.steps)  # fmt: skip
        while True:
            solver.step()
            if solver.status == "failed":
                raise NoSolutionError(self.contacts[0].pair, "no step above rounding meets the tolerance")
            dense = solver.dense_output()
            event = self._first_event(dense)
            end, pair, which = (solver.t, None, 0) if event is None else event
            self.motion.segments.append((end, dense))
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
                for j in range(len(self.contacts))
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
        for j, one in enumerate(self.contacts):
            pressed, rows = float(forces[one.n]) + force, one.tangents
            if self.mode[j] == OPEN:
                margins.append((float(at.gap[j]), float(at.velocity[one.n])))
            elif self.mode[j] == STICKS:
                grip = one.mu * forces[one.n] - np.linalg.norm(forces[rows]) + force
                margins.append((min(pressed, float(grip)), 0.0))
            else:
                slip = float(at.velocity[rows] @ self.ways[j]) + speed if rows and one.mu else math.inf
                margins.append((pressed, slip))
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
        rubs = any(mode == SLIDES and one.mu for mode, one in zip(self.mode, self.contacts, strict=True))
        if not rubs and not self.equations.booked:
            return
        half = (end - dense.t_old) / 2
        for place, weight in zip(*np.polynomial.legendre.leggauss(PARTS), strict=True):
            at = self.equations.at(t := dense.t_old + half * (1 + place), dense(t))
            forces = self._accelerations(at)[2]
            rows = [row for one in self.contacts for row in one.tangents]
            self.motion.rubbed -= float(half * weight * (forces[rows] @ at.velocity[rows])) if rubs else 0.0
            if self.equations.booked:
                self.motion.work += half * weight * self.equations.work(t, dense(t), forces)[0]
