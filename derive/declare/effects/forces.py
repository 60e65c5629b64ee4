"""Forces and torques given by expressions, and forces of a potential.

Expressions of time, coordinates, speeds and parameters. The power of a force or torque is booked as input, positive
or negative. A potential is stored energy.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.effect import (
    Declared,
    Effect,
    Element,
    JointEffect,
    Kinematics,
    Mark,
    axes_faults,
    together,
)
from hertzwerk.derive.declare.effects.state_expression import COORDINATE, LOADS, Varying, as_choice, shown, states_in
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Frame, Point
from hertzwerk.derive.expressions.algebra.functions import slope
from hertzwerk.derive.expressions.algebra.vectors import Vector, apply, dot
from hertzwerk.derive.expressions.parameter import Scalar, Slot, parameters_of

Components = tuple[Any, Any, Any]


@dataclass(frozen=True)
class JointForce(JointEffect):
    """Force [N] along a prismatic joint, or torque [N m] about a revolute one.

    It acts on the child, its reaction on the parent.
    """

    name: str
    joint: str
    force: Scalar
    kind: ClassVar[str] = "force"
    drawn: ClassVar[bool] = True
    measures: ClassVar[Mapping[str, Slot]] = {"force": Varying.of("{force}", on=LOADS)}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"force on {self.joint} = {shown(self.force)}"

    def element(self, kin: Kinematics) -> Element:
        """Force, and its power as input."""
        force = kin.tape.let(kin.expression(self.force), f"{self.name}_force")
        return Element(kin.on_joint(self.joint, force, self.name), input=force * kin.speed(self.joint))


@dataclass(frozen=True)
class PointForce(Effect):
    """External force (x, y, z) [N] on a point of a body, in the axes of the frame `axes`."""

    name: str
    point: Point
    force: Components
    axes: Frame = GROUND
    kind: ClassVar[str] = "force"

    @property
    def text(self) -> str:
        """Description for people."""
        return f"force on {self.point.body.name} = ({', '.join(map(shown, self.force))}) in axes of {self.axes.name}"

    @property
    def points(self) -> tuple[Point, ...]:
        """The point of application."""
        return (self.point,)

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The body, and the frame of the components."""
        return self.point.body, self.axes

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the point and the three components."""
        yield from super().slots(scene)
        for axis, value in zip("xyz", self.force, strict=True):
            yield Varying(f"{self.where}, force along {axis}", value, "N", on=LOADS)

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of components and axes."""
        yield from super().type_faults()
        yield from axes_faults(self.where, self.axes, "force", self.force)

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield the fault of a force on the ground."""
        yield from super().faults(scene)
        if self.point.body == GROUND:
            yield Fault(self.where, "a force on the ground", "a force on a body")

    def element(self, kin: Kinematics) -> Element:
        """Force, and its power as input."""
        force = _resolved(self.force, self.axes, kin, f"{self.name}_force")
        position, velocity, _ = kin.point(self.point, f"{self.name}_point")
        forces = kin.generalised(force, position, self.point.body, GROUND, self.name)
        return Element(forces, input=dot(force, velocity))

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the point, and the force if it depends on parameters alone."""
        yield "force", "point", self.point, {}
        yield from _constant("force", self.axes, self.force)


@dataclass(frozen=True)
class BodyTorque(Effect):
    """External torque (x, y, z) [N m] on a body, in the axes of the frame `axes`."""

    name: str
    body: Body
    torque: Components
    axes: Frame = GROUND
    kind: ClassVar[str] = "force"

    @property
    def text(self) -> str:
        """Description for people."""
        return f"torque on {self.body.name} = ({', '.join(map(shown, self.torque))}) in axes of {self.axes.name}"

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The body, and the frame of the components."""
        return self.body, self.axes

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the three components."""
        for axis, value in zip("xyz", self.torque, strict=True):
            yield Varying(f"{self.where}, torque about {axis}", value, "N m", on=LOADS)

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of the body, components and axes."""
        if not isinstance(self.body, Body):
            yield Fault(self.where, repr(self.body), "a Body")
        yield from axes_faults(self.where, self.axes, "torque", self.torque)

    def element(self, kin: Kinematics) -> Element:
        """Torque, and its power as input."""
        torque = _resolved(self.torque, self.axes, kin, f"{self.name}_torque")
        forces = kin.generalised_moment(torque, self.body, GROUND, self.name)
        return Element(forces, input=dot(torque, kin.angular_velocity(self.body)))

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the mass centre, and the torque if it depends on parameters alone."""
        yield "moment", "centre", Point(self.body, self.body.centre), {}
        yield from _constant("moment", self.axes, self.torque)


@dataclass(frozen=True)
class Potential(Effect):
    """Stored energy [J], an expression of coordinates; its forces are minus its derivatives."""

    name: str
    energy: Scalar
    kind: ClassVar[str] = "potential"
    measures: ClassVar[Mapping[str, Slot]] = {"energy": Varying.of("J", on=(COORDINATE,))}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"forces of the energy {shown(self.energy)}"

    def element(self, kin: Kinematics) -> Element:
        """Forces, minus the derivatives of the energy, and the stored energy."""
        energy = as_choice(self.energy)
        shares = []
        for symbol in states_in(energy):
            joint = symbol.joint
            force = kin.tape.let(kin.expression(-slope(energy, symbol)), f"{self.name}_on_{joint.replace('.', '_')}")
            shares.append(kin.on_joint(joint, force, self.name))
        return Element(together(*shares), stored=kin.expression(energy))


def _resolved(components: Components, axes: Frame, kin: Kinematics, name: str) -> Vector:
    """Ground components of a vector given along the axes of a frame."""
    x, y, z = (kin.expression(value) for value in components)
    return kin.tape.vector(apply(kin.rotation(axes), (x, y, z)), name)


def _constant(kind: str, axes: Frame, components: Components) -> Iterator[Mark]:
    """Landmark of a force or moment that depends on parameters alone, along the axes of its frame."""
    values = tuple(sp.sympify(component) for component in components)
    if all(value.free_symbols <= set(parameters_of(value)) for value in values):
        yield kind, "axes", Point(axes), {kind: values}
