"""Absolute coordinates: every body has a joint of its own to the ground, and every joint is a loop.

The same derivation with another tree: the mass matrix is then block-diagonal, one block per body, and the cost of a
chain grows with its length. A body that no joint turns is not turned, and one whose whole motion is prescribed keeps
its driven joint; a plane mechanism remains plane.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.derive.declare.effects.state_expression import COORDINATE, SPEED, states_in
from hertzwerk.derive.declare.effects.tracking import uncounted_angles
from hertzwerk.derive.declare.mechanism.bodies import AXES, GROUND, Body, Frame, Point, Triple
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.vectors import Vector, apply, transpose
from hertzwerk.derive.expressions.parameter import Slot, default_value
from hertzwerk.derive.program.program import Tape


@dataclass(frozen=True, init=False)
class Base(Joint):
    """Joint of a body to the ground: translations of its mass centre, then, if it turns, a rotation.

    Translations along axes of the ground, `x`, `y`, `z`; an `angle` about `normal` or, without one, a quaternion.
    """

    slides: tuple[int, ...]
    turns: bool
    normal: int | None

    def __init__(self, name: str, parent: Point, child: Point, turns: bool, normal: int | None) -> None:
        slides = tuple(k for k in range(3) if k != normal)
        super().__init__(name, parent, child, slides=slides, turns=turns, normal=normal)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Translations, then the rotation."""
        slides = tuple(self.slide(AXES[k], "xyz"[k]) for k in self.slides)
        if not self.turns:
            return slides
        return (*slides, self.ball() if self.normal is None else self.turn(AXES[self.normal]))


@dataclass(frozen=True)
class Absolute(Scene):
    """A sound scene in absolute coordinates; `declared` is the scene it was made from.

    The start and the quantities are those of `declared`.
    """

    declared: Scene = field(kw_only=True)

    def __post_init__(self) -> None:
        """Skip the checks, which `declared` has passed."""

    def slots(self) -> Iterator[Slot]:
        """Yield every quantity of the scene, in declared order."""
        return self.declared.slots()

    @cached_property
    def scalars(self) -> dict[str, Freedom]:
        """Freedoms of the joints with one coordinate, which effects name."""
        return self.declared.scalars

    def follows_drives(self, body: Frame) -> bool:
        """Whether drives alone move a body, as declared."""
        return self.declared.follows_drives(body)


def absolute(scene: Scene) -> Absolute:
    """The scene in absolute coordinates; raises InputError, with every fault, where that is impossible."""
    mechanism, driven = scene.mechanism, scene.driven
    if not mechanism.tree:
        fault = Fault(
            "coordinates", "absolute ones of a mechanism without joints", "'tree': those that it was given with"
        )
        raise InputError(f"scene {scene.name} in absolute coordinates", [fault])
    carried: list[Joint] = []
    closing = list(mechanism.closures)
    unruled: list[Fault] = []
    still: list[Frame] = [GROUND]
    for joint in mechanism.tree:
        keys = [freedom.key for freedom in joint.freedoms]
        prescribed = joint.parent.body in still and all(key in driven for key in keys)
        at_ground = joint.parent.body == GROUND and not any(key in driven for key in keys)
        if prescribed:
            still.append(joint.child.body)
        guides = joint.name in scene.held and bool(joint.sliding)
        if prescribed or not joint.freedoms or joint.bends or (at_ground and (joint.absolute or guides)):
            carried.append(joint)
            continue
        carried.append(_base(mechanism, joint, guides))
        if guides and mechanism.plane is not None:
            unruled.append(
                Fault(f"joint {joint.name}", "a guide on a moving body, whose reaction is read, in plane motion",
                      "a guide on the ground: plane coordinates do not determine the force across the plane",
                      "Keep the joints' coordinates: coordinates='tree'.")
            )  # fmt: skip
        unruled += joint.unruled()
        if not unruled and joint.constraints():
            closing.append(joint)
    order = {joint.name: i for i, joint in enumerate(mechanism.joints)}
    closing.sort(key=lambda joint: order[joint.name])
    faults = unruled or [*_body_faults(scene, carried), *_effect_faults(scene, carried)]
    refuse(f"scene {scene.name} in absolute coordinates", dict.fromkeys(faults))
    values = {entry.name: getattr(scene, entry.name) for entry in fields(Scene)}
    values["mechanism"] = replace(mechanism, joints=(*carried, *closing))
    values["effects"] = (*scene.effects, *uncounted_angles(values["mechanism"], scene.effects, scene))
    return Absolute(**values, declared=scene)


def _base(mechanism: Mechanism, joint: Joint, held: bool) -> Base:
    """Joint of a body to the ground; held by a guide whose reaction is read, the body turns."""
    body = joint.child.body
    if not isinstance(body, Body):
        raise TypeError(f"joint {joint.name} moves the ground")
    taken = [other.name for other in mechanism.joints]
    name = body.name if body.name not in taken else f"{body.name}_base"
    turns, k = mechanism.turned_by(body) is not None or held, mechanism.plane
    if k is None:
        return Base(name, Point(GROUND), Point(body, body.centre), turns, None)
    centre = _with(body.centre, k, 0)
    return Base(name, Point(GROUND, _with((0, 0, 0), k, _height(mechanism, body, k))), Point(body, centre), turns, k)


def _with(triple: Triple, k: int, value: Any) -> Triple:
    """The triple with component k replaced."""
    x, y, z = (value if i == k else component for i, component in enumerate(triple))
    return (x, y, z)


def _height(mechanism: Mechanism, body: Frame, k: int) -> Any:
    """Coordinate of a body's origin normal to the plane of motion [m]."""
    joint = mechanism.joint_of(body)
    if joint is None:
        return sp.S.Zero
    return (
        _height(mechanism, joint.parent.body, k)
        + sp.sympify(joint.parent.position[k])
        - sp.sympify(joint.child.position[k])
    )


# -- faults ------------------------------------------------------------------------------------------------------------


def _body_faults(scene: Scene, carried: list[Joint]) -> Iterator[Fault]:
    """Faults of inertias and scales that rotations of bodies need.

    Inertias must not be zero, except the number 0 of a single body (`Equations.artificial_inertia`), and not be about one axis
    only.
    """
    remedy = "Give it one, or keep the joints' coordinates: coordinates='tree'."
    for joint in carried:
        body = joint.child.body
        if not isinstance(joint, Base) or not isinstance(body, Body) or not joint.turns:
            continue
        rigid = [body, *_welded_to(body, carried)]
        used = [each.moments if joint.normal is None else (each.moments[joint.normal],) for each in rigid]
        zero = any(value != 0 and default_value(value) == 0 for value in used[0])
        if zero or (len(rigid) > 1 and not any(all(default_value(value) != 0 for value in each) for each in used)):
            why = (
                ", zero at the defaults"
                if zero
                else f", and welded to it {', '.join(each.name for each in rigid[1:])}, without one about every axis"
            )
            yield Fault(f"body {body.name}, inertia", f"{body.inertia}{why}", "positive inertias, or of a body by itself the number 0, because the "
                        "body turns by coordinates of its own", remedy)  # fmt: skip
        elif (
            len(used[0]) == 3
            and not isinstance(body.inertia, tuple)
            and body.inertia != 0
            and _about_one_axis(scene.mechanism, body)
        ):
            yield Fault(f"body {body.name}, inertia", f"{body.inertia}, about the joint's axis alone", "three principal inertias, because the "
                        "body turns by coordinates of its own", remedy)  # fmt: skip
        if scene.scales.arm is None:
            yield Fault("scales", "no arm", "an arm [m], because the bodies' coordinates have angles",
                        "Scales(length=..., speed=..., arm=...): an angle is measured as length/arm.")  # fmt: skip


def _welded_to(body: Frame, carried: list[Joint]) -> list[Body]:
    """Bodies welded to a body, outwards."""
    tips = [joint.child.body for joint in carried if not joint.freedoms and joint.parent.body == body]
    return [each for tip in tips if isinstance(tip, Body) for each in (tip, *_welded_to(tip, carried))]


def _about_one_axis(mechanism: Mechanism, body: Frame) -> bool:
    """Whether the nearest joint that turns a body does so about one axis."""
    joint = mechanism.turned_by(body)
    return joint is not None and len(joint.turning) == 1 and joint.turning[0] is not None


def _effect_faults(scene: Scene, carried: list[Joint]) -> Iterator[Fault]:
    """Faults of effects on a joint's coordinate that is neither a coordinate of the scene nor measurable."""
    keys = [freedom.key for joint in carried for freedom in joint.freedoms]
    closing = {freedom.key: (joint, freedom) for joint in scene.mechanism.joints for freedom in joint.freedoms}
    remedy = "Keep the joints' coordinates: coordinates='tree'."
    for effect in scene.effects:
        symbols = (symbol for slot in effect.slots(scene) for symbol in states_in(slot.value))
        for key in [*(symbol.joint for symbol in symbols if symbol.quantity in (COORDINATE, SPEED)), *effect.joints]:
            if key in keys:
                continue
            joint, freedom = closing[key]
            where = f"effect {effect.name}"
            if not joint.measures(freedom):
                actual = f"{key}, of a {type(joint).__name__.lower()} joint"
                yield Fault(
                    where,
                    actual,
                    "a freedom that the poses of its bodies determine: the only turn, one of two that differ, a slide normal to its others",
                    remedy,
                )


# -- from the joints' coordinates --------------------------------------------------------------------------------------


def placed(scene: Absolute, joints: Kinematics, bodies: Kinematics) -> tuple[list[Any], list[Any]]:
    """Coordinates and speeds of the bodies from those of the joints.

    `joints` is the kinematics of the scene as declared.
    """
    q: list[Any] = []
    u: list[Any] = []
    links = {link.freedom.key: link for link in joints.tree.links if link.freedom is not None}
    for joint in scene.mechanism.tree:
        if isinstance(joint, Base):
            position, velocity, _ = joints.point(joint.child, f"{joint.name}_centre")
            q.extend(position[k] for k in joint.slides)
            u.extend(velocity[k] for k in joint.slides)
            if joint.turns:
                turned, spin = _turned(joint, joints)
                q.extend(turned)
                u.extend(spin)
            continue
        for freedom in joint.freedoms:
            if freedom.key not in scene.driven:
                q.extend(links[freedom.key].coordinates)
                u.extend(row.speed for row in links[freedom.key].rows)
    counted = {state: key for key, state in bodies.counted.items()}
    integrated = {state.port: state.symbol for state in joints.drive_states}
    q.extend(integrated[state.port] for state in bodies.drive_states)
    q.extend(joints.effect_states[name] if name in joints.effect_states else joints.coordinate(counted[state])
             for name, state in bodies.effect_states.items())  # fmt: skip
    return q, u


def _turned(joint: Base, joints: Kinematics) -> tuple[list[Any], list[Any]]:
    """Orientation of a body, and its angular velocity in its own axes."""
    body = joint.child.body
    rate = joints.motion(body).angular_velocity
    if joint.normal is not None:
        return [joints.turned(body, joint.normal)], [rate[joint.normal]]
    return list(quaternion_of(joints, body)), list(apply(transpose(joints.rotation(body)), rate))


Quaternion = tuple[Any, ...]
"""q0 + q1 i + q2 j + q3 k."""


def quaternion_of(kin: Kinematics, body: Frame) -> Quaternion:
    """Quaternion from a body's axes to the ground's, multiplied along its joints without a branch."""
    joint = kin.mechanism.joint_of(body)
    if joint is None:
        return (sp.S.One, sp.S.Zero, sp.S.Zero, sp.S.Zero)
    total = quaternion_of(kin, joint.parent.body)
    steps = [_of_turn(axis.unit, angle) for axis, angle in joint.parent.turns]
    for link in kin.tree.links:
        if link.joint is joint and link.kind == "bend":
            steps += [_of_turn(axis, angle) for axis, angle in link.rod.angles]
        elif link.joint is joint and link.freedom is not None and link.kind != "slide":
            axis = link.freedom.axis
            steps.append(link.coordinates if axis is None else _of_turn(axis.unit, link.coordinates[0]))
    steps += [_of_turn(axis.unit, -sp.sympify(angle)) for axis, angle in reversed(joint.child.turns)]
    for step in steps:
        total = tuple(kin.tape.let(part, f"{body.name}_q{i}") for i, part in enumerate(_times(total, step)))
    return total


def turned(body: Quaternion, point: Point) -> Quaternion:
    """Quaternion from a point's axes to the ground's, by that of its body."""
    for axis, angle in point.turns:
        body = _times(body, _of_turn(axis.unit, angle))
    return body


def between(one: Quaternion, two: Quaternion, tape: Tape, name: str) -> Quaternion:
    """Quaternion from the axes of `two` to those of `one`, named on the tape."""
    back = (one[0], *(-part for part in one[1:]))
    return tuple(tape.let(part, f"{name}_q{i}") for i, part in enumerate(_times(back, two)))


def _of_turn(axis: Vector, angle: Any) -> Quaternion:
    half = sp.sympify(angle) / 2
    return (sp.cos(half), axis[0] * sp.sin(half), axis[1] * sp.sin(half), axis[2] * sp.sin(half))


def _times(a: Quaternion, b: Quaternion) -> Quaternion:
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )
