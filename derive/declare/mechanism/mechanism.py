"""Mechanism: bodies, joints, contact pairs. Declarations only, no equations.

Every record is frozen and checks itself; the scene collects all faults and raises them at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import Any

import sympy as sp

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.declare.mechanism.bodies import Body, Frame
from hertzwerk.derive.declare.mechanism.joints.joint import Freedom, Joint
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.expressions.algebra.vectors import along
from hertzwerk.derive.expressions.parameter import Slot


@dataclass(frozen=True)
class Mechanism:
    """Bodies connected by joints, and pairs of surfaces that may touch.

    The first joint to reach a body carries it: these joints are the tree, whose coordinates are the mechanism's. Any
    later joint to a body closes a loop, and is a constraint. A pair of several parts stands here as its parts.
    """

    name: str
    joints: tuple[Joint, ...]
    pairs: tuple[Pair, ...] = ()

    def __post_init__(self) -> None:
        for listed in ("joints", "pairs"):
            if isinstance(getattr(self, listed), list):
                object.__setattr__(self, listed, tuple(getattr(self, listed)))
        if isinstance(self.pairs, tuple):
            parts = (pair.parts if isinstance(pair, Pair) else (pair,) for pair in self.pairs)
            object.__setattr__(self, "pairs", tuple(chain.from_iterable(parts)))

    @cached_property
    def parts(self) -> dict[str, tuple[str, ...]]:
        """Names of the pairs that are parts of one, by its name."""
        members = grouped(
            (pair.part_of, pair.name)
            for pair in (self.pairs if isinstance(self.pairs, tuple) else ())
            if isinstance(pair, Pair) and pair.part_of
        )
        return {name: tuple(parts) for name, parts in members.items()}

    @cached_property
    def pair_named(self) -> dict[str, Pair]:
        """Pairs by their names."""
        return {pair.name: pair for pair in self.pairs}

    @property
    def bodies(self) -> tuple[Body, ...]:
        """Children of the tree's joints, in their order."""
        return tuple(joint.child.body for joint in self.tree if isinstance(joint.child.body, Body))

    @cached_property
    def tree(self) -> tuple[Joint, ...]:
        """Joints that carry a body, from the ground outwards."""
        carriers: dict[Frame, Joint] = {}
        for joint in (joint for joint in self.joints if joint.carries):
            carriers.setdefault(joint.child.body, joint)
        return tuple(carriers.values())

    @cached_property
    def closures(self) -> tuple[Joint, ...]:
        """Joints that close a loop."""
        tree = {id(joint) for joint in self.tree}
        return tuple(joint for joint in self.joints if id(joint) not in tree)

    @property
    def total_mass(self) -> Any:
        """Mass of all bodies [kg], by which energies are scaled."""
        return sp.Add(*(sp.sympify(body.mass) for body in self.bodies))

    def joint_of(self, body: Frame) -> Joint | None:
        """Joint that carries `body`; None for the ground."""
        return self._carriers.get(body)

    def turned_by(self, body: Frame) -> Joint | None:
        """Nearest joint on the way to the ground that turns `body`; None where nothing does."""
        joint = self.joint_of(body)
        while joint is not None and not joint.turning:
            joint = self.joint_of(joint.parent.body)
        return joint

    @cached_property
    def _carriers(self) -> dict[Frame, Joint]:
        return {joint.child.body: joint for joint in self.tree}

    @property
    def freedoms(self) -> tuple[Freedom, ...]:
        """Freedoms of the tree's joints, in order."""
        return tuple(freedom for joint in self.tree for freedom in joint.freedoms)

    @cached_property
    def dependent_freedoms(self) -> tuple[Freedom, ...]:
        """Freedoms of closing joints that follow from where the bodies are, in order."""
        ruled = (joint for joint in self.closures if not joint.unruled())
        return tuple(freedom for joint in ruled for freedom in joint.freedoms if joint.measures(freedom))

    @property
    def uncounted(self) -> tuple[str, ...]:
        """Keys of speeds without a coordinate: none of joints."""
        return ()

    @property
    def contradictions(self) -> tuple[tuple[str, str, str], ...]:
        """Velocities that positions contradict, as set and as they follow: none of joints."""
        return ()

    @cached_property
    def wrapped(self) -> tuple[str, ...]:
        """Keys of angles of closing joints in space, which follow from the bodies up to whole turns."""
        joints = (joint for joint in self.closures if self.plane is None and not joint.unruled())
        turns = (
            freedom
            for joint in joints
            for freedom in joint.freedoms
            if freedom.kind == "turn" and joint.measures(freedom)
        )
        return tuple(freedom.key for freedom in turns)

    def motion_by_expressions(self, kinematics: Any) -> Any:
        """Motion that is given by expressions, on the tape of a kinematics; None where it is that of joints."""
        return None

    @cached_property
    def plane(self) -> int | None:
        """Coordinate axis normal to the plane of motion of all bodies; None in space.

        By structure: all turns are about it, all slides perpendicular to it.
        """
        return next((k for k in (2, 1, 0) if all(_stays_across(joint, k) for joint in self.joints)), None)

    def slots(self) -> Iterator[Slot]:
        """Yield every quantity of the mechanism, in declared order."""
        for body in self.bodies:
            yield from body.slots()
        parts: tuple[Joint | Pair, ...] = (*self.joints, *self.pairs)
        for part in parts:
            yield from part.slots()


def _stays_across(joint: Joint, k: int) -> bool:
    """Whether a joint turns only about a coordinate axis and slides only perpendicular to it.

    The axes of its points are included.
    """
    turned = (axis for point in (joint.parent, joint.child) for axis, _ in point.turns)
    turns = (freedom.axis for freedom in joint.freedoms if freedom.kind != "slide")
    slides = (freedom.axis for freedom in joint.freedoms if freedom.kind == "slide")
    return all(axis is not None and along(axis.unit) == k for axis in (*turned, *turns)) and all(
        axis is not None and axis.unit[k] == 0 for axis in slides
    )
