"""Contact pairs: surfaces of two bodies that may touch. Declarations only, no equations.

A pair pushes its first place along a unit vector out of the second's solid. A kind is one class with its geometry of
touching, in `contact.pairs`; the defaults are declared here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from typing import Any, ClassVar

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.declare.mechanism.bodies import Direction, Point, measured
from hertzwerk.derive.expressions.algebra.vectors import Vector, apply
from hertzwerk.derive.expressions.parameter import POSITIVE, Slot, is_number

Components = tuple[Any, Any, Any]
LENGTH = Slot.of("m", POSITIVE)


@dataclass(frozen=True)
class Pair:
    """Two surfaces that may touch.

    kind          text for tables and laws that are made for one kind
    form          how the surfaces touch, at a "point", along a "line" or over a "surface": laws are made for one of them
    measures      fields that hold a quantity -> its unit and range, `LENGTH` or `Slot.of(unit, limit)`
    first_radius  distance from the first place to the contact point [m]
    journal       whether it replaces a joint, which the start closes: its outputs then hold its eccentricity e, and its
                  gap is (c^2 - e.e)/(2 c), c its clearance
    guides        whether it is one of several that together replace a joint, which has no eccentricity to close
    holds_film    whether a lubrication may act on it
    wears         how it may wear: around a "contour", at a "flat" spot of the first surface, or "" for not at all
    labels        names of the two places in the equations
    """

    name: str
    kind: ClassVar[str] = "custom"
    form: ClassVar[str] = "point"
    measures: ClassVar[Mapping[str, Slot]] = {}
    first_radius: ClassVar[Any] = 0
    journal: ClassVar[bool] = False
    guides: ClassVar[bool] = False
    holds_film: ClassVar[bool] = False
    wears: ClassVar[str] = ""
    labels: ClassVar[tuple[str, str]] = ("first", "second")

    @property
    def part_of(self) -> str:
        """Name of the pair, `whole`, that it is a part of, at which effects are declared; "" of one by itself."""
        whole = getattr(self, "whole", None)
        return str(getattr(whole, "name", whole) or "")

    @property
    def parts(self) -> tuple[Pair, ...]:
        """Pairs that it stands for in a mechanism, by default itself."""
        return (self,)

    @property
    def placed(self) -> bool:
        """Whether its places are points and its quantities numbers; else the scene has faults."""
        try:
            points = all(isinstance(place, Point) for place in self.places)
            return points and all(is_number(slot.value) for slot in self.slots())
        except (AttributeError, TypeError, ValueError):
            return False

    @property
    def places(self) -> tuple[Point, Point]:
        """The two places; contact pushes the first along the normal.

        They are the pair's two fields that are points.
        """
        first, second = (getattr(self, name) for name in self._typed("Point", Point))
        return first, second

    def _typed(self, *types: Any) -> list[str]:
        """Names of its fields of given types; these are text where annotations are postponed."""
        return [field.name for field in fields(self) if field.type in types]

    @property
    def geometry(self) -> dict[str, Any]:
        """Lengths for laws by name, such as radius of relative curvature `R_eff`, smaller radius `R_min` [m]."""
        return {}

    @property
    def directions(self) -> dict[str, Direction]:
        """Declared directions, by field."""
        optional = "Direction | None"
        values = {name: getattr(self, name) for name in self._typed("Direction", Direction, optional)}
        return {name: v for name, v in values.items() if v is not None or name not in self._typed(optional)}

    @property
    def triples(self) -> dict[str, Components]:
        """Fields of three components, by name."""
        return {name.replace("_", " "): getattr(self, name) for name in self._typed("Components", Components)}

    @property
    def surfaces(self) -> tuple[dict[str, Any], dict[str, Any]]:
        """Directions and sizes at each place for landmarks, along the axes of its body."""
        return {}, {}

    @property
    def curves(self) -> tuple[Any, ...]:
        """Planar curves among its fields, each a `SolidCurve`."""
        return ()

    def slots(self) -> Iterator[Slot]:
        """Yield its quantities: of its whole, then its `measures`, directions and places."""
        whole = getattr(self, "whole", None)
        if isinstance(whole, Pair):
            yield from whole.slots()
        yield from measured(self, f"pair {self.name}", self.measures)
        for name, direction in self.directions.items():
            yield from direction.slots(f"pair {self.name}, {name}")
        for point in self.places:
            yield from point.slots()

    def landmarks(self) -> Iterator[tuple[str, Point, dict[str, Any]]]:
        """Yield name, point, directions and sizes of each place."""
        return zip(self._typed("Point", Point), self.places, self.surfaces, strict=True)

    def faults(self) -> Iterator[Fault]:
        """Yield faults of the pair by itself."""
        yield from ()

    def touch(self, kinematics: Any) -> Any:
        """Contact geometry on the kinematics' tape, a `Touch`; raises InputError for a kind that has none."""
        actual = f"{type(self).__name__}, a kind of pair without equations"
        remedy = f"{type(self).__name__}.touch, which returns a subclass of Touch with `gap` and `normal`."
        raise InputError(
            f"pair {self.name}", [Fault(f"pair {self.name}", actual, "one whose geometry is known", remedy)]
        )


def in_body(point: Point, direction: Direction) -> Vector:
    """A direction given in a point's axes, in the axes of its body."""
    return apply(point.axes, direction.unit)
