"""Pictures of a solution: the overview of a run, and one page per contact pair.

Times are sampled densely between the accepted steps, so that an impact of 20 us looks as smooth as it is. Warnings
that affect trust in a picture, an unchecked law or a law outside its range, stand on the picture.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from numpy.typing import NDArray

from hertzwerk.runtime.pictures.curves import Array, Curves, Scale, impact_curves, scale_of
from hertzwerk.runtime.pictures.plot_panel import LEGEND_ROOM, caption, empty_panel, legend, lines, over_time
from hertzwerk.runtime.pictures.plot_style import BLUE, GREY, STYLE, VERMILLION

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.solution.impacts import Impact
    from hertzwerk.runtime.solution.solution import Solution

UNRESOLVED = "the rows that were kept do not resolve the first impact"
PEAKS_CUT = 2.5  # accelerations are shown up to this multiple of the ideal mechanism's


def plot(run: Solution, *names: str) -> Figure:
    """Draw the overview of a run, one contact pair's page, or other histories by name.

    Raises KeyError for an unknown name.
    """
    if not names:
        return overview(run)
    if len(names) == 1 and names[0] in run.model.pairs:
        return pair(run, names[0])
    return histories(run, *names)


def histories(run: Solution, *names: str) -> Figure:
    """Draw a panel for each named history; raises KeyError for an unknown name."""
    curves = Curves.of(run)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(9.5, 2.3 * len(names) + 0.8), layout="constrained")
        axes = figure.subplots(len(names), 1, squeeze=False).ravel()
        for axis, name in zip(axes, names, strict=True):
            scale = lines(axis, curves, run.history.units.get(name, "1"), {name: curves[name]})
            over_time(axis, curves, f"{name} [{scale.unit}]")
        caption(figure, run, run.model.module.SUMMARY)
    return figure


def overview(run: Solution) -> Figure:
    """Draw motion, contact forces and energy of a run, beside the ideal mechanism where there is one."""
    return _overview(Curves.of(run))


def pair(run: Solution, name: str) -> Figure:
    """Draw one contact pair: journal path or gap, force, first impact; raises KeyError for another name."""
    if name not in run.model.pairs:
        raise KeyError(f"{name!r} is no contact pair; there are {', '.join(run.model.pairs)}")
    return _pair(Curves.of(run), name)


def pages(run: Solution) -> dict[str, Callable[[Path], None]]:
    """Return functions that save the overview and each pair's page as PNG, by name; data are shared."""
    curves = cache(lambda: Curves.of(run))

    def saved(figure: Callable[[], Figure]) -> Callable[[Path], None]:
        def save(path: Path) -> None:
            page = figure()
            with mpl.rc_context(STYLE):
                page.savefig(path)

        return save

    return {"overview": saved(lambda: _overview(curves()))} | {
        name: saved(partial(lambda pair: _pair(curves(), pair), name)) for name in run.model.pairs
    }


# ---- pages -----------------------------------------------------------------------------------------------------------


def _overview(curves: Curves) -> Figure:
    panels: list[Callable[[Axes, Curves], None]] = [_positions, _speeds]
    if curves.ideal is not None:
        panels += [_deviations, _accelerations]
    if curves.run.model.pairs:
        panels.append(_forces)
    if curves.run.energy_residual is not None:
        panels.append(_energy)
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM}):
        rows = (len(panels) + 1) // 2
        figure = Figure(figsize=(12.5, 3.1 * rows + 0.6), layout="constrained")
        axes = figure.subplots(rows, 2, squeeze=False).ravel()
        for draw, axis in zip(panels, axes, strict=False):
            draw(axis, curves)
        for axis in axes[len(panels) :]:
            axis.set_visible(False)
        caption(figure, curves.run, curves.run.model.module.SUMMARY, curves.no_ideal)
    return figure


def _pair(curves: Curves, name: str) -> Figure:
    run = curves.run
    impact = next((impact for impact in run.impacts if impact.contact == name), None)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(12.5, 6.4), layout="constrained")
        inside = [output for output in run.model.outputs if output.startswith(f"{name}.eccentricity_")]
        if len(inside) > 1:
            views = [(inside[0], other) for other in inside[1:]]
            figure.set_figwidth(7 + 5.5 * len(views))
            grid = figure.add_gridspec(2, len(views) + 1, width_ratios=(*[1.05] * len(views), 1))
            for column, view in enumerate(views):
                _journal_path(figure.add_subplot(grid[:, column]), curves, name, inside, view)
            _normal_force(figure.add_subplot(grid[0, -1]), curves, name)
            _first_impact(figure.add_subplot(grid[1, -1]), run, impact)
        else:
            grid = figure.add_gridspec(2, 2)
            _gap(figure.add_subplot(grid[0, :]), curves, name)
            _first_impact(figure.add_subplot(grid[1, 0]), run, impact)
            _loop(figure.add_subplot(grid[1, 1]), run, impact)
        laws = [text for effect, _, text in run.model.module.EFFECTS if effect == name]
        caption(figure, run, ", ".join([name, *laws]))
    return figure


# ---- panels ----------------------------------------------------------------------------------------------------------


def _positions(axis: Axes, curves: Curves) -> None:
    _motion(axis, curves, 0, "Position")


def _speeds(axis: Axes, curves: Curves) -> None:
    _motion(axis, curves, 1, "Speed")


def _accelerations(axis: Axes, curves: Curves) -> None:
    """Draw accelerations with the axis limited to the ideal mechanism's; marks show the cut peaks.

    Peaks of an impact are ten times those of the mechanism.
    """
    scale = _motion(axis, curves, 2, "Acceleration")
    values = scale([curves[motion.names[2]] for motion in curves.motions])
    limit = PEAKS_CUT * float(np.max(np.abs(scale(_ideal(curves, 2)))))
    largest = float(np.max(np.abs(values)))
    if largest <= limit or limit == 0:  # nothing to cut, or an ideal mechanism at rest
        return
    axis.set_ylim(-limit, limit)
    axis.set_title(f"Acceleration [{scale.unit}], cut at the marks (largest peak {largest:.0f})")
    legend(axis)
    for sign, marker in ((1, "^"), (-1, "v")):
        peaks = _peaks(np.max(sign * values, axis=0), limit)
        marks = np.full(len(peaks), sign * 0.97 * limit)
        axis.plot(curves.time(curves.t[peaks]), marks, marker, color=VERMILLION, markersize=4, clip_on=False)


def _motion(axis: Axes, curves: Curves, order: int, title: str) -> Scale:
    """Draw positions (order 0), speeds (1) or accelerations (2), over the ideal mechanism's."""
    values = {motion.joint: curves[motion.names[order]] for motion in curves.motions}
    scale = lines(axis, curves, curves.motions[0].units[order], values, _ideal(curves, order))
    over_time(axis, curves, f"{title} [{scale.unit}]")
    return scale


def _ideal(curves: Curves, order: int) -> list[Array]:
    ideal = curves.ideal
    if ideal is None:
        return []
    if order == 2:
        return [ideal.acceleration_of(motion.names[1]) for motion in curves.motions]
    return [ideal[motion.names[order]] for motion in curves.motions]


def _deviations(axis: Axes, curves: Curves) -> None:
    positions = zip(curves.motions, _ideal(curves, 0), strict=True)
    values = {motion.joint: curves[motion.names[0]] - ideal for motion, ideal in positions}
    scale = lines(axis, curves, curves.motions[0].units[0], values)
    over_time(axis, curves, f"Position minus that of the ideal mechanism [{scale.unit}]")


def _forces(axis: Axes, curves: Curves) -> None:
    scale = lines(axis, curves, "N", {name: curves[f"{name}.normal_force"] for name in curves.run.model.pairs})
    axis.set_ylim(bottom=0)
    over_time(axis, curves, f"Contact force [{scale.unit}]")


def _normal_force(axis: Axes, curves: Curves, name: str) -> None:
    scale = lines(axis, curves, "N", {name: curves[f"{name}.normal_force"]})
    axis.set_ylim(bottom=0)
    over_time(axis, curves, f"Normal force [{scale.unit}]")


def _energy(axis: Axes, curves: Curves) -> None:
    parts = {"mechanical": curves["energy"] - curves["energy"][0]}
    for name in curves.run.model.memory:
        owner, _, what = name.rpartition(".")
        label = {"dissipated": f"loss, {owner}", "input": "drives' work"}.get(what)
        if label is not None:
            parts[label] = curves[name]
    scale = lines(axis, curves, "J", {label: values for label, values in parts.items() if np.any(values)})
    over_time(axis, curves, f"Energy since the start [{scale.unit}], ledger closed to {curves.run.energy_residual:.1g}")


def _gap(axis: Axes, curves: Curves, name: str) -> None:
    scale = lines(axis, curves, "m", {name: curves[f"{name}.gap"]})
    axis.axhline(0, color=GREY, linewidth=0.8)
    over_time(axis, curves, f"Gap [{scale.unit}]")


def _journal_path(axis: Axes, curves: Curves, name: str, inside: Sequence[str], view: tuple[str, str]) -> None:
    """Draw the path of a pin or ball in the plane of two of its eccentricities."""
    (x, y), gap = (curves[part] for part in view), curves[f"{name}.gap"]
    clearance = float(np.median(np.sqrt(sum(curves[part] ** 2 for part in inside)) + gap))
    scale = scale_of("m", clearance)
    points = np.column_stack([scale(x), scale(y)])
    radius = clearance / scale.factor
    look = {"facecolor": "#f3f6f9", "edgecolor": GREY, "linewidth": 1.2, "zorder": 0.8}
    axis.add_patch(Circle((0, 0), radius, label="clearance circle", **look))
    segments = np.stack([points[:-1], points[1:]], axis=1)
    touching = gap[:-1] + gap[1:] < 0
    for chosen, colour, width, label in (
        (~touching, BLUE, 0.8, "free flight"),
        (touching, VERMILLION, 1.0, "in contact" + (" (outside the circle: penetration)" if len(inside) == 2 else "")),
    ):
        axis.add_collection(LineCollection(list(segments[chosen]), colors=colour, linewidths=width, label=label))
    axis.plot(*points[0], "o", color="black", markersize=4, label="start")
    reach = 1.08 * max(radius, float(np.max(np.hypot(*points.T))))
    axis.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal")
    labels = (f"eccentricity {part[-1]} [{scale.unit}]" for part in view)
    axis.set(**dict(zip(("xlabel", "ylabel"), labels, strict=True)))
    pin = dict(curves.run.model.module.PAIRS)[name] == "pin_in_bush"
    axis.set_title(f"Path of the {'pin' if pin else 'ball'}'s centre in the {'bush' if pin else 'socket'}")
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.09), ncols=2)


def _first_impact(axis: Axes, run: Solution, impact: Impact | None) -> None:
    if impact is None:
        empty_panel(axis, "no impact")
        return
    t, force, _ = impact_curves(run, impact)
    if len(t) < 2:
        empty_panel(axis, UNRESOLVED)
        return
    time, start, scale = scale_of("s", t[-1]), scale_of("s", impact.t), scale_of("N", force)
    axis.plot(time(t), scale(force), color=BLUE, linewidth=1.4)
    axis.fill_between(time(t), scale(force), color=BLUE, alpha=0.12, linewidth=0)
    axis.set_ylim(bottom=0)
    axis.set_title(f"First impact: normal force [{scale.unit}]")
    onset = f"its onset at {impact.t / start.factor:.6g} {start.unit}"
    axis.set_xlabel(f"time [{time.unit}] since {onset}; approach speed {impact.speed:.4g} m/s")


def _loop(axis: Axes, run: Solution, impact: Impact | None) -> None:
    if impact is None:
        empty_panel(axis, "")
        return
    t, force, penetration = impact_curves(run, impact)
    if len(t) < 2:
        empty_panel(axis, UNRESOLVED)
        return
    scale, length = scale_of("N", force), scale_of("m", penetration)
    axis.plot(length(penetration), scale(force), color=BLUE, linewidth=1.4)
    axis.fill(length(penetration), scale(force), color=BLUE, alpha=0.12, linewidth=0)
    axis.set_ylim(bottom=0)
    axis.set_title(f"First impact: force over penetration [{scale.unit}]")
    axis.set_xlabel(f"penetration [{length.unit}]; the area is the energy dissipated")


def _peaks(values: Array, limit: float) -> NDArray[np.intp]:
    """Return the index of the largest value of every stretch above the limit."""
    above = np.flatnonzero(values > limit)
    groups = np.split(above, np.flatnonzero(np.diff(above) > 1) + 1) if len(above) else []
    return np.array([group[np.argmax(values[group])] for group in groups], dtype=np.intp)
