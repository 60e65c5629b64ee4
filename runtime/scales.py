"""What accuracy is measured by: sizes of coordinates, speeds and energies, of a scene's parameters or, where they give none, of the run itself.

A scene derives its scales from its parameters: the ball's speed from gravity and drop height. Where a run departs from that so far that a
scale is zero or undefined (no gravity, a start of one's own), a rough run finds the sizes that occur.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from hertzwerk.runtime.history import History
    from hertzwerk.runtime.model import Bound, Model

GUESS = {
    "m": 1e-4,
    "rad": 1e-3,
    "1": 1e-3,
    "m/s": 1.0,
    "rad/s": 10.0,
    "J": 1.0,
    "N": 1.0,
}  # of the first rough run, in SI
ROUNDS = 2


@dataclass(frozen=True)
class Scales:
    """state (ny,): of q, u, z; scene (4,): length [m], speed [m/s], force [N], energy [J]."""

    state: np.ndarray
    scene: np.ndarray

    @property
    def sound(self) -> bool:
        """Whether every scale is a positive number."""
        return bool(np.all(_sound(self.state)) and np.all(_sound(self.scene)))


def of_parameters(model: Model, bound: Bound) -> Scales:
    """The scales that the scene states."""
    *parts, scene = (np.array(x).ravel() for x in model.function("scales")(bound.p))
    return Scales(np.concatenate(parts), scene)


def of_run(model: Model, stated: Scales, rough: Callable[[Scales], History]) -> Scales:
    """The stated scales where they are sound, elsewhere the sizes that occur in a rough run, in units alike."""
    units = list(model.units.values())
    scales = _completed(stated, units, GUESS)
    for _ in range(ROUNDS):
        scales = _completed(stated, units, GUESS | _sizes(model, units, rough(scales)))
    return scales


def _sizes(model: Model, units: list[str], history: History) -> dict[str, float]:
    """Largest size of each unit in a run: of lengths the penetration, or the way where nothing is touched."""
    y = history.part("y")
    ways = np.max(np.abs(y - y[0]), axis=0)
    peaks = np.max(np.abs(y), axis=0)
    found: dict[str, float] = {}
    for i, unit in enumerate(units):
        found[unit] = max(found.get(unit, 0.0), float(ways[i] if i < model.nq else peaks[i]))
    if model.k:
        depth = float(np.max(-history.part("gap"), where=history.part("mode") != 0, initial=0.0))
        found["m"] = depth if depth > 0 else found.get("m", 0.0)
        found["N"] = float(np.max(history.part("force")))
    found["J"] = max(found.get("J", 0.0), found.get("N", 0.0) * found.get("m", 0.0))
    return {unit: size for unit, size in found.items() if _sound(np.array(size))}


def _completed(stated: Scales, units: list[str], sizes: dict[str, float]) -> Scales:
    state = np.array([sizes.get(unit, 1.0) for unit in units])
    scene = np.array([sizes[unit] for unit in ("m", "m/s", "N", "J")])
    return Scales(
        np.where(_sound(stated.state), stated.state, state), np.where(_sound(stated.scene), stated.scene, scene)
    )


def _sound(values: np.ndarray) -> np.ndarray:
    sound: np.ndarray = np.isfinite(values) & (values > 0)
    return sound
