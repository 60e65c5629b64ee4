"""Energy ledger: work put in and energy dissipated, integrated with the states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from hertzwerk.derive.declare.effects.effect import NOWHERE, Effect


@dataclass(frozen=True)
class EnergyLedger(Effect):
    """Quadratures of energy input and dissipation: energy + dissipated - input must stay constant."""

    name: str = "energy_ledger"
    kind: ClassVar[str] = "ledger"
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """Description for people."""
        return "work put in, energy dissipated per effect"

    @property
    def only(self) -> str:
        """Description of the one in a scene."""
        return "ledger of the scene"
