"""Friction of a joint, under its own reaction or a declared normal force."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.effect import (
    FRONT,
    RADIAL,
    REAR,
    Declared,
    Element,
    JointEffect,
    Kinematics,
    Rubbing,
)
from hertzwerk.derive.declare.effects.state_expression import LOADS, Varying
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot
from hertzwerk.derive.laws.law import BoundLaw, FrictionLaw, N, s


def drag_of(kin: Kinematics, name: str, bound: BoundLaw, normal: Any, sliding: Any) -> Any:
    """Friction force [N] of a law at a normal force [N] and a sliding velocity [m/s], on the tape."""
    law, values = bound.law, {**bound.binding, N: normal, s: sliding}
    for symbol, expression in law.definitions:
        values[symbol] = kin.tape.let(expression.xreplace(values), f"{name}_{symbol.name}")
    return kin.tape.let(law.force.xreplace(values), f"{name}_drag")


@dataclass(frozen=True)
class JointFriction(JointEffect):
    """Friction of a joint by a law, under its own reaction or a declared normal force.

    It slides with the speed of a slide, or `radius` (of the journal) times that of a turn. Without a normal force the
    joint's own reaction presses: of a turn the force across its axis; of a prismatic guide the forces on two pads,
    `length` apart about the child's point, that carry force and moment across its axis. The reaction depends on the
    accelerations, and these on the friction: they are solved together (`reaction_loads`).

    A set-valued law slides under a coefficient with a sign, and sticks by a force that keeps the joint at rest: both are
    given to the equations of motion by the run.
    """

    name: str
    joint: str
    law: BoundLaw
    normal_force: Scalar | None = None
    radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "joint_friction"
    takes: ClassVar[Mapping[str, str]] = {"law": "friction"}
    measures: ClassVar[Mapping[str, Slot]] = {
        "normal_force": Varying.of("N", NOT_NEGATIVE, on=LOADS),
        "radius": Slot.of("m", POSITIVE),
        "length": Slot.of("m", POSITIVE),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        pressed = "its own reaction" if self.normal_force is None else "a declared normal force"
        return f"{self.law.law.name} in {self.joint} under {pressed}"

    def reactions(self, scene: Declared) -> Iterator[str]:
        """Yield the joints that its normal force depends on: its own, where none is declared."""
        yield from super().reactions(scene)
        if self.normal_force is None:
            yield scene.joint_of(self.joint).name

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of the radius, and of a law that needs a contact."""
        yield from super().faults(scene)
        kind, law = self.freedom(scene).kind if self.joint in scene.scalars else "", self.law.law
        if kind and self.normal_force is None:
            yield from self._reaction_faults(scene, kind)
        elif self.length is not None:
            yield Fault(self.where, f"length {self.length}", "none, because the normal force is declared")
        if kind == "slide" and self.radius is not None:
            yield Fault(self.where, f"radius {self.radius}", "none, because a prismatic joint slides by its coordinate")
        if kind == "turn" and self.radius is None:
            yield Fault(self.where, "no radius", "the radius of the journal [m], which turns an angle into a way")
        if isinstance(law, FrictionLaw) and law.modes:
            yield from self._mode_faults(scene, law)
        elif isinstance(law, FrictionLaw) and law.needs_contact:
            yield Fault(self.where, f"law {law.name}, which needs a contact pair",
                        "a friction law that follows from sliding velocity and normal force",
                        "smooth_coulomb, stribeck and brown_mcphee do.")  # fmt: skip

    def _mode_faults(self, scene: Declared, law: FrictionLaw) -> Iterator[Fault]:
        """Yield faults of a set-valued law."""
        if any((force / N).has(N) for force in (law.sliding, law.holding)):
            yield Fault(self.where, f"law {law.name}, set-valued and other than proportional to the normal force",
                        "coulomb, or a smooth law")  # fmt: skip
        if self.joint in scene.driven:
            yield Fault(self.where, f"law {law.name}, set-valued, in {self.joint}, which is driven: at rest its force has no value",
                        "a law of the sliding velocity", "smooth_coulomb is one.")  # fmt: skip

    def _reaction_faults(self, scene: Declared, kind: str) -> Iterator[Fault]:
        """Yield faults of friction under a reaction."""
        joint, law = scene.joint_of(self.joint), self.law.law
        if kind == "turn" and self.length is not None:
            yield Fault(self.where, f"length {self.length}", "none, because a turn has no pads")
        if joint.name not in scene.carrying or (kind == "slide" and joint.turning):
            yield Fault(self.where, f"{self.joint} of {joint.name}, under its own reaction", "a turn, or the slide of a prismatic joint",
                        "Declare the normal force.")  # fmt: skip
        elif kind == "slide" and self.length is None:
            yield Fault(self.where, "neither length nor normal force", "the length of the guide between its two pads [m], "
                        "or a declared normal force")  # fmt: skip
        if isinstance(law, FrictionLaw) and not law.modes and sp.diff(law.force, N).has(N):
            yield Fault(self.where, f"law {law.name} under the joint's own reaction, on which it depends other than linearly",
                        "a law proportional to the normal force, but for viscous friction",
                        "smooth_coulomb and stribeck are; or declare the normal force.")  # fmt: skip

    def _pressing(self, kin: Kinematics) -> Any:
        """The normal force [N]."""
        if self.normal_force is not None:
            return kin.expression(self.normal_force)
        name = kin.scene.joint_of(self.joint).name
        if self.length is None:
            return kin.reaction(name, RADIAL)
        return kin.reaction(name, FRONT, self.length) + kin.reaction(name, REAR, self.length)

    def element(self, kin: Kinematics) -> Element:
        """Friction force at the sliding velocity, and the dissipated power."""
        arm = sp.S.One if self.radius is None else sp.sympify(self.radius)
        sliding = kin.tape.let(arm * kin.speed(self.joint), f"{self.name}_sliding_velocity")
        if isinstance(self.law.law, FrictionLaw) and self.law.law.modes:
            return self._set_valued(kin, self.law.law, arm, sliding)
        drag = drag_of(kin, self.name, self.law, self._pressing(kin), sliding)
        force = kin.tape.let(-arm * drag, f"{self.name}_force")
        return Element(kin.on_joint(self.joint, force, self.name), dissipated=drag * sliding)

    def _set_valued(self, kin: Kinematics, law: FrictionLaw, arm: Any, sliding: Any) -> Element:
        """Friction of a law that slides or sticks, along the joint's coordinate."""
        pressing = kin.tape.let(self._pressing(kin), f"{self.name}_pressing")
        coefficient, holding = kin.friction(self.name)
        drive = kin.tape.let(coefficient * pressing + holding, f"{self.name}_along")
        force = kin.tape.let(arm * drive, f"{self.name}_force")
        kinetic, static = (
            kin.tape.let((limit / N).xreplace(self.law.binding), f"{self.name}_{regime}")
            for limit, regime in ((law.sliding, "kinetic"), (law.holding, "static"))
        )
        rubbing = Rubbing(sliding, pressing, kinetic, static)
        return Element(kin.on_joint(self.joint, force, self.name), dissipated=-drive * sliding, rubbing=rubbing)
