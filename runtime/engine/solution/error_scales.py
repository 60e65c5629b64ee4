"""Scales that accuracy is relative to: sizes of coordinates, speeds and energies of a scene or run.

A scene derives its scales from its parameters: the ball's speed from gravity and drop height. Where a run departs
from that so far that a scale is zero or undefined (no gravity, a start of one's own), a rough run finds the sizes
that occur.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
    from hertzwerk.runtime.engine.solution.history import History

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
    """Scales: state (ny,) of q, u, z; scene (4,): length [m], speed [m/s], force [N], energy [J]."""

    state: np.ndarray
    scene: np.ndarray

    @property
    def pace(self) -> float:
        """Speed over length [1/s], by which a shift in time counts."""
        return float(self.scene[1]) / float(self.scene[0])

    @cached_property
    def sound(self) -> bool:
        """Return whether every scale is a positive number."""
        return bool(_sound(self.state).all() and _sound(self.scene).all())


def error(
    model: EngineModel,
    scales: Scales,
    y: np.ndarray,
    reference: np.ndarray,
    dy: np.ndarray | None = None,
    reference_dy: np.ndarray | None = None,
) -> np.ndarray:
    """Return the error of a state: the largest scaled difference of q and u, up to a shift in time.

    y, reference (..., ny) as recorded, or their first nq + nu entries; dy, reference_dy (..., ny) their rates, without
    which no shift is allowed for; returns (...,). Memory (z) and timers do not count. See `distance`, `event_differences`.
    """
    moving = _moving(model, model.nq + model.nu)
    size = scales.state[moving]
    apart = (y[..., moving] - reference[..., moving]) / size
    if dy is None or reference_dy is None:
        return _or_jumped(model, scales, y, reference, _largest(apart))
    rates = (part[..., moving] / size for part in (dy, reference_dy))
    return _or_jumped(model, scales, y, reference, np.minimum(*(distance(apart, f, scales.pace)[0] for f in rates)))


def event_differences(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Return the differences (..., m) of states that change at events alone.

    Each is that to the nearest value of another run, which may have it at another time: an event that one run has a moment
    before the other is a shift in time, which the states that move show.
    """
    nearest = np.empty(one.shape)
    for i in range(one.shape[-1]):
        nearest[..., i] = np.abs(one[..., i, None] - np.unique(other[..., i])).min(axis=-1)
    return nearest


def distance(apart: np.ndarray, rates: np.ndarray, pace: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the distances (...,) of states from a motion, and the shifts in time [s] that lead to them.

    With the scaled differences e = `apart` and the scaled rates f of the motion, both (..., n), it is

        min over tau of max(pace |tau|, |e_1 - f_1 tau|, ..., |e_n - f_n tau|):

    a state that the motion has a moment later is off by that moment, counted by `pace` [1/s], the scene's speed over its
    length, and not by how far the motion gets in it, which is much in an impact. Each term is an interval of tau about
    e_i/f_i, of radius d/|f_i|; all meet where any two do, so that d is the largest of |e_i f_j - e_j f_i| / (|f_i| + |f_j|),
    with e_0 = 0, f_0 = pace.
    """
    sizes = np.abs(rates)
    distances = np.max(np.abs(apart) * pace / (sizes + pace), axis=-1, initial=0.0)
    for i in range(apart.shape[-1] - 1):
        (e, others), (f, rates_there), (size, sizes_there) = (
            (part[..., i : i + 1], part[..., i + 1 :]) for part in (apart, rates, sizes)
        )
        both = np.maximum(size + sizes_there, np.finfo(float).tiny)
        distances = np.maximum(distances, np.max(np.abs(e * rates_there - others * f) / both, axis=-1, initial=0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        centres, radii = (
            np.where(sizes > 0, apart / rates, 0.0),
            np.where(sizes > 0, distances[..., None] / sizes, np.inf),
        )
    first = np.max(centres - radii, axis=-1, initial=-np.inf)
    last = np.min(centres + radii, axis=-1, initial=np.inf)
    reach = distances / pace
    return distances, (np.maximum(first, -reach) + np.minimum(last, reach)) / 2


def departure(model: EngineModel, scales: Scales, y: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """Return the largest scaled difference of the coordinates alone."""
    moving = _moving(model, model.nq)
    apart = (y[..., moving] - reference[..., moving]) / scales.state[moving]
    return _or_jumped(model, scales, y, reference, _largest(apart))


def rounding(model: EngineModel, scales: Scales, y: np.ndarray) -> float:
    """Return the error that one rounding of the largest of the states y (n, ny) makes."""
    n = model.nq + model.nu
    return float(np.finfo(float).eps * np.max(np.abs(y[:, :n]) / scales.state[:n], initial=0.0))


def _moving(model: EngineModel, n: int) -> list[int]:
    """Return which of the first n states move, other than timers."""
    return [row for row in range(n) if row not in model.held and row not in model.timers]


def _or_jumped(
    model: EngineModel, scales: Scales, y: np.ndarray, reference: np.ndarray, moved: np.ndarray
) -> np.ndarray:
    """Return the errors (...,) of what moves, or of what events alone change where those are larger."""
    held = list(model.held)
    jumped = event_differences(y[..., held], reference[..., held]) / scales.state[held]
    largest: np.ndarray = np.maximum(moved, _largest(jumped))
    return largest


def _largest(apart: np.ndarray) -> np.ndarray:
    """Return the largest scaled difference of the last axis."""
    largest: np.ndarray = np.max(np.abs(apart), axis=-1, initial=0.0)
    return largest


def of_parameters(model: EngineModel, bound: BoundParameters) -> Scales:
    """Return the scales that the scene states."""
    *parts, scene = model.evaluate("scales", bound.p)
    return Scales(np.concatenate(parts), scene)


def of_run(model: EngineModel, stated: Scales, rough: Callable[[Scales, Sizes], object]) -> Scales:
    """Return the stated scales where they are sound, elsewhere the sizes that occur in a rough run.

    rough    makes a run with some scales and shows it to a `Sizes`
    """
    units = list(model.units.values())
    scales = _completed(stated, units, GUESS)
    for _ in range(ROUNDS):
        sizes = Sizes(units)
        rough(scales, sizes)
        scales = _completed(stated, units, GUESS | sizes.largest())
    return scales


class Sizes:
    """Observer of the largest displacements, speeds, memory values, penetrations and forces of a run."""

    def __init__(self, units: list[str]) -> None:
        self._units = units
        self._from: np.ndarray | None = None
        self._largest = np.zeros(len(units))
        self._depth = self._force = 0.0

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `findings.Observer`."""
        y = block.part("y")
        if self._from is None:
            self._from = y[0].copy()
            self._from[block.model.nq :] = 0
        self._largest = np.maximum(self._largest, np.max(np.abs(y - self._from), axis=0))
        touching = block.part("mode") != 0
        self._depth = float(np.max(-block.part("gap"), where=touching, initial=self._depth))
        self._force = float(np.max(block.part("force"), initial=self._force))

    def largest(self) -> dict[str, float]:
        """Return the largest size of each unit; for lengths the penetration, or the way without contact."""
        sizes: dict[str, float] = {}
        for unit, size in zip(self._units, self._largest, strict=True):
            sizes[unit] = max(sizes.get(unit, 0.0), float(size))
        if self._depth > 0:
            sizes["m"] = self._depth
        sizes["N"] = max(sizes.get("N", 0.0), self._force)
        sizes["J"] = max(sizes.get("J", 0.0), sizes["N"] * sizes.get("m", 0.0))
        return {unit: size for unit, size in sizes.items() if _sound(np.array(size))}


def _completed(stated: Scales, units: list[str], sizes: dict[str, float]) -> Scales:
    state = np.array([sizes.get(unit, 1.0) for unit in units])
    scene = np.array([sizes[unit] for unit in ("m", "m/s", "N", "J")])
    return Scales(
        np.where(_sound(stated.state), stated.state, state), np.where(_sound(stated.scene), stated.scene, scene)
    )


def _sound(values: np.ndarray) -> np.ndarray:
    sound: np.ndarray = np.isfinite(values) & (values > 0)
    return sound
