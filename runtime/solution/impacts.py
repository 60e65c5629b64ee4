"""Contacts of a run: onset, approach speed, duration, largest force and penetration.

They are found as the run proceeds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import casadi as ca
import numpy as np

from hertzwerk.runtime.integrate.step.layout import CONTACT, RELEASED
from hertzwerk.runtime.model.caller import Rowwise
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.attempt import Integrator
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

PEAK = 1e-5
TOGETHER = 256  # contacts whose peaks are found at once
TRIES = (4, 8)  # most iterations, nested: groups of them, and iterations of a group


@dataclass(frozen=True, slots=True)
class Impact:
    """One contact: onset t [s], approach speed [m/s], largest normal force [N], duration [s], penetration.

    duration: None if unfinished; peak_penetration [m].
    """

    contact: str
    t: float
    speed: float
    peak_force: float
    duration: float | None
    peak_penetration: float


@dataclass
class Track:
    """Begins and ends of one pair's contacts, block by block: from a row in contact to the next in flight.

    Between them it may be released and touch again.
    """

    pair: int
    open: bool = False

    def take(self, block: History, fresh: int) -> tuple[np.ndarray, np.ndarray]:
        """Return the rows at which contacts begin, and those at which gaps have opened after them."""
        mode = block.part("mode")[:, self.pair]
        rows = np.flatnonzero(mode[max(fresh, 1) :] != mode[max(fresh, 1) - 1 : -1]) + max(fresh, 1)
        if not fresh:
            rows = np.append(0, rows)
        rows = rows[mode[rows] != RELEASED]
        touching = mode[rows] == CONTACT
        changes = touching != np.append(self.open, touching[:-1])
        self.open = bool(touching[-1]) if len(rows) else self.open
        return rows[changes & touching], rows[changes & ~touching]


@dataclass
class ApproachSpeeds:
    """Observer of one pair's contacts: their number, those faster than a limit [m/s], the fastest [m/s]."""

    limit: float
    track: Track
    count: int = 0
    over: int = 0
    worst: float = 0.0

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        begins, _ = self.track.take(block, fresh)
        speeds = -block.part("gap_rate")[begins, self.track.pair]
        self.count += len(speeds)
        self.over += int(np.sum(speeds > self.limit))
        self.worst = float(np.max(speeds, initial=self.worst))


_PEAKS = (("force", "force_rate", +1, "normal_force"), ("gap", "gap_rate", -1, "penetration"))  # sign * part peaks


@dataclass(frozen=True)
class _Contacts:
    """Contacts of one pair, with what is known of their peaks.

    t, speed  onset (n,) [s], approach speed (n,) [m/s]
    left  time of the first row after the last one in contact (n,) [s]; nan while that is the last row
    tops  by the kinds of _PEAKS the row of the largest value so far, between its neighbours (n, kinds, 3, ns): the row
          itself in place of a neighbour that is not there, or not yet
    value, at_end  of those rows: sign * value, and whether the next row is not known yet (n, kinds)
    """

    LASTING: ClassVar = ("t", "speed", "left", "tops")  # what is of use when it is over

    t: np.ndarray
    speed: np.ndarray
    left: np.ndarray
    tops: np.ndarray
    value: np.ndarray
    at_end: np.ndarray

    def some(self, rows: range) -> _Contacts:
        """Return some of the contacts, copied."""
        return _Contacts(*(part[list(rows)] for part in vars(self).values()))


class _Pair:
    """Contacts of one pair, block by block."""

    def __init__(self, j: int) -> None:
        self.track = Track(j)
        self.open: _Contacts | None = None  # the one that is not over
        self._age = 0  # of that one: rows since its onset

    def take(self, block: History, fresh: int) -> _Contacts | None:
        """Return the contacts that end in a block; None if there is none in it."""
        onsets, stops = self.track.take(block, fresh)
        if self.open is not None:
            onsets = np.append(fresh - self._age, onsets)
        if not len(onsets):
            return None
        over, count = len(stops), len(block.rows)
        found = self._found(block, fresh, onsets, np.append(stops, count)[: len(onsets)])
        self.open = found.some(range(over, over + 1)) if over < len(onsets) else None
        self._age = count - int(onsets[-1])
        return found.some(range(over))

    def _found(self, block: History, fresh: int, onsets: np.ndarray, stops: np.ndarray) -> _Contacts:
        """Return the contacts between rows of a block; one that was open may begin before it."""
        j, t, before = self.track.pair, block.t, self.open
        touching = block.part("mode")[:, j] == CONTACT
        values = np.column_stack([sign * block.part(part)[:, j] for part, _, sign, _ in _PEAKS])
        # the last row that was known may be a top: now the row after it is known
        starts, first = np.maximum(onsets, fresh - 1), np.maximum(onsets, 0)
        top = _largest(values, starts, stops)
        near = np.stack([np.maximum(top - 1, first[:, None]), top, np.minimum(top + 1, len(t) - 1)], axis=2)
        found = _Contacts(
            t=t[first],
            speed=np.maximum(0.0, -block.part("gap_rate")[first, j]),
            left=_left(t, touching, starts, stops),
            tops=block.rows[near],
            value=np.take_along_axis(values, top, axis=0),
            at_end=top + 1 == len(t),
        )
        if before is not None:
            found.t[0], found.speed[0] = before.t[0], before.speed[0]
            if not touching[-1] and np.isnan(found.left[0]):
                found.left[0] = before.left[0]
            kept = ~((found.value[0] > before.value[0]) | (before.at_end[0] & (top[0] == starts[0])))
            for part in ("tops", "value", "at_end"):
                getattr(found, part)[0, kept] = getattr(before, part)[0, kept]
        return found


def _largest(values: np.ndarray, starts: np.ndarray, stops: np.ndarray) -> np.ndarray:
    """Return the row of the largest of some values (rows, kinds) in each range of rows, shape (n, kinds).

    The first of them; a value that is no number counts as the largest.
    """
    lengths = stops - starts
    begins = np.cumsum(lengths) - lengths
    owner = np.repeat(np.arange(len(starts)), lengths)
    rows = np.arange(len(owner)) + (starts - begins)[owner]
    values = values[rows]
    values[np.isnan(values)] = np.inf
    is_largest = values == np.maximum.reduceat(values, begins, axis=0)[owner]
    places = [np.flatnonzero(column) for column in is_largest.T]
    return np.column_stack([rows[place[np.searchsorted(place, begins)]] for place in places])


def _left(t: np.ndarray, touching: np.ndarray, starts: np.ndarray, stops: np.ndarray) -> np.ndarray:
    """Return the time [s] of the last row in each range that follows a contact without being in one.

    The row at its end counts. nan if there is none, and where the range reaches the last row of all, in contact.
    """
    leaves = np.flatnonzero(touching[:-1] & ~touching[1:]) + 1
    last = np.searchsorted(leaves, stops, side="right") - 1
    rows = np.append(leaves, 0)[last]
    lasts = (stops == len(t)) & touching[-1]
    return np.where((last >= 0) & (rows >= starts) & ~lasts, t[rows], np.nan)


class Contacts:
    """Observer of every contact of a run; keeps only rows beside the largest values of open contacts."""

    def __init__(self, model: Model) -> None:
        self._pairs = [_Pair(j) for j in range(model.k)]
        self._found: list[np.ndarray] = []  # tables, see `_table`
        self._over: list[list[_Contacts]] = [[] for _ in self._pairs]  # without a table
        self._block: History | None = None

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        self._block = block
        for pair, left in zip(self._pairs, self._over, strict=True):
            over = pair.take(block, fresh)
            if over is not None and len(over.t):
                left.append(over)
                if sum(len(some.t) for some in left) >= TOGETHER:
                    self._found.append(_table(block, pair.track.pair, left))
                    left.clear()

    def impacts(self) -> tuple[Impact, ...]:
        """Return every contact in the order of onset, open ones included.

        Peaks are found within the steps, to the accuracy of the run.
        """
        block = self._block
        if block is None:
            return ()
        tables = list(self._found)
        for pair, over in zip(self._pairs, self._over, strict=True):
            left = over if pair.open is None else [*over, pair.open]
            if left:
                tables.append(_table(block, pair.track.pair, left))
        if not tables:
            return ()
        table = np.concatenate(tables)
        table = table[np.lexsort((table[:, 0], table[:, 1]))]
        names = block.model.pairs
        return tuple(
            Impact(names[int(j)], t, speed, force, duration if duration == duration else None, penetration)
            for j, t, speed, force, duration, penetration in table.tolist()
        )


def _table(history: History, j: int, contacts: Sequence[_Contacts]) -> np.ndarray:
    """Return a table (n, 6) of contacts, with their peaks.

    Columns: pair, onset [s], approach speed [m/s], peak force [N], duration [s], nan if unfinished, peak penetration [m].
    """
    t, speed, left, tops = (np.concatenate([getattr(some, part) for some in contacts]) for part in _Contacts.LASTING)
    with np.errstate(invalid="ignore"):  # a run that came to no good end may hold what is not a number
        force, penetration = _peaks(history, j, tops).T
        return np.stack([np.full(len(t), float(j)), t, speed, force, left - t, penetration], axis=1)


def _peaks(history: History, j: int, tops: np.ndarray) -> np.ndarray:
    """Return the peak values of a pair's contacts by their `tops`, shape (n, kinds).

    The largest in the rows, or where sign * rate falls through zero within the steps beside it.
    """
    kinds, ns = tops.shape[1], tops.shape[-1]
    lower, upper = (tops[:, :, side].reshape(-1, ns) for side in (slice(0, 2), slice(1, 3)))
    place = np.arange(len(lower))
    kind = place // 2 % kinds
    column = np.array([history.columns(rate).start + j for _, rate, _, _ in _PEAKS])[kind]
    sign = np.array([sign for _, _, sign, _ in _PEAKS])[kind]
    at_low, at_high = (sign * side[place, column] for side in (lower, upper))
    modes, h = history.columns("mode"), upper[:, 0] - lower[:, 0]
    changed = np.flatnonzero(np.any(lower[:, modes] != upper[:, modes], axis=1))  # there the step ended otherwise
    if len(changed):
        ended = history.later(lower[changed], h[changed])
        at_high[changed] = sign[changed] * ended[np.arange(len(changed)), column[changed]]
    # a force begins with no slope, or none that is known, and rises
    at_low = np.where(at_low == 0, np.abs(at_high), at_low)
    within = np.flatnonzero((at_low > 0) & (at_high < 0))
    rates = np.zeros((len(within), 2 * history.model.k))
    rates[np.arange(len(within)), j + history.model.k * kind[within]] = sign[within]
    sides = (x[within, None] for x in (h, at_low, at_high))
    crests = history.within_steps(crest, lower[within], *sides, rates)
    found = history.of(np.concatenate([tops[:, :, 1].reshape(-1, ns), crests]))
    values = np.column_stack([found[f"{history.model.pairs[j]}.{name}"] for *_, name in _PEAKS])
    count = kinds * len(tops)
    peaks: np.ndarray = values[np.arange(count), np.arange(count) % kinds]
    np.maximum.at(peaks, within // 2, values[count + np.arange(len(within)), kind[within]])
    return peaks.reshape(-1, kinds)


@per_model
def crest(model: Model, integrator: Integrator, method: int) -> Rowwise:
    """Build the function (state, controls, h, at_low, at_high, rates) -> trial of a part of a step.

    The part ends where a rate falls through zero: `rates` (2 k) is its sign among the rates of all forces, then of all
    gaps; it is at_low > 0 at the start of the step h [s], at_high < 0 at its end. Regula falsi in the form of
    Anderson and Bjorck, BIT 13 (1973) 253. A peak is flat: its value is right to rounding when its time is to PEAK of
    the step.
    """
    vectors = integrator.layouts
    sizes = {"state": vectors.state.size, "controls": vectors.controls.size, "h": 1, "rates": 2 * model.k}
    given: list[Any] = [ca.SX.sym(name, size) for name, size in sizes.items()]
    state, controls, h, rates = given
    search: Any = ca.SX.sym("search", 7)
    low, high, at_low, at_high, before, rose, _ = ca.vertsplit(search)
    root = low + (high - low) * at_low / (at_low - at_high)
    trial = integrator.step(method)(state, controls, root)
    parts = vectors.trial.split(trial)
    of_each = ca.vertcat(*(parts[rate] for _, rate, _, _ in _PEAKS))
    value = ca.sum1(ca.if_else(rates == 0, 0, rates * of_each))
    above = value > 0
    rises = ca.if_else(above, 1, -1)
    weight = 1 - value / ca.if_else(above, at_low, at_high)
    weight = ca.if_else(rises != rose, 1, ca.if_else(weight > 0, weight, 0.5))
    goes_on = (ca.fabs(root - before) > PEAK * h) * (value != 0)
    after = ca.vertcat(
        ca.if_else(above, root, low),
        ca.if_else(above, high, root),
        ca.if_else(above, value, at_low * weight),
        ca.if_else(above, at_high * weight, value),
        *(root, rises, goes_on),
    )
    once = ca.Function("once", [search, ca.SX.sym("trial", vectors.trial.size), *given], [after, trial])
    given = [ca.MX.sym(name, size) for name, size in sizes.items()]
    for tries in TRIES:
        first: list[Any] = [ca.MX.sym("search", 7), ca.MX.sym("trial", vectors.trial.size)]
        found = ca.Function.if_else("found", once, ca.Function("kept", [*first, *given], first))
        search, trial = first
        for _ in range(tries):
            search, trial = found(search[6], search, trial, *given)
        once = ca.Function("tried", [*first, *given], [search, trial])
    state, controls, h, rates = given
    ends = [ca.MX.sym(name) for name in ("at_low", "at_high")]
    _, trial = once(ca.vertcat(0, h, *ends, -h, 0, 1), ca.MX.zeros(vectors.trial.size), *given)
    return Rowwise(ca.Function("crest", [state, controls, h, *ends, rates], [trial]), constant=1)
