"""Figures of a study's page: panels of curves, one look for each label throughout a chart."""

from __future__ import annotations

import textwrap
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

from hertzwerk.runtime.output.plots.plot_panel import LEGEND_ROOM, legend
from hertzwerk.runtime.output.plots.plot_style import CYCLE, GREY, ORANGE, STYLE, heading, plain

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.studies.paper.study_page import Axis, Chart, Curve, Panel

WIDE, HIGH = 5.4, 3.5  # inches of a panel
COLOURS = tuple(colour for colour in CYCLE if colour != ORANGE)  # which references have
DASHES = ("-", "--", ":", "-.")
CHARACTERS = 17  # of a caption, per inch
LABEL = 0.08  # inches that a character of a legend takes
FORMATS = ("png", "svg")
FEW, MANY = 3, 6  # labels of a panel, above which one legend stands below all: where all have the same, or not
PART_OF_DECADE, FEW_DECADES, MANY_DECADES = 0.7, 2.0, 6.0  # of a logarithmic axis


def save(chart: Chart, folder: Path) -> list[str]:
    """Write a chart into a folder in every format; return the names of the files."""
    names = [f"{chart.name}.{kind}" for kind in FORMATS]
    with mpl.rc_context(STYLE):
        page = figure(chart)
        for name in names:
            page.savefig(folder / name, metadata={"Date": None} if name.endswith("svg") else None)
    return names


def figure(chart: Chart) -> Figure:
    """Draw a chart."""
    columns = min(chart.columns, len(chart.panels))
    rows = -(-len(chart.panels) // columns)
    with mpl.rc_context(STYLE):
        page = Figure(figsize=(WIDE * columns, HIGH * rows + 0.8), layout="constrained")
        looks = _looks(chart)
        labels = [{curve.label for curve in panel.curves} for panel in chart.panels]
        alike = len(labels) > 1 and all(each == labels[0] for each in labels)  # one legend says it all
        shared = max(map(len, labels)) > (FEW if alike else MANY)
        for i, panel in enumerate(chart.panels):
            axis = page.add_subplot(rows, columns, i + 1)
            _draw(axis, panel, looks)
            if not shared and len(axis.get_legend_handles_labels()[1]) > 1:
                axis.set_title(plain(panel.title), pad=LEGEND_ROOM)
                legend(axis)
        heading(page, chart.title, *((chart.note,) if chart.note and not shared else ()))
        if shared:
            _legend_below(page, chart.note)
    return page


def _looks(chart: Chart) -> dict[str, dict[str, Any]]:
    """Return colour and dashes by label, in the order of their appearance."""
    labels = dict.fromkeys(
        c.label for panel in chart.panels for c in panel.curves if c.look not in ("reference", "dashed", "measured")
    )
    styles = list(product(DASHES, COLOURS))
    return {
        label: {"linestyle": styles[i % len(styles)][0], "color": styles[i % len(styles)][1]}
        for i, label in enumerate(labels)
    }


def _draw(axis: Axes, panel: Panel, looks: dict[str, dict[str, Any]]) -> None:
    for curve in panel.curves:
        _curve(axis, curve, looks.get(curve.label, {}), panel.y)
    axis.set(title=plain(panel.title), xlabel=plain(str(panel.x)), ylabel=plain(str(panel.y)))
    if panel.x.log:
        axis.set_xscale("log")
    if panel.y.log:
        axis.set_yscale("log")
    if panel.y_limits is not None:
        axis.set_ylim(*panel.y_limits)
    for ticks, limits, log in (
        (axis.xaxis, axis.get_xlim(), panel.x.log),
        (axis.yaxis, axis.get_ylim(), panel.y.log),
    ):
        if log:
            _log_ticks(ticks, limits)
    if panel.y.labels:
        axis.set_yticks(range(len(panel.y.labels)), panel.y.labels)
        axis.set_ylim(len(panel.y.labels) - 0.4, -0.6)
    for x, text in panel.marks:
        axis.axvline(x, color=GREY, linewidth=0.9, linestyle=":")
        axis.annotate(
            plain(text), (x, 1), (2, -2), xycoords=("data", "axes fraction"), textcoords="offset points", va="top",
            color=GREY, fontsize=8.5, rotation=90,
        )  # fmt: skip
    if panel.equal:
        axis.set_aspect("equal", adjustable="datalim")
        axis.locator_params(nbins=5)  # labels of one width: room is made for those of the first layout


def _log_ticks(ticks: Any, limits: tuple[float, float]) -> None:
    """Label decades; below two of them 2 and 5 times their values, too, and round values of less than one."""
    decades = float(np.log10(limits[1] / limits[0]))
    if decades < FEW_DECADES:
        ticks.set_major_locator(LogLocator(subs=(1, 2, 5)) if decades > PART_OF_DECADE else MaxNLocator(6))
    if decades < MANY_DECADES:
        ticks.set_major_formatter(FuncFormatter(lambda value, _: f"{value:,.0f}" if value >= 1e4 else f"{value:g}"))
    ticks.set_minor_formatter(NullFormatter())


def _curve(axis: Axes, curve: Curve, look: dict[str, Any], y: Axis) -> None:
    """Draw a curve; where the positions along y are names, its errors are of x."""
    label = plain(curve.label)
    if curve.look == "reference":
        axis.plot(curve.x, curve.y, color=ORANGE, linewidth=2.6, alpha=0.75, label=label)
        return
    if curve.look == "dashed":
        axis.plot(curve.x, curve.y, color=GREY, linestyle="--")
        axis.annotate(
            label, (curve.x[-1], curve.y[-1]), (0, 3), textcoords="offset points", color=GREY, fontsize=8.5,
            ha="right" if curve.x[-1] > curve.x[0] else "left",
        )  # fmt: skip
        return
    if curve.look == "measured":
        axis.plot(curve.x, curve.y, ".", color="black", markersize=2.5, label=label)
        return
    lined = curve.look != "dots"
    style = {**look, **({} if lined else {"linestyle": "none"})}
    marker = {"line": "", "dots": "o", "both": "o"}[curve.look]
    size = 2.0 if len(curve.x) > 60 else 4.0
    axis.plot(curve.x, curve.y, marker=marker, markersize=size, label=label, **style)
    if curve.half_width is None:
        return
    if y.labels:
        axis.hlines(curve.y, curve.x - curve.half_width, curve.x + curve.half_width, color=look["color"], linewidth=1.0)
        return
    low, high = np.maximum(curve.y - curve.half_width, y.least), curve.y + curve.half_width
    if lined and len(curve.x) > 1:
        axis.fill_between(curve.x, low, high, color=look["color"], alpha=0.15, linewidth=0)
    else:
        axis.vlines(curve.x, low, high, color=look["color"], linewidth=1.0)


def _legend_below(page: Figure, note: str) -> None:
    """Draw one legend of all labels below the panels, under the note."""
    handles: dict[str, Any] = {}
    for axis in page.axes:
        for handle, label in zip(*axis.get_legend_handles_labels(), strict=True):
            handles.setdefault(label, handle)
    width = LABEL * (max(map(len, handles)) + 5)
    title = plain("\n".join(textwrap.wrap(note, int(CHARACTERS * page.get_figwidth()))))
    legend = page.legend(
        list(handles.values()), list(handles), loc="outside lower left", ncols=max(1, int(page.get_figwidth() // width)),
        title=title or None, title_fontsize=9, alignment="left",
    )  # fmt: skip
    legend.get_title().set_color(GREY)
