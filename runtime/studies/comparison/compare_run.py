"""Comparison of a run with measured data, seen through the instrument and aligned.

1. request     columns against histories, instrument, ranges                                comparison_request
2. run         integrated between its steps and filtered as the instrument does             filtered_run
3. alignment   offset and drift of the measured time                                        alignment
4. comparison  trajectories within the horizon, statistics beyond                           residuals, spectra, signal_statistics
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any, cast

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.accuracy.error_estimate import VALID, horizon
from hertzwerk.runtime.engine.inputs.input_values import Input
from hertzwerk.runtime.engine.inputs.measurement_csv import MeasuredTable, Measurement
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.run.run_request import Accuracy, Compiled
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.simulation import Solution, simulate
from hertzwerk.runtime.studies.comparison.alignment import Alignment, align
from hertzwerk.runtime.studies.comparison.comparison_request import (
    Between,
    Channel,
    ComparisonRequest,
    read_comparison_request,
)
from hertzwerk.runtime.studies.comparison.comparison_result import Comparison, Signal
from hertzwerk.runtime.studies.comparison.filtered_run import FilteredRun
from hertzwerk.runtime.studies.comparison.residuals import residual_of
from hertzwerk.runtime.studies.comparison.signal_statistics import Statistic, statistics_of
from hertzwerk.runtime.studies.comparison.spectra import series_of, spectrum_of
from hertzwerk.runtime.system.arrays import Array


def compare(
    target: Solution | Target,
    data: Measurement | MeasuredTable,
    *,
    map: Mapping[str, str] | None = None,
    bandwidth: str | float | None = None,
    order: int = 4,
    zero_phase: bool = False,
    offset: Between = 0.0,
    drift: Between = 0.0,
    noise: Mapping[str, Value] | None = None,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    duration: str | float | None = None,
    accuracy: Accuracy | None = None,
    tolerance: float | None = None,
    method: str | None = None,
    compiled: Compiled | None = None,
    progress: Callable[[float], object] | None = None,
) -> Comparison:
    """Compare a run with measured data: a `Measurement`, or a table as `read_measurement` reads it.

    target      a run; or a scene or a Model, which is run as long as the data last, or for a `duration`, as `simulate` does with
                `parameters`, `initial`, `inputs`, `accuracy`, `tolerance`, `method`, `compiled`, `progress`
    map         histories of the run by measured column, {"acceleration": "guide.acceleration"}; by default equal names
    bandwidth   cut-off frequency of the instrument, "5 kHz" or [Hz]: the run goes through a Butterworth low-pass of this `order`, causal
                (3 dB down there), or with zero_phase forwards and backwards (6 dB); None: the run is compared as it is
    offset      run time less measured time: a value, or the range in which the best is searched, "-2..2 ms"; (low, high) in s
    drift       part by which the run takes longer than the measured clock says: a value or a range, "-1e-4..1e-4"
    noise       standard deviations of the measurement's noise by column, {"acceleration": "5 m/s^2"}: what a residual is judged by

    Trajectories are compared while the run's own numerical error (`run.error`) is within 0.1 % of its scales, statistics beyond it.
    Raises InputError with every fault: lines of the file, units, names, ranges; a run that did not keep its steps.
    """
    of_run = {
        **{"parameters": parameters, "initial": initial, "inputs": inputs, "duration": duration},
        **{"accuracy": accuracy, "tolerance": tolerance, "method": method, "compiled": compiled, "progress": progress},
    }
    settings: dict[str, Any] = {name: value for name, value in of_run.items() if value is not None}
    run = target if isinstance(target, Solution) else None
    if run is not None and settings:
        raise InputError("compare", [Fault(", ".join(settings), "values beside a run", "none: it has its own")])
    model = run.engine.model if run is not None else engine_model(cast("Target", target))
    request = read_comparison_request(
        units_of(model, None) if run is None else run.units,
        data,
        map,
        bandwidth=bandwidth,
        order=order,
        zero_phase=zero_phase,
        offset=offset,
        drift=drift,
        noise=noise,
    )
    return match(run or simulate(model, **{"duration": request.lasts, **settings}), request)


INTERVALS = 240  # of the times beyond the horizon, where the run has no period
OWN = VALID / 10  # of the scales: largest error of the run itself where a residual is judged
FEWEST = 16  # samples of a window that is compared
PER_SAMPLE = 4  # cells of an unfiltered run in a measured step
SEED = 0  # of the noise added to the run before statistics


def match(run: Solution, request: ComparisonRequest) -> Comparison:
    """Compare a run with what was read; raises InputError for a run too short, or without its steps."""
    if not run.engine.history.steps:
        actual, expected = "a saved run, or one that kept a grid", "a run that kept its steps, grid=None"
        raise InputError("comparison with measured data", [Fault("run", actual, expected)])
    times = request.measurement.times
    spacing = float(np.median(np.diff(times))) / PER_SAMPLE
    filtered = FilteredRun(run, [channel.history for channel in request.channels], request.instrument, spacing)
    samples = np.column_stack([channel.samples for channel in request.channels])
    known = horizon_of(run)
    alignment = align(filtered, times, samples, request.offsets, request.drifts, horizon=known)
    at = alignment(times)
    inside = (at >= filtered.start) & (at <= filtered.end)
    shown = filtered.at(at[inside])
    signals = tuple(
        _signal(channel, at[inside], samples[inside, k], shown[:, k], request, known, run.engine.findings.period)
        for k, channel in enumerate(request.channels)
    )
    outside = int(np.sum(~inside))
    return Comparison(
        run, request, alignment, known, signals, outside, tuple(_warnings(run, request, alignment, outside))
    )


def horizon_of(run: Solution) -> float:
    """Return the time [s] up to which trajectories are compared; a run's end where nothing is known.

    Its own error stays within a tenth of what a valid trajectory may have, so as not to be taken for a difference.
    """
    if run.error is None:
        return run.engine.t_end
    sooner = horizon(run.error.times, run.error.values, OWN)
    return float(min(t for t in (sooner, run.error.horizon, run.engine.t_end) if t is not None))


def _signal(
    channel: Channel,
    at: Array,
    samples: Array,
    run: Array,
    request: ComparisonRequest,
    horizon: float,
    period: float | None,
) -> Signal:
    there = np.isfinite(samples)
    t, measured, run = at[there], samples[there], run[there]
    within = t <= horizon
    beyond = ~within
    residual = (
        residual_of(t[within], measured[within], run[within], channel.noise) if np.sum(within) >= FEWEST else None
    )
    cut_off = math.inf if request.instrument is None else request.instrument.cut_off
    series = series_of(t, measured, run)
    spectrum = (
        series
        if isinstance(series, str)
        else spectrum_of(series, cut_off, coherent=bool(np.all(within)), noise=channel.noise)
    )
    statistics: tuple[Statistic, ...] = ()
    why = ""
    if np.sum(beyond) < FEWEST:
        why = "the trajectory is valid throughout" if not np.any(beyond) else "too few samples beyond the horizon"
    else:
        interval = period or float(np.ptp(t[beyond])) / INTERVALS
        noisy = run[beyond]
        if channel.noise is not None:  # what the instrument adds belongs to its rms, quantiles and excursions
            noisy = noisy + np.random.default_rng(SEED).normal(0, channel.noise, len(noisy))
        statistics = statistics_of(t[beyond], measured[beyond], noisy, channel.unit, interval)
    return Signal(channel, t, measured, run, int(np.sum(~there)), residual, spectrum, statistics, why)


def _warnings(run: Solution, request: ComparisonRequest, alignment: Alignment, outside: int) -> Iterator[str]:
    """Yield what to heed before the numbers are believed."""
    step = float(np.median(np.diff(request.measurement.times)))
    if not run.outcome.finished:
        yield f"{run.outcome.name}: {run.outcome.message}"
    if run.error is None:
        yield "the horizon is not known, as the run was made at a tolerance: beyond it a residual does not test the model"
    if request.instrument is not None and request.instrument.cut_off > 0.5 / step:
        yield (
            f"the cut-off lies above half the sampling rate, {0.5 / step:.4g} Hz: higher frequencies that the instrument passes "
            "are aliased in the data, not in the run"
        )
    if request.instrument is None:
        durations = [impact.duration for impact in run.impacts if impact.duration is not None]
        if durations and min(durations) < 4 * step:
            yield (
                f"no bandwidth is stated, and impacts as short as {min(durations):.3g} s meet samples {step:.3g} s apart: "
                "peaks then compare by chance"
            )
    if outside:
        yield (
            f"{outside:,} of {len(request.measurement.times):,} measured times lie outside the run, or before its filter has settled, "
            "and are omitted"
        )
    if request.measurement.jumps:
        yield f"{request.measurement.jumps:,} times are repeated in the file: they are read as jumps, of which the later line counts"
    yield from alignment.doubts
    yield from run.warnings
