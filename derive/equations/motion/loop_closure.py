"""Joints that close loops: constraints on the coordinates of the tree, their rates and forces.

A joint whose child is already carried by another joint closes a loop. Its constraints are scalar: a point of the
child coincides with the parent's (along a direction), or a direction of the child keeps its angle to one of the
parent. Constraints that a plane mechanism fulfils by structure vanish. Their forces follow from the same partial
velocities as all other forces; Kane, Levinson, Dynamics: Theory and Applications (1985), 2.13 and 4.5.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.declare.mechanism.bodies import AXES, Direction
from hertzwerk.derive.declare.mechanism.curve import SolidCurve
from hertzwerk.derive.declare.mechanism.joints.conditions import (
    Carried,
    Coincident,
    ConstantAngle,
    Moving,
    NoDisplacement,
    OnTrack,
    across,
)
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.equations.motion.curve_frame import Beside, OnCurve
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, apply, cross, dot, is_zero, scale, sub


@dataclass(frozen=True)
class Constraint:
    """A scalar constraint: `value` and `rate` must be zero; the acceleration is `column` . a + `bias`.

    One with the unit m/s has no value, as its rate has no integral: a nonholonomic one.
    `column` holds, by row of the equations of motion, the generalised force of a unit multiplier. The constraints of
    a `group` are components of one vector, or of one unit. Where a drive prescribes it, `drives` is the freedom
    driven, and the multiplier is the drive's force or torque. Of a joint, `force` and `moment` are those of a unit
    multiplier on the child, about its point. Their reactions act on the parent at that point too: where the loop is
    open by d, `column` differs from the gradient of `value` by terms in d. Of a coupling, `by_time` is the part of its
    rate due to time itself; where there is one, it drives too.
    """

    name: str
    unit: str
    group: str
    value: Any
    rate: Any
    bias: Any
    column: dict[str, Any]
    drives: str = ""
    by_time: Any = sp.S.Zero
    force: Vector = ZERO
    moment: Vector = ZERO


def closing_constraints(kinematics: Kinematics) -> Iterator[Constraint]:
    """Yield the constraints of a mechanism's closing joints, then those of their drives."""
    joints = kinematics.mechanism.closures
    for joint in joints:
        yield from Closure(kinematics, joint).constraints()
    for joint in joints:
        driven = (freedom for freedom in joint.freedoms if freedom.key in kinematics.prescribed)
        yield from (Closure(kinematics, joint).driven(freedom) for freedom in driven)


@dataclass(frozen=True)
class Measured:
    """Coordinate of a freedom, with its rate.

    The coordinate is None for an angle in space whose whole turns nothing counts (`CountedAngle`). The acceleration is
    `column` . a + `bias`, and `column` holds the generalised forces of a unit force on it.
    """

    value: Any
    rate: Any
    bias: Any
    column: dict[str, Any]


def measured(kinematics: Kinematics, key: str) -> Measured:
    """Coordinate of the freedom of this key: of the tree, or measured on a closing joint."""
    if key in kinematics.states:
        row = kinematics.row(key)
        return Measured(*kinematics.states[key], sp.S.Zero if row.free else row.acceleration, {row.key: sp.S.One})
    if kinematics.by_expressions is not None:
        return Measured(*kinematics.by_expressions.measured(key))
    freedoms = ((joint, freedom) for joint in kinematics.mechanism.closures for freedom in joint.freedoms)
    joint, freedom = next(entry for entry in freedoms if entry[1].key == key)
    return Closure(kinematics, joint).measured(freedom)


class Closure:
    """One closing joint on its kinematics' tape."""

    def __init__(self, kinematics: Kinematics, joint: Joint) -> None:
        self.kin, self.tape, self.joint = kinematics, kinematics.tape, joint
        self.bodies = joint.child.body, joint.parent.body
        self.motions = [kinematics.motion(body) for body in self.bodies]
        self.biases = [kinematics.bias_of(kinematics.link_of(body))[0] for body in self.bodies]
        name = joint.name
        sides = (joint.child, f"{name}_child"), (joint.parent, f"{name}_parent")
        one, two = (kinematics.point(place, side) for place, side in sides)
        self.place = one[0]
        self.apart = self.tape.vector(sub(one[0], two[0]), f"{name}_apart")
        self.apart_rate = self.tape.vector(sub(one[1], two[1]), f"{name}_apart_rate")
        bias = (kinematics.point_bias(place, side) for place, side in sides)
        self.apart_bias = self.tape.vector(sub(*bias), f"{name}_apart_bias")

    def constraints(self) -> Iterator[Constraint]:
        """Yield the constraints of the joint."""
        for forbidden in self.joint.constraints():
            if isinstance(forbidden, Coincident):
                yield from (self._meet(k) for k in range(3))
            elif isinstance(forbidden, NoDisplacement):
                yield self._off(forbidden.direction, forbidden.label)
            elif isinstance(forbidden, OnTrack):
                yield self._track(forbidden.curve)
            else:
                yield self._turn(forbidden)

    def _meet(self, k: int) -> Constraint:
        """Both points coincide, along an axis of the ground."""
        label = "xyz"[k]
        return Constraint(
            f"{self.joint.name}.apart_{label}", "m", f"{self.joint.name}.apart",
            self.apart[k], self.apart_rate[k], self.apart_bias[k], self._force(AXES[k].unit, label),
            force=AXES[k].unit,
        )  # fmt: skip

    def _off(self, direction: Carried, label: str) -> Constraint:
        """The child's point has no displacement along a direction."""
        normal, rate, bent = direction.moving(self, label)
        bias = dot(self.apart_bias, normal) + 2 * dot(self.apart_rate, rate) + dot(self.apart, bent)
        return Constraint(
            f"{self.joint.name}.off_{label}", "m", f"{self.joint.name}.off",
            self._let(dot(self.apart, normal), f"off_{label}"),
            self._let(dot(self.apart_rate, normal) + dot(self.apart, rate), f"off_{label}_rate"),
            self._let(bias, f"off_{label}_bias"),
            self._force(normal, label, moment := direction.moment(self, label, self.apart)),
            force=normal,
            moment=moment,
        )  # fmt: skip

    def _track(self, curve: SolidCurve) -> Constraint:
        """The child's point is on a curve: its signed distance vanishes."""
        on, beside = self.on_curve(curve)
        if self.tape.rate(on.local(self.apart, "local")[2], f"{self.joint.name}_off_plane") != 0:
            raise InputError(f"mechanism {self.kin.mechanism.name}", [
                Fault(f"joint {self.joint.name}", "motion out of the curve's plane", "plane motion, about its Z",
                      "Turn the curve's place so that its Z is normal to the plane of motion: body.at(...).turned(axis, angle)."),
            ])  # fmt: skip
        normal = on.ground(*beside.normal, "normal")
        w, alpha = self.motions[1].angular_velocity, self.biases[1]
        carried = add(cross(alpha, self.apart), scale(2, cross(w, self.apart_rate)))
        bent = sub(add(self.apart_bias, cross(w, self.named(cross(w, self.apart), "turned"))), carried)
        bias = dot(normal, self.named(bent, "bent")) + beside.bend * beside.sliding**2
        return Constraint(
            f"{self.joint.name}.off_track", "m", f"{self.joint.name}.off",
            beside.distance,
            self.tape.rate(beside.distance, f"{self.joint.name}_off_track_rate"),
            self._let(bias, "off_track_bias"),
            self._force(normal, "track"),
        )  # fmt: skip

    def on_curve(self, curve: SolidCurve) -> tuple[OnCurve, Beside]:
        """The curve that is fixed to the parent, and the child's point beside it."""
        for place, rate in zip(self.apart, self.apart_rate, strict=True):
            self.tape.set_rate(place, rate)
        on = OnCurve(self.kin, curve.planar, self.joint.parent, self.joint.name)
        x, y, _ = on.local(self.apart, "local")
        return on, on.beside(x, y)

    def fixed(self, side: int, direction: Direction, label: str) -> Moving:
        """A direction fixed in the child or the parent, with its rates."""
        vector = self.kin.direction((self.joint.child, self.joint.parent)[side], direction)
        w, alpha = self.motions[side].angular_velocity, self.biases[side]
        rate = self.named(cross(w, vector), f"{label}_rate")
        return vector, rate, add(cross(alpha, vector), cross(w, rate))

    def named(self, vector: Vector, label: str) -> Vector:
        """Name a vector of this joint on the tape."""
        return self.tape.vector(vector, f"{self.joint.name}_{label}")

    def _turn(self, angle: ConstantAngle) -> Constraint:
        """A direction of the child keeps its angle to one of the parent."""
        label = angle.label
        a, b = (
            self.kin.direction(self.joint.child, angle.on_child),
            self.kin.direction(self.joint.parent, angle.on_parent),
        )
        (w, v), (alpha, beta) = (motion.angular_velocity for motion in self.motions), self.biases
        about = self.tape.vector(cross(a, b), f"{self.joint.name}_turned_{label}_about")
        turning = self.tape.vector(sub(w, v), f"{self.joint.name}_turning")
        moving = add(cross(cross(w, a), b), cross(a, cross(v, b)))
        return Constraint(
            f"{self.joint.name}.turned_{label}", "1", f"{self.joint.name}.turned",
            self._let(dot(a, b) - dot(angle.on_child.unit, angle.on_parent.unit), f"turned_{label}"),
            self._let(dot(turning, about), f"turned_{label}_rate"),
            self._let(dot(sub(alpha, beta), about) + dot(turning, moving), f"turned_{label}_bias"),
            _without_zeros(self.kin.generalised_moment(about, *self.bodies, f"{self.joint.name}_turned_{label}")),
            moment=about,
        )  # fmt: skip

    def measured(self, freedom: Freedom) -> Measured:
        """Displacement along the parent's axis, or angle about the common axis, of a freedom of the joint."""
        axis, label = _axis_of(freedom), freedom.label
        if freedom.kind == "slide":
            travel = self._off(self.joint.carried(axis, self.joint.turns_before(freedom)), label)
            return Measured(travel.value, travel.rate, travel.bias, travel.column)
        (w, v), (alpha, beta) = (motion.angular_velocity for motion in self.motions), self.biases
        about, moving = self._about(freedom)
        turning = self.tape.vector(sub(w, v), f"{self.joint.name}_turning")
        rate = self._let(dot(turning, about), f"{label}_rate")
        return Measured(
            self._angle(freedom, rate),
            rate,
            self._let(dot(sub(alpha, beta), about) + dot(turning, moving), f"{label}_bias"),
            _without_zeros(self.kin.generalised_moment(about, *self.bodies, f"{self.joint.name}_{label}")),
        )

    def _about(self, freedom: Freedom) -> tuple[Vector, Vector]:
        """Vector along which the relative angular velocity is the rate of a turn, and the vector's rate.

        Of a single turn it is the axis; of two it is perpendicular to the other's axis.
        """
        w, v = (motion.angular_velocity for motion in self.motions)
        if len(self.joint.turning) == 1:
            about = self.kin.direction(self.joint.child, _axis_of(freedom))
            return about, cross(w, about)
        first, second = self._both()
        a, b = self.kin.direction(self.joint.parent, first), self.kin.direction(self.joint.child, second)
        pairs = [(a, cross(v, a)), (b, cross(w, b))]
        (own, own_rate), (other, other_rate) = pairs if freedom.axis == first else reversed(pairs)
        cosine = dot(first.unit, second.unit)
        size = 1 / (1 - cosine**2)
        return scale(size, sub(own, scale(cosine, other))), scale(size, sub(own_rate, scale(cosine, other_rate)))

    def _both(self) -> tuple[Direction, Direction]:
        """Axes of two turns, the first fixed in the parent, the second in the child."""
        first, second = (axis for axis in self.joint.turning if axis is not None)
        return first, second

    def _components(self, freedom: Freedom) -> tuple[Any, Any]:
        """Cosine and sine of the angle of a turn, by directions fixed in child and parent."""
        axis, (child, parent) = _axis_of(freedom), (self.joint.child, self.joint.parent)
        if len(self.joint.turning) == 1:
            (first, _), _ = across(axis)
            second = Direction(cross(axis.unit, first.unit))
            arm = self.kin.direction(child, first)
            cosine, sine = (dot(arm, self.kin.direction(parent, direction)) for direction in (first, second))
            return cosine, sine
        one, two = self._both()
        level = dot(one.unit, two.unit)
        size, normal = 1 / (1 - level**2), cross(one.unit, two.unit)
        if freedom.axis == one:  # the second axis, about the first, in the parent
            arm, ways = self.kin.direction(child, two), (sub(two.unit, scale(level, one.unit)), normal)
            axes = self.kin.axes_of(parent)
        else:  # the first axis, about the second, in the child
            arm, ways = self.kin.direction(parent, one), (sub(one.unit, scale(level, two.unit)), normal)
            axes = self.kin.axes_of(child)
        cosine, sine = (size * dot(arm, apply(axes, way)) for way in ways)
        return cosine, sine

    def _angle(self, freedom: Freedom, rate: Any) -> Any:
        """Angle of the child against the parent of a turn; None in space where nothing counts its whole turns."""
        k, axis, label = self.kin.mechanism.plane, _axis_of(freedom), freedom.label
        if k is not None:
            one, two = (self.kin.turned(body, k) for body in self.bodies)
            turned = one + self.joint.child.turned_about(k) - two - self.joint.parent.turned_about(k)
            return self._let(axis.unit[k] * turned, label)
        near = self.kin.counted.get(freedom.key)
        if near is None:
            return None
        cosine, sine = self._components(freedom)
        x, y = self._let(sp.cos(near), f"{label}_near_cosine"), self._let(sp.sin(near), f"{label}_near_sine")
        angle = self._let(near + sp.atan2(sine * x - cosine * y, cosine * x + sine * y), label)
        self.tape.set_rate(angle, rate)
        return angle

    def driven(self, freedom: Freedom) -> Constraint:
        """Constraint of a driven freedom; for an angle in space the sine of the error vanishes."""
        (wanted,), (row,) = self.kin.prescribed[freedom.key]
        measurement, joint, slides = self.measured(freedom), self.joint, freedom.kind == "slide"
        label = freedom.label
        if measurement.value is None:
            cosine, sine = self._components(freedom)
            error = sine * self._let(sp.cos(wanted), f"{label}_cosine") - cosine * self._let(
                sp.sin(wanted), f"{label}_sine"
            )
        else:
            error = measurement.value - wanted
        return Constraint(
            f"{joint.name}.{'off' if slides else 'turned'}_{label}",
            "m" if slides else "1",
            f"{joint.name}.{label}",
            self._let(error, f"{label}_left"),
            self._let(measurement.rate - row.speed, f"{label}_left_rate"),
            self._let(measurement.bias - row.acceleration, f"{label}_left_bias"),
            measurement.column,
            freedom.key,
        )

    def _let(self, expression: Any, label: str) -> Any:
        return self.tape.let(expression, f"{self.joint.name}_{label}")

    def _force(self, direction: Vector, label: str, moment: Vector = ZERO) -> dict[str, Any]:
        """Generalised forces of a unit force on the child at its point, and of a moment."""
        name = f"{self.joint.name}_{label}"
        column = self.kin.generalised(direction, self.place, *self.bodies, name)
        turned = {} if is_zero(moment) else self.kin.generalised_moment(moment, *self.bodies, f"{name}_turned")
        return _without_zeros({key: column[key] + turned.get(key, 0) for key in column})


def _axis_of(freedom: Freedom) -> Direction:
    """Axis of a turn or a slide; raises TypeError for a ball."""
    if freedom.axis is None:
        raise TypeError(f"{freedom.key} turns about every axis, so it has no single angle")
    return freedom.axis


def _without_zeros(column: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in column.items() if value != 0}
