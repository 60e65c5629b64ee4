"""The joint of two bodies that are one."""

from __future__ import annotations

from hertzwerk.derive.mechanism.joints.joint import Freedom, Joint


class Weld(Joint):
    """No freedom: the child is part of its parent."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """None."""
        return ()
