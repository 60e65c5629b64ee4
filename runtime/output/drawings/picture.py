"""Picture of a mechanism: start, later positions, paths of points, enlarged clearances."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.run_warnings import unchecked
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.output.drawings import insets
from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.places import Places
from hertzwerk.runtime.output.plots.plot_style import GREY, STYLE, VERMILLION, plain
from hertzwerk.runtime.output.plots.title import differences, differences_of, title_height, title_of, write_title
from hertzwerk.runtime.system.arrays import Array

PANEL = (6.6, 4.7)  # largest size of the mechanism, inches
DPI = 160
LETTERS = 14.0  # on an inch of the lines below


def of_run(run: EngineSolution) -> Figure:
    """Draw the mechanism of a run, at its start and later; raises InputError for a saved run."""
    return figure(Places.over(run), notes_on(run), differences(run))


def notes_on(run: EngineSolution) -> tuple[str, ...]:
    """Return the outcome and warnings that a picture of a run must show."""
    return (*(() if run.outcome.finished else (f"{run.outcome.name}: {run.outcome.message}",)), *run.warnings)


def of_start(model: EngineModel, parameters: Mapping[str, Value] | None, initial: Mapping[str, Value] | None) -> Figure:
    """Draw a mechanism at its start; raises InputError."""
    places = Places.at_start(model, parameters, initial)
    return figure(places, unchecked(model), differences_of(model, parameters or {}, initial or {}))


def figure(places: Places, warnings: Sequence[str], differs: str = "", caption: str = "") -> Figure:
    """Draw the picture on a page of its own, with insets.

    differs: the numbers and effects that are not the scene's own; caption: in place of what the drawing says of itself.
    """
    drawing = Drawing.of(places, PANEL)
    shown = list(insets.clearances(drawing.parts, drawing.point))
    row = len(shown) > 1  # of insets below, else one beside
    plane = drawing.parts.view.names is not None
    (width, height), left, below = drawing.size, 0.75 if plane else 0.15, 0.52 if plane else 0.1
    beside = insets.WIDTH + 0.4 if len(shown) == 1 else 0.2
    across = left + width + beside
    letters = int(LETTERS * (across - 0.2))
    lines_below = textwrap.wrap(caption or drawing.caption(), letters)
    cautions = [line for text in warnings for line in textwrap.wrap(text, letters)]
    title = title_of(places.model, places.model.module.SUMMARY)
    foot = 0.14 + 0.165 * (len(lines_below) + len(cautions))
    low = foot + below + (insets.HEIGHT if row else 0.0)
    top = max(low + height, low + insets.HEIGHT) + 0.15
    tall = top + title_height(across, title, differs)

    def fraction(x: float, y: float, w: float, h: float) -> tuple[float, float, float, float]:
        return x / across, y / tall, w / across, h / tall

    with mpl.rc_context({**STYLE, "axes.grid": False}):
        page = Figure(figsize=(across, tall), dpi=DPI)
        axis = page.add_axes(fraction(left, low, width, height))
        drawing.on(axis)
        spots = [(left + width + 0.3, top - insets.HEIGHT)]
        if row:
            wanted = [
                left + (inset.centre[0] - drawing.frame[0]) / drawing.point / 72 - insets.WIDTH / 2 for inset in shown
            ]
            spots = [(x, foot + 0.4) for x in spread(np.array(wanted), left, left + width - insets.WIDTH)]
        for (x, y), inset in zip(spots, shown, strict=False):
            inset.on(page, axis, fraction(x, y, insets.WIDTH, insets.WIDTH), drawing.point, row)
        write_title(page, title, differs)
        texts: tuple[tuple[list[str], float, dict[str, Any]], ...] = (
            (lines_below, 0.07 + 0.165 * len(cautions), {"va": "bottom", "fontsize": 8.5, "color": GREY}),
            (cautions, 0.07, {"va": "bottom", "fontsize": 8.5, "color": VERMILLION}),
        )
        for lines, y, look in texts:
            page.text(0.1 / across, y / tall, plain("\n".join(lines)), **look)
    return page


def spread(wanted: Array, low: float, high: float) -> Array:
    """Place insets side by side within limits, near where they are wanted."""
    step, order = insets.WIDTH + 0.2, np.argsort(wanted, kind="stable")
    first = np.minimum(np.maximum(wanted, low), high)
    for a, b in pairwise(order):
        first[b] = max(first[b], first[a] + step)
    last = high
    for k in order[::-1]:
        first[k] = min(first[k], last)
        last = first[k] - step
    return first
