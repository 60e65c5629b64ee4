"""Friction of a ball joint under its own reaction."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault, one_of
from hertzwerk.derive.declare.effects.effect import Declared, Effect, Element, Kinematics
from hertzwerk.derive.declare.effects.tribology.joint_friction import drag_of
from hertzwerk.derive.declare.mechanism.joints.joint import Joint
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import dot, scale, sub
from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot
from hertzwerk.derive.laws.law import BoundLaw, FrictionLaw, N

AT_REST = sp.Rational(
    1, 10**9
)  # of the scene's speed: sliding that counts as this much, where the direction has no value


@dataclass(frozen=True)
class BallFriction(Effect):
    """Friction moment of a spherical joint, against its angular velocity w: radius times the law's force.

    The force is that of the sliding velocity radius |w| under the magnitude of the joint's reaction, which is solved with
    the accelerations (`reaction_loads`). The pressure is taken as met at the ball's equator about w.
    """

    name: str
    joint: str
    law: BoundLaw
    radius: Scalar
    kind: ClassVar[str] = "joint_friction"
    takes: ClassVar[Mapping[str, str]] = {"law": "friction"}
    measures: ClassVar[Mapping[str, Slot]] = {"radius": Slot.of("m", POSITIVE)}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"{self.law.law.name} in the ball joint {self.joint} under its own reaction"

    def reactions(self, scene: Declared) -> Iterator[str]:
        """Yield the joint."""
        yield self.joint

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of another joint, and of a law not linear in normal force and slip."""
        yield from super().faults(scene)
        balls = [joint.name for joint in scene.mechanism.joints if _is_ball(joint)]
        if self.joint not in balls:
            yield Fault(self.where, f"joint {self.joint!r}", one_of(balls, "a spherical joint, of which the mechanism has none"),
                        "A joint with an axis has JointFriction.")  # fmt: skip
        law = self.law.law
        if isinstance(law, FrictionLaw) and (law.needs_contact or sp.diff(law.force, N).has(N)):
            yield Fault(self.where, f"law {law.name}", "a law of the sliding velocity that is linear in the normal force",
                        "smooth_coulomb and stribeck are.")  # fmt: skip

    def element(self, kin: Kinematics) -> Element:
        """Friction moment, and the dissipated power."""
        joint = next(joint for joint in kin.scene.mechanism.joints if joint.name == self.joint)
        bodies, tape, radius = (joint.child.body, joint.parent.body), kin.tape, sp.sympify(self.radius)
        w = tape.vector(sub(*map(kin.angular_velocity, bodies)), f"{self.name}_spin")
        square = tape.let(dot(w, w), f"{self.name}_spin_squared")
        least = AT_REST * sp.sympify(kin.scene.scales.speed) / radius
        spin = tape.let(sp.sqrt(Where(square > least**2, square, least**2)), f"{self.name}_spin_size")
        sliding = tape.let(radius * spin, f"{self.name}_sliding_velocity")
        drag = drag_of(kin, self.name, self.law, kin.reaction(self.joint), sliding)
        per_speed = tape.let(radius * drag / spin, f"{self.name}_per_speed")
        forces = kin.generalised_moment(scale(-per_speed, w), *bodies, self.name)
        return Element(forces, dissipated=per_speed * square)


def _is_ball(joint: Joint) -> bool:
    return joint.turning == (None,) and not joint.sliding
