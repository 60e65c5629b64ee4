"""Joint coordinates of a scene in absolute coordinates, in which its start is given."""

from __future__ import annotations

from functools import cached_property

from hertzwerk.derive.equations.module.labelled_results import ports_of
from hertzwerk.derive.equations.motion.absolute_coordinates import Absolute
from hertzwerk.derive.equations.motion.constraints import constraints_of
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.program.program import Tape


class Joints:
    """Kinematics of the declared scene in joint coordinates, on the tape of the absolute one."""

    def __init__(self, tape: Tape, absolute: Absolute) -> None:
        self.absolute = absolute
        self.scene = absolute.declared
        self.kin = Kinematics(tape, self.scene, ("joints", "joint_speeds", "joint_accelerations"))
        self.coordinates, self.speeds = ports_of(self.scene, self.kin)

    @cached_property
    def loops(self) -> tuple[Constraint, ...]:
        """Constraints of the declared scene: of loops and couplings."""
        return constraints_of(self.kin)
