"""Picture of a wear: contours as they grow, of pin and bush also enlarged around the axis; volume."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.arrangement import Arrangement
from hertzwerk.runtime.output.plots.curves import Curves
from hertzwerk.runtime.output.plots.picture_samples import Rows
from hertzwerk.runtime.output.plots.plot_panel import caption, over_time
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, STYLE, VERMILLION
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.engine.solution.solution import EngineSolution

INSTANTS, ANGLES = 5, np.linspace(0, 2 * np.pi, 721)
SHOWN, APART = 0.25, 0.2  # of the bush's radius: deepest as shown, and clearance as shown
COLOURS = {"bush": BLUE, "pin": VERMILLION, "track": BLUE}


def wears(run: EngineSolution) -> list[str]:
    """Names of the wears of pins, bushes and tracks."""
    effects = run.engine.model.module.EFFECTS
    return [name for name, kind, _ in effects if kind == "wear" and worn_surfaces(run, name)]


def worn_surfaces(run: EngineSolution, wear: str) -> dict[str, Array]:
    """Depths (sectors, times) [m] of the pin, bush or track that wears, by name; empty for one spot."""
    names = {
        surface: [f"{wear}.{surface}_{k + 1}" for k in range(len(run.engine.model.coordinates))] for surface in COLOURS
    }
    known = {surface: [name for name in of if name in run.engine.model.coordinates] for surface, of in names.items()}
    return {surface: np.array([run[name] for name in of]) for surface, of in known.items() if of}


def contour(depths: Array, angles: Array) -> Array:
    """Depth (n, ...) at angles (n,) [rad] between sectors (sectors, ...), by their shares."""
    count = len(depths)
    half = (angles[:, None] - 2 * np.pi * np.arange(count) / count) / 2
    shares = (np.sinc(count / (2 * np.pi) * half) / np.sinc(half / np.pi)) ** 4
    line: Array = (shares / shares.sum(axis=1, keepdims=True)) @ depths
    return line


def plot_wear(run: EngineSolution, wear: str) -> Figure:
    """Draw the worn contours at five instants, also unrolled, and the volume lost."""
    rows = Curves(run, run.t, Rows(run), scale_of("s", run.t[-1])) if len(run.t) else Curves.of(run)  # which refuses
    surfaces = worn_surfaces(run, wear)
    shown = np.unique(np.searchsorted(run.t, np.linspace(run.t[0], run.t[-1], INSTANTS + 1)[1:]))
    track = "track" in surfaces
    lines = {name: contour(depths[:, shown], ANGLES - np.pi * track) for name, depths in surfaces.items()}
    deepest = max(float(of.max()) for of in lines.values()) or 1.0
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(9.5 if track else 12.5, 6.4), layout=Arrangement())
        grid = figure.add_gridspec(2, 1 if track else 2, width_ratios=(1,) if track else (1.05, 1))
        if not track:
            _around(figure.add_subplot(grid[:, 0]), run, wear, lines, deepest)
        _unrolled(figure.add_subplot(grid[0, -1]), lines, track=track)
        below = figure.add_subplot(grid[1, -1])
        below.plot(rows.time(run.t), run[f"{wear}.volume"] * 1e9, color=GREY)
        below.set_ylim(bottom=0)
        over_time(below, rows, "Volume lost [mm³]")
        text = next(text for name, _, text in run.engine.model.module.EFFECTS if name == wear)
        caption(figure, run, f"{wear}, {text}")
    return figure


def _around(axis: Axes, run: EngineSolution, wear: str, lines: dict[str, Array], deepest: float) -> None:
    """Draw the contours around the axis, one for each instant, the last one heavy."""
    circle = np.stack([np.cos(ANGLES), np.sin(ANGLES)])
    for name, of in lines.items():
        radius, outwards = (1.0, 1) if name == "bush" else (1 - APART, -1)
        axis.plot(*(radius * circle), color=GREY, linewidth=0.8, linestyle=(0, (3, 2)))
        for depth, look in _growing(name, of):
            axis.plot(*((radius + outwards * SHOWN * depth / deepest) * circle), **look)
    axis.set(aspect="equal", xticks=[], yticks=[], xlim=(-1.35, 1.35), ylim=(-1.35, 1.35))
    axis.grid(visible=False)
    axis.spines[:].set_visible(False)
    title, model, p = f"Contours at {of.shape[1]} instants, depth enlarged", run.engine.model, run.engine.history.p
    if p is not None:  # of a saved run sizes are not known
        _, bush = next(model.radii(p)[pair] for pair, name in model.effects_at_pairs("wear").items() if name == wear)
        title += f" {float(f'{SHOWN * bush / deepest:.2g}'):.6g} times"
    axis.set_title(title)
    axis.legend(loc="center")


def _growing(name: str, of: Array) -> Iterator[tuple[Array, dict[str, Any]]]:
    """Yield the depth of a surface at each instant, and how it is drawn: the last one heavy, and named."""
    for share, depth in zip(np.linspace(0, 1, of.shape[1] + 1)[1:], of.T, strict=True):
        yield depth, {"color": COLOURS[name], "alpha": 0.2 + 0.8 * share**2, "label": name if share == 1 else None}


def _unrolled(axis: Axes, lines: dict[str, Array], *, track: bool) -> None:
    """Draw the depth over the angle or, downwards, along the track, one line for each instant."""
    scale = scale_of("m", max(float(of.max()) for of in lines.values()))
    places = ANGLES / (2 * np.pi) - 0.5 if track else np.degrees(ANGLES)
    for name, of in lines.items():
        for depth, look in _growing(name, of):
            axis.plot(places, scale(depth), **look)
    axis.set_ylim(bottom=0)
    if track:
        axis.set(xlim=(-0.5, 0.5), xlabel="position along the track, from the plane's place, over its length")
        axis.invert_yaxis()
    else:
        axis.set(xticks=np.arange(0, 361, 60), xlim=(0, 360), xlabel="angle in the surface's own axes [degree]")
    axis.set_title(f"Depth [{scale.unit}]")
