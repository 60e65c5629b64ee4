"""Joints with one axis: revolute, prismatic, cylindrical."""

from __future__ import annotations

from dataclasses import dataclass

from hertzwerk.derive.declare.mechanism.bodies import Direction, Frame, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint


@dataclass(frozen=True, init=False)
class Axial(Joint):
    """Joint with one axis."""

    axis: Direction

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, axis: Direction) -> None:
        super().__init__(name, parent, child, axis=axis)


class Revolute(Axial):
    """Rotation about `axis` by `angle`."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The angle."""
        return (self.turn(self.axis, alone=True),)


class Prismatic(Axial):
    """Translation along `axis` by `travel`; the child keeps the parent's orientation."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The travel."""
        return (self.slide(self.axis, alone=True),)


class Cylindrical(Axial):
    """Translation along `axis` by `travel` and rotation about it by `angle`."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Travel, then angle."""
        return (self.slide(self.axis), self.turn(self.axis))
