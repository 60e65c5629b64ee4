"""Common elements of panels: caption, labelled curves in a suitable unit, time axis, legend."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from itertools import cycle, product
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.pictures.curves import Array, Curves, Scale, scale_of
from hertzwerk.runtime.pictures.plot_style import CYCLE, GREY, ORANGE, VERMILLION, plain

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from hertzwerk.runtime.solution.solution import Solution

LEGEND_ROOM = 22  # points between a panel and its title
LEGEND_ROW = 13  # points that a further row of the legend takes
LEGEND_WIDTH, LEGEND_HANDLE = 66, 6  # characters beside each other above a panel; what the line before a label takes


def caption(figure: Figure, run: Solution, subtitle: str, note: str = "") -> None:
    """Write the title, and below the panels the outcome, warnings and notes."""
    figure.suptitle(f"{run.model.name}: {subtitle}", x=0.01, ha="left", fontsize=12.5, fontweight="bold")
    notes = [] if run.outcome.finished else [f"{run.outcome.name}: {run.outcome.message}"]
    notes += run.warnings  # unchecked laws among them
    notes += [note] if note else []
    if notes:
        text = "\n".join(line for note in notes for line in textwrap.wrap(note, 150))
        figure.supxlabel(plain(text), x=0.01, ha="left", fontsize=9, color=VERMILLION)


def lines(axis: Axes, curves: Curves, unit: str, values: Mapping[str, Array], ideal: Sequence[Array] = ()) -> Scale:
    """Draw labelled histories in a common unit over those of the ideal mechanism; return the unit."""
    time = curves.time(curves.t)
    scale = scale_of(unit, list(ideal) or list(values.values()))
    for history in ideal:
        axis.plot(time, scale(history), color=ORANGE, linewidth=2.6, alpha=0.75, label="ideal mechanism")
    looks = product(("-", "--", ":"), CYCLE)  # when the colours have run out, dashed
    marker = "" if len(time) > 1 else "o"  # of a run without a step there is one point
    for (style, colour), (label, history) in zip(cycle(looks), values.items(), strict=False):
        axis.plot(time, scale(history), color=colour, linestyle=style, marker=marker, label=label)
    return scale


def over_time(axis: Axes, curves: Curves, title: str) -> None:
    """Set title, legend and time axis of a panel."""
    axis.set_title(title)
    axis.set_xlabel(f"time [{curves.time.unit}]")
    if curves.t[-1] > curves.t[0]:
        axis.set_xlim(*curves.time(curves.t[[0, -1]]))
    legend(axis)


def legend(axis: Axes) -> None:
    """Draw a legend between title and panel, in as many rows as needed; none for a single curve."""
    handles, labels = axis.get_legend_handles_labels()
    unique = dict(zip(labels, handles, strict=True))
    if len(unique) > 1:
        widths = [len(label) + LEGEND_HANDLE for label in unique]
        fitting = (n for n in range(len(widths), 1, -1) if _wide(widths, n) <= LEGEND_WIDTH)
        columns = next(fitting, 1)
        rows = -(-len(widths) // columns)
        if rows > 1:
            axis.set_title(axis.get_title("left"), pad=LEGEND_ROOM + (rows - 1) * LEGEND_ROW)
        axis.legend(
            unique.values(), unique.keys(), loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns,
            borderaxespad=0.2, borderpad=0.1, handlelength=1.4, columnspacing=1.1, labelspacing=0.25,
        )  # fmt: skip


def _wide(widths: Sequence[int], columns: int) -> int:
    """Return the width in characters of a legend in so many columns, filled one after the other."""
    return sum(int(np.max(column)) for column in np.array_split(widths, columns))


def empty_panel(axis: Axes, text: str) -> None:
    """Write a text in place of a panel."""
    axis.set_axis_off()
    axis.text(0.5, 0.5, plain(text), transform=axis.transAxes, ha="center", color=GREY)
