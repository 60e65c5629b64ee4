"""Results of functions, with a label and a unit for every entry."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from hertzwerk.derive.declare.mechanism.joints.joint import Port
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.equations.motion.loop_closure import Constraint
from hertzwerk.derive.program.program import Result

VALUE_UNITS = {"m/s": "m"}  # value of a constraint, by its unit, where that is another: it is zero
RATE_UNITS = {"m": "m/s", "1": "1/s", "m/s": "m/s"}  # its rate
SECOND_UNITS = {"m": "m/s^2", "1": "1/s^2", "m/s": "m/s^2"}  # its second derivative
MULTIPLIER_UNITS = {"m": "N", "1": "N m", "m/s": "N"}  # its multiplier


def ports_of(scene: Scene, kin: Kinematics) -> tuple[list[Port], list[Port]]:
    """Coordinates, including states of drives and effects, and speeds."""
    coordinates = [port for freedom in scene.free for port in freedom.coordinates]
    coordinates += [state.port for state in kin.drive_states]
    coordinates += [Port(name, state.unit) for name, state in scene.states.items()]
    return coordinates, [port for freedom in scene.free for port in freedom.speeds]


def vector(name: str, ports: list[Port], values: list[Any]) -> Result:
    """Result with one entry per port."""
    return Result(name, tuple(port.name for port in ports), tuple(port.unit for port in ports), tuple(values))


def of_loops(name: str, loops: tuple[Constraint, ...], values: list[Any], units: Mapping[str, str]) -> Result:
    """Result with one entry per constraint; `units` maps the constraint's unit to the entry's."""
    labels, of = tuple(row.name for row in loops), tuple(units.get(row.unit, row.unit) for row in loops)
    return Result(name, labels, of, tuple(values))
