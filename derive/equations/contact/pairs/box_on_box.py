"""Pair of two boxes, or of two rectangles in plane motion, and how their corners and edges touch."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Point, X, Y
from hertzwerk.derive.declare.mechanism.pair import Pair, in_body
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.box_features import Features, Stacked
from hertzwerk.derive.expressions.algebra.planar_curve import Entry
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, dot, transpose
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot

METRE, PACE, ACCELERATION, PURE, PER_SECOND = (Dimension.from_unit(unit) for unit in ("m", "m/s", "m/s^2", "1", "1/s"))


@dataclass(frozen=True)
class BoxOnBox(Pair):
    """Two boxes that may touch: corners of each on the other, and edges that cross.

    `first` and `second` are their middles, with sizes x, y, z along the axes there. Edges and corners of both are rounded
    by a `radius`, within which all distances are exact and smooth; a run whose boxes penetrate deeper ends. Without z both
    are rectangles that move in the plane of x and y, and only corners touch.

    It is as many pairs, at each of which acts what is declared at NAME: NAME_1 to NAME_4 are the corners of the first, each
    with its opposite, which never touch together, NAME_5 to NAME_8 those of the second, and NAME_9 to NAME_24 its edges, in
    four sets that share no face, with those of the second. Of rectangles NAME_1 and NAME_2, NAME_3 and NAME_4 are corners.
    """

    first: Point
    first_x: Scalar
    first_y: Scalar
    second: Point
    second_x: Scalar
    second_y: Scalar
    radius: Scalar
    first_z: Scalar | None = None
    second_z: Scalar | None = None

    @property
    def sizes(self) -> dict[str, dict[str, Any]]:
        """Sizes along the axes of each box [m]."""
        sizes = {which: {axis: getattr(self, f"{which}_{axis}") for axis in "xyz"} for which in ("first", "second")}
        return {which: {axis: v for axis, v in of.items() if v is not None} for which, of in sizes.items()}

    @property
    def dimensions(self) -> int:
        """Number of dimensions: 3, or 2 of rectangles."""
        return 2 if self.first_z is None else 3

    @property
    def parts(self) -> tuple[Pair, ...]:
        """Corners and edges, each a pair; itself where they cannot be made, a fault the scene finds."""
        if not self.placed or any(self.faults()):
            return (self,)
        count = 4 if self.dimensions == 2 else 24
        return tuple(BoxFeature(f"{self.name}_{k}", self.first, self.second, k - 1, self) for k in range(1, count + 1))

    def slots(self) -> Iterator[Slot]:
        """Yield the sizes, and what the rounding leaves of them."""
        yield Slot(f"pair {self.name}, radius", self.radius, "m", POSITIVE)
        for which, sizes in self.sizes.items():
            for axis, value in sizes.items():
                yield Slot(f"pair {self.name}, {which} {axis}", value, "m", POSITIVE)
                if all(isinstance(v, sp.Expr) for v in (value, self.radius)):
                    flat = f"pair {self.name}, {which} {axis} less two radii"
                    yield Slot(flat, value - 2 * self.radius, "m", POSITIVE)
        yield from super().slots()

    def faults(self) -> Iterator[Fault]:
        """Yield the fault of a box against a rectangle."""
        if (self.first_z is None) != (self.second_z is None):
            yield Fault(f"pair {self.name}", "a z of one of both", "both, of boxes, or neither, of rectangles")


@dataclass(frozen=True)
class BoxFeature(Pair):
    """Corners or edges of a box on those of another: a part of `whole`."""

    first: Point
    second: Point
    slot: int
    whole: BoxOnBox
    kind: ClassVar[str] = "box_on_box"

    @property
    def first_radius(self) -> Any:
        """Distance from the first place to the contact point [m]."""
        return self.whole.radius

    @property
    def geometry(self) -> dict[str, Any]:
        """Geometry of a rounded corner on a face, and of rounded edges that cross square."""
        r = self.whole.radius
        return {"R_eff": r, "R_min": r, "R_2": r}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Sizes of each box and two of its axes, for landmarks; of a rectangle twice the radius deep."""
        one, two = (
            {"along": in_body(place, X), "across": in_body(place, Y), "size": (*sizes.values(), 2 * self.whole.radius)[:3]}
            for place, sizes in zip(self.places, self.whole.sizes.values(), strict=True)
        )  # fmt: skip
        return one, two

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return BetweenBoxes(self, kinematics)


class BetweenBoxes(Touch):
    """Rounded corners or edges of two boxes."""

    proved: ClassVar[bool] = True

    @property
    def limit(self) -> Any:
        """Penetration up to which the distance of both is that of their features [m]."""
        return self.pair.whole.radius

    @cached_property
    def _pose(self) -> tuple[Any, ...]:
        """Place of the first box from the second, axes of both, sizes and reach; their rates and second rates."""
        boxes, kin, tape = self.pair.whole, self.kin, self.tape
        radius, bodies = sp.sympify(boxes.radius), (self.first.body, self.second.body)
        axes = [entry for place in (self.first, self.second) for row in kin.axes_of(place) for entry in row]
        halves = [size / 2 - radius for sizes in boxes.sizes.values() for size in sizes.values()]
        still = [tape.let(value, f"{boxes.name}_half") for value in halves] + [
            tape.let(2 * radius, f"{boxes.name}_reach")
        ]
        rates = [tape.rate(part, f"{boxes.name}_rate") for part in self.apart]
        second = [tape.rate(part, f"{boxes.name}_second_rate") for part in rates]
        turning = [part for body in bodies for part in kin.angular_velocity(body)]
        turning_rate = [part for body in bodies for part in kin.motion(body).angular_acceleration]
        stacked = {"pose": [*self.apart, *axes, *still], "rate": [*rates, *turning], "second": [*second, *turning_rate]}
        return tuple(tape.block(Stacked(*v), f"{boxes.name}_{label}", len(v), METRE) for label, v in stacked.items())

    def _features(self, order: int, suffix: str, *dimensions: Dimension) -> list[Any]:
        """Gap, penetration, normal and point of the features, or as many of their rates, on the tape."""
        boxes = self.pair.whole
        features = Features(sp.Integer(boxes.dimensions), sp.Integer(self.pair.slot), *self._pose[: order + 1])
        vector = self.tape.block(features, f"{self.pair.name}_features{suffix}", 8, METRE)
        names = ("gap", "penetration", *(f"{of}_{axis}" for of in ("normal", "arm") for axis in "xyz"))
        return [
            self.let(Entry(vector, k), f"{name}{suffix}", of)
            for k, (name, of) in enumerate(zip(names, dimensions, strict=False))
        ]

    @cached_property
    def _entries(self) -> list[Any]:
        entries = self._features(0, "", *[METRE] * 2, *[PURE] * 3, *[METRE] * 3)
        rates = self._features(1, "_rate", *[PACE] * 2, *[PER_SECOND] * 3, *[PACE] * 3)
        for entry, rate in zip(entries, rates, strict=True):
            self.tape.set_rate(entry, rate)
        return entries

    def _vector(self, begin: int) -> Vector:
        """Three entries; structurally zero across a plane of motion."""
        flat = self.pair.whole.dimensions == 2
        out = transpose(self.kin.axes_of(self.second))[2]
        x, y, z = (
            sp.S.Zero if flat and abs(k) == 1 else v for k, v in zip(out, self._entries[begin : begin + 3], strict=True)
        )
        return x, y, z

    @cached_property
    def gap(self) -> Any:
        """Event function [m]: of corners (distance^2 - reach^2)/(2 reach), of edges minus their penetration."""
        return self._entries[0]

    @cached_property
    def gap_acceleration(self) -> Any:
        """Second derivative of the gap [m/s^2]."""
        return self._features(2, "_second_rate", ACCELERATION)[0]

    @property
    def penetration(self) -> Any:
        """Exact penetration [m]; of edges no more than they reach beyond the crossing."""
        return self._entries[1]

    @cached_property
    def normal(self) -> Vector:
        """Unit vector from the second's feature to the first's."""
        return self._vector(2)

    @cached_property
    def position(self) -> Vector:
        """Point of the first's feature [m]."""
        return self.named(add(self.base, self._vector(5)), "position")

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield the fault of rectangles that leave their plane."""
        if self.pair.whole.dimensions == 3 or self.pair.slot:
            return
        normal = transpose(self.kin.axes_of(self.second))[2]
        off = self.let(dot(normal, self.apart), "off_plane")
        level = dot(normal, transpose(self.kin.axes_of(self.first))[2])
        if (
            self.tape.rate(off, f"{self.pair.name}_off_plane_rate") != 0
            or abs(level) != 1
            or all(abs(k) != 1 for k in normal)
        ):
            yield Fault(f"pair {self.pair.whole.name}", "motion out of the plane of x and y", "motion in it, or sizes z of both boxes",
                        "Turn the places so that their Z is normal to the plane of motion: body.at(...).turned(axis, angle).")  # fmt: skip
