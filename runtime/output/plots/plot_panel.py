"""Common elements of panels: caption, labelled curves in a suitable unit, time axis, legend."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from itertools import cycle, product
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np

from hertzwerk.runtime.engine.solution.step_warnings import headline
from hertzwerk.runtime.output.plots.arrangement import LINE, PAD
from hertzwerk.runtime.output.plots.curves import Curves
from hertzwerk.runtime.output.plots.plot_style import CYCLE, GREY, ORANGE, VERMILLION, plain
from hertzwerk.runtime.output.plots.title import differences, title_of, write_title
from hertzwerk.runtime.output.plots.unit_prefixes import Scale, scale_of
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from hertzwerk.runtime.engine.solution.solution import EngineSolution

NOTE = 9  # points, of the text below the panels
LEGEND_ROOM = 22  # points between a panel and its title
LEGEND_ROW = 13  # points that a further row of the legend takes
LEGEND_WIDTH, LEGEND_HANDLE = 66, 6  # characters beside each other above a panel; what the line before a label takes
MANY, NAMED = 12, 6  # curves of a panel that are told apart by colour and dash; of more, those that are named
RESTS = 1e-2  # of the curves: less motion of the ideal mechanism is not what a unit is chosen by
CONSTANT = 1e-12  # relative: less change than this is rounding, and not drawn


def caption(figure: Figure, run: EngineSolution, subtitle: str, notes: Sequence[str] = ()) -> None:
    """Write title and differences from the scene; below the panels outcome, findings and notes."""
    width, height = figure.get_size_inches()
    used = write_title(figure, title_of(run.engine.model, subtitle), differences(run))
    remarks = [] if run.outcome.finished else [f"{run.outcome.name}: {run.outcome.message}"]
    remarks += [*(headline(warning) for warning in run.warnings), *notes]  # unchecked laws among them
    rows = [line for note in remarks for line in textwrap.wrap(note, int(12 * width))]
    if rows:
        look: Any = {"ha": "left", "va": "bottom", "fontsize": NOTE, "color": VERMILLION}
        figure.text(0.01, PAD / height, plain("\n".join(rows)), **look)
    layout: Any = figure.get_layout_engine()
    layout.set(above=used, below=2 * PAD + LINE * NOTE * len(rows))


def lines(
    axis: Axes,
    curves: Curves,
    unit: str,
    values: Mapping[str, Array],
    ideal: Sequence[Array] = (),
    *,
    size: float = 0.0,
) -> Scale:
    """Draw labelled histories in a common unit over those of the ideal mechanism; return the unit.

    size: scale of the quantity, SI; curves that change by less than 1e-12 of it, or of themselves, are flat and said
    to be constant.
    """
    time = curves.time(curves.t)
    largest = [
        max((float(np.nanmax(np.abs(x), initial=0.0)) for x in some), default=0.0) for some in (ideal, values.values())
    ]
    scale = scale_of(unit, largest[0] if largest[0] > RESTS * largest[1] else largest[1])
    for history in ideal:
        axis.plot(time, scale(history), color=ORANGE, linewidth=2.6, alpha=0.75, label="ideal mechanism")
    marker = "" if len(time) > 1 else "o"  # of a run without a step there is one point
    looks = _looks(len(values))
    named = {*np.linspace(0, len(values) - 1, NAMED).round().astype(int)} if len(values) > MANY else None
    for i, ((style, colour), (label, history)) in enumerate(zip(looks, values.items(), strict=False)):
        shown = label if named is None or i in named else "_"
        axis.plot(time, scale(history), color=colour, linestyle=style, marker=marker, label=shown)
    _flatten(axis, scale, [*values.values(), *ideal], size)
    return scale


def _looks(count: int) -> Any:
    """Return line styles and colours of curves: different ones, of very many those of a colour map."""
    if count > MANY:
        return (("-", mpl.colormaps["viridis"](i / count)) for i in range(count))
    return cycle(product(("-", "--", ":"), CYCLE))  # when the colours have run out, dashed


def _flatten(axis: Axes, scale: Scale, histories: Sequence[Array], size: float) -> None:
    """Set the limits of a panel whose curves all are constant but for rounding, and say that they are."""
    largest = max([size, *(float(np.nanmax(np.abs(history), initial=0.0)) for history in histories)])
    if not histories or not all(np.ptp(history) <= CONSTANT * largest for history in histories):  # nan is not constant
        return
    low, high = (float(pick(histories)) / scale.factor for pick in (np.min, np.max))
    far = max(abs(low), abs(high))
    reach = 0.1 * far if far > CONSTANT * largest / scale.factor else size / scale.factor or 1.0  # rounding is zero
    axis.set_ylim(low - reach, high + reach)
    text = f"constant to {CONSTANT:g}" if len(histories[0]) > 1 else ""
    axis.text(0.99, 0.95, text, transform=axis.transAxes, ha="right", va="top", color=GREY)


def panel(
    axis: Axes,
    curves: Curves,
    title: str,
    unit: str,
    values: Mapping[str, Array],
    ideal: Sequence[Array] = (),
    *,
    size: float = 0.0,
    from_zero: bool = False,
    remark: str = "",
) -> Scale:
    """Draw labelled histories over time, as `lines`, under a title with their unit; return the unit."""
    scale = lines(axis, curves, unit, values, ideal, size=size)
    if from_zero:
        axis.set_ylim(bottom=0)
    over_time(axis, curves, f"{labelled(title, scale)}{remark}")
    return scale


def labelled(text: str, scale: Scale) -> str:
    """Return a text with a unit; that of a plain number is not written."""
    return text if scale.unit == "1" else f"{text} [{scale.unit}]"


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
