"""Rigid connection of two bodies."""

from __future__ import annotations

from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint


class Weld(Joint):
    """No freedom: the child is fixed to its parent."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """No freedoms."""
        return ()
