"""Gaps and forces of the contact pairs."""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.contacts import Contact, Friction
from hertzwerk.derive.declare.effects.tribology.rolling_resistance import PairResistance
from hertzwerk.derive.equations.contact.contact_forces import Forces, PairKinematics
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.program.program import Function, Result


def gaps(system: System) -> Function:
    """Gaps, the event functions of contact, and their rates."""
    gaps = [pair.gap(contact) for pair, contact, _ in system.contacts]
    return system.function(
        "gaps",
        "Gap of every pair, positive while open, and its rate; at an onset the rate is minus the approach speed.",
        "t q u c",
        system.of_pairs("G", "m", [gap for gap, _, _ in gaps]),
        system.of_pairs("dG", "m/s", [rate for _, rate, _ in gaps]),
    )


def gap_accelerations(system: System) -> Function:
    """Second derivatives of the gaps."""
    values = [pair.gap(contact)[2] for pair, contact, _ in system.contacts]
    return system.function(
        "gap_accelerations", "Second derivative of every gap.", "t q u a c", system.of_pairs("ddG", "m/s^2", values)
    )


def contact(system: System, pair: PairKinematics, contact: Contact, friction: Friction | None) -> Function:
    """Forces of one pair."""
    bristles = {} if friction is None else system.bristles.get(friction.name, {})
    forces = pair.forces(contact, friction, system.latches.get(contact.name), tuple(bristles.values()))
    name = contact.name
    # a force between driven parts is asked for, though it moves none
    system.enter(name, forces.generalised, driven=True)
    if friction is not None:
        for rubbing in (forces.rubbing,) if forces.grip is None else forces.grip.along:
            system.enter(friction.name, rubbing, driven=True)
    for effect, moment in forces.resistances.items():
        system.enter(effect.name, moment.generalised, driven=True)
    for effect, turning in forces.turning.items():
        for axis in turning.along:
            system.enter(effect.name, axis, driven=True)
    by_row = {**forces.generalised, f"{name}.normal_force": forces.normal_force, **forces.wear}
    f = [by_row.get(row.key, sp.S.Zero) for row in system.rows]
    rates = {f"{name}.dissipated": forces.normal_power}
    rates |= {f"{effect.name}.dissipated": moment.power for effect, moment in forces.resistances.items()}
    if friction is not None:
        rates[f"{friction.name}.dissipated"] = forces.friction_power
    rates |= dict(zip(bristles, forces.bristle_rates, strict=True))
    if pair.touch.worn is not None:
        wear = pair.touch.worn.wear.name
        rates[f"{wear}.dissipated"] = forces.wear_power
        system.entered.add(wear)
    sliding = () if friction is None else (forces.sliding_velocity,) if forces.grip is None else forces.grip.velocity
    grip = _grips(system, name, friction, forces) if forces.grips else []
    parts = [contact.text, *([friction.law.law.name] if friction else [])]
    parts += [effect.text for effect in system.scene.resistances(name)]
    return system.function(
        f"contact_{name}",
        f"Forces of {name}: {', '.join(parts)}. "
        "The normal force is the laws' own, not clamped: where it would pull, the contact ends."
        + (" Friction comes on top: `along` times its force, which is that of slip or stick." if grip else "")
        + (" Along two tangents: `along` and `dz_along` of the one, then of the other." if len(sliding) > 1 else "")
        + (" Then of the moments of rolling and drilling, about their axes." if forces.turning else ""),
        "t q u z m c",
        system.of_rows("f", f),
        system.memory_rates([rates.get(entry, sp.S.Zero) for entry, _ in system.memory]),
        Result("normal_force", (name,), ("N",), (forces.normal_force,)),
        Result("sliding_velocity", (name,) * len(sliding), ("m/s",) * len(sliding), sliding),
        Result("in_range", (name,), ("1",), (forces.in_range,)),
        *grip,
    )


def _grips(system: System, name: str, friction: Friction | None, forces: Forces) -> list[Result]:
    """Results for friction and resistances with stick and slip.

    Per newton along each tangent, and per newton metre about each axis: generalised force and dissipated power; then
    the forces of slip and stick.
    """
    effects: list[Any] = [*([] if forces.grip is None else [friction]), *forces.turning]
    each = [
        (effect, grip, i) for effect, grip in zip(effects, forces.grips, strict=True) for i in range(len(grip.along))
    ]
    along = [grip.along[i].get(row.key, sp.S.Zero) for _, grip, i in each for row in system.rows]
    units = [_PER[_unit(effect)][unit] for effect, *_ in each for unit in system.row_units]
    power = [
        -grip.velocity[i] if entry == f"{effect.name}.dissipated" else sp.S.Zero
        for effect, grip, i in each
        for entry, _ in system.memory
    ]
    rates = [_PER[_unit(effect)][unit] for effect, *_ in each for _, unit in system.memory]
    whose = tuple(name if effect is friction else effect.name for effect in effects)
    limits = tuple(map(_unit, effects))
    pace = {"N": "m/s", "N m": "rad/s"}
    turning = [
        (effect.name, pace[effect.holds], part) for effect, grip in forces.turning.items() for part in grip.velocity
    ]
    labels, speeds, velocities = tuple(zip(*turning, strict=True)) if turning else ((), (), ())
    return [
        Result("along", tuple(row.key for row in system.rows) * len(each), tuple(units), tuple(along)),
        Result("dz_along", tuple(entry for entry, _ in system.memory) * len(each), tuple(rates), tuple(power)),
        Result("sliding_force", whose, limits, tuple(grip.sliding for grip in forces.grips)),
        Result("holding_force", whose, limits, tuple(grip.holding for grip in forces.grips)),
        *([Result("turning_velocity", labels, speeds, velocities)] if turning else []),
    ]


_PER = {
    "N": {"N": "1", "N m": "m", "J": "W/N", "m": "m/(s N)", "m/s": "m/(s N)", "W": "W/N"},
    "N m": {"N": "1/m", "N m": "1", "J": "rad/s", "m": "1/(s N)", "m/s": "1/(s N)", "W": "rad/s"},
}


def _unit(effect: object) -> str:
    """Unit of what a grip holds with."""
    return effect.holds if isinstance(effect, PairResistance) else "N"
