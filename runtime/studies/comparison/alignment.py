"""Phase of measured data against a run: an offset, and a drift of the time base, by cross-correlation.

Standard errors come from the curvature of the least squares and the residual. The largest correlation is the least sum of
squares of measured less gain times run less level, gain and level free. Near it the residual changes by the run's slope
for an offset, by slope times elapsed time for a drift, both less what a gain or a level explains: J. The curvature is J'J,
and the variance of what noise adds to it J' R J with R the autocovariance of the residual, so that neighbouring samples
with the same error do not count as two.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.studies.comparison.residuals import autocorrelations
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.studies.comparison.filtered_run import FilteredRun


LAGS = 1000  # most that are summed

Range = tuple[float, float]
FEWEST = 16  # samples within the run, wherever in the ranges
DRIFTS = 401  # most that are tried
NEARLY = 1.5  # times the missing correlation of the best offset: another one that is as good is doubtful
PROMINENT = 0.05  # least prominence of another peak of the correlation
PAST_HORIZON = (
    "the alignment uses times beyond the horizon, where trajectories separate: it is that of the drive at best"
)
FINEST = 1e-4  # of the spacing of offsets that are tried: to which the best is refined


def standard_errors(
    filtered: FilteredRun,
    run_times: Callable[[Array], Array],
    times: Array,
    measured: Array,
    signals: Sequence[NDArray[np.intp]],
    free: tuple[bool, bool],
) -> tuple[float, float]:
    """Return the standard errors of offset [s] and drift [1]; nan where not free or not determined.

    run_times    of measured times, as aligned; measured (n, signals), of which the rows `signals` of each count.
    Noise of one signal is taken to be independent of another's, and of the run.
    """
    chosen = np.flatnonzero(free)
    curvature, spread = np.zeros((2, len(chosen), len(chosen)))
    for j, rows in enumerate(signals):
        elapsed, y = times[rows] - times[0], measured[rows, j]
        at = np.clip(run_times(times[rows]), filtered.start, filtered.end)
        before, after = (
            np.maximum(at - filtered.spacing, filtered.start),
            np.minimum(at + filtered.spacing, filtered.end),
        )
        slope = (filtered.at(after)[:, j] - filtered.at(before)[:, j]) / (after - before)
        run = filtered.at(at)[:, j]
        explained, _ = np.linalg.qr(np.column_stack([np.ones(len(rows)), run - np.mean(run)]))
        moved = np.column_stack([slope, slope * elapsed])[:, chosen]
        ways, residual = (part - explained @ (explained.T @ part) for part in (moved, y))
        size, gain = float(np.std(run)), float(np.cov(y, run)[0, 1] / np.var(run, ddof=1)) if np.std(run) > 0 else 0.0
        if not (size > 0 and gain and len(rows) > 2 + len(chosen)):
            continue
        weight = 1 / (len(rows) * size * float(np.std(y)))  # of its sum of squares in the mean of the correlations
        curvature += weight * gain * ways.T @ ways
        spread += weight**2 * _spread(ways, residual, len(chosen))
    try:
        turned = np.linalg.inv(curvature)
    except np.linalg.LinAlgError:
        return math.nan, math.nan
    variances = np.diag(turned @ spread @ turned)
    errors = np.full(2, np.nan)
    errors[chosen] = np.sqrt(np.where(variances > 0, variances, np.nan))
    return float(errors[0]), float(errors[1])


def _spread(ways: Array, residual: Array, free: int) -> Array:
    """Return the covariance of the products of a residual (n,) with ways (n, k) that it could go."""
    from scipy.signal import fftconvolve  # slow to import

    known = autocorrelations(residual)[:LAGS]
    both_ways = np.concatenate([known[::-1], [1.0], known])
    sums: Array = ways.T @ fftconvolve(ways, both_ways[:, None], mode="same", axes=0)
    variance = float(residual @ residual) / (len(residual) - 2 - free)
    return variance * sums


@dataclass(frozen=True)
class Alignment:
    """Run time of a measured time t: offset + t + drift (t - begin).

    offset, drift    [s] and 1, within their ranges; a range of one value was not searched
    begin            first measured time [s]
    correlation      mean over the signals; nan where nothing was searched
    offset_error, drift_error    standard errors [s] and 1, by the curvature of the least squares and the residual that
                     is left (see above); nan of what was not searched
    doubts           reasons not to trust what was found
    """

    offset: float
    drift: float
    begin: float
    offsets: Range
    drifts: Range
    correlation: float = math.nan
    doubts: tuple[str, ...] = ()
    offset_error: float = math.nan
    drift_error: float = math.nan

    @property
    def searched(self) -> bool:
        """Return whether there was something to find."""
        return self.offsets[0] < self.offsets[1] or self.drifts[0] < self.drifts[1]

    def __call__(self, times: Array) -> Array:
        """Return the run times [s] of measured times [s]."""
        return self.offset + times + self.drift * (times - self.begin)


def align(
    filtered: FilteredRun, times: Array, measured: Array, offsets: Range, drifts: Range, *, horizon: float = math.inf
) -> Alignment:
    """Find the offset and drift within ranges at which measured (n, signals) correlates best with a run.

    nan are missing samples. All offsets of a range are tried at once, by FFT, at so many drifts that none lies more
    than half a sample from one; the best is refined (Nelder and Mead). Only samples that lie within the run wherever
    in the ranges they are put count, so that all compare alike; those up to the horizon [s] alone where there are enough.
    Raises InputError where they are fewer than 16.
    """
    begin = float(times[0])
    stated = Alignment(offsets[0], drifts[0], begin, offsets, drifts)
    ends = [Alignment(o, d, begin, offsets, drifts)(times) for o in offsets for d in drifts]
    start = np.min(ends, axis=0) >= filtered.start

    def until(end: float) -> list[NDArray[np.intp]]:
        inside = start & (np.max(ends, axis=0) <= end)
        return [np.flatnonzero(inside & np.isfinite(column)) for column in measured.T]

    signals, lost = until(min(horizon, filtered.end)), tuple[str, ...]()
    if min(map(len, signals)) < FEWEST and horizon < filtered.end:
        signals, lost = until(filtered.end), (PAST_HORIZON,)
    fewest = min(map(len, signals))
    if fewest < FEWEST:
        actual = f"{fewest} samples that lie within the run, {filtered.start:.4g}..{filtered.end:.4g} s, at every offset of the range"
        remedy = "a longer run, narrower ranges, or an offset that places the data within it"
        raise InputError("offset", [Fault("offset, drift", actual, f"at least {FEWEST}", remedy)])
    if not stated.searched:
        return stated
    search = _Search(filtered, times - begin, measured, signals, offsets, begin)
    tried = _drifts(drifts, float(times[-1] - begin), float(np.median(np.diff(times))))
    curves = [search.curve(drift) for drift in tried]
    k = int(np.argmax([np.max(curve) for curve in curves]))
    s = int(np.argmax(curves[k]))
    offset, drift, correlation = search.refined(offsets[0] + s * filtered.spacing, tried[k], offsets, drifts)
    best = Alignment(offset, drift, begin, offsets, drifts, correlation)
    free = offsets[0] < offsets[1], drifts[0] < drifts[1]
    errors = standard_errors(filtered, best, times, measured, signals, free)
    best = replace(best, offset_error=errors[0], drift_error=errors[1])
    return replace(
        best, doubts=(*lost, *_at_ends(best, filtered.spacing), *_another(curves[k], s, offsets[0], filtered.spacing))
    )


def _drifts(drifts: Range, span: float, step: float) -> list[float]:
    """Return the drifts to try: their ends differ by at most a sample's step [s] over the span [s]."""
    count = math.ceil((drifts[1] - drifts[0]) * span / step) + 1
    if count > DRIFTS:
        actual = f"a range over which the data stretch by {count - 1:,} samples"
        raise InputError("drift", [Fault("drift", actual, f"at most {DRIFTS - 1}", "a narrower range")])
    return [float(drift) for drift in np.linspace(*drifts, count if drifts[0] < drifts[1] else 1)]


def _at_ends(alignment: Alignment, spacing: float) -> list[str]:
    """Return doubts of what lies at an end of its range."""
    span = 4 * spacing
    at = {
        "offset": (alignment.offset, alignment.offsets, span),
        "drift": (alignment.drift, alignment.drifts, (alignment.drifts[1] - alignment.drifts[0]) / 100),
    }
    return [
        f"the {name} found lies at an end of the searched range: a better one may lie outside"
        for name, (value, (low, high), near) in at.items()
        if low < high and min(value - low, high - value) < min(near, (high - low) / 100)
    ]


def _another(curve: Array, best: int, low: float, spacing: float) -> list[str]:
    """Return the doubt that another offset correlates nearly as well: a peak of its own."""
    from scipy.signal import find_peaks  # slow to import

    peaks = find_peaks(curve, prominence=PROMINENT)[0]
    peaks = peaks[np.abs(peaks - best) > 1]
    if not len(peaks):
        return []
    other = int(peaks[np.argmax(curve[peaks])])
    if 1 - curve[other] > NEARLY * (1 - curve[best]):
        return []
    where = f"an offset of {low + other * spacing:.6g} s correlates nearly as well ({curve[other]:.4f}, the best {curve[best]:.4f})"
    return [f"{where}: the phase is not certain, and a narrower range would be"]


class _Search:
    """Correlations of measured signals with a run, over offsets and drifts."""

    def __init__(
        self,
        filtered: FilteredRun,
        elapsed: Array,
        measured: Array,
        signals: list[NDArray[np.intp]],
        offsets: Range,
        begin: float,
    ) -> None:
        self._filtered, self._begin, self._low = filtered, begin, offsets[0] + begin
        self._shifts = int((offsets[1] - offsets[0]) / filtered.spacing + 1e-9)
        middle = filtered.values.mean(axis=0)
        self._run = filtered.values - middle
        counted = np.zeros(len(elapsed), dtype=bool)
        counted[np.concatenate(signals)] = True
        self._elapsed = elapsed[counted]
        whole = len(self._elapsed)
        self._among = [slice(None) if len(rows) == whole else np.cumsum(counted)[rows] - 1 for rows in signals]
        self._parts = [(elapsed[rows], measured[rows, j] - middle[j]) for j, rows in enumerate(signals)]
        self._sums = [(len(y), float(np.sum(y)), float(y @ y)) for _, y in self._parts]

    def curve(self, drift: float) -> Array:
        """Return the correlation at every offset, `spacing` apart, mean over the signals."""
        from scipy.signal import correlate  # slow to import

        curves = []
        for j, (elapsed, y) in enumerate(self._parts):
            cells = np.rint((self._low + elapsed * (1 + drift) - self._filtered.t[0]) / self._filtered.spacing).astype(
                int
            )
            cells = np.clip(cells, 0, len(self._run) - 1 - self._shifts)
            first = int(cells[0])
            run = self._run[first : int(cells[-1]) + self._shifts + 1, j]
            weights = np.bincount(cells - first).astype(float)
            sums = np.bincount(cells - first, y)
            product, mean, square = (
                correlate(a, b, mode="valid", method="fft") for a, b in ((run, sums), (run, weights), (run**2, weights))
            )
            curves.append(_correlation(product, mean, square, *self._sums[j]))
        return np.asarray(np.mean(curves, axis=0))

    def value(self, offset: float, drift: float) -> float:
        """Return the correlation at one offset and drift, at the samples' own times."""
        times = np.clip(offset + self._begin + self._elapsed * (1 + drift), self._filtered.start, self._filtered.end)
        predicted = self._filtered.at(times)
        correlations = []
        for j, (among, (_, y)) in enumerate(zip(self._among, self._parts, strict=True)):
            x = predicted[among, j] - np.mean(predicted[among, j])
            product, mean, square = (np.array([value]) for value in (x @ y, np.sum(x), x @ x))
            correlations.append(_correlation(product, mean, square, *self._sums[j])[0])
        return float(np.mean(correlations))

    def refined(self, offset: float, drift: float, offsets: Range, drifts: Range) -> tuple[float, float, float]:
        """Return the best offset and drift near given ones, and their correlation."""
        from scipy.optimize import minimize  # slow to import

        units = np.array([2 * self._filtered.spacing, max((drifts[1] - drifts[0]) / 20, 1e-300)])
        start = np.array([offset, drift])
        low, high = np.array([offsets, drifts]).T
        free = low < high

        def lacks(x: Array) -> float:
            moved = start.copy()
            moved[free] = np.clip(start[free] + x * units[free], low[free], high[free])
            return -self.value(float(moved[0]), float(moved[1]))

        size = int(np.sum(free))
        corners = np.vstack([np.zeros(size), np.eye(size)])
        how = {"initial_simplex": corners, "xatol": FINEST, "fatol": 1e-12, "maxiter": 200}
        result = minimize(lacks, np.zeros(size), method="Nelder-Mead", options=how)
        best = start.copy()
        best[free] = np.clip(start[free] + result.x * units[free], low[free], high[free])
        return float(best[0]), float(best[1]), -float(result.fun)


def _correlation(product: Array, mean: Array, square: Array, n: int, total: float, power: float) -> Array:
    """Return correlations from sums of x y, x, x^2 at every offset, and of y, y^2; 0 of a constant."""
    spread, other = n * square - mean**2, n * power - total**2
    alive = (spread > 1e-12 * n * np.max(square, initial=0.0)) & (other > 0)
    size = np.sqrt(np.where(alive, spread * other, 1.0))
    return np.where(alive, (n * product - mean * total) / size, 0.0)
