"""Landmarks: what a picture of a mechanism shows of its joints, pairs, force elements and bodies, fixed in the bodies and constant there.

Where they are follows from the poses of the bodies, so a run pays nothing for them. What a scene does not call for has none: a pair without
contact, a joint that forbids nothing, a body without mass.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.scene import Scene
from hertzwerk.derive.mechanism.bodies import Point
from hertzwerk.derive.mechanism.parameter import is_number
from hertzwerk.derive.program.program import Result

UNITS = {"axis": "1", "normal": "1", "along": "1", "force": "N", "moment": "N m", "radius": "m", "length": "m"}
"""Of what a landmark has beside its point."""


@dataclass(frozen=True)
class Landmark:
    """A point of a body or the ground, what it belongs to, and directions and sizes there.

    part    name of the joint, pair, effect or body
    kind    what that is: revolute, pin_in_bush, spring, turn_drive (an effect on a joint that turns), body
    place   which of its points this is: parent or child, pin or bush, first or second, centre
    beside  directions (three components along the body's axes) and sizes, named as in `UNITS`
    """

    part: str
    kind: str
    place: str
    point: Point
    beside: Mapping[str, Any] = field(default_factory=dict)

    @property
    def row(self) -> tuple[Any, ...]:
        """Of the table LANDMARKS: part, kind, place, body, names of what is beside the point."""
        return self.part, self.kind, self.place, self.point.body.name, tuple(self.beside)

    @property
    def result(self) -> Result:
        """The point's coordinates along its body's axes, then what is beside it."""
        rows = [(axis, "m", value) for axis, value in zip("xyz", self.point.position, strict=True)]
        for what, value in self.beside.items():
            if isinstance(value, tuple):
                rows += [(f"{what}_{axis}", UNITS[what], v) for axis, v in zip("xyz", value, strict=True)]
            else:
                rows.append((what, UNITS[what], value))
        labels, units, values = zip(*rows, strict=True)
        return Result(f"{self.part}.{self.place}", labels, units, tuple(map(sp.sympify, values)))


def landmarks_of(scene: Scene) -> Iterator[Landmark]:
    """Of the joints, of the pairs that contact is called for, of the effects, and of the bodies with mass, in declared order."""
    mechanism = scene.mechanism
    for joint in mechanism.joints:
        yield from (Landmark(joint.name, joint.symbol, *mark) for mark in joint.landmarks())
    for pair, _, _ in scene.contacts:
        yield from (Landmark(pair.name, pair.kind, *mark) for mark in pair.landmarks())
    for effect in scene.effects:
        yield from (Landmark(effect.name, *mark) for mark in effect.landmarks(scene))
    for body in mechanism.bodies:
        if not (is_number(body.mass) and body.mass == 0):
            yield Landmark(body.name, "body", "centre", Point(body, body.centre))
