"""Universal (Cardan) joint."""

from __future__ import annotations

from dataclasses import dataclass

from hertzwerk.derive.declare.mechanism.bodies import Direction, Frame, Point, X, Y
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint


@dataclass(frozen=True, init=False)
class Universal(Joint):
    """Rotation `angle_1` about `first`, fixed in the parent, then `angle_2` about `second`, in the child.

    The axes need not be perpendicular.
    """

    first: Direction
    second: Direction

    def __init__(
        self, name: str, parent: Frame | Point, child: Frame | Point, first: Direction = X, second: Direction = Y
    ) -> None:
        super().__init__(name, parent, child, first=first, second=second)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The two angles."""
        return (self.turn(self.first, "angle_1"), self.turn(self.second, "angle_2"))
