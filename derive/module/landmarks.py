"""Landmarks: what a picture of a mechanism shows of its joints, pairs, force elements and bodies, fixed in the bodies and constant there.

Where they are follows from the poses of the bodies, so a run pays nothing for them. What a scene does not call for has none: a pair without
contact, a joint that forbids nothing, a body without mass.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import singledispatch
from typing import Any

import sympy as sp

from hertzwerk.derive.algebra.vectors import Vector, apply
from hertzwerk.derive.declare.scene import Gravity, Scene
from hertzwerk.derive.effects.forces import BodyTorque, PointForce
from hertzwerk.derive.effects.springs import PointDamper, PointSpring
from hertzwerk.derive.mechanism.bodies import GROUND, Direction, Frame, Point
from hertzwerk.derive.mechanism.joints import Freedom, Joint
from hertzwerk.derive.mechanism.mechanism import Mechanism
from hertzwerk.derive.mechanism.parameter import is_number, parameters_of
from hertzwerk.derive.program.program import Result

UNITS = {"axis": "1", "normal": "1", "along": "1", "force": "N", "moment": "N m", "radius": "m", "length": "m"}
"""Of what a landmark has beside its point."""
ON_JOINT = ("spring", "damper", "drive", "force")
"""Kinds of effects on a joint that a picture shows."""


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
        if hasattr(effect, "joint"):
            yield from _on_joint(effect, mechanism)
        else:
            yield from _of_effect(effect)
    for body in mechanism.bodies:
        if not (is_number(body.mass) and body.mass == 0):
            yield Landmark(body.name, "body", "centre", Point(body, body.centre))


def _in_body(point: Point, direction: Direction) -> Vector:
    """A direction given in a point's axes, in those of its body."""
    return apply(point.axes, direction.unit)


# -- joints ------------------------------------------------------------------------------------------------------------


def _on_joint(effect: Any, mechanism: Mechanism) -> Iterator[Landmark]:
    """Of a spring, damper, drive or force on a turn: its axis; on a slide: both points, and the axis."""
    if effect.kind not in ON_JOINT:
        return
    joint, freedom = _freedom(mechanism, effect.joint)
    if freedom.axis is None:
        return
    kind = f"{freedom.kind}_{effect.kind}"
    # the last axis is fixed in the child, as the first turn's and every slide's is in the parent
    last = freedom == joint.freedoms[-1]
    if freedom.kind == "turn":
        point, place = (joint.child, "child") if last else (joint.parent, "parent")
        yield Landmark(effect.name, kind, place, point, {"axis": _in_body(point, freedom.axis)})
        return
    yield Landmark(effect.name, kind, "parent", joint.parent, {"axis": _in_body(joint.parent, freedom.axis)})
    yield Landmark(effect.name, kind, "child", joint.child)


def _freedom(mechanism: Mechanism, key: str) -> tuple[Joint, Freedom]:
    freedoms = ((joint, freedom) for joint in mechanism.joints for freedom in joint.freedoms)
    return next(found for found in freedoms if found[1].key == key)


# -- effects that stand at points of their own -------------------------------------------------------------------------


@singledispatch
def _of_effect(effect: Any) -> Iterator[Landmark]:
    """None: of most effects there is nothing to see."""
    return iter(())


@_of_effect.register
def _(effect: PointSpring | PointDamper) -> Iterator[Landmark]:
    yield Landmark(effect.name, effect.kind, "first", effect.first)
    yield Landmark(effect.name, effect.kind, "second", effect.second)


@_of_effect.register
def _(effect: PointForce) -> Iterator[Landmark]:
    yield Landmark(effect.name, "force", "point", effect.point)
    yield from _constant(effect.name, "force", effect.axes, effect.force)


@_of_effect.register
def _(effect: BodyTorque) -> Iterator[Landmark]:
    yield Landmark(effect.name, "moment", "centre", Point(effect.body, effect.body.centre))
    yield from _constant(effect.name, "moment", effect.axes, effect.torque)


@_of_effect.register
def _(effect: Gravity) -> Iterator[Landmark]:
    yield Landmark(effect.name, "gravity", "direction", Point(GROUND), {"axis": effect.direction.unit})


def _constant(name: str, kind: str, axes: Frame, components: Any) -> Iterator[Landmark]:
    """Where a force or moment depends on parameters alone: its components, along the axes of their frame."""
    values = tuple(sp.sympify(component) for component in components)
    if all(value.free_symbols <= set(parameters_of(value)) for value in values):
        yield Landmark(name, kind, "axes", Point(axes), {kind: values})
