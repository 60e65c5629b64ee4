"""Loads of an imported model: generalised forces, and the power that they put in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.effect import Declared, Effect, Element
from hertzwerk.derive.declare.effects.energy_ledger import EnergyLedger
from hertzwerk.derive.declare.effects.state_expression import COORDINATE, Varying
from hertzwerk.derive.exchange.sympy_models.mechanism_by_expressions import MechanismByExpressions
from hertzwerk.derive.expressions.parameter import Slot


@dataclass(frozen=True)
class Loads(Effect):
    """Generalised forces of loads, each with its row and unit, and the potential energy of some.

    Their power is booked as input, but for what changes that energy.
    """

    name: str
    forces: tuple[tuple[str, str, Any], ...]
    stored: Any = sp.S.Zero
    kind: ClassVar[str] = "loads"

    @property
    def text(self) -> str:
        """Description for people."""
        return "loads of the imported model"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the generalised forces and the energy."""
        yield from (Varying(f"{self.where}, {key}", force, unit) for key, unit, force in self.forces)
        yield Varying(f"{self.where}, stored energy", self.stored, "J", on=(COORDINATE,))

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield a fault of a mechanism that was not imported."""
        if not isinstance(scene.mechanism, MechanismByExpressions):
            yield Fault(self.where, f"mechanism {scene.mechanism.name}", "the imported model that has these loads")

    def element(self, kin: Any) -> Element:
        """Generalised forces, stored energy and power."""
        tape, motion = kin.tape, kin.by_expressions
        forces = {key: tape.let(motion.of(value), f"{self.name}_on_{key}") for key, _, value in self.forces}
        power = sp.Add(*(force * motion.speed(key) for key, force in forces.items()))
        stored = tape.let(motion.of(self.stored), f"{self.name}_stored")
        drawn = tape.rate(stored, f"{self.name}_stored_rate") if stored != 0 else sp.S.Zero
        return Element(forces, stored, input=tape.let(power + drawn, f"{self.name}_power"))


def ledger_faults(effects: tuple[Any, ...], follows_time: bool, alone: bool) -> Iterator[Fault]:
    """Yield faults of an energy ledger beside a motion that follows time, and beside equations alone."""
    if not any(isinstance(effect, EnergyLedger) for effect in effects):
        return
    if alone:
        yield Fault("effects", "an energy ledger beside equations alone", "a model whose loads or potential are known",
                    "Omit it: loads of a KanesMethod or a LagrangesMethod are known.")  # fmt: skip
    elif follows_time:
        yield Fault("effects", "an energy ledger beside a motion that itself follows time",
                    "a motion with a drive: the equations of SymPy do not contain its force",
                    "Make the specified function a coordinate with Drive(..., position=...), or omit the ledger.")  # fmt: skip
