"""Points and directions beside a planar curve, on the tape: distance, normal, and their rates.

A point's distance has the normal as its gradient, and the normal turns with the curvature of the parallel curve
through the point: all rates follow by implicit differentiation, whatever finds the nearest point.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hertzwerk.derive.algebra.planar_curve import Entry, Nearest, PlanarChain, PlanarCurve, Sampled, Support
from hertzwerk.derive.algebra.vectors import Vector, apply, transpose
from hertzwerk.derive.dimension.dimension import Dimension
from hertzwerk.derive.mechanism.bodies import Point
from hertzwerk.derive.motion.kinematics import Kinematics

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


class OnCurve:
    """A curve on the tape, at a place of a body."""

    def __init__(self, kinematics: Kinematics, curve: PlanarCurve | PlanarChain, place: Point, name: str) -> None:
        self.kin, self.tape, self.name = kinematics, kinematics.tape, name
        self.curve, self.axes = curve, kinematics.axes_of(place)
        self.samples = self.tape.block(Sampled(curve, *curve.given), f"{curve.name}_samples", curve.width, METRE)

    def local(self, vector: Vector, what: str) -> Vector:
        """A vector along the curve's axes, on the tape."""
        return self.tape.vector(apply(transpose(self.axes), vector), f"{self.name}_{what}")

    def ground(self, x: Any, y: Any, what: str) -> Vector:
        """A vector of the curve's plane along the ground's axes."""
        return self.tape.vector(apply(self.axes, (x, y, 0)), f"{self.name}_{what}")

    def _rate(self, value: Any, what: str) -> Any:
        return self.tape.rate(value, f"{self.name}_{what}_rate")

    def _let(self, value: Any, what: str, dimension: Dimension | None = None) -> Any:
        return self.tape.let(value, f"{self.name}_{what}", dimension)

    def _entries(self, node: type, x: Any, y: Any, width: int) -> list[Any]:
        found = node(self.curve, self.samples, x, y, *self.curve.given)
        vector = self.tape.block(found, f"{self.name}_{node.__name__.lower()}", width, PURE)
        return [Entry(vector, k) for k in range(width)]

    def beside(self, x: Any, y: Any) -> Beside:
        """The curve as seen from a point (x, y) in its axes [m]."""
        entries = self._entries(Nearest, x, y, 5)
        distance, nx, ny, bend, parameter = (
            self._let(entry, what, dimension)
            for entry, (what, dimension) in zip(
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
            self._let(entry, what, dimension)
            for entry, (what, dimension) in zip(
                entries,
                (("foot_x", METRE), ("foot_y", METRE), ("bend_radius", METRE), ("parameter", PURE)),
                strict=True,
            )
        )
        self.tape.set_rate(px, -radius * self._rate(x, "direction_x"))
        self.tape.set_rate(py, -radius * self._rate(y, "direction_y"))
        return Least((px, py), parameter)
