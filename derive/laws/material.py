"""Materials of bodies and of laws."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from hertzwerk.derive.expressions.parameter import POSITIVE, Interval, Scalar, Slot


@dataclass(frozen=True)
class Material:
    """Linear elastic material: Young's modulus [Pa], Poisson's ratio [1].

    If known, density [kg/m^3] and yield strength in simple tension [Pa].
    """

    youngs_modulus: Scalar
    poissons_ratio: Scalar
    density: Scalar | None = None
    yield_strength: Scalar | None = None

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the material."""
        yield Slot("material, Young's modulus", self.youngs_modulus, "Pa", POSITIVE)
        yield Slot("material, Poisson's ratio", self.poissons_ratio, "1", Interval(-1, 0.5, open_left=True))
        if self.density is not None:
            yield Slot("material, density", self.density, "kg/m^3", POSITIVE)
        if self.yield_strength is not None:
            yield Slot("material, yield strength", self.yield_strength, "Pa", POSITIVE)
