"""Joints as chains of freedoms between parent and child, and their consequences. Declarations only.

The freedoms go from the parent outwards; each is a turn about a fixed axis, a slide along one, or a ball, which lets
the child turn about every axis. Directions are given in the axes of the joint's point on the parent, which are its
body's unless the point is `turned`; they coincide with those of the point on the child where all coordinates are
zero.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, fields
from functools import cached_property
from itertools import pairwise
from typing import Any, ClassVar, Literal, NamedTuple

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.declare.mechanism.bodies import AXES, Direction, Frame, Point
from hertzwerk.derive.declare.mechanism.joints.conditions import (
    CHILD,
    PARENT,
    Carried,
    Coincident,
    Condition,
    ConstantAngle,
    FixedIn,
    NoDisplacement,
    Product,
    Sum,
    across,
    numbers,
    parallel,
    perpendicular,
)
from hertzwerk.derive.expressions.algebra.vectors import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    about,
    add,
    apply,
    cross,
    dot,
    multiply,
)
from hertzwerk.derive.expressions.parameter import Slot

RANK = 1e-9  # residual of a unit vector that counts as linearly dependent


class Port(NamedTuple):
    """One coordinate or speed: its full name, `<joint>.<name>`, and its unit."""

    name: str
    unit: str


@dataclass(frozen=True)
class Freedom:
    """One freedom of a joint.

    key          its name in drives and starts: the joint's name where the joint has one freedom, else `<joint>.<coordinate>`
    axis         of a turn or a slide
    coordinates  of a turn its angle, of a slide its travel, of a ball the unit quaternion q0 + q1 i + q2 j + q3 k of the child's axes
    speeds       the coordinate's rate; of a ball the angular velocity against the parent in the child's axes, in which the child's
                 equations are resolved; the four rates of the quaternion follow from it
                 (`given`, by expressions: a coordinate alone, or a speed alone; `bend`, of a rod: any number, each with its rate)
    forces       generalised force per speed
    """

    kind: Literal["turn", "slide", "ball", "bend", "given"]
    key: str
    axis: Direction | None
    coordinates: tuple[Port, ...]
    speeds: tuple[Port, ...]
    forces: tuple[Port, ...]

    @property
    def scalar(self) -> bool:
        """Whether it has one coordinate, whose rate is its speed."""
        return self.kind in ("turn", "slide")

    @property
    def known_by_key(self) -> bool:
        """Whether its key stands for its coordinate in a start; else each coordinate is named."""
        return self.kind not in ("ball", "bend")

    @property
    def label(self) -> str:
        """Name of its first coordinate within the joint."""
        return self.coordinates[0].name.rsplit(".", 1)[1]

    @property
    def units(self) -> tuple[str, str, str]:
        """Units of coordinate, speed and generalised force of a scalar freedom."""
        return self.coordinates[0].unit, self.speeds[0].unit, self.forces[0].unit


@dataclass(frozen=True)
class Joint:
    """Joint between a parent and a child, each given as a body (its origin and axes) or a point.

    A kind of joint declares its `freedoms`, by `turn`, `slide` and `ball`. Its constraints where it closes a loop,
    its measurable coordinates, landmarks and faults follow from them; a kind may override these.
    """

    name: str
    parent: Point
    child: Point
    carries: ClassVar[bool] = True
    """Whether the first of its kind to reach a body carries it; else another joint does."""
    absolute: ClassVar[bool] = False
    """Whether its coordinates on the ground are absolute coordinates of the body, so that it is kept."""
    bends: ClassVar[bool] = False
    """Whether it is an elastic body between its two, which carries its child in all coordinates and whose load is not read."""

    def __init__(self, name: str, parent: Frame | Point, child: Frame | Point, **entries: Any) -> None:
        if unknown := entries.keys() - {field.name for field in fields(self)}:
            raise TypeError(f"{type(self).__name__}: found {', '.join(sorted(unknown))}, which it has no field for")
        for field, value in {"name": name, "parent": _point(parent), "child": _point(child), **entries}.items():
            object.__setattr__(self, field, value)

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Freedoms from the parent outwards."""
        raise NotImplementedError

    @property
    def directions(self) -> dict[str, Direction]:
        """Declared directions, by field."""
        return {
            field.name: getattr(self, field.name) for field in fields(self) if field.type in ("Direction", Direction)
        }

    def slots(self) -> Iterator[Slot]:
        """Yield the coordinates of the joint's two points, and its directions."""
        yield from self.parent.slots()
        yield from self.child.slots()
        for name, direction in self.directions.items():
            yield from direction.slots(f"joint {self.name}, {name}")

    @property
    def curves(self) -> tuple[Any, ...]:
        """Planar curves among its fields, each a `SolidCurve`."""
        return ()

    # -- freedoms ------------------------------------------------------------------------------------------------------

    def turn(self, axis: Direction, coordinate: str = "angle", alone: bool = False) -> Freedom:
        """Turn about an axis.

        The only freedom of a joint (`alone`) has the joint's name, and its speed is named `speed`.
        """
        return self._scalar("turn", axis, coordinate, alone, ("rad", "rad/s", "N m"))

    def slide(self, axis: Direction, coordinate: str = "travel", alone: bool = False) -> Freedom:
        """Slide along an axis, named as a turn is."""
        return self._scalar("slide", axis, coordinate, alone, ("m", "m/s", "N"))

    def ball(self) -> Freedom:
        """Any rotation: quaternion `q0`..`q3`, angular velocity `angular_speed_x`.. in the child's axes."""
        return Freedom(
            "ball",
            f"{self.name}.quaternion",
            None,
            tuple(Port(f"{self.name}.q{i}", "1") for i in range(4)),
            tuple(Port(f"{self.name}.angular_speed_{axis}", "rad/s") for axis in "xyz"),
            tuple(Port(f"{self.name}.moment_{axis}", "N m") for axis in "xyz"),
        )

    def _scalar(
        self, kind: Literal["turn", "slide"], axis: Direction, coordinate: str, alone: bool, units: tuple[str, str, str]
    ) -> Freedom:
        full = f"{self.name}.{coordinate}"
        names = (full, f"{self.name}.speed", self.name) if alone else (full, f"{full}_speed", full)
        ports = [(Port(name, unit),) for name, unit in zip(names, units, strict=True)]
        return Freedom(kind, names[2], axis, *ports)

    # -- what closes a loop --------------------------------------------------------------------------------------------

    @cached_property
    def turning(self) -> tuple[Direction | None, ...]:
        """Axes of its turns, from the parent outwards; None for a ball."""
        return tuple(freedom.axis for freedom in self.freedoms if freedom.kind != "slide")

    @cached_property
    def sliding(self) -> tuple[tuple[Direction, int], ...]:
        """Axes of its slides, each with the number of turns before it."""
        slides = (freedom for freedom in self.freedoms if freedom.kind == "slide")
        return tuple((slide.axis, self.turns_before(slide)) for slide in slides if slide.axis is not None)

    @property
    def main_axis(self) -> Direction | None:
        """Axis of its first slide, else of its first turn; None without one, as of a ball."""
        return next((axis for axis, _ in self.sliding), next(iter(self.turning), None))

    def turns_before(self, freedom: Freedom) -> int:
        """Number of the joint's turns that carry a freedom."""
        earlier = self.freedoms[: self.freedoms.index(freedom)]
        return sum(other.kind != "slide" for other in earlier)

    def constraints(self) -> tuple[Condition, ...]:
        """Constraints of the joint by its freedoms; raises InputError where no rule is known."""
        return (*self._position_constraints(), *self._orientation_constraints())

    def unruled(self) -> tuple[Fault, ...]:
        """Faults of a joint whose constraints are not known; () where they are."""
        try:
            self.constraints()
        except InputError as error:
            return error.faults
        return ()

    def _position_constraints(self) -> Iterator[Condition]:
        """Yield the constraints on the position of the child's point."""
        slides = self.sliding
        if not slides:
            yield Coincident()
        elif len(slides) == 1:
            ((axis, before),) = slides
            yield from (NoDisplacement(self.carried(direction, before), label) for direction, label in across(axis))
        elif len(slides) == 2:
            (one, before), (two, after) = slides
            if before == after:
                yield NoDisplacement(self.carried(Direction(cross(one.unit, two.unit)), before), "normal")
            else:
                yield NoDisplacement(Product(self.carried(one, before), self.carried(two, after)), "normal")

    def _orientation_constraints(self) -> Iterator[Condition]:
        """Yield the constraints on the orientation of the child."""
        axes = [axis for axis in self.turning if axis is not None]
        skew = not any(parallel(a, b) for a, b in pairwise(axes))
        if not self.turning:
            yield from (ConstantAngle(AXES[k], AXES[(k + 1) % 3], "xyz"[k] + "yzx"[k]) for k in range(3))
        elif len(axes) == len(self.turning) == 1:
            yield from (ConstantAngle(axes[0], direction, label) for direction, label in across(axes[0]))
        elif len(axes) == len(self.turning) == 2 and skew:
            yield ConstantAngle(axes[1], axes[0], "axes")
        elif self.turning != (None,) and not (len(axes) == len(self.turning) == 3 and skew):
            raise self._no_rule("these turns")

    def carried(self, direction: Direction, before: int) -> Carried:
        """Direction carried by the first turns of the joint, in terms of child and parent.

        Raises InputError where it does not follow from them.
        """
        if before == 0 or before == len(self.turning):
            return FixedIn(PARENT if before == 0 else CHILD, direction)
        axes = [axis for axis in self.turning if axis is not None]
        if len(self.turning) != 2 or len(axes) != 2 or parallel(*axes):
            raise self._no_rule("a slide between these turns")
        first, second = axes
        a, b, d = first.unit, second.unit, direction.unit
        cosine, (da, db, dc) = dot(a, b), (dot(d, a), dot(d, b), dot(d, cross(a, b)))
        one, two = FixedIn(PARENT, first), FixedIn(CHILD, second)
        parts = ((da - cosine * db, one), (db - cosine * da, two), (dc, Product(one, two)))
        return Sum(tuple((value / (1 - cosine**2), part) for value, part in parts if value != 0))

    def measures(self, freedom: Freedom) -> bool:
        """Whether a freedom's coordinate follows from the positions of the bodies.

        It does for the only turn, for two about axes that are not parallel, and for a slide perpendicular to all others.
        """
        if freedom.axis is None or not self.constraints():
            return False
        if freedom.kind == "turn":
            axes = [axis for axis in self.turning if axis is not None]
            return len(self.turning) == 1 or (len(axes) == len(self.turning) == 2 and not parallel(*axes))
        slides = list(self.sliding)
        slides.remove(own := (freedom.axis, self.turns_before(freedom)))
        return all(before == own[1] and perpendicular(axis, own[0]) for axis, before in slides)

    def _no_rule(self, subject: str) -> InputError:
        chain = ", then ".join(f"{freedom.kind} {freedom.label}" for freedom in self.freedoms)
        expected = "a chain of freedoms that it follows from, or `constraints` of the joint's own"
        remedy = (
            "Let the joint carry its body, by the joints' coordinates: coordinates='tree'; or make two joints of it."
        )
        actual = f"{chain}: no rule gives the constraints of {subject} forbid where the joint closes a loop"
        return InputError(f"joint {self.name}", [Fault(f"joint {self.name}", actual, expected, remedy)])

    # -- landmarks -----------------------------------------------------------------------------------------------------

    @property
    def symbol(self) -> str:
        """Kind of joint as which it is drawn."""
        turns = [axis for axis in self.turning if axis is not None]
        if self.sliding:
            return "cylindrical" if any(parallel(axis, self.sliding[0][0]) for axis in turns) else "prismatic"
        if len(turns) < len(self.turning):
            return "spherical"
        return ("weld", "revolute", "universal")[min(len(turns), 2)]

    def landmarks(self) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """Yield name, point and directions of each landmark: axes of the slides, else of the turns.

        Directions are along the axes of the point's body.
        """
        axes = [axis for axis, _ in self.sliding] or [axis for axis in self.turning if axis is not None]
        yield from self.landmarks_with("axis", *axes[:1], *axes[-1:])

    def landmarks_with(self, label: str, *directions: Direction) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """Yield its two points with a direction at each, or none."""
        for i, (place, point) in enumerate((("parent", self.parent), ("child", self.child))):
            yield place, point, {label: apply(point.axes, directions[i].unit)} if directions else {}

    # -- faults --------------------------------------------------------------------------------------------------------

    def faults(self) -> Iterator[Fault]:
        """Yield the fault of freedoms that are not independent."""
        axes = [freedom.axis for freedom in self.freedoms if freedom.axis is not None]
        if all(axis.points for axis in axes) and not self._independent():
            yield Fault(f"joint {self.name}", "redundant freedoms, such as turns about two parallel axes",
                        "axes that are not parallel", "One rotation about one axis is a Revolute.")  # fmt: skip

    def _independent(self) -> bool:
        """Whether the motions of the freedoms are independent at some position, at the defaults."""
        rotation: Matrix = IDENTITY
        place: Vector = ZERO
        known: list[list[float]] = []
        for i, freedom in enumerate(self.freedoms):
            axes = AXES if freedom.axis is None else (freedom.axis,)
            for axis in axes:
                way = apply(rotation, numbers(axis))
                turns = freedom.kind != "slide"
                rest = [float(x) for x in ((*way, *cross(place, way)) if turns else (*ZERO, *way))]
                for other in known:
                    share = sum(a * b for a, b in zip(rest, other, strict=True))
                    rest = [a - share * b for a, b in zip(rest, other, strict=True)]
                size = sum(x * x for x in rest) ** 0.5
                if size < RANK:
                    return False
                known.append([x / size for x in rest])
                amount = 0.6 + 0.1 * i
                if turns:
                    rotation = multiply(rotation, about(numbers(axis), math.cos(amount), math.sin(amount)))
                else:
                    place = add(place, tuple(amount * x for x in way))
        return True


def _point(place: Frame | Point) -> Point:
    return place if isinstance(place, Point) else Point(place)
