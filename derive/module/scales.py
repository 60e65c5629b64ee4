"""Scales of tolerances, and bounds of a run: speed limits of the laws, and the period."""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.declare.scene import Scene
from hertzwerk.derive.module.system import System
from hertzwerk.derive.program.program import Function, Result


def scales(system: System) -> Function:
    """Scales of all quantities that have a tolerance."""
    scales, of_unit = system.scene.scales, sizes_of(system.scene)
    length, speed = sp.sympify(scales.length), sp.sympify(scales.speed)
    mass = system.tape.let(sp.Add(*(sp.sympify(body.mass) for body in system.scene.mechanism.bodies)), "total_mass")
    energy = system.tape.let(mass * speed**2 / 2, "energy_scale")
    force = system.tape.let(energy / length, "force_scale")
    q = [of_unit[port.unit] for port in system.coordinates]
    u = [of_unit[port.unit] for port in system.speeds]
    sizes = {
        f"{friction.name}.bristle": pair.bristle_size(friction)
        for pair, _, friction in system.contacts
        if friction is not None and friction.law.law.memory
    }
    return system.function(
        "scales",
        "Scales of errors: of coordinates, speeds and memory; then of length, speed, force and energy.",
        "p",
        system.of_coordinates("sq", q),
        system.of_speeds("su", u),
        system.of_memory("sz", [sizes.get(name, energy) for name, _ in system.memory]),
        Result("s", ("length", "speed", "force", "energy"), ("m", "m/s", "N", "J"), (length, speed, force, energy)),
    )


def sizes_of(scene: Scene) -> dict[str, Any]:
    """Scales of coordinates and speeds, by unit."""
    scales = scene.scales
    length, speed = sp.sympify(scales.length), sp.sympify(scales.speed)
    if scales.arm is None:
        return {"m": length, "m/s": speed}
    # a quaternion moves by half the angle
    angles = {"rad": length / scales.arm, "rad/s": speed / scales.arm, "1": length / scales.arm / 2}
    return {"m": length, "m/s": speed, **angles}


def speed_limits(system: System) -> Function:
    """Speeds up to which the compliant laws hold."""
    names, values = tuple(system.limited), tuple(system.limited.values())
    return system.function(
        "speed_limits",
        "Approach speed 1e-5 sqrt(E/rho) up to which each compliant law holds, see SPEED_LIMITED.",
        "p",
        Result("limits", names, ("m/s",) * len(names), values),
    )


def period(system: System) -> Function:
    """Common period of everything that depends on time."""
    summary = "Common period of everything that depends on time."
    return system.function("period", summary, "p", Result("period", ("period",), ("s",), (system.periodic,)))
