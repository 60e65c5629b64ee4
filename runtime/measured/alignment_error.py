"""Standard errors of an alignment, from the curvature of the least squares and the residual.

The largest correlation is the least sum of squares of measured less gain times run less level, gain and level free. Near
it the residual changes by the run's slope for an offset, by slope times elapsed time for a drift, both less what a gain
or a level explains: J. The curvature is J'J, and the variance of what noise adds to it J' R J with R the
autocovariance of the residual, so that neighbouring samples with the same error do not count as two.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.measured.residuals import autocorrelations

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from hertzwerk.runtime.measured.seen_run import SeenRun

Array = NDArray[np.float64]

LAGS = 1000  # most that are summed


def standard_errors(
    seen: SeenRun,
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
        at = np.clip(run_times(times[rows]), seen.start, seen.end)
        before, after = np.maximum(at - seen.spacing, seen.start), np.minimum(at + seen.spacing, seen.end)
        slope = (seen.at(after)[:, j] - seen.at(before)[:, j]) / (after - before)
        run = seen.at(at)[:, j]
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
    sums = ways.T @ ways
    for lag, correlation in enumerate(autocorrelations(residual)[:LAGS], 1):
        products = ways[:-lag].T @ ways[lag:]
        sums += correlation * (products + products.T)
    variance = float(residual @ residual) / (len(residual) - 2 - free)
    return variance * sums
