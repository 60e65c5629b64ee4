"""Contact pairs: which surfaces of two bodies may touch, and what everything else asks of a kind. Declarations only, no equations.

A pair pushes its first place along a unit vector out of the second's solid. Its equations stand beside the others of their kind, in `contact.touch`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields
from typing import Any, ClassVar

from hertzwerk.derive.algebra.vectors import Vector, apply
from hertzwerk.derive.faults import Fault
from hertzwerk.derive.mechanism.bodies import Direction, Point, Slot

Components = tuple[Any, Any, Any]


@dataclass(frozen=True)
class Pair:
    """Two surfaces that may touch.

    kind          text for tables and laws that are made for one kind
    form          how the surfaces touch, at a "point", along a "line" or over a "surface": laws are made for one of them
    first_radius  from the first place to the contact point [m]
    journal       whether it stands for a joint, which a start closes
    holds_film    whether a lubrication may act on it
    labels        names of the two places in the equations
    """

    name: str
    kind: ClassVar[str] = "custom"
    form: ClassVar[str] = "point"
    first_radius: ClassVar[Any] = 0
    journal: ClassVar[bool] = False
    holds_film: ClassVar[bool] = False
    labels: ClassVar[tuple[str, str]] = ("first", "second")

    @property
    def places(self) -> tuple[Point, Point]:
        """The point that feels +F along the contact normal, then its partner: the pair's two fields that are points."""
        first, second = (getattr(self, name) for name in self._typed("Point", Point))
        return first, second

    def _typed(self, *types: Any) -> list[str]:
        """Names of its fields of a type, which is text where annotations are postponed."""
        return [field.name for field in fields(self) if field.type in types]

    @property
    def geometry(self) -> dict[str, Any]:
        """Lengths that laws may ask for, such as the radius of relative curvature `R_eff` and the smaller radius `R_min` [m]."""
        return {}

    @property
    def directions(self) -> dict[str, Direction]:
        """The directions it is declared with, by field."""
        optional = "Direction | None"
        given = {name: getattr(self, name) for name in self._typed("Direction", Direction, optional)}
        return {name: v for name, v in given.items() if v is not None or name not in self._typed(optional)}

    @property
    def triples(self) -> dict[str, Components]:
        """Its fields of three components, by what they are."""
        return {name.replace("_", " "): getattr(self, name) for name in self._typed("Components", Components)}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Directions and sizes that a picture shows at each place, along the axes of its body."""
        return {}, {}

    def slots(self) -> Iterator[Slot]:
        """The quantities of the pair; those of its directions and places come by themselves."""
        for name, direction in self.directions.items():
            yield from direction.slots(f"pair {self.name}, {name}")
        for point in self.places:
            yield from point.slots()

    def landmarks(self) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """Name of each place, the point, and what a picture shows there."""
        return zip(self._typed("Point", Point), self.places, self.surfaces, strict=True)

    def faults(self) -> Iterator[Fault]:
        """Say what is wrong with it alone."""
        yield from ()


def in_body(point: Point, direction: Direction) -> Vector:
    """A direction given in a point's axes, in those of its body."""
    return apply(point.axes, direction.unit)
