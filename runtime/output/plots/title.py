"""Titles of pictures: the scene, and how a run of it differs from the scene's own numbers and effects."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure

from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.continuation import parameters_of
from hertzwerk.runtime.output.plots.plot_style import GREY, plain

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

MOST = 12  # differences that are listed
BOLD, SMALL = 9.4, 13.5  # characters on an inch, of the title and of the line below it
TITLE, LINE = 0.24, 0.17  # inches of a line
MARGIN = 0.06  # inches above


def title_of(model: EngineModel, subtitle: str) -> str:
    """Return the name of a scene and what a picture shows of it."""
    return ": ".join(filter(None, (model.name, subtitle)))


def differences(run: EngineSolution) -> str:
    """Describe the variation of the scene, and the parameters and initial states that are not its own."""
    initial = {} if run.engine.checkpoint is None else run.engine.checkpoint.initial
    return differences_of(run.engine.model, parameters_of(run, run.engine.model), initial)


def differences_of(model: EngineModel, parameters: Mapping[str, Value], initial: Mapping[str, Value]) -> str:
    """Describe a variation of a scene, and parameters and initial states given in place of its own."""
    changes = [f"{name} = {_text(value)}" for name, value in (*parameters.items(), *initial.items())]
    variation = model.declaration
    if variation is not None:
        changes += [f"{effect} by {law}" for effect, law in variation.laws]
        changes += [f"without {', '.join(variation.without)}"] if variation.without else []
        changes += [f"{variation.coordinates} coordinates"] if variation.coordinates is not None else []
    more = [f"and {len(changes) - MOST} more"] if len(changes) > MOST else []
    return ", ".join([*changes[:MOST], *more])


def _text(value: Value) -> str:
    if isinstance(value, str):
        return value
    number, unit = value if isinstance(value, tuple) else (value, "1")
    return f"{number:.6g}" + ("" if unit == "1" else f" {unit}")


def title_height(width: float, title: str, below: str) -> float:
    """Return the height [inch] of a title, and a line below it, on a figure of a width [inch]."""
    rows = ((textwrap.wrap(text, int(letters * (width - 0.2))), line) for text, letters, line in
            ((title, BOLD, TITLE), (below, SMALL, LINE)))  # fmt: skip
    return MARGIN + sum(line * len(texts) for texts, line in rows)


def write_title(figure: Figure, title: str, below: str) -> float:
    """Write a title, and a line below it, at the top of a figure; return their height [inch]."""
    width, height = figure.get_size_inches()
    used = MARGIN
    looks: tuple[tuple[str, float, float, dict[str, Any]], ...] = (
        (title, BOLD, TITLE, {"fontsize": 12.5, "fontweight": "bold"}),
        (below, SMALL, LINE, {"fontsize": 9.5, "color": GREY}),
    )
    for text, letters, line, look in looks:
        rows = textwrap.wrap(text, int(letters * (width - 0.2)))
        figure.text(0.1 / width, 1 - used / height, plain("\n".join(rows)), va="top", ha="left", **look)
        used += line * len(rows)
    return used


def titled_page(width: float, height: float, title: str, below: str) -> Figure:
    """Return a figure with a title, a line below it, and a height [inch] for panels under them."""
    page = Figure(figsize=(width, height + title_height(width, title, below)), layout="constrained")
    layout: Any = page.get_layout_engine()
    layout.set(rect=(0, 0, 1, 1 - write_title(page, title, below) / page.get_figheight()))
    return page
