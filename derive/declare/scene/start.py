"""Start of a scene: coordinates and speeds at t = 0."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.mechanism.joints.joint import Freedom
from hertzwerk.derive.expressions.parameter import Scalar, Slot


@dataclass(frozen=True)
class Start:
    """Coordinates and speeds at t = 0 by name, `<joint>.<name>`.

    For a joint with one coordinate, the joint's name suffices.

    Given values are kept. Others are found where loops are to be closed and journals to be centred: positions and
    speeds of the ideal mechanism. Remaining ones are zero, and an orientation is that of the parent. Flexible rods are
    straight where nothing else is given. `near` gives starting values of coordinates for the assembly, which select one of several configurations.

    With `seated`, journals do not start in the middle of their bushes or sockets, but rest in them, held by their
    contact alone: each is displaced along the force that its clearance would transmit as a closed joint at that
    instant, so deep that its elastic normal force equals that force, and moves with its bush. A journal without such
    a force is centred. Friction of the contact is neglected. The given values must allow this.
    """

    position: Mapping[str, Scalar] = field(default_factory=dict)
    speed: Mapping[str, Scalar] = field(default_factory=dict)
    near: Mapping[str, Scalar] = field(default_factory=dict)
    seated: bool = False

    def coordinates(self, freedom: Freedom) -> list[Any]:
        """Values of a freedom's coordinates; a quaternion's are normalised."""
        stated = [_value_of({**self.near, **self.position}, port.name, freedom) for port in freedom.coordinates]
        if freedom.kind != "ball":
            return [value or 0 for value in stated]
        if all(value is None for value in stated):
            return [1, 0, 0, 0]
        values = [sp.sympify(value or 0) for value in stated]
        norm = sp.sqrt(sp.Add(*(value**2 for value in values)))
        return [value / norm for value in values]

    def speeds(self, freedom: Freedom) -> list[Any]:
        """Values of a freedom's speeds."""
        return [_value_of(self.speed, port.name, freedom) or 0 for port in freedom.speeds]

    def stated(self, freedom: Freedom) -> list[str]:
        """Names of a freedom's coordinates and speeds with a given value."""
        sides = (self.position, freedom.coordinates), (self.speed, freedom.speeds)
        straight = freedom.kind == "bend"
        return [
            port.name
            for values, ports in sides
            for port in ports
            if _value_of(values, port.name, freedom) is not None or (straight and port.name not in self.near)
        ]

    def slots(self, freedoms: Iterable[Freedom]) -> Iterator[Slot]:
        """Yield the given values."""
        for freedom in freedoms:
            for values, ports, quantity in (
                (self.position, freedom.coordinates, "position"),
                (self.near, freedom.coordinates, "position near"),
                (self.speed, freedom.speeds, "speed"),
            ):
                for port in ports:
                    value = _value_of(values, port.name, freedom)
                    if value is not None:
                        named = freedom.key if freedom.known_by_key else port.name
                        yield Slot(f"start, {quantity} of {named}", value, port.unit)


def _value_of(values: Mapping[str, Scalar], name: str, freedom: Freedom) -> Any:
    return values.get(name, values.get(freedom.key) if freedom.known_by_key else None)
