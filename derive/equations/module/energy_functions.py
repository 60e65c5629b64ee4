"""Energy ledger (powers) and energies."""

from __future__ import annotations

import sympy as sp

from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.program.program import Function, Result


def ledger(system: System) -> Function:
    """Power of the drives and force elements."""
    power = [force * row.speed for force, row in zip(system.supplied, system.driven, strict=True)]
    rows = {
        f"{effect.name}.{quantity}": power
        for effect, e in system.elements.items()
        for quantity, power in e.powers.items()
    }
    if system.scene.ledger is not None:
        rows[f"{system.scene.ledger.name}.input"] = sp.Add(*power)
    values = [rows.get(name, sp.S.Zero) for name, _ in system.memory]
    return system.function(
        "ledger",
        f"Power put in by drives, in its row of z{'; put in and dissipated by force elements, in theirs' if len(rows) > 1 else ''}.",
        "t q u reactions c",
        system.memory_rates(values),
    )


def energy(system: System) -> Function:
    """Kinetic, potential and stored energy."""
    stored = [pair.elastic(contact)[1] for pair, contact, _ in system.contacts]
    kinetic = system.equations.kinetic()
    potential = sp.Add(system.equations.potential(), *(e.stored for e in system.elements.values()))
    return system.function(
        "energy",
        "Kinetic and potential energy, and the energy stored by each pair's stiffness.",
        "t q u c",
        Result("kinetic", ("kinetic",), ("J",), (kinetic,)),
        Result("potential", ("potential",), ("J",), (potential,)),
        system.of_pairs("stored", "J", stored),
    )
