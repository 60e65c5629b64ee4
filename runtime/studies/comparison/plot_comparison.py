"""Picture of a run beside measured data: both over time, the largest peak, the residual, the spectra."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, empty_panel, legend
from hertzwerk.runtime.output.plots.plot_style import BLUE, ORANGE, STYLE, VERMILLION, heading, plain
from hertzwerk.runtime.output.plots.unit_prefixes import Scale, scale_of
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.studies.comparison.comparison_result import Comparison, Signal

SHADE = "#f1ece4"  # beyond the horizon
CLOSE = 40  # samples around the largest measured value, each side, that its panel shows
GAP = 1.5  # samples: times farther apart are not joined
PARTS = 2000  # of a curve that is thinned, more than a panel has columns of dots


def figure(comparison: Comparison) -> Figure:
    """Draw measured data over the run, its largest peak, the residual and the spectra of each signal."""
    count = len(comparison.signals)
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM}):
        page = Figure(figsize=(13, 5.6 * count + 1.2), layout="constrained")
        rows = page.subplots(2 * count, 2, squeeze=False, width_ratios=(2, 1), height_ratios=(3, 2) * count)
        for signal, (above, below) in zip(comparison.signals, zip(rows[::2], rows[1::2], strict=True), strict=True):
            below[0].sharex(above[0])
            _signal(above, below, signal, comparison)
        name, data = comparison.solution.engine.model.name, comparison.request.measurement
        notes = (f"{label}: {text}" for label, text in list(comparison.lines())[1:])
        heading(page, f"{name} beside {Path(data.source).name or 'measured data'}", *notes)
    return page


def _signal(above: Array, below: Array, signal: Signal, comparison: Comparison) -> None:
    """Draw the four panels of a signal."""
    times, values = scale_of("s", signal.t), scale_of(signal.channel.unit, [signal.measured, signal.run])
    (whole, close), (residual, spectra) = above, below
    _both(whole, signal, times, values, np.ones(len(signal.t), dtype=bool))
    whole.set_title(plain(f"{signal.channel.column} [{values.unit}], {signal.channel.history}"))
    near = np.abs(np.arange(len(signal.t)) - int(np.argmax(np.abs(signal.measured)))) <= CLOSE
    _both(close, signal, times, values, near)
    close.set_title("around the largest measured value")
    close.set_xlabel(f"run time [{times.unit}]")
    close.locator_params(axis="x", nbins=4)  # times of many digits, as of a million samples, stand apart
    _residual(residual, signal, times)
    end = comparison.solution.engine.t_end
    if comparison.horizon < end:
        for axis in (whole, residual):
            axis.axvspan(*times([comparison.horizon, end]), color=SHADE, zorder=0, label="beyond the horizon")
    whole.set_xlim(*times(signal.t[[0, -1]]))
    _spectra(spectra, signal, comparison)
    for axis in (whole, close, residual, spectra):
        legend(axis)


def _both(axis: Axes, signal: Signal, times: Scale, values: Scale, shown: NDArray[np.bool_]) -> None:
    t = signal.t[shown]
    style = {"linewidth": 1.0, "marker": ".", "markersize": 3.5} if len(t) <= 3 * CLOSE else {"linewidth": 0.9}
    for samples, colour, label, width in (
        (signal.run, ORANGE, "run, as the instrument shows it", 2.4),
        (signal.measured, BLUE, "measured", 0.9),
    ):
        look = {"linewidth": width} if samples is signal.run else style
        axis.plot(*_broken(times(t), values(samples[shown])), color=colour, label=label, **look)


def _broken(t: Array, values: Array) -> tuple[Array, Array]:
    """Return a curve that is interrupted where samples are missing."""
    gaps = np.flatnonzero(np.diff(t) > GAP * np.median(np.diff(t))) + 1
    return _thinned(np.insert(t, gaps, np.nan), np.insert(values, gaps, np.nan))


def _thinned(t: Array, values: Array) -> tuple[Array, Array]:
    """Return the first, least, largest and last point of each of many parts of a curve: it looks the same."""
    size = len(t) // PARTS
    if size < 8:
        return t, values
    table = values[: PARTS * size].reshape(PARTS, size)  # the least of a part with a gap is the gap
    inside = np.array([np.zeros(PARTS, int), table.argmin(axis=1), table.argmax(axis=1), np.full(PARTS, size - 1)])
    rows = np.append(np.sort((inside + size * np.arange(PARTS)).T).ravel(), np.arange(PARTS * size, len(t)))
    return t[rows], values[rows]


def _residual(axis: Axes, signal: Signal, times: Scale) -> None:
    """Draw measured less run, with the stated noise."""
    residual = signal.measured - signal.run
    scale = scale_of(signal.channel.unit, residual)
    axis.plot(*_broken(times(signal.t), scale(residual)), color=VERMILLION, linewidth=0.8, label="measured less run")
    if signal.channel.noise is not None:
        for size in (-2, 2):
            label = "twice the stated noise" if size > 0 else None
            axis.axhline(
                scale(size * signal.channel.noise), color="black", linewidth=0.9, linestyle="--", label=label, zorder=3
            )
    axis.set_title(f"residual [{scale.unit}]")
    axis.set_xlabel(f"run time [{times.unit}]")


def _spectra(axis: Axes, signal: Signal, comparison: Comparison) -> None:
    spectrum = signal.spectrum
    if isinstance(spectrum, str):
        empty_panel(axis, "\n".join(textwrap.wrap(f"no spectrum: {spectrum}", 45)))
        return
    noisy = "" if signal.channel.noise is None else ", stated noise added"
    axis.semilogy(*_thinned(spectrum.frequencies / 1e3, spectrum.run), color=ORANGE, linewidth=2.4, label=f"run{noisy}")
    axis.semilogy(*_thinned(spectrum.frequencies / 1e3, spectrum.measured), color=BLUE, linewidth=0.9, label="measured")
    name = signal.channel.unit.replace("^2", "²")
    unit = f"{name}²" if name.isidentifier() else f"({name})²"
    axis.set_title(plain(f"power spectral density [{unit} s]"))
    axis.set_xlabel("frequency [kHz]")
