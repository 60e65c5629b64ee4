"""What is wrong with drives and force elements beyond their quantities: types, joints and bodies that are not there, what does not go together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from hertzwerk.derive.effects.drives import Drive, Ramp
from hertzwerk.derive.effects.forces import BodyTorque, PointForce
from hertzwerk.derive.effects.springs import JointFriction, PointDamper, PointSpring
from hertzwerk.derive.faults import Fault, one_of
from hertzwerk.derive.laws.law import FrictionLaw
from hertzwerk.derive.mechanism.bodies import GROUND, Body, Ground, Point
from hertzwerk.derive.mechanism.joints import Freedom
from hertzwerk.derive.mechanism.mechanism import Mechanism


def type_faults(effect: Any) -> Iterator[Fault]:
    """What has the wrong type, so that nothing else can be asked of it."""
    where = f"effect {effect.name}"
    if hasattr(effect, "joint") and not isinstance(effect.joint, str):
        yield Fault(where, f"joint {effect.joint!r}", "the name of a joint")
    points = (effect.point,) if isinstance(effect, PointForce) else effect.places if _has_ends(effect) else ()
    for point in points:
        if not isinstance(point, Point):
            yield Fault(where, repr(point), "a point of a body: body.at(x, y, z)")
        elif not isinstance(point.position, tuple) or len(point.position) != 3:
            yield Fault(where, f"point {point.position!r}", "three values, (x, y, z)")
    if isinstance(effect, BodyTorque) and not isinstance(effect.body, Body):
        yield Fault(where, repr(effect.body), "a Body")
    if isinstance(effect, PointForce | BodyTorque):
        what, components = ("force", effect.force) if isinstance(effect, PointForce) else ("torque", effect.torque)
        if not isinstance(components, tuple) or len(components) != 3:
            yield Fault(f"{where}, {what}", repr(components), "three values, (x, y, z)")
        if not isinstance(effect.axes, Body | Ground):
            yield Fault(f"{where}, axes", repr(effect.axes), "a Body or GROUND")
    if isinstance(effect, Ramp | Drive):
        yield from effect.faults()


def element_faults(effect: Any, mechanism: Mechanism) -> Iterator[Fault]:
    """What does not fit the mechanism."""
    where = f"effect {effect.name}"
    freedoms = {freedom.key: freedom for freedom in mechanism.freedoms if freedom.scalar}
    if hasattr(effect, "joint") and effect.joint not in freedoms:
        closing = effect.joint in [joint.name for joint in mechanism.closures]
        known = effect.joint in [joint.name for joint in mechanism.joints]
        why = ", which closes a loop" if closing else ", which has not just one coordinate" if known else ""
        way_out = (
            "The first joint to reach a body has the coordinates: declare this one before the others."
            if closing
            else ""
        )
        yield Fault(
            where,
            f"joint {effect.joint!r}{why}",
            one_of(freedoms, "a joint with one coordinate, of which the mechanism has none"),
            way_out,
        )
    for body in _bodies(effect):
        if body != GROUND and body not in mechanism.bodies:
            yield Fault(
                where,
                f"body {body.name}",
                f"{one_of([b.name for b in mechanism.bodies], 'a body of the mechanism')}, or the ground",
            )
    if isinstance(effect, PointForce) and effect.point.body == GROUND:
        yield Fault(where, "a force on the ground", "a force on a body")
    if _has_ends(effect) and effect.first.body == effect.second.body:
        yield Fault(where, f"both ends on {effect.first.body.name}", "points of two different bodies")
    if isinstance(effect, JointFriction):
        yield from _friction_faults(effect, freedoms.get(effect.joint))


def _friction_faults(effect: JointFriction, freedom: Freedom | None) -> Iterator[Fault]:
    where, law = f"effect {effect.name}", effect.law.law
    if freedom is not None and freedom.kind == "slide" and effect.radius is not None:
        yield Fault(where, f"radius {effect.radius}", "none, because a prismatic joint slides by its coordinate")
    if freedom is not None and freedom.kind == "turn" and effect.radius is None:
        yield Fault(where, "no radius", "the radius of the journal [m], which turns an angle into a way")
    if isinstance(law, FrictionLaw) and (law.modes or law.memory or law.geometry() or law.pairs):
        yield Fault(where, f"law {law.name}, which needs a contact pair", "a friction law that follows from sliding velocity and normal force",
                    "smooth_coulomb, stribeck and brown_mcphee do.")  # fmt: skip


def _has_ends(effect: Any) -> bool:
    return isinstance(effect, PointSpring | PointDamper)


def _bodies(effect: Any) -> list[Any]:
    if isinstance(effect, PointForce):
        return [effect.point.body, effect.axes]
    if isinstance(effect, BodyTorque):
        return [effect.body, effect.axes]
    return [point.body for point in effect.places] if _has_ends(effect) else []
