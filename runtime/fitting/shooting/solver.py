"""Least squares over parameters and the starts of all segments.

Segments are joined one by one, and settled by steps that are shortened and relaxed.
A step is shortened by the natural monotonicity test (Bock, Bonner Math. Schriften 183, 1987), and relaxed where curvature
that least squares leave out makes steps swing (Aitken).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.fitting.search import FINER, Found
from hertzwerk.runtime.fitting.shooting import condensing
from hertzwerk.runtime.fitting.shooting.segments import (
    FINEST,
    Block,
    Segment,
    SegmentedForward,
    farthest_apart,
    states_of,
)

Array = NDArray[np.float64]
Place = tuple[Array, list[list[tuple[Segment, Array | None]]]]

WINDOW = 0.6, 1.15  # of a segment's length: where it may end, at the step farthest from contact
CERTAIN = 10.0  # times the tolerance, of the scales: least error that is taken of a run
TIMES = 3.0  # a run's error seen, by which it may miss
SMALL, STUCK = 1e-7, 1.0  # length of steps that may be the runs' own error, and root of the squares that it may be
STEPS, SHORTEST, LONGEST = 30, 1 / 200, 2.0  # most steps, the least part of one, and the most
CONVERGED, JOINING = 0.1, 1.0  # root of what the squares may still fall by, at the end and while segments are joined
DOWN = 40  # runs down a step to a corner
LIKELY, MET = 3.0, 10.0  # deviations of the mean square of all residuals: no other start is followed, data are met
DRAWS, WIDTHS, FOLLOWED = 24, (1.0, 2.0), 3  # places tried before a segment is joined, their deviations, and settled
CUTS = 3  # times that segments are cut
SAME = 0.1  # squares by which places differ that are one
JOINED = 4.0  # mean square of a new segment's residuals over the noise beyond which it is not joined


@dataclass
class Solver:
    """Gauss-Newton over x and the starts of all segments."""

    forward: SegmentedForward
    sigma: Array
    x: Array
    low: Array
    high: Array
    ends: Sequence[float]  # [s] of the measured runs
    seed: int = 0
    converged: bool = True
    cornered: bool = False  # whether the least squares lie where a contact is about to begin
    scale: Array = field(default_factory=lambda: np.ones(0))
    closed: set[int] = field(default_factory=set)
    held: int | None = None  # place in x that stays

    def join(self, progress: Callable[[float], object]) -> None:
        """Join segments one by one, as long as they meet their data, until the ends of the measured runs."""
        chains, ends = self.forward.chains, self.ends
        while True:
            going = [
                i for i, chain in enumerate(chains) if i not in self.closed and not (chain and chain[-1].end >= ends[i])
            ]
            if not going:
                self.settle()
                return
            draws = self._draws()
            for i in going:
                self._add(i, chains[i][-1].end if chains[i] else 0.0, ends[i])
            self._settle_likeliest(draws)
            self._drop()
            progress(min(chain[-1].end / end if chain else 1.0 for chain, end in zip(chains, ends, strict=True)))

    def _draws(self) -> list[Array]:
        """Return places drawn from what the segments joined so far tell of x, the estimate first."""
        blocks = self._blocks() if self.forward.segments else None
        if blocks is None:
            return [self.x]
        told, k = np.asarray(np.linalg.qr(self._condensed(blocks)[1], mode="r")), len(self.x)
        normal = np.random.default_rng(self.seed).normal(size=(DRAWS, k)) * np.resize(WIDTHS, DRAWS)[:, None]
        changes = normal @ np.linalg.pinv(told[:k, :k], rcond=1e-9).T
        return [self.x, *np.clip(self.x + changes, self.low, self.high)]

    def _settle_likeliest(self, places: Sequence[Array]) -> None:
        """Settle from the place whose runs from the scene's start meet the data best."""
        costs = [self._squares(x) for x in places]
        for at in np.argsort(costs)[:FOLLOWED]:
            self.x = places[at]
            self._cut()
            self.settle(JOINING)
            if self.converged:
                return

    def _squares(self, x: Array) -> float:
        """Return the squares of the residuals of one run from the scene's start through each chain."""
        found = 0.0
        for i, chain in enumerate(self.forward.chains):
            if chain:
                rows = np.concatenate([segment.rows for segment in chain])
                told = self.forward.residual(Segment(i, 0.0, chain[-1].end, rows, None, np.zeros(0)), x, self.sigma)
                found += math.inf if told is None else float(told[0] @ told[0])
        return found

    def _cut(self) -> None:
        """Cut the runs from the scene's start at x into segments anew, at least as far as they were followed."""
        for i, chain in enumerate(self.forward.chains):
            end, self.forward.chains[i] = chain[-1].end if chain else 0.0, []
            begin = 0.0
            while begin < end and i not in self.closed:
                self._add(i, begin, self.ends[i])
                begin = self.forward.chains[i][-1].end if self.forward.chains[i] else begin

    def _touching(self) -> bool:
        """Return whether surfaces touch where segments join: what a contact remembers is lost there."""
        for chain in self.forward.chains:
            for segment in chain[:-1]:
                run = self.forward.run_of(segment, self.x)
                if run is not None and run.model.pairs:
                    end = run.at(np.array([segment.end]))
                    if min(float(end[f"{pair}.gap"][0]) for pair in run.model.pairs) <= 0:
                        return True
        return False

    def worth(self, most: float = LIKELY) -> tuple[bool, int, float]:
        """Return whether all data are met, their number, and less their mean square over the noise.

        most    deviations of that mean square from 1
        """
        if not self.forward.segments:
            return False, 0, -math.inf
        found = self.found()
        square, count = float(np.mean(found.residuals**2)), int(np.sum(found.used))
        met = square < 1 + most * math.sqrt(2 / count)
        return bool(np.all(found.used) and met and self.converged), count, -square

    def _add(self, i: int, begin: float, end: float) -> None:
        forward, length = self.forward, self.forward.length
        chain, states = forward.chains[i], states_of(forward.observed[i].model)
        segment = Segment(i, begin, begin, np.zeros(0, dtype=int), None, np.zeros(0))
        if chain:
            before = forward.run_of(chain[-1], self.x)
            if before is None:
                self.closed.add(i)
                return
            segment.start = np.array([before.final[name] for name in states])
        joint, times = math.nan, 0
        while math.isnan(joint):  # surfaces may touch throughout: longer
            times += 1
            segment.end = min(begin + times * WINDOW[1] * length, end)
            run = forward.run_of(segment, self.x)
            segment.known.clear()
            if run is None:
                self.closed.add(i)
                return
            last = segment.end >= end
            joint = end if last else farthest_apart(run, begin + (times - 1 + WINDOW[0]) * length)
        segment.end = joint
        if run is not None and not len(self.scale):
            self.scale = np.array(run.scales.state[: len(states)])
        at = forward.observed[i].at + forward.offset(i, self.x)
        inside = (at >= begin) & ((at < segment.end) | (last & (at <= segment.end)))
        segment.rows = np.flatnonzero(forward.run == i)[inside]
        coarse, fine = (
            forward.run_of(segment, self.x),
            forward.run_of(segment, self.x, max(forward.tolerance / FINER, FINEST)),
        )
        if coarse is None or fine is None:
            self.closed.add(i)
            return
        miss = np.abs([coarse.final[name] - fine.final[name] for name in states])
        segment.allowed = np.maximum(TIMES * miss, CERTAIN * forward.tolerance * self.scale)
        chain.append(segment)

    def _drop(self) -> None:
        """Take back segments whose data are not met."""
        for i, chain in enumerate(self.forward.chains):
            if len(chain) > 1 and i not in self.closed and len(chain[-1].rows):
                found = self.forward.residual(chain[-1], self.x, self.sigma)
                if found is None or not np.mean(found[0] ** 2) < JOINED:
                    chain.pop()
                    self.closed.add(i)

    def loosest(self) -> float:
        """Return the largest miss that is allowed at a joint, of the scales."""
        return float(np.max([segment.allowed / self.scale for segment in self.forward.segments]))

    def settle(self, within: float = CONVERGED) -> None:
        """Find the least squares; where surfaces come to touch at a joint, segments are cut anew."""
        for _ in range(CUTS):
            self._settle(within)
            if not (self.converged and self._touching()):
                return
            self.converged = False
            self._cut()

    def _settle(self, within: float) -> None:
        """Take steps, relaxed and shortened, until squares fall by no more than within^2.

        Where the curvature that the least squares leave out is c times theirs, steps of x are -c times the last:
        1 / (1 + c) of one is taken, c by the last two (Aitken).
        """
        taken, share, self.cornered = np.zeros(0), 1.0, False
        for _ in range(STEPS):
            blocks = self._blocks()
            if blocks is None:
                break
            step, size = self._step(blocks)
            length, dx = self._length(step), step[0, : len(self.x)] / (self.high - self.low)
            if size < (STUCK if length < SMALL else within):
                self.converged = True
                return
            if len(taken):
                share = 1 / max(1 / LONGEST, 1 / share - float(dx @ taken) / float(taken @ taken))
                step, _ = self._step(blocks, share=share)
            part, longest = 1.0, max(length, SMALL)
            while part > SHORTEST and not self._moved(blocks, step, part, longest * (1 - min(share, 1) * part / 4)):
                part /= 2
            if part <= SHORTEST:
                fell = self._descended(step[0, : len(self.x)])
                if not fell > within**2:
                    self.converged = self.cornered = fell >= 0
                    return
                taken, share = np.zeros(0), 1.0
                continue
            share *= part
            taken = share * dx
        self.converged = False

    def _descended(self, dx: Array) -> float:
        """Go down along a change of x by runs from the scene's start, and return how far squares fell.

        Where a contact is about to begin the least squares have a corner, to whose other side slopes say nothing. nan without a run.
        """
        x, begun = self.x, self._squares(self.x)
        least, part = begun, 1.0
        for _ in range(DOWN):
            there = np.clip(x + part * dx, self.low, self.high)
            found = self._squares(there)
            if found < least:
                x, least = there, found
            else:
                part /= 2
        self.x = x
        self._cut()
        followed = bool(self.forward.segments) and math.isfinite(begun) and abs(self.cost() - least) < SAME
        return begun - least if followed else math.nan

    def _moved(self, blocks: Sequence[Block], step: Array, part: float, length: float) -> bool:
        """Take part of a step, unless the next one, by the same derivatives, would be longer than `length`."""
        before = self.place
        self._take(part * step)
        found = [self.forward.residual(segment, self.x, self.sigma) for segment in self.forward.segments]
        if all(one is not None for one in found):
            later = [
                replace(block, residual=one[0], end=one[1]) for block, one in zip(blocks, found, strict=True) if one
            ]
            if self._length(self._step(later)[0]) <= length:
                return True
        self.place = before
        return False

    def _take(self, step: Array) -> None:
        self.x = np.clip(self.x + step[0, : len(self.x)], self.low, self.high)
        for segment, change in zip(self.forward.segments, step[1:], strict=True):
            if segment.start is not None:
                segment.start = segment.start + change[: len(self.scale)] * self.scale

    @property
    def place(self) -> Place:
        """Where it is: x, and the segments of every run with their starts."""
        return self.x, [[(segment, segment.start) for segment in chain] for chain in self.forward.chains]

    @place.setter
    def place(self, place: Place) -> None:
        self.x = place[0]
        for i, chain in enumerate(place[1]):
            self.forward.chains[i] = [segment for segment, _ in chain]
            for segment, start in chain:
                segment.start = start

    def hold(self, j: int, at: float) -> None:
        """Settle with one entry of x held at a place, all else moved there first by the derivatives."""
        self.held, self.converged = j, False
        try:
            blocks = self._blocks()
            if blocks is not None:
                self._take(self._step(blocks, at - float(self.x[j]))[0])
                self.settle()
        finally:
            self.held = None

    def cost(self) -> float:
        """Return the squares of all residuals over the noise, and of what segments miss over what they may."""
        segments, found = self.forward.segments, 0.0
        for segment, after in zip(segments, [*segments[1:], None], strict=True):
            told = self.forward.residual(segment, self.x, self.sigma)
            if told is None:
                return math.inf
            found += float(told[0] @ told[0])
            if after is not None and after.start is not None:
                found += float(np.sum(((told[1] - after.start) / segment.allowed) ** 2))
        return found

    def slope(self, j: int) -> float:
        """Return the derivative of the least squares by an entry of x that is held; nan at a corner."""
        blocks = self._blocks()
        if blocks is None or self.cornered:
            return math.nan
        rows = self._condensed(blocks)[1]
        return -2 * float(rows[:, j] @ rows[:, -1])

    def _length(self, step: Array) -> float:
        """Return the length of a step, x over the width of its range and starts over the scales."""
        return float(np.linalg.norm(np.append(step[0, : len(self.x)] / (self.high - self.low), step[1:])))

    def _blocks(self) -> list[Block] | None:
        found = [self.forward.linear(segment, self.x, self.sigma) for segment in self.forward.segments]
        return None if any(block is None for block in found) else [block for block in found if block is not None]

    def _step(self, blocks: Sequence[Block], by: float = 0.0, share: float = 1.0) -> tuple[Array, float]:
        return condensing.step(*self._condensed(blocks), len(self.scale), held=self.held, by=by, share=share)

    def _condensed(self, blocks: Sequence[Block]) -> tuple[list[Array | None], Array]:
        return condensing.condensed(self.forward.segments, blocks, self.scale)

    def found(self) -> Found:
        """Return the place with residuals, and the factor of what all segments tell of x as their Jacobian."""
        forward, k = self.forward, len(self.x)
        used = np.zeros(len(forward.measured), dtype=bool)
        used[np.concatenate([segment.rows for segment in forward.segments])] = True
        residual = ((forward.measured - forward.at(self.x).predicted) / self.sigma)[used]
        blocks = self._blocks()
        told = np.zeros((k, k))
        if blocks is not None:
            told = np.asarray(np.linalg.qr(self._condensed(blocks)[1], mode="r"))[:k, :k]
        missed = self.cost() - float(residual @ residual)
        return Found(self.x, used, self.sigma, residual, told, self.converged and blocks is not None, missed)
