"""Pair of user-defined surfaces, given by expressions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.mechanism.bodies import Point, Slot
from hertzwerk.derive.mechanism.pairs.pair import Components, Pair
from hertzwerk.derive.mechanism.parameter import POSITIVE, Scalar


class PoseSymbol(sp.Symbol):  # type: ignore[misc]  # SymPy is untyped
    """Coordinate of a pair's first place, or of its axes, in the axes of the second."""

    __slots__ = ("unit",)

    def __new__(cls, name: str, unit: str) -> PoseSymbol:
        """Make a new symbol, never from SymPy's cache."""
        self = sp.Symbol.__xnew__(cls, name, real=True)
        self.unit = unit
        return self  # type: ignore[no-any-return]

    def _hashable_content(self) -> tuple[Any, ...]:
        return (self.name, self.unit)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (self.name, self.unit), {}


APART = tuple(PoseSymbol(f"apart_{k}", "m") for k in "xyz")
"""Vector from the second place to the first, along the axes of the second [m]."""
TURN = tuple(tuple(PoseSymbol(f"turn_{i}{k}", "1") for k in "xyz") for i in "xyz")
"""Rotation from the axes of the first place to those of the second: its columns are the first's axes."""


@dataclass(frozen=True)
class Posed(Slot):
    """Quantity that may vary with the pose of one body against another: `APART`, `TURN`."""


@dataclass(frozen=True)
class CustomPair(Pair):
    """User-defined surfaces: gap, normal and contact point as expressions of `APART`, `TURN`, parameters.

    All along the axes of the second place.

    gap            signed distance of the surfaces [m], negative while they penetrate
    normal         unit vector that pushes the first body, (x, y, z)
    contact_point  the point of contact, from the second place, (x, y, z) [m]

    The rest is derived. `radius` [m] is that of relative curvature, for laws that depend on it; `length` [m] that of
    a line contact: without it the contact is a point. A gap whose rate is not the speed at which the bodies approach
    along the normal at the contact point is refused: its forces would not conserve energy.
    """

    first: Point
    second: Point
    gap: Scalar
    normal: Components
    contact_point: Components
    radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "custom"

    @property
    def form(self) -> str:  # type: ignore[override]  # here it depends on what is given
        """Line contact if it has a length, else point contact."""
        return "point" if self.length is None else "line"

    @property
    def geometry(self) -> dict[str, Any]:
        """Radius and length, if given."""
        given = {"R_eff": self.radius, "R_min": self.radius, "L": self.length}
        return {name: value for name, value in given.items() if value is not None}

    def slots(self) -> Iterator[Slot]:
        """Yield the expressions and the places."""
        yield Posed(f"pair {self.name}, gap", self.gap, "m")
        for what, values, unit in (("normal", self.normal, "1"), ("contact point", self.contact_point, "m")):
            for axis, value in zip("xyz", values, strict=True):
                yield Posed(f"pair {self.name}, {what}, {axis}", value, unit)
        if self.radius is not None:
            yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        if self.length is not None:
            yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE, asked_as=f"{self.name}.L")
        yield from super().slots()
