"""Initial state, and its conversion from joint to body coordinates."""

from __future__ import annotations

import sympy as sp

from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.module.joint_coordinates import Joints
from hertzwerk.derive.equations.module.labelled_results import vector
from hertzwerk.derive.equations.module.scale_functions import coordinate_sizes
from hertzwerk.derive.equations.motion.absolute_coordinates import placed
from hertzwerk.derive.program.program import Function


def start(system: System) -> Function:
    """Initial state, in joint coordinates."""
    of = system if system.joints is None else system.joints
    initial, free = of.scene.start, of.scene.free
    q = [sp.sympify(value) for freedom in free for value in initial.coordinates(freedom)]
    q += [state.start for state in of.kin.drive_states]
    q += [sp.sympify(state.start) for state in of.scene.states.values()]
    u = [sp.sympify(value) for freedom in free for value in initial.speeds(freedom)]
    return system.function(
        "start", "Coordinates and speeds at t = 0.", "p", vector("q", of.coordinates, q), vector("u", of.speeds, u)
    )


def joint_scales(system: System, joints: Joints) -> Function:
    """Scales of joint coordinates and speeds, for assembly at the start."""
    sizes = joints.scene.scales.by_unit
    return system.function(
        "joint_scales",
        "Scales of the joints' coordinates and speeds.",
        "p",
        vector("sq", joints.coordinates, coordinate_sizes(joints.scene, joints.coordinates)),
        vector("su", joints.speeds, [sizes[unit] for _, unit in joints.speeds]),
    )


def placed_bodies(system: System, joints: Joints) -> Function:
    """Body coordinates and speeds from those of the joints."""
    q, u = placed(joints.absolute, joints.kin, system.kin)
    return system.function(
        "placed",
        "Coordinates and speeds of the bodies, from those of the joints.",
        "t joints joint_speeds c",
        system.of_coordinates("q", q),
        system.of_speeds("u", u),
    )
