"""Scales of a scene, by which errors are measured."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot, is_number


@dataclass(frozen=True)
class Scales:
    """Scales of error tolerances: a length [m], a speed [m/s], and the arm [m] of an angle length/arm."""

    length: Scalar
    speed: Scalar
    arm: Scalar | None = None

    @property
    def by_unit(self) -> dict[str, Any]:
        """Scales of coordinates and speeds; of angles only where there is an arm."""
        if not all(map(is_number, (self.length, self.speed))):
            return {}
        length, speed = sp.sympify(self.length), sp.sympify(self.speed)
        if not is_number(self.arm):
            return {"m": length, "m/s": speed}
        # a quaternion moves by half the angle
        angles = {"rad": length / self.arm, "rad/s": speed / self.arm, "1": length / self.arm / 2}
        return {"m": length, "m/s": speed, **angles}

    def slots(self) -> Iterator[Slot]:
        """Yield the scales."""
        yield Slot("scales, length", self.length, "m", POSITIVE)
        yield Slot("scales, speed", self.speed, "m/s", POSITIVE)
        if self.arm is not None:
            yield Slot("scales, arm", self.arm, "m", POSITIVE)
