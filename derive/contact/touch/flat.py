"""Contact geometry of a plane with a sphere, a cylinder or the rim of a disc."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.algebra.vectors import Vector, add, dot, scale, sub
from hertzwerk.derive.contact.touch.touch import Touch, touch
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.mechanism.pairs.flat import CylinderOnPlane, RimOnPlane, SphereOnPlane


@touch.register(SphereOnPlane)
class Face(Touch):
    """A plane, and a sphere, a cylinder or a corner on it."""

    proved: ClassVar[bool] = True

    @cached_property
    def normal(self) -> Vector:
        """Normal of the plane."""
        return self.named(self.kin.direction(self.second, self.pair.normal), "direction")

    @cached_property
    def gap(self) -> Any:
        """Height over the plane, less the radius."""
        return self.let(dot(self.normal, self.apart) - sp.sympify(self.pair.first_radius), "gap")


@touch.register(CylinderOnPlane)
class LyingCylinder(Face):
    """Cylinder whose axis stays parallel to the plane."""

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield the fault of an axis that may tilt."""
        axis = self.kin.direction(self.first, self.pair.axis)
        if dot(axis, self.normal) != 0:
            yield Fault(f"pair {self.pair.name}", f"a cylinder on {self.first.body.name} that may tilt against the plane",
                        "an axis that the joints keep parallel to it: a line contact would become a point at a jump",
                        "Give it a RimOnPlane for each end.")  # fmt: skip


@touch.register(RimOnPlane)
class Rim(Touch):
    """Lowest point of a disc's rim over a plane."""

    proved: ClassVar[bool] = True

    @cached_property
    def normal(self) -> Vector:
        """Normal of the plane."""
        return self.named(self.kin.direction(self.second, self.pair.normal), "direction")

    @cached_property
    def _up(self) -> tuple[Vector, Any]:
        """Component of the normal in the plane of the disc, and its length [1]."""
        axis = self.named(self.kin.direction(self.first, self.pair.axis), "axis")
        tilt = self.let(dot(self.normal, axis), "tilt")
        up = self.named(sub(self.normal, scale(tilt, axis)), "up")
        return up, self.let(sp.sqrt(1 - tilt**2), "rise")

    @cached_property
    def gap(self) -> Any:
        """Height of the lowest point."""
        return self.let(dot(self.normal, self.apart) - self.pair.radius * self._up[1], "gap")

    @cached_property
    def position(self) -> Vector:
        """The lowest point."""
        up, rise = self._up
        return add(self.centre, self.named(scale(-self.pair.radius / rise, up), "rim"))
