"""Layout of panels on a page from the sizes of their texts, which are not drawn to be measured.

Matplotlib's constrained layout measures all artists of a figure twice, which takes longer than drawing them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.layout_engine import LayoutEngine
from matplotlib.transforms import ScaledTranslation, Transform

from hertzwerk.runtime.pictures.plot_style import STYLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

POINT = 1 / 72  # inch
LINE = 1.3 * POINT  # height of a line of text, for each point of its size
LEGEND = 1.6 * POINT  # height of a row of a legend, likewise
DIGIT = 0.64  # width of a digit, of the size of its text
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
        self.set(above=0.0, below=0.0)
        self._legends: dict[Axes, float] = {}

    def set(self, **rooms: float) -> None:
        """Set the room above or below all panels [inch]."""
        self._params.update(rooms)

    def execute(self, fig: Figure) -> None:
        """Place the panels of a figure."""
        axes = [axis for axis in fig.axes if axis.get_subplotspec() is not None and axis.get_visible()]
        if not axes:
            return
        (width, height), cells = fig.get_size_inches(), [axis.get_subplotspec() for axis in axes]
        grid = cells[0].get_gridspec()
        above, below = self._params["above"], self._params["below"]
        rooms = [(_above(axis), _below(axis) + self._legends.get(axis, 0.0)) for axis in axes]
        rows = _spans([cell.rowspan for cell in cells], rooms, grid.get_height_ratios(), above, height - below)
        for axis, (top, bottom) in zip(axes, rows, strict=True):  # a panel's height decides on its numbers
            axis.set_position((0.1, 1 - bottom / height, 0.8, (bottom - top) / height))
        rooms = [(_left(axis), SIDE) for axis in axes]
        columns = _spans([cell.colspan for cell in cells], rooms, grid.get_width_ratios(), 0.0, width)
        for axis, (top, bottom), (left, right) in zip(axes, rows, columns, strict=True):
            axis.set_position((left / width, 1 - bottom / height, (right - left) / width, (bottom - top) / height))
            axis.xaxis.set_label_coords(0.5, 0, _under(axis, NUMBERS))

    def legend_below(self, axis: Axes, columns: int) -> None:
        """Draw the legend of a panel below the name of its horizontal axis."""
        at = axis.transAxes + ScaledTranslation(0, -_below(axis), axis.get_figure(root=True).dpi_scale_trans)
        legend = axis.legend(
            loc="upper center", bbox_to_anchor=(0.5, 0), bbox_transform=at, borderaxespad=0, ncols=columns
        )
        rows = -(-len(legend.get_texts()) // columns)
        self._legends[axis] = LEGEND * STYLE["legend.fontsize"] * rows + 2 * PAD


def _above(axis: Axes) -> float:
    """Return the height of the title of a panel, and of the legend between them [inch]."""
    pad = axis.titleOffsetTrans.transform((0, 0))[1] / axis.get_figure(root=True).dpi
    return float(pad + LINE * STYLE["axes.titlesize"])


def _below(axis: Axes) -> float:
    """Return the height of the numbers and the name of the axis below a panel [inch]."""
    if not axis.axison:
        return PAD
    named = LINE * axis.xaxis.label.get_fontsize() if axis.get_xlabel() else 0.0
    return float(NUMBERS + named + PAD)


def _under(axis: Axes, distance: float) -> Transform:
    """Return the coordinates of a panel, from a distance [inch] below it."""
    return axis.transAxes + ScaledTranslation(0, -distance, axis.get_figure(root=True).dpi_scale_trans)


def _left(axis: Axes) -> float:
    """Return the width of the numbers and the name of the axis beside a panel [inch]."""
    if not axis.axison:
        return PAD
    low, high = sorted(axis.get_ylim())
    ticks = [tick for tick in axis.yaxis.get_majorticklocs() if low <= tick <= high]
    longest = max(map(len, axis.yaxis.get_major_formatter().format_ticks(ticks)), default=0)
    named = LINE * axis.yaxis.label.get_fontsize() if axis.get_ylabel() else 0.0
    return PAD + TICK + DIGIT * POINT * STYLE["font.size"] * longest + named


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
