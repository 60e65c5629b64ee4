"""Faults of declarations of the wrong type, which prevent all other checks."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Body, Direction, Ground, Point
from hertzwerk.derive.declare.mechanism.solids import Shape
from hertzwerk.derive.declare.scene.checks.directions import direction_faults, directions

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene


def scene_type_faults(scene: Scene) -> Iterator[Fault]:
    """Yield faults of values of the wrong type."""
    if scene.coordinates not in ("tree", "absolute", "auto"):
        yield Fault("coordinates", repr(scene.coordinates), "'tree', 'absolute' or 'auto'")
    for effect in scene.effects:
        yield from effect.type_faults()
    for joint in scene.mechanism.joints:
        where = f"joint {joint.name}"
        yield from _is(where, "parent", joint.parent.body, Body | Ground, "a Body, GROUND, or a point of one")
        yield from _is(where, "child", joint.child.body, Body | Ground, "a Body or a point of one")
        for point in (joint.parent, joint.child):
            yield from _point(where, point)
    for body in scene.mechanism.bodies:
        yield from _three(f"body {body.name}, mass centre", body.centre)
        if not (isinstance(body.shapes, tuple) and all(isinstance(shape, Shape) for shape in body.shapes)):
            yield Fault(f"body {body.name}, shapes", repr(body.shapes), "none, or those of Body.box(...) and its like")
        if isinstance(body.inertia, tuple):
            rows = (body.inertia, *body.inertia) if body.has_products else (body.inertia,)
            for row in rows:
                yield from _three(f"body {body.name}, inertia", row, "three principal values, or three rows of three")
    for pair in scene.mechanism.pairs:
        where = f"pair {pair.name}"
        for place in pair.places:
            yield from _is(where, "place", place, Point, "a point of a body: body.at(x, y, z)")
            if isinstance(place, Point):
                yield from _is(where, "body", place.body, Body | Ground, "a Body or GROUND")
                yield from _point(where, place)
        for label, values in pair.triples.items():
            yield from _three(f"{where}, {label}", values)
    for where, direction in directions(scene):
        yield from direction_faults(where, direction)


def _is(where: str, label: str, value: Any, kind: Any, expected: str) -> Iterator[Fault]:
    if not isinstance(value, kind):
        yield Fault(f"{where}, {label}", repr(value), expected)


def _point(where: str, point: Point) -> Iterator[Fault]:
    yield from _three(f"{where}, point", point.position)
    pairs = isinstance(point.turns, tuple) and all(isinstance(turn, tuple) and len(turn) == 2 for turn in point.turns)
    if not (pairs and all(isinstance(axis, Direction) for axis, _ in point.turns)):
        yield Fault(
            f"{where}, turns of a point", repr(point.turns), "none, or what `turned` gives: point.turned(axis, angle)"
        )


def _three(where: str, values: Any, expected: str = "three values, (x, y, z)") -> Iterator[Fault]:
    if not isinstance(values, tuple) or len(values) != 3:
        yield Fault(where, repr(values), expected)
