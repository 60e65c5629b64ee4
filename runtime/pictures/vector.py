"""Figures as SVG text, for pages that hold their pictures."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import matplotlib as mpl
from matplotlib.collections import LineCollection

from hertzwerk.runtime.pictures.plot_style import STYLE

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MANY = 4000  # segments from which a path is drawn as pixels: each one would be an element of the picture
DPI = 200


def svg_of(figure: Figure) -> str:
    """Return a figure as SVG, texts as outlines, so that it looks the same everywhere."""
    for lines in figure.findobj(LineCollection):
        lines.set_rasterized(len(lines.get_paths()) > MANY)
    text = io.StringIO()
    with mpl.rc_context({**STYLE, "svg.fonttype": "path"}):
        figure.savefig(text, format="svg", dpi=DPI, metadata={"Date": None, "Creator": None})
    return text.getvalue()
