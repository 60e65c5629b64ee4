"""Linear springs and dampers, on a joint's coordinate or between two points; friction of a joint under a declared load."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from hertzwerk.derive.effects.expression import Varying
from hertzwerk.derive.laws.law import BoundLaw
from hertzwerk.derive.mechanism.bodies import Point, Slot
from hertzwerk.derive.mechanism.joints import Freedom
from hertzwerk.derive.mechanism.parameter import NOT_NEGATIVE, POSITIVE, Scalar


@dataclass(frozen=True)
class JointSpring:
    """A spring on a joint's coordinate, k (q - rest) [N/m, or N m per rad], torsional on a revolute joint."""

    name: str
    joint: str
    stiffness: Scalar
    rest: Scalar = 0
    kind: ClassVar[str] = "spring"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"linear spring of {self.joint}"

    def slots(self, freedom: Freedom) -> Iterator[Slot]:
        """Stiffness, and the coordinate at which it is at rest."""
        yield Slot(f"effect {self.name}, stiffness", self.stiffness, _per(freedom, freedom.units[0]), NOT_NEGATIVE)
        yield Slot(f"effect {self.name}, rest", self.rest, freedom.units[0])


@dataclass(frozen=True)
class JointDamper:
    """Viscous friction of a joint, c q' [N s/m, or N m s per rad]."""

    name: str
    joint: str
    damping: Scalar
    kind: ClassVar[str] = "damper"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"viscous damper of {self.joint}"

    def slots(self, freedom: Freedom) -> Iterator[Slot]:
        """The coefficient."""
        yield Slot(f"effect {self.name}, damping", self.damping, _per(freedom, freedom.units[1]), NOT_NEGATIVE)


@dataclass(frozen=True)
class PointSpring:
    """A spring between two points, k (distance - rest length) along the line through them; without a rest length it needs no direction.

    Where the points coincide the direction of a spring with a rest length is undefined, and it pulls nowhere.
    """

    name: str
    first: Point
    second: Point
    stiffness: Scalar
    rest_length: Scalar | None = None
    kind: ClassVar[str] = "spring"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"linear spring between {self.first.body.name} and {self.second.body.name}"

    @property
    def places(self) -> tuple[Point, Point]:
        """Both ends."""
        return self.first, self.second

    def slots(self) -> Iterator[Slot]:
        """Points, stiffness, rest length."""
        yield from self.first.slots()
        yield from self.second.slots()
        yield Slot(f"effect {self.name}, stiffness", self.stiffness, "N/m", NOT_NEGATIVE)
        if self.rest_length is not None:
            yield Slot(f"effect {self.name}, rest length", self.rest_length, "m", POSITIVE)


@dataclass(frozen=True)
class PointDamper:
    """A damper between two points, c times the rate of their distance, along the line through them; no force where they coincide."""

    name: str
    first: Point
    second: Point
    damping: Scalar
    kind: ClassVar[str] = "damper"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"viscous damper between {self.first.body.name} and {self.second.body.name}"

    @property
    def places(self) -> tuple[Point, Point]:
        """Both ends."""
        return self.first, self.second

    def slots(self) -> Iterator[Slot]:
        """Points and coefficient."""
        yield from self.first.slots()
        yield from self.second.slots()
        yield Slot(f"effect {self.name}, damping", self.damping, "N s/m", NOT_NEGATIVE)


@dataclass(frozen=True)
class JointFriction:
    """Friction of a joint by a law of its sliding velocity: of a prismatic joint its speed, of a revolute one `radius` (of the journal) times it.

    The normal force is declared, an expression if need be (a preload, a weight); the joint's own reaction is not fed back. That neglects how
    the load varies with the motion, and keeps the accelerations explicit: a reaction depends on the accelerations, which depend on the friction.
    """

    name: str
    joint: str
    law: BoundLaw
    normal_force: Scalar
    radius: Scalar | None = None
    kind: ClassVar[str] = "joint_friction"
    takes: ClassVar[str] = "friction"
    unchecked: ClassVar[bool] = False

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"{self.law.law.name} in {self.joint} under a declared normal force"

    @property
    def laws(self) -> tuple[BoundLaw, ...]:
        """The one law."""
        return (self.law,)

    def slots(self, freedom: Freedom) -> Iterator[Slot]:
        """The parameters of the law, the normal force, the radius."""
        yield from self.law.slots(f"effect {self.name}", {})
        yield Varying(f"effect {self.name}, normal force", self.normal_force, "N", NOT_NEGATIVE)
        if freedom.kind == "turn" and self.radius is not None:
            yield Slot(f"effect {self.name}, radius", self.radius, "m", POSITIVE)


def _per(freedom: Freedom, unit: str) -> str:
    return f"{freedom.units[2]}/({unit})"
