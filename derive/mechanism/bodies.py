"""Bodies, the ground, their points and directions, and materials. Declarations only.

Dimensional quantities take a `Parameter`, an expression of parameters, or 0; a bare number has no unit and is a
fault.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.algebra.vectors import IDENTITY, Matrix, Vector, about, dot, multiply, scale
from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.derive.mechanism.parameter import (
    NOT_NEGATIVE,
    POSITIVE,
    Interval,
    Scalar,
    default_value,
    is_number,
    parameters_of,
)

Triple = tuple[Any, Any, Any]


@dataclass(frozen=True)
class Slot:
    """One quantity of a record: its place, value and unit, and the ranges (SI) it must and should keep.

    `asked_as` is `<pair>.<symbol>` for quantities that a pair has for its laws alone: without a law that depends on
    it, it is unused.
    """

    where: str
    value: Scalar
    unit: str
    limit: Interval | None = None
    recommended: Interval | None = None
    asked_as: str = ""


@dataclass(frozen=True)
class Direction:
    """A direction in a frame; `-Y` is opposite to Y.

    Three numbers, or parameters of one unit: only their ratios count, `Direction((1, 0, 1))` lies between X and Z.
    """

    components: Triple

    def __neg__(self) -> Direction:
        x, y, z = self.components
        return Direction((-x, -y, -z))

    @property
    def unit(self) -> Vector:
        """Unit vector; exact integers for X, Y, Z and their opposites."""
        given: Vector = tuple(sp.sympify(component) for component in self.components)
        nonzero = [component for component in given if component != 0]
        if len(nonzero) == 1 and nonzero[0].is_number:
            return tuple(sp.sign(component) for component in given)
        return scale(1 / sp.sqrt(dot(given, given)), given)

    @property
    def points(self) -> bool:
        """Whether it has a length, at the defaults."""
        return any(default_value(component) != 0 for component in self.components)

    def slots(self, where: str) -> Iterator[Slot]:
        """Yield the components, in the unit of the first that has one; `where` is the place of the direction."""
        units = (parameter.unit for value in self.components for parameter in parameters_of(value))
        unit = next((unit for unit in units if unit not in ("1", "rad", "deg")), "1")
        for value in self.components:
            yield Slot(where, value, unit)


X = Direction((1, 0, 0))
Y = Direction((0, 1, 0))
Z = Direction((0, 0, 1))
AXES = (X, Y, Z)


@dataclass(frozen=True)
class Material:
    """Linear elastic material: Young's modulus [Pa], Poisson's ratio [1], density [kg/m^3] if known."""

    youngs_modulus: Scalar
    poissons_ratio: Scalar
    density: Scalar | None = None

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the material."""
        yield Slot("material, Young's modulus", self.youngs_modulus, "Pa", POSITIVE)
        yield Slot("material, Poisson's ratio", self.poissons_ratio, "1", Interval(-1, 0.5, open_left=True))
        if self.density is not None:
            yield Slot("material, density", self.density, "kg/m^3", POSITIVE)


@dataclass(frozen=True)
class Body:
    """Rigid body: mass [kg], inertia about its mass centre [kg m^2], mass centre in its own frame [m].

    A scalar inertia is for the axis of the joint that turns the body (plane motion), or the same about every axis
    where a joint turns it freely; a triple holds the principal values along the frame's axes. A mass of 0 declares a
    massless body, which the last body of a chain cannot be.
    """

    name: str
    mass: Scalar
    inertia: Scalar | Triple = 0
    centre: Triple = (0, 0, 0)

    def at(self, x: Scalar, y: Scalar, z: Scalar) -> Point:
        """Point fixed in the body at (x, y, z) [m] of its frame."""
        return Point(self, (x, y, z))

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the body."""
        massless = is_number(self.mass) and self.mass == 0  # the number 0; a parameter must be positive
        yield Slot(f"body {self.name}, mass", self.mass, "kg", None if massless else POSITIVE)
        inertia = self.inertia if isinstance(self.inertia, tuple) else (self.inertia,)
        for value in inertia:
            yield Slot(f"body {self.name}, inertia", value, "kg m^2", NOT_NEGATIVE)
        for value in self.centre:
            yield Slot(f"body {self.name}, mass centre", value, "m")


@dataclass(frozen=True)
class Ground:
    """The fixed frame."""

    name: ClassVar[str] = "ground"

    def at(self, x: Scalar, y: Scalar, z: Scalar) -> Point:
        """Fixed point (x, y, z) [m]."""
        return Point(self, (x, y, z))


GROUND = Ground()
Frame = Body | Ground


@dataclass(frozen=True)
class Point:
    """Point fixed in a body or the ground, with axes of its own if `turned`, else its body's."""

    body: Frame
    position: Triple = (0, 0, 0)
    turns: tuple[tuple[Direction, Scalar], ...] = ()

    def turned(self, axis: Direction, angle: Scalar) -> Point:
        """The point with axes turned by a constant angle [rad] about `axis` of the present ones.

        Raises InputError for an axis that is no Direction.
        """
        if not isinstance(axis, Direction):
            raise InputError(
                "a turned point", [Fault("axis", repr(axis), "a Direction, such as X, -Y or Direction((1, 0, 1))")]
            )
        return replace(self, turns=(*self.turns, (axis, angle)))

    @property
    def axes(self) -> Matrix:
        """Rotation matrix from the point's axes to its body's."""
        matrix = IDENTITY
        for axis, angle in self.turns:
            matrix = multiply(matrix, about(axis.unit, sp.cos(angle), sp.sin(angle)))
        return matrix

    def turned_about(self, k: int) -> Any:
        """Angle of its axes about the coordinate axis common to all its turns [rad]."""
        return sp.Add(*(axis.unit[k] * angle for axis, angle in self.turns))

    def slots(self) -> Iterator[Slot]:
        """Yield the coordinates of the point and the angles of its axes."""
        for value in self.position:
            yield Slot(f"point of {self.body.name}", value, "m")
        for axis, angle in self.turns:
            yield from axis.slots(f"point of {self.body.name}, axis it is turned about")
            yield Slot(f"point of {self.body.name}, angle of its axes", angle, "rad")
