"""Joints of one axis: hinge, slide, and both at once."""

from __future__ import annotations

from dataclasses import dataclass

from hertzwerk.derive.mechanism.bodies import Direction, Frame, Point
from hertzwerk.derive.mechanism.joints.joint import Freedom, Joint


@dataclass(frozen=True, init=False)
class Axial(Joint):
    """A joint of one axis."""

    axis: Direction

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, axis: Direction) -> None:
        super().__init__(name, parent, child, axis=axis)


class Revolute(Axial):
    """One rotation about `axis`: `angle`."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The angle."""
        return (self.turn(self.axis, alone=True),)


class Prismatic(Axial):
    """One translation along `axis`, `travel`; the child keeps the parent's orientation."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The travel."""
        return (self.slide(self.axis, alone=True),)


class Cylindrical(Axial):
    """A translation along `axis` and a rotation about it: `travel`, `angle`."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Travel, then angle."""
        return (self.slide(self.axis), self.turn(self.axis))
