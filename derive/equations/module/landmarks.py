"""Landmarks: points, directions and sizes for pictures of joints, pairs, force elements and bodies.

They are constant in the bodies' frames. Their positions follow from the poses of the bodies, at no cost for a run. A
pair without contact, a joint without constraints, a body without mass have none.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.nonholonomic import RollingWithoutSlip
from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.declare.mechanism.curve import SolidCurve
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.expressions.parameter import is_number
from hertzwerk.derive.program.program import Result

UNITS = {
    "axis": "1",
    "normal": "1",
    "along": "1",
    "force": "N",
    "moment": "N m",
    "radius": "m",
    "length": "m",
    "hole_radius": "m",
    "size": "m",
    "across": "1",
}
"""Units of a landmark's directions and sizes."""


@dataclass(frozen=True)
class Landmark:
    """A point of a body or the ground, the part it belongs to, and directions and sizes there.

    part    name of the joint, pair, effect or body
    kind    kind of the part: revolute, pin_in_bush, spring, turn_drive (an effect on a joint that turns), body
    place   role of the point: parent or child, pin or bush, first or second, centre
    beside  directions (three components along the body's axes) and sizes, named as in `UNITS`
    """

    part: str
    kind: str
    place: str
    point: Point
    beside: Mapping[str, Any] = field(default_factory=dict)

    @property
    def row(self) -> tuple[Any, ...]:
        """Row of the table LANDMARKS: part, kind, place, body, names of directions and sizes."""
        return self.part, self.kind, self.place, self.point.body.name, tuple(self.beside)

    @property
    def result(self) -> Result:
        """Coordinates of the point along its body's axes, then directions and sizes."""
        rows = [(axis, "m", value) for axis, value in zip("xyz", self.point.position, strict=True)]
        for label, value in self.beside.items():
            if isinstance(value, SolidCurve):
                rows.append((label, "", value.drawn))
            elif isinstance(value, tuple):
                rows += [(f"{label}_{axis}", UNITS[label], v) for axis, v in zip("xyz", value, strict=True)]
            else:
                rows.append((label, UNITS[label], value))
        labels, units, values = zip(*rows, strict=True)
        return Result(f"{self.part}.{self.place}", labels, units, tuple(map(sp.sympify, values)))


def landmarks_of(scene: Scene) -> Iterator[Landmark]:
    """Yield landmarks of joints, pairs that touch or roll, effects, bodies with mass, in declared order."""
    mechanism = scene.mechanism
    for joint in mechanism.joints:
        yield from (Landmark(joint.name, joint.symbol, *mark) for mark in joint.landmarks())
    touching = {*scene.pressed, *(rolling.pair for rolling in scene.all(RollingWithoutSlip))}
    for pair in (pair for pair in mechanism.pairs if pair.name in touching):
        yield from (Landmark(pair.name, pair.kind, *mark) for mark in pair.landmarks())
    for effect in scene.effects:
        yield from (Landmark(effect.name, *mark) for mark in effect.landmarks(scene))
    for body in mechanism.bodies:
        carrier = [joint for joint in mechanism.joints if joint.bends and joint.parent.body == body]
        if not carrier and not (is_number(body.mass) and body.mass == 0):
            yield Landmark(body.name, "body", "centre", Point(body, body.centre))
    for body in mechanism.bodies:
        for number, shape in enumerate(body.shapes, 1):
            point, beside = shape.landmark()
            kind = f"{'hole' if shape.hole else 'solid'}_{shape.kind}"
            yield Landmark(body.name, kind, f"shape_{number}", Point(body, point), beside)
