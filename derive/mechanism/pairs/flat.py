"""A sphere, a cylinder or the rim of a disc on a plane."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.mechanism.bodies import Direction, Point, Slot
from hertzwerk.derive.mechanism.pairs.pair import Pair, in_body
from hertzwerk.derive.mechanism.parameter import POSITIVE, Scalar


@dataclass(frozen=True)
class SphereOnPlane(Pair):
    """A sphere that may touch a plane; `normal` points out of the solid, in the plane's frame."""

    sphere: Point
    radius: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "sphere_on_plane"

    @property
    def first_radius(self) -> Any:
        """From the first place to the contact point [m]."""
        return self.radius

    @property
    def geometry(self) -> dict[str, Any]:
        """What laws may ask for: the radius of relative curvature `R_eff` and the smaller radius `R_min` [m]."""
        return {"R_eff": self.radius, "R_min": self.radius, "R_2": self.radius}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """What a picture shows of them."""
        return {"radius": self.radius}, {"normal": in_body(self.plane, self.normal)}


@dataclass(frozen=True)
class CylinderOnPlane(Pair):
    """A cylinder that may touch a plane along a line of `length`: its `axis`, in its own frame, stays parallel to the plane.

    `normal` points out of the solid, in the plane's frame. The force acts in the middle of the line, at the place on the axis. A cylinder that may
    tilt is refused, because its line contact would become one point at a jump: give it two `RimOnPlane`, one for each end.
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
        """[m]."""
        return self.radius

    @property
    def geometry(self) -> dict[str, Any]:
        """The radius of relative curvature `R_eff`, the smaller radius, and the length of the line [m]."""
        return {"R_eff": self.radius, "R_min": self.radius, "L": self.length}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """What a picture shows of them."""
        beside = {"radius": self.radius, "axis": in_body(self.cylinder, self.axis), "length": self.length}
        return beside, {"normal": in_body(self.plane, self.normal)}


@dataclass(frozen=True)
class RimOnPlane(Pair):
    """The sharp rim of a disc of `radius` about `axis`, the end of a cylinder or a wheel, that may touch a plane with its lowest point.

    A tilted cylinder rests on one rim, a lying one on both: as two of these pairs. A disc that lies flat has no lowest point, and no gap: the
    simulation stops there.
    """

    disc: Point
    axis: Direction
    radius: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "rim_on_plane"

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """What a picture shows of them."""
        beside = {"radius": self.radius, "axis": in_body(self.disc, self.axis)}
        return beside, {"normal": in_body(self.plane, self.normal)}
