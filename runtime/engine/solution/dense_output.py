"""Histories of a run between its steps, dense enough for extremes and integrals."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.history import History
    from hertzwerk.runtime.engine.solution.solution import EngineSolution

SAMPLES, HALVES = 4_000, (1, 16)  # wanted number in a run; half the least and most parts of a step
NORMS = {"norm8": 8, "norm32": 32}  # even orders of smooth stand-ins for the largest magnitude
PLACES, POINTS, ZOOMS = 16, 17, 4  # most places at which an extreme is searched, points around each, and refinements


class Extremes(NamedTuple):
    """Minimum and maximum of a history within a run, in SI, and their times [s]."""

    lowest: float
    lowest_t: float
    highest: float
    highest_t: float

    @property
    def magnitude(self) -> float:
        """Largest absolute value."""
        return max(abs(self.lowest), abs(self.highest))


class Samples:
    """Histories of a run over times `t` (n,) that divide every step into an even number of parts."""

    def __init__(self, run: EngineSolution, wanted: int = SAMPLES) -> None:
        self.run = run
        ends = np.unique(run.t)  # an event may leave two rows at its time
        self._steps = np.diff(ends)
        half = int(np.clip(wanted // max(2 * len(self._steps), 1), *HALVES))
        within = ends[:-1, None] + self._steps[:, None] * np.arange(2 * half) / (2 * half)
        self.t = np.append(np.minimum(within, ends[1:, None]).ravel(), ends[-1])
        self.history = run.at(self.t)
        self._begins = np.searchsorted(run.t, ends[:-1], side="right") - 1

    def __getitem__(self, name: str) -> np.ndarray:
        return self.history[name]

    def highest(self, of: Callable[[History], np.ndarray]) -> float:
        """Return the largest value of a quantity in the run, refined around the largest sample."""
        return self.top(of)[1]

    def top(self, of: Callable[[History], np.ndarray]) -> tuple[float, float]:
        """Return the time [s] of the largest value of a quantity in the run, and that value.

        Refined around every sample that is larger than those beside it and may, by how far it is, have the largest value near it: at
        most PLACES, those that may reach furthest.
        """
        values = of(self.history)
        beside = np.pad(values, 1, constant_values=-math.inf)
        # a parabola through three samples is an eighth of that above them at most
        bends = np.abs(np.pad(np.diff(values, 2), 1))
        tops = (values > beside[:-2]) & (values >= beside[2:]) & (values + bends >= np.max(values))
        tops[np.argmax(values)] = True
        places = np.flatnonzero(tops)
        places = np.sort(places[np.argsort(values[places] + bends[places])[-PLACES:]])
        best, largest, each = self.t[places], values[places], np.arange(len(places))
        low, high = self.t[np.maximum(places - 1, 0)], self.t[np.minimum(places + 1, len(self.t) - 1)]
        for _ in range(ZOOMS):
            times = np.linspace(low, high, POINTS, axis=1)
            values = of(self.run.at(times.ravel())).reshape(times.shape)
            i = np.argmax(values, axis=1)
            low, high = times[each, np.maximum(i - 1, 0)], times[each, np.minimum(i + 1, POINTS - 1)]
            best = np.where(values[each, i] > largest, times[each, i], best)
            largest = np.fmax(largest, values[each, i])
        top = int(np.argmax(largest))
        return float(best[top]), float(largest[top])

    def extremes(self, name: str) -> Extremes:
        """Return the extremes of a history."""
        at_low, low = self.top(lambda history: -history[name])
        at_high, high = self.top(lambda history: history[name])
        return Extremes(-low, at_low, high, at_high)

    def integral(self, of: Callable[[History], np.ndarray]) -> float:
        """Integrate a quantity over time [s], by Simpson's rule; it may jump where a step ends."""
        values = of(self.history)
        parts = (len(values) - 1) // len(self._steps)
        weights = np.tile([2.0, 4.0], parts // 2)
        weights[0] = 1
        by_step = values[:-1].reshape(-1, parts) @ weights + of(self._step_ends)
        return float(by_step @ self._steps) / (3 * parts)

    def mean(self, of: Callable[[History], np.ndarray]) -> float:
        """Average a quantity over time."""
        return self.integral(of) / float(self.t[-1] - self.t[0])

    def norm(self, name: str, order: int) -> float:
        """Return the mean over time of the order-th power of a magnitude, and of that the root."""
        size = float(np.abs(self[name]).max()) or 1.0
        return size * math.pow(self.mean(lambda history: (history[name] / size) ** order), 1 / order)

    @cached_property
    def _step_ends(self) -> History:
        """Histories where each step ends, before an event there."""
        if self.run.engine.history.steps:
            return self.run.engine.history.between(self._begins, self._steps)
        return self.run.at(self.run.t[self._begins + 1])


REDUCERS: dict[str, Callable[[Samples, str], float]] = {
    "max": lambda samples, name: samples.highest(lambda history: history[name]),
    "min": lambda samples, name: -samples.highest(lambda history: -history[name]),
    "mean": lambda samples, name: samples.mean(lambda history: history[name]),
    "rms": partial(Samples.norm, order=2),
    "peak_to_peak": lambda samples, name: REDUCERS["max"](samples, name) - REDUCERS["min"](samples, name),
    **{kind: partial(Samples.norm, order=order) for kind, order in NORMS.items()},
}
"""Numbers of a history in a run, by name."""
