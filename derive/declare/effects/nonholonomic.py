"""Rolling without slip, and knife edges: conditions on speeds, held by forces that do no work.

They are constraints of the equations of motion, beside those of joints that close loops (`derive.motion.constraints`).
Their rates have no integral, so that they restrict how a mechanism moves and not where it can go. Neimark, Fufaev,
Dynamics of Nonholonomic Systems (1972), chapter 1.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.declare.effects.effect import NOWHERE, Declared, Effect, Mark, Moving, PairEffect, SpeedConstraint
from hertzwerk.derive.declare.mechanism.bodies import GROUND, Body, Direction, Frame, Ground, Point
from hertzwerk.derive.expressions.algebra.vectors import apply
from hertzwerk.derive.expressions.parameter import NOT_NEGATIVE, Scalar, Slot


@dataclass(frozen=True)
class RollingWithoutSlip(PairEffect):
    """Rolling of one surface of a pair on the other: they stay in contact, and do not slip.

    Of a sphere or the rim of a wheel on a plane, a disc on a curved track, a circle on another. It takes the place of
    the pair's `Contact`, where impacts, compliance and slip do not matter. Surfaces that the joints keep in contact
    are held by these; others by `<name>.normal_force` [N], which is negative where they would part. What keeps them
    from slipping is `<name>.friction_force` [N] in plane motion, else `_1` and `_2` along two tangents, on the pair's
    first body.

    coefficient  coefficient of friction [1]: a run that needs more warns of it, as one warns whose surfaces would part
    """

    name: str
    pair: str
    coefficient: Scalar | None = None
    measures: ClassVar[Mapping[str, Slot]] = {"coefficient": Slot.of("1", NOT_NEGATIVE)}
    kind: ClassVar[str] = "rolling_without_slip"
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """Description for people."""
        return f"rolling without slip at {self.pair}"

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield a fault of a pair with a contact of its own, beside those of any effect at a pair."""
        yield from super().faults(scene)
        beside = [
            effect.name
            for effect in scene.effects
            if isinstance(effect, PairEffect) and effect.pair == self.pair and effect != self
        ]
        if beside:
            yield Fault(self.where, f"{' and '.join(beside)} at the same pair", "a pair that is kept in contact and rolls, or one with laws",
                        f"Leave it out, or give {self.pair} a Contact with Friction alone, and RollingResistance.")  # fmt: skip

    def speed_constraints(self, kin: Moving) -> Iterator[SpeedConstraint]:
        """Yield that the surfaces stay in contact, and that they do not slip along each tangent."""
        touch = kin.touch(self.pair)
        bodies, point = (touch.first.body, touch.second.body), touch.contact_point
        yield SpeedConstraint("gap", touch.normal, point, bodies, -touch.penetration)
        tangents = touch.tangents
        for i, tangent in enumerate(tangents, 1):
            yield SpeedConstraint(
                f"sliding_velocity_{i}" if len(tangents) > 1 else "sliding_velocity", tangent, point, bodies
            )


@dataclass(frozen=True)
class KnifeEdge(Effect):
    """Knife edge, skate or thin wheel: a point of a body that does not move `across` on another body.

    The direction is in the point's axes. What holds it is a history, `<name>.side_force` [N], along that direction.
    """

    name: str
    point: Point
    across: Direction
    on: Frame = GROUND
    kind: ClassVar[str] = "knife_edge"
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """Description for people."""
        return f"knife edge of {self.point.body.name}"

    @property
    def points(self) -> tuple[Point, ...]:
        """The point."""
        return (self.point,)

    @property
    def frames(self) -> tuple[Frame, ...]:
        """The body with the edge, and that against which it moves."""
        return self.point.body, self.on

    @property
    def directions(self) -> Mapping[str, Direction]:
        """The direction across the edge."""
        return {"across": self.across}

    def type_faults(self) -> Iterator[Fault]:
        """Yield a fault of something that is no body to move on."""
        yield from super().type_faults()
        if not isinstance(self.on, Body | Ground):
            yield Fault(f"{self.where}, on", shown(self.on), "a Body or GROUND")

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield a fault of an edge on its own body."""
        yield from super().faults(scene)
        if self.point.body == self.on:
            yield Fault(self.where, f"an edge of {self.on.name} on {self.on.name}", "two different bodies")

    def speed_constraints(self, kin: Moving) -> Iterator[SpeedConstraint]:
        """Yield that the point does not move across."""
        position, _, _ = kin.point(self.point, f"{self.name}_edge")
        across = kin.tape.vector(kin.direction(self.point, self.across), f"{self.name}_across")
        yield SpeedConstraint("side_velocity", across, position, (self.point.body, self.on))

    def landmarks(self, scene: Declared) -> Iterator[Mark]:
        """Yield the point and the direction across."""
        yield self.kind, "point", self.point, {"across": apply(self.point.axes, self.across.unit)}
