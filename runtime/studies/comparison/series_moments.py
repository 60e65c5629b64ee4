"""Statistics of sampled histories and their covariance, of measured series and of runs alike.

Each is a function of a mean over intervals. Its deviation is that of `averages.estimate`, batch means over blocks long
enough that neighbours are uncorrelated; correlations between statistics are those of the means of common blocks.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.engine.solution.averages import Estimate, estimate
from hertzwerk.runtime.engine.solution.dense_output import NORMS
from hertzwerk.runtime.studies.comparison.signal_statistics import begins, excursion_level, intervals_of
from hertzwerk.runtime.system.arrays import Array

ORDERS = {"rms": 2, **NORMS}  # of means of powers
KINDS = ("mean", *ORDERS, "largest", "excursions")
OF_IMPACTS = ("mean", *ORDERS, "largest", "rate")  # kinds of numbers that come with impacts
QUANTILE = 1.96  # half the width of a 95 % interval over the standard deviation
FEWEST = 8  # samples in an interval
ROUNDED = 1 / math.sqrt(
    6
)  # deviation of a count of equal intervals at a phase by chance, on average: f (1 - f) of its part f


@dataclass(frozen=True)
class SeriesMoment:
    """Statistic of one signal.

    kind     mean, rms, norm8, norm32: over time, or over impacts; largest: mean of the largest values in an interval;
             excursions: their rate, which begin `level` from the `middle` and end below half of that, as `compare`
             counts them; rate: of impacts
    signal   place of the signal among the samples
    """

    kind: str
    signal: int
    middle: float = math.nan
    level: float = math.nan

    @classmethod
    def of(cls, kind: str, signal: int, samples: Array) -> SeriesMoment:
        """Return the statistic with the level of excursions that measured samples (n,) have."""
        return cls(kind, signal, *excursion_level(samples[np.isfinite(samples)]))

    def parts(self, x: Array, places: NDArray[np.intp], passed: NDArray[np.floating[Any]]) -> tuple[Array, Array]:
        """Return sums and weights (intervals,) whose ratio the statistic is a function of; nan are left out.

        places    intervals (n,) of the values; passed: time [s] in each interval
        """
        there, count = np.isfinite(x), len(passed)
        x, places = x[there], places[there]
        weights = np.bincount(places, minlength=count).astype(float)
        if self.kind == "largest":
            sums = np.full(count, -np.inf)
            np.maximum.at(sums, places, x)
            weights = (weights > 0).astype(float)
        elif self.kind == "rate":
            sums, weights = weights, passed
        elif self.kind == "excursions":
            sums = np.bincount(places, begins(np.abs(x - self.middle), self.level), count)
            weights = np.where(weights > 0, passed, 0.0)  # time passes where samples are missing
        else:
            sums = np.bincount(places, x if self.kind == "mean" else np.abs(x) ** ORDERS[self.kind], count)
        return np.where(weights > 0, sums, 0.0), weights

    def value(self, mean: float) -> tuple[float, float]:
        """Return the statistic of a mean, and its derivative by that."""
        if self.kind not in ORDERS or mean <= 0:
            return mean, 1.0
        order = ORDERS[self.kind]
        return mean ** (1 / order), mean ** (1 / order - 1) / order


@dataclass(frozen=True)
class SeriesStatistics:
    """Statistics (m,) of a series and their covariance (m, m), in SI.

    reasons    why a deviation is missing, by statistic; its covariance is nan
    blocks     fewest blocks that a deviation comes from
    """

    values: Array
    covariance: Array
    reasons: tuple[str, ...]
    blocks: int

    @property
    def deviations(self) -> Array:
        """Standard deviations (m,)."""
        return np.sqrt(np.diag(self.covariance))


def series_statistics(
    times: Array, samples: Array, moments: Sequence[SeriesMoment], interval: float
) -> SeriesStatistics:
    """Return statistics of samples (n, signals), nan where missing, at times (n,) in intervals [s]."""
    spacing = float(np.median(np.diff(times)))
    places, complete = intervals_of(times, interval)
    whole = max(complete, 1)
    inside = places < whole
    passed = np.bincount(places[inside], minlength=whole) * spacing
    parts = [moment.parts(samples[inside, moment.signal], places[inside], passed) for moment in moments]
    there = np.all([weights > 0 for _, weights in parts], axis=0)
    return _statistics([(sums[there], weights[there]) for sums, weights in parts], moments)


def impact_statistics(
    times: Sequence[Array], values: Sequence[Array], moments: Sequence[SeriesMoment], span: tuple[float, float],
    interval: float,
) -> SeriesStatistics:  # fmt: skip
    """Return statistics of numbers (n,) at the times (n,) [s] of impacts, by signal, within a span [s].

    A count is whole: a rate is not known better than by a fraction of an impact in all, uniform between 0 and 1, also where
    all blocks count alike.
    """
    whole = max(int((span[1] - span[0]) / interval * (1 + 1e-9)), 1)
    parts = []
    for moment in moments:
        at = (times[moment.signal] - span[0]) / interval
        inside = (at >= 0) & (at < whole)
        parts.append(moment.parts(values[moment.signal][inside], at[inside].astype(np.intp), np.full(whole, interval)))
    counted = ROUNDED / (whole * interval)
    return _statistics(parts, moments, [counted if moment.kind == "rate" else 0.0 for moment in moments])


def _statistics(
    parts: Sequence[tuple[Array, Array]], moments: Sequence[SeriesMoment], least: Sequence[float] | float = 0.0
) -> SeriesStatistics:
    """Return statistics of sums and weights; least    deviations that they have at least."""
    estimates = [
        estimate(*each) if np.any(each[1] > 0) else Estimate(math.nan, None, 0, 1, "no impacts") for each in parts
    ]
    values, slopes = np.array(
        [moment.value(each.mean) for moment, each in zip(moments, estimates, strict=True)], dtype=float
    ).T
    half = np.array([math.nan if each.half_width is None else each.half_width for each in estimates])
    deviations = np.maximum(slopes * half / QUANTILE, least)
    covariance = np.outer(deviations, deviations) * _correlation(parts, estimates)
    return SeriesStatistics(
        values, covariance, tuple(each.reason for each in estimates), min(each.blocks for each in estimates)
    )


def _correlation(parts: Sequence[tuple[Array, Array]], estimates: Sequence[Estimate]) -> Array:
    """Return the correlations of the means of blocks, as long as the longest that any statistic needs."""
    size = max(each.intervals for each in estimates)
    n = len(parts[0][0]) // size
    if n < 2:
        return np.eye(len(parts))
    means = []
    for (sums, weights), each in zip(parts, estimates, strict=True):
        above, below = (x[len(x) - n * size :].reshape(n, size).sum(axis=1) for x in (sums, weights))
        left = (above - each.mean * below) / below.mean()
        left -= left.mean()
        norm = float(np.linalg.norm(left))
        means.append(left / norm if norm > 0 else left)
    correlation: Array = np.array(means) @ np.array(means).T
    np.fill_diagonal(correlation, 1.0)
    return correlation
