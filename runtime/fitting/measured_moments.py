"""Moments of a measured series, and of runs as its instrument sees them, by one function."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.faults import Fault, InputError, shown, unknown
from hertzwerk.runtime.measured.asked import Asked, read_asked
from hertzwerk.runtime.measured.measurement import Measurement
from hertzwerk.runtime.measured.seen_run import SeenRun
from hertzwerk.runtime.measured.series_moments import (
    FEWEST,
    KINDS,
    SeriesMoment,
    SeriesStatistics,
    series_statistics,
)
from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.solution.averages import TRANSIENT, seconds
from hertzwerk.runtime.solution.findings import INTERVALS
from hertzwerk.runtime.solution.history import units_of
from hertzwerk.runtime.solution.solution import Solution
from hertzwerk.runtime.start.start_values import split_values

Array = NDArray[np.float64]
SEED = 0  # of the noise that is added to runs
PER_MOMENT = 2  # least blocks for every statistic: their correlations come from these


@dataclass(frozen=True)
class MeasuredSeries:
    """Measured series that a fit takes statistics of, and how.

    data       CSV file headed `name [unit]` over time, or a `Measurement`
    map        histories by column; noise: standard deviations by column: that of the sensor, which is added to runs
    bandwidth, order, zero_phase    of the instrument that runs go through, as of `compare`
    skip       transient left out of series and runs alike, "20 ms"; by default a tenth of each
    """

    data: Measurement | str | Path
    map: Mapping[str, str] | None = None
    noise: Mapping[str, Value] | None = None
    bandwidth: str | float | None = None
    order: int = 4
    zero_phase: bool = False
    skip: str | float | None = None


@dataclass
class SeriesMoments:
    """Statistics of a measured series, and of runs.

    names, units    of the statistics (m,); interval [s] over which both are cut; skip: transient [s], None for a tenth
    """

    asked: Asked
    names: tuple[str, ...]
    units: tuple[str, ...]
    moments: tuple[SeriesMoment, ...]
    interval: float
    skip: float | None
    measured: SeriesStatistics
    _last: tuple[Solution, SeriesStatistics] | None = field(default=None, repr=False)

    @property
    def duration(self) -> float:
        """Time [s] of runs as long as the series, and what the filter needs to settle."""
        settling = 0.0 if self.asked.instrument is None else 2 * self.asked.instrument.settling
        return float(np.ptp(self.asked.measurement.times)) + settling

    def functions(self) -> dict[str, Callable[[Solution], float]]:
        """Return functions of a run for a sweep: statistics and their deviations, by the names of `columns`."""
        both: dict[str, Callable[[Solution], float]] = {}
        for k, (name, deviation) in enumerate(map(columns, self.names)):
            both[name] = partial(self._value, k)
            both[deviation] = partial(self._deviation, k)
        return both

    def _value(self, k: int, run: Solution) -> float:
        return float(self.of(run).values[k])

    def _deviation(self, k: int, run: Solution) -> float:
        return float(self.of(run).deviations[k])

    def of(self, run: Solution) -> SeriesStatistics:
        """Return the statistics of a run as the instrument sees it, at the spacing of the series."""
        last = self._last  # another thread may put its own
        if last is None or last[0] is not run:
            spacing = float(np.median(np.diff(self.asked.measurement.times)))
            seen = SeenRun(run, [c.history for c in self.asked.channels], self.asked.instrument, spacing)
            start = max(seen.start, run.t_start + _transient(self.skip, run.t_end - run.t_start))
            times: Array = start + spacing * np.arange(int((seen.end - start) / spacing), dtype=float)
            samples = seen.at(times)
            noise = np.array([channel.noise or 0.0 for channel in self.asked.channels])
            samples = samples + noise * np.random.default_rng(SEED).normal(size=samples.shape)
            last = self._last = run, series_statistics(times, samples, self.moments, self.interval)
        return last[1]


def columns(name: str) -> tuple[str, str]:
    """Return the names of a sweep's columns of a statistic and its deviation."""
    return f"measured {name}", f"measured {name}, deviation"


def _transient(skip: float | None, span: float) -> float:
    return TRANSIENT * span if skip is None else skip


def read_series(
    model: Model, names: Sequence[str], series: MeasuredSeries | None, values: object, faults: list[Fault]
) -> SeriesMoments | None:
    """Return statistics of a series by names COLUMN.KIND; bad input is appended to `faults`.

    values    that runs are made at: of them the period of all drives follows, which the series is cut by
    """
    if series is None:
        expected = "a value and its standard deviation, or a measured series to compute them from"
        faults += [Fault(name, "no value, and no measured series", expected) for name in names]
        return None
    if not names:
        faults.append(Fault("measured", "beside moments that all have values", "a moment without a value"))
    skip = 0.0 if series.skip == 0 else seconds("skip", series.skip, faults)
    try:
        asked = read_asked(
            units_of(model, None), series.data, series.map, bandwidth=series.bandwidth, order=series.order,
            zero_phase=series.zero_phase, offset=0.0, drift=0.0, noise=series.noise,
        )  # fmt: skip
    except InputError as error:
        faults += error.faults
        return None
    wrong = len(faults)
    period = _period(model, values)
    by_column = {channel.column: k for k, channel in enumerate(asked.channels)}
    split = [name.rpartition(".")[::2] for name in names]
    for name, (column, kind) in zip(names, split, strict=True):
        if column not in by_column:
            faults.append(unknown(f"{name}, column", column, by_column))
        if kind not in KINDS:
            remedy = "the largest of all grows with the length of a series" if kind in ("max", "min") else ""
            faults.append(Fault(name, shown(kind), f"one of {', '.join(KINDS)}", remedy))
        elif kind == "largest" and period is None:
            found = "a scene without a period: the largest value of what interval"
            faults.append(Fault(name, found, "another statistic, such as norm8"))
    times = asked.measurement.times
    span, spacing = float(np.ptp(times)), float(np.median(np.diff(times)))
    kept = times >= times[0] + _transient(skip, span)
    if np.sum(kept) < FEWEST * FEWEST:
        faults.append(
            Fault("measured", f"{int(np.sum(kept))} samples after the transient", f"at least {FEWEST * FEWEST}")
        )
    if len(faults) > wrong or not names:
        return None
    samples = np.column_stack([channel.samples for channel in asked.channels])[kept]
    interval = max(period or span / INTERVALS, FEWEST * spacing)
    interval = period * math.ceil(interval / period - 1e-9) if period else interval
    moments = tuple(SeriesMoment.of(kind, by_column[column], samples[:, by_column[column]]) for column, kind in split)
    statistics = series_statistics(times[kept], samples, moments, interval)
    for name, deviation, reason in zip(names, statistics.deviations, statistics.reasons, strict=True):
        if not math.isfinite(deviation):
            faults.append(Fault(name, f"no deviation: {reason}", "a longer measured series"))
        elif not deviation > 0:
            faults.append(Fault(name, "a series that repeats exactly", "one that varies", "fit the history itself"))
    if statistics.blocks < PER_MOMENT * len(names):
        found = f"{len(names)} statistics of a series with {statistics.blocks} independent blocks"
        faults.append(Fault("moments", found, f"at most {statistics.blocks // PER_MOMENT}", "a longer series"))
    units = tuple("1/s" if kind == "excursions" else asked.channels[by_column[column]].unit for column, kind in split)
    return (
        None if len(faults) > wrong else SeriesMoments(asked, tuple(names), units, moments, interval, skip, statistics)
    )


def _period(model: Model, values: object) -> float | None:
    """Return the period [s] of all drives; None without one, or where a sweep will refuse values."""
    try:
        parameters, _ = split_values(model, values if isinstance(values, Mapping) else {})
        return model.period(model.bind(parameters))
    except InputError:
        return None
