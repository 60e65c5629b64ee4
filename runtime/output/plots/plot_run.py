"""Pictures of a solution: the overview of a run, and one page per contact pair.

Times are sampled densely between the accepted steps, so that an impact of 20 us looks as smooth as it is. Warnings
that affect trust in a picture, an unchecked law or a law outside its range, stand on the picture.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import matplotlib as mpl
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from numpy.typing import NDArray

from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.output.plots.arrangement import Arrangement
from hertzwerk.runtime.output.plots.curves import Curves, impact_curves
from hertzwerk.runtime.output.plots.dents import dents_of, draw_dents
from hertzwerk.runtime.output.plots.plot_panel import CONSTANT, LEGEND_ROOM, caption, empty_panel, legend, panel
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, STYLE, VERMILLION
from hertzwerk.runtime.output.plots.save_figure import png_of
from hertzwerk.runtime.output.plots.unit_prefixes import Scale, scale_of
from hertzwerk.runtime.output.plots.worn_contours import plot_wear, wears
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.engine.solution.impacts import Impact
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

UNRESOLVED = "the rows that were kept do not resolve the first impact,\nwhose peak is {:.4g} {}"
KINDS = {"m": ("Position", "Speed", "Acceleration"), "rad": ("Angle", "Angular speed", "Angular acceleration"),
         "1": ("Quaternion", "Angular speed", "Angular acceleration")}  # fmt: skip
NOTHING = 1e-9  # of the energy moved: less is put in or lost where it is conserved
HEIGHT, LOW = 3.1, 2.6  # inches of a row of panels, and of one of many
PEAKS_CUT = 2.5  # accelerations are shown up to this multiple of the ideal mechanism's


Panel: TypeAlias = Callable[["Axes", Curves], object]
ImpactPanel: TypeAlias = Callable[["Axes", "Impact", Array, Array, Array], object]


def plot(run: EngineSolution, *names: str) -> Figure:
    """Draw the overview of a run, the page of a contact pair or of its wear, or other histories by name.

    Raises KeyError for an unknown name.
    """
    if not names:
        return overview(run)
    if len(names) == 1 and names[0] in run.engine.model.pairs:
        return pair(run, names[0])
    if len(names) == 1 and names[0] in wears(run):
        return plot_wear(run, names[0])
    return histories(run, *names)


def histories(run: EngineSolution, *names: str) -> Figure:
    """Draw a panel for each named history; raises KeyError for an unknown name."""
    curves = Curves.of(run)
    values = [curves[name] for name in names]
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(9.5, 2.3 * len(names) + 0.8), layout=Arrangement())
        axes = figure.subplots(len(names), 1, squeeze=False).ravel()
        for axis, name, of in zip(axes, names, values, strict=True):
            panel(axis, curves, name, run.engine.history.units.get(name, "1"), {name: of})
        caption(figure, run, run.engine.model.module.SUMMARY, curves.notes)
    return figure


def overview(run: EngineSolution) -> Figure:
    """Draw motion, contact forces and energy of a run, beside the ideal mechanism where there is one."""
    return _overview(Curves.of(run))


def pair(run: EngineSolution, name: str) -> Figure:
    """Draw one contact pair: journal path or gap, force, first impact; raises KeyError for another name."""
    if name not in run.engine.model.pairs:
        raise KeyError(f"{name!r} is no contact pair; there are {', '.join(run.engine.model.pairs)}")
    return _pair(Curves.of(run), name)


def pages(run: EngineSolution) -> dict[str, Callable[[Path], None]]:
    """Sample a run; return functions that save the overview and each pair's page as PNG, by name."""
    _ = Curves.of(run).ideal

    figures: dict[str, Callable[[], Figure]] = {"overview": partial(overview, run)}
    figures |= {name: partial(pair, run, name) for name in run.engine.model.pairs}
    figures |= {name: partial(plot_wear, run, name) for name in wears(run)}

    def save(name: str, path: Path) -> None:
        path.write_bytes(png_of(figures[name]()))

    return {name: partial(save, name) for name in figures}


# ---- pages -----------------------------------------------------------------------------------------------------------


def _overview(curves: Curves) -> Figure:
    panels: list[Panel] = []
    for unit in curves.kinds:
        orders = (0, 1) if curves.kinds[unit][0].units[1:] else (0,)
        panels += [partial(_motion, unit=unit, order=order) for order in orders]
        if curves.ideal is not None:
            panels += [partial(_deviations, unit=unit), partial(_accelerations, unit=unit)]
    if _sags(curves):
        panels.append(_bending)
    if curves.run.engine.model.pairs:
        panels.append(_forces)
    if _friction_forces(curves):
        panels.append(_friction)
    if curves.run.energy_residual is not None:
        panels.append(_energy)
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM, "axes.titley": 1.0}):  # nothing is above the panels
        rows = (len(panels) + 1) // 2
        figure = Figure(figsize=(12.5, (HEIGHT if rows < 4 else LOW) * rows + 0.6), layout=Arrangement())
        axes = figure.subplots(rows, 2, squeeze=False).ravel()
        for draw, axis in zip(panels, axes, strict=False):
            draw(axis, curves)
        for axis in axes[len(panels) :]:
            axis.set_visible(False)
        caption(figure, curves.run, curves.run.engine.model.module.SUMMARY, curves.notes)
    return figure


def _pair(curves: Curves, name: str) -> Figure:
    run, film = curves.run, _films(curves).get(name)
    impact = next((impact for impact in run.impacts if impact.contact == name), None)
    with mpl.rc_context({**STYLE, "axes.titlepad": LEGEND_ROOM if film else mpl.rcParams["axes.titlepad"]}):
        figure = Figure(figsize=(12.5, 6.4), layout=Arrangement())
        inside = [output for output in run.engine.model.outputs if output.startswith(f"{name}.eccentricity_")]
        if len(inside) > 1:
            views = [(inside[0], other) for other in inside[1:]]
            figure.set_figwidth(7 + 5.5 * len(views))
            grid = figure.add_gridspec(2, len(views) + 1, width_ratios=(*[1.05] * len(views), 1))
            for column, view in enumerate(views):
                _journal_path(figure.add_subplot(grid[:, column]), curves, name, inside, view)
            _normal_force(figure.add_subplot(grid[0, -1]), curves, name)
            below = figure.add_subplot(grid[1, -1])
            if impact is None and film is not None:
                thickness = {film: curves[f"{film}.thickness"]}
                panel(
                    below, curves, "Least thickness of the film", "m", thickness, from_zero=True, remark="; no contact"
                )
            else:
                _first_impact(run, impact, {below: _impact_force})
        else:
            dents = dents_of(run, name)
            grid = figure.add_gridspec(2 + bool(dents), 2, height_ratios=(1, 1, 0.55)[: 2 + bool(dents)])
            if dents:
                figure.set_figheight(8.4)
                draw_dents(figure.add_subplot(grid[2, :]), dents)
            _gap(figure.add_subplot(grid[0, :]), curves, name)
            below, beside = (figure.add_subplot(grid[1, k]) for k in (0, 1))
            _first_impact(run, impact, {below: _impact_force, beside: _impact_loop})
        laws = [text for effect, _, text in run.engine.model.module.EFFECTS if effect in (name, film)]
        caption(figure, run, ", ".join([name, *laws]), [note for note in curves.notes if note != curves.no_ideal])
    return figure


# ---- panels ----------------------------------------------------------------------------------------------------------


def _accelerations(axis: Axes, curves: Curves, unit: str) -> None:
    """Draw accelerations with the axis limited to the ideal mechanism's; marks show the cut peaks.

    Peaks of an impact are ten times those of the mechanism.
    """
    scale = _motion(axis, curves, unit, 2)
    motions = [motion for motion in curves.kinds[unit] if motion.units[2:]]
    values = scale([curves[motion.names[2]] for motion in motions])
    limit = PEAKS_CUT * float(np.max(np.abs(scale(_ideal(curves, unit, 2)))))
    largest = float(np.max(np.abs(values)))
    if largest <= limit or limit == 0:  # nothing to cut, or an ideal mechanism at rest
        return
    axis.set_ylim(-limit, limit)
    axis.set_title(f"{KINDS[unit][2]} [{scale.unit}], cut (peak {largest:.0f})")
    legend(axis)
    for sign, marker in ((1, "^"), (-1, "v")):
        peaks = _peaks(np.max(sign * values, axis=0), limit)
        if not len(peaks):  # a line without points would stand in the corner, unclipped
            continue
        marks = np.full(len(peaks), sign * 0.97 * limit)
        axis.plot(curves.time(curves.t[peaks]), marks, marker, color=VERMILLION, markersize=4, clip_on=False)


def _motion(axis: Axes, curves: Curves, unit: str, order: int) -> Scale:
    """Draw positions (order 0), speeds (1) or accelerations (2) of a kind, over the ideal mechanism's."""
    motions = [motion for motion in curves.kinds[unit] if len(motion.names) > order]
    names = tuple(motion.names[order] for motion in motions)
    values = {motion.joint: curves[name] for motion, name in zip(motions, names, strict=True)}
    ideal, size = _ideal(curves, unit, order), curves.size(names)
    title = KINDS[unit][order] if curves.ideal is not None else _of_one(KINDS[unit][order], values)
    return panel(axis, curves, title, motions[0].units[order], values, ideal, size=size)


def _of_one(title: str, values: Mapping[str, Array]) -> str:
    """Return the title of a panel, with the name of its only curve, which needs no legend."""
    return f"{title} of {next(iter(values))}" if len(values) == 1 else title


def _ideal(curves: Curves, unit: str, order: int) -> list[Array]:
    ideal = curves.ideal
    if ideal is None:
        return []
    names = [motion.names for motion in curves.kinds[unit] if len(motion.names) > order]
    if order == 2:
        return [ideal.acceleration_of(name[1]) for name in names]
    return [ideal[name[order]] for name in names]


def _deviations(axis: Axes, curves: Curves, unit: str) -> None:
    positions = zip(curves.kinds[unit], _ideal(curves, unit, 0), strict=True)
    values = {motion.joint: curves[motion.names[0]] - ideal for motion, ideal in positions}
    size = curves.size(tuple(motion.names[0] for motion in curves.kinds[unit]))
    panel(axis, curves, f"{KINDS[unit][0]} minus that of the ideal mechanism", unit, values, size=size)


def _sags(curves: Curves) -> list[str]:
    """Name the sags of flexible rods between their ends."""
    sags = (name for name in curves.run.engine.model.outputs if "sag_" in name)
    return [name for name in sags if not name.endswith(("sag_0", "sag_100"))]


def _bending(axis: Axes, curves: Curves) -> None:
    sags = {name: curves[name] for name in _sags(curves)}
    panel(axis, curves, "Sag of rods from the line between their ends", "m", sags)


def _films(curves: Curves) -> dict[str, str]:
    """Return the oil film of each pair that has one, which is neither contact nor flight."""
    return curves.run.engine.model.effects_at_pairs("lubrication")


def _forces(axis: Axes, curves: Curves) -> None:
    oils = _films(curves)
    contacts = {name: curves[f"{name}.normal_force"] for name in curves.run.engine.model.pairs}
    title = "Contact and film force" if oils else _of_one("Contact force", contacts)
    of_films = {f"film, {oil}": curves[f"{oil}.force"] for oil in oils.values()}
    panel(axis, curves, title, "N", contacts | of_films, from_zero=True)


def _friction_forces(curves: Curves) -> list[str]:
    """Name the friction forces that every run has, those of set-valued laws."""
    return [name for name in curves.run.engine.history if name.endswith(".friction_force")]


def _friction(axis: Axes, curves: Curves) -> None:
    forces = {name.removesuffix(".friction_force"): curves[name] for name in _friction_forces(curves)}
    panel(axis, curves, _of_one("Friction force", forces), "N", forces)


def _normal_force(axis: Axes, curves: Curves, name: str) -> None:
    film = _films(curves).get(name)
    values = {"contact": curves[f"{name}.normal_force"]} | ({"film": curves[f"{film}.force"]} if film else {})
    panel(axis, curves, "Film and normal force" if film else "Normal force", "N", values, from_zero=True)


def _energy(axis: Axes, curves: Curves) -> None:
    """Draw energies since the start; where nothing is put in or lost, kinetic and potential energy.

    Their sum is then constant but for the error of the run, which the title states.
    """
    parts = {"mechanical": curves["energy"] - curves["energy"][0]}
    kinds = {name: kind for name, kind, _ in curves.run.engine.model.module.EFFECTS}
    for name in curves.run.engine.model.memory:
        owner, _, quantity = name.rpartition(".")
        work = "drives' work" if kinds.get(owner) == "ledger" else f"work, {owner}"
        label = {"dissipated": f"loss, {owner}", "input": work}.get(quantity)
        if label is not None:
            parts[label] = curves[name]
    residual = curves.run.energy_residual or 0.0
    closure, moved = f"ledger closed to {residual:.1g}", float(np.max(np.abs(list(parts.values()))))
    conserved = max((float(np.max(np.abs(values))) for values in list(parts.values())[1:]), default=0.0)
    if isinstance(curves.sampled, History):
        kinetic, potential = curves.sampled.energies
        moved = max(float(np.max(kinetic)), float(np.ptp(potential)), moved)
        if conserved <= NOTHING * moved:
            parts = {"kinetic": kinetic - kinetic[0], "potential": potential - potential[0], **parts}
            closure = f"constant to {max(residual, CONSTANT):.1g}"
    drawn = {label: values for label, values in parts.items() if np.max(np.abs(values)) > NOTHING * moved}
    drawn["mechanical"] = parts["mechanical"]
    panel(axis, curves, "Energy since the start", "J", drawn, size=moved, remark=f", {closure}")


def _gap(axis: Axes, curves: Curves, name: str) -> None:
    panel(axis, curves, "Gap", "m", {name: curves[f"{name}.gap"]})
    axis.axhline(0, color=GREY, linewidth=0.8)


def _journal_path(axis: Axes, curves: Curves, name: str, inside: Sequence[str], view: tuple[str, str]) -> None:
    """Draw the path of a pin or ball in the plane of two of its eccentricities."""
    (x, y), gap = (curves[part] for part in view), curves[f"{name}.gap"]
    clearance = float(np.median(np.sqrt(sum(curves[part] ** 2 for part in inside)) + gap))
    scale = scale_of("m", clearance)
    points = np.column_stack([scale(x), scale(y)])
    radius = clearance / scale.factor
    look = {"facecolor": "#f3f6f9", "edgecolor": GREY, "linewidth": 1.2, "zorder": 0.8}
    axis.add_patch(Circle((0, 0), radius, label="clearance circle", **look))
    touching = gap[:-1] + gap[1:] < 0  # of each line between two points
    ends = [0, *np.flatnonzero(np.diff(touching)) + 1, len(touching)]
    ways = [(touching[a], points[a : b + 1]) for a, b in pairwise(ends) if a < b]
    apart = "on the film" if name in _films(curves) else "free flight"
    for touches, colour, width, label in (
        (False, BLUE, 0.8, apart),
        (True, VERMILLION, 1.0, "in contact" + (" (outside the circle: penetration)" if len(inside) == 2 else "")),
    ):
        chosen = [way for touching, way in ways if touching == touches]
        if chosen:
            axis.add_collection(LineCollection(chosen, colors=colour, linewidths=width, label=label))
    axis.plot(*points[0], "o", color="black", markersize=4, label="start")
    reach = 1.08 * max(radius, float(np.max(np.hypot(*points.T))))
    axis.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal")
    labels = (f"eccentricity {part[-1]} [{scale.unit}]" for part in view)
    axis.set(**dict(zip(("xlabel", "ylabel"), labels, strict=True)))
    pin = dict(curves.run.engine.model.module.PAIRS)[name] == "pin_in_bush"
    axis.set_title(f"Path of the {'pin' if pin else 'ball'}'s centre in the {'bush' if pin else 'socket'}")
    arrangement: Any = axis.figure.get_layout_engine()
    arrangement.legend_below(axis, columns=2)


def _first_impact(run: EngineSolution, impact: Impact | None, panels: Mapping[Axes, ImpactPanel]) -> None:
    """Draw the first impact of a pair into panels; where it is not resolved, they state so."""
    text = "no impact"
    if impact is not None:
        drawn = impact_curves(run, impact)
        if len(drawn[0]) > 1:
            for axis, draw in panels.items():
                draw(axis, impact, *drawn)
                axis.set_ylim(bottom=0)
            return
        scale = scale_of("N", impact.peak_force)
        text = UNRESOLVED.format(impact.peak_force / scale.factor, scale.unit)
    for axis in panels:
        empty_panel(axis, text)


def _impact_force(axis: Axes, impact: Impact, t: Array, force: Array, _: Array) -> None:
    time, start, scale = scale_of("s", t[-1]), scale_of("s", impact.t), scale_of("N", force)
    axis.plot(time(t), scale(force), color=BLUE, linewidth=1.4)
    axis.fill_between(time(t), scale(force), color=BLUE, alpha=0.12, linewidth=0)
    axis.set_title(f"First impact: normal force [{scale.unit}]")
    onset = f"its onset at {impact.t / start.factor:.6g} {start.unit}"
    axis.set_xlabel(f"time [{time.unit}] since {onset}; approach speed {impact.speed:.4g} m/s")


def _impact_loop(axis: Axes, _: Impact, t: Array, force: Array, penetration: Array) -> None:
    scale, length = scale_of("N", force), scale_of("m", penetration)
    axis.plot(length(penetration), scale(force), color=BLUE, linewidth=1.4)
    axis.fill(length(penetration), scale(force), color=BLUE, alpha=0.12, linewidth=0)
    axis.set_title(f"First impact: force over penetration [{scale.unit}]")
    axis.set_xlabel(f"penetration [{length.unit}]; the area is the energy dissipated")


def _peaks(values: Array, limit: float) -> NDArray[np.intp]:
    """Return the index of the largest value of every stretch above the limit."""
    above = np.flatnonzero(values > limit)
    groups = np.split(above, np.flatnonzero(np.diff(above) > 1) + 1) if len(above) else []
    return np.array([group[np.argmax(values[group])] for group in groups], dtype=np.intp)
