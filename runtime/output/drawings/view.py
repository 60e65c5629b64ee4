"""View of a mechanism: the direction of projection."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from hertzwerk.runtime.output.drawings.places import SOLIDS, Landmark, Places
from hertzwerk.runtime.system.arrays import Array

FLAT = 1e-9  # relative: largest deviation of a plane mechanism
AXES = np.eye(3)
SPATIAL = ("spherical", "universal", "cylindrical")  # kinds of joints
STEEP = (0.45, -0.78, 0.42)  # oblique view of spatial mechanisms: right, back, up


@dataclass(frozen=True)
class View:
    """Parallel projection: unit vectors to the right, up and towards the viewer.

    names: of the axes of a plane view, else None.
    """

    right: Array
    up: Array
    towards: Array
    names: tuple[str, str] | None

    def __call__(self, points: Array) -> Array:
        """Project points (..., 3) to the paper (..., 2)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def depth(self, points: Array) -> Array:
        """Return the distance towards the viewer."""
        return np.asarray(points @ self.towards)


def view_of(places: Places) -> View:
    """Return the view across the plane of motion, else an oblique view with gravity pointing down."""
    for k in (2, 1, 0):
        if _is_plane(places, k):
            i, j = {2: (0, 1), 1: (0, 2), 0: (1, 2)}[k]
            return View(AXES[i], AXES[j], np.cross(AXES[i], AXES[j]), ("xyz"[i], "xyz"[j]))
    up = next((-places.direction(mark, "axis")[0] for mark in places.landmarks if mark.kind == "gravity"), AXES[2])
    first = AXES[0] if abs(up[0]) < 0.9 else AXES[1]
    first = first - (first @ up) * up
    first /= np.linalg.norm(first)
    towards = np.stack([first, np.cross(up, first), up]).T @ np.array(STEEP)
    towards /= np.linalg.norm(towards)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    return View(right, np.cross(towards, right), towards, None)


def _is_plane(places: Places, k: int) -> bool:
    """Return whether all bodies move across axis k and turn about it alone, and all directions agree.

    A start alone does not show that of balls.
    """
    axis, balls = AXES[k], places.model.quaternions or any(mark.kind in SPATIAL for mark in places.landmarks)
    if len(places.t) == 1 and balls:
        return False
    moved = np.max(np.ptp(places.origins[..., k], axis=0)) > FLAT * max(float(np.ptp(places.origins)), 1e-12)
    if moved or np.max(np.abs(places.rotations @ axis - axis)) > FLAT:
        return False
    return all(
        abs(abs(places.direction(mark, name)[0] @ axis) - _along(mark, name) * np.linalg.norm(value))
        <= FLAT * np.linalg.norm(value)
        for mark in places.landmarks
        for name, value in mark.beside.items()
        if len(value) == 3
        and name != "size"
        and mark.kind not in ("gravity", "sphere_on_box", "box_on_box")
        and not mark.kind.startswith(SOLIDS)
    )


def _along(mark: Landmark, name: str) -> float:
    """Return 1 where in a plane mechanism a direction must be across the plane, such as a turning axis."""
    slides = mark.kind == "prismatic" or mark.kind.startswith("slide_")
    return float(name == "moment" or (name == "axis" and not slides) or (name == "normal" and mark.kind == "planar"))
