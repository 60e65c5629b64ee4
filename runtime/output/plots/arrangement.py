"""Layout of panels on a page from the sizes of their texts, without drawing them to measure them.

Matplotlib's constrained layout measures all artists of a figure twice, which takes longer than to draw them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.layout_engine import LayoutEngine
from matplotlib.transforms import ScaledTranslation, Transform

from hertzwerk.runtime.output.plots.plot_style import STYLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

POINT = 1 / 72  # inch
LINE = 1.2 * POINT  # height of a line of text, for each point of its size
LEGEND = 1.6 * POINT  # height of a row of a legend, likewise
DIGIT = 0.64 * POINT  # width of a digit, likewise
TICK = 8 * POINT  # a tick and its distance from its number
NUMBERS = TICK + LINE * STYLE["font.size"]  # height of those below a panel
PAD = 4 * POINT  # between neighbours, and at the edge
SIDE = 14 * POINT  # to the right of a panel: half of the number below its corner


class Arrangement(LayoutEngine):
    """Layout engine of a page: all panels of a row are equally high, and those of a column equally wide.

    Its parameters `above` and `below` are the room at the top and the bottom of the page [inch].
    """

    _adjust_compatible = False
    _colorbar_gridspec = False

    def __init__(self) -> None:
        super().__init__()
        self._rooms = {"above": 0.0, "below": 0.0}
        self._legends: dict[Axes, float] = {}

    def set(self, **rooms: float) -> None:
        """Set the room above or below all panels [inch]."""
        self._rooms |= rooms

    def legend_below(self, axis: Axes, columns: int) -> None:
        """Draw the legend of a panel below the name of its horizontal axis."""
        at, look = _under(axis, _below(axis)), {"bbox_to_anchor": (0.5, 0), "borderaxespad": 0, "ncols": columns}
        legend = axis.legend(loc="upper center", bbox_transform=at, **look)
        rows = -(-len(legend.get_texts()) // columns)
        self._legends[axis] = LEGEND * STYLE["legend.fontsize"] * rows + 3 * PAD

    def execute(self, fig: Figure) -> None:
        """Place the panels of a figure."""
        panels: list[tuple[Axes, Any]] = [(axis, axis.get_subplotspec()) for axis in fig.axes if axis.get_visible()]
        axes, cells = [axis for axis, _ in panels], [cell for _, cell in panels]
        (width, height), grid = fig.get_size_inches(), cells[0].get_gridspec()
        rooms = [(_above(axis), _below(axis) + self._legends.get(axis, 0.0)) for axis in axes]
        first, last = self._rooms["above"], height - self._rooms["below"]
        rows = _spans([cell.rowspan for cell in cells], rooms, grid.get_height_ratios(), first, last)
        for axis, (top, bottom) in zip(axes, rows, strict=True):  # a panel's height decides on its numbers
            axis.set_position((0.1, 1 - bottom / height, 0.8, (bottom - top) / height))
        rooms = [(_left(axis), SIDE) for axis in axes]
        columns = _spans([cell.colspan for cell in cells], rooms, grid.get_width_ratios(), 0.0, width)
        for axis, (top, bottom), (left, right) in zip(axes, rows, columns, strict=True):
            axis.set_position((left / width, 1 - bottom / height, (right - left) / width, (bottom - top) / height))
            axis.xaxis.set_label_coords(0.5, 0, _under(axis, NUMBERS))


def _under(axis: Any, distance: float) -> Transform:
    """Return the coordinates of a panel, from a distance [inch] below it."""
    transform: Transform = axis.transAxes + ScaledTranslation(0, -distance, axis.figure.dpi_scale_trans)
    return transform


def _above(axis: Any) -> float:
    """Return the height of the title of a panel, and of the legend between them [inch]."""
    pad = axis.titleOffsetTrans.transform((0, 0))[1] / axis.figure.dpi
    return float(pad + LINE * STYLE["axes.titlesize"])


def _below(axis: Any) -> float:
    """Return the height of the numbers and the name of the axis below a panel [inch]."""
    if not axis.axison:
        return PAD
    named = LINE * axis.xaxis.label.get_fontsize() if axis.get_xlabel() else 0.0
    return float(NUMBERS + named + PAD)


def _left(axis: Any) -> float:
    """Return the width of the numbers and the name of the axis beside a panel [inch]."""
    if not axis.axison:
        return PAD
    low, high = sorted(axis.get_ylim())
    ticks = [tick for tick in axis.yaxis.get_majorticklocs() if low <= tick <= high]
    longest = max(map(len, axis.yaxis.get_major_formatter().format_ticks(ticks)), default=0)
    named = LINE * axis.yaxis.label.get_fontsize() if axis.get_ylabel() else 0.0
    return float(PAD + TICK + DIGIT * STYLE["font.size"] * longest + named)


def _spans(
    cells: Sequence[range], rooms: Sequence[tuple[float, float]], ratios: Sequence[float], first: float, last: float
) -> list[tuple[float, float]]:
    """Return begin and end of each panel along one side of a grid [inch].

    cells: those that it covers; rooms: what it needs before and after them; ratios: of the sizes of the grid's cells.
    """
    before, after = np.zeros(len(ratios)), np.zeros(len(ratios))
    for cell, (begin, end) in zip(cells, rooms, strict=True):
        before[cell.start] = max(before[cell.start], begin)
        after[cell.stop - 1] = max(after[cell.stop - 1], end)
    sizes = (last - first - np.sum(before + after)) * np.array(ratios) / np.sum(ratios)
    begins = first + np.cumsum(before + sizes + after) - sizes - after
    return [(float(begins[cell.start]), float(begins[cell.stop - 1] + sizes[cell.stop - 1])) for cell in cells]
