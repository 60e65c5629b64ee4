"""Effects without forces that follow a motion: pieces of a track passed, whole turns of an angle.

A scene adds them where they are needed.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.effects.effect import (
    NOWHERE,
    Declared,
    Effect,
    Element,
    Event,
    JointEffect,
    Kinematics,
    State,
)
from hertzwerk.derive.declare.effects.state_expression import COORDINATE, states_in
from hertzwerk.derive.declare.mechanism.mechanism import Mechanism
from hertzwerk.derive.expressions.algebra.functions import Where


@dataclass(frozen=True)
class Junctions(Effect):
    """Junctions of a track along a chain of `pieces`, at which its curvature jumps.

    A scene has one for each such track. A step ends at each of them: across it, no method has the order that its error is
    judged by. The state `<name>.piece` is the number of pieces passed, as of the track's parameter.
    """

    name: str
    track: str
    pieces: int
    closed: bool
    kind: ClassVar[str] = "junctions"
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """Description for people."""
        return f"junctions of {self.track}, where steps end"

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the piece; the first step finds it."""
        yield State("piece", "1", size=sp.S.One)

    def element(self, kin: Kinematics) -> Element:
        """Event at both ends of the piece."""
        piece, at = kin.state(f"{self.name}.piece"), kin.along_track(self.track)
        n, past = self.pieces, at - piece
        if self.closed:
            half = sp.Rational(1, 2)
            past += Where(past > n - half, -n, Where(past < half + 1 - n, n, 0))
        past = kin.tape.let(past, f"{self.name}_past")
        passed = sp.Add(*(Where(at >= k, 1, 0) for k in range(1, n)))
        return Element(events=(Event("junction", past * (1 - past), sp.S.One, {"piece": passed}),))


@dataclass(frozen=True)
class CountedAngle(JointEffect):
    """Count of the whole turns of an angle whose joint closes a loop in space.

    Such an angle follows from the bodies up to whole turns. The state `<name>.near` integrates the angle's rate. Of the angles
    that the bodies allow, the one nearest to it counts, so that no error of the state enters. An event sets the state
    anew where it is a quarter turn off, as it may be at the start. The start is near 0, or `Start(near={joint: angle})`.

    A scene counts by itself the angles that its effects need. Declared, it makes the angle a history in
    absolute coordinates too, where every joint closes a loop.
    """

    name: str
    joint: str
    kind: ClassVar[str] = "counted_angle"
    enters: ClassVar[str] = NOWHERE

    @property
    def text(self) -> str:
        """Description for people."""
        return f"whole turns of {self.joint}"

    @property
    def only(self) -> str:
        """Description of the one of a joint."""
        return f"count of {self.joint}"

    def faults(self, scene: Declared) -> Iterator[Fault]:
        """Yield the fault of what is no angle, or counts by itself, beside those of any effect on a joint."""
        yield from super().faults(scene)
        freedom = scene.scalars.get(self.joint)
        if freedom is not None and (freedom.kind != "turn" or scene.mechanism.plane is not None):
            actual = (
                f"{self.joint}, a {'travel' if freedom.kind == 'slide' else 'plane angle'}, which counts whole turns"
            )
            yield Fault(self.where, actual, "an angle in space", "Leave it out: the coordinate is a history as it is.")

    def counts(self, scene: Declared) -> bool:
        """Whether the bodies alone do not determine the whole turns, in the coordinates of the scene."""
        return self.joint in scene.mechanism.wrapped

    def states(self, scene: Declared) -> Iterator[State]:
        """Yield the angle integrated; its errors steer no step."""
        if self.counts(scene):
            yield State("near", "rad", scene.start.coordinates(scene.scalars[self.joint])[0], size=sp.S.One)

    def element(self, kin: Kinematics) -> Element | None:
        """Rate of the state, and the event that sets it."""
        if not self.counts(kin.scene):
            return None
        angle, rate = kin.coordinate(self.joint), kin.speed(self.joint)
        margin = sp.cos(angle - kin.state(f"{self.name}.near"))
        return Element(rates={"near": rate}, events=(Event("set", margin, sp.S.One, {"near": angle}),))


class AddedCount(CountedAngle):
    """Count that a scene has added by itself; a variation of the scene adds those that it needs."""


def uncounted_angles(mechanism: Mechanism, effects: Iterable[Effect], scene: Declared) -> Iterator[AddedCount]:
    """Yield a count for each angle that effects of a sound scene, or its start, need and none counts."""
    needed = list(scene.start.near)
    for effect in effects:
        slots = (slot for slot in effect.slots(scene))
        needed += [symbol.joint for slot in slots for symbol in states_in(slot.value) if symbol.quantity == COORDINATE]
        needed += effect.joints if effect.reads == COORDINATE else ()
    counted = [effect.joint for effect in effects if isinstance(effect, CountedAngle)]
    for key in mechanism.wrapped:
        if key not in counted and (key in needed or scene.scalars[key].coordinates[0].name in needed):
            yield AddedCount(f"{key.replace('.', '_')}_count", key)
