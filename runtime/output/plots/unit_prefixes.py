"""Units to show quantities in: the prefix that fits the data."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

LEAST = 0.4  # of the largest value in a unit that fits: half a millimetre, 0.4 kN...
LEAST_ANGLE = 0.02  # ... and a degree in radians

_SIZES = {"G": 1e9, "M": 1e6, "k": 1e3, "": 1.0, "m": 1e-3, "µ": 1e-6, "n": 1e-9}
_PREFIXES = {
    "m": "mµn", "s": "mµn", "N": "GMkmµ", "J": "GMkmµn", "W": "GMkmµ", "Pa": "GMk", "N m": "Mkmµ", "m/s": "mµ", "m/s^2": "kmµ",
    "rad": "mµ", "rad/s": "k", "rad/s^2": "kM", "N/m": "GMk",
}  # fmt: skip
"""Prefixes in use for a unit; for any other none."""


@dataclass(frozen=True)
class Scale:
    """Unit to show a quantity in: its text and its size in SI."""

    unit: str
    factor: float

    def __call__(self, values: Any) -> Any:
        """Convert SI values to this unit."""
        return np.asarray(values) / self.factor


def scale_of(unit: str, values: Any) -> Scale:
    """Return the largest prefix that keeps the largest of the values above 0.4; none where all are zero."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    least = LEAST_ANGLE if unit == "rad" else LEAST
    used = sorted(("", *_PREFIXES.get(unit, "")), key=lambda prefix: -_SIZES[prefix])
    fitting = (prefix for prefix in used if largest >= least * _SIZES[prefix])
    prefix = next(fitting, used[-1]) if largest else ""
    return Scale(f"{prefix}{unit}".replace("^2", "²"), _SIZES[prefix])
