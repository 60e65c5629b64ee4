"""What a force element does to a mechanism."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

DISSIPATED, INPUT = "dissipated", "input"


@dataclass(frozen=True)
class Element:
    """Generalised forces by joint [N m or N]; stored energy [J]; power [W] that the energy ledger books as `DISSIPATED` or `INPUT`, None where the
    element stores; outputs (name, unit, expression)."""

    forces: Mapping[str, Any] = field(default_factory=dict)
    stored: Any = sp.S.Zero
    power: Any = None
    booked: str = DISSIPATED
    outputs: tuple[tuple[str, str, Any], ...] = ()
