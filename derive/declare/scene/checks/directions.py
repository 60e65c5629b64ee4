"""Faults of directions: of the wrong type, or of zero length."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.declare.mechanism.bodies import Direction, Point
from hertzwerk.derive.expressions.parameter import is_number

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene.scene import Scene


def direction_faults(where: str, value: Any) -> Iterator[Fault]:
    """Yield faults of a value that is no direction."""
    if not isinstance(value, Direction):
        yield Fault(where, repr(value), "a Direction, such as X, -Y or Direction((1, 0, 1))")
    elif not (
        isinstance(value.components, tuple) and len(value.components) == 3 and all(map(is_number, value.components))
    ):
        yield Fault(where, repr(value.components), "three numbers or expressions of parameters of one unit")


def length_faults(scene: Scene) -> Iterator[Fault]:
    """Yield faults of directions of zero length."""
    for where, direction in directions(scene):
        if not direction.points:
            yield Fault(where, "a direction of length 0", "one that points somewhere",
                        "Its components are ratios: Direction((1, 0, 1)) lies between X and Z.")  # fmt: skip


def directions(scene: Scene) -> Iterator[tuple[str, Any]]:
    """Yield every declared direction, and its place."""
    for joint in scene.mechanism.joints:
        yield from ((f"joint {joint.name}, {name}", direction) for name, direction in joint.directions.items())
        for point in (joint.parent, joint.child):
            if isinstance(point, Point):
                yield from ((f"joint {joint.name}, turned point, axis", direction) for direction, _ in point.turns)
    for pair in scene.mechanism.pairs:
        yield from ((f"pair {pair.name}, {name}", direction) for name, direction in pair.directions.items())
    for effect in scene.effects:
        yield from ((f"{effect.where}, {name}", direction) for name, direction in effect.directions.items())
