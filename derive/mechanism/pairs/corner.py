"""Pair of a corner and a face."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from hertzwerk.derive.faults import Fault
from hertzwerk.derive.mechanism.bodies import Direction, Point, Slot
from hertzwerk.derive.mechanism.pairs.pair import Pair, in_body
from hertzwerk.derive.mechanism.parameter import POSITIVE, Scalar, default_value


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

    def slots(self) -> Iterator[Slot]:
        """Yield the quantities of the pair."""
        if self.length is not None:
            yield Slot(f"pair {self.name}, length", self.length, "m", POSITIVE)
        yield from super().slots()

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Normal, direction and length of the face, for landmarks."""
        beside: dict[str, Any] = {"normal": in_body(self.face, self.normal)}
        if self.along is not None:
            beside |= {"along": in_body(self.face, self.along), "length": self.length}
        return {}, beside

    def faults(self) -> Iterator[Fault]:
        """A face that ends needs a direction in it, and a length."""
        if (self.along is None) != (self.length is None):
            found = (
                "a length without a direction along the face" if self.along is None else "a direction without a length"
            )
            yield Fault(f"pair {self.name}", found, "both, for a face that ends, or neither")
        if self.along is not None:
            normal, along_face = ([default_value(part) for part in axis.unit] for axis in (self.normal, self.along))
            cosine = sum(a * b for a, b in zip(normal, along_face, strict=True))
            if abs(cosine) > 1e-9:
                yield Fault(
                    f"pair {self.name}, along",
                    f"a direction at a cosine of {cosine:.3g} to the normal",
                    "one square to it",
                )
