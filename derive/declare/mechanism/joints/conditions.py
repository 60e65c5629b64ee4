"""Conditions of a loop-closing joint on child and parent, and their directions. Declarations only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from hertzwerk.derive.declare.mechanism.bodies import AXES, Direction
from hertzwerk.derive.declare.mechanism.curve import SolidCurve
from hertzwerk.derive.expressions.algebra.vectors import ZERO, Vector, add, along, cross, dot, scale
from hertzwerk.derive.expressions.parameter import default_value

CHILD, PARENT = 0, 1
PARALLEL = 1e-9  # greatest sine, or cosine, of directions that count as parallel, or perpendicular


Moving = tuple[Vector, Vector, Vector]
"""A vector in ground axes, its rate, and its second rate at zero generalised accelerations."""


class JointMotion(Protocol):
    """Protocol of the joint's kinematics as its conditions need it."""

    def fixed(self, side: int, direction: Direction, label: str) -> Moving:
        """A direction fixed in the child or the parent, with its rates."""

    def named(self, vector: Vector, label: str) -> Vector:
        """Name a vector."""


class Carried(Protocol):
    """Protocol of a direction that depends on the positions of child and parent."""

    def moving(self, shown: JointMotion, label: str) -> Moving:
        """The direction and its rates."""

    def moment(self, shown: JointMotion, label: str, force: Vector) -> Vector:
        """Moment on the child, against the parent, with the power of a force at the tip of the direction."""


@dataclass(frozen=True)
class FixedIn:
    """Direction fixed in the child's point or the parent's."""

    side: int
    direction: Direction

    def moving(self, shown: JointMotion, label: str) -> Moving:
        """The direction and its rates."""
        return shown.fixed(self.side, self.direction, label)

    def moment(self, shown: JointMotion, label: str, force: Vector) -> Vector:
        """Moment on the child; zero for a direction fixed in the parent."""
        return ZERO if self.side == PARENT else cross(self.moving(shown, label)[0], force)


@dataclass(frozen=True)
class Product:
    """Vector product of two directions."""

    first: Carried
    second: Carried

    def moving(self, shown: JointMotion, label: str) -> Moving:
        """The product and its rates."""
        (a, da, dda), (b, db, ddb) = self.first.moving(shown, f"{label}_1"), self.second.moving(shown, f"{label}_2")
        rate = shown.named(add(cross(da, b), cross(a, db)), f"{label}_rate")
        bent = add(cross(dda, b), scale(2, cross(da, db)), cross(a, ddb))
        return shown.named(cross(a, b), label), rate, shown.named(bent, f"{label}_bent")

    def moment(self, shown: JointMotion, label: str, force: Vector) -> Vector:
        """Moment on the child, by the product rule."""
        a, b = self.first.moving(shown, f"{label}_1")[0], self.second.moving(shown, f"{label}_2")[0]
        first = self.first.moment(shown, f"{label}_1", cross(b, force))
        return add(first, self.second.moment(shown, f"{label}_2", cross(force, a)))


@dataclass(frozen=True)
class Sum:
    """Linear combination of directions with constant factors."""

    parts: tuple[tuple[Any, Carried], ...]

    def moving(self, shown: JointMotion, label: str) -> Moving:
        """The sum and its rates."""
        parts = [(factor, part.moving(shown, f"{label}{i}")) for i, (factor, part) in enumerate(self.parts)]
        value, rate, bent = (add(*(scale(factor, part[k]) for factor, part in parts)) for k in range(3))
        return shown.named(value, label), shown.named(rate, f"{label}_rate"), shown.named(bent, f"{label}_bent")

    def moment(self, shown: JointMotion, label: str, force: Vector) -> Vector:
        """Moment on the child, the sum over all parts."""
        parts = enumerate(self.parts)
        return add(*(scale(factor, part.moment(shown, f"{label}{i}", force)) for i, (factor, part) in parts))


@dataclass(frozen=True)
class Coincident:
    """Condition: both points coincide."""


@dataclass(frozen=True)
class NoDisplacement:
    """Condition: the child's point has no displacement along a direction."""

    direction: Carried
    label: str


@dataclass(frozen=True)
class ConstantAngle:
    """Condition: a direction of the child keeps its angle to one of the parent.

    Where all coordinates are zero, both are given in the same axes.
    """

    on_child: Direction
    on_parent: Direction
    label: str


@dataclass(frozen=True)
class OnTrack:
    """Condition: the child's point is on a curve fixed to the parent's."""

    curve: SolidCurve


Condition = Coincident | NoDisplacement | ConstantAngle | OnTrack


def numbers(direction: Direction) -> tuple[float, float, float]:
    """Components of the unit vector at the parameters' defaults."""
    x, y, z = map(default_value, direction.unit)
    return x, y, z


def parallel(one: Direction, two: Direction) -> bool:
    """Whether two directions are parallel or opposite, at the defaults."""
    return all(abs(x) < PARALLEL for x in cross(numbers(one), numbers(two)))


def perpendicular(one: Direction, two: Direction) -> bool:
    """Whether two directions are perpendicular, at the defaults."""
    return bool(abs(dot(numbers(one), numbers(two))) < PARALLEL)


def across(direction: Direction) -> list[tuple[Direction, str]]:
    """Two directions perpendicular to one and each other, with their labels."""
    k = along(direction.unit)
    if k is not None:
        return [(AXES[i], "xyz"[i]) for i in range(3) if i != k]
    unit = direction.unit
    least = min(range(3), key=lambda i: abs(default_value(unit[i])))
    first = Direction(cross(unit, AXES[least].unit))
    return [(first, "1"), (Direction(cross(unit, first.unit)), "2")]
