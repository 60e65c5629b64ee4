"""Friction of a joint under a declared normal force."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from hertzwerk.derive.effects.effect import Declared, Element, JointEffect, Kinematics
from hertzwerk.derive.effects.state_expression import Varying
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.laws.law import BoundLaw, FrictionLaw, N, s
from hertzwerk.derive.mechanism.bodies import Slot
from hertzwerk.derive.mechanism.parameter import NOT_NEGATIVE, POSITIVE, Scalar


@dataclass(frozen=True)
class JointFriction(JointEffect):
    """Friction of a joint by a law of its sliding velocity under a declared normal force.

    The sliding velocity is the speed of a prismatic joint, or `radius` (of the journal) times that of a revolute one.
    The normal force is an expression if need be (a preload, a weight); the joint's own reaction is not fed back. That
    neglects its variation with the motion, and keeps the accelerations explicit: a reaction depends on the
    accelerations, which depend on the friction.
    """

    name: str
    joint: str
    law: BoundLaw
    normal_force: Scalar
    radius: Scalar | None = None
    kind: ClassVar[str] = "joint_friction"
    takes: ClassVar[Mapping[str, str]] = {"law": "friction"}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"{self.law.law.name} in {self.joint} under a declared normal force"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the parameters of the law, the normal force, the radius."""
        yield from self.law.slots(self.where, {})
        yield Varying(f"{self.where}, normal force", self.normal_force, "N", NOT_NEGATIVE)
        if self.freedom(scene).kind == "turn" and self.radius is not None:
            yield Slot(f"{self.where}, radius", self.radius, "m", POSITIVE)

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of the radius, and of a law that needs a contact."""
        yield from super().faults(scene)
        kind, law = self.freedom(scene).kind if self.joint in scene.scalars else "", self.law.law
        if kind == "slide" and self.radius is not None:
            yield Fault(self.where, f"radius {self.radius}", "none, because a prismatic joint slides by its coordinate")
        if kind == "turn" and self.radius is None:
            yield Fault(self.where, "no radius", "the radius of the journal [m], which turns an angle into a way")
        if isinstance(law, FrictionLaw) and (law.modes or law.memory or law.geometry() or law.pairs):
            yield Fault(self.where, f"law {law.name}, which needs a contact pair",
                        "a friction law that follows from sliding velocity and normal force",
                        "smooth_coulomb, stribeck and brown_mcphee do.")  # fmt: skip

    def element(self, kin: Kinematics) -> Element:
        """Friction force at the sliding velocity, and the dissipated power."""
        arm = sp.S.One if self.radius is None else sp.sympify(self.radius)
        sliding = kin.tape.let(arm * kin.speed(self.joint), f"{self.name}_sliding_velocity")
        law, values = self.law.law, {**self.law.binding, N: kin.expression(self.normal_force), s: sliding}
        for symbol, expression in law.definitions:
            values[symbol] = kin.tape.let(expression.xreplace(values), f"{self.name}_{symbol.name}")
        drag = kin.tape.let(law.force.xreplace(values), f"{self.name}_drag")
        force = kin.tape.let(-arm * drag, f"{self.name}_force")
        return Element(kin.on_joint(self.joint, force, self.name), dissipated=drag * sliding)
