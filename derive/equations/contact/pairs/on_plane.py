"""Pairs of a plane with a sphere, a cylinder or the rim of a disc, and how they touch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Direction, Point
from hertzwerk.derive.declare.mechanism.pair import LENGTH, Pair, in_body
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, dot, scale, sub
from hertzwerk.derive.expressions.parameter import Scalar, Slot


@dataclass(frozen=True)
class SphereOnPlane(Pair):
    """Sphere that may touch a plane; `normal` points out of the solid, in the plane's frame."""

    sphere: Point
    radius: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "sphere_on_plane"
    wears: ClassVar[str] = "flat"
    measures: ClassVar[Mapping[str, Slot]] = {"radius": LENGTH}

    @property
    def first_radius(self) -> Any:
        """Distance from the first place to the contact point [m]."""
        return self.radius

    @property
    def geometry(self) -> dict[str, Any]:
        """Geometry for laws: radius of relative curvature `R_eff`, smaller radius `R_min` [m]."""
        return {"R_eff": self.radius, "R_min": self.radius, "R_2": self.radius}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius and normal, for landmarks."""
        return {"radius": self.radius}, {"normal": in_body(self.plane, self.normal)}

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return Face(self, kinematics)


@dataclass(frozen=True)
class CylinderOnPlane(Pair):
    """Cylinder that may touch a plane along a line of `length`; its `axis` stays parallel to the plane.

    The axis is in its own frame; `normal` points out of the solid, in the plane's frame. The force acts in the middle
    of the line, at the place on the axis. A cylinder that may tilt is refused, because its line contact would become
    one point at a jump: give it two `RimOnPlane`, one for each end.
    """

    cylinder: Point
    axis: Direction
    radius: Scalar
    length: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "cylinder_on_plane"
    form: ClassVar[str] = "line"
    measures: ClassVar[Mapping[str, Slot]] = {"radius": LENGTH, "length": LENGTH}

    @property
    def first_radius(self) -> Any:
        """Radius [m]."""
        return self.radius

    @property
    def geometry(self) -> dict[str, Any]:
        """Radius of relative curvature `R_eff`, smaller radius, and length of the line [m]."""
        return {"R_eff": self.radius, "R_min": self.radius, "L": self.length}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius, axis and length of the cylinder, normal of the plane, for landmarks."""
        cylinder = {"radius": self.radius, "axis": in_body(self.cylinder, self.axis), "length": self.length}
        return cylinder, {"normal": in_body(self.plane, self.normal)}

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return LyingCylinder(self, kinematics)


@dataclass(frozen=True)
class RimOnPlane(Pair):
    """Sharp rim of a disc of `radius` about `axis` that may touch a plane with its lowest point.

    The disc is the end of a cylinder or a wheel. A tilted cylinder rests on one rim, a lying one on both: as two of
    these pairs. A disc that lies flat has no lowest point, and no gap: the simulation stops there.
    """

    disc: Point
    axis: Direction
    radius: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "rim_on_plane"
    measures: ClassVar[Mapping[str, Slot]] = {"radius": LENGTH}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius and axis of the disc, normal of the plane, for landmarks."""
        disc = {"radius": self.radius, "axis": in_body(self.disc, self.axis)}
        return disc, {"normal": in_body(self.plane, self.normal)}

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return Rim(self, kinematics)


class Face(Touch):
    """A plane, and a sphere, a cylinder or a corner on it."""

    proved: ClassVar[bool] = True

    @cached_property
    def direction(self) -> Vector:
        """Normal of the plane."""
        return self.named(self.kin.direction(self.second, self.pair.normal), "direction")

    @cached_property
    def normal(self) -> Vector:
        """Normal of the plane, or of its worn track."""
        return self.direction if self.stretch is None else self.named(self.worn.normal, "normal")

    @cached_property
    def gap(self) -> Any:
        """Height over the plane, less the radius, which wear shortens."""
        radius = sp.sympify(self.pair.first_radius) - (0 if self.worn is None else self.worn.depth)
        return self.let(dot(self.direction, self.apart) - radius, "gap")

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield faults of wear that does not fit the motion."""
        yield from super().faults(length)
        if self.worn is not None:
            yield from self.worn.faults()


class LyingCylinder(Face):
    """Cylinder whose axis stays parallel to the plane."""

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield the fault of an axis that may tilt."""
        axis = self.kin.direction(self.first, self.pair.axis)
        if dot(axis, self.normal) != 0:
            yield Fault(f"pair {self.pair.name}", f"a cylinder on {self.first.body.name} that may tilt against the plane",
                        "an axis that the joints keep parallel to it: a line contact would become a point at a jump",
                        "Give it a RimOnPlane for each end.")  # fmt: skip


class Rim(Face):
    """Lowest point of a disc's rim over a plane."""

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
