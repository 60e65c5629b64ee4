"""Points of contact and directions of normal forces, from the landmarks of a pair."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from hertzwerk.runtime.pictures.draw.parts import Parts
from hertzwerk.runtime.pictures.draw.places import Array, Landmark

Contact = tuple[Array, Array]
"""Contact point (3,) [m], and the unit direction (3,) of the normal force on the first body."""


def contact_of(parts: Parts, kind: str, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return point and direction of a pair's force at an instant; None where landmarks do not tell."""
    find = CONTACTS.get(kind)
    return None if find is None else find(parts, marks, i)


def _inside(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of a pin in a bush, or a ball in a socket: where the eccentricity points to."""
    inner, outer = marks
    way = _unit(_across(parts, marks, i, parts.positions[id(inner)][i] - parts.positions[id(outer)][i]))
    return None if way is None else (parts.positions[id(inner)][i] + inner.size("radius") * way, -way)


def _outside(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of two spheres, or parallel cylinders, beside each other."""
    first, second = marks
    way = _unit(_across(parts, marks, i, parts.positions[id(first)][i] - parts.positions[id(second)][i]))
    return None if way is None else (parts.positions[id(second)][i] + second.size("radius") * way, way)


def _on_plane(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of a sphere, a cylinder or a corner on a plane."""
    first, second = marks
    normal = parts.places.direction(second, "normal")[i]
    radius = first.size("radius") if "radius" in first.beside else 0.0
    return parts.positions[id(first)][i] - radius * normal, normal


def _rim(parts: Parts, marks: Sequence[Landmark], i: int) -> Contact | None:
    """Return the contact of a disc's lowest point on a plane."""
    first, second = marks
    normal, axis = parts.places.direction(second, "normal")[i], parts.places.direction(first, "axis")[i]
    up = _unit(normal - (normal @ axis) * axis)
    return None if up is None else (parts.positions[id(first)][i] - first.size("radius") * up, normal)


def _across(parts: Parts, marks: Sequence[Landmark], i: int, vector: Array) -> Array:
    """Return the part of a vector across the axis of a pair, if it has one."""
    axis = parts.axis_of(marks, i)
    return vector if axis is None else vector - (vector @ axis) * axis


def _unit(vector: Array) -> Array | None:
    length = float(np.linalg.norm(vector))
    return vector / length if length > 0 else None


CONTACTS: dict[str, Callable[[Parts, Sequence[Landmark], int], Contact | None]] = {
    "pin_in_bush": _inside,
    "ball_in_socket": _inside,
    "sphere_on_sphere": _outside,
    "parallel_cylinders": _outside,
    "sphere_on_plane": _on_plane,
    "cylinder_on_plane": _on_plane,
    "corner_on_face": _on_plane,
    "rim_on_plane": _rim,
}
