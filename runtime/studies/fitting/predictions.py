"""Predictions of measured data by runs at a place of the search, with their exact Jacobian."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.engine.model.free_quantities import Free
from hertzwerk.runtime.engine.run.run_request import Compiled
from hertzwerk.runtime.engine.start.start_values import split_values
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.studies.fitting.experiment import Observed
from hertzwerk.runtime.system.arrays import Array

STEP = 1e-4  # of the scale of the search, of differences in place of derivatives
REMEMBERED = 4  # points whose runs are remembered


@dataclass(frozen=True)
class Point:
    """Runs at a point of the search: one of each measured run, None where it cannot be made.

    predicted    of all data (n,) [SI], nan where there is nothing; times [s] at which they are
    """

    runs: tuple[Solution | None, ...]
    predicted: Array
    times: Array


class Forward:
    """Predictions of measured runs, over places x of quantities, offsets of runs, gains of columns.

    offsets    for each measured run a place in x, or an offset [s] that is given; gains: by column a place in x
    """

    def __init__(
        self,
        observed: Sequence[Observed],
        free: Sequence[Free],
        nuisance: Sequence[Free],
        offsets: Sequence[int | float],
        gains: dict[str, int],
        *,
        tolerance: float,
        method: str,
        compiled: Compiled,
    ) -> None:
        self.observed, self.free, self.nuisance = tuple(observed), tuple(free), tuple(nuisance)
        self.tolerance, self._method, self._compiled = tolerance, method, compiled
        self._offsets, self._gains = tuple(offsets), gains
        self.measured = np.concatenate([each.measured for each in observed])
        self.place = np.concatenate([each.place for each in observed])
        self.columns = [(i, k) for i, each in enumerate(observed) for k in range(len(each.channels))]
        self.column = np.concatenate(
            [each.column + sum(len(other.channels) for other in observed[:i]) for i, each in enumerate(observed)]
        )
        names = [observed[i].channels[k].column for i, k in self.columns]
        self.group = np.array([names.index(name) for name in names])[
            self.column
        ]  # data of columns of one name, whose noise is one
        self._gain = np.array([gains.get(name, -1) for name in names], dtype=int)[self.column]
        self.run = np.concatenate([np.full(len(each.at), i) for i, each in enumerate(observed)])
        self._known: dict[tuple[bytes, float], Point] = {}
        self._derived: tuple[bytes, Array] = b"", np.zeros((0, 0))
        self.runs_made = 0
        self.without_exact: set[str] = set()  # reasons why some derivatives are differences

    @property
    def searched(self) -> tuple[Free, ...]:
        """All that is free, in the order of x."""
        return (*self.free, *self.nuisance)

    def values(self, x: Array) -> dict[str, float]:
        """Return everything free by name, SI."""
        return {free.name: free.outer(place) for free, place in zip(self.searched, x, strict=True)}

    def at(self, x: Array, tolerance: float | None = None) -> Point:
        """Return the runs at a place, remembered for the last few."""
        key = x.tobytes(), tolerance or self.tolerance
        if key not in self._known:
            while len(self._known) >= REMEMBERED:
                self._known.pop(next(iter(self._known)))
            self._known[key] = self._made(x, key[1])
        return self._known[key]

    def offset(self, i: int, x: Array) -> float:
        """Return the offset [s] of a measured run."""
        place = self._offsets[i]
        return self.searched[place].outer(x[place]) if isinstance(place, int) else place

    def gains(self, x: Array) -> Array:
        """Return the gain of every datum (n,)."""
        outer = np.array([free.outer(place) for free, place in zip(self.searched, x, strict=True)] + [1.0])
        gains: Array = outer[self._gain]
        return gains

    def _made(self, x: Array, tolerance: float) -> Point:
        runs, predicted, times = [], [], []
        for i, each in enumerate(self.observed):
            run = self._run(each, x, tolerance)
            runs.append(run)
            empty = np.full(len(each.at), np.nan)
            predicted.append(empty if run is None else each.predicted(run, self.offset(i, x)))
            times.append(empty if run is None else each.times(run, self.offset(i, x)))
        return Point(tuple(runs), self.gains(x) * np.concatenate(predicted), np.concatenate(times))

    def _run(self, each: Observed, x: Array, tolerance: float) -> Solution | None:
        values = {free.name: (free.outer(float(place)), free.unit) for free, place in zip(self.free, x, strict=False)}
        parameters, initial = split_values(each.model, values)
        self.runs_made += 1
        try:
            run = simulate(
                each.model,
                duration=each.duration,
                tolerance=tolerance,
                method=self._method,
                compiled=self._compiled,
                parameters={**each.parameters, **parameters},
                initial={**each.initial, **initial},
                max_events=each.max_events,
            )
        except InputError:  # a start or a constant that these values together do not have
            return None
        if run.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return run

    def slopes(self, x: Array) -> Array:
        """Return the derivatives of what is predicted (n, x) on the scale of the search; 0 where nothing is."""
        if self._derived[0] != x.tobytes():
            self._derived = x.tobytes(), self._slopes(x)
        return self._derived[1]

    def _slopes(self, x: Array) -> Array:
        point, names = self.at(x), [free.name for free in self.free]
        scales = np.array([free.slope(free.outer(place)) for free, place in zip(self.searched, x, strict=True)])
        slopes = np.zeros((len(self.measured), len(x)))
        gains = self.gains(x)
        for i, (each, run) in enumerate(zip(self.observed, point.runs, strict=True)):
            if run is None:
                continue
            rows, offset = np.flatnonzero(self.run == i), self.offset(i, x)
            block = self._exact(each, run, names, offset) * gains[rows, None] * scales[: len(names)]
            lost = np.isfinite(point.predicted[rows]) & ~np.all(np.isfinite(block), axis=1)
            if np.any(lost):
                block[lost] = self._differences(x)[rows[lost]]
            slopes[rows, : len(names)] = block
            place = self._offsets[i]
            if isinstance(place, int):
                slopes[rows, place] = each.rates(run, offset) * gains[rows] * scales[place]
        scaled = np.flatnonzero(self._gain >= 0)
        slopes[scaled, self._gain[scaled]] = (point.predicted / gains)[scaled] * scales[self._gain[scaled]]
        slopes[~np.isfinite(slopes)] = 0.0
        return slopes

    def _exact(self, each: Observed, run: Solution, names: list[str], offset: float) -> Array:
        """Return the exact derivatives by the free quantities (n, names) [SI]; nan where there are none."""
        try:
            of = run.sensitivities(*names)
        except InputError as error:
            self.without_exact |= {f"{fault.where}: {fault.found}" for fault in error.faults}
            return np.full((len(each.at), len(names)), np.nan)
        if of.reason:
            self.without_exact.add(f"t = {of.until:.6g} s: {of.reason}")
        return each.slopes(run, of, offset)

    def _differences(self, x: Array) -> Array:
        """Return central differences in place of derivatives (n, free), on the scale of the search."""
        columns = []
        for j, free in enumerate(self.free):
            low, high = free.bounds
            step = np.zeros(len(x))
            step[j] = STEP if free.log else min(STEP, (high - low) / 4)
            ends = [np.where(step > 0, np.clip(x + sign * step, low, high), x) for sign in (1, -1)]
            above, below = (self._made(end, self.tolerance).predicted for end in ends)
            columns.append((above - below) / (ends[0][j] - ends[1][j]))
        return np.column_stack(columns)
