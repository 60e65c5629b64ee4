"""Search for the least squares: a Latin hypercube of starts, and windows that lengthen.

A start is judged by its residuals over all windows; the best few are followed on the shortest, where a trajectory is
still determined by its parameters, and from window to window, as long as the run's own error stays below the noise.
Predictions of measured data come with their exact Jacobian.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.engine.model.free_quantities import Free
from hertzwerk.runtime.engine.model.ranges import starts_in
from hertzwerk.runtime.engine.run.run_request import Compiled
from hertzwerk.runtime.engine.start.start_values import split_values
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.studies.fitting.experiment import Observed
from hertzwerk.runtime.system.arrays import Array

FOLLOWED, OF_MANY = 3, 16  # starts that are followed, and of how many starts one is at least
WINDOWS = (0.125, 0.25, 0.5, 1.0)  # parts of each measured run
FEW = 4  # times the number of what is free: data that a window needs
FINER = 30.0  # part of the tolerance of a run that tells the error of one
OWN = 0.1  # of the noise: largest error of a run itself where data are compared
GUESSED = 1e-2  # of a column's spread: its noise where none is stated, before the first residuals
LOST = 5.0  # of a column's spread: residual where a run has no value
ALIKE = 1e-6  # of the scale of the search: places that are one
CONVERGED, ROUGH = 1e-10, 1e-4  # relative: of the last window, and of a start for the next


@dataclass(frozen=True)
class Estimate:
    """Least squares over the rows used (n,), at a place x, over the noise sigma of each row."""

    x: Array
    used: NDArray[np.bool_]
    sigma: Array
    residuals: Array
    jacobian: Array
    converged: bool

    @property
    def cost(self) -> float:
        """Sum of the squared residuals over the noise."""
        return float(self.residuals @ self.residuals)


class Search:
    """Least squares of a forward model; sigma: stated noise of each row (n,), nan where none is stated."""

    def __init__(self, forward: Forward, sigma: Array, progress: Callable[[float], object] | None = None) -> None:
        self.forward, self.stated, self._progress = forward, sigma, progress or (lambda _: None)
        columns = [forward.measured[forward.column == k] for k in range(len(forward.columns))]
        size = np.array([float(np.std(c)) if np.ptp(c) > 0 else abs(float(c[0])) or 1.0 for c in columns])
        self.spread = size[forward.column]
        self.low, self.high = np.array([free.bounds for free in forward.searched]).T

    def best(self, count: int, seed: int) -> Estimate:
        """Return the least squares over the longest window before the horizon."""
        forward, sigma = self.forward, self._sigma0()
        windows = [w for w in WINDOWS if np.sum(forward.place <= w) >= FEW * len(self.low)] or [1.0]
        masks = [forward.place <= w * (1 + 1e-12) for w in windows]
        estimates = self._followed(masks, count, seed)
        for number, mask in enumerate(masks[1:], 2):
            starts = _apart([each.x for each in estimates])
            used = self.within(starts[0], mask, sigma)
            if np.sum(used) <= np.sum(estimates[0].used):
                break
            estimates = self._leasts(starts, used)
            self._progress(0.4 + 0.5 * number / len(masks))
        return self.settled(self.least(estimates[0].x, estimates[0].used, self._sigma0()))

    def _followed(self, masks: Sequence[NDArray[np.bool_]], count: int, seed: int) -> list[Estimate]:
        """Return the least squares over the first window from the best starts, the least first."""
        places, scores = self.starts(count, seed), []
        for k, x in enumerate(places):
            r = self.residuals(x, np.ones(len(self.stated), dtype=bool), self._sigma0())
            scores.append(np.mean([math.log(np.mean(r[mask] ** 2) + 1e-300) for mask in masks]))
            self._progress(0.4 * (k + 1) / len(places))
        starts = [places[k] for k in np.argsort(scores)[: max(FOLLOWED, count // OF_MANY)]]
        return self._leasts(starts, self.within(starts[0], masks[0], self._sigma0()))

    def _leasts(self, places: Sequence[Array], used: NDArray[np.bool_]) -> list[Estimate]:
        estimates = [self.least(x, used, self._sigma0(), within=ROUGH) for x in places]
        return sorted(estimates, key=lambda each: each.cost)

    def settled(self, estimate: Estimate) -> Estimate:
        """Return the least squares over the noise that the residuals have, where none is stated."""
        if np.any(np.isnan(self.stated[estimate.used])):
            for _ in range(3):  # noise follows residuals, and they the noise
                estimate = self.least(estimate.x, estimate.used, self._estimated(estimate))
        return estimate

    def starts(self, count: int, seed: int) -> list[Array]:
        """Return places to start from: the model's own values, and a Latin hypercube."""
        free = self.forward.searched
        return [*starts_in(free, [one.value for one in free], count, seed)]

    def _sigma0(self) -> Array:
        return np.where(np.isnan(self.stated), GUESSED * self.spread, self.stated)

    def _estimated(self, estimate: Estimate) -> Array:
        """Return the noise of each row, that of columns without a stated one from their residuals."""
        sigma, group = self._sigma0(), self.forward.group
        for k in np.unique(group):
            rows = estimate.used & (group == k)
            if np.any(rows) and np.isnan(self.stated[rows][0]):
                part = estimate.residuals[(group == k)[estimate.used]] * estimate.sigma[rows]
                free = len(part) * (1 - len(estimate.x) / max(int(np.sum(estimate.used)), len(estimate.x) + 1))
                sigma[group == k] = math.sqrt(float(part @ part) / max(free, 1e-9)) or GUESSED * self.spread[rows][0]
        return sigma

    def within(self, x: Array, mask: NDArray[np.bool_], sigma: Array) -> NDArray[np.bool_]:
        """Return the rows of a window that lie before each run's own error exceeds a part of the noise."""
        forward = self.forward
        coarse, fine = forward.at(x), forward.at(x, max(forward.tolerance / FINER, 1e-13))
        allowed = OWN * np.where(np.isnan(self.stated), GUESSED * self.spread, self.stated)
        wrong = ~(np.abs(coarse.predicted - fine.predicted) <= allowed) & np.isfinite(coarse.predicted)
        used = mask.copy()
        for i in range(len(forward.observed)):
            rows = forward.run == i
            end = np.min(coarse.times[rows & wrong], initial=np.inf)
            used &= ~rows | (np.nan_to_num(coarse.times, nan=0.0, posinf=0.0) < end)
        return used if np.sum(used) > len(x) else mask

    def residuals(self, x: Array, used: NDArray[np.bool_], sigma: Array) -> Array:
        """Return measured less predicted over the noise, of the rows used."""
        predicted = self.forward.at(x).predicted
        with np.errstate(over="ignore"):
            residuals = (self.forward.measured - predicted) / sigma
        return np.where(np.isfinite(residuals), residuals, LOST * self.spread / sigma)[used]

    def jacobian(self, x: Array, used: NDArray[np.bool_], sigma: Array) -> Array:
        """Return the derivatives of the residuals (used, x)."""
        return -(self.forward.slopes(x) / sigma[:, None])[used]

    def least(
        self, x: Array, used: NDArray[np.bool_], sigma: Array, *, fixed: int | None = None, within: float = CONVERGED
    ) -> Estimate:
        """Return the least squares from a place, one entry of x held where `fixed` says which."""
        from scipy.optimize import least_squares  # slow to import

        moving = np.array([j for j in range(len(x)) if j != fixed], dtype=int)

        def whole(part: Array) -> Array:
            placed = x.copy()
            placed[moving] = part
            return placed

        if not len(moving):
            return self._judged(x, used, sigma)
        width = self.high - self.low
        begin = np.clip(x, self.low + 1e-9 * width, self.high - 1e-9 * width)[moving]
        result = least_squares(
            lambda part: self.residuals(whole(part), used, sigma),
            begin,
            jac=lambda part: self.jacobian(whole(part), used, sigma)[:, moving],
            bounds=(self.low[moving], self.high[moving]),
            xtol=within,
            ftol=within,
            gtol=within,
            max_nfev=60,
        )
        return replace(self._judged(whole(result.x), used, sigma), converged=result.status > 0)

    def _judged(self, x: Array, used: NDArray[np.bool_], sigma: Array) -> Estimate:
        """Return residuals and their Jacobian at a place."""
        return Estimate(x, used, sigma, self.residuals(x, used, sigma), self.jacobian(x, used, sigma), True)


def _apart(places: list[Array]) -> list[Array]:
    """Return places, those alike but once."""
    distinct: list[Array] = []
    for x in places:
        if all(float(np.max(np.abs(x - other))) > ALIKE for other in distinct):
            distinct.append(x)
    return distinct


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
