"""Constraints of the loops, and the projection of speeds onto them."""

from __future__ import annotations

from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.module.joint_coordinates import Joints
from hertzwerk.derive.equations.module.labelled_results import RATE_UNITS, VALUE_UNITS, of_loops
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.program.program import Function


def constraints(system: System) -> Function:
    """Loop constraints and their rates."""
    return _closed(system, "constraints", system.loops, "t q u c")


def joint_constraints(system: System, joints: Joints) -> Function:
    """Loop constraints of the declared scene, in joint coordinates."""
    return _closed(system, "joint_constraints", joints.loops, "t joints joint_speeds c")


def _closed(system: System, name: str, loops: tuple[Constraint, ...], arguments: str) -> Function:
    return system.function(
        name,
        "Constraints, zero while the loops are closed, and their rates.",
        arguments,
        of_loops("phi", loops, [row.value for row in loops], VALUE_UNITS),
        of_loops("dphi", loops, [row.rate for row in loops], RATE_UNITS),
    )


def projection(system: System) -> Function:
    """Change of speeds that gives the constraints wanted rates."""
    wanted = [
        system.tape.input(
            f"{row.name.replace('.', '_')}_wanted_rate", "wanted", Dimension.from_unit(RATE_UNITS[row.unit])
        )
        for row in system.loops
    ]
    return system.function(
        "projection",
        "Change of speeds, of least kinetic energy, for the wanted rates of the constraints, and their independence.",
        "t q wanted c",
        system.of_speeds("v", system.equations.projection(wanted)),
        of_loops("independence", system.loops, system.equations.independence(), dict.fromkeys(RATE_UNITS, "1")),
    )
