"""Contact geometry of spheres and parallel cylinders."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.algebra.vectors import Vector, apply, dot, scale, sub, transpose
from hertzwerk.derive.contact.touch.touch import Touch, touch
from hertzwerk.derive.mechanism.pairs import round as pairs


@touch.register(pairs.Round)
class Round(Touch):
    """Spheres or parallel cylinders, one on or in the other."""

    proved: ClassVar[bool] = True

    @cached_property
    def eccentricity(self) -> Vector:
        """Vector from centre to centre, for cylinders normal to the axis [m]."""
        if self.pair.line is None:
            return self.apart
        axis = self.named(self.kin.direction(self.second, self.pair.line), "direction")
        along = self.let(dot(self.apart, axis), "along")
        return self.named(sub(self.apart, scale(along, axis)), "e")

    @cached_property
    def _reach(self) -> Any:
        """Distance of the centres at which contact begins [m]."""
        if self.pair.inside:
            return sp.sympify(self.pair.clearance)
        return self.let(self.pair.radius_first + self.pair.radius_second, "reach")

    @cached_property
    def gap(self) -> Any:
        """(reach^2 - e.e)/(2 reach) inside, its negative outside: smooth through the centre."""
        reach = self._reach
        squared = self.let(dot(self.eccentricity, self.eccentricity), "apart_squared")
        sign = 1 if self.pair.inside else -1
        return self.let(sign * (reach**2 - squared) / (2 * reach), "gap")

    @cached_property
    def _distance(self) -> Any:
        return self.let(sp.sqrt(self.let(dot(self.eccentricity, self.eccentricity), "apart_squared")), "distance")

    @cached_property
    def normal(self) -> Vector:
        """Unit vector from the other centre, or inside towards it."""
        sign = -1 if self.pair.inside else 1
        return self.named(scale(sign / self._distance, self.eccentricity), "normal")

    @cached_property
    def penetration(self) -> Any:
        """Exact penetration, by the distance of the centres [m]."""
        sign = 1 if self.pair.inside else -1
        return self.let(sign * (self._distance - self._reach), "penetration")

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Eccentricity inside, in the axes of the second place; structural zeros are left out."""
        if not self.pair.inside:
            return super().outputs()
        local = apply(transpose(self.kin.axes_of(self.second)), self.eccentricity)
        line = self.pair.line
        across = [k for k in range(3) if (local[k] != 0 if line is None else line.components[k] == 0)]
        return [
            (f"{self.pair.name}.eccentricity_{'xyz'[k]}", "m", self.let(local[k], f"eccentricity_{'xyz'[k]}"))
            for k in across
        ]
