"""What averages need of all accepted steps, summed up over equal intervals of time as a run goes: momentum passed on, largest forces, the ledger."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from hertzwerk.runtime.integrate.layout import CONTACT

if TYPE_CHECKING:
    from collections.abc import Mapping

    from hertzwerk.runtime.history import History
    from hertzwerk.runtime.model import Model


@dataclass(frozen=True)
class Sums:
    """Of n whole intervals of so many seconds from the start on, k pairs and nz states of memory.

    impulse   normal force, integrated over each interval (n, k) [N s]
    largest   largest normal force in each interval (n, k) [N]
    memory    states of memory where intervals begin and end (n + 1, nz)
    """

    interval: float
    impulse: np.ndarray
    largest: np.ndarray
    memory: np.ndarray

    @property
    def count(self) -> int:
        """Number of intervals."""
        return len(self.impulse)

    def joined(self, many: int) -> Sums:
        """Of intervals so many times as long, from the start on."""
        n = self.count // many
        parts = (x[: n * many].reshape(n, many, -1) for x in (self.impulse, self.largest))
        impulse, largest = next(parts).sum(axis=1), next(parts).max(axis=1)
        return Sums(self.interval * many, impulse, largest, self.memory[: n * many + 1 : many])

    def about(self) -> dict[str, Any]:
        """Plain numbers, to be saved."""
        return {name: x.tolist() if isinstance(x, np.ndarray) else x for name, x in asdict(self).items()}

    @classmethod
    def saved(cls, about: Mapping[str, Any], model: Model) -> Self:
        """Those of a run that was saved."""
        impulse, largest = (np.array(about[name]).reshape(-1, model.k) for name in ("impulse", "largest"))
        return cls(about["interval"], impulse, largest, np.array(about["memory"]).reshape(-1, model.nz))


class Summing:
    """Sums up over intervals [s] from the start on, up to a time [s]; an `Observer`.

    A force is taken within a step for the cubic that its values and rates at both ends give: no function is evaluated but where an interval or
    a contact ends.
    """

    def __init__(self, model: Model, interval: float, until: float) -> None:
        count = int(until / interval * (1 + 1e-12))
        self._model, self._interval, self._marks = model, interval, interval * np.arange(count + 1)
        self._impulse, self._largest = np.zeros((count + 1, model.k)), np.zeros((count + 1, model.k))
        self._memory: list[np.ndarray] = []
        self._known = 0  # marks
        self._last: History

    def take(self, block: History, fresh: int) -> None:
        """The next accepted steps; see `Observer`."""
        t, first = block.t, max(fresh - 1, 0)
        self._last = block.of(block.rows[-1:].copy())
        stop = int(np.searchsorted(self._marks, t[-1]))  # at the last row an event may change the state yet
        rows, marked = block.rows[first:], np.zeros(len(t) - first, dtype=bool)
        if stop > self._known:
            marks = self._marks[self._known : stop]
            places = np.searchsorted(t[first:], marks, side="right")
            found = block.at(marks).rows
            self._memory.append(self._memory_of(block.of(found)))
            rows, marked = np.insert(rows, places, found, axis=0), np.insert(marked, places, True)
        if self._model.k and len(rows) > 1:
            interval = self._known - 1 + np.cumsum(marked)[:-1]
            with np.errstate(
                invalid="ignore", over="ignore"
            ):  # a run that came to no good end may hold what is no number
                impulse, largest = _forces(block.of(rows))
                np.add.at(self._impulse, interval, impulse)
                np.maximum.at(self._largest, interval, largest)
        self._known = max(stop, self._known)

    def _memory_of(self, history: History) -> np.ndarray:
        y = history.part("y")
        return y[:, y.shape[1] - self._model.nz :].copy()

    @property
    def sums(self) -> Sums:
        """Of the intervals that the run went through."""
        memory, count = self._memory, self._known - 1
        arrived = self._known < len(self._marks) and self._last.t[0] >= self._marks[self._known] * (1 - 1e-12)
        if arrived:
            memory, count = [*memory, self._memory_of(self._last)], count + 1
        if count < 1:
            k, nz = self._model.k, self._model.nz
            return Sums(self._interval, np.zeros((0, k)), np.zeros((0, k)), np.zeros((1, nz)))
        return Sums(self._interval, self._impulse[:count], self._largest[:count], np.concatenate(memory))


def _forces(history: History) -> tuple[np.ndarray, np.ndarray]:
    """Impulse [N s] and largest force [N] of every pair from each row to the next, (rows - 1, k) each."""
    rows, h = history.rows, np.diff(history.t)[:, None]
    mode = history.part("mode")
    touching = mode[:-1] == CONTACT
    ends = rows[1:]
    cut = np.flatnonzero(np.any(touching & (mode[:-1] != mode[1:]), axis=1) & (h[:, 0] > 0))  # the step ended otherwise
    if len(cut):
        ends = ends.copy()
        ends[cut] = history.later(rows[cut], h[cut, 0])
    start, end = history.of(rows[:-1]), history.of(ends)
    f0, f1 = (np.where(touching, side.part("force"), 0) for side in (start, end))
    g0, g1 = (np.where(touching, side.part("force_rate"), 0) for side in (start, end))
    # where a gap is not below zero the rate is not known: there the parabola without it
    known0, known1 = (side.part("gap") < 0 for side in (start, end))
    impulse = np.select(
        [known0 & known1, known1, known0],
        [
            h / 2 * (f0 + f1) + h**2 / 12 * (g0 - g1),
            h / 3 * (f0 + 2 * f1) - h**2 / 6 * g1,
            h / 3 * (2 * f0 + f1) + h**2 / 6 * g0,
        ],
        h / 2 * (f0 + f1),
    )
    return impulse, np.maximum(np.maximum(f0, f1), _between(f0, f1, h * g0, h * g1))


def _between(f0: np.ndarray, f1: np.ndarray, g0: np.ndarray, g1: np.ndarray) -> np.ndarray:
    """Largest value of the cubic on 0..1 with these values and slopes at its ends where it rises at 0 and falls at 1; else f0."""
    peaks = (g0 > 0) & (g1 < 0)
    square, cube = 3 * (f1 - f0) - 2 * g0 - g1, 2 * (f0 - f1) + g0 + g1
    root = np.sqrt(np.maximum(square**2 - 3 * cube * g0, 0))
    x = np.divide(g0, root - square, out=np.zeros_like(f0), where=peaks)
    return np.where(peaks, f0 + x * (g0 + x * (square + x * cube)), f0)
