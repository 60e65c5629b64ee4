"""Joint without constraints."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from hertzwerk.derive.declare.mechanism.bodies import AXES, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint


class Free(Joint):
    """No constraint: position `x`, `y`, `z` of the child's point, orientation by a quaternion `q0`..`q3`.

    The position is in the parent's axes. Speeds are those of the point in the parent's axes, `x_speed`.., and the
    angular velocity in the child's, `angular_speed_x`..: with the point at the mass centre the mass matrix is then
    constant and diagonal.
    """

    absolute: ClassVar[bool] = True

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Three translations, then the orientation."""
        return (*(self.slide(axis, name) for axis, name in zip(AXES, "xyz", strict=True)), self.ball())

    def landmarks(self) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """No landmarks: a free joint is not drawn."""
        return iter(())
