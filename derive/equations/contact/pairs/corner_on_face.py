"""Pair of a corner and a face, and how they touch."""

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
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.vectors import Vector, dot
from hertzwerk.derive.expressions.parameter import Scalar, Slot, default_value


@dataclass(frozen=True)
class CornerOnFace(Pair):
    """Corner, or any point, of one body that may touch a plane face of another.

    `face` is the middle of the face, `normal` points out of its solid, in the frame of `face`. With a `length` the
    face, and the solid below it, end at length/2 to both sides `along` it: beyond them the corner is free, and from
    there it meets the end of the solid, not its face.
    """

    corner: Point
    face: Point
    normal: Direction
    along: Direction | None = None
    length: Scalar | None = None
    kind: ClassVar[str] = "corner_on_face"
    guides: ClassVar[bool] = True
    wears: ClassVar[str] = "flat"
    measures: ClassVar[Mapping[str, Slot]] = {"length": LENGTH}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Normal, direction and length of the face, for landmarks."""
        face: dict[str, Any] = {"normal": in_body(self.face, self.normal)}
        if self.along is not None:
            face |= {"along": in_body(self.face, self.along), "length": self.length}
        return {}, face

    def faults(self) -> Iterator[Fault]:
        """A face that ends needs a direction in it, and a length."""
        if (self.along is None) != (self.length is None):
            actual = (
                "a length without a direction along the face" if self.along is None else "a direction without a length"
            )
            yield Fault(f"pair {self.name}", actual, "both, for a face that ends, or neither")
        if self.along is not None:
            normal, along_face = ([default_value(part) for part in axis.unit] for axis in (self.normal, self.along))
            cosine = sum(a * b for a, b in zip(normal, along_face, strict=True))
            if abs(cosine) > 1e-9:
                yield Fault(
                    f"pair {self.name}, along",
                    f"a direction at a cosine of {cosine:.3g} to the normal",
                    "one square to it",
                )

    def touch(self, kinematics: Kinematics) -> Touch:
        """Contact geometry on the kinematics' tape."""
        return BoundedFace(self, kinematics)


class BoundedFace(Touch):
    """Bounded plane face of a solid.

    The gap is the greater of the height over the face and the distance beyond its ends.
    """

    proved: ClassVar[bool] = True

    @cached_property
    def _directions(self) -> tuple[Vector, Vector | None]:
        along = self.pair.along
        return (
            self.named(self.kin.direction(self.second, self.pair.normal), "direction"),
            None if along is None else self.named(self.kin.direction(self.second, along), "line"),
        )

    @cached_property
    def _height(self) -> Any:
        worn = 0 if self.worn is None else self.worn.depth
        return self.let(dot(self._directions[0], self.apart) + worn, "height")

    @cached_property
    def _ends(self) -> tuple[Any, Any] | None:
        """Condition for the nearer end, and the distance beyond it [m]; None for a face without ends."""
        if self._directions[1] is None:
            return None
        way = self.let(dot(self._directions[1], self.apart), "way")
        beyond = Where(way > 0, way, -way) - sp.sympify(self.pair.length) / 2
        return way > 0, self.let(beyond, "beyond")

    def _nearest(self, face: Any, end: Any, label: str) -> Any:
        """Choose between values for the face and for its end, by which the corner is nearer to."""
        if self._ends is None:
            return face
        return self.let(Where(self._height > self._ends[1], face, end), label)

    def _outwards(self, value: Any, label: str) -> Any:
        """Component along the face towards the nearer end."""
        return 0 if self._ends is None else self.let(Where(self._ends[0], value, -value), label)

    @cached_property
    def gap(self) -> Any:
        """Signed distance of the corner to the solid [m].

        Outside beside an edge it is the greater of both distances, so that its sign is right everywhere.
        """
        return self._nearest(self._height, None if self._ends is None else self._ends[1], "gap")

    @cached_property
    def _rates(self) -> tuple[Any, Any]:
        """Rates of the height and of the distance along the face [m/s]."""
        name, line = self.pair.name, self._directions[1]
        height = self.tape.rate(self._height, f"{name}_height_rate")
        return height, 0 if line is None else self.tape.rate(self.let(dot(line, self.apart), "way"), f"{name}_way_rate")

    @cached_property
    def gap_rate(self) -> Any:
        """Rate of the gap [m/s]."""
        height, way = self._rates
        return self._nearest(height, self._outwards(way, "beyond_rate"), "gap_rate")

    @cached_property
    def gap_acceleration(self) -> Any:
        """Second derivative of the gap [m/s^2]."""
        height, way = (self.tape.rate(rate, f"{self.pair.name}_second") for rate in self._rates)
        return self._nearest(height, self._outwards(way, "beyond_acceleration"), "gap_acceleration")

    @cached_property
    def normal(self) -> Vector:
        """Normal of the face; beyond an end outwards there."""
        normal, along = self._directions
        if self._ends is None or along is None:
            return normal
        far, beyond = self._ends
        ex, ey, ez = (_choice(far, component, -component) for component in along)
        end = self.named((ex, ey, ez), "end")
        on_face = self._height > beyond
        x, y, z = (_choice(on_face, face, side) for face, side in zip(normal, end, strict=True))
        return self.named((x, y, z), "normal")


def _choice(condition: Any, a: Any, b: Any) -> Any:
    return a if a == b else Where(condition, a, b)
