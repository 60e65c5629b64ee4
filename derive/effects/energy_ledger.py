"""The energy ledger: work put in and energy dissipated, integrated with the states."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from hertzwerk.derive.effects.effect import NOWHERE, Effect, Kinematics


@dataclass(frozen=True)
class EnergyLedger(Effect):
    """Quadratures of the energy put in and dissipated, so that energy + dissipated - input must stay constant."""

    name: str = "energy_ledger"
    kind: ClassVar[str] = "ledger"
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """What the effect is, for people."""
        return "work put in, energy dissipated per effect"

    @property
    def only(self) -> str:
        """One in a scene."""
        return "ledger of the scene"

    def element(self, kin: Kinematics) -> None:
        """None: it books what others do."""
