"""Solids of one density: volume and radii of gyration of simple shapes, symbolic in their sizes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.algebra.vectors import (
    IDENTITY,
    Matrix,
    Vector,
    add,
    combine,
    diagonal,
    outer,
    scale,
    scaled,
)

KINDS = ("box", "cylinder", "tube", "sphere", "cone", "rod")


@dataclass(frozen=True)
class Shape:
    """A solid in the frame of its body: sizes [m] by name, axis of symmetry, mass centre.

    A box has its sizes along the axes of the body; a cone tapers along its axis; `hole` is one that was taken away.
    """

    kind: str
    sizes: tuple[tuple[str, Any], ...]
    axis: Vector
    centre: Vector
    hole: bool = False

    @property
    def volume(self) -> Any:
        """Volume [m^3]; None of a rod, which is slender."""
        of = dict(self.sizes)
        if self.kind == "box":
            return of["x"] * of["y"] * of["z"]
        if self.kind == "rod":
            return None
        r = of["radius"]
        if self.kind == "sphere":
            return sp.Rational(4, 3) * sp.pi * r**3
        area = sp.pi * (r**2 - of["hole_radius"] ** 2 if self.kind == "tube" else r**2)
        return area * of["length"] / (3 if self.kind == "cone" else 1)

    @property
    def gyration(self) -> Matrix:
        """Inertia about the mass centre for each unit of mass, along the axes of the body [m^2].

        Meriam, Kraige, Engineering Mechanics: Dynamics, table D/4.
        """
        of = {name: sp.sympify(value) for name, value in self.sizes}
        if self.kind == "box":
            x, y, z = (of[name] ** 2 / 12 for name in "xyz")
            return diagonal(y + z, x + z, x + y)
        if self.kind == "sphere":
            return scaled(2 * of["radius"] ** 2 / 5, IDENTITY)
        length = of["length"] ** 2 / 12
        if self.kind == "rod":
            about, across = sp.S.Zero, length
        elif self.kind == "cone":
            about, across = 3 * of["radius"] ** 2 / 10, 3 * of["radius"] ** 2 / 20 + 3 * of["length"] ** 2 / 80
        else:
            about = (of["radius"] ** 2 + of.get("hole_radius", sp.S.Zero) ** 2) / 2
            across = about / 2 + length
        return combine(scaled(across, IDENTITY), scaled(about - across, outer(self.axis, self.axis)))

    def landmark(self) -> tuple[Vector, Mapping[str, Any]]:
        """Point of its centre, of a cone that of its base, and what a picture shows there."""
        of = dict(self.sizes)
        if self.kind == "box":
            return self.centre, {"size": tuple(of[name] for name in "xyz")}
        sizes = {name: value for name, value in of.items() if name != "hole_radius"}
        beside = sizes if self.kind == "sphere" else {"axis": self.axis, **sizes}
        if self.kind == "tube":
            beside["hole_radius"] = of["hole_radius"]
        if self.kind == "cone":
            return add(self.centre, scale(-sp.sympify(of["length"]) / 4, self.axis)), beside
        return self.centre, beside

    def slots(self) -> Iterator[tuple[str, Any]]:
        """Yield what each size is, and its value [m]."""
        yield from ((f"{self.kind}, {name.replace('_', ' ')}", value) for name, value in self.sizes)
