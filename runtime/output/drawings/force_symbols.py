"""Symbols of force elements: springs, dampers, drives, forces and moments; pitch circles of gears."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from hertzwerk.runtime.output.drawings.drawing_primitives import INK, Paper
from hertzwerk.runtime.output.drawings.parts import THIN, Parts, across
from hertzwerk.runtime.output.drawings.places import Landmark
from hertzwerk.runtime.output.plots.plot_style import GREY, VERMILLION
from hertzwerk.runtime.system.arrays import Array

REACH = 13.0  # radius of symbols around a joint, points
ARROW = 30.0  # length, points
RUBBER = 7.0  # size of a bushing, points


def draw(parts: Parts, paper: Paper, i: int) -> None:
    """Draw all force elements at an instant."""
    for (_, kind), marks in parts.of.items():
        if kind in _SYMBOLS:
            _SYMBOLS[kind](parts, paper, marks, i)


def _between(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    a, b = (parts.at(mark, i) for mark in marks[:2])
    if float(np.linalg.norm(b - a)) > 2 * paper.point:
        (paper.zigzag if marks[0].kind.endswith("spring") else paper.dashpot)(a, b)


def along_slide(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> tuple[Array, Array, bool]:
    """Return the ends of a slide's spring or damper, and whether ground is drawn at the first.

    They are both points of the joint; where these are close, the ground is behind the slider, where the outline of another
    body is between them, before it. A damper stands beside a spring.
    """
    way, _ = parts.way(marks[0], "axis", i)
    side = np.array([-way[1], way[0]]) * paper.point * (0.0 if marks[0].kind.endswith("spring") else 9.0)
    a, b = (parts.at(mark, i) + side for mark in marks[:2])
    along, _ = parts.half_block(paper, marks[1])
    away, reach = way if (b - a) @ way >= 0 else -way, 1.4 * ARROW * paper.point
    if parts.is_covered((a + b) / 2, marks[1].body, i):
        return b + (along + reach) * away, b + along * away, True
    b = b - along * away
    near = bool((b - a) @ away < ARROW * paper.point)
    return (b - reach * away if near else a), b, near


def _on_slide(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    a, b, grounded = along_slide(parts, paper, marks, i)
    if grounded:
        away = (b - a) / float(np.linalg.norm(b - a))
        edge = np.array([-away[1], away[0]]) * 9 * paper.point
        paper.ground(a - edge, a + edge, -away)
    (paper.zigzag if marks[0].kind.endswith("spring") else paper.dashpot)(a, b)


def _arc(parts: Parts, mark: Landmark, i: int, radius: float, start: float, end: float) -> Array:
    """Return the projected arc about the axis of a landmark, angles in degrees."""
    name = "axis" if "axis" in mark.beside else "moment"
    first, second = across(parts.places.direction(mark, name)[i])
    angles = np.radians(np.linspace(start, end, 40))
    size = radius * parts.unit.factor
    around = np.cos(angles)[:, None] * first * size + np.sin(angles)[:, None] * second * size
    return parts.flat(parts.positions[id(mark)][i] + around)


def _turn_arrow(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    paper.turning(_arc(parts, marks[0], i, REACH * paper.point, -30, 200))


def _spiral(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    sizes = np.linspace(0.35, 0.9, 80) * REACH * paper.point
    turns = [
        _arc(parts, marks[0], i, size, angle, angle)[0]
        for size, angle in zip(sizes, np.linspace(0, 900, 80), strict=True)
    ]
    paper.line(np.array(turns), INK, 0.9, 6.5)


def _turn_damper(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    for start in (20, 200):
        paper.line(_arc(parts, marks[0], i, 0.7 * REACH * paper.point, start, start + 140), INK, 1.8, 6.5)


def _slide_arrow(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    way, projected = parts.way(marks[0], "axis", i)
    if projected > THIN:
        along, _ = parts.half_block(paper, marks[1])
        start = parts.at(marks[1], i) + (along + 2 * paper.point) * way
        paper.arrow(np.array([start, start + 0.8 * ARROW * paper.point * way]), VERMILLION)


def _force(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    """Draw an arrow along a force that depends on parameters alone; for any other its point."""
    at = parts.at(marks[0], i)
    if len(marks) > 1 and np.any(marks[1].beside["force"]):
        way, projected = parts.way(marks[1], "force", i)
        if projected > THIN:
            paper.arrow(np.array([at, at + ARROW * paper.point * way]), VERMILLION, 1.8)
            return
    paper.pin(at, 3.2, VERMILLION)


def _moment(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    at = parts.at(marks[0], i)
    if len(marks) > 1 and np.any(marks[1].beside["moment"]):
        outline = _arc(parts, marks[1], i, REACH * paper.point, -30, 200)
        paper.turning(outline - parts.at(marks[1], i) + at)
    else:
        paper.pin(at, 3.2, VERMILLION)


def _bushing(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    """Draw a ring of rubber around the first frame, and a spring to the second where it is apart."""
    a, b = (parts.at(mark, i) for mark in marks[:2])
    if float(np.linalg.norm(b - a)) > 2 * RUBBER * paper.point:
        paper.zigzag(a, b)
    paper.pin(a, RUBBER, GREY, 7.0)
    paper.pin(a, 0.45 * RUBBER, "white", 7.1)


def _belt(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    """Draw a belt around a drum, from its load or upwards, to an arrow that holds it."""
    drum = marks[0] if marks[0].place == "drum" else marks[1]
    axis = parts.places.direction(drum, "axis")[i] if "axis" in drum.beside else None
    ring = parts.ring(parts.positions[id(drum)][i], axis, drum.size("radius"))
    middle, loads = parts.at(drum, i), [parts.at(mark, i) for mark in marks if mark.place == "load"]
    paper.line(ring, INK, 1.8, 6.5)
    radius = float(np.max(np.linalg.norm(ring - middle, axis=1)))
    down = loads[0] - middle if loads else np.array([0.0, -2 * radius - ARROW * paper.point])
    far = float(np.linalg.norm(down))
    along = down / far if far > 0 else np.array([0.0, -1.0])
    side, share = np.array([-along[1], along[0]]), min(radius / far, 1.0) if far > 0 else 0.0
    rim = [middle + radius * (share * along + sign * np.sqrt(1 - share**2) * side) for sign in (1, -1)]
    if loads:
        paper.line(np.array([rim[0], loads[0]]), INK, 1.8, 6.5)
    paper.arrow(np.array([rim[1], rim[1] + ARROW * paper.point * along]), VERMILLION, 1.8)


def _blade(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    """Draw a knife edge as a line along which its point may move: level where it is seen in space."""
    across_it, out = parts.places.direction(marks[0], "across")[i], parts.view.towards
    down = [parts.places.direction(mark, "axis")[i] for mark in parts.places.landmarks if mark.kind == "gravity"]
    if parts.view.names is None and down:
        out = down[0]
    along = parts.view(np.cross(across_it, out))
    length, at = float(np.linalg.norm(along)), parts.at(marks[0], i)
    if length > THIN:
        half = REACH * paper.point * along / length
        paper.line(np.array([at - half, at + half]), VERMILLION, 2.4, 7.5)
    paper.pin(at, 2.0, VERMILLION)


def _mesh(parts: Parts, paper: Paper, marks: Sequence[Landmark], i: int) -> None:
    """Draw the pitch circles of wheels, and the line of a rack or rope."""
    style = (0, (9, 3, 1.5, 3))
    for mark in marks:
        where = parts.positions[id(mark)][i]
        if "radius" in mark.beside:
            outline = parts.ring(where, parts.places.direction(mark, "axis")[i], mark.size("radius"))
        else:
            way = parts.places.direction(mark, "along")[i]
            beside = (parts.positions[id(marks[1])][i] - where) @ way
            outline = parts.flat(np.array([where, where + beside * way]))
        paper.line(outline, INK, 0.9, 6.5, style)


_SYMBOLS: dict[str, Callable[[Parts, Paper, Sequence[Landmark], int], None]] = {
    "spring": _between,
    "bushing": _bushing,
    "belt": _belt,
    "damper": _between,
    "slide_spring": _on_slide,
    "slide_damper": _on_slide,
    "turn_spring": _spiral,
    "turn_damper": _turn_damper,
    "turn_drive": _turn_arrow,
    "turn_force": _turn_arrow,
    "turn_motor": _turn_arrow,
    "slide_drive": _slide_arrow,
    "slide_force": _slide_arrow,
    "slide_motor": _slide_arrow,
    "knife_edge": _blade,
    "mesh": _mesh,
    "force": _force,
    "moment": _moment,
}
