"""Pair of user-defined surfaces, given by expressions, and how they touch."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

from hertzwerk.derive.declare.effects.state_expression import as_choice
from hertzwerk.derive.declare.mechanism.bodies import Point
from hertzwerk.derive.declare.mechanism.pair import LENGTH, Components, Pair
from hertzwerk.derive.declare.mechanism.pose import APART, TURN, Posed
from hertzwerk.derive.equations.contact.touch import Touch
from hertzwerk.derive.equations.motion.kinematics import Kinematics
from hertzwerk.derive.expressions.algebra.vectors import Vector, add, apply, multiply, transpose
from hertzwerk.derive.expressions.parameter import POSITIVE, Scalar, Slot


@dataclass(frozen=True)
class CustomPair(Pair):
    """User-defined surfaces: gap, normal and contact point as expressions of `APART`, `TURN`, parameters.

    All along the axes of the second place.

    gap            signed distance of the surfaces [m], negative while they penetrate
    normal         unit vector that pushes the first body, (x, y, z)
    contact_point  the point of contact, from the second place, (x, y, z) [m]

    The rest is derived. `radius` [m] is that of relative curvature, for laws that depend on it; `length` [m] that of
    a line contact: without it the contact is a point. A gap whose rate is not the speed at which the bodies approach
    along the normal at the contact point is refused: its forces would not conserve energy.
    """

    first: Point
    second: Point
    gap: Scalar
    normal: Components
    contact_point: Components
    radius: Scalar | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "custom"
    measures: ClassVar[Mapping[str, Slot]] = {"radius": LENGTH, "length": Slot.of("m", POSITIVE, law_symbol="L")}

    @property
    def form(self) -> str:  # type: ignore[override]  # here it depends on what is given
        """Line contact if it has a length, else point contact."""
        return "point" if self.length is None else "line"

    @property
    def geometry(self) -> dict[str, Any]:
        """Radius and length, if given."""
        sizes = {"R_eff": self.radius, "R_min": self.radius, "L": self.length}
        return {name: value for name, value in sizes.items() if value is not None}

    def slots(self) -> Iterator[Slot]:
        """Yield the expressions and the places."""
        yield Posed(f"pair {self.name}, gap", self.gap, "m")
        for label, values, unit in (("normal", self.normal, "1"), ("contact point", self.contact_point, "m")):
            for axis, value in zip("xyz", values, strict=True):
                yield Posed(f"pair {self.name}, {label}, {axis}", value, unit)
        yield from super().slots()

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return CustomTouch(self, kinematics)


class CustomTouch(Touch):
    """User-defined surfaces."""

    @cached_property
    def _pose(self) -> dict[Any, Any]:
        """The user's pose symbols on the tape."""
        back = transpose(self.kin.axes_of(self.second))
        apart = self.named(apply(back, self.apart), "local_apart")
        turn = self.tape.matrix(multiply(back, self.kin.axes_of(self.first)), f"{self.pair.name}_turn")
        rows = zip(TURN, turn, strict=True)
        return dict(zip(APART, apart, strict=True)) | {s: v for row in rows for s, v in zip(*row, strict=True)}

    def _stated(self, value: Any) -> Any:
        return as_choice(value).xreplace(self._pose)

    def _in_ground(self, components: Any, label: str) -> Vector:
        x, y, z = (self._stated(value) for value in components)
        local = self.named((x, y, z), f"local_{label}")
        return self.named(apply(self.kin.axes_of(self.second), local), label)

    @cached_property
    def gap(self) -> Any:
        """Gap as declared."""
        return self.let(self._stated(self.pair.gap), "gap")

    @cached_property
    def normal(self) -> Vector:
        """Normal as declared."""
        return self._in_ground(self.pair.normal, "normal")

    @cached_property
    def position(self) -> Vector:
        """The contact point."""
        return add(self.base, self._in_ground(self.pair.contact_point, "contact_arm"))
