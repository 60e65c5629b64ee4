"""Results for inspection of a run: poses, landmarks, named quantities."""

from __future__ import annotations

from typing import Any

from hertzwerk.derive.declare.mechanism.joints.flexible_rod import FlexibleRod
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.motion.loop_closure import Closure
from hertzwerk.derive.program.program import Function, Result


def posed_names(mechanism: Mechanism) -> tuple[str, ...]:
    """Names of the bodies, then those of the sections of rods."""
    rods = (joint for joint in mechanism.tree if isinstance(joint, FlexibleRod))
    return (*(body.name for body in mechanism.bodies), *(body.name for rod in rods for _, body in rod.sections))


def poses(system: System) -> Function:
    """Positions and rotations of the bodies."""
    positions: list[Any] = []
    rotations: list[Any] = []
    names = posed_names(system.scene.mechanism)
    for body in system.scene.mechanism.bodies:
        positions.extend(system.kin.frame_origin(body))
        rotations.extend(entry for row in system.kin.rotation(body) for entry in row)
    for end in (link for link in system.kin.tree.links if link.kind == "bend"):
        for at, _ in end.rod.rod.sections:
            place, turned = system.kin.section(end, at)
            positions.extend(place)
            rotations.extend(entry for row in turned for entry in row)
    return system.function(
        "poses",
        "Origin of every body's frame (x, y, z after one another) and its rotation matrix (row by row), body by body.",
        "t q c",
        Result("positions", tuple(f"{n}.{k}" for n in names for k in "xyz"), ("m",) * len(positions), tuple(positions)),
        Result(
            "rotations",
            tuple(f"{n}.R_{i}{j}" for n in names for i in "xyz" for j in "xyz"),
            ("1",) * len(rotations),
            tuple(rotations),
        ),
    )


def landmarks(system: System) -> Function:
    """Points, directions and sizes for pictures."""
    return system.function(
        "landmarks",
        "Points, directions and sizes for pictures, row by row of LANDMARKS, along the axes of their bodies.",
        "p",
        *(landmark.result for landmark in system.landmarks),
    )


def outputs(system: System) -> Function:
    """Named quantities of pairs, force elements and loop-closing joints."""
    rows = output_rows(system)
    result = Result("y", tuple(n for n, _, _ in rows), tuple(u for _, u, _ in rows), tuple(e for _, _, e in rows))
    return system.function("outputs", "Named quantities, see OUTPUTS.", "t q u c", result)


def output_rows(system: System) -> list[tuple[str, str, Any]]:
    """Name, unit and expression of every named quantity."""
    of_pairs = [row for pair, _, _ in system.contacts for row in pair.touch.outputs()]
    of_pairs += [row for e in system.elements.values() for row in e.outputs]
    of_pairs += [(name, signal.unit, system.kin.inputs[name]) for name, signal in system.scene.inputs.items()]
    return of_pairs + _track_outputs(system) + ([] if system.joints is None else _joint_outputs(system))


def _track_outputs(system: System) -> list[tuple[str, str, Any]]:
    """Parameters of the curves of tracks, where their points are."""
    return [
        (f"{joint.name}.parameter", "1", Closure(system.kin, joint).on_curve(curve)[1].parameter)
        for joint in system.scene.mechanism.closures
        for curve in joint.curves
    ]


def _joint_outputs(system: System) -> list[tuple[str, str, Any]]:
    """Coordinates and speeds of loop-closing joints, where they are measurable."""
    joints = system.scene.mechanism.closures
    freedoms = [freedom for joint in joints for freedom in joint.freedoms if joint.measures(freedom)]
    rows = [
        (port, value)
        for freedom in freedoms
        for port, value in (
            (freedom.coordinates[0], system.kin.coordinate(freedom.key)),
            (freedom.speeds[0], system.kin.speed(freedom.key)),
        )
    ]
    return [(port.name, port.unit, value) for port, value in rows if value is not None]
