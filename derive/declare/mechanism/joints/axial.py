"""Joints with one axis: revolute, prismatic, cylindrical."""

from __future__ import annotations

from dataclasses import dataclass

from hertzwerk.derive.declare.mechanism.bodies import Direction, Frame, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint


@dataclass(frozen=True, init=False)
class Revolute(Joint):
    """Rotation about `axis` by `angle`."""

    axis: Direction

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, axis: Direction) -> None:
        super().__init__(name, parent, child, axis=axis)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The angle."""
        return (self.turn(self.axis, alone=True),)


@dataclass(frozen=True, init=False)
class Prismatic(Joint):
    """Translation along `axis` by `travel`; the child keeps the parent's orientation."""

    axis: Direction

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, axis: Direction) -> None:
        super().__init__(name, parent, child, axis=axis)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The travel."""
        return (self.slide(self.axis, alone=True),)


@dataclass(frozen=True, init=False)
class Cylindrical(Joint):
    """Translation along `axis` by `travel` and rotation about it by `angle`."""

    axis: Direction

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, axis: Direction) -> None:
        super().__init__(name, parent, child, axis=axis)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Travel, then angle."""
        return (self.slide(self.axis), self.turn(self.axis))
