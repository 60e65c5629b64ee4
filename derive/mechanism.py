"""What a mechanism is made of: bodies, joints, contact pairs. Declarations only, no equations.

Every record is frozen and knows its own faults; the scene that uses them gathers all faults and refuses to exist while there is one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.frames import GROUND, Body, Direction, Frame, Ground, Material, Point, Slot, X, Y, Z
from hertzwerk.derive.joints import (
    Cylindrical,
    Free,
    Freedom,
    Joint,
    Planar,
    Prismatic,
    Revolute,
    Spherical,
    Universal,
    Weld,
)
from hertzwerk.derive.parameter import POSITIVE, Scalar
from hertzwerk.derive.vectors import along


@dataclass(frozen=True)
class SphereOnPlane:
    """A sphere that may touch a plane; `normal` points out of the solid, in the plane's frame."""

    name: str
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
    def places(self) -> tuple[Point, Point]:
        """The point that feels +F along the contact normal, then its partner."""
        return self.sphere, self.plane

    @property
    def geometry(self) -> dict[str, Any]:
        """What laws may ask for: the radius of relative curvature `R_eff` and the smaller radius `R_min` [m]."""
        return {"R_eff": self.radius, "R_min": self.radius, "R_2": self.radius}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield from self.normal.slots(f"pair {self.name}, normal")
        for point in self.places:
            yield from point.slots()


@dataclass(frozen=True)
class SphereOnSphere:
    """Two spheres that may touch from outside."""

    name: str
    first: Point
    second: Point
    radius_first: Scalar
    radius_second: Scalar
    kind: ClassVar[str] = "sphere_on_sphere"
    inside: ClassVar[bool] = False

    @property
    def first_radius(self) -> Any:
        """From the first place to the contact point [m]."""
        return self.radius_first

    @property
    def places(self) -> tuple[Point, Point]:
        """The two centres."""
        return self.first, self.second

    @property
    def geometry(self) -> dict[str, Any]:
        """`R_eff = R1 R2/(R1 + R2)`, both radii, the smaller one and their sum [m]."""
        r1, r2 = self.radius_first, self.radius_second
        return {"R_eff": r1 * r2 / (r1 + r2), "R_min": sp.Min(r1, r2), "R_1": r1, "R_2": r2, "dR": r1 + r2}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, first radius", self.radius_first, "m", POSITIVE)
        yield Slot(f"pair {self.name}, second radius", self.radius_second, "m", POSITIVE)
        for point in self.places:
            yield from point.slots()


@dataclass(frozen=True)
class PinInBush:
    """A revolute joint with clearance: a pin of radius `bush_radius - clearance` free inside a bush, axes along `axis` of the bush's frame.

    With a `length` it offers the line contact of parallel cylinders to laws that ask for one.
    """

    name: str
    pin: Point
    bush: Point
    axis: Direction
    bush_radius: Scalar
    clearance: Scalar
    length: Scalar | None = None
    kind: ClassVar[str] = "pin_in_bush"
    inside: ClassVar[bool] = True

    @property
    def places(self) -> tuple[Point, Point]:
        """Pin centre, then bush centre."""
        return self.pin, self.bush

    @property
    def pin_radius(self) -> Any:
        """[m]."""
        return self.bush_radius - self.clearance

    first_radius = pin_radius

    @property
    def geometry(self) -> dict[str, Any]:
        """`R_eff = R1 R2/(R1 - R2)` of bush and pin (their difference is the clearance), and the pin's radius [m]."""
        return {
            "R_eff": self.bush_radius * self.pin_radius / self.clearance,
            "R_min": self.pin_radius,
            "R_1": self.bush_radius,
            "R_2": self.pin_radius,
            "dR": self.clearance,
            **({} if self.length is None else {"L": self.length}),
        }

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, bush radius", self.bush_radius, "m", POSITIVE)
        yield Slot(f"pair {self.name}, clearance", self.clearance, "m", POSITIVE)
        if isinstance(self.bush_radius, sp.Expr) and isinstance(self.clearance, sp.Expr):
            yield Slot(f"pair {self.name}, pin radius (bush radius minus clearance)", self.pin_radius, "m", POSITIVE)
        if self.length is not None:
            yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)
        yield from self.axis.slots(f"pair {self.name}, axis")
        for point in self.places:
            yield from point.slots()


@dataclass(frozen=True)
class ParallelCylinders(SphereOnSphere):
    """Two cylinders that may touch from outside along a line of `length`, axes along `axis` of the second's frame."""

    axis: Direction
    length: Scalar
    kind: ClassVar[str] = "parallel_cylinders"

    @property
    def geometry(self) -> dict[str, Any]:
        """That of two spheres of the same radii, and the length [m]."""
        return {**super().geometry, "L": self.length}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield from super().slots()
        yield from self.axis.slots(f"pair {self.name}, axis")
        yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)


Pair = SphereOnPlane | SphereOnSphere | PinInBush | ParallelCylinders


@dataclass(frozen=True)
class Mechanism:
    """Bodies joined by joints, and the pairs that may touch.

    The first joint to reach a body carries it: these joints are the tree, whose coordinates are the mechanism's. Any later joint to a body
    closes a loop, and is a constraint.
    """

    name: str
    joints: tuple[Joint, ...]
    pairs: tuple[Pair, ...] = ()

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The children of the tree's joints, in their order."""
        return tuple(joint.child.body for joint in self.tree if isinstance(joint.child.body, Body))

    @cached_property
    def tree(self) -> tuple[Joint, ...]:
        """The joints that carry a body, from the ground outwards."""
        found: dict[Frame, Joint] = {}
        for joint in self.joints:
            found.setdefault(joint.child.body, joint)
        return tuple(found.values())

    @cached_property
    def closures(self) -> tuple[Joint, ...]:
        """The joints that close a loop."""
        tree = {id(joint) for joint in self.tree}
        return tuple(joint for joint in self.joints if id(joint) not in tree)

    def joint_of(self, body: Frame) -> Joint | None:
        """The joint that carries `body`; None for the ground."""
        return next((joint for joint in self.joints if joint.child.body == body), None)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Those of the tree's joints, in order."""
        return tuple(freedom for joint in self.tree for freedom in joint.freedoms)

    @cached_property
    def plane(self) -> int | None:
        """Coordinate axis across the plane all bodies move in, by structure: all turns are about it, all slides across it. None in space."""
        return next((k for k in (2, 1, 0) if all(_stays_across(joint, k) for joint in self.joints)), None)

    def slots(self) -> Iterator[Slot]:
        """Every quantity of the mechanism, in declared order."""
        for body in self.bodies:
            yield from body.slots()
        for part in (*self.joints, *self.pairs):
            yield from part.slots()


def _stays_across(joint: Joint, k: int) -> bool:
    """Whether a joint turns about a coordinate axis and slides across it, its points' axes included."""
    turned = (axis for point in (joint.parent, joint.child) for axis, _ in point.turns)
    turns = (freedom.axis for freedom in joint.freedoms if freedom.kind != "slide")
    slides = (freedom.axis for freedom in joint.freedoms if freedom.kind == "slide")
    return all(axis is not None and along(axis.unit) == k for axis in (*turned, *turns)) and all(
        axis is not None and axis.unit[k] == 0 for axis in slides
    )


__all__ = [
    "GROUND",
    "Body",
    "Cylindrical",
    "Direction",
    "Frame",
    "Free",
    "Freedom",
    "Ground",
    "Joint",
    "Material",
    "Mechanism",
    "Pair",
    "ParallelCylinders",
    "PinInBush",
    "Planar",
    "Point",
    "Prismatic",
    "Revolute",
    "Slot",
    "SphereOnPlane",
    "SphereOnSphere",
    "Spherical",
    "Universal",
    "Weld",
    "X",
    "Y",
    "Z",
]
