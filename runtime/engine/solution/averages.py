"""Averages of a run with 95 % confidence, valid also beyond the horizon of prediction.

A run is cut into intervals, whole periods of its drives; those of the transient are left out. Intervals are joined to
blocks until the means of successive blocks are no longer correlated, and Student's t gives the confidence of their
mean (Law, Simulation Modeling and Analysis, ch. 9.5; that more than 30 blocks gain little: Schmeiser, Operations
Research 30 (1982) 556).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import Fault, among, refuse
from hertzwerk.runtime.engine.model.binding import read_time

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.engine.solution.error_scales import Scales
    from hertzwerk.runtime.engine.solution.impacts import Impact
    from hertzwerk.runtime.engine.solution.interval_sums import Sums
    from hertzwerk.runtime.engine.solution.step_observers import Findings

CONFIDENCE = 0.95
FEWEST, MOST = 8, 30  # blocks
TRANSIENT = 0.1  # part of a run left out as transient, in whole intervals
STEADY = 1e-5  # of a mean: blocks that differ by less are steady
DOUBT = 1.645  # standard deviations: correlations above are significant, one-sided at 5 %
OF_IMPACTS = IMPACT_RATE, PEAK_FORCE = ".impact_rate", ".peak_force"  # ends of the names of averages over impacts
POWERS = {".dissipated": ".dissipated_power", ".input": ".input_power"}  # names of ledger entries and of their rates


@dataclass(frozen=True)
class Average:
    """Mean over time or over impacts, with its 95 % confidence interval mean +- half_width, in `unit`.

    blocks, block    how many blocks it comes from, and their length [s]
    reason           why half_width, or mean as well, is missing; else empty
    """

    name: str
    unit: str
    mean: float | None
    half_width: float | None
    blocks: int
    block: float
    reason: str = ""

    def __str__(self) -> str:
        if self.mean is None:
            return f"{self.name}: {self.reason}"
        if self.half_width is None:
            return f"{self.name} = {self.mean:.4g} {self.unit}; no confidence interval: {self.reason}"
        return f"{self.name} = {self.mean:.4g} +- {self.half_width:.2g} {self.unit} ({self.blocks} blocks of {self.block:.3g} s)"


@dataclass(frozen=True)
class Estimate:
    """Mean of a series and half width of its confidence interval, from `blocks` of `intervals` each."""

    mean: float
    half_width: float | None
    blocks: int
    intervals: int
    reason: str = ""


def estimate(values: np.ndarray, weights: np.ndarray | None = None, *, floor: float = 0.0) -> Estimate:
    """Estimate the mean of a series (n,), or the ratio of summed values and weights (n,).

    Blocks are equally long, at most MOST, and longer until the correlation of neighbours is within DOUBT of none; the
    remaining correlation widens the interval as in a series whose correlations fall geometrically. Blocks whose means
    differ by no more than `floor`, or STEADY, are steady: the half width is then their range, without regard to
    correlation.
    """
    if weights is None:
        weights = np.ones(len(values))
    count, size, correlation = len(values), max(1, math.ceil(len(values) / MOST)), math.nan
    while (n := count // size) >= FEWEST:
        above, below = (x[count - n * size :].reshape(n, size).sum(axis=1) for x in (values, weights))
        mean = float(above.sum() / below.sum())
        means = (above - mean * below) / below.mean()  # less the mean
        spread = float(np.ptp(means))
        if spread <= max(floor, STEADY * abs(mean)):
            return Estimate(mean, spread, n, size)
        # of independent ones it is -1/n on average
        correlation = float(means[1:] @ means[:-1] / (means @ means)) + 1 / n
        if correlation <= DOUBT / math.sqrt(n):
            positive = max(correlation, 0.0)
            return Estimate(mean, _student(n) * _spread(means) * math.sqrt((1 + positive) / (1 - positive)), n, size)
        size = max(size + 1, math.ceil(1.25 * size))
    reason = (
        f"the means of {FEWEST} blocks are still correlated ({correlation:.2f}): the motion changes slowly, or the run is too short"
        if count >= FEWEST
        else f"{count} of at least {FEWEST} intervals after the transient: simulate longer"
    )
    return Estimate(float(values.sum() / weights.sum()), None, count // size, size, reason)


def _student(n: int) -> float:
    """Return the quantile of Student's t for the mean of n values."""
    from scipy.special import stdtrit  # slow to import

    return float(stdtrit(n - 1, (1 + CONFIDENCE) / 2))


def _spread(means: np.ndarray) -> float:
    """Return the standard error of the mean."""
    return float(np.std(means, ddof=1)) / math.sqrt(len(means))


@dataclass(frozen=True)
class Run:
    """Parts of a run that averages are taken from.

    start, end    times [s] at which it began and ended
    tolerance     local, relative to `scales`
    """

    model: EngineModel
    findings: Findings
    scales: Scales
    tolerance: float
    start: float
    end: float


def averages(run: Run, *, interval: str | float | None = None, skip: str | float | None = None) -> tuple[Average, ...]:
    """Average a run: impacts and forces of every pair, then power of every effect in the ledger.

    <pair>.impact_rate      impacts per time [1/s], by their onsets
    <pair>.normal_force     normal force over time [N], flights included
    <pair>.peak_force       largest normal force of an impact [N], over the impacts
    <pair>.largest_force    largest normal force in an interval [N], over the intervals; where the scene has a period, or an interval is given
    <effect>.dissipated_power, <effect>.input_power    [W]

    interval    shortest interval, "12 ms" or seconds: by default the period of all drives and forces, or 1/240 of the run where
                there is none. A run that kept a grid, or was saved, has sums over the default interval: only multiples of it can be requested
    skip        the transient at the start, that is left out: by default a tenth of the run, in whole intervals

    Raises InputError.
    """
    return tuple(average() for average in averages_by_name(run, interval=interval, skip=skip).values())


def averages_by_name(
    run: Run, *, interval: str | float | None = None, skip: str | float | None = None
) -> dict[str, Callable[[], Average]]:
    """Return the averages of a run by name, each computed when it is called; see `averages`.

    Those OF_IMPACTS need the impacts of the run alone, the others sums. Raises InputError.
    """
    faults: list[Fault] = []
    length, skipped = (seconds(name, value, faults) for name, value in (("interval", interval), ("skip", skip)))
    if among(skip, 0):
        skipped = 0.0
    span = run.end - run.start
    if not faults and length is not None and length > span:
        faults.append(Fault("interval", f"{length:g} s", f"at most the run's {span:g} s"))
    if not faults and skipped is not None and skipped >= span:
        faults.append(Fault("skip", f"{skipped:g} s", f"less than the run's {span:g} s"))
    refuse(f"averages of {run.model.name}", faults)
    dt, count = run.findings.intervals(length, run.end)
    first = math.ceil((TRANSIENT * count if skipped is None else skipped / dt) - 1e-9)
    shows_largest = length is not None or run.findings.period is not None
    return dict(_averages(run, dt, count, partial(run.findings.sums, length), first, shows_largest=shows_largest))


def seconds(name: str, value: str | float | None, faults: list[Fault]) -> float | None:
    """Return a requested time [s]; None where there is none, or it is bad, and appended to `faults`."""
    expected = 'a positive time, such as "12 ms" or a number of seconds'
    if value is None or (name == "skip" and among(value, 0)):
        return None
    if isinstance(value, str):
        return read_time(name, value, expected, faults)
    if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value) and value > 0:
        return float(value)
    faults.append(Fault(name, repr(value), expected))
    return None


def _averages(
    run: Run, dt: float, count: int, sums: Callable[[], Sums], first: int, *, shows_largest: bool
) -> Iterator[tuple[str, Callable[[], Average]]]:
    """Yield the averages over `count` intervals dt [s], from the interval `first` on, by name."""
    model, tolerance = run.model, run.tolerance
    force, energy = float(run.scales.scene[2]), float(run.scales.scene[3])

    def average(
        name: str,
        unit: str,
        series: Callable[[], np.ndarray],
        weights: Callable[[], np.ndarray] | None = None,
        scale: float = 0.0,
    ) -> tuple[str, Callable[[], Average]]:
        def computed() -> Average:
            x, w = series()[first:], None if weights is None else weights()[first:]
            if not len(x):
                reason = f"the run is not longer than its transient and one interval, {(first + 1) * dt:.3g} s"
                return Average(name, unit, None, None, 0, dt, reason)
            if not np.all(np.isfinite(x)):
                return Average(name, unit, None, None, 0, dt, "the run holds values that are not finite")
            if w is not None and not np.any(w):
                return Average(name, unit, None, None, 0, dt, "no impact after the transient")
            estimated = estimate(x, w, floor=tolerance * scale)
            return Average(
                name,
                unit,
                estimated.mean,
                estimated.half_width,
                estimated.blocks,
                estimated.intervals * dt,
                estimated.reason,
            )

        return name, computed

    def over_impacts(pair: str, of: Callable[[Impact], float]) -> np.ndarray:
        """Return the sums of numbers of a pair's impacts, by the intervals of their onsets."""
        impacts = [impact for impact in run.findings.impacts if impact.contact == pair]
        places = np.floor((np.array([impact.t for impact in impacts]) - run.start) / dt * (1 + 1e-12)).astype(int)
        within = places < count
        return np.bincount(places[within], np.array([of(impact) for impact in impacts])[within], count)

    def rate(pair: str) -> np.ndarray:
        return over_impacts(pair, lambda _: 1.0) / dt

    def summed(part: str, column: int) -> np.ndarray:
        series: np.ndarray = getattr(sums(), part)[:, column]
        return series

    for j, pair in enumerate(model.pairs):
        hits = partial(over_impacts, pair, lambda _: 1.0)
        peaks = partial(over_impacts, pair, lambda impact: impact.peak_force)
        yield average(f"{pair}{IMPACT_RATE}", "1/s", partial(rate, pair))
        yield average(f"{pair}.normal_force", "N", partial(summed, "mean_force", j), scale=force)
        yield average(f"{pair}{PEAK_FORCE}", "N", peaks, hits, scale=force)
        if shows_largest:
            yield average(f"{pair}.largest_force", "N", partial(summed, "largest", j), scale=force)
    for i, name in enumerate(model.memory):
        for end, title in POWERS.items():
            if name.endswith(end):
                yield average(name.removesuffix(end) + title, "W", partial(summed, "power", i), scale=energy / dt)
