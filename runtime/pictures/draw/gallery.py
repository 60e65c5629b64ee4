"""Sheet of several mechanisms, each with its name: the built-in scenes at a glance."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib as mpl
from matplotlib.figure import Figure

from hertzwerk.runtime.pictures.draw.drawing import Drawing
from hertzwerk.runtime.pictures.draw.places import Places
from hertzwerk.runtime.pictures.plot_style import STYLE

COLUMNS = 4
CELL = (3.5, 2.9)  # inches, of which
TITLE = 0.28  # is the name's
MARGIN = 17.0  # points
SYMBOLS = 0.72  # size of symbols, against a page of their own
DPI = 92


def sheet(mechanisms: Sequence[Places]) -> Figure:
    """Draw a page with a cell for each mechanism."""
    columns = min(COLUMNS, len(mechanisms))
    rows = -(-len(mechanisms) // columns)
    width, height = columns * CELL[0], rows * CELL[1]
    panel = CELL[0] - 0.1, CELL[1] - TITLE - 0.05
    with mpl.rc_context({**STYLE, "axes.grid": False}):
        page = Figure(figsize=(width, height), dpi=DPI)
        for k, places in enumerate(mechanisms):
            left, top = k % columns * CELL[0], height - k // columns * CELL[1]
            page.text(
                (left + 0.1) / width, (top - 0.05) / height, places.model.name, va="top", fontsize=11, fontweight="bold"
            )
            axis = page.add_axes(((left + 0.05) / width, (top - CELL[1]) / height, panel[0] / width, panel[1] / height))
            Drawing.of(places, panel, least=panel, margin=MARGIN).on(axis, size=7.5, symbols=SYMBOLS, times=False)
            axis.set_axis_off()
    return page
