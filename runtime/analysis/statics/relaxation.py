"""Search for positions of rest: steps of a strongly damped motion, ever longer, then Newton's method.

W dx/ds = F + G^T lambda + D mu is how the mechanism would creep through a viscous fluid; its implicit Euler steps
take the stiffness of contacts that close on the way as it is, and end in Newton's method as they grow. What they
approach is stable. Where contacts stick they hold what is below their limit, else they creep. Kelley, Keyes, SIAM J.
Numer. Anal. 35 (1998) 508 (pseudo-transient continuation).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.analysis.statics.balance import (
    Balance,
    balance,
    drifting,
    followed,
    followers,
    gauge_of,
    grip_names,
    grip_pairs,
    kernel,
    limits,
    sizes_of,
)
from hertzwerk.runtime.engine.integration.step.set_valued_friction import groups_of
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.system.arrays import Array

Flags = NDArray[np.bool_]

STEPS, ITERATIONS, POLISH = 400, 40, 40
LONGER, SHORTER = 4.0, 8.0  # factors of a step after success and failure
FIRST = 0.1  # scales: first displacement
TURN = 0.3  # rad: largest of an iteration
DEEP = 0.1  # of the scene's length: largest penetration that an iteration may make of a gap
SETTLED = 1e-6  # scales: change that ends the iterations of a step
BALANCED = 1e-10  # sum of the forces over the largest force
EPS = 4e-15  # relative rounding of a position and of the geometry that follows from it
CLOSED = 1e-11  # residual of a loop over the largest motion by a coordinate
HOLDS = 1e-9  # excess of a grip over its limit that counts as rounding
STEADY, ROUNDS = 1e-13, 3  # scales: change that ends Newton's method, or so many rounds in balance
NEAR, TRIED = 1.0, 4  # scales: shorter steps try Newton's method, longer ones one in so many
AWAY = 1e9  # scales: what moves further has no place of rest
VANISHED = 1e-13  # of the largest direction of a constraint: below it is rounding of one that has no part there
NONE = BALANCED / AWAY  # stiffness over the largest load: no displacement makes it an unbalanced force


@dataclass
class Rest:
    """Position q (nq,), multipliers (nl,), mu (n,), closed pairs (k,), and whether each grip sticks (n,).

    unbalanced (nu,): what is left of the forces, relative to the largest force.
    """

    q: Array
    multipliers: Array
    mu: Array
    closed: Array
    sticks: Flags
    balance: Balance
    unbalanced: Array
    converged: bool = False


@dataclass
class Search:
    """Search for the rest of a model at a time; scale (nu,): displacements that count as one, length [m]."""

    model: EngineModel
    bound: BoundParameters
    t: float
    scale: Array = field(init=False)
    length: float = field(init=False)
    load: float = field(init=False, default=0.0)  # largest load at the start, without contacts, times its scale [J]

    def __post_init__(self) -> None:
        _, su, _, scene = self.model.evaluate("scales", self.bound.p)
        length, speed = (float(x) if np.isfinite(x) and x > 0 else 1.0 for x in scene[:2])
        sizes = np.where(np.isfinite(su) & (su > 0), su, speed) / speed * length
        self.scale, self.length = np.maximum(sizes, 1e-12), length

    def start(self, q: Array) -> Rest:
        """Return the state of the search at a position."""
        model, n = self.model, len(grip_pairs(self.model))
        none = np.zeros(model.k), np.zeros(model.nl), np.zeros(n)
        loads = balance(model, self.bound, self.t, q, *none).force * self.scale
        self.load = float(np.max(np.abs(loads), initial=0.0))
        return self._at(q, np.zeros(model.nl), np.zeros(n), np.ones(n, dtype=bool))

    def nearest(self, q: Array) -> Rest:
        """Return the equilibrium that Newton's method finds from a position, stable or not."""
        return self._polished(self.start(q))

    def relaxed(self, q: Array) -> Rest:
        """Return the place of rest that a strongly damped motion from a position leads to."""
        rest = self._polished(self.start(q), within=SETTLED)
        follow = {self.model.coordinates[i] for i in followers(self.model)}
        if (
            rest.converged or drifting(self.model, self.bound, self.t, q).keys() - follow
        ):  # no position stops the latter
            return rest
        rest = self.start(q)
        pull = float(np.max(np.abs(rest.balance.force * self.scale), initial=0.0)) or 1.0
        stretch, moved = FIRST / pull, 0.0  # pseudo-time over the weight 1/scale^2
        for count in range(1, STEPS + 1):
            if not stretch > 0:  # no step is short enough, or no force is finite
                break
            following = self._step(rest, stretch)
            if following is None:
                stretch /= SHORTER
                continue
            rest, change = following
            stretch, moved = stretch * LONGER, moved + change
            if moved > AWAY:
                break
            if change < NEAR or count % TRIED == 0:
                polished = self._polished(rest, within=max(change, SETTLED))
                if polished.converged:
                    return polished
        return rest

    # -- one step ------------------------------------------------------------------------------------------------------

    def _step(self, rest: Rest, stretch: float) -> tuple[Rest, float] | None:
        """Take an implicit step of the damped motion; return it and its size in scales, None if it fails."""
        least = 2.0 * max(-self._least_stiffness(rest), 0.0)  # where it is negative, a longer step would go uphill
        drag = max(1.0 / stretch, least) / self.scale**2
        here, total = rest, np.zeros(self.model.nu)
        for _ in range(ITERATIONS):
            step = self._iterate(here, drag, total)
            if step is None:
                return None
            here, total = step[0], total + step[1]
            self._decide(here, total)
            if self._size(step[1]) <= SETTLED * max(1.0, self._size(total)):
                return here, self._size(total)
        return None

    def _polished(self, rest: Rest, within: float = np.inf) -> Rest:
        """Iterate without drag, all contacts sticking; found where the forces balance within so many scales."""
        here, total, no_drag = replace(rest, sticks=np.ones(rest.mu.size, dtype=bool)), 0.0, np.zeros(self.model.nu)
        settled = 0
        for _ in range(POLISH):
            step = self._iterate(here, no_drag, no_drag)
            if step is None or (total := total + self._size(step[1])) > within:
                break
            here = step[0]
            settled = settled + 1 if self._balanced(here) else 0
            if settled and (settled >= ROUNDS or self._size(step[1]) <= STEADY):
                return replace(here, converged=True)
        return rest

    def _balanced(self, rest: Rest) -> bool:
        """Return whether forces balance, states stay, loops close, grips hold, laws are in range."""
        at = rest.balance
        reach = max(
            float(np.max(np.abs(at.G), initial=0.0)) * max(1.0, float(np.max(np.abs(rest.q), initial=0.0))), 1e-9
        )
        return bool(
            np.all(np.abs(rest.unbalanced) <= BALANCED)
            and np.all(np.abs(at.loops) <= CLOSED * reach)
            and np.all(sizes_of(self.model, rest.mu) <= limits(self.model, self.bound, at) * (1 + HOLDS))
            and np.all(at.in_range > 0.5)
            and not drifting(self.model, self.bound, self.t, rest.q)
        )

    def _iterate(self, rest: Rest, drag: Array, total: Array) -> tuple[Rest, Array] | None:
        """Take one Newton iteration of drag total = F + G^T lambda + D mu.

        Loops are closed, and contacts stick. Return what it leads to, and its change (nu,); None where the equations are not finite.
        """
        at, nu, loops = rest.balance, self.model.nu, self.model.nl
        sticks = np.flatnonzero(rest.sticks & (rest.closed[list(grip_pairs(self.model))] > 0))
        slides = np.setdiff1d(np.arange(rest.mu.size), sticks)
        directions, held = np.vstack([at.G, at.S[sticks]]), np.hstack([at.G.T, at.D[:, sticks]])
        n, unit = nu + len(directions), self.scale
        matrix = np.zeros((n, n))
        stiffness = unit[:, None] * at.stiffness * unit
        matrix[:nu, :nu] = np.where(np.abs(stiffness) < NONE * self.load, 0.0, stiffness) + np.diag(drag * unit**2)
        matrix[:nu, nu:], matrix[nu:, :nu] = -_significant(unit[:, None] * held), _significant(directions * unit)
        known = at.force + at.D[:, slides] @ rest.mu[slides] - drag * total
        solution = _solved(matrix, np.concatenate([unit * known, -at.loops, -at.S[sticks] @ total]))
        if solution is None:
            return None
        part = self._part(at, unit * solution[:nu])
        change, multipliers, mu = part * unit * solution[:nu], rest.multipliers.copy(), rest.mu.copy()
        multipliers += part * (solution[nu : nu + loops] - multipliers)
        mu[sticks] += part * (solution[nu + loops :] - mu[sticks])
        mu[rest.closed[list(grip_pairs(self.model))] == 0] = 0.0
        moved = rest.q + at.moves @ change
        for i in self.model.quaternions:
            moved[i : i + 4] /= np.linalg.norm(moved[i : i + 4])
        if not np.all(np.isfinite(moved)):
            return None
        return self._at(moved, multipliers, mu, rest.sticks), change

    def _part(self, at: Balance, change: Array) -> float:
        """Return the part of an iteration's change that neither turns too far nor closes a gap too deep."""
        turns = np.array([self.model.units[name] == "rad/s" for name in self.model.speeds], dtype=bool)
        part = min(1.0, TURN / max(float(np.max(np.abs(change[turns]), initial=0.0)), 1e-300))
        rates = at.W @ change
        for gap, rate in zip(at.gap, rates, strict=True):
            if gap > 0 > gap + rate:
                part = min(part, (gap + DEEP * self.length) / -rate)
        return part

    def _least_stiffness(self, rest: Rest) -> float:
        """Return the least real part of the eigenvalues of the stiffness, in scales, with closed loops.

        Not that of its symmetric part: friction that grows with the load makes that indefinite, and nothing moves uphill.
        """
        free, unit = kernel(rest.balance.G * self.scale), self.scale
        stiffness = free.T @ (unit[:, None] * rest.balance.stiffness * unit) @ free
        return float(np.min(np.linalg.eigvals(stiffness).real)) if stiffness.size else 0.0

    def _decide(self, rest: Rest, total: Array) -> None:
        """Decide which grips stick in a step: what was beyond its limit slips, while that takes energy."""
        bound, ways = limits(self.model, self.bound, rest.balance), rest.balance.D.T @ total
        for group in groups_of(grip_names(self.model)):
            limit, size = bound[group[0]], gauge_of(rest.mu[group])
            if (
                rest.sticks[group[0]] or size == 0.0
            ):  # what was clipped under no load, as a contact closed, slips nowhere
                rest.sticks[group] = size <= limit * (1 + HOLDS)
            else:
                rest.sticks[group] = rest.mu[group] @ ways[group] > 0
            if size > limit:
                rest.mu[group] *= limit / size

    def _at(self, q: Array, multipliers: Array, mu: Array, sticks: Flags) -> Rest:
        model, still = self.model, np.zeros(self.model.nu)
        q = followed(model, self.bound, self.t, q)
        gap = model.evaluate("gaps", self.t, q, still, self.bound.c)[0] if model.k else still[:0]
        closed = (gap < 0).astype(float)
        at = balance(model, self.bound, self.t, q, closed, multipliers, mu)
        terms = np.vstack([at.force, at.G * multipliers[:, None], at.D.T * mu[:, None]]) * self.scale
        pressed = at.W * at.normal[:, None] * self.scale
        most = max(self.load, *(float(np.max(np.abs(x), initial=0.0)) for x in (terms, pressed)))
        left = np.sum(terms, axis=0)
        places = np.maximum(np.abs(at.moves).T @ np.abs(q), self.scale)
        rounding = EPS * float(np.max(self.scale * (np.abs(at.stiffness) @ places), initial=0.0))
        return Rest(q, multipliers, mu, closed, sticks.copy(), at, left / max(most, rounding / BALANCED, 1e-300))

    def _size(self, change: Array) -> float:
        return float(np.max(np.abs(change) / self.scale, initial=0.0))


def _solved(matrix: Array, right: Array) -> Array | None:
    """Solve a system that redundant loops or indifferent freedoms make singular, with the least solution."""
    if not np.all(np.isfinite(matrix)) or not np.all(np.isfinite(right)):
        return None
    rows = _sizes(np.abs(matrix).max(axis=1, initial=0.0))
    columns = _sizes(np.abs(matrix / rows[:, None]).max(axis=0, initial=0.0))
    scaled = matrix / rows[:, None] / columns
    return np.linalg.lstsq(scaled, right / rows, rcond=1e-13)[0] / columns


def _sizes(largest: Array) -> Array:
    """Return sizes to divide by: infinite ones of what nothing holds, so that it stays."""
    return np.where(largest > 0, largest, np.inf)


def _significant(directions: Array) -> Array:
    """Return directions without what is rounding of zero."""
    return np.where(np.abs(directions) < VANISHED * np.max(np.abs(directions), initial=0.0), 0.0, directions)
