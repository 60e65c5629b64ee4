"""Force elements on the tape: what each effect that is no contact, gravity or drive does to a mechanism.

Every element gives generalised forces by joint; beside them the energy it stores, the power it dissipates or puts in, and named outputs.
A new kind of effect is a record with `name`, `kind`, `text` and `slots`, and its `element`, registered here: nothing else knows of it.
"""

from __future__ import annotations

from functools import singledispatch
from typing import Any

import sympy as sp

from hertzwerk.derive.algebra.functions import Where
from hertzwerk.derive.algebra.vectors import Vector, apply, dot, scale, sub
from hertzwerk.derive.declare.scene import Scene
from hertzwerk.derive.effects.element import INPUT, Element
from hertzwerk.derive.effects.expression import as_choice, states_in
from hertzwerk.derive.effects.film import film
from hertzwerk.derive.effects.forces import BodyTorque, JointForce, PointForce, Potential
from hertzwerk.derive.effects.lubrication import Lubrication
from hertzwerk.derive.effects.springs import JointDamper, JointFriction, JointSpring, PointDamper, PointSpring
from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.derive.laws.law import N, s
from hertzwerk.derive.mechanism.bodies import GROUND, Frame
from hertzwerk.derive.motion.kinematics import Kinematics

BUILT_IN = ("contact", "friction", "gravity", "drive", "ledger")
"""Kinds of effects that are no elements."""


@singledispatch
def element(effect: Any, kin: Kinematics, scene: Scene) -> Element | None:
    """What an effect of the scene does; None for a contact, gravity, a drive or the ledger. Raises InputError for a kind without one."""
    if effect.kind in BUILT_IN:
        return None
    found = f"the kind {effect.kind!r}, which has no element"
    raise InputError(f"scene {scene.name}", [Fault(f"effect {effect.name}", found, "one that says what it does",
                     f"@element.register on a function of ({type(effect).__name__}, kinematics, scene) that gives an Element.")])  # fmt: skip


@element.register
def _(effect: JointForce, kin: Kinematics, scene: Scene) -> Element:
    force = kin.tape.let(kin.expression(effect.force), f"{effect.name}_force")
    return Element(kin.on_joint(effect.joint, force, effect.name), power=force * kin.speed(effect.joint), booked=INPUT)


@element.register
def _(effect: PointForce, kin: Kinematics, scene: Scene) -> Element:
    force = _resolved(effect.force, effect.axes, kin, f"{effect.name}_force")
    position, velocity, _ = kin.point(effect.point, f"{effect.name}_point")
    forces = kin.generalised(force, position, effect.point.body, GROUND, effect.name)
    return Element(forces, power=dot(force, velocity), booked=INPUT)


@element.register
def _(effect: BodyTorque, kin: Kinematics, scene: Scene) -> Element:
    torque = _resolved(effect.torque, effect.axes, kin, f"{effect.name}_torque")
    forces = kin.generalised_moment(torque, effect.body, GROUND, effect.name)
    return Element(forces, power=dot(torque, kin.motion(effect.body).angular_velocity), booked=INPUT)


@element.register
def _(effect: Potential, kin: Kinematics, scene: Scene) -> Element:
    energy = as_choice(effect.energy)
    forces: dict[str, Any] = {}
    for symbol in states_in(energy):
        force = kin.tape.let(
            kin.expression(-sp.diff(energy, symbol)), f"{effect.name}_on_{symbol.joint.replace('.', '_')}"
        )
        for row, share in kin.on_joint(symbol.joint, force, effect.name).items():
            forces[row] = forces.get(row, sp.S.Zero) + share
    return Element(forces, stored=kin.expression(energy))


@element.register
def _(effect: JointSpring, kin: Kinematics, scene: Scene) -> Element:
    stretch = kin.tape.let(kin.coordinate(effect.joint) - sp.sympify(effect.rest), f"{effect.name}_stretch")
    force = kin.tape.let(-sp.sympify(effect.stiffness) * stretch, f"{effect.name}_force")
    return Element(kin.on_joint(effect.joint, force, effect.name), stored=sp.sympify(effect.stiffness) * stretch**2 / 2)


@element.register
def _(effect: JointDamper, kin: Kinematics, scene: Scene) -> Element:
    speed = kin.speed(effect.joint)
    force = kin.tape.let(-sp.sympify(effect.damping) * speed, f"{effect.name}_force")
    return Element(kin.on_joint(effect.joint, force, effect.name), power=-force * speed)


@element.register
def _(effect: PointSpring, kin: Kinematics, scene: Scene) -> Element:
    between, _ = _line(effect, kin)
    stiffness = sp.sympify(effect.stiffness)
    squared = kin.tape.let(dot(between, between), f"{effect.name}_squared")
    if effect.rest_length is None:
        return Element(_pulled(effect, kin, stiffness, between), stored=stiffness * squared / 2)
    rest = sp.sympify(effect.rest_length)
    # where the ends coincide the length counts as the rest length: nothing is divided by zero, in the derivatives either
    reach = kin.tape.let(sp.sqrt(Where(squared > 0, squared, rest**2)), f"{effect.name}_length")
    tension = kin.tape.let(stiffness * (1 - rest / reach), f"{effect.name}_per_length")
    return Element(_pulled(effect, kin, tension, between), stored=stiffness * (sp.sqrt(squared) - rest) ** 2 / 2)


@element.register
def _(effect: PointDamper, kin: Kinematics, scene: Scene) -> Element:
    between, rate = _line(effect, kin)
    squared = kin.tape.let(dot(between, between), f"{effect.name}_squared")
    along = kin.tape.let(dot(between, rate), f"{effect.name}_along")
    nonzero = Where(squared > 0, squared, sp.sympify(scene.scales.length) ** 2)
    drag = kin.tape.let(sp.sympify(effect.damping) * along / nonzero, f"{effect.name}_per_length")
    return Element(_pulled(effect, kin, drag, between), power=drag * along)


@element.register
def _(effect: JointFriction, kin: Kinematics, scene: Scene) -> Element:
    arm = sp.S.One if effect.radius is None else sp.sympify(effect.radius)
    sliding = kin.tape.let(arm * kin.speed(effect.joint), f"{effect.name}_sliding_velocity")
    law, values = effect.law.law, {**effect.law.binding, N: kin.expression(effect.normal_force), s: sliding}
    for symbol, expression in law.definitions:
        values[symbol] = kin.tape.let(expression.xreplace(values), f"{effect.name}_{symbol.name}")
    drag = kin.tape.let(law.force.xreplace(values), f"{effect.name}_drag")
    force = kin.tape.let(-arm * drag, f"{effect.name}_force")
    return Element(kin.on_joint(effect.joint, force, effect.name), power=drag * sliding)


@element.register
def _(effect: Lubrication, kin: Kinematics, scene: Scene) -> Element:
    return film(effect, kin, scene)


def _resolved(components: Any, axes: Frame, kin: Kinematics, name: str) -> Vector:
    """Ground components of a vector given along the axes of a frame."""
    x, y, z = (kin.expression(value) for value in components)
    return kin.tape.vector(apply(kin.rotation(axes), (x, y, z)), name)


def _line(effect: PointSpring | PointDamper, kin: Kinematics) -> tuple[Vector, Vector]:
    """From the first end to the second [m], and its rate [m/s]."""
    one, one_rate, _ = kin.point(effect.first, f"{effect.name}_first")
    two, two_rate, _ = kin.point(effect.second, f"{effect.name}_second")
    between = kin.tape.vector(sub(two, one), f"{effect.name}_between")
    return between, kin.tape.vector(sub(two_rate, one_rate), f"{effect.name}_rate")


def _pulled(effect: PointSpring | PointDamper, kin: Kinematics, tension: Any, between: Vector) -> dict[str, Any]:
    """Generalised forces of a tension [N/m] times the vector between the ends, which pulls them together."""
    force = kin.tape.vector(scale(tension, between), f"{effect.name}_force")
    position, _, _ = kin.point(effect.first, f"{effect.name}_first")
    return kin.generalised(force, position, effect.first.body, effect.second.body, effect.name)
