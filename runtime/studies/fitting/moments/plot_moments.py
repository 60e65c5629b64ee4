"""Picture of a fit of moments: statistics, fitted and measured, and the objective along each quantity."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, labelled, legend
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, ORANGE, STYLE, VERMILLION, heading, plain
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of
from hertzwerk.runtime.studies.comparison.series_moments import QUANTILE
from hertzwerk.runtime.studies.fitting.intervals import LEVEL

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.studies.fitting.moments.moment_fit import Moment, MomentFit

REACH = 3.0  # times the interval's rise that is shown


def figure(fit: MomentFit) -> Figure:
    """Draw statistics, less the measured ones over their deviations, and the objective along quantities."""
    rows = math.ceil(len(fit.values) / 2)
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM}):
        height = 0.42 * len(fit.moments) + 1.4
        page = Figure(figsize=(11, height + 3.2 * rows + 1.4), layout="constrained")
        above, below = page.subfigures(2, 1, squeeze=False, height_ratios=(height, 3.2 * rows)).ravel()
        _statistics(above.subplots(), fit.moments)
        panels = below.subplots(rows, min(2, len(fit.values)), squeeze=False).ravel()
        for axis, name in zip(panels, fit.values, strict=False):
            _objective(axis, fit, name)
        for axis in panels[len(fit.values) :]:
            axis.set_visible(False)
        values = (f"{value.name} = {value}" for value in fit.values.values())
        heading(page, f"{fit.scene} fitted to statistics", *values, fit.verdict, *fit.unidentified, *fit.warnings)
    return page


def _statistics(axis: Axes, moments: tuple[Moment, ...]) -> None:
    """Draw measured and fitted values with 95 % intervals, less the measured ones, over their deviations."""
    rows = np.arange(len(moments))
    sizes = np.array([moment.deviation for moment in moments])
    fitted = np.array([moment.fitted - moment.value for moment in moments]) / sizes
    own = QUANTILE * np.array([moment.fitted_deviation for moment in moments]) / sizes
    look: dict[str, Any] = {"linestyle": "", "marker": "o", "markersize": 5.5, "capsize": 4, "linewidth": 1.8}
    axis.errorbar(0 * rows, rows - 0.12, xerr=QUANTILE, color=BLUE, label="measured, 95 %", **look)
    axis.errorbar(fitted, rows + 0.12, xerr=own, color=ORANGE, label="fitted, 95 % of runs and regression", **look)
    axis.axvline(0, color=GREY, linewidth=0.9)
    labels = []
    for moment in moments:
        scale = scale_of(moment.unit or "1", [moment.value, moment.fitted])
        unit = "" if scale.unit == "1" else f" {scale.unit}"
        labels.append(
            f"{moment.name}\n{float(scale(moment.value)):.4g}{unit}, fitted {float(scale(moment.fitted)):.4g}{unit}"
        )
    axis.set_yticks(rows, [plain(label) for label in labels], fontsize=8.5)
    axis.set_ylim(len(moments) - 0.5, -0.5)
    reach = 1.1 * max(3.0, float(np.max(np.abs(fitted) + own)))
    axis.set_xlim(-reach, reach)
    axis.set_xlabel("less the measured value, in its standard deviations")
    axis.set_title("statistics")
    legend(axis)


def _objective(axis: Axes, fit: MomentFit, name: str) -> None:
    """Draw how the objective rises along a quantity, all else fitted anew, and where its interval ends."""
    value, profile, rise = fit.values[name], fit.profiles[name], QUANTILE**2
    scale = scale_of(value.unit, profile.places)
    shown = profile.rises <= REACH * rise
    axis.plot(scale(profile.places), profile.rises, color=VERMILLION, linewidth=2)
    if not value.interval.how.startswith("none"):
        axis.axvspan(
            float(scale(value.interval.low)), float(scale(value.interval.high)), color=BLUE, alpha=0.12, linewidth=0
        )
    axis.axvline(float(scale(value.value)), color=BLUE, linewidth=1.4)
    axis.axhline(rise, color=GREY, linewidth=0.9, linestyle="--")
    axis.set_ylim(0, max(rise * 1.3, float(np.max(profile.rises[shown], initial=0.0)) * 1.05))
    ends = scale(profile.places[shown])
    axis.set_xlim(float(np.min(ends)), float(np.max(ends)))
    if value.log:
        axis.set_xscale("log")
    axis.set_xlabel(plain(labelled(name, scale)))
    axis.set_title(f"rise of the objective, and {rise:.2f} of a {LEVEL:.0%} interval")
