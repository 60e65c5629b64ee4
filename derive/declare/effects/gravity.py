"""Uniform gravity."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from hertzwerk.derive.declare.effects.effect import Declared, Effect, Element, Kinematics, Mark
from hertzwerk.derive.declare.effects.state_expression import TIME, Varying, shown, states_in
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Direction, Point
from hertzwerk.derive.expressions.algebra.vectors import ZERO, add, dot, scale
from hertzwerk.derive.expressions.parameter import Scalar, Slot


@dataclass(frozen=True)
class Gravity(Effect):
    """Uniform gravity [m/s^2] along `direction` of the ground frame.

    An expression of time is that of a frame that is shaken, of which there may be several; its power is input.
    """

    name: str
    acceleration: Scalar
    direction: Direction
    kind: ClassVar[str] = "gravity"
    measures: ClassVar[Mapping[str, Slot]] = {"acceleration": Varying.of("m/s^2", on=(TIME,))}

    @property
    def text(self) -> str:
        """Description for people."""
        return f"uniform gravity {shown(self.acceleration)}, by time" if self.varies else "uniform gravity"

    @property
    def varies(self) -> bool:
        """Whether it depends on time."""
        return bool(states_in(self.acceleration))

    @property
    def directions(self) -> Mapping[str, Direction]:
        """The direction of gravity."""
        return {"direction": self.direction}

    @property
    def only(self) -> str:
        """Description of the one in a scene that does not vary."""
        return "" if self.varies else "gravity of the scene"

    def element(self, kin: Kinematics) -> Element | None:
        """Power where it varies: the equations of motion include gravity of whole subtrees."""
        if not self.varies:
            return None
        bodies = [body for body in kin.scene.mechanism.bodies if body.mass != 0]
        speeds = (kin.point(Point(body, body.centre), f"{body.name}_centre")[1] for body in bodies)
        momentum = add(ZERO, *(scale(sp.sympify(b.mass), v) for b, v in zip(bodies, speeds, strict=True)))
        pull = kin.tape.let(kin.expression(self.acceleration), f"{self.name}_acceleration")
        return Element(input=pull * dot(momentum, self.direction.unit))

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the direction."""
        yield "gravity", "direction", Point(GROUND), {"axis": self.direction.unit}
