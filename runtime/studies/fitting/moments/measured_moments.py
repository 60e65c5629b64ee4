"""Moments of measured series and impacts, and of runs as their instruments see them, by one function."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TypeAlias

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, among, noted, shown, unknown
from hertzwerk.runtime.engine.inputs.measurement_csv import MeasuredImpacts, MeasuredTable, Measurement
from hertzwerk.runtime.engine.model.binding import Value, named_values
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.averages import TRANSIENT, seconds
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.engine.solution.step_observers import INTERVALS
from hertzwerk.runtime.engine.start.start_values import split_values
from hertzwerk.runtime.studies.comparison.comparison_request import (
    Channel,
    ComparisonRequest,
    read_channels,
    read_comparison_request,
)
from hertzwerk.runtime.studies.comparison.filtered_run import FilteredRun
from hertzwerk.runtime.studies.comparison.series_moments import (
    FEWEST,
    KINDS,
    OF_IMPACTS,
    SeriesMoment,
    SeriesStatistics,
    impact_statistics,
    series_statistics,
)
from hertzwerk.runtime.studies.fitting.experiment import (
    impact_units,
    mapped_columns,
    of_impacts,
    onsets,
    parts_of,
    read_table,
)
from hertzwerk.runtime.system.arrays import Array

SEED = 0  # of the noise that is added to runs
PER_MOMENT = 2  # least blocks for every statistic: their correlations come from these
RATES = "excursions", "rate"  # kinds whose unit is 1/s


@dataclass(frozen=True)
class MeasuredSeries:
    """Measured series or impacts, and the statistics that `fit_moments` compares.

    data       table over time or with a column `impact [1]`, as `read_measurement` reads it; a `Measurement` or `MeasuredImpacts`
    map        histories by column; of impacts numbers of them, {"t": "floor.impacts.t", "speed": "floor.impacts.speed"}
    noise      standard deviations by column: that of the sensor, which is added to runs
    bandwidth, order, zero_phase    of the instrument that runs go through, as of `compare`; not of impacts
    skip       transient left out of series and runs alike, "20 ms"; by default a tenth of each
    parameters that it was measured at, initial states too, beside those of the fit
    """

    data: Measurement | MeasuredImpacts | MeasuredTable
    map: Mapping[str, str] | None = None
    noise: Mapping[str, Value] | None = None
    bandwidth: str | float | None = None
    order: int = 4
    zero_phase: bool = False
    skip: str | float | None = None
    parameters: Mapping[str, Value] = field(default_factory=dict)


class _OverTime:
    """Samples over time, and runs as the instrument sees them at the same spacing.

    times    (n,) [s] of the measured rows, increasing; channels: what is measured; kinds: of statistics that there are
    least    shortest interval [s] that statistics are cut by; lasts: time [s] of runs as long
    """

    kinds = KINDS

    def __init__(self, request: ComparisonRequest) -> None:
        self._request, self.times, self.channels = request, request.measurement.times, request.channels
        self._spacing = float(np.median(np.diff(self.times)))
        self.least = FEWEST * self._spacing
        settling = 0.0 if request.instrument is None else 2 * request.instrument.settling
        self.lasts = float(np.ptp(self.times)) + settling

    def measured(self, moments: Sequence[SeriesMoment], start: float, interval: float) -> SeriesStatistics:
        settled = self.times >= start
        samples = np.column_stack([channel.samples for channel in self.channels])[settled]
        return series_statistics(self.times[settled], samples, moments, interval)

    def of(
        self, run: EngineSolution, moments: Sequence[SeriesMoment], skip: float | None, interval: float
    ) -> SeriesStatistics:
        filtered = FilteredRun(run, [c.history for c in self.channels], self._request.instrument, self._spacing)
        start = max(filtered.start, run.engine.t_start + _transient(skip, run.engine.t_end - run.engine.t_start))
        times: Array = start + self._spacing * np.arange(int((filtered.end - start) / self._spacing), dtype=float)
        samples = _noisy(filtered.at(times), self.channels)
        return series_statistics(times, samples, moments, interval)


class _OfImpacts:
    """List of impacts with their onsets, and all impacts of runs."""

    kinds, least = OF_IMPACTS, 0.0

    def __init__(self, times: Array, channels: tuple[Channel, ...]) -> None:
        self.times, self.channels = times, channels
        self.lasts = float(times[-1])

    def measured(self, moments: Sequence[SeriesMoment], start: float, interval: float) -> SeriesStatistics:
        samples = [channel.samples for channel in self.channels]
        return impact_statistics(
            [self.times] * len(samples), samples, moments, (start, float(self.times[-1])), interval
        )

    def of(
        self, run: EngineSolution, moments: Sequence[SeriesMoment], skip: float | None, interval: float
    ) -> SeriesStatistics:
        times = [onsets(run, channel.history) for channel in self.channels]
        values = [_noisy(of_impacts(run, channel.history)[:, None], (channel,))[:, 0] for channel in self.channels]
        span = run.engine.t_start + _transient(skip, run.engine.t_end - run.engine.t_start), run.engine.t_end
        return impact_statistics(times, values, moments, span, interval)


Sight: TypeAlias = _OverTime | _OfImpacts


def _noisy(samples: Array, channels: Sequence[Channel]) -> Array:
    """Return samples (n, channels) with the noise of their sensors."""
    noise = np.array([channel.noise or 0.0 for channel in channels])
    return samples + noise * np.random.default_rng(SEED).normal(size=samples.shape)


@dataclass
class SeriesMoments:
    """Statistics of one measured series, and of runs.

    names, units    of the statistics (m,); interval [s] over which both are cut; skip: transient [s], None for a tenth
    values    that the runs beside it are made at
    """

    sight: Sight
    names: tuple[str, ...]
    units: tuple[str, ...]
    moments: tuple[SeriesMoment, ...]
    interval: float
    skip: float | None
    values: Mapping[str, Value]
    measured: SeriesStatistics
    _last: tuple[EngineSolution, SeriesStatistics] | None = field(default=None, repr=False)

    def functions(self) -> dict[str, Callable[[EngineSolution], float]]:
        """Return functions of a run for a sweep: statistics and their deviations, by the names of `columns`."""
        both: dict[str, Callable[[EngineSolution], float]] = {}
        for k, (name, deviation) in enumerate(map(columns, self.names)):
            both[name] = partial(self._value, k)
            both[deviation] = partial(self._deviation, k)
        return both

    def _value(self, k: int, run: EngineSolution) -> float:
        return float(self._of(run).values[k])

    def _deviation(self, k: int, run: EngineSolution) -> float:
        return float(self._of(run).deviations[k])

    def _of(self, run: EngineSolution) -> SeriesStatistics:
        last = self._last  # another thread may put its own
        if last is None or last[0] is not run:
            last = self._last = run, self.sight.of(run, self.moments, self.skip, self.interval)
        return last[1]


def columns(name: str) -> tuple[str, str]:
    """Return the names of a sweep's columns of a statistic and its deviation."""
    return f"measured {name}", f"measured {name}, deviation"


def _transient(skip: float | None, span: float) -> float:
    return TRANSIENT * span if skip is None else skip


def read_series(
    model: EngineModel, names: Sequence[str], series: Sequence[MeasuredSeries], values: object, faults: list[Fault]
) -> tuple[SeriesMoments, ...]:
    """Return statistics of each series by names COLUMN.KIND; bad input is appended to `faults`.

    A statistic is taken of every series that has its column: of several it is named "x.rms of NAME".
    values    that runs are made at: of them the period of all drives follows, which a series is cut by
    """
    if not series:
        expected = "a value and its standard deviation, or a measured series to compute them from"
        faults += [Fault(name, "no value, and no measured series", expected) for name in names]
        return ()
    if not names:
        faults.append(Fault("measured", "beside moments that all have values", "a moment without a value"))
    wrong = len(faults)
    sights = [_sight(model, one, faults) for one in series]
    parameters = [named_values("parameters", one.parameters, faults) for one in series]
    skips = [0.0 if among(one.skip, 0) else seconds("skip", one.skip, faults) for one in series]
    if len(faults) > wrong or not names:
        return ()
    read = [sight for sight in sights if sight is not None]
    own = [{channel.column for channel in sight.channels} for sight in read]
    column = {name: name.rpartition(".")[0] for name in names}
    there = sorted(set().union(*own))
    faults += [unknown(f"{name}, column", column[name], there) for name in names if column[name] not in there]
    moments = []
    for number, (one, sight, own_columns, skip, its) in enumerate(
        zip(series, read, own, skips, parameters, strict=True), 1
    ):
        source = one.data if isinstance(one.data, str | Path) else getattr(one.data, "source", "")
        of = f" of {Path(source).stem or f'series {number}'}"
        measured = [name for name in names if column[name] in own_columns]
        labels = [name + of * (sum(column[name] in other for other in own) > 1) for name in measured]
        made_at = {**(values if isinstance(values, Mapping) else {}), **its}
        made = _moments(model, measured, labels, sight, skip, made_at, faults) if measured else None
        if made is not None:
            moments.append(made)
    return tuple(moments) if len(faults) == wrong else ()


def _sight(model: EngineModel, series: MeasuredSeries, faults: list[Fault]) -> Sight | None:
    """Return a measured table beside what it is of; bad input is appended to `faults`."""
    if not isinstance(series.map, Mapping | None):
        faults.append(Fault("map", shown(series.map), 'histories by column, such as {"force": "floor.normal_force"}'))
        return None
    table = read_table(series.data, series.map, faults)
    sizes = named_values("noise", {} if series.noise is None else series.noise, faults)
    if table is None:
        return None
    by_impacts = isinstance(table, MeasuredImpacts)
    mapped = mapped_columns(table, series.map, by_impacts)
    others = set(series.map or {}) - set(mapped or {})  # of the other kind: noise may be that of several tables
    noise = {name: size for name, size in sizes.items() if name not in others}
    if isinstance(table, MeasuredImpacts):
        if series.bandwidth is not None:
            faults.append(Fault("bandwidth", "beside a list of impacts", "none: a run's impacts are not filtered"))
        return _impacts(read_channels(impact_units(model), table, mapped, noise, faults), faults)
    with noted(faults):
        return _OverTime(
            read_comparison_request(
                units_of(model, None), table, mapped, bandwidth=series.bandwidth, order=series.order,
                zero_phase=series.zero_phase, offset=0.0, drift=0.0, noise=noise,
            )
        )  # fmt: skip
    return None


def _impacts(channels: tuple[Channel, ...], faults: list[Fault]) -> _OfImpacts | None:
    times = [channel.samples for channel in channels if parts_of(channel.history)[1] == "t"]
    if len(times) != 1 or not np.all(np.isfinite(times[0])) or np.any(np.diff(times[0]) < 0):
        actual = f"{len(times)} columns of onsets" if len(times) != 1 else "onsets that are missing or fall"
        remedy = 'map one to "impacts.t", or to that of a pair'
        faults.append(Fault("measured", actual, "the time of every impact, increasing", remedy))
        return None
    return _OfImpacts(times[0], channels)


def _moments(
    model: EngineModel,
    names: Sequence[str],
    labels: Sequence[str],
    sight: Sight,
    skip: float | None,
    values: Mapping[str, Value],
    faults: list[Fault],
) -> SeriesMoments | None:
    """Return the statistics of one series; bad input is appended to `faults`."""
    wrong = len(faults)
    period = _period(model, values)
    by_column = {channel.column: k for k, channel in enumerate(sight.channels)}
    split = [name.rpartition(".")[::2] for name in names]
    faults += _kind_faults(split, labels, sight.kinds, period)
    times = sight.times
    span = float(np.ptp(times))
    start = float(times[0]) + _transient(skip, span)
    count = int(np.sum(times >= start))
    if count < FEWEST * FEWEST:
        faults.append(Fault("measured", f"{count} samples after the transient", f"at least {FEWEST * FEWEST}"))
    if len(faults) > wrong:
        return None
    interval = max(period or span / INTERVALS, sight.least)
    interval = period * math.ceil(interval / period - 1e-9) if period else interval
    moments = tuple(
        SeriesMoment.of(kind, by_column[column], sight.channels[by_column[column]].samples[times >= start])
        for column, kind in split
    )
    statistics = sight.measured(moments, start, interval)
    for label, deviation, reason in zip(labels, statistics.deviations, statistics.reasons, strict=True):
        if not math.isfinite(deviation):
            faults.append(Fault(label, f"no deviation: {reason}", "a longer measured series"))
        elif not deviation > 0:
            faults.append(Fault(label, "a series that repeats exactly", "one that varies", "fit the history itself"))
    if statistics.blocks < PER_MOMENT * len(names):
        actual = f"{len(names)} statistics of a series with {statistics.blocks} independent blocks"
        faults.append(Fault("moments", actual, f"at most {statistics.blocks // PER_MOMENT}", "a longer series"))
    units = tuple("1/s" if kind in RATES else sight.channels[by_column[column]].unit for column, kind in split)
    if len(faults) > wrong:
        return None
    return SeriesMoments(sight, tuple(labels), units, moments, interval, skip, values, statistics)


def _kind_faults(
    split: Sequence[tuple[str, str]], labels: Sequence[str], kinds: Sequence[str], period: float | None
) -> Iterator[Fault]:
    for (_, kind), label in zip(split, labels, strict=True):
        if kind not in kinds:
            remedy = "the largest of all grows with the length of a series" if kind in ("max", "min") else ""
            yield Fault(label, shown(kind), f"one of {', '.join(kinds)}", remedy)
        elif kind == "largest" and period is None:
            actual = "a scene without a period: the largest value of what interval"
            yield Fault(label, actual, "another statistic, such as norm8")


def _period(model: EngineModel, values: object) -> float | None:
    """Return the period [s] of all drives; None without one, or where a sweep will refuse values."""
    try:
        parameters, _ = split_values(model, values if isinstance(values, Mapping) else {})
        return model.period(model.bind(parameters))
    except InputError:
        return None
