"""Planar joint."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import AXES, Direction, Frame, Point, Z
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.expressions.algebra.vectors import along


@dataclass(frozen=True, init=False)
class Planar(Joint):
    """Motion in a plane: two translations and the rotation about the `normal`, one of X, Y, Z.

    The translations, `x` and `y`, are along the two axes that follow the normal cyclically (for Z: X and Y); `angle`
    turns the first to the second.
    """

    normal: Direction
    absolute: ClassVar[bool] = True
    symbol: ClassVar[str] = "planar"

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, normal: Direction = Z) -> None:
        super().__init__(name, parent, child, normal=normal)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Both translations in the parent's axes, then the angle."""
        k = along(self.normal.unit) or 0
        return (self.slide(AXES[(k + 1) % 3], "x"), self.slide(AXES[(k + 2) % 3], "y"), self.turn(self.normal))

    def landmarks(self) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """Yield the points with the normal."""
        return self.landmarks_with("normal", self.normal, self.normal)

    def faults(self) -> Iterator[Fault]:
        """Yield the fault of a normal that is no coordinate axis."""
        if self.normal.points and along(self.normal.unit) is None:
            yield Fault(f"joint {self.name}", f"the normal {self.normal.components}", "X, Y, Z or the opposite of one",
                        "Turn the joint's points: parent.at(...).turned(axis, angle).")  # fmt: skip
