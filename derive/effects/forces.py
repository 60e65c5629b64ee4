"""Forces and torques given by an expression of time, coordinates, speeds and parameters; and the forces of a potential.

What a force or torque does is booked as input, positive or negative. What a potential does is stored: it belongs to the energy.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.algebra.vectors import Vector, apply, dot
from hertzwerk.derive.effects.effect import INPUT, Declared, Effect, Element, JointEffect, Kinematics, Mark, axes_faults
from hertzwerk.derive.effects.expression import COORDINATE, Varying, as_choice, shown, states_in
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.mechanism.bodies import GROUND, Body, Frame, Point, Slot
from hertzwerk.derive.mechanism.parameter import Scalar, parameters_of

Components = tuple[Any, Any, Any]


@dataclass(frozen=True)
class JointForce(JointEffect):
    """A force [N] along a prismatic joint, or a torque [N m] about a revolute one, on its child; the parent feels the opposite."""

    name: str
    joint: str
    force: Scalar
    kind: ClassVar[str] = "force"
    drawn: ClassVar[bool] = True

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"force on {self.joint} = {shown(self.force)}"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """The force."""
        yield Varying(f"{self.where}, force", self.force, self.freedom(scene).units[2])

    def element(self, kin: Kinematics) -> Element:
        """The force, and its power put in."""
        force = kin.tape.let(kin.expression(self.force), f"{self.name}_force")
        return Element(kin.on_joint(self.joint, force, self.name), power=force * kin.speed(self.joint), booked=INPUT)


@dataclass(frozen=True)
class PointForce(Effect):
    """A force (x, y, z) [N] on a point of a body, its components along the axes of the frame `axes`; it comes from outside the mechanism."""

    name: str
    point: Point
    force: Components
    axes: Frame = GROUND
    kind: ClassVar[str] = "force"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"force on {self.point.body.name} = ({', '.join(map(shown, self.force))}) in axes of {self.axes.name}"

    @property
    def points(self) -> tuple[Point, ...]:
        """The one point."""
        return (self.point,)

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The body, and that whose axes are used."""
        return self.point.body, self.axes

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """The point and the three components."""
        yield from self.point.slots()
        for axis, value in zip("xyz", self.force, strict=True):
            yield Varying(f"{self.where}, force along {axis}", value, "N")

    def type_faults(self) -> Iterator[Fault]:
        """A force of other than three components, axes of no frame."""
        yield from super().type_faults()
        yield from axes_faults(self.where, self.axes, "force", self.force)

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """A force on the ground."""
        yield from super().faults(scene)
        if self.point.body == GROUND:
            yield Fault(self.where, "a force on the ground", "a force on a body")

    def element(self, kin: Kinematics) -> Element:
        """The force, and its power put in."""
        force = _resolved(self.force, self.axes, kin, f"{self.name}_force")
        position, velocity, _ = kin.point(self.point, f"{self.name}_point")
        forces = kin.generalised(force, position, self.point.body, GROUND, self.name)
        return Element(forces, power=dot(force, velocity), booked=INPUT)

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """The point, and the force where it depends on parameters alone."""
        yield "force", "point", self.point, {}
        yield from _constant("force", self.axes, self.force)


@dataclass(frozen=True)
class BodyTorque(Effect):
    """A torque (x, y, z) [N m] on a body, its components along the axes of the frame `axes`; it comes from outside the mechanism."""

    name: str
    body: Body
    torque: Components
    axes: Frame = GROUND
    kind: ClassVar[str] = "force"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"torque on {self.body.name} = ({', '.join(map(shown, self.torque))}) in axes of {self.axes.name}"

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The body, and that whose axes are used."""
        return self.body, self.axes

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """The three components."""
        for axis, value in zip("xyz", self.torque, strict=True):
            yield Varying(f"{self.where}, torque about {axis}", value, "N m")

    def type_faults(self) -> Iterator[Fault]:
        """No body, a torque of other than three components, axes of no frame."""
        if not isinstance(self.body, Body):
            yield Fault(self.where, repr(self.body), "a Body")
        yield from axes_faults(self.where, self.axes, "torque", self.torque)

    def element(self, kin: Kinematics) -> Element:
        """The torque, and its power put in."""
        torque = _resolved(self.torque, self.axes, kin, f"{self.name}_torque")
        forces = kin.generalised_moment(torque, self.body, GROUND, self.name)
        return Element(forces, power=dot(torque, kin.angular_velocity(self.body)), booked=INPUT)

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """The mass centre, and the torque where it depends on parameters alone."""
        yield "moment", "centre", Point(self.body, self.body.centre), {}
        yield from _constant("moment", self.axes, self.torque)


@dataclass(frozen=True)
class Potential(Effect):
    """Stored energy [J], an expression of coordinates; its forces are minus its derivatives, so the two cannot disagree."""

    name: str
    energy: Scalar
    kind: ClassVar[str] = "potential"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"forces of the energy {shown(self.energy)}"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """The energy."""
        yield Varying(f"{self.where}, energy", self.energy, "J", on=(COORDINATE,))

    def element(self, kin: Kinematics) -> Element:
        """Minus the derivatives of the energy, which is stored."""
        energy = as_choice(self.energy)
        forces: dict[str, Any] = {}
        for symbol in states_in(energy):
            joint = symbol.joint
            force = kin.tape.let(kin.expression(-sp.diff(energy, symbol)), f"{self.name}_on_{joint.replace('.', '_')}")
            for row, share in kin.on_joint(joint, force, self.name).items():
                forces[row] = forces.get(row, sp.S.Zero) + share
        return Element(forces, stored=kin.expression(energy))


def _resolved(components: Components, axes: Frame, kin: Kinematics, name: str) -> Vector:
    """Ground components of a vector given along the axes of a frame."""
    x, y, z = (kin.expression(value) for value in components)
    return kin.tape.vector(apply(kin.rotation(axes), (x, y, z)), name)


def _constant(kind: str, axes: Frame, components: Components) -> Iterator[Mark]:
    """A force or moment that depends on parameters alone: its components, along the axes of their frame."""
    values = tuple(sp.sympify(component) for component in components)
    if all(value.free_symbols <= set(parameters_of(value)) for value in values):
        yield kind, "axes", Point(axes), {kind: values}
