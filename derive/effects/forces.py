"""Forces and torques given by an expression of time, coordinates, speeds and parameters; and the forces of a potential.

What a force or torque does is booked as input, positive or negative. What a potential does is stored: it belongs to the energy.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.effects.expression import COORDINATE, Varying, shown
from hertzwerk.derive.mechanism.bodies import GROUND, Body, Frame, Point, Slot
from hertzwerk.derive.mechanism.joints import Freedom
from hertzwerk.derive.mechanism.parameter import Scalar

Components = tuple[Any, Any, Any]


@dataclass(frozen=True)
class JointForce:
    """A force [N] along a prismatic joint, or a torque [N m] about a revolute one, on its child; the parent feels the opposite."""

    name: str
    joint: str
    force: Scalar
    kind: ClassVar[str] = "force"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"force on {self.joint} = {shown(self.force)}"

    def slots(self, freedom: Freedom) -> Iterator[Slot]:
        """The force."""
        yield Varying(f"effect {self.name}, force", self.force, freedom.units[2])


@dataclass(frozen=True)
class PointForce:
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

    def slots(self) -> Iterator[Slot]:
        """The point and the three components."""
        yield from self.point.slots()
        for axis, value in zip("xyz", self.force, strict=True):
            yield Varying(f"effect {self.name}, force along {axis}", value, "N")


@dataclass(frozen=True)
class BodyTorque:
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

    def slots(self) -> Iterator[Slot]:
        """The three components."""
        for axis, value in zip("xyz", self.torque, strict=True):
            yield Varying(f"effect {self.name}, torque about {axis}", value, "N m")


@dataclass(frozen=True)
class Potential:
    """Stored energy [J], an expression of coordinates; its forces are minus its derivatives, so the two cannot disagree."""

    name: str
    energy: Scalar
    kind: ClassVar[str] = "potential"

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return f"forces of the energy {shown(self.energy)}"

    def slots(self) -> Iterator[Slot]:
        """The energy."""
        yield Varying(f"effect {self.name}, energy", self.energy, "J", on=(COORDINATE,), derivatives=0)
