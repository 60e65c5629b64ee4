"""Pairs of a planar curve with a circle, a point or a straight face, and how they touch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Direction, Point
from hertzwerk.derive.declare.mechanism.curve import SolidCurve, single_faults
from hertzwerk.derive.declare.mechanism.pair import LENGTH, Pair, in_body
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.curve_frame import Beside, Least, OnCurve
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, scale
from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot


@dataclass(frozen=True)
class OnSolidCurve(Pair):
    """Surface that may touch the solid beside a curve, in plane motion.

    A kind has the fields `curve`, `fixed`, its place, in whose plane of X and Y it lies, and `curvature_radius` [m], that of
    relative curvature for laws that need one: a curve has many.
    """

    form: ClassVar[str] = "line"
    measures: ClassVar[Mapping[str, Slot]] = {
        "curvature_radius": Slot.of("m", POSITIVE, law_symbol="R_eff"),
        "length": Slot.of("m", POSITIVE, law_symbol="L"),
    }

    @property
    def geometry(self) -> dict[str, Any]:
        """Radius of relative curvature and length, where given."""
        radius, length = getattr(self, "curvature_radius", None), getattr(self, "length", None)
        sizes = {"R_eff": radius, "R_min": radius, "L": length}
        return {name: value for name, value in sizes.items() if value is not None}

    @property
    def curves(self) -> tuple[Any, ...]:
        """The curve."""
        return (getattr(self, "curve", None),)

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the pair, its curve's included."""
        for curve in self.curves:
            yield from curve.slots() if isinstance(curve, SolidCurve) else ()
        yield from super().slots()

    def faults(self) -> Iterator[Fault]:
        """Yield the fault of a curve with copies, which are searched between curves alone."""
        yield from single_faults(f"pair {self.name}", getattr(self, "curve", None))


@dataclass(frozen=True)
class CircleOnCurve(OnSolidCurve):
    """Circle, as the roller of a follower, that may touch the solid beside a curve."""

    circle: Point
    radius: Scalar
    curve: SolidCurve
    fixed: Point
    curvature_radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "circle_on_curve"
    measures: ClassVar[Mapping[str, Slot]] = {"radius": LENGTH, **OnSolidCurve.measures}

    @property
    def first_radius(self) -> Any:
        """Distance from the first place to the contact point [m]."""
        return self.radius

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Radius of the circle; axes and points of the curve, for landmarks."""
        return {"radius": self.radius}, outline(self.fixed, self.curve)

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return NearCurve(self, kinematics)


@dataclass(frozen=True)
class PointOnCurve(OnSolidCurve):
    """Point, as the tip of a follower, that may touch the solid beside a curve."""

    point: Point
    curve: SolidCurve
    fixed: Point
    curvature_radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "point_on_curve"

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Axes and points of the curve, for landmarks."""
        return {}, outline(self.fixed, self.curve)

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return NearCurve(self, kinematics)


@dataclass(frozen=True)
class FaceOnCurve(OnSolidCurve):
    """Straight face, as of a flat follower, that may touch the solid beside a curve.

    It touches where the curve reaches farthest: of one that is not convex, its hull. `normal` points out of the face's solid.
    The face has no ends.
    """

    face: Point
    normal: Direction
    curve: SolidCurve
    fixed: Point
    curvature_radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "face_on_curve"

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Normal of the face; axes and points of the curve, for landmarks."""
        return {"normal": in_body(self.face, self.normal)}, outline(self.fixed, self.curve)

    def faults(self) -> Iterator[Fault]:
        """Yield also the fault of a curve without an outside that a face could touch."""
        yield from super().faults()
        if isinstance(self.curve, SolidCurve) and self.curve.hole:
            yield Fault(
                f"pair {self.name}, curve", f"the hole {self.curve.name}", "a solid that a straight face can touch"
            )

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return FaceTouch(self, kinematics)


def outline(place: Point, curve: SolidCurve) -> dict[str, Any]:
    """Axes of a curve's plane, and the curve, for landmarks."""
    x, y = (in_body(place, axis) for axis in (Direction((1, 0, 0)), Direction((0, 1, 0))))
    return {"along": x, "across": y, "outline" if curve.closed and not curve.hole else "track": curve}


class CurveTouch(Touch):
    """Common part of pairs with a curve, the field `curve_of`, which is fixed to the second place."""

    proved: ClassVar[bool] = True
    curve_of: ClassVar[str] = "curve"

    @cached_property
    def _on(self) -> OnCurve:
        return OnCurve(self.kin, getattr(self.pair, self.curve_of).planar, self.second, self.pair.name)

    @cached_property
    def _local(self) -> Vector:
        return self._on.local(self.apart, "local")

    def faults(self, length: float) -> Iterator[Fault]:
        """Yield the fault of surfaces that leave the curve's plane."""
        if self.tape.rate(self._local[2], f"{self.pair.name}_off_plane") != 0 or not self._parallel():
            yield Fault(f"pair {self.pair.name}", "motion out of the curve's plane", "plane motion, about its Z",
                        "Turn the curve's place so that its Z is normal to the plane of motion: body.at(...).turned(axis, angle).")  # fmt: skip

    def _parallel(self) -> bool:
        """Whether the curve's Z stays the normal of the motion."""
        w = [self.kin.angular_velocity(place.body) for place in (self.first, self.second)]
        z = [row[2] for row in self._on.axes]
        return all(turn[k] == 0 or abs(z[k]) == 1 for turn in w for k in range(3))


class NearCurve(CurveTouch):
    """Circle or point beside a curve."""

    @cached_property
    def _beside(self) -> Beside:
        return self._on.beside(self._local[0], self._local[1])

    @cached_property
    def gap(self) -> Any:
        """Distance of the circle from the curve [m]."""
        return self.let(self._beside.distance - sp.sympify(self.pair.first_radius), "gap")

    @cached_property
    def normal(self) -> Vector:
        """Normal of the curve where it is nearest."""
        return self._on.ground(*self._beside.normal, "normal")

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Gap, and the curve's parameter where it is nearest."""
        return [*super().outputs(), (f"{self.pair.name}.parameter", "1", self._beside.parameter)]


class FaceTouch(CurveTouch):
    """Straight face beside a curve."""

    @cached_property
    def _direction(self) -> Vector:
        return self.named(self.kin.direction(self.first, self.pair.normal), "direction")

    @cached_property
    def _turned(self) -> Vector:
        return self._on.local(self._direction, "turned")

    @cached_property
    def _least(self) -> Least:
        return self._on.least(self._turned[0], self._turned[1])

    @cached_property
    def gap(self) -> Any:
        """Height of the curve over the face [m]."""
        return self.let(sp.Add(*(m * part for m, part in zip(self._turned, self._over, strict=False))), "gap")

    @cached_property
    def _over(self) -> list[Any]:
        """Vector from the face to the curve's point, in the curve's plane [m]."""
        return [self.let(x - at, f"over_{k}") for k, x, at in zip("xy", self._least.point, self._local, strict=False)]

    @cached_property
    def gap_rate(self) -> Any:
        """Rate of the gap [m/s]: the curve's point moves along the face."""
        terms = (
            self.tape.rate(m, f"{self.pair.name}_turned_{k}_rate") * over
            - m * self.tape.rate(at, f"{self.pair.name}_local_{k}_rate")
            for k, m, over, at in zip("xy", self._turned, self._over, self._local, strict=False)
        )
        return self.let(sp.Add(*terms), "gap_rate")

    @cached_property
    def normal(self) -> Vector:
        """Into the face."""
        return scale(-1, self._direction)

    @cached_property
    def position(self) -> Vector:
        """Point of contact on the curve."""
        return self.named(add(self.base, self._on.ground(*self._least.point, "foot")), "contact")

    def outputs(self) -> list[tuple[str, str, Any]]:
        """Gap, and the curve's parameter where it is highest."""
        return [*super().outputs(), (f"{self.pair.name}.parameter", "1", self._least.parameter)]
