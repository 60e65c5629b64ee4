"""Pairs of a sphere with a box, a bounded face, an edge or a cylinder, and how they touch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import AXES, Direction, Point, Z
from hertzwerk.derive.declare.mechanism.pair import LENGTH, Pair, in_body
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, apply, cross, dot, scale, sub, transpose
from hertzwerk.derive.expressions.parameter import Scalar, Slot, default_value

NEAREST = sp.Float(1e-9)
"""Least distance of the centre from the solid for a direction, in radii."""


@dataclass(frozen=True)
class SphereOnSolid(Pair):
    """Sphere that may touch a convex solid from outside, wherever it is nearest: one contact, never two.

    Gap and normal are those of the distance of the centre, which goes on smoothly from a face to its edge and its
    corner. A centre within the solid is pushed out by the way that is shortest, through the face that is nearest. A
    plate or a wire has no inside: a centre pressed through it comes out on the other side.
    """

    @property
    def first_radius(self) -> Any:
        """Distance from the first place to the contact point [m]."""
        return getattr(self, "radius")  # noqa: B009  # a field of each kind, behind its first

    @property
    def geometry(self) -> dict[str, Any]:
        """Geometry for laws: that of the sphere on a plane, which edges and corners are not."""
        return {"R_eff": self.first_radius, "R_min": self.first_radius, "R_2": self.first_radius}

    def off(self, p: Vector) -> Vector:
        """Vector to the point p from the nearest of the solid, along the axes of the second place [m]."""
        raise NotImplementedError

    def within(self, p: Vector) -> list[tuple[Any, Vector]]:
        """Depth of a point p of the inside below each face [m], and the face's normal, along the same axes."""
        del p
        return []

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return NearestPoint(self, kinematics)


@dataclass(frozen=True)
class SphereOnBox(SphereOnSolid):
    """Sphere that may touch a box: faces, edges and corners.

    Its sizes x, y, z are along the axes of its middle.
    """

    sphere: Point
    radius: Scalar
    box: Point
    x: Scalar
    y: Scalar
    z: Scalar
    kind: ClassVar[str] = "sphere_on_box"
    measures: ClassVar[Mapping[str, Slot]] = dict.fromkeys(("radius", "x", "y", "z"), LENGTH)

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius; sizes of the box and two of its axes, for landmarks."""
        first, second, _ = (in_body(self.box, axis) for axis in AXES)
        return {"radius": self.radius}, {"along": first, "across": second, "size": (self.x, self.y, self.z)}

    def off(self, p: Vector) -> Vector:
        """Vector from the nearest point of the box [m]."""
        x, y, z = (_beyond(value, size) for value, size in zip(p, (self.x, self.y, self.z), strict=True))
        return (x, y, z)

    def within(self, p: Vector) -> list[tuple[Any, Vector]]:
        """Depth below the nearer face across each axis [m]."""
        sizes = zip(p, (self.x, self.y, self.z), AXES, strict=True)
        return [_below(value, size, axis.unit) for value, size, axis in sizes]


@dataclass(frozen=True)
class SphereOnFace(SphereOnSolid):
    """Sphere that may touch a rectangular plate without thickness: its faces, edges and corners.

    `face` is its middle; `length` is `along`, `width` across it; the normal is perpendicular to `along`.
    """

    sphere: Point
    radius: Scalar
    face: Point
    normal: Direction
    along: Direction
    length: Scalar
    width: Scalar
    kind: ClassVar[str] = "sphere_on_face"
    measures: ClassVar[Mapping[str, Slot]] = dict.fromkeys(("radius", "length", "width"), LENGTH)

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius; normal, direction and length of the face, for landmarks."""
        normal, along = in_body(self.face, self.normal), in_body(self.face, self.along)
        return {"radius": self.radius}, {"normal": normal, "along": along, "length": self.length}

    def faults(self) -> Iterator[Fault]:
        """A direction along the face must be square to its normal."""
        cosine = sum(default_value(a * b) for a, b in zip(self.normal.unit, self.along.unit, strict=True))
        if abs(cosine) > 1e-9:
            actual = f"a direction at a cosine of {cosine:.3g} to the normal"
            yield Fault(f"pair {self.name}, along", actual, "one square to it")

    def off(self, p: Vector) -> Vector:
        """Vector from the nearest point of the plate [m]."""
        normal, along = self.normal.unit, self.along.unit
        across = cross(normal, along)
        return add(
            scale(dot(normal, p), normal),
            scale(_beyond(dot(along, p), self.length), along),
            scale(_beyond(dot(across, p), self.width), across),
        )


@dataclass(frozen=True)
class SphereOnEdge(SphereOnSolid):
    """Sphere that may touch a straight edge, or wire, `along` a direction; with a `length` it has ends."""

    sphere: Point
    radius: Scalar
    edge: Point
    along: Direction
    length: Scalar | None = None
    kind: ClassVar[str] = "sphere_on_edge"
    measures: ClassVar[Mapping[str, Slot]] = dict.fromkeys(("radius", "length"), LENGTH)

    @property
    def geometry(self) -> dict[str, Any]:
        """No radius of curvature: an edge has none, its stiffness is given."""
        return {"R_2": self.radius}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius; direction and length of the edge, for landmarks."""
        edge = {"along": in_body(self.edge, self.along)}
        return {"radius": self.radius}, edge | ({} if self.length is None else {"length": self.length})

    def off(self, p: Vector) -> Vector:
        """Vector from the nearest point of the edge [m]."""
        along = self.along.unit
        way = dot(along, p)
        return sub(p, scale(way if self.length is None else way - _beyond(way, self.length), along))


@dataclass(frozen=True)
class SphereOnCylinder(SphereOnSolid):
    """Sphere that may touch a cylinder from outside: its side; with a `length` its ends and rims."""

    sphere: Point
    radius: Scalar
    cylinder: Point
    cylinder_radius: Scalar
    axis: Direction = Z
    length: Scalar | None = None
    kind: ClassVar[str] = "sphere_on_cylinder"
    measures: ClassVar[Mapping[str, Slot]] = dict.fromkeys(("radius", "cylinder_radius", "length"), LENGTH)

    @property
    def geometry(self) -> dict[str, Any]:
        """Radii of the side, and that of the geometric mean of its relative curvatures, 1/r and 1/r + 1/R [m]."""
        r, R = self.radius, self.cylinder_radius
        return {"R_eff": r / sp.sqrt(1 + r / R), "R_min": r, "R_1": R, "R_2": r}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radii; axis and length of the cylinder, for landmarks."""
        cylinder = {"radius": self.cylinder_radius, "axis": in_body(self.cylinder, self.axis)}
        return {"radius": self.radius}, cylinder | ({} if self.length is None else {"length": self.length})

    def off(self, p: Vector) -> Vector:
        """Vector from the nearest point of the cylinder [m]."""
        R = sp.sympify(self.cylinder_radius)
        axis, way, aside = self._parts(p)
        distance = _length(aside, R)  # from within the side nothing depends on it
        beyond = sp.S.Zero if self.length is None else _beyond(way, self.length)
        return add(scale(1 - R / distance, aside), scale(beyond, axis))

    def within(self, p: Vector) -> list[tuple[Any, Vector]]:
        """Depth below the side, and below the nearer end [m]."""
        R = sp.sympify(self.cylinder_radius)
        axis, way, aside = self._parts(p)
        distance = _length(aside, NEAREST * R)  # on the axis no way out is the shortest
        ends = [] if self.length is None else [_below(way, self.length, axis)]
        return [(R - distance, scale(1 / distance, aside)), *ends]

    def _parts(self, p: Vector) -> tuple[Vector, Any, Vector]:
        """Axis, way along it, and vector from it [m]."""
        axis = self.axis.unit
        way = dot(axis, p)
        return axis, way, sub(p, scale(way, axis))


def _length(vector: Vector, least: Any) -> Any:
    """Length of a vector, or the least one given, which is positive."""
    square = dot(vector, vector)
    return sp.sqrt(Where(square > least**2, square, least**2))


def _below(way: Any, size: Any, axis: Vector) -> tuple[Any, Vector]:
    """Depth below the nearer end of an interval of a given size about zero, and its normal."""
    depth = sp.sympify(size) / 2 - Where(way > 0, way, -way)
    return depth, scale(Where(way > 0, sp.S.One, -sp.S.One), axis)


def _beyond(way: Any, size: Any) -> Any:
    """Part of a coordinate beyond an interval of a given size about zero."""
    half = sp.sympify(size) / 2
    return Where(way > half, way - half, Where(way < -half, way + half, sp.S.Zero))


class NearestPoint(Touch):
    """Sphere and the point of a convex solid that is nearest to its centre."""

    proved: ClassVar[bool] = True

    @cached_property
    def _local(self) -> Vector:
        """Vector from the second place to the centre, along the axes of that place [m]."""
        return self.named(apply(transpose(self.kin.axes_of(self.second)), self.apart), "local_apart")

    @cached_property
    def _off(self) -> Vector:
        """Vector from the nearest point to the centre, along the axes of the second place [m]."""
        return self.named(self.pair.off(self._local), "off")

    @cached_property
    def _square(self) -> Any:
        return self.let(dot(self._off, self._off), "off_squared")

    @cached_property
    def _least(self) -> Any:
        """Least square of a distance that has a direction [m^2]."""
        return (NEAREST * sp.sympify(self.pair.radius)) ** 2

    @cached_property
    def _beneath(self) -> tuple[Any, Vector] | None:
        """Depth of the centre below the nearest face and that face's normal; None without an inside.

        Along the axes of the second place. A face that the motion cannot near is none, as those beside a plane of motion.
        """
        faces = [(self.let(depth, "depth"), normal) for depth, normal in self.pair.within(self._local)]
        candidates = [face for face in faces if self.tape.rate(face[0], f"{self.pair.name}_depth_rate") != 0]
        if not candidates:
            return None
        (least, normal), *others = candidates
        for depth, other in others:
            nearer = depth < least
            normal = self._either(nearer, other, normal, "way_out")
            least = self.let(Where(nearer, depth, least), "least_depth")
        return least, normal

    def _either(self, condition: Any, a: Vector, b: Vector, label: str) -> Vector:
        x, y, z = (one if one == two else Where(condition, one, two) for one, two in zip(a, b, strict=True))
        return self.named((x, y, z), label)

    @cached_property
    def _length(self) -> Any:
        """Length of the vector from the nearest point, at least one that has a direction [m]."""
        return self.let(sp.sqrt(Where(self._square > self._least, self._square, self._least)), "off_length")

    @cached_property
    def _distance(self) -> Any:
        """Distance of the centre from the solid, negative within [m]."""
        if self._beneath is None:
            return self._length
        return self.let(Where(self._square > self._least, self._length, -self._beneath[0]), "distance")

    @cached_property
    def gap(self) -> Any:
        """(distance |distance| - radius^2)/(2 radius), smooth where the distance vanishes [m]."""
        radius, square = sp.sympify(self.pair.radius), self._square
        if self._beneath is not None:
            square = self.let(Where(square > self._least, square, -(self._beneath[0] ** 2)), "signed_square")
        return self.let((square - radius**2) / (2 * radius), "gap")

    @cached_property
    def normal(self) -> Vector:
        """Unit vector from the nearest point to the centre, from within out of the nearest face."""
        local = self.named(scale(1 / self._length, self._off), "local_normal")
        if self._beneath is not None:
            local = self._either(self._square > self._least, local, self._beneath[1], "way_out")
        return self.named(apply(self.kin.axes_of(self.second), local), "normal")

    @cached_property
    def penetration(self) -> Any:
        """Exact penetration, by the distance [m]."""
        return self.let(sp.sympify(self.pair.radius) - self._distance, "penetration")
