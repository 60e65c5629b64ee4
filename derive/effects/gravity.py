"""Uniform gravity."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

from hertzwerk.derive.effects.effect import Declared, Effect, Kinematics, Mark
from hertzwerk.derive.mechanism.bodies import GROUND, Direction, Point, Slot
from hertzwerk.derive.mechanism.parameter import Scalar


@dataclass(frozen=True)
class Gravity(Effect):
    """Uniform gravity [m/s^2] along `direction` of the ground frame."""

    name: str
    acceleration: Scalar
    direction: Direction
    kind: ClassVar[str] = "gravity"

    @property
    def text(self) -> str:
        """Description for people."""
        return "uniform gravity"

    @property
    def directions(self) -> Mapping[str, Direction]:
        """The direction of gravity."""
        return {"direction": self.direction}

    @property
    def only(self) -> str:
        """Description of the one in a scene."""
        return "gravity of the scene"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """Yield the acceleration and the direction."""
        yield from self.direction.slots(f"{self.where}, direction")
        yield Slot(f"{self.where}, acceleration", self.acceleration, "m/s^2")

    def element(self, kin: Kinematics) -> None:
        """No element: the equations of motion include gravity of whole subtrees."""

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the direction."""
        yield "gravity", "direction", Point(GROUND), {"axis": self.direction.unit}
