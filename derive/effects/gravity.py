"""Gravity, uniform over the mechanism."""

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
        """What the effect is, for people."""
        return "uniform gravity"

    @property
    def directions(self) -> Mapping[str, Direction]:
        """The one direction."""
        return {"direction": self.direction}

    @property
    def only(self) -> str:
        """One in a scene."""
        return "gravity of the scene"

    def slots(self, scene: Declared) -> Iterator[Slot]:
        """The acceleration and the direction."""
        yield from self.direction.slots(f"{self.where}, direction")
        yield Slot(f"{self.where}, acceleration", self.acceleration, "m/s^2")

    def element(self, kin: Kinematics) -> None:
        """None: the equations of motion weigh whole branches at once."""

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """The direction."""
        yield "gravity", "direction", Point(GROUND), {"axis": self.direction.unit}
