"""Figures as content of PNG files, and as SVG text for pages that hold them; each is drawn once."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
from matplotlib.collections import LineCollection

from hertzwerk.runtime.output.plots.arrangement import Arrangement
from hertzwerk.runtime.output.plots.plot_style import STYLE

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MANY = 4000  # points from which a path is drawn as pixels
DPI = 200
COMPRESSION = 3  # of PNG files, of 9: 3 takes two thirds of the time of 6, and a tenth more bytes


def png_of(figure: Figure, **options: Any) -> bytes:
    """Return a figure as the content of a PNG file; its layout is fixed by this."""
    _lay_out(figure)
    content = io.BytesIO()
    with mpl.rc_context(STYLE):
        figure.savefig(content, format="png", pil_kwargs={"compress_level": COMPRESSION}, **options)
    return content.getvalue()


def svg_of(figure: Figure) -> str:
    """Return a figure as SVG, texts as outlines, so that it looks the same everywhere."""
    for lines in figure.findobj(LineCollection):
        lines.set_rasterized(sum(map(len, lines.get_paths())) > MANY)
    _lay_out(figure)
    text = io.StringIO()
    with mpl.rc_context({**STYLE, "svg.fonttype": "path"}):
        figure.savefig(text, format="svg", dpi=DPI, metadata={"Date": None, "Creator": None})
    return text.getvalue()


def _lay_out(figure: Figure) -> None:
    """Execute a layout that needs no drawing, and remove it: with one, Matplotlib draws a figure twice."""
    layout = figure.get_layout_engine()
    if isinstance(layout, Arrangement):
        layout.execute(figure)
        figure.set_layout_engine(None)
