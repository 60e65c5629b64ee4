"""Points and directions beside a planar curve, on the tape: distance, normal, and their rates.

A point's distance has the normal as its gradient, and the normal turns with the curvature of the parallel curve
through the point: all rates follow by implicit differentiation, whatever finds the nearest point.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.planar_curve import (
    Between,
    ChainPoints,
    Entry,
    Nearest,
    Place,
    PlanarChain,
    PlanarCurve,
    Sampled,
    Support,
)
from hertzwerk.derive.expressions.algebra.vectors import Vector, apply, transpose
from hertzwerk.derive.expressions.dimension.dimension import Dimension

METRE, PURE, BEND = (Dimension.from_unit(unit) for unit in ("m", "1", "1/m"))


@dataclass(frozen=True)
class Beside:
    """A point beside a curve: signed distance [m], normal (x, y) in the curve's axes.

    `parameter` is the curve's where it is nearest, `sliding` is the point's speed along the curve [m/s],
    `bend` the curvature of the parallel curve through it [1/m].
    """

    distance: Any
    normal: tuple[Any, Any]
    bend: Any
    sliding: Any
    parameter: Any


@dataclass(frozen=True)
class Least:
    """Point (x, y) of a curve [m] with the least component along a direction, and the parameter there."""

    point: tuple[Any, Any]
    parameter: Any


@dataclass(frozen=True)
class Pose:
    """A place against a curve's: origin (x, y) [m], cosine, sine and rate [rad/s] of its turn."""

    x: Any
    y: Any
    cos: Any
    sin: Any
    turning: Any


@dataclass(frozen=True)
class Meeting:
    """Another curve beside a curve: signed distance [m], normal and point of the curve in its axes.

    `parameters` are those of the other and of the curve.
    """

    distance: Any
    normal: tuple[Any, Any]
    point: tuple[Any, Any]
    parameters: tuple[Any, Any]


class OnCurve:
    """A curve on the tape, at a place of a body."""

    def __init__(self, kinematics: Kinematics, curve: PlanarCurve | PlanarChain, place: Point, name: str) -> None:
        self.kin, self.tape, self.name = kinematics, kinematics.tape, name
        self.curve, self.axes = curve, kinematics.axes_of(place)
        self.samples = self._sampled(curve)

    def _sampled(self, curve: PlanarCurve | PlanarChain) -> Any:
        return self.tape.block(Sampled(curve, *curve.parameters), f"{curve.name}_samples", curve.width, METRE)

    def local(self, vector: Vector, label: str) -> Vector:
        """A vector along the curve's axes, on the tape."""
        return self.tape.vector(apply(transpose(self.axes), vector), f"{self.name}_{label}")

    def ground(self, x: Any, y: Any, label: str) -> Vector:
        """A vector of the curve's plane along the ground's axes."""
        return self.tape.vector(apply(self.axes, (x, y, 0)), f"{self.name}_{label}")

    def _rate(self, value: Any, label: str) -> Any:
        return self.tape.rate(value, f"{self.name}_{label}_rate")

    def _let(self, value: Any, label: str, dimension: Dimension | None = None) -> Any:
        return self.tape.let(value, f"{self.name}_{label}", dimension)

    def _entries(self, node: type, x: Any, y: Any, width: int) -> list[Any]:
        return self._vector(node(self.curve, self.samples, x, y, *self.curve.parameters), width)

    def _vector(self, node: Any, width: int) -> list[Any]:
        vector = self.tape.block(node, f"{self.name}_{type(node).__name__.lower()}", width, PURE)
        return [Entry(vector, k) for k in range(width)]

    def beside(self, x: Any, y: Any) -> Beside:
        """The curve as seen from a point (x, y) in its axes [m]."""
        entries = self._entries(Nearest, x, y, 5)
        distance, nx, ny, bend, parameter = (
            self._let(entry, label, dimension)
            for entry, (label, dimension) in zip(
                entries,
                (("distance", METRE), ("normal_x", PURE), ("normal_y", PURE), ("bend", BEND), ("parameter", PURE)),
                strict=True,
            )
        )
        vx, vy = self._rate(x, "x"), self._rate(y, "y")
        sliding = self._let(nx * vy - ny * vx, "along_curve")
        turning = self._let(bend * sliding, "turning")
        self.tape.set_rate(distance, self._let(nx * vx + ny * vy, "distance_rate"))
        self.tape.set_rate(nx, -ny * turning)
        self.tape.set_rate(ny, nx * turning)
        return Beside(distance, (nx, ny), bend, sliding, parameter)

    def least(self, x: Any, y: Any) -> Least:
        """The curve as seen along a unit direction (x, y) in its axes."""
        entries = self._entries(Support, x, y, 4)
        px, py, radius, parameter = (
            self._let(entry, label, dimension)
            for entry, (label, dimension) in zip(
                entries,
                (("foot_x", METRE), ("foot_y", METRE), ("bend_radius", METRE), ("parameter", PURE)),
                strict=True,
            )
        )
        self.tape.set_rate(px, -radius * self._rate(x, "direction_x"))
        self.tape.set_rate(py, -radius * self._rate(y, "direction_y"))
        return Least((px, py), parameter)

    def between(
        self, other: PlanarCurve | PlanarChain, pose: Pose, points: Sequence[ChainPoints | Place] = ()
    ) -> Meeting:
        """Another curve in a pose against this one's place; of two chains also their `points`.

        With the curvatures k of the other and l of this one, the distance h and D = k + l + h k l, the foot on this curve
        moves along it by k/D for each length that the other slides there, and by (1 + h k)/D for each angle that it turns;
        the normal turns by k l/D and l (1 + h k)/D = 1 - k/D. These three coefficients are finite on lines and at ends too.
        """
        node = Between(
            other, self.curve, self._sampled(other), self.samples, pose.x, pose.y, pose.cos, pose.sin,
            *other.parameters, *self.curve.parameters, *points,
        )  # fmt: skip
        named = (
            ("distance", METRE), ("normal_x", PURE), ("normal_y", PURE), ("foot_x", METRE), ("foot_y", METRE), ("share", PURE),
            ("rolling", METRE), ("bend", BEND), ("first_parameter", PURE), ("second_parameter", PURE),
        )  # fmt: skip
        entries = zip(self._vector(node, len(named)), named, strict=True)
        distance, nx, ny, px, py, share, rolling, bend, first, second = (
            self._let(entry, label, dimension) for entry, (label, dimension) in entries
        )
        turning = pose.turning
        vx = self._let(self._rate(pose.x, "x") - turning * (py - pose.y), "slip_x")
        vy = self._let(self._rate(pose.y, "y") + turning * (px - pose.x), "slip_y")
        sliding = self._let(nx * vy - ny * vx, "along_curve")
        turn = self._let(bend * sliding + (1 - share) * turning, "turning")
        moved = self._let(share * sliding + rolling * turning, "moved")
        self.tape.set_rate(distance, self._let(nx * vx + ny * vy, "distance_rate"))
        for (x, y), rate in (((nx, ny), turn), ((px, py), moved)):
            self.tape.set_rate(x, -ny * rate)
            self.tape.set_rate(y, nx * rate)
        return Meeting(distance, (nx, ny), (px, py), (first, second))
