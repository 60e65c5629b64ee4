"""Search for the least squares: a Latin hypercube of starts, and windows that lengthen.

A start is judged by its residuals over all windows; the best few are followed on the shortest, where a trajectory is
still determined by its parameters, and from window to window, as long as the run's own error stays below the noise.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.engine.model.ranges import starts_in
from hertzwerk.runtime.studies.fitting.predictions import Forward
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
