"""Resistance of a touching pair to rolling and to drilling, fed by its normal force."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.contacts import contact_faults
from hertzwerk.derive.declare.effects.effect import CONTACT, Declared, PairEffect, Turning
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, dot, scale, sub
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot


@dataclass(frozen=True)
class Grip:
    """Friction with stick and slip: directions and limits of its force, or of its moment about axes.

    tangents  unit vectors along which the first body may slide, or turn, on the second: one in plane motion, else two; one of spin
    along     generalised force by joint, per newton on the first body along each tangent, or per newton metre
    velocity  sliding velocity along each tangent [m/s], or angular velocity [rad/s]
    sliding   friction force while sliding [N], or moment while turning [N m]
    holding   greatest at rest

    Of a patch the third is its rim's speed by spin, and the moment over its radius.
    """

    tangents: tuple[Vector, ...]
    along: tuple[Mapping[str, Any], ...]
    velocity: tuple[Any, ...]
    sliding: Any
    holding: Any


@dataclass(frozen=True)
class Moment:
    """Moment on the first body [N m], generalised forces by joint, and dissipated power [W]."""

    vector: Vector
    generalised: Mapping[str, Any]
    power: Any


class PairResistance(PairEffect):
    """Moment -c N w/sqrt(w^2 + w0^2) on the first body against a relative angular velocity w.

    It is a part of the first body's against the second's. `coefficient` c [m], the arm of the normal force N; `speed` w0
    [rad/s] smooths the change of sign: at 10 w0 the moment is within 0.5 % of c N, at 100 w0 within 5e-5. Without it the
    moment is set-valued, as Coulomb's friction: c N against w, and at rest whatever keeps w = 0, up to c N.
    """

    name: str
    pair: str
    coefficient: Scalar
    speed: Scalar | None
    enters: ClassVar[str] = CONTACT
    holds: ClassVar[str] = "N m"
    """Unit of what it holds with."""
    measures: ClassVar[Mapping[str, Slot]] = {
        "coefficient": Slot.of("m", NOT_NEGATIVE),
        "speed": Slot.of("rad/s", POSITIVE),
    }
    mode: ClassVar[str] = "turning"
    """Name of its slip: of a force or of a moment."""
    sought: ClassVar[tuple[str, ...]] = ("turning", "turning_speed", "moment", "turning_velocity", "holding_moment")

    @property
    def text(self) -> str:
        """Description for people."""
        return f"{self.kind.replace('_', ' ')} at {self.pair}"

    @property
    def has_modes(self) -> bool:
        """Whether it is set-valued, with rest as a mode."""
        return self.speed is None

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield faults of a pair without a contact."""
        yield from contact_faults(self, scene) or super().faults(scene)

    def opposed(self, turning: Vector, normal: Vector) -> Vector:
        """Part of a relative angular velocity that it opposes."""
        raise NotImplementedError

    def axes(self, touch: Any) -> tuple[Vector, ...]:
        """Axes of the turning that it opposes, at a contact geometry (a `Touch`)."""
        raise NotImplementedError

    def grip(self, kin: Turning, touch: Any, pressing: Any) -> Grip:
        """Grip of a set-valued resistance, under the force that presses [N]."""
        bodies, tape, axes = (touch.first.body, touch.second.body), kin.tape, self.axes(touch)
        relative = sub(*map(kin.angular_velocity, bodies))
        velocity = tuple(tape.let(dot(relative, axis), f"{self.name}_turning_velocity") for axis in axes)
        limit = tape.let(sp.sympify(self.coefficient) * pressing, f"{self.name}_holding_moment")
        along = tuple(kin.generalised_moment(axis, *bodies, f"{self.name}_grip") for axis in axes)
        return Grip(axes, along, velocity, limit, limit)

    def held(self, grip: Grip, components: Sequence[Any]) -> tuple[Vector, Vector]:
        """Force [N] and moment [N m] on the first body of what its grip holds with along each tangent."""
        return ZERO, add(*(scale(part, axis) for part, axis in zip(components, grip.tangents, strict=True)))

    def moment(self, kin: Turning, touch: Any, pressing: Any) -> Moment:
        """Moment at a contact geometry (a `Touch`), under the force that presses [N]."""
        bodies, tape = (touch.first.body, touch.second.body), kin.tape
        relative = sub(*map(kin.angular_velocity, bodies))
        turning = tape.vector(self.opposed(relative, touch.normal), f"{self.name}_turning")
        square = tape.let(dot(turning, turning), f"{self.name}_turning_squared")
        fast = tape.let(sp.sqrt(square + sp.sympify(self.speed) ** 2), f"{self.name}_turning_speed")
        per_speed = tape.let(sp.sympify(self.coefficient) * pressing / fast, f"{self.name}_per_speed")
        vector = tape.vector(scale(-per_speed, turning), f"{self.name}_moment")
        generalised = kin.generalised_moment(vector, *bodies, self.name)
        return Moment(vector, generalised, tape.let(per_speed * square, f"{self.name}_power"))


def _with_modes(below: str, motion: str) -> dict[str, tuple[str, str, str]]:
    """Quantities of a set-valued resistance, with the letter of their subscript."""
    quantities = {
        "turning_velocity": (r"\omega", rf"\mathrm{{{below}}}", f"angular velocity of {motion}"),
        "holding_moment": (
            "M",
            rf"\mathrm{{{below}h}}",
            f"moment against {motion}, and the most that holds it at rest",
        ),
        "resting_moment": ("M", rf"\mathrm{{{below}s}}", f"what keeps it from {motion}, at most the holding moment"),
    }
    for i in (1, 2):
        quantities[f"moment_{i}"] = ("M", rf"\mathrm{{{below}{i}}}", f"moment against {motion}, about tangent {i}")
        rests = f"what keeps it from {motion} about tangent {i}, with the other's at most the holding moment"
        quantities[f"resting_moment_{i}"] = ("M", rf"\mathrm{{{below}s{i}}}", rests)
    return quantities


@dataclass(frozen=True)
class RollingResistance(PairResistance):
    """Rolling resistance of a pair, against the relative angular velocity in its tangent plane.

    `coefficient` [m] is the arm by which the normal force lies ahead of the contact's middle, the angle of repose of a
    wheel times its radius. Source: Johnson, Contact Mechanics (1985), chapter 9.
    """

    name: str
    pair: str
    coefficient: Scalar
    speed: Scalar | None = None
    kind: ClassVar[str] = "rolling_resistance"
    quantities: ClassVar[Mapping[str, tuple[str, str, str]]] = {
        "turning": (r"\omega", r"\mathrm{r}", "angular velocity of rolling, of the first body against the second"),
        "turning_squared": (r"\omega^{2}", r"\mathrm{r}", "its square"),
        "turning_speed": (r"\Omega", r"\mathrm{r}", "its smoothed magnitude"),
        "per_speed": ("c", r"\mathrm{r}", "rolling resistance per angular velocity"),
        **_with_modes("r", "rolling"),
        "moment": ("M", r"\mathrm{r}", "moment against rolling, on the first body"),
        "power": ("P", r"\mathrm{r}", "power dissipated by rolling"),
    }

    def opposed(self, turning: Vector, normal: Vector) -> Vector:
        """Part of a relative angular velocity across the normal."""
        spin = dot(turning, normal)
        return turning if spin == 0 else sub(turning, scale(spin, normal))

    def axes(self, touch: Any) -> tuple[Vector, ...]:
        """Tangents of the surfaces; in plane motion the normal of the plane."""
        plane = touch.plane_of_motion
        return (plane,) if plane is not None else touch.tangents


@dataclass(frozen=True)
class DrillingResistance(PairResistance):
    """Drilling resistance of a pair, against spin: the relative angular velocity about the normal.

    Friction mu on a circular patch of radius a holds c N with the `coefficient` c = 3 pi/16 mu a under Hertz's pressure,
    and 2/3 mu a under a uniform one: the integral of mu p r over the patch. Source: Johnson, Contact Mechanics (1985),
    chapter 7; Popov, Contact Mechanics and Friction (2010). Friction that slides at the same time is not weakened.
    """

    name: str
    pair: str
    coefficient: Scalar
    speed: Scalar | None = None
    kind: ClassVar[str] = "drilling_resistance"
    quantities: ClassVar[Mapping[str, tuple[str, str, str]]] = {
        "turning": (r"\omega", r"\mathrm{d}", "angular velocity of spin, of the first body against the second"),
        "turning_squared": (r"\omega^{2}", r"\mathrm{d}", "its square"),
        "turning_speed": (r"\Omega", r"\mathrm{d}", "its smoothed magnitude"),
        "per_speed": ("c", r"\mathrm{d}", "drilling resistance per angular velocity"),
        **_with_modes("d", "spin"),
        "moment": ("M", r"\mathrm{d}", "moment against spin, on the first body"),
        "power": ("P", r"\mathrm{d}", "power dissipated by spin"),
    }

    def opposed(self, turning: Vector, normal: Vector) -> Vector:
        """Part of a relative angular velocity along the normal."""
        return scale(dot(turning, normal), normal)

    def axes(self, touch: Any) -> tuple[Vector, ...]:
        """Return the normal of the surfaces."""
        return (touch.normal,)
