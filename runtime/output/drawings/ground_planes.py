"""Planes of the ground in an oblique view, cut at each other as the walls of a box."""

from __future__ import annotations

import numpy as np

from hertzwerk.runtime.output.drawings.places import GROUND, Places
from hertzwerk.runtime.system.arrays import Array

SAME = 1e-9  # planes whose normals and offsets differ by less are one
HalfSpace = tuple[Array, float]  # normal and offset [m]: the points x with normal @ x >= offset


def ground_planes(places: Places) -> dict[int, tuple[Array, Array]]:
    """Return normals and outlines (n, 3) of planes of the ground that differ, by the landmark's id.

    Planes reach as far as bodies do at any instant. Empty where the ground has fewer planes.
    """
    planes: dict[int, HalfSpace] = {}
    points = []
    for mark in places.landmarks:
        where, reach = places.point(mark), mark.size("radius") if "radius" in mark.beside else 0.0
        points += [where - reach, where + reach]
        if mark.place == "plane" and mark.body == GROUND:
            normal = places.direction(mark, "normal")[0]
            offset = float(normal @ where[0])
            if not any(np.allclose([*normal, offset], [*n, o], SAME, SAME) for n, o in planes.values()):
                planes[id(mark)] = normal, offset
    if len(planes) < 2:
        return {}
    everything = np.concatenate(points)
    low, high = np.min(everything, axis=0), np.max(everything, axis=0)
    box = [(way * axis, float(way * end @ axis)) for way, end in ((1, low), (-1, high)) for axis in np.eye(3)]
    outlines = {}
    for key, (normal, offset) in planes.items():
        first = np.cross(normal, np.eye(3)[int(np.argmin(np.abs(normal)))])
        second = np.cross(normal, first)
        size = 2 * float(np.linalg.norm(high - low)) / float(np.linalg.norm(first))
        middle = (low + high) / 2
        middle = middle + (offset - middle @ normal) * normal
        outline = middle + size * np.array([first + second, first - second, -first - second, second - first])
        for half in [*box, *(plane for other, plane in planes.items() if other != key)]:
            outline = _cut(outline, half)
        if len(outline):
            outlines[key] = normal, outline
    return outlines


def _cut(outline: Array, half: HalfSpace) -> Array:
    """Return the part of a convex outline (n, 3) that lies in a half-space (Sutherland and Hodgman 1974)."""
    height = outline @ half[0] - half[1]
    height[np.abs(height) <= SAME * np.max(np.abs(height), initial=1.0)] = 0.0
    corners = []
    for a, b, above, next_above in zip(outline, np.roll(outline, -1, 0), height, np.roll(height, -1), strict=True):
        if above >= 0:
            corners.append(a)
        if above * next_above < 0:
            corners.append(a + (b - a) * above / (above - next_above))
    return np.array(corners).reshape(-1, 3)
