"""Style of every picture: colours and Matplotlib settings."""

from __future__ import annotations

from typing import Any

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
