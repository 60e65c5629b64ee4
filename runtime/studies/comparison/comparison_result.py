"""Comparison of a run with measured data, in numbers, words and JSON."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.common.units import time_text
from hertzwerk.runtime.output.tables.notebook import Sentences
from hertzwerk.runtime.studies.comparison.signal_statistics import Estimated, Statistic, by_chance

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.simulation import Solution
    from hertzwerk.runtime.studies.comparison.alignment import Alignment
    from hertzwerk.runtime.studies.comparison.comparison_request import Channel, ComparisonRequest
    from hertzwerk.runtime.studies.comparison.residuals import Residual
    from hertzwerk.runtime.studies.comparison.spectra import Spectrum
    from hertzwerk.runtime.system.arrays import Array

RARE = 0.01  # chance of so many differing statistics below which they are taken for a difference


@dataclass(frozen=True)
class Signal:
    """Measured column beside what the instrument would have shown of the run.

    t                run times [s] of the samples that lie within the run and are not missing, shape (n,)
    measured, run    there, in SI
    missing          samples without a value
    residual         within the horizon; None where no sample lies there
    spectrum         or the reason why there is none
    statistics       beyond the horizon; empty where `no_statistics` says why there are none
    """

    channel: Channel
    t: Array
    measured: Array
    run: Array
    missing: int
    residual: Residual | None
    spectrum: Spectrum | str
    statistics: tuple[Statistic, ...]
    no_statistics: str = ""

    @property
    def differing(self) -> tuple[int, int]:
        """Number of statistics that differ beyond their intervals, and of those that have intervals."""
        verdicts = [statistic.differs for statistic in self.statistics if statistic.differs is not None]
        return sum(verdicts), len(verdicts)


@dataclass(frozen=True)
class Comparison(Sentences):
    """Result of `compare`: a run beside measured data.

    horizon     time [s] up to which trajectories are compared: the run's own errors grow to 0.1 % of its scales there
    outside     measured times that lie outside the run
    warnings    what to heed before the numbers are believed
    """

    solution: Solution
    request: ComparisonRequest
    alignment: Alignment
    horizon: float
    signals: tuple[Signal, ...]
    outside: int
    warnings: tuple[str, ...]

    @property
    def differs(self) -> bool | None:
        """Return whether data and run differ by more than the stated noise, or by statistics beyond chance.

        None where neither could be judged: no noise was stated, and there are no statistics with intervals.
        """
        verdicts = [not s.residual.explained for s in self.signals if s.residual and s.residual.explained is not None]
        verdicts += [by_chance(n, k) < RARE for k, n in (signal.differing for signal in self.signals) if n]
        return any(verdicts) if verdicts else None

    def lines(self, *, statistics: bool = True) -> Iterator[tuple[str, str]]:
        """Yield what was found, as labels and sentences; each statistic too, if wanted."""
        run, request = self.solution, self.request
        data = request.measurement
        yield (
            run.engine.model.name,
            f"{time_text(run.engine.t_end)} beside {data.source or 'measured data'}, {len(data.times):,} times",
        )
        yield "instrument", str(request.instrument or "none: the run is compared unfiltered")
        yield "alignment", _alignment(self.alignment)
        for signal in self.signals:
            yield from _signal_lines(signal, self.horizon, run.engine.t_end, statistics=statistics)
        yield "verdict", _verdict(self)
        for warning in self.warnings:
            yield "warning", warning

    def plot(self) -> Figure:
        """Draw measured data over the run, the residual, and spectra, for each signal."""
        from hertzwerk.runtime.studies.comparison import plot_comparison

        return plot_comparison.figure(self)

    def csv(self) -> str:
        """Return run times with measured and run of every signal as CSV; empty where missing."""
        times = np.sort(np.concatenate([signal.t for signal in self.signals]))
        times = times[np.diff(times, prepend=-np.inf) > 0]
        columns = {"t [s]": times}
        for signal in self.signals:
            rows = np.searchsorted(times, signal.t)
            for which, values in (("measured", signal.measured), ("run", signal.run)):
                column = np.full(len(times), np.nan)
                column[rows] = values
                columns[f"{signal.channel.column} {which} [{signal.channel.unit}]"] = column
        texts = (["" if x != x else repr(x) for x in column.tolist()] for column in columns.values())
        return "\n".join([",".join(columns), *map(",".join, zip(*texts, strict=True))]) + "\n"

    def record(self) -> dict[str, Any]:
        """Return everything but the samples as plain numbers, in SI, null for missing ones."""
        data, alignment = self.request.measurement, self.alignment
        return {
            "scene": self.solution.engine.model.name,
            "outcome": self.solution.outcome.name,
            "source": data.source,
            "instrument": self.request.instrument
            and {**asdict(self.request.instrument), "text": str(self.request.instrument)},
            "alignment": {**asdict(alignment), "searched": alignment.searched},
            "horizon": self.horizon,
            "outside": self.outside,
            "differs": self.differs,
            "signals": [_signal_record(signal) for signal in self.signals],
            "warnings": list(self.warnings),
        }


def _signal_record(signal: Signal) -> dict[str, Any]:
    channel, residual, spectrum = signal.channel, signal.residual, signal.spectrum
    return {
        "column": channel.column,
        "history": channel.history,
        "unit": channel.unit,
        "samples": len(signal.t),
        "missing": signal.missing,
        "residual": residual and {**asdict(residual), "explained": residual.explained},
        "spectrum": {"reason": spectrum}
        if isinstance(spectrum, str)
        else {
            "low": float(spectrum.frequencies[0]),
            "high": float(spectrum.frequencies[-1]),
            "distance_dB": spectrum.distance,
            "coherence": spectrum.coherence,
        },
        "statistics": [{**asdict(each), "differs": each.differs} for each in signal.statistics],
        "no_statistics": signal.no_statistics,
    }


def _alignment(alignment: Alignment) -> str:
    if not alignment.searched and alignment.offset == alignment.drift == 0:
        return "none: measured times are times of the run"
    if not alignment.searched:
        return f"the measured time plus {time_text(alignment.offset)}, a drift of {alignment.drift:.3g}: as stated, without a search"
    ends = [
        f"{name} {show(value)}"
        + (f" +- {show(float(f'{error:.2g}'))} (of {show(low)} to {show(high)})" if low < high else " (given)")
        for name, value, error, (low, high), show in (
            ("offset", alignment.offset, alignment.offset_error, alignment.offsets, time_text),
            ("drift", alignment.drift, alignment.drift_error, alignment.drifts, lambda value: f"{value:.3g}"),
        )
    ]
    return f"{', '.join(ends)}, where the correlation is largest, {alignment.correlation:.4f}; +- standard errors"


def _signal_lines(signal: Signal, horizon: float, end: float, *, statistics: bool) -> Iterator[tuple[str, str]]:
    channel, residual, spectrum = signal.channel, signal.residual, signal.spectrum
    lost = f", {signal.missing:,} missing" if signal.missing else ""
    yield channel.column, f"{channel.history}: {len(signal.t):,} samples within the run{lost}"
    unit = "" if channel.unit == "1" else f" {channel.unit}"
    if residual is None:
        yield "trajectory", f"not compared: no sample lies before the horizon, t = {time_text(horizon)}"
    else:
        until = "whole run" if horizon >= end else f"until the horizon, t = {time_text(horizon)}"
        of_all = 100 * residual.rms / residual.variation if residual.variation > 0 else math.nan
        part = f" ({of_all:.2g} % of the measured variation)" if residual.variation > 0 else ""
        yield (
            "trajectory",
            f"{until}: residual rms {residual.rms:.4g}{unit}{part}, mean {residual.mean:.2g}{unit}, peak {residual.peak:.4g}{unit}; "
            f"correlation {residual.correlation:.4f}",
        )
        if residual.largest is not None and residual.noise is not None:
            yield "noise", _noise(residual, unit)
    if isinstance(spectrum, str):
        yield "spectrum", f"none: {spectrum}"
    else:
        coherent = "" if spectrum.coherence is None else f", coherence {spectrum.coherence:.3f}"
        low, high = spectrum.frequencies[[0, -1]]
        yield "spectrum", f"{low:.4g} to {high:.4g} Hz: log-spectral distance {spectrum.distance:.2f} dB{coherent}"
    if signal.no_statistics:
        yield "statistics", f"none: {signal.no_statistics}"
    reasons = {each.reason for statistic in signal.statistics for each in (statistic.measured, statistic.run)}
    if signal.statistics and "" not in reasons:
        yield "statistics", f"beyond the horizon, without confidence intervals: {'; '.join(sorted(reasons))}"
        return
    for statistic in signal.statistics if statistics else ():
        yield "statistics", _statistic(statistic)


def _noise(residual: Residual, unit: str) -> str:
    ratio = residual.rms / residual.noise if residual.noise else math.nan
    limit = f"{residual.largest:.4g}{unit}, which noise of {residual.noise:.4g}{unit} alone exceeds once in a hundred"
    if not residual.explained:
        return f"the residual is {ratio:.3g} times the stated noise, more than {limit}: the model or the measurement differs in another way"
    if residual.overstated:
        least = f"{residual.least:.4g}{unit}, which noise of {residual.noise:.4g}{unit} falls below once in a hundred"
        return f"the residual is {ratio:.2g} times the stated noise, less than {least}: the stated noise is too large, and hides differences"
    return f"the residual is {ratio:.3g} times the stated noise, within {limit}: no difference is detected"


def _statistic(statistic: Statistic) -> str:
    unit = "" if statistic.unit == "1" else f" {statistic.unit}"

    def text(estimate: Estimated) -> str:
        return f"{estimate} (no interval: {estimate.reason})" if estimate.low is None else str(estimate)

    return (
        f"{statistic.name}: measured {text(statistic.measured)}, run {text(statistic.run)}{unit}: {statistic.verdict}"
    )


def _verdict(comparison: Comparison) -> str:
    """Return a sentence that says no more than the numbers do."""
    differ, counted = (
        sum(numbers) for numbers in zip(*(signal.differing for signal in comparison.signals), strict=True)
    )
    residuals = [signal.residual for signal in comparison.signals if signal.residual is not None]
    judged = [residual for residual in residuals if residual.explained is not None]
    parts = []
    if judged:
        bad = sum(not residual.explained for residual in judged)
        parts.append(
            f"{bad} of {len(judged)} residuals are larger than the stated noise explains"
            if bad
            else "the stated noise explains every residual that was judged by it"
        )
    if len(judged) < len(residuals):
        parts.append("residuals are not judged, as the noise of the measurement is not stated (noise)")
    if counted:
        parts.append(
            f"{differ} of {counted} statistics differ beyond their 95 % intervals, {counted / 20:.2g} would by chance"
        )
    return "; ".join(parts) or "nothing could be judged"
