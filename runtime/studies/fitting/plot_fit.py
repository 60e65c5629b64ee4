"""Picture of a fit: measured data over the best run, and residuals over their noise."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import matplotlib.ticker
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, legend
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, ORANGE, STYLE, VERMILLION, heading, plain
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.studies.fitting.fit_result import Fit, FittedSignal

LEFT_OUT = "#b8b0a4"
MOST = 6  # signals that are drawn
FINE = 1500  # places of a run's curve
LISTED = ("fit", "verdict", "unidentified", "warning")  # labels of what is not a fitted quantity that is written below


def figure(fit: Fit) -> Figure:
    """Draw measured data over the best fit, and the residuals, for each signal; of many the first six."""
    shown = fit.signals[:MOST]
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM}):
        page = Figure(figsize=(11, 4.4 * len(shown) + 1.6), layout="constrained")
        rows = page.subplots(2 * len(shown), 1, squeeze=False, height_ratios=(3, 1.6) * len(shown))
        for signal, (above,), (below,) in zip(shown, rows[::2], rows[1::2], strict=True):
            below.sharex(above)
            _signal(above, signal, fit)
            _residuals(below, signal)
        model = fit.observed[0].model.name
        names = ", ".join(each.name for each in fit.observed)
        notes = [
            f"{label}: {text}"
            for label, text in fit.lines()
            if label in LISTED or label in fit.values or label in fit.nuisance
        ]
        if len(shown) < len(fit.signals):
            notes.append(f"{len(fit.signals) - len(shown)} signals more are not drawn")
        heading(page, f"{model} fitted to {names}", *notes)
    return page


def _signal(axis: Axes, signal: FittedSignal, fit: Fit) -> None:
    """Draw measured values over those of the best fit."""
    along = scale_of("1" if signal.by_impacts else "s", signal.at)
    values = scale_of(signal.channel.unit, [signal.measured, signal.predicted])
    if signal.by_impacts:
        axis.plot(
            along(signal.at),
            values(signal.predicted),
            color=ORANGE,
            marker="_",
            markersize=16,
            markeredgewidth=2.4,
            linestyle="",
            label="best fit",
        )
    else:
        fine, curve = _curve(signal, fit)
        axis.plot(along(fine), values(curve), color=ORANGE, linewidth=2.2, label="best fit")
    for used, colour, label in ((True, BLUE, "measured"), (False, LEFT_OUT, "measured, left out")):
        rows = signal.used == used
        if np.any(rows):
            axis.plot(
                along(signal.at[rows]),
                values(signal.measured[rows]),
                color=colour,
                marker=".",
                markersize=4.5,
                linestyle="",
                label=label,
            )
    many = f"{signal.run}: " if len(fit.observed) > 1 else ""
    axis.set_title(plain(f"{many}{signal.channel.column} [{values.unit}], {signal.channel.history}"))
    axis.tick_params(labelbottom=False)
    legend(axis)


def _curve(signal: FittedSignal, fit: Fit) -> tuple[np.ndarray, np.ndarray]:
    """Return the best fit over measured time [s], between the samples too where its run is there."""
    number = [each.name for each in fit.observed].index(signal.run)
    if len(fit.solutions) != len(fit.observed) or signal.channel.column in {
        name.removeprefix("gain of ") for name in fit.nuisance
    }:
        order = np.argsort(signal.at)
        return signal.at[order], signal.predicted[order]
    run = fit.solutions[number]
    moved = fit.offsets[number]
    fine = np.unique(np.concatenate([np.linspace(signal.at.min(), signal.at.max(), FINE), signal.at]))
    fine = fine[(fine + moved >= run.engine.t_start) & (fine + moved <= run.engine.t_end)]
    return fine, run.at(fine + moved)[signal.channel.history]


def _residuals(axis: Axes, signal: FittedSignal) -> None:
    """Draw measured less best fit over the noise."""
    along = scale_of("1" if signal.by_impacts else "s", signal.at)
    over = (signal.measured - signal.predicted) / signal.sigma
    for used, colour in ((True, VERMILLION), (False, LEFT_OUT)):
        rows = signal.used == used
        axis.plot(along(signal.at[rows]), over[rows], color=colour, marker=".", markersize=4, linestyle="")
    for size in (-2, 2):
        axis.axhline(size, color=GREY, linewidth=0.9, linestyle="--")
    axis.axhline(0, color=GREY, linewidth=0.9)
    inside = over[signal.used & np.isfinite(over)]
    reach = max(3.5, 1.15 * float(np.max(np.abs(inside), initial=0.0)))
    axis.set_ylim(-reach, reach)
    noise = "stated" if signal.stated else "estimated"
    axis.set_title(f"residual over the {noise} noise, and twice the noise")
    axis.set_xlabel("number of the impact" if signal.by_impacts else f"measured time [{along.unit}]")
    if signal.by_impacts:
        axis.xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
