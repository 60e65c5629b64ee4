"""Pair of a box and a plane: eight corners, or four of a rectangle in plane motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import product
from typing import ClassVar

import sympy as sp

from hertzwerk.derive.declare.mechanism.bodies import Direction, Point
from hertzwerk.derive.declare.mechanism.pair import LENGTH, Pair
from hertzwerk.derive.equations.contact.pairs.corner_on_face import CornerOnFace
from hertzwerk.derive.expressions.algebra.vectors import add, apply
from hertzwerk.derive.expressions.parameter import Scalar, Slot


@dataclass(frozen=True)
class BoxOnPlane(Pair):
    """Box that may touch a plane, with its corners: two where it stands on an edge, four on a face.

    `box` is its middle, with sizes x, y, z along the axes there; `normal` points out of the solid, in the plane's frame.
    Without z it is a rectangle that moves in the plane of x and y, and each of its four corners stands for an edge.

    It is as many pairs, NAME_1.. in the order (-,-,-), (+,-,-), (-,+,-), (+,+,-), (-,-,+).. of the corners' x, y, z. What
    acts at NAME acts at each of them: `Contact("floor", law)` is `Contact("floor_1", law)`.., with its own force each. An
    effect declared at one corner by its own name stands in place of what the others share.
    """

    box: Point
    x: Scalar
    y: Scalar
    plane: Point
    normal: Direction
    z: Scalar | None = None
    measures: ClassVar[Mapping[str, Slot]] = dict.fromkeys("xyz", LENGTH)

    @property
    def parts(self) -> tuple[Pair, ...]:
        """Corners, each a pair; the box itself where it cannot be placed, a fault the scene finds."""
        return tuple(self._corners()) if self.placed else (self,)

    def _corners(self) -> Iterator[Pair]:
        a, b, c = (sp.sympify(size) / 2 for size in (self.x, self.y, self.z or 0))
        signs = product((-1,) if self.z is None else (-1, 1), (-1, 1), (-1, 1))
        for number, (k, j, i) in enumerate(signs, 1):
            x, y, z = add(self.box.position, apply(self.box.axes, (i * a, j * b, k * c)))
            corner = Point(self.box.body, (x, y, z))
            yield BoxCorner(f"{self.name}_{number}", corner, self.plane, self.normal, whole=self)


@dataclass(frozen=True)
class BoxCorner(CornerOnFace):
    """Corner of a box on a plane."""

    whole: BoxOnPlane | None = None
    guides: ClassVar[bool] = False
