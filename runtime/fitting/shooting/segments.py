"""Measured runs in segments, each from a start of its own: data, end, and their derivatives."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime.fitting.forward import Forward, Point
from hertzwerk.runtime.fitting.search import FINER
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.run.continuation import parameters_of
from hertzwerk.runtime.run.request import Settings
from hertzwerk.runtime.sensitivity.sensitivities import Sensitivities
from hertzwerk.runtime.simulation import Solution, solve

Array = NDArray[np.float64]

FINEST = 1e-13  # tolerance of a run


@dataclass(frozen=True)
class Block:
    """Linearised segment: residuals (m,) and end (n,), with derivatives by x and by its start."""

    residual: Array
    by_x: Array
    by_start: Array
    end: Array
    end_by_x: Array
    end_by_start: Array


@dataclass
class Segment:
    """Segment of a measured run, from `begin` to `end` [s], with its rows of the data.

    start      state (n,) that it begins with, None of the first: the scene's
    allowed    misses (n,) of its end, one standard deviation
    """

    run: int
    begin: float
    end: float
    rows: NDArray[np.intp]
    start: Array | None
    allowed: Array
    known: dict[tuple[bytes, bytes, float], Solution | None] = field(default_factory=dict)
    linear: tuple[tuple[bytes, bytes, bytes], Block | None] | None = None


class SegmentedForward(Forward):
    """Forward model in segments; `at` is that of the starts found, which are no function of x alone."""

    def __init__(self, whole: Forward, length: float) -> None:
        self.__dict__.update(vars(whole))
        self.length, self.chains = length, [list[Segment]() for _ in whole.observed]
        self.tolerance = max(whole.tolerance / FINER, FINEST)
        self.names = [free.name for free in self.free]
        self.of_start = [free.name in states_of(self.observed[0].model) for free in self.free]

    def at(self, x: Array, tolerance: float | None = None) -> Point:
        """Return the segments' runs, in order, and what they predict."""
        predicted, times = np.full((2, len(self.measured)), np.nan)
        runs = []
        for segment in self.segments:
            each, offset = self.observed[segment.run], self.offset(segment.run, x)
            run = self.run_of(segment, x)
            runs.append(run)
            if run is not None:
                local = segment.rows - self._first(segment)
                predicted[segment.rows] = each.predicted(run, offset)[local]
                times[segment.rows] = each.times(run, offset)[local]
        return Point(tuple(runs), self.gains(x) * predicted, times)

    @property
    def segments(self) -> list[Segment]:
        """All segments, run by run."""
        return [segment for chain in self.chains for segment in chain]

    def run_of(self, segment: Segment, x: Array, tolerance: float | None = None) -> Solution | None:
        """Return the run of a segment; None where it cannot be made or ends before its time."""
        start, tol = segment.start, tolerance or self.tolerance
        key = x.tobytes(), b"" if start is None else start.tobytes(), tol
        if key not in segment.known:
            while len(segment.known) >= 3:
                segment.known.pop(next(iter(segment.known)))
            segment.known[key] = self._solved(segment, x, tol)
        return segment.known[key]

    def _solved(self, segment: Segment, x: Array, tolerance: float) -> Solution | None:
        each = self.observed[segment.run]
        parameters, initial = self.given(each, x)
        self.runs_made += 1
        try:
            run = solve(
                each.model,
                Settings(segment.end, None, tolerance, self._method),
                parameters,
                initial,
                start=None if segment.start is None else (segment.begin, segment.start),
            )
        except InputError:
            return None
        if run.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return run if run.t_end >= segment.end else None

    def residual(self, segment: Segment, x: Array, sigma: Array) -> tuple[Array, Array] | None:
        """Return the residuals of a segment over the noise, and its end; None where it has none."""
        each, run = self.observed[segment.run], self.run_of(segment, x)
        if run is None:
            return None
        predicted = each.predicted(run, self.offset(segment.run, x))[segment.rows - self._first(segment)]
        residual = (self.measured[segment.rows] - self.gains(x)[segment.rows] * predicted) / sigma[segment.rows]
        end = np.array([run.final[name] for name in states_of(each.model)])
        return (residual, end) if np.isfinite(residual).all() and np.isfinite(end).all() else None

    def _first(self, segment: Segment) -> int:
        """Return the first row of a segment's measured run."""
        return int(np.flatnonzero(self.run == segment.run)[0])

    def linear(self, segment: Segment, x: Array, sigma: Array) -> Block | None:
        """Return a segment with its derivatives, that of the last place remembered; None where it has none."""
        key = x.tobytes(), b"" if segment.start is None else segment.start.tobytes(), sigma[segment.rows].tobytes()
        if segment.linear is None or segment.linear[0] != key:
            segment.linear = key, self._linear(segment, x, sigma)
        return segment.linear[1]

    def _linear(self, segment: Segment, x: Array, sigma: Array) -> Block | None:
        each, run, offset = self.observed[segment.run], self.run_of(segment, x), self.offset(segment.run, x)
        found = self.residual(segment, x, sigma)
        if run is None or found is None:
            return None
        model = each.model
        states, k, free = states_of(model), len(x), len(self.free)
        if segment.start is None:
            of = run.sensitivities(*self.names)
            changes = slice(free)
        else:
            given = [name for name, start in zip(self.names, self.of_start, strict=True) if not start]
            begin = np.hstack([np.zeros((len(states), len(given))), np.eye(len(states))])
            bound = model.bind(parameters_of(run, model))
            of = Sensitivities(run.history, bound, {}, (*given, *states), compiled=run.compiled, begin=begin)
            changes = slice(len(given))
        if of.until < segment.end:
            return None
        local, gains = segment.rows - self._first(segment), self.gains(x)[segment.rows]
        slopes = each.slopes(run, of, offset)[local] * gains[:, None]
        at_end = np.array([of.along(np.array([segment.end]), name)[0] for name in states])
        scales = np.array([one.slope(one.outer(place)) for one, place in zip(self.searched, x, strict=True)])
        by_x, end_by_x = np.zeros((len(local), k)), np.zeros((len(states), k))
        moving = np.flatnonzero([segment.start is None or not start for start in self.of_start])
        by_x[:, moving], end_by_x[:, moving] = slopes[:, changes], at_end[:, changes]
        predicted = each.predicted(run, offset)[local]
        column = self._gain[segment.rows]
        scaled = np.flatnonzero(column >= 0)
        by_x[scaled, column[scaled]] = predicted[scaled]
        rest = slice(changes.stop, None)
        block = Block(
            found[0],
            -by_x * scales / sigma[segment.rows, None],
            -slopes[:, rest] / sigma[segment.rows, None],
            found[1],
            end_by_x * scales,
            at_end[:, rest],
        )
        return block if all(np.isfinite(part).all() for part in vars(block).values()) else None


def states_of(model: Model) -> tuple[str, ...]:
    """Return the states that a segment begins with."""
    return (*model.coordinates, *model.speeds)


def farthest_apart(run: Solution, earliest: float) -> float:
    """Return the time [s] after another at which surfaces are farthest apart; nan where one touches."""
    middles = (run.t[1:] + run.t[:-1]) / 2  # of steps: a flight may be one
    later = middles[middles >= earliest]
    if not len(later):
        return math.nan
    history = run.at(later)
    gaps = np.min([history[f"{pair}.gap"] for pair in run.model.pairs], axis=0) if run.model.pairs else later
    best = int(np.argmax(gaps))
    return float(later[best]) if gaps[best] > 0 else math.nan
