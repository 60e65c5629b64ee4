"""Bodies, the ground, their points and directions, and materials. Declarations only.

Dimensional quantities take a `Parameter`, an expression of parameters, or 0; a bare number has no unit and is a
fault.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar, TypeAlias

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.derive.declare.mechanism.solids import Shape
from hertzwerk.derive.expressions.algebra.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    about,
    add,
    combine,
    diagonal,
    dot,
    multiply,
    outer,
    scale,
    scaled,
    sub,
)
from hertzwerk.derive.expressions.parameter import (
    NOT_NEGATIVE,
    POSITIVE,
    Scalar,
    Slot,
    default_value,
    is_number,
    parameters_of,
)
from hertzwerk.derive.laws.material import Material

Triple = tuple[Any, Any, Any]


def measured(
    record: Any, where: str, measures: Mapping[str, Slot], units: Mapping[str, str] | None = None
) -> Iterator[Slot]:
    """Yield the quantities of a record by field; one that is None by default may be left out.

    `units` stand for names in braces in units of `measures`.
    """
    for name, slot in measures.items():
        value = getattr(record, name)
        if value is not None or getattr(type(record), name, record) is not None:
            place, unit = f"{where}, {slot.where or name.replace('_', ' ')}", slot.unit.format_map(units or {})
            law_symbol = slot.law_symbol and f"{record.name}.{slot.law_symbol}"
            yield replace(slot, where=place, value=value, unit=unit, law_symbol=law_symbol)


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
        components: Vector = tuple(sp.sympify(component) for component in self.components)
        nonzero = [component for component in components if component != 0]
        if len(nonzero) == 1 and nonzero[0].is_number:
            return tuple(sp.sign(component) for component in components)
        return scale(1 / sp.sqrt(dot(components, components)), components)

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


Density: TypeAlias = Scalar | Material | None
"""Density [kg/m^3], also that of a material."""


@dataclass(frozen=True)
class Body:
    """Rigid body: mass [kg], inertia about its mass centre [kg m^2], mass centre in its own frame [m].

    A scalar inertia is for the axis of the joint that turns the body (plane motion), or the same about every axis
    where a joint turns it freely; a triple holds the principal values along the frame's axes; three rows are the
    whole tensor along these axes, whose products are J_xy = -integral of x y dm. A mass of 0 declares a massless
    body. `shapes` are drawn; `Body.cylinder` and its like make bodies of them.
    """

    name: str
    mass: Scalar
    inertia: Scalar | Triple = 0
    centre: Triple = (0, 0, 0)
    shapes: tuple[Shape, ...] = ()

    @classmethod
    def box(
        cls, name: str, x: Scalar, y: Scalar, z: Scalar, *, density: Density = None, mass: Scalar | None = None,
        centre: Triple = (0, 0, 0),
    ) -> Body:  # fmt: skip
        """Box of sizes x, y, z [m] along its axes, about `centre`; raises InputError."""
        return cls._shaped(name, Shape("box", (("x", x), ("y", y), ("z", z)), ZERO, centre), density, mass)

    @classmethod
    def sphere(
        cls, name: str, radius: Scalar, *, density: Density = None, mass: Scalar | None = None,
        centre: Triple = (0, 0, 0),
    ) -> Body:  # fmt: skip
        """Sphere about `centre`; raises InputError."""
        return cls._shaped(name, Shape("sphere", (("radius", radius),), ZERO, centre), density, mass)

    @classmethod
    def cylinder(
        cls, name: str, radius: Scalar, length: Scalar, *, density: Density = None, mass: Scalar | None = None,
        axis: Direction = Z, centre: Triple = (0, 0, 0),
    ) -> Body:  # fmt: skip
        """Cylinder or disc about `centre`; raises InputError."""
        return cls._round("cylinder", name, {"radius": radius, "length": length}, axis, centre, density, mass)

    @classmethod
    def tube(
        cls, name: str, radius: Scalar, hole_radius: Scalar, length: Scalar, *, density: Density = None,
        mass: Scalar | None = None, axis: Direction = Z, centre: Triple = (0, 0, 0),
    ) -> Body:  # fmt: skip
        """Tube or ring about `centre`; raises InputError."""
        sizes = {"radius": radius, "hole_radius": hole_radius, "length": length}
        return cls._round("tube", name, sizes, axis, centre, density, mass)

    @classmethod
    def cone(
        cls, name: str, radius: Scalar, length: Scalar, *, density: Density = None, mass: Scalar | None = None,
        axis: Direction = Z, centre: Triple = (0, 0, 0),
    ) -> Body:  # fmt: skip
        """Cone that tapers along its axis, its base length/4 before its mass centre; raises InputError."""
        return cls._round("cone", name, {"radius": radius, "length": length}, axis, centre, density, mass)

    @classmethod
    def rod(cls, name: str, length: Scalar, *, mass: Scalar, axis: Direction = X, centre: Triple = (0, 0, 0)) -> Body:
        """Slender rod about `centre`, without inertia about itself; raises InputError."""
        return cls._round("rod", name, {"length": length}, axis, centre, None, mass)

    @classmethod
    def of(cls, name: str, *parts: Body, without: tuple[Body, ...] = ()) -> Body:
        """One rigid body of several in the same frame, those in `without` taken away: holes.

        Raises InputError for parts without an inertia about every axis.
        """
        wrong = [
            part for part in (*parts, *without) if not isinstance(part, Body) or not isinstance(part.inertia, tuple)
        ]
        expected = "a body with three principal inertias or a tensor, as of Body.box(...)"
        faults = [Fault(f"part {getattr(part, 'name', part)}", f"{part!r:.80}", expected) for part in wrong]
        if faults or not parts:
            raise InputError(f"body {name}", faults or [Fault("parts", "none", "at least one body")])
        signed = [(sp.S.One, part) for part in parts] + [(sp.S.NegativeOne, part) for part in without]
        mass = sp.Add(*(sign * part.mass for sign, part in signed))
        centre = scale(1 / mass, add(*(scale(sign * part.mass, part.centre) for sign, part in signed)))
        inertia = combine(
            *(
                scaled(sign, combine(part.tensor, scaled(part.mass, steiner(sub(part.centre, centre)))))
                for sign, part in signed
            )
        )
        shapes = [replace(shape, hole=shape.hole or sign < 0) for sign, part in signed for shape in part.shapes]
        return cls(name, mass, _shortest(inertia), centre, tuple(shapes))

    @classmethod
    def _round(
        cls, kind: str, name: str, sizes: dict[str, Scalar], axis: Direction, centre: Triple, density: Density,
        mass: Scalar | None,
    ) -> Body:  # fmt: skip
        if not isinstance(axis, Direction):
            raise InputError(f"body {name}", [Fault("axis", repr(axis), "a Direction, such as X, -Y or Z")])
        return cls._shaped(name, Shape(kind, tuple(sizes.items()), axis.unit, centre), density, mass)

    @classmethod
    def _shaped(cls, name: str, shape: Shape, density: Density, mass: Scalar | None) -> Body:
        """Body of one shape, of a given density [kg/m^3] or mass [kg]."""
        mass_density = density.density if isinstance(density, Material) else density
        values = {**dict(shape.sizes), "density": mass_density, "mass": mass}
        faults = [
            Fault(quantity, repr(value), "a Parameter, or an expression of them")
            for quantity, value in values.items()
            if not is_number(value) and (value is not None or quantity not in ("density", "mass"))
        ]
        if (mass_density is None) == (mass is None):
            actual = "neither a density nor a mass" if mass is None else "both a density and a mass"
            faults.append(Fault("mass", actual, "one of them: density=... [kg/m^3] or mass=... [kg]"))
        if not isinstance(shape.centre, tuple) or len(shape.centre) != 3:
            faults.append(Fault("centre", repr(shape.centre), "three values, (x, y, z)"))
        refuse(f"body {name}", faults)
        whole = sp.sympify(mass if mass_density is None else mass_density * shape.volume)
        return cls(name, whole, _shortest(scaled(whole, shape.gyration)), shape.centre, (shape,))

    @property
    def moments(self) -> Triple:
        """Inertias about the frame's axes [kg m^2]; a single one is about each."""
        entries = self.inertia if isinstance(self.inertia, tuple) else (self.inertia,) * 3
        x, y, z = (row[k] if isinstance(row, tuple) else row for k, row in enumerate(entries))
        return (x, y, z)

    @property
    def has_products(self) -> bool:
        """Whether its inertia is given as a whole tensor."""
        return isinstance(self.inertia, tuple) and any(isinstance(row, tuple) for row in self.inertia)

    @property
    def tensor(self) -> Matrix:
        """Inertia about the mass centre, along the frame's axes [kg m^2]."""
        if not isinstance(self.inertia, tuple) or not self.has_products:
            return diagonal(*self.moments)
        x, y, z = (tuple(map(sp.sympify, row)) for row in self.inertia)
        return (x, y, z)

    def at(self, x: Scalar, y: Scalar, z: Scalar) -> Point:
        """Point fixed in the body at (x, y, z) [m] of its frame."""
        return Point(self, (x, y, z))

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the body."""
        massless = is_number(self.mass) and self.mass == 0  # the number 0; a parameter must be positive
        yield Slot(f"body {self.name}, mass", self.mass, "kg", None if massless else POSITIVE)
        for value in self.moments if isinstance(self.inertia, tuple) else (self.inertia,):
            yield Slot(f"body {self.name}, inertia", value, "kg m^2", NOT_NEGATIVE)
        if isinstance(self.inertia, tuple) and self.has_products:
            for i, k in ((0, 1), (0, 2), (1, 2), (1, 0), (2, 0), (2, 1)):
                if i < k or self.inertia[i][k] != self.inertia[k][i]:
                    yield Slot(f"body {self.name}, inertia J_{'xyz'[i]}{'xyz'[k]}", self.inertia[i][k], "kg m^2")
        for value in self.centre:
            yield Slot(f"body {self.name}, mass centre", value, "m")
        for shape in self.shapes:
            yield from (Slot(f"body {self.name}, {size}", value, "m", POSITIVE) for size, value in shape.slots())


def steiner(shift: Vector) -> Matrix:
    """Inertia of a unit mass at `shift`, by the parallel-axis theorem: r.r 1 - r r^T [m^2]."""
    return combine(scaled(dot(shift, shift), IDENTITY), scaled(sp.S.NegativeOne, outer(shift, shift)))


def _shortest(inertia: Matrix) -> Triple:
    """Principal values where the products vanish, else all rows."""
    x, y, z = (tuple(map(sp.sympify, row)) for row in inertia)
    return (x, y, z) if any((x[1] != 0, x[2] != 0, y[2] != 0)) else (x[0], y[1], z[2])


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
