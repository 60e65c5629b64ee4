"""Accepted steps of a run, passed to observers block by block to bound the memory."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.engine.integration.events.cubics import crest_of_cubic
from hertzwerk.runtime.engine.integration.loop.reduced_rows import Rows, joined
from hertzwerk.runtime.system.heap import available
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.history import History
    from hertzwerk.runtime.engine.solution.step_observers import Observer

BLOCK = 2**23  # bytes: enough rows that costs per block are negligible
ENDS = 0  # bytes: the first and the last state alone
MANY, AGAIN = 2**28, 1.1  # bytes kept from which the memory left is looked at, and how much more until the next look
OVERLAP = 2  # known rows repeated at a block's start: events show between rows


class Recorder:
    """Gathers rows into blocks of about `block` bytes and passes them to observers; None: one block.

    view    makes a History of rows
    error    what an observer raised, the first of them; it is raised again once all have seen the block
    """

    def __init__(
        self, view: Callable[[Rows], History], observers: Sequence[Observer], block: int | None = BLOCK
    ) -> None:
        self._view, self._observers, self._block = view, list(observers), block
        self.error: Exception | None = None
        self._parts: list[Rows] = []
        self._known = self._new = self._bytes = 0
        self._look: float = MANY

    def keep(self, rows: Rows) -> None:
        """Take the next accepted rows (n, ns); raises MemoryError before they fill the memory."""
        self._parts.append(rows)
        self._new += len(rows)
        self._bytes += rows.nbytes
        if self._block is not None and self._bytes >= self._block:
            self.flush()
        elif self._block is None and self._bytes > self._look:
            self._look = AGAIN * self._bytes
            if available() < self._bytes:  # to join them takes as much again
                raise MemoryError(f"{self._bytes / 1e9:.1f} GB of steps are kept, more than are left")

    def flush(self) -> None:
        """Pass the gathered rows to the observers; call once more at the end."""
        if not self._new:
            return
        known, rows = self._known, self._gathered()
        self._parts = [rows[-OVERLAP:].copy()]
        self._known, self._new, self._bytes = len(self._parts[0]), 0, 0
        block = self._view(rows)
        for observer in tuple(self._observers):
            try:
                observer.take(block, known)
            except Exception as error:  # the others lose no row for it, and it sees no more, as it would not see all
                self._observers.remove(observer)
                self.error = self.error or error
        if self.error is not None:
            raise self.error

    def _gathered(self) -> Rows:
        """Join the gathered rows in one array; if memory does not suffice, as many of the first as fit."""
        while True:
            try:
                return joined(self._parts)
            except MemoryError as error:
                if len(self._parts) < 2:
                    raise
                self.error = error.with_traceback(None)  # whose frames would hold all parts
                del self._parts[len(self._parts) // 2 :]


class Steps:
    """Observer that keeps every step."""

    history: History

    def take(self, block: History, fresh: int) -> None:
        """Take all steps of a run, in one block; see `Observer`."""
        self.history = block

    @property
    def ends(self) -> History:
        """Histories whose first and last row are those of the run."""
        return self.history


class Grid:
    """Observer that keeps the states at given increasing times [s], by dense output.

    At a time of an event the state just after it; without times the ends of the run alone.

    compared    keep only what a comparison of runs reads, see `History.between`
    """

    def __init__(self, times: np.ndarray, *, compared: bool = False) -> None:
        self._times, self._count, self._compared = times, 0, compared
        self._rows: list[np.ndarray] = []
        self._first: np.ndarray
        self._last: History  # of one row

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        times = self.passed(block, fresh)
        if len(times):
            self.keep(np.asarray(block.at(times, compared=self._compared).rows))

    def passed(self, block: History, fresh: int) -> np.ndarray:
        """Return the next times [s] that the steps have passed, whose states are to be kept."""
        if not fresh:
            self._first = block.rows[:1].copy()
        self._last = block.of(block.rows[-1:].copy())
        stop = int(np.searchsorted(self._times, block.t[-1]))  # the last row has to wait: an event may change it yet
        times, self._count = self._times[self._count : stop], stop
        return times

    def keep(self, rows: np.ndarray) -> None:
        """Keep the states at the times just passed."""
        self._rows.append(rows)

    @cached_property
    def history(self) -> History:
        """Histories at the times that the run reached, once it has ended."""
        arrived = self._last.t[0] in self._times[self._count : self._count + 1]
        return self._last.of(np.concatenate([*self._rows, self._last.rows[: int(arrived)]]))

    @property
    def ends(self) -> History:
        """Histories whose first and last row are those of the run."""
        return self._last.of(np.concatenate([self._first, self._last.rows]))


class Sampled:
    """Observer that keeps the states at which a run is compared with others.

    That is at its start and end, at `count` times between, and within its own steps, which lie close where much
    happens: towards the end of all, or of every second, fourth, ... where they are many, of those through which a rate
    is zero there, at peaks of forces, and throughout those in which the rates change most, as where friction turns round.
    Where a rate is zero no shift in time accounts for an error: of a fast vibration it is seen there alone. Nor does one
    for a contact that alone is late, whose error is largest at its peak. Where effects have events, one at the end of a
    step may change a state at once, and another run may have that event slightly earlier or later: no sample lies so close
    to an end, and the shortest steps have none.

    later    find them when `history` is read, of a run whose steps are kept: one that is stopped needs none
    """

    EVEN, BENT = 100, 60  # the former are between so many and twice as many
    LATE = 0.99  # of a step: its error grows towards its end
    # where rates change at once it goes up and down; of 224 runs none was more than 5 % larger at .15, .3, .6 and .9 as well
    THROUGHOUT = 0.45, 0.75, LATE
    SHORT = 100  # tolerances, as a shift in time by length over speed: shorter steps may be those between such events

    def __init__(self, begin: float, end: float, count: int, *, later: bool) -> None:
        self._later = later
        self._waiting: list[tuple[History, int]] = []
        # no event of a period meets those between
        between = begin + (np.arange(count) + (3 - 5**0.5) / 2) / count * (end - begin)
        self._grid = Grid(np.concatenate([[begin], between, [end]]))
        self._steps = self._turns = self._peaks = 0
        self._within = (*(_Within(self.EVEN, 1) for _ in range(3)), _Within(self.BENT, len(self.THROUGHOUT)))

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        self._waiting.append((block, fresh))
        if not self._later:
            self._sample()

    def _sample(self) -> None:
        while self._waiting:
            self._of(*self._waiting.pop(0))

    def _of(self, block: History, fresh: int) -> None:
        times = self._grid.passed(block, fresh)
        before = np.searchsorted(block.t, times, side="right") - 1
        first = max(fresh - 1, 0)
        controls, layout = block.controls, block.engine.layouts.controls
        (tolerance,), (length, speed) = controls[layout["tolerance"]], controls[layout["scales"]][:2]
        short = self.SHORT * tolerance * length / speed if block.model.ne else 0.0
        begins = first + np.flatnonzero(np.diff(block.t[first:]) > short)
        turned, zeros = _turns(block, begins, speed / length)
        peaked, peaks = _peaks(block, begins)
        even, through_zero, at_peak, bent = self._within
        chosen = [
            even.choose(begins, _evenly(self._steps, len(begins)), np.array([[self.LATE]])),
            through_zero.choose(begins[turned], _evenly(self._turns, len(zeros)), zeros),
            at_peak.choose(begins[peaked], _evenly(self._peaks, len(peaks)), peaks),
            bent.choose(begins, _bends(block, begins), np.array([self.THROUGHOUT])),
        ]
        index = np.concatenate([before, *(np.repeat(steps, parts.shape[1]) for steps, parts in chosen)])
        own = np.concatenate([parts.ravel() for _, parts in chosen])
        own *= np.diff(block.t)[index[len(times) :]]
        h = np.append(times - block.t[before], own)
        _, first_of, place = np.unique(block.t[index] + h, return_index=True, return_inverse=True)
        rows = block.between(index[first_of], h[first_of], compared=True).rows[place]
        bounds = np.cumsum([len(times), *(parts.size for _, parts in chosen)])[:-1]
        at_times, *within = np.split(rows, bounds)
        at_times[:, block.columns("t").start] = times  # not t + (time - t), which may differ in the last digit
        self._grid.keep(at_times)
        for steps, states in zip(self._within, within, strict=True):
            steps.keep(states)
        self._steps += len(begins)
        self._turns += len(zeros)
        self._peaks += len(peaks)

    @cached_property
    def history(self) -> History:
        """Histories at the times that the run reached, once it has ended."""
        self._sample()
        grid = self._grid.history
        own = (states.reshape(-1, states.shape[-1]) for steps in self._within for states in steps.rows)
        rows = np.concatenate([*own, grid.rows])
        return grid.of(rows[np.unique(rows[:, grid.columns("t").start], return_index=True)[1]])


class _Within:
    """States at parts of those steps of a run whose scores are largest."""

    def __init__(self, most: int, parts: int) -> None:
        self._most, self._parts = most, parts
        self._scores, self._stay = np.zeros(0), np.zeros(0, dtype=bool)  # of steps known before, whether they stay
        self.rows: list[np.ndarray] = []  # (steps, parts, ns), in one piece

    def choose(self, begins: np.ndarray, scores: np.ndarray, parts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return those of some steps whose scores are among the largest, and their parts.

        begins, scores    rows that the steps begin at, and their scores (n,)
        parts    of the steps at which the states are kept, (n or 1, parts)
        """
        known, scores = len(self._scores), np.append(self._scores, scores)
        stay = (scores >= np.sort(scores)[-self._most :][:1]) & (scores > 0)
        self._scores, (self._stay, fresh) = scores[stay], np.split(stay, [known])
        return begins[fresh], np.broadcast_to(parts, (len(fresh), parts.shape[1]))[fresh]

    def keep(self, rows: np.ndarray) -> None:
        """Keep the states (steps * parts, ns) of the steps just chosen, and of those before that stay."""
        before = (piece[self._stay] for piece in self.rows)
        self.rows = [np.concatenate([*before, rows.reshape(-1, self._parts, rows.shape[1])])]


def _evenly(before: int, count: int) -> np.ndarray:
    """Return scores of further things, the largest those of every second, fourth, ... of all."""
    numbers = before + 1 + np.arange(count)
    return numbers & -numbers  # the power of 2 that a number has as a factor


def _turns(block: History, begins: np.ndarray, pace: float) -> tuple[np.ndarray, np.ndarray]:
    """Return through which steps a rate is zero, and at which parts of those (n, 1), by cubics.

    It is the one that changes most in the scales; one that changes less than by `pace` [1/s] makes no shift in time count.
    """
    n = block.model.nq + block.model.nu
    before, after = (block.part("dy")[begins + i, :n] for i in (0, 1))
    changes = np.where(np.sign(before) * np.sign(after) < 0, np.abs(after - before), 0.0)
    changes /= block.controls[block.engine.layouts.controls["scale"]][:n]
    turned = np.flatnonzero(np.max(changes, axis=1, initial=0.0) > pace)
    one = turned, np.argmax(changes[turned], axis=1) if len(turned) else turned
    h, y = (block.t[begins + 1] - block.t[begins])[turned], block.part("y")
    sign = np.sign(before[one])
    start, end, way = (sign * x for x in (h * before[one], h * after[one], (y[begins + 1, :n] - y[begins, :n])[one]))
    return turned, _crests(np.zeros(len(turned)), way, start, end)


def _peaks(block: History, begins: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return through which steps a normal force is largest, and at which parts of those (n, 1), by cubics."""
    forces, rates = (block.part(name) for name in ("force", "force_rate"))
    peaked, pair = np.nonzero((rates[begins] >= 0) & (rates[begins + 1] < 0))
    before, h = begins[peaked], np.diff(block.t)[begins[peaked]]
    ends = ((before, pair), (before + 1, pair))
    return peaked, _crests(*(forces[end] for end in ends), *(h * rates[end] for end in ends))


def _crests(before: np.ndarray, after: np.ndarray, rate: np.ndarray, rate_after: np.ndarray) -> np.ndarray:
    """Return the parts (n, 1) of steps at which cubics of values and rates at their ends are largest."""
    with np.errstate(all="ignore"):  # of a run that left all scales
        parts, *_ = crest_of_cubic(np, before, after, rate, rate_after)
    clipped: np.ndarray = np.clip(np.nan_to_num(parts), 1 - Sampled.LATE, Sampled.LATE)
    return clipped[:, None]


def _bends(block: History, begins: np.ndarray) -> np.ndarray:
    """Return how much rates change in steps (n,): the error of the trapezoidal rule, in the scales."""
    n = block.model.nq + block.model.nu
    y, dy = (block.part(name)[:, :n] for name in ("y", "dy"))
    h = (block.t[begins + 1] - block.t[begins])[:, None]
    scale = block.controls[block.engine.layouts.controls["scale"]][:n]
    bent = y[begins + 1] - y[begins] - h / 2 * (dy[begins] + dy[begins + 1])
    bends: np.ndarray = np.max(np.abs(bent) / scale, axis=1, initial=0.0)
    return bends
