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
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.runtime.engine.start.pair_values import pair_values, values_by_kind

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel

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


def intrusions(model: EngineModel, bound: BoundParameters, q: np.ndarray, u: np.ndarray) -> tuple[Intrusion, ...]:
    """Return the pairs that overlap deeply at coordinates q (nq,) and speeds u (nu,), t = 0."""
    if not model.k:
        return ()
    state = {"t": 0.0, "q": q, "u": u, "c": bound.c}
    gap, rate = pair_values(model, "gaps", range(model.k), state)
    inside = np.flatnonzero(gap < 0).tolist()
    if not inside:
        return ()
    (applied,) = model.evaluate("applied", 0.0, q, u, bound.c)
    pressed = applied.copy()
    valid: dict[int, bool] = {}
    latched = state | {"z": np.zeros(model.nz), "m": np.full(model.nm, UNDAMPED)}
    for pairs, rows, (forces, _, _, _, defined, *_) in values_by_kind(model, "contact", inside, latched):
        np.add.at(pressed, rows, forces)
        valid |= dict(zip(pairs, defined[:, 0] >= 0.5, strict=True))
    own = _accelerations(model, inside, state, applied)
    out = _accelerations(model, inside, state, pressed) - own
    sizes = _sizes(model, bound)
    deep = []
    for j, driven, loaded in zip(inside, out.tolist(), own.tolist(), strict=True):
        depth, slope = _depth(model, bound, q, u, j, float(gap[j]))
        speed = math.sqrt(max(depth * driven / slope, 0.0))
        scene = _scene_speed(model, bound, float(rate[j]), loaded, depth)
        if not valid[j] or 0 < scene < speed:
            pair = model.pairs[j]
            deep.append(Intrusion(pair, depth, sizes.get(pair, 0.0), speed, scene, bool(valid[j])))
    return tuple(deep)


def _accelerations(model: EngineModel, pairs: list[int], state: dict[str, Any], forces: np.ndarray) -> np.ndarray:
    """Return the second derivatives of gaps under generalised forces [m/s^2]."""
    a, *_ = model.evaluate("accelerations", *(state[x] for x in "tqu"), forces, state["c"])
    return pair_values(model, "gap_accelerations", pairs, state | {"a": a})[0]


def _depth(
    model: EngineModel, bound: BoundParameters, q: np.ndarray, u: np.ndarray, j: int, gap: float
) -> tuple[float, float]:
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


def _sizes(model: EngineModel, bound: BoundParameters) -> dict[str, float]:
    """Return the plausible penetrations [m] of pairs that have a size.

    That is the clearance, or half the smaller radius.
    """
    return {
        name: abs(of[0] - of[1]) if name in model.journals and len(of) == 2 else min(of) / 2
        for name, of in model.radii(bound.p).items()
    }


def _scene_speed(model: EngineModel, bound: BoundParameters, rate: float, acceleration: float, depth: float) -> float:
    """Return the characteristic speed of a scene [m/s]; 0 where it has none.

    The largest of its scale, of the rate of the gap and of the speed that loads reach over the depth.
    """
    *_, scene = model.evaluate("scales", bound.p)
    length, speed = (float(x) if math.isfinite(x) else 0.0 for x in scene[:2])
    loads = math.sqrt(abs(acceleration) * (depth + max(length, 0.0))) if math.isfinite(acceleration) else 0.0
    return max(speed, abs(rate) if math.isfinite(rate) else 0.0, loads)
