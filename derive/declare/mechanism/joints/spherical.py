"""Spherical joint."""

from __future__ import annotations

from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint


class Spherical(Joint):
    """Any rotation about a common point.

    Unit quaternion `q0`..`q3`, angular velocity `angular_speed_x`.. in the child's axes.
    """

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The orientation."""
        return (self.ball(),)
