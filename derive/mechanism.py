"""What a mechanism is made of: materials, bodies, points, joints, contact pairs. Declarations only, no equations.

Every record is frozen and knows its own faults; the scene that uses them gathers all faults and refuses to exist while there is one.
Frames: each body carries a frame; a joint's axis is given in the frame of its parent, and both frames are parallel at zero coordinate.
Slots for dimensional quantities take a `Parameter`, an expression of parameters, or 0; a bare number has no unit and is a fault.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.parameter import NOT_NEGATIVE, POSITIVE, Interval, Scalar

Triple = tuple[Any, Any, Any]


@dataclass(frozen=True)
class Direction:
    """A unit vector in a frame: along an axis, `-Y` the opposite one; of gravity any other too, in rationals such as (3/5, -4/5, 0)."""

    components: tuple[Any, Any, Any]

    def __neg__(self) -> Direction:
        x, y, z = self.components
        return Direction((-x, -y, -z))


X = Direction((1, 0, 0))
Y = Direction((0, 1, 0))
Z = Direction((0, 0, 1))


@dataclass(frozen=True)
class Slot:
    """One quantity a record asks for: where it stands, what was given, its unit, and the ranges (SI) it must and should keep."""

    where: str
    value: Scalar
    unit: str
    limit: Interval | None = None
    recommended: Interval | None = None


@dataclass(frozen=True)
class Material:
    """Linear elastic material: Young's modulus [Pa], Poisson's ratio [1], density [kg/m^3] if known."""

    youngs_modulus: Scalar
    poissons_ratio: Scalar
    density: Scalar | None = None

    def slots(self) -> Iterator[Slot]:
        """The quantities of the material."""
        yield Slot("material, Young's modulus", self.youngs_modulus, "Pa", POSITIVE)
        yield Slot("material, Poisson's ratio", self.poissons_ratio, "1", Interval(-1, 0.5, open_left=True))
        if self.density is not None:
            yield Slot("material, density", self.density, "kg/m^3", POSITIVE)


@dataclass(frozen=True)
class Body:
    """A rigid body: mass [kg], inertia about its mass centre [kg m^2], mass centre in its own frame [m].

    A scalar inertia is for the axis of the joint that turns the body (plane motion); a triple holds the principal values along the frame's axes.
    """

    name: str
    mass: Scalar
    inertia: Scalar | Triple = 0
    centre: Triple = (0, 0, 0)

    def at(self, x: Scalar, y: Scalar, z: Scalar) -> Point:
        """The point fixed in the body at (x, y, z) [m] of its frame."""
        return Point(self, (x, y, z))

    def slots(self) -> Iterator[Slot]:
        """The quantities of the body."""
        yield Slot(f"body {self.name}, mass", self.mass, "kg", POSITIVE)
        inertia = self.inertia if isinstance(self.inertia, tuple) else (self.inertia,)
        for value in inertia:
            yield Slot(f"body {self.name}, inertia", value, "kg m^2", NOT_NEGATIVE)
        for value in self.centre:
            yield Slot(f"body {self.name}, mass centre", value, "m")


@dataclass(frozen=True)
class Ground:
    """The frame that does not move."""

    name: ClassVar[str] = "ground"

    def at(self, x: Scalar, y: Scalar, z: Scalar) -> Point:
        """The fixed point (x, y, z) [m]."""
        return Point(self, (x, y, z))


GROUND = Ground()
Frame = Body | Ground


@dataclass(frozen=True)
class Point:
    """A point fixed in a body or in the ground."""

    body: Frame
    position: Triple = (0, 0, 0)

    def slots(self) -> Iterator[Slot]:
        """The coordinates of the point."""
        for value in self.position:
            yield Slot(f"point of {self.body.name}", value, "m")


def _point(place: Frame | Point) -> Point:
    return place if isinstance(place, Point) else Point(place)


@dataclass(frozen=True)
class Joint:
    """A joint with one coordinate between a parent and a child; both may be given as a body (its origin) or a point."""

    name: str
    parent: Point
    child: Point
    axis: Direction

    motion: ClassVar[str]
    coordinate_unit: ClassVar[str]
    speed_unit: ClassVar[str]
    force_unit: ClassVar[str]

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, axis: Direction) -> None:
        object.__setattr__(self, "name", name)
        object.__setattr__(self, "parent", _point(parent))
        object.__setattr__(self, "child", _point(child))
        object.__setattr__(self, "axis", axis)

    def slots(self) -> Iterator[Slot]:
        """The coordinates of the joint's two points."""
        yield from self.parent.slots()
        yield from self.child.slots()


class Revolute(Joint):
    """One rotation about `axis`."""

    motion = "angle"
    coordinate_unit = "rad"
    speed_unit = "rad/s"
    force_unit = "N m"


class Prismatic(Joint):
    """One translation along `axis`; the child keeps the parent's orientation."""

    motion = "travel"
    coordinate_unit = "m"
    speed_unit = "m/s"
    force_unit = "N"


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
        yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)


Pair = SphereOnPlane | SphereOnSphere | PinInBush | ParallelCylinders


@dataclass(frozen=True)
class Mechanism:
    """Bodies joined into a tree that grows from the ground, and the pairs that may touch."""

    name: str
    joints: tuple[Joint, ...]
    pairs: tuple[Pair, ...] = ()

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The children of the joints, in the order of the joints."""
        return tuple(joint.child.body for joint in self.joints if isinstance(joint.child.body, Body))

    def joint_of(self, body: Frame) -> Joint | None:
        """The joint that carries `body`; None for the ground."""
        return next((joint for joint in self.joints if joint.child.body == body), None)

    def turning_axis(self, body: Frame) -> Direction | None:
        """Axis of the nearest revolute joint between `body` and the ground, in the parent's frame of that joint."""
        joint = self.joint_of(body)
        if joint is None or isinstance(joint, Revolute):
            return None if joint is None else joint.axis
        return self.turning_axis(joint.parent.body)

    def slots(self) -> Iterator[Slot]:
        """Every quantity of the mechanism, in declared order."""
        for body in self.bodies:
            yield from body.slots()
        for part in (*self.joints, *self.pairs):
            yield from part.slots()
