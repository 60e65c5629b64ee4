"""Contact geometry of a corner and a face."""

from __future__ import annotations

from functools import cached_property
from typing import Any, ClassVar

import sympy as sp

from hertzwerk.derive.algebra.functions import Where
from hertzwerk.derive.algebra.vectors import Vector, dot
from hertzwerk.derive.contact.touch.touch import Touch, touch
from hertzwerk.derive.mechanism.pairs.corner import CornerOnFace


@touch.register(CornerOnFace)
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
        return self.let(dot(self._directions[0], self.apart), "height")

    @cached_property
    def _ends(self) -> tuple[Any, Any] | None:
        """Condition for the nearer end, and the distance beyond it [m]; None for a face without ends."""
        if self._directions[1] is None:
            return None
        way = self.let(dot(self._directions[1], self.apart), "way")
        beyond = Where(way > 0, way, -way) - sp.sympify(self.pair.length) / 2
        return way > 0, self.let(beyond, "beyond")

    def _nearest(self, face: Any, end: Any, what: str) -> Any:
        """Choose between values for the face and for its end, by which the corner is nearer to."""
        if self._ends is None:
            return face
        return self.let(Where(self._height > self._ends[1], face, end), what)

    def _outwards(self, value: Any, what: str) -> Any:
        """Component along the face towards the nearer end."""
        return 0 if self._ends is None else self.let(Where(self._ends[0], value, -value), what)

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
