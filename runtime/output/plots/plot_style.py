"""Style of every picture: colours and Matplotlib settings."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Okabe & Ito's palette, distinguishable with every common colour vision.
BLUE, VERMILLION, GREEN, ORANGE, PURPLE, SKY = "#0072B2", "#D55E00", "#009E73", "#E69F00", "#CC79A7", "#56B4E9"
GREY = "#707070"
CYCLE = (BLUE, VERMILLION, GREEN, PURPLE, SKY, ORANGE)

STYLE: Any = {  # typed as 300 literal names by Matplotlib
    "font.size": 9.5,
    "axes.titlesize": 10.5,
    "axes.titlelocation": "left",
    "axes.titleweight": "bold",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.7,
    "lines.linewidth": 1.0,
    "lines.solid_joinstyle": "round",
    "legend.frameon": False,
    "legend.fontsize": 9,
    "savefig.dpi": 160,
    "svg.hashsalt": "hertzwerk",
}


def plain(text: str) -> str:
    """Escape the dollars of a text, so that they begin no mathematics."""
    return text.replace("$", r"\$")


def heading(page: Figure, title: str, *notes: str) -> None:
    """Write a title over the panels of a page, and notes below them, in lines of the page's width."""
    page.suptitle(plain(title), x=0.01, ha="left", fontsize=12.5, fontweight="bold")
    if notes:
        rows = [row for note in notes for row in textwrap.wrap(note, int(13 * page.get_figwidth()))]
        page.supxlabel(plain("\n".join(rows)), x=0.01, ha="left", fontsize=9, color=GREY)
