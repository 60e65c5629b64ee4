"""Joints: what a child may do against its parent. Declarations only.

A joint is a chain of freedoms, from the parent outwards. Each is a turn about a fixed axis, a slide along one, or a ball, which lets the child turn
in every way. Directions are given in the axes of the joint's point on the parent, which are its body's unless the point is `turned`; they coincide
with those of the point on the child where all coordinates are zero.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, NamedTuple

from hertzwerk.derive.algebra.vectors import along
from hertzwerk.derive.mechanism.bodies import Direction, Frame, Point, Slot, X, Y, Z


class Port(NamedTuple):
    """One coordinate or speed: its full name, `<joint>.<name>`, and its unit."""

    name: str
    unit: str


@dataclass(frozen=True)
class Freedom:
    """One freedom of a joint.

    key          what drives and starts call it: the joint's name where this is all the joint lets happen, else `<joint>.<coordinate>`
    axis         of a turn or a slide
    coordinates  of a turn its angle, of a slide its travel, of a ball the unit quaternion q0 + q1 i + q2 j + q3 k that turns the child's axes
    speeds       the coordinate's rate; of a ball the angular velocity against the parent in the child's axes, which needs no further rotation
                 where it is used, in the child's equations; rates of the quaternion follow from it: there are four of them
    forces       generalised force per speed
    """

    kind: Literal["turn", "slide", "ball"]
    key: str
    axis: Direction | None
    coordinates: tuple[Port, ...]
    speeds: tuple[Port, ...]
    forces: tuple[Port, ...]

    @property
    def scalar(self) -> bool:
        """Whether its one coordinate's rate is its one speed."""
        return self.kind != "ball"

    @property
    def units(self) -> tuple[str, str, str]:
        """Of a scalar one: coordinate, speed, generalised force."""
        return self.coordinates[0].unit, self.speeds[0].unit, self.forces[0].unit


@dataclass(frozen=True)
class Joint:
    """A joint between a parent and a child; both may be given as a body (its origin and axes) or a point."""

    name: str
    parent: Point
    child: Point

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point) -> None:
        object.__setattr__(self, "name", name)
        object.__setattr__(self, "parent", _point(parent))
        object.__setattr__(self, "child", _point(child))

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """From the parent outwards."""
        raise NotImplementedError

    @property
    def directions(self) -> dict[str, Direction]:
        """The directions it is declared with, by field."""
        return {}

    def slots(self) -> Iterator[Slot]:
        """The coordinates of the joint's two points, and its directions."""
        yield from self.parent.slots()
        yield from self.child.slots()
        for name, direction in self.directions.items():
            yield from direction.slots(f"joint {self.name}, {name}")

    def _one(self, kind: Literal["turn", "slide"], axis: Direction, coordinate: str) -> tuple[Freedom, ...]:
        """The only freedom of a joint, whose speed is just `speed`."""
        return (_scalar(kind, self.name, axis, f"{self.name}.{coordinate}", f"{self.name}.speed"),)

    def _of_several(self, kind: Literal["turn", "slide"], axis: Direction, coordinate: str) -> Freedom:
        key = f"{self.name}.{coordinate}"
        return _scalar(kind, key, axis, key, f"{key}_speed")

    def _ball(self) -> Freedom:
        return Freedom(
            "ball",
            f"{self.name}.quaternion",
            None,
            tuple(Port(f"{self.name}.q{i}", "1") for i in range(4)),
            tuple(Port(f"{self.name}.angular_speed_{axis}", "rad/s") for axis in "xyz"),
            tuple(Port(f"{self.name}.moment_{axis}", "N m") for axis in "xyz"),
        )


def _scalar(kind: Literal["turn", "slide"], key: str, axis: Direction, coordinate: str, speed: str) -> Freedom:
    units = ("rad", "rad/s", "N m") if kind == "turn" else ("m", "m/s", "N")
    ports = [(Port(name, unit),) for name, unit in zip((coordinate, speed, key), units, strict=True)]
    return Freedom(kind, key, axis, *ports)


def _point(place: Frame | Point) -> Point:
    return place if isinstance(place, Point) else Point(place)


@dataclass(frozen=True, init=False)
class _OfOneAxis(Joint):
    axis: Direction

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, axis: Direction) -> None:
        super().__init__(name, parent, child)
        object.__setattr__(self, "axis", axis)

    @property
    def directions(self) -> dict[str, Direction]:
        """The axis."""
        return {"axis": self.axis}


class Revolute(_OfOneAxis):
    """One rotation about `axis`: `angle`."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The angle."""
        return self._one("turn", self.axis, "angle")


class Prismatic(_OfOneAxis):
    """One translation along `axis`, `travel`; the child keeps the parent's orientation."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The travel."""
        return self._one("slide", self.axis, "travel")


class Cylindrical(_OfOneAxis):
    """A translation along `axis` and a rotation about it: `travel`, `angle`."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Travel, then angle."""
        return (self._of_several("slide", self.axis, "travel"), self._of_several("turn", self.axis, "angle"))


@dataclass(frozen=True, init=False)
class Planar(Joint):
    """Motion in a plane: two translations and the rotation about the `normal`, one of X, Y, Z.

    The translations, `x` and `y`, are along the two axes that follow the normal cyclically (of Z: X and Y); `angle` turns the first to the second.
    """

    normal: Direction

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, normal: Direction = Z) -> None:
        super().__init__(name, parent, child)
        object.__setattr__(self, "normal", normal)

    @property
    def directions(self) -> dict[str, Direction]:
        """The normal."""
        return {"normal": self.normal}

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Both translations in the parent's axes, then the angle."""
        k = along(self.normal.unit) or 0
        first, second = (X, Y, Z)[(k + 1) % 3], (X, Y, Z)[(k + 2) % 3]
        return (
            self._of_several("slide", first, "x"),
            self._of_several("slide", second, "y"),
            self._of_several("turn", self.normal, "angle"),
        )


@dataclass(frozen=True, init=False)
class Universal(Joint):
    """Two rotations: `angle_1` about `first`, fixed in the parent, then `angle_2` about `second`, fixed in the child; the axes need not be square."""

    first: Direction
    second: Direction

    def __init__(
        self, name: str, parent: Frame | Point, child: Frame | Point, first: Direction = X, second: Direction = Y
    ) -> None:
        super().__init__(name, parent, child)
        object.__setattr__(self, "first", first)
        object.__setattr__(self, "second", second)

    @property
    def directions(self) -> dict[str, Direction]:
        """Both axes."""
        return {"first": self.first, "second": self.second}

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The two angles."""
        return (self._of_several("turn", self.first, "angle_1"), self._of_several("turn", self.second, "angle_2"))


class Spherical(Joint):
    """Any rotation about a common point: a unit quaternion `q0`..`q3`, and the angular velocity `angular_speed_x`.. in the child's axes."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The orientation."""
        return (self._ball(),)


class Free(Joint):
    """No constraint: the child's point at `x`, `y`, `z` of the parent's axes, oriented by a unit quaternion `q0`..`q3`.

    Speeds are those of the point in the parent's axes, `x_speed`.., and the angular velocity in the child's, `angular_speed_x`..: with the point at
    the mass centre the mass matrix is then constant and diagonal.
    """

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Three translations, then the orientation."""
        slides = (self._of_several("slide", axis, name) for axis, name in zip((X, Y, Z), "xyz", strict=True))
        return (*slides, self._ball())


class Weld(Joint):
    """No freedom: the child is part of its parent."""

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """None."""
        return ()
