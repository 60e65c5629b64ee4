"""Scales of tolerances, and bounds of a run: speed limits of the laws, and the period."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.effect import State
from hertzwerk.derive.declare.effects.nonholonomic import RollingWithoutSlip
from hertzwerk.derive.declare.mechanism.joints.joint import Port
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.program.program import Function, Result


def scales(system: System) -> Function:
    """Scales of all quantities that have a tolerance."""
    scales = system.scene.scales
    length, speed = sp.sympify(scales.length), sp.sympify(scales.speed)
    mass = system.tape.let(system.scene.mechanism.total_mass, "total_mass")
    energy = system.tape.let(mass * speed**2 / 2, "energy_scale")
    force = system.tape.let(energy / length, "force_scale")
    q = coordinate_sizes(system.scene, system.coordinates)
    u = [scales.by_unit[port.unit] for port in system.speeds]
    sizes = {
        name: pair.bristle_size(friction)
        for pair, _, friction in system.contacts
        if friction is not None and friction.law.law.memory
        for name in system.bristles[friction.name]
    }
    names, units = tuple(name for name, _ in system.memory), tuple(unit for _, unit in system.memory)
    return system.function(
        "scales",
        "Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.",
        "p",
        system.of_coordinates("sq", q),
        system.of_speeds("su", u),
        Result("sz", names, units, tuple(sizes.get(name, energy) for name in names)),
        Result("s", ("length", "speed", "force", "energy"), ("m", "m/s", "N", "J"), (length, speed, force, energy)),
    )


def coordinate_sizes(scene: Scene, ports: list[Port]) -> list[Any]:
    """Scales of coordinates and states, in the order of their ports."""
    of_unit, states = scene.scales.by_unit, scene.states
    return [size_of(states[port.name], of_unit) if port.name in states else of_unit[port.unit] for port in ports]


def size_of(state: State, of_unit: Mapping[str, Any]) -> Any:
    """Scale of an effect's state: its own, or the scene's of its unit."""
    if state.size is not None:
        return sp.sympify(state.size)
    return sp.S.One if state.unit == "1" else of_unit[state.unit]


def speed_limits(system: System) -> Function:
    """Speeds up to which the compliant laws hold."""
    names, values = tuple(system.limited), tuple(system.limited.values())
    return system.function(
        "speed_limits",
        "Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.",
        "p",
        Result("limits", names, ("m/s",) * len(names), values),
    )


def yield_forces(system: System) -> Function:
    """Normal forces at which surfaces begin to yield."""
    names, values = tuple(system.yielding), tuple(system.yielding.values())
    return system.function(
        "yield_forces",
        "Normal force at which a surface of each of PAIRS begins to yield; 0 where its yield strength is not known.",
        "p",
        Result("forces", names, ("N",) * len(names), values),
    )


def rolling_limits(system: System) -> Function:
    """Coefficients of friction up to which surfaces roll without slip."""
    coefficients = {e.name: e.coefficient for e in system.scene.all(RollingWithoutSlip) if e.coefficient is not None}
    return system.function(
        "rolling_limits",
        "Coefficient of friction that keeps surfaces from slipping, where one is given, see ROLLING.",
        "p",
        Result(
            "limits", tuple(coefficients), ("1",) * len(coefficients), tuple(map(sp.sympify, coefficients.values()))
        ),
    )


def period(system: System) -> Function:
    """Common period of everything that depends on time."""
    summary = "Common period of everything that depends on time."
    return system.function("period", summary, "p", Result("period", ("period",), ("s",), (system.periodic,)))
