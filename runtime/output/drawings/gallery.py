"""Sheet of several mechanisms, each with a title: the built-in scenes at a glance, the modes of one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import matplotlib as mpl
from matplotlib.figure import Figure

from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.places import Places
from hertzwerk.runtime.output.plots.plot_style import STYLE, plain

COLUMNS = 4
CELL = (3.5, 2.9)  # inches, of which
TITLE = 0.28  # is the name's
MARGIN = 17.0  # points
SYMBOLS = 0.72  # size of symbols, against a page of their own
DPI = 92


def sheet(
    mechanisms: Sequence[Places],
    titles: Sequence[str] | None = None,
    *,
    faint: tuple[int, ...] | None = None,
    columns: int = COLUMNS,
) -> Figure:
    """Draw a page with a cell for each mechanism.

    titles: in place of their names; faint: instants of the faint positions, in place of those that show most.
    """
    columns = min(columns, len(mechanisms))
    rows = -(-len(mechanisms) // columns)
    width, height = columns * CELL[0], rows * CELL[1]
    panel = CELL[0] - 0.1, CELL[1] - TITLE - 0.05
    with mpl.rc_context({**STYLE, "axes.grid": False}):
        page = Figure(figsize=(width, height), dpi=DPI)
        for k, places in enumerate(mechanisms):
            left, top = k % columns * CELL[0], height - k // columns * CELL[1]
            title = places.model.name if titles is None else titles[k]
            page.text(
                (left + 0.1) / width, (top - 0.05) / height, plain(title), va="top", fontsize=11, fontweight="bold"
            )
            axis = page.add_axes(((left + 0.05) / width, (top - CELL[1]) / height, panel[0] / width, panel[1] / height))
            drawing = Drawing.of(places, panel, least=panel, margin=MARGIN)
            drawing = drawing if faint is None else replace(drawing, ghosts=faint)
            drawing.on(axis, size=7.5, symbols=SYMBOLS, times=False)
            axis.set_axis_off()
    return page
