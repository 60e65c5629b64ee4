"""Mechanism whose motion and equations are given as expressions, in place of joints.

Downstream it is a mechanism like any other: its bodies move with the coordinates and speeds, by partial velocities as
all bodies do.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Frame, Point
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.exchange.sympy_models.motion_by_expressions import Description, MotionByExpressions
from hertzwerk.derive.expressions.parameter import Slot

MASSES = ("kg", "g", "mg", "t")


@dataclass(frozen=True, init=False)
class Carried(Joint):
    """Relation of a body to the ground where its motion is given; it is no joint of the mechanism."""

    moved_by: tuple[Freedom, ...]

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Every freedom of the mechanism."""
        return self.moved_by


@dataclass(frozen=True)
class MechanismByExpressions(Mechanism):
    """Mechanism of bodies whose motion is given by a description; it has no joints."""

    moved: tuple[Body, ...] = ()
    description: Description = field(kw_only=True)

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The bodies, in their order."""
        return self.moved

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """The freedoms of the description."""
        return self.description.coordinates

    @property
    def dependent_freedoms(self) -> tuple[Freedom, ...]:
        """Coordinates with their rates, and speeds, where these are no freedoms."""
        return self.description.measured

    @property
    def uncounted(self) -> tuple[str, ...]:
        """Keys of speeds without a coordinate."""
        return self.description.uncounted

    @property
    def contradictions(self) -> tuple[tuple[str, str, str], ...]:
        """Velocities of the description that its positions and axes contradict, and what follows from these."""
        return self.description.contradictions

    @property
    def plane(self) -> int | None:
        """Coordinate axis normal to the motion of all bodies, by structure; None in space."""
        places = [self.description.places[body.name] for body in self.moved]
        return next((k for k in (2, 1, 0) if all(place.stays_across(k) for place in places)), None)

    @property
    def total_mass(self) -> Any:
        """Mass by which energies are scaled [kg]: of the bodies, else all masses among the parameters."""
        masses = [slot.value for slot in self.description.quantities if slot.unit in MASSES]
        return super().total_mass or sp.Add(*masses)

    def joint_of(self, body: Frame) -> Joint | None:
        """Relation of a body to the ground; None for the ground."""
        if body not in self.moved:
            return None
        place = self.description.places[body.name]
        still = all(
            not any(map(bool, shares.values())) and rest == 0
            for shares, rest in (*place.velocity, *place.angular_velocity)
        )
        return Carried(body.name, Point(GROUND), Point(body), moved_by=() if still else self.freedoms)

    def slots(self) -> Iterator[Slot]:
        """Yield every quantity, in declared order."""
        yield from self.description.quantities
        yield from super().slots()

    def motion_by_expressions(self, kinematics: Any) -> MotionByExpressions:
        """Its motion on the tape of a kinematics."""
        return MotionByExpressions(kinematics, self.description)
