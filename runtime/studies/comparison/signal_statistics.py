"""Statistics of a measured signal and a run's with 95 % confidence, valid where trajectories part."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.engine.solution.averages import CONFIDENCE, estimate
from hertzwerk.runtime.system.arrays import Array

QUANTILES = (0.05, 0.5, 0.95)
LEVEL = 0.95  # quantile of the measured deviations from the median at which an excursion begins; it ends below half


@dataclass(frozen=True)
class Estimated:
    """Value with its 95 % confidence interval low..high, None where `reason` says why there is none."""

    value: float
    low: float | None = None
    high: float | None = None
    reason: str = ""

    def __str__(self) -> str:
        interval = "" if self.low is None or self.high is None else f" ({self.low:.4g} to {self.high:.4g})"
        return f"{self.value:.4g}{interval}"


@dataclass(frozen=True)
class Statistic:
    """Statistic of a measured signal and of the run's, over the same times."""

    name: str
    unit: str
    measured: Estimated
    run: Estimated

    @property
    def differs(self) -> bool | None:
        """Return whether they differ by more than their intervals allow; None without intervals.

        Of independent estimates with the same expectation, one in twenty does.
        """
        below, above = sorted((self.measured, self.run), key=lambda each: each.value)
        if below.high is None or above.low is None:
            return None
        return above.value - below.value > math.hypot(below.high - below.value, above.value - above.low)

    @property
    def verdict(self) -> str:
        """Say whether they differ."""
        return {None: "cannot be distinguished", True: "differ", False: "no difference seen"}[self.differs]


def by_chance(count: int, differing: int) -> float:
    """Return the chance that so many or more of independent statistics differ without a reason."""
    from scipy.special import bdtrc  # slow to import

    return float(bdtrc(differing - 1, count, 1 - CONFIDENCE)) if differing else 1.0


def statistics_of(times: Array, measured: Array, run: Array, unit: str, interval: float) -> tuple[Statistic, ...]:
    """Compare mean, rms, quantiles and rate of excursions over times (n,) [s], in whole intervals [s].

    An excursion begins where the signal is farther from the measured median than 95 % of the measured samples are,
    and ends below half of that: impacts, as the instrument shows them.
    """
    places, whole = intervals_of(times, interval)
    inside = places < whole if whole else np.ones(len(times), dtype=bool)
    middle, level = excursion_level(measured[inside])
    statistics = [
        dict(_statistics(times[inside], signal[inside], places[inside], middle, level)) for signal in (measured, run)
    ]
    units = {"excursions": "1/s"}
    return tuple(
        Statistic(name, units.get(name, unit), value, statistics[1][name]) for name, value in statistics[0].items()
    )


def intervals_of(times: Array, interval: float) -> tuple[NDArray[np.intp], int]:
    """Return the intervals (n,) that times (n,) lie in, and how many are whole; all in [s]."""
    lasts = float(times[-1] - times[0] + np.median(np.diff(times)))
    return ((times - times[0]) / interval * (1 + 1e-12)).astype(np.intp), int(lasts / interval * (1 + 1e-9))


def excursion_level(measured: Array) -> tuple[float, float]:
    """Return the median of samples (n,), and how far from it an excursion begins."""
    middle = float(np.median(measured))
    return middle, float(np.quantile(np.abs(measured - middle), LEVEL))


def _statistics(
    times: Array, x: Array, places: NDArray[np.intp], middle: float, level: float
) -> Iterator[tuple[str, Estimated]]:
    counts = np.bincount(places).astype(float)
    present = counts > 0

    def mean_of(values: Array, weights: Array = counts) -> tuple[float, float | None, str]:
        mean = estimate(np.bincount(places, values, len(counts))[present], weights[present])
        return mean.mean, mean.half_width, mean.reason

    yield "mean", _around(*mean_of(x))
    square, half, reason = mean_of(x * x)
    low, high = (None, None) if half is None else (math.sqrt(max(square - half, 0.0)), math.sqrt(square + half))
    yield "rms", Estimated(math.sqrt(square), low, high, reason)
    for q in QUANTILES:
        value = float(np.quantile(x, q))
        _, half, reason = mean_of((x <= value).astype(float))
        low, high = (None, None) if half is None else map(float, np.quantile(x, np.clip((q - half, q + half), 0, 1)))
        yield f"{q:.0%} quantile", Estimated(value, low, high, reason)
    passed = counts * float(np.median(np.diff(times)))
    yield "excursions", _around(*mean_of(begins(np.abs(x - middle), level), passed))


def _around(value: float, half: float | None, reason: str) -> Estimated:
    return Estimated(value, reason=reason) if half is None else Estimated(value, value - half, value + half)


def begins(sizes: Array, level: float) -> Array:
    """Return 1 where a size rises above a level for the first time since it was below half of it, else 0."""
    state = np.where(sizes >= level, 1, np.where(sizes < level / 2, 0, -1))
    known = np.flatnonzero(state >= 0)
    last = np.searchsorted(known, np.arange(len(state)), side="right") - 1
    up = np.where(last >= 0, state[known[np.maximum(last, 0)]], 0) if len(known) else np.zeros(len(state))
    return np.asarray(np.diff(up, prepend=up[:1]) > 0, dtype=float)
