"""Picture of a work-precision study: error against time for every method, and errors along the run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from hertzwerk.runtime.analysis.work_precision.accuracy_report import conclusions, length, seconds, warnings
from hertzwerk.runtime.analysis.work_precision.timed_runs import LATE
from hertzwerk.runtime.analysis.work_precision.work_precision_study import Row, Study
from hertzwerk.runtime.engine.accuracy.error_estimate import VALID
from hertzwerk.runtime.engine.accuracy.horizon import crossing
from hertzwerk.runtime.engine.integration.tableaux.methods import AUTOMATIC, EXPLICIT, IMPLICIT
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, STYLE, VERMILLION, heading
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes


LOOKS = {
    **dict(zip(EXPLICIT, ((SKY, "s"), (BLUE, "o")), strict=False)),
    **dict(zip(IMPLICIT, ((ORANGE, "^"), (GREEN, "D")), strict=False)),
    **dict(zip(AUTOMATIC, (("black", "x"),), strict=False)),
}
OTHER = (PURPLE, "v")  # of other methods
SHADE = "#ececec"
LEAST = 1e-16  # departures are drawn down to this
MAIN: dict[str, Any] = {"linewidth": 1.5, "markersize": 4.5}
BESIDE: dict[str, Any] = {"linewidth": 0.9, "markersize": 3, "linestyle": (0, (4, 2)), "alpha": 0.65}
LATER: dict[str, Any] = {"marker": ">", "markersize": 8, "markerfacecolor": "none", "linestyle": "none"}
RING: dict[str, Any] = {
    "marker": "o",
    "markersize": 11,
    "markerfacecolor": "none",
    "color": VERMILLION,
    "linestyle": "none",
}


def figure(study: Study) -> Figure:
    """Draw the picture."""
    with mpl.rc_context({**STYLE, "axes.titlepad": 40}):
        page = Figure(figsize=(13, 6.6), layout="constrained")
        left, right = page.subplots(1, 2, width_ratios=(1.1, 1))
        _work(left, study)
        _along(right, study)
        title = f"{study.problem.model.name}: cost of accuracy in {seconds(float(study.reference.t[-1]))}"
        heading(page, title, *conclusions(study), *(f"Warning: {text}" for text in warnings(study)))
    return page


def _work(axis: Axes, study: Study) -> None:
    """Draw the largest error of the run over time: a line per method, as C and in the virtual machine.

    Errors too small to be measured lie on the floor.
    """
    handles, floor = [], study.reference.uncertainty
    for method in study.methods:
        colour, marker = LOOKS.get(method, OTHER)
        handles.append(Line2D([], [], color=colour, marker=marker, markersize=4.5, linewidth=1.5, label=method))
        for compiled in {False, study.compiled}:
            rows = study.of(method, compiled=compiled)
            points = _points(rows, floor)
            look: dict[str, Any] = MAIN if compiled == study.compiled else BESIDE
            axis.plot(points[:, 0] * 1e3, points[:, 1], color=colour, marker=marker, **look)
            late = [row for row in rows if row.outcome in LATE and row.time]
            axis.plot([(r.time or 0) * 1e3 for r in late], [r.accuracy for r in late], color=colour, **LATER)
    taken = _points(_taken(study), floor)
    if len(taken):
        axis.plot(taken[:, 0] * 1e3, taken[:, 1], zorder=1.8, **RING)
        handles.append(Line2D([], [], label="taken by auto", **RING))
    if study.compiled:
        handles.append(Line2D([], [], color=GREY, label="as C", **MAIN))
        handles.append(Line2D([], [], color=GREY, label="in the virtual machine", **BESIDE))
    if any(row.outcome in LATE for row in study.rows):
        handles.append(Line2D([], [], color=GREY, label="takes longer", **LATER))
    axis.set(xscale="log", yscale="log", xlabel="time of the whole call [ms]")
    axis.set_ylim(floor / 10, max(100 * floor, axis.get_ylim()[1]))
    axis.axhspan(floor / 10, floor, color=SHADE, zorder=0.6, linewidth=0)
    axis.axhline(floor, color=GREY, linewidth=0.8, zorder=0.7)
    one, other = study.reference.run.settings.method, study.reference.partner.settings.method
    axis.text(
        0.5, floor / 3.2, f"floor: {one} and {other}, the reference, differ by {floor:.0e}",
        transform=axis.get_yaxis_transform(), ha="center", va="center", fontsize=8.5, color=GREY,
    )  # fmt: skip
    _decades(axis)
    axis.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.set_title("Largest error of the run, in the scene's scales")
    _legend(axis, handles, 5)


def _points(rows: Sequence[Row], floor: float) -> np.ndarray:
    """Return time [s] and error of rows that have both, shape (n, 2)."""
    return np.array([(r.time, max(r.error, floor)) for r in rows if r.error is not None and r.time]).reshape(-1, 2)


def _taken(study: Study) -> list[Row]:
    """Return the runs of the method that `auto` uses most of the time, at each accuracy."""
    methods = {accuracy: max(share, key=lambda name: share[name]) for accuracy, share in study.taken.items()}
    return [row for accuracy, method in methods.items() for row in study.of(method) if row.accuracy == accuracy]


def _along(axis: Axes, study: Study) -> None:
    """Draw the departure along the run of the recommended method, by accuracy."""
    held = study.reference
    method = study.recommended or study.methods[0]
    scale = scale_of("s", held.t[-1])
    runs = {accuracy: path for (name, accuracy), (_, path) in study.along.items() if name == method}
    colours = mpl.colormaps["viridis"](np.linspace(0.92, 0.0, max(len(runs), 2)))
    handles = []
    for (accuracy, path), colour in zip(runs.items(), colours, strict=False):
        shown = np.where(path > LEAST, path, np.nan)
        axis.plot(scale(held.t), shown, color=colour, linewidth=1.1)
        handles.append(Line2D([], [], color=colour, linewidth=2, label=f"{accuracy:.0e}"))
        left = crossing(held.t, path)
        if np.isfinite(left):
            axis.plot(
                scale(left), VALID, "o", color=colour, markersize=5, markeredgecolor="white", zorder=3, clip_on=False
            )
    axis.set(yscale="log", xlabel=f"time [{scale.unit}]", xlim=scale(held.t[[0, -1]]))
    floor = np.maximum(held.floor_of_departure, LEAST)
    low = float(np.median(floor)) / 30
    axis.set_ylim(bottom=low, top=max(0.1, axis.get_ylim()[1]))
    axis.fill_between(scale(held.t), low, np.maximum(floor, low), color=SHADE, zorder=0.6, linewidth=0)
    axis.axhline(VALID, color=VERMILLION, linewidth=1, linestyle=(0, (5, 3)))
    axis.annotate(
        length(study),
        (0.01, VALID),
        (0, 3),
        xycoords=("axes fraction", "data"),
        textcoords="offset points",
        fontsize=8.5,
        color=VERMILLION,
    )
    _decades(axis)
    axis.set_title(f"Departure along the run, {method}, by requested accuracy", pad=26)
    _legend(axis, handles, 7)


def _decades(axis: Axes) -> None:
    """Draw a line for each decade of errors, and no numbers between them."""
    axis.yaxis.set_major_locator(LogLocator(numticks=20))
    axis.yaxis.set_minor_formatter(NullFormatter())


def _legend(axis: Axes, handles: list[Line2D], columns: int) -> None:
    axis.legend(
        handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns,
        borderaxespad=0.2, borderpad=0.1, handlelength=1.5, columnspacing=0.9, labelspacing=0.3,
    )  # fmt: skip
