"""Belt or rope on a drum, with the friction of Euler and Eytelwein."""

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
    Kinematics,
    Mark,
    joint_faults,
    place_on_joint,
    together,
)
from hertzwerk.derive.declare.effects.state_expression import LOADS, Varying, shown
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot
from hertzwerk.derive.laws.law import BoundLaw, FrictionLaw, N, s


@dataclass(frozen=True)
class BeltOnDrum(Effect):
    """Belt, band or rope around a drum: one end is held, the other pulls at a load.

    It has no mass and does not stretch.

    With the slip v = radius (drum's speed) - (load's speed), load = tension exp(-law(v) wrap): law(v) is the coefficient
    of friction at that slip, mu tanh(v/v_s) for `smooth_coulomb`. Full slip has the ratio exp(mu wrap) of Euler (1769) and
    Eytelwein (1808), less slip less: the belt creeps.

    drum     revolute joint of the drum; "" for one that stands still
    load     prismatic joint of the load, whose travel is that of the belt, and for which the drum turns positively; ""
             where the other end is anchored: a band brake, whose load is the anchor's
    tension  of the held end [N], against the travel: an expression
    wrap     angle [rad]

    It acts by a torque on the drum's joint and a force along the load's: its pull on the drum's bearing is not in that
    joint's reaction. Heat is dissipated; input is what the held end puts in.
    """

    name: str
    drum: str
    load: str
    law: BoundLaw
    tension: Scalar
    radius: Scalar
    wrap: Scalar
    kind: ClassVar[str] = "belt"
    takes: ClassVar[Mapping[str, str]] = {"law": "friction"}
    measures: ClassVar[Mapping[str, Slot]] = {
        "tension": Varying.of("N", NOT_NEGATIVE, on=LOADS),
        "radius": Slot.of("m", POSITIVE),
        "wrap": Slot.of("rad", POSITIVE),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        ends = " and ".join(filter(None, (self.drum, self.load)))
        return f"belt on a drum, between {ends} and a tension {shown(self.tension)}, {self.law.law.name}"

    @property
    def joints(self) -> tuple[str, ...]:
        """Joints of drum and load."""
        return tuple(name for name in (self.drum, self.load) if name)

    def type_faults(self) -> Iterator[Fault]:
        """Yield faults of joints that are no names."""
        for role, joint in (("drum", self.drum), ("load", self.load)):
            if not isinstance(joint, str):
                yield Fault(self.where, f"{role} {joint!r:.60}", "the name of a joint, or ''")
        yield from super().type_faults()

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of the joints, and of a law that is not proportional to the normal force."""
        yield from super().faults(scene)
        if not self.joints:
            yield Fault(self.where, "neither drum nor load", "the joint of one of them at least")
        for name, kind, motion in ((self.drum, "turn", "the drum turns"), (self.load, "slide", "the load travels")):
            if name and name not in scene.scalars:
                yield from joint_faults(self.where, name, scene)
            elif name and scene.scalars[name].kind != kind:
                yield Fault(self.where, f"joint {name}, which has another freedom", f"a {kind}, by which {motion}")
        law = self.law.law
        if isinstance(law, FrictionLaw) and (law.needs_contact or law.definitions or (law.force / N).has(N)):
            yield Fault(self.where, f"law {law.name}", "a law of the slip that is proportional to the normal force",
                        "smooth_coulomb is; the belt's normal force varies around the drum.")  # fmt: skip

    def element(self, kin: Kinematics) -> Element:
        """Torque on the drum, force on the load, heat and input, and histories of slip and tensions."""
        tape, name, radius = kin.tape, self.name, sp.sympify(self.radius)
        rolls, moves = (kin.speed(joint) if joint else sp.S.Zero for joint in (self.drum, self.load))
        slip = tape.let(radius * rolls - moves, f"{name}_slip")
        held = tape.let(kin.expression(self.tension), f"{name}_tension")
        grip = (self.law.law.force / N).xreplace({**self.law.binding, s: slip})
        pulled = tape.let(held * sp.exp(-grip * sp.sympify(self.wrap)), f"{name}_load")
        drag = tape.let(held - pulled, f"{name}_drag")
        forces = together(
            kin.on_joint(self.drum, -radius * drag, name) if self.drum else {},
            kin.on_joint(self.load, -pulled, name) if self.load else {},
        )
        outputs: tuple[tuple[str, str, Any], ...] = ((f"{name}.slip", "m/s", slip),)
        if not tape.depends_on(held, "reactions"):
            outputs += ((f"{name}.tension", "N", held), (f"{name}.load", "N", pulled))
        return Element(forces, dissipated=drag * slip, input=-held * moves if self.load else None, outputs=outputs)

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the drum with its radius, and the load."""
        if self.drum:
            _, point, axis = place_on_joint(scene, self.drum)
            yield "belt", "drum", point, {"axis": axis, "radius": self.radius}
        if self.load:
            joint = scene.joint_of(self.load)
            yield "belt", "load", joint.child, {}
            if not self.drum:  # which stands where the load's joint does
                yield "belt", "drum", joint.parent, {"radius": self.radius}
