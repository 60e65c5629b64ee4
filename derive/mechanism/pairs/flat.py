"""Pairs of a plane with a sphere, a cylinder or the rim of a disc."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.mechanism.bodies import Direction, Point, Slot
from hertzwerk.derive.mechanism.pairs.pair import Pair, in_body
from hertzwerk.derive.mechanism.parameter import POSITIVE, Scalar


@dataclass(frozen=True)
class SphereOnPlane(Pair):
    """Sphere that may touch a plane; `normal` points out of the solid, in the plane's frame."""

    sphere: Point
    radius: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "sphere_on_plane"

    @property
    def first_radius(self) -> Any:
        """Distance from the first place to the contact point [m]."""
        return self.radius

    @property
    def geometry(self) -> dict[str, Any]:
        """Geometry for laws: radius of relative curvature `R_eff`, smaller radius `R_min` [m]."""
        return {"R_eff": self.radius, "R_min": self.radius, "R_2": self.radius}

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius and normal, for landmarks."""
        return {"radius": self.radius}, {"normal": in_body(self.plane, self.normal)}


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

    @property
    def first_radius(self) -> Any:
        """Radius [m]."""
        return self.radius

    @property
    def geometry(self) -> dict[str, Any]:
        """Radius of relative curvature `R_eff`, smaller radius, and length of the line [m]."""
        return {"R_eff": self.radius, "R_min": self.radius, "L": self.length}

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius, axis and length of the cylinder, normal of the plane, for landmarks."""
        beside = {"radius": self.radius, "axis": in_body(self.cylinder, self.axis), "length": self.length}
        return beside, {"normal": in_body(self.plane, self.normal)}


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

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius and axis of the disc, normal of the plane, for landmarks."""
        beside = {"radius": self.radius, "axis": in_body(self.disc, self.axis)}
        return beside, {"normal": in_body(self.plane, self.normal)}
