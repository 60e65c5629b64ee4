"""Springs and dampers of a joint or between two points, linear or by a law of length and rate."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.effect import Declared, Effect, Element, JointEffect, Kinematics, Mark
from hertzwerk.derive.declare.effects.state_expression import (
    COORDINATE,
    LENGTH,
    LENGTH_RATE,
    LOADS,
    REACH,
    REACH_RATE,
    Varying,
    as_choice,
    shown,
)
from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import Vector, dot, scale, sub
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, POSITIVE, Scalar, Slot


@dataclass(frozen=True)
class JointSpring(JointEffect):
    """Spring k (q - rest) on a joint's coordinate [N/m, or N m per rad], torsional on a revolute joint."""

    name: str
    joint: str
    stiffness: Scalar
    rest: Scalar = 0
    kind: ClassVar[str] = "spring"
    reads: ClassVar[str] = COORDINATE
    drawn: ClassVar[bool] = True
    measures: ClassVar[Mapping[str, Slot]] = {
        "stiffness": Slot.of("{force}/({coordinate})", NOT_NEGATIVE),
        "rest": Slot.of("{coordinate}"),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        return f"linear spring of {self.joint}"

    def element(self, kin: Kinematics) -> Element:
        """Force, and the stored energy."""
        stiffness = sp.sympify(self.stiffness)
        stretch = kin.tape.let(kin.coordinate(self.joint) - sp.sympify(self.rest), f"{self.name}_stretch")
        force = kin.tape.let(-stiffness * stretch, f"{self.name}_force")
        return Element(kin.on_joint(self.joint, force, self.name), stored=stiffness * stretch**2 / 2)


@dataclass(frozen=True)
class JointDamper(JointEffect):
    """Viscous friction of a joint, c q' [N s/m, or N m s per rad]."""

    name: str
    joint: str
    damping: Scalar
    kind: ClassVar[str] = "damper"
    drawn: ClassVar[bool] = True
    measures: ClassVar[Mapping[str, Slot]] = {"damping": Slot.of("{force}/({speed})", NOT_NEGATIVE)}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"viscous damper of {self.joint}"

    def element(self, kin: Kinematics) -> Element:
        """Force, and the dissipated power."""
        speed = kin.speed(self.joint)
        force = kin.tape.let(-sp.sympify(self.damping) * speed, f"{self.name}_force")
        return Element(kin.on_joint(self.joint, force, self.name), dissipated=-force * speed)


class BetweenPoints(Effect):
    """Effect between two points, of two bodies."""

    first: Point
    second: Point
    ends: ClassVar[str] = "ends"

    @property
    def points(self) -> tuple[Point, ...]:
        """Both ends."""
        return self.first, self.second

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield the fault of both on one body."""
        yield from super().faults(scene)
        if self.first.body == self.second.body:
            yield Fault(self.where, f"both {self.ends} on {self.first.body.name}", "points of two different bodies")

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield both places."""
        yield self.kind, "first", self.first, {}
        yield self.kind, "second", self.second, {}


class AlongLine(BetweenPoints):
    """Force along the line through two points, of two bodies."""

    def _line(self, kin: Kinematics) -> tuple[Vector, Vector]:
        """Vector from the first end to the second [m], and its rate [m/s]."""
        one, one_rate, _ = kin.point(self.first, f"{self.name}_first")
        two, two_rate, _ = kin.point(self.second, f"{self.name}_second")
        between = kin.tape.vector(sub(two, one), f"{self.name}_between")
        return between, kin.tape.vector(sub(two_rate, one_rate), f"{self.name}_rate")

    def _pulled(self, kin: Kinematics, tension: Any, between: Vector) -> dict[str, Any]:
        """Generalised forces of a tension per length [N/m] that pulls both ends together."""
        force = kin.tape.vector(scale(tension, between), f"{self.name}_force")
        position, _, _ = kin.point(self.first, f"{self.name}_first")
        return kin.generalised(force, position, self.first.body, self.second.body, self.name)


@dataclass(frozen=True)
class PointSpring(AlongLine):
    """Spring k (distance - rest length) between two points, along the line through them.

    Where the points coincide the direction of a spring with a rest length is undefined, and its force is zero.
    """

    name: str
    first: Point
    second: Point
    stiffness: Scalar
    rest_length: Scalar | None = None
    kind: ClassVar[str] = "spring"
    measures: ClassVar[Mapping[str, Slot]] = {
        "stiffness": Slot.of("N/m", NOT_NEGATIVE),
        "rest_length": Slot.of("m", POSITIVE),
    }

    @property
    def text(self) -> str:
        """Description for people."""
        return f"linear spring between {self.first.body.name} and {self.second.body.name}"

    def element(self, kin: Kinematics) -> Element:
        """Force, and the stored energy."""
        between, _ = self._line(kin)
        stiffness = sp.sympify(self.stiffness)
        squared = kin.tape.let(dot(between, between), f"{self.name}_squared")
        if self.rest_length is None:
            return Element(self._pulled(kin, stiffness, between), stored=stiffness * squared / 2)
        rest = sp.sympify(self.rest_length)
        # where the ends coincide the length counts as the rest length: nothing is divided by zero, in the derivatives either
        reach = kin.tape.let(sp.sqrt(Where(squared > 0, squared, rest**2)), f"{self.name}_length")
        tension = kin.tape.let(stiffness * (1 - rest / reach), f"{self.name}_per_length")
        return Element(self._pulled(kin, tension, between), stored=stiffness * (sp.sqrt(squared) - rest) ** 2 / 2)


@dataclass(frozen=True)
class PointDamper(AlongLine):
    """Damper between two points, c times the rate of their distance, along the line through them.

    No force where they coincide.
    """

    name: str
    first: Point
    second: Point
    damping: Scalar
    kind: ClassVar[str] = "damper"
    measures: ClassVar[Mapping[str, Slot]] = {"damping": Slot.of("N s/m", NOT_NEGATIVE)}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"viscous damper between {self.first.body.name} and {self.second.body.name}"

    def element(self, kin: Kinematics) -> Element:
        """Force, and the dissipated power."""
        between, rate = self._line(kin)
        squared = kin.tape.let(dot(between, between), f"{self.name}_squared")
        along = kin.tape.let(dot(between, rate), f"{self.name}_along")
        nonzero = Where(squared > 0, squared, sp.sympify(kin.scene.scales.length) ** 2)
        drag = kin.tape.let(sp.sympify(self.damping) * along / nonzero, f"{self.name}_per_length")
        return Element(self._pulled(kin, drag, between), dissipated=drag * along)


@dataclass(frozen=True)
class LineForce(AlongLine):
    """Spring, damper, rope or stop between two points, by any law of their distance and its rate.

    The tension [N], which pulls the points together where it is positive, is an expression of `LENGTH`, `LENGTH_RATE`,
    the time, coordinates, speeds and states: a rope that only pulls is Where(LENGTH > l, k (LENGTH - l), 0). Its power is
    booked as input, which an elastic law takes and gives back. No force where the points coincide.
    """

    name: str
    first: Point
    second: Point
    tension: Scalar
    kind: ClassVar[str] = "spring"
    measures: ClassVar[Mapping[str, Slot]] = {"tension": Varying.of("N", on=(REACH, REACH_RATE, *LOADS))}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"tension {shown(self.tension)} between {self.first.body.name} and {self.second.body.name}"

    def element(self, kin: Kinematics) -> Element:
        """Force, its power, and histories of length and tension."""
        between, rate = self._line(kin)
        squared = kin.tape.let(dot(between, between), f"{self.name}_squared")
        apart = Where(squared > 0, squared, sp.sympify(kin.scene.scales.length) ** 2)
        length = kin.tape.let(sp.sqrt(apart), f"{self.name}_length")
        closing = kin.tape.let(dot(between, rate) / length, f"{self.name}_length_rate")
        law = sp.sympify(as_choice(self.tension)).xreplace({LENGTH: length, LENGTH_RATE: closing})
        tension = kin.tape.let(kin.expression(law), f"{self.name}_tension")
        per_length = kin.tape.let(Where(squared > 0, tension, 0) / length, f"{self.name}_per_length")
        outputs = (f"{self.name}.length", "m", sp.sqrt(squared)), (f"{self.name}.tension", "N", tension)
        return Element(self._pulled(kin, per_length, between), input=-tension * closing, outputs=outputs)
