"""Overlaps at the start that are deeper than the scene could cause: most likely a mistake.

The depth is judged by the speed at which the contacts, all at once, would throw their surfaces apart: from a depth d,
driven out with the acceleration a, v = sqrt(d a), the work of a force that falls linearly; a stiffer law than linear
gives less. Preload in balance, such as a ball between two walls or a static load, throws nothing. More than LIMIT
times the scene's speed is LIMIT^2 times its energy, which nothing in it can supply. An overlap that is also deeper
than its clearance, or than half its smaller radius, where it has them, is refused; a shallow one that is fast may be
meant.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Bound, Model

LIMIT = 5.0  # times the scene's speed: impacts in mechanisms are up to 2 or 3 times as fast as their drives
UNDAMPED = 1e12  # m/s, approach speed at which damping laws vanish: only stiffness acts
STEEPEST = 2.5  # power of the depth in the energy of Hertz's law


@dataclass(frozen=True)
class Intrusion:
    """Overlap at the start that separates faster than the scene moves, or where the law is undefined.

    depth, size [m]: that of the overlap, and a plausible one; speed, scene [m/s]: of separation, and of the scene.
    """

    pair: str
    depth: float
    size: float
    speed: float
    scene: float
    in_range: bool

    @property
    def too_deep(self) -> bool:
        """Return whether nothing in the scene could have caused it."""
        return not self.in_range or (self.speed > LIMIT * self.scene and self.depth > self.size)

    @property
    def allowed(self) -> float:
        """Return about the depth [m] that could be caused."""
        allowed: float = self.depth * (LIMIT * self.scene / self.speed) ** (2 / STEEPEST)
        return allowed


def intrusions(model: Model, bound: Bound, q: np.ndarray, u: np.ndarray) -> tuple[Intrusion, ...]:
    """Return the pairs that overlap deeply at coordinates q (nq,) and speeds u (nu,), t = 0."""
    if not model.k:
        return ()
    gap, rate = model.evaluate("gaps", 0.0, q, u, bound.c)
    inside = [j for j in range(model.k) if gap[j] < 0]
    if not inside:
        return ()
    (applied,) = model.evaluate("applied", 0.0, q, u, bound.c)
    pressed, found = applied.copy(), []
    for j in inside:
        z, m = np.zeros(model.nz), np.full(model.nm, UNDAMPED)
        forces, _, _, _, defined, *_ = model.evaluate(f"contact_{model.pairs[j]}", 0.0, q, u, z, m, bound.c)
        pressed += forces
        found.append((j, float(defined[0]) >= 0.5))
    own = _accelerations(model, bound, q, u, applied)
    out = _accelerations(model, bound, q, u, pressed) - own
    deep = []
    for j, in_range in found:
        depth, slope = _depth(model, bound, q, u, j, float(gap[j]))
        speed = math.sqrt(max(depth * float(out[j]) / slope, 0.0))
        scene = _scene_speed(model, bound, float(rate[j]), float(own[j]), depth)
        if not in_range or 0 < scene < speed:
            deep.append(Intrusion(model.pairs[j], depth, _size(model, bound, j), speed, scene, in_range))
    return tuple(deep)


def _accelerations(model: Model, bound: Bound, q: np.ndarray, u: np.ndarray, forces: np.ndarray) -> np.ndarray:
    """Return the second derivatives of all gaps under generalised forces [m/s^2]."""
    a, *_ = model.evaluate("accelerations", 0.0, q, u, forces, bound.c)
    return model.evaluate("gap_accelerations", 0.0, q, u, a, bound.c)[0]


def _depth(model: Model, bound: Bound, q: np.ndarray, u: np.ndarray, j: int, gap: float) -> tuple[float, float]:
    """Return the depth of a pair [m] and the derivative of its gap by depth.

    A journal's event function is quadratic in the eccentricity.
    """
    rows = model.journals.get(model.pairs[j])
    if rows is None:
        return -gap, 1.0
    (y,) = model.evaluate("outputs", 0.0, q, u, bound.c)
    eccentricity = math.hypot(*y[list(rows)])
    ratio = gap / eccentricity
    slope = math.hypot(ratio, 1) - ratio  # eccentricity over clearance, of a gap (c^2 - e^2)/(2 c) below 0
    return eccentricity - eccentricity / slope, slope


def _size(model: Model, bound: Bound, j: int) -> float:
    """Return a pair's plausible penetration [m] by its size: the clearance or half the smaller radius.

    0 where it has no such size.
    """
    places = model.function("landmarks")(bound.p) if hasattr(model.module, "LANDMARKS") else ()
    name = model.pairs[j]
    radii = [
        float(place[3])  # behind the point
        for row, place in zip(getattr(model.module, "LANDMARKS", ()), places, strict=True)
        if row[0] == name and row[4][:1] == ("radius",) and not row[1].startswith("solid_")  # of a body of this name
    ]
    if name in model.journals and len(radii) == 2:
        return abs(radii[0] - radii[1])
    return min(radii, default=0.0) / 2


def _scene_speed(model: Model, bound: Bound, rate: float, acceleration: float, depth: float) -> float:
    """Return the characteristic speed of a scene [m/s]; 0 where it has none.

    The largest of its scale, of the rate of the gap and of the speed that loads reach over the depth.
    """
    *_, scene = model.evaluate("scales", bound.p)
    length, speed = (float(x) if math.isfinite(x) else 0.0 for x in scene[:2])
    loads = math.sqrt(abs(acceleration) * (depth + max(length, 0.0))) if math.isfinite(acceleration) else 0.0
    return max(speed, abs(rate) if math.isfinite(rate) else 0.0, loads)
