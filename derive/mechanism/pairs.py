"""Contact pairs: which surfaces of two bodies may touch. Declarations only, no equations.

A pair pushes its first place along a unit vector out of the second's solid; `first_radius` lies between that place and the contact point. `form` is
what the surfaces touch in, a point, a line or a surface: laws are made for one of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.mechanism.bodies import Direction, Point, Slot
from hertzwerk.derive.mechanism.parameter import POSITIVE, Scalar

Components = tuple[Any, Any, Any]
JOURNALS = ("pin_in_bush", "ball_in_socket")  # kinds that stand for a joint, which a start closes


@dataclass(frozen=True)
class SphereOnPlane:
    """A sphere that may touch a plane; `normal` points out of the solid, in the plane's frame."""

    name: str
    sphere: Point
    radius: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "sphere_on_plane"
    form: ClassVar[str] = "point"

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
    form: ClassVar[str] = "point"
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

    Only laws of line contact ask for its `length`: where none does, it is no parameter of the scene.
    """

    name: str
    pin: Point
    bush: Point
    axis: Direction
    bush_radius: Scalar
    clearance: Scalar
    length: Scalar | None = None
    kind: ClassVar[str] = "pin_in_bush"
    form: ClassVar[str] = "line"
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
            yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE, asked_as=f"{self.name}.L")
        yield from self.axis.slots(f"pair {self.name}, axis")
        for point in self.places:
            yield from point.slots()


@dataclass(frozen=True)
class ParallelCylinders(SphereOnSphere):
    """Two cylinders that may touch from outside along a line of `length`, axes along `axis` of the second's frame."""

    axis: Direction
    length: Scalar
    kind: ClassVar[str] = "parallel_cylinders"
    form: ClassVar[str] = "line"

    @property
    def geometry(self) -> dict[str, Any]:
        """That of two spheres of the same radii, and the length [m]."""
        return {**super().geometry, "L": self.length}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield from super().slots()
        yield from self.axis.slots(f"pair {self.name}, axis")
        yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)


@dataclass(frozen=True)
class BallInSocket:
    """A spherical joint with clearance: a ball of radius `socket_radius - clearance` free inside a hollow sphere."""

    name: str
    ball: Point
    socket: Point
    socket_radius: Scalar
    clearance: Scalar
    kind: ClassVar[str] = "ball_in_socket"
    form: ClassVar[str] = "point"
    inside: ClassVar[bool] = True

    @property
    def places(self) -> tuple[Point, Point]:
        """The two centres: the ball's, then the socket's."""
        return self.ball, self.socket

    @property
    def first_radius(self) -> Any:
        """The ball's [m]."""
        return self.socket_radius - self.clearance

    @property
    def geometry(self) -> dict[str, Any]:
        """`R_eff = R1 R2/(R1 - R2)` of socket and ball (their difference is the clearance), and both radii [m]."""
        ball = self.first_radius
        return {
            "R_eff": self.socket_radius * ball / self.clearance,
            "R_min": ball,
            "R_1": self.socket_radius,
            "R_2": ball,
            "dR": self.clearance,
        }

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, socket radius", self.socket_radius, "m", POSITIVE)
        yield Slot(f"pair {self.name}, clearance", self.clearance, "m", POSITIVE)
        if isinstance(self.socket_radius, sp.Expr) and isinstance(self.clearance, sp.Expr):
            yield Slot(
                f"pair {self.name}, ball radius (socket radius minus clearance)", self.first_radius, "m", POSITIVE
            )
        for point in self.places:
            yield from point.slots()


@dataclass(frozen=True)
class CylinderOnPlane:
    """A cylinder that may touch a plane along a line of `length`: its `axis`, in its own frame, stays parallel to the plane.

    `normal` points out of the solid, in the plane's frame. The force acts in the middle of the line, at the place on the axis. A cylinder that may
    tilt is refused, because its line contact would become one point at a jump: give it two `RimOnPlane`, one for each end.
    """

    name: str
    cylinder: Point
    axis: Direction
    radius: Scalar
    length: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "cylinder_on_plane"
    form: ClassVar[str] = "line"

    @property
    def places(self) -> tuple[Point, Point]:
        """The middle of the axis, then the plane."""
        return self.cylinder, self.plane

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
        yield from self.axis.slots(f"pair {self.name}, axis")
        yield from self.normal.slots(f"pair {self.name}, normal")
        for point in self.places:
            yield from point.slots()


@dataclass(frozen=True)
class RimOnPlane:
    """The sharp rim of a disc of `radius` about `axis`, the end of a cylinder or a wheel, that may touch a plane with its lowest point.

    A tilted cylinder rests on one rim, a lying one on both: as two of these pairs. A disc that lies flat has no lowest point, and no gap: the
    simulation stops there.
    """

    name: str
    disc: Point
    axis: Direction
    radius: Scalar
    plane: Point
    normal: Direction
    kind: ClassVar[str] = "rim_on_plane"
    form: ClassVar[str] = "point"
    first_radius: ClassVar[Any] = 0

    @property
    def places(self) -> tuple[Point, Point]:
        """The disc's centre, then the plane."""
        return self.disc, self.plane

    @property
    def geometry(self) -> dict[str, Any]:
        """Nothing: an edge has no radius of curvature."""
        return {}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        yield from self.axis.slots(f"pair {self.name}, axis")
        yield from self.normal.slots(f"pair {self.name}, normal")
        for point in self.places:
            yield from point.slots()


@dataclass(frozen=True)
class CornerOnFace:
    """A corner, or any point, of one body that may touch a plane face of another.

    `face` is the middle of the face, `normal` points out of its solid, in the frame of `face`. With a `length` the face, and the solid below
    it, end at length/2 to both sides `along` it: beyond them the corner is free, and from there it meets the end of the solid, not its face.
    """

    name: str
    corner: Point
    face: Point
    normal: Direction
    along: Direction | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "corner_on_face"
    form: ClassVar[str] = "point"
    first_radius: ClassVar[Any] = 0

    @property
    def places(self) -> tuple[Point, Point]:
        """The corner, then the middle of the face."""
        return self.corner, self.face

    @property
    def geometry(self) -> dict[str, Any]:
        """Nothing: a corner has no radius of curvature."""
        return {}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair."""
        if self.length is not None:
            yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)
        if self.along is not None:
            yield from self.along.slots(f"pair {self.name}, along")
        yield from self.normal.slots(f"pair {self.name}, normal")
        for point in self.places:
            yield from point.slots()


class PoseSymbol(sp.Symbol):  # type: ignore[misc]  # SymPy is untyped
    """A coordinate of a pair's first place, or of its axes, in the axes of the second."""

    __slots__ = ("unit",)

    def __new__(cls, name: str, unit: str) -> PoseSymbol:
        """A symbol of its own: never taken from SymPy's cache."""
        self = sp.Symbol.__xnew__(cls, name, real=True)
        self.unit = unit
        return self  # type: ignore[no-any-return]

    def _hashable_content(self) -> tuple[Any, ...]:
        return (self.name, self.unit)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        return (self.name, self.unit), {}


APART = tuple(PoseSymbol(f"apart_{k}", "m") for k in "xyz")
"""From the second place to the first, along the axes of the second [m]."""
TURN = tuple(tuple(PoseSymbol(f"turn_{i}{k}", "1") for k in "xyz") for i in "xyz")
"""Rotation from the axes of the first place to those of the second: its columns are the first's axes."""


@dataclass(frozen=True)
class Posed(Slot):
    """A quantity that may vary with the pose of one body against another: `APART`, `TURN`."""


@dataclass(frozen=True)
class CustomPair:
    """Surfaces of the user's: gap, normal and contact point as expressions of `APART`, `TURN` and parameters, along the axes of the second place.

    gap            signed distance of the surfaces [m], negative while they penetrate
    normal         unit vector that pushes the first body, (x, y, z)
    contact_point  the point both bodies touch at, from the second place, (x, y, z) [m]

    The rest is derived. `radius` [m] is that of relative curvature, for laws that ask; `length` [m] that of the line, where they touch along one:
    else their contact is a point. A gap whose rate is not the speed at which the bodies approach along the normal at the contact point is refused:
    its forces would not keep the energy.
    """

    name: str
    first: Point
    second: Point
    gap: Scalar
    normal: Components
    contact_point: Components
    radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "custom"
    first_radius: ClassVar[Any] = 0

    @property
    def form(self) -> str:
        """A line where it has a length."""
        return "point" if self.length is None else "line"

    @property
    def places(self) -> tuple[Point, Point]:
        """The two places."""
        return self.first, self.second

    @property
    def geometry(self) -> dict[str, Any]:
        """The radius and the length, if given."""
        given = {"R_eff": self.radius, "R_min": self.radius, "L": self.length}
        return {name: value for name, value in given.items() if value is not None}

    def slots(self) -> Iterator[Slot]:
        """The expressions and the places."""
        yield Posed(f"pair {self.name}, gap", self.gap, "m")
        for what, values, unit in (("normal", self.normal, "1"), ("contact point", self.contact_point, "m")):
            for axis, value in zip("xyz", values, strict=True):
                yield Posed(f"pair {self.name}, {what}, {axis}", value, unit)
        if self.radius is not None:
            yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        if self.length is not None:
            yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE, asked_as=f"{self.name}.L")
        for point in self.places:
            yield from point.slots()


Pair = (
    SphereOnPlane
    | SphereOnSphere
    | PinInBush
    | ParallelCylinders
    | BallInSocket
    | CylinderOnPlane
    | RimOnPlane
    | CornerOnFace
    | CustomPair
)
