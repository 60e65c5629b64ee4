"""Pairs of spheres and parallel cylinders, one on or in the other, and how they touch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Direction, Point
from hertzwerk.derive.declare.mechanism.pair import LENGTH, Pair, in_body
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.vectors import Vector, along, apply, dot, scale, sub, transpose
from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot


@dataclass(frozen=True)
class Round(Pair):
    """A round surface on or in another."""

    inside: ClassVar[bool] = False

    @property
    def line(self) -> Direction | None:
        """Axis of cylinders, in the axes of the second place; None of spheres."""
        return None

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return RoundTouch(self, kinematics)


@dataclass(frozen=True)
class SphereOnSphere(Round):
    """Two spheres that may touch from outside."""

    first: Point
    second: Point
    radius_first: Scalar
    radius_second: Scalar
    kind: ClassVar[str] = "sphere_on_sphere"
    measures: ClassVar[Mapping[str, Slot]] = {
        "radius_first": Slot.of("m", POSITIVE, "first radius"),
        "radius_second": Slot.of("m", POSITIVE, "second radius"),
    }

    @property
    def first_radius(self) -> Any:
        """Distance from the first place to the contact point [m]."""
        return self.radius_first

    @property
    def geometry(self) -> dict[str, Any]:
        """`R_eff = R1 R2/(R1 + R2)`, both radii, the smaller one and their sum [m]."""
        r1, r2 = self.radius_first, self.radius_second
        return {"R_eff": r1 * r2 / (r1 + r2), "R_min": sp.Min(r1, r2), "R_1": r1, "R_2": r2, "dR": r1 + r2}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radii, for landmarks."""
        one, two = {"radius": self.radius_first}, {"radius": self.radius_second}
        return one, two


@dataclass(frozen=True)
class ParallelCylinders(SphereOnSphere):
    """Two cylinders that may touch from outside along a line of `length`.

    Their axes are along `axis` of the second's frame.
    """

    axis: Direction
    length: Scalar
    kind: ClassVar[str] = "parallel_cylinders"
    form: ClassVar[str] = "line"
    measures: ClassVar[Mapping[str, Slot]] = {**SphereOnSphere.measures, "length": LENGTH}

    @property
    def geometry(self) -> dict[str, Any]:
        """Geometry of two spheres of the same radii, and the length [m]."""
        return {**super().geometry, "L": self.length}

    @property
    def line(self) -> Direction:
        """The axis."""
        return self.axis

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radii, axis and length, for landmarks."""
        second = {"radius": self.radius_second, "axis": in_body(self.second, self.axis), "length": self.length}
        return {"radius": self.radius_first}, second


class WithClearance(Round):
    """Joint with clearance: a round surface free inside a hollow one.

    Its radius is less by the `clearance`; the hollow one's is a field with the name of the second of its `labels`.
    """

    clearance: Scalar  # a field of each kind
    inside: ClassVar[bool] = True
    journal: ClassVar[bool] = True

    @property
    def outer_radius(self) -> Any:
        """Radius of the hollow surface [m]."""
        return getattr(self, f"{self.labels[1]}_radius")

    @property
    def first_radius(self) -> Any:
        """Radius of the surface within [m]."""
        return self.outer_radius - self.clearance

    @property
    def geometry(self) -> dict[str, Any]:
        """`R_eff = R1 R2/(R1 - R2)` of outer and inner surface, both radii, their difference, a length."""
        outer, inner, length = self.outer_radius, self.first_radius, getattr(self, "length", None)
        lengths = {} if length is None else {"L": length}
        apart = outer - inner
        return {"R_eff": outer * inner / apart, "R_min": inner, "R_1": outer, "R_2": inner, "dR": apart, **lengths}

    def slots(self) -> Iterator[Slot]:
        """Yield its quantities, and the inner radius that follows from them."""
        yield from super().slots()
        inner, outer = self.labels
        if all(isinstance(x, sp.Expr) for x in (self.outer_radius, self.clearance)):
            place = f"pair {self.name}, {inner} radius ({outer} radius minus clearance)"
            yield Slot(place, self.first_radius, "m", POSITIVE)


@dataclass(frozen=True)
class PinInBush(WithClearance):
    """Revolute joint with clearance: a pin of radius `bush_radius - clearance` free inside a bush.

    Both axes are along `axis` of the bush's frame. Only laws of line contact depend on its `length`: without such a
    law it is no parameter of the scene.
    """

    pin: Point
    bush: Point
    axis: Direction
    bush_radius: Scalar
    clearance: Scalar
    length: Scalar | None = None
    kind: ClassVar[str] = "pin_in_bush"
    form: ClassVar[str] = "line"
    measures: ClassVar[Mapping[str, Slot]] = {
        "bush_radius": LENGTH,
        "clearance": LENGTH,
        "length": Slot.of("m", POSITIVE, law_symbol="L"),
    }
    holds_film: ClassVar[bool] = True
    wears: ClassVar[str] = "contour"
    labels: ClassVar[tuple[str, str]] = ("pin", "bush")

    @property
    def line(self) -> Direction:
        """The axis."""
        return self.axis

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radii and axis, for landmarks."""
        bush = {"radius": self.bush_radius, "axis": in_body(self.bush, self.axis)}
        return {"radius": self.first_radius}, bush

    def faults(self) -> Iterator[Fault]:
        """An axis that is no coordinate axis."""
        if self.axis.points and along(self.axis.unit) is None:
            yield Fault(f"pair {self.name}", f"the axis {self.axis.components}", "X, Y, Z or the opposite of one",
                        "Turn the bush: body.at(...).turned(axis, angle).")  # fmt: skip


@dataclass(frozen=True)
class BallInSocket(WithClearance):
    """Spherical joint with clearance: a ball of radius `socket_radius - clearance` in a hollow sphere."""

    ball: Point
    socket: Point
    socket_radius: Scalar
    clearance: Scalar
    kind: ClassVar[str] = "ball_in_socket"
    labels: ClassVar[tuple[str, str]] = ("ball", "socket")
    measures: ClassVar[Mapping[str, Slot]] = {"socket_radius": LENGTH, "clearance": LENGTH}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radii, for landmarks."""
        one, two = {"radius": self.first_radius}, {"radius": self.socket_radius}
        return one, two


class RoundTouch(Touch):
    """Spheres or parallel cylinders, one on or in the other."""

    proved: ClassVar[bool] = True

    @cached_property
    def eccentricity(self) -> Vector:
        """Vector from centre to centre, for cylinders normal to the axis [m]."""
        if self.pair.line is None:
            return self.apart
        axis = self.named(self.kin.direction(self.second, self.pair.line), "direction")
        along = self.let(dot(self.apart, axis), "along")
        return self.named(sub(self.apart, scale(along, axis)), "e")

    @cached_property
    def _reach(self) -> Any:
        """Distance of the centres at which contact begins [m], without wear."""
        if self.pair.inside:
            return sp.sympify(self.pair.clearance)
        return self.let(self.pair.radius_first + self.pair.radius_second, "reach")

    @cached_property
    def gap(self) -> Any:
        """(reach^2 - e.e)/(2 reach) inside, its negative outside: smooth through the centre."""
        reach = self._reach if self.worn is None else self.let(self._reach + self.worn.counted, "reach")
        sign = 1 if self.pair.inside else -1
        return self.let(sign * (reach**2 - self.squared) / (2 * reach), "gap")

    @cached_property
    def squared(self) -> Any:
        """Squared distance of the centres [m^2]."""
        return self.let(dot(self.eccentricity, self.eccentricity), "apart_squared")

    @cached_property
    def _distance(self) -> Any:
        return self.let(sp.sqrt(self.squared), "distance")

    @cached_property
    def normal(self) -> Vector:
        """Unit vector from the other centre, or inside towards it."""
        sign = -1 if self.pair.inside else 1
        exact = scale(sign / self._distance, self.eccentricity) if self.worn is None else self.worn.normal
        return self.named(exact, "normal")

    @cached_property
    def penetration(self) -> Any:
        """Exact penetration, by the distance of the centres [m]."""
        sign = 1 if self.pair.inside else -1
        reach = self._reach if self.worn is None else self._reach + self.worn.depth
        return self.let(sign * (self._distance - reach), "penetration")

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield the fault of a pin that wears and may tilt."""
        yield from super().faults(length)
        if self.worn is not None and self.worn.wear.first is not None and self.plane_of_motion is None:
            actual = f"a pin at {self.pair.name} that may leave the plane of motion"
            yield Fault(self.worn.wear.where, actual, "wear of the bush alone", "Leave `first` out.")

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Eccentricity inside, in the axes of the second place; structural zeros are left out."""
        if not self.pair.inside:
            return super().outputs()
        local = apply(transpose(self.kin.axes_of(self.second)), self.eccentricity)
        line = self.pair.line
        across = [k for k in range(3) if (local[k] != 0 if line is None else line.components[k] == 0)]
        return [
            (f"{self.pair.name}.eccentricity_{'xyz'[k]}", "m", self.let(local[k], f"eccentricity_{'xyz'[k]}"))
            for k in across
        ]
