"""Contacts of a run: onset, approach speed, duration, largest force and penetration.

They are found as the run proceeds.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import zip_longest
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.integrate.step.layout import CONTACT, RELEASED

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

PEAK = 1e-5
MAX_ITERATIONS = 60


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
        mode = block.part("mode")[fresh:, self.pair]
        known = np.flatnonzero(mode != RELEASED)
        touching = mode[known] == CONTACT
        before = np.concatenate([[self.open], touching])
        self.open = bool(before[-1])
        changes = before[:-1] != touching
        begins, ends = known[changes & touching], known[changes & ~touching]
        return begins + fresh, ends + fresh


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


@dataclass(frozen=True, slots=True)
class _Top:
    """Row of the largest value so far, between its neighbours: rows (<= 3, ns)."""

    value: float
    rows: np.ndarray
    at_end: bool  # of its block: the row after it is not known yet


@dataclass(slots=True)
class _Contact:
    """Contact in progress: onset, and the largest values in the order of _PEAKS."""

    t: float
    speed: float
    tops: list[_Top | None] = field(default_factory=lambda: [None] * len(_PEAKS))
    left: float | None = None  # time of the first row after the last one in contact; None while that is the last row


class _Pair:
    """Contacts of one pair, block by block."""

    def __init__(self, j: int) -> None:
        self.track = Track(j)
        self.contact: _Contact | None = None  # the one that is not over
        self.age = 0  # of that one: rows since its onset

    def take(self, block: History, fresh: int) -> list[_Contact]:
        """Return the contacts that end in a block."""
        begins, ends = self.track.take(block, fresh)
        if self.contact is None and not len(begins):
            return []
        j, count, t, over = self.track.pair, len(block.rows), block.t, []
        touching = block.part("mode")[:, j] == CONTACT
        leaves = np.flatnonzero(touching[:-1] & ~touching[1:]) + 1
        values = [sign * block.part(part)[:, j] for part, _, sign, _ in _PEAKS]
        rates = block.part("gap_rate")[:, j]
        onsets = begins.tolist() if self.contact is None else [fresh - self.age, *begins.tolist()]
        for onset, stop in zip_longest(onsets, ends.tolist(), fillvalue=count):
            contact = self.contact or _Contact(float(t[onset]), max(0.0, -float(rates[onset])))
            start = max(onset, fresh - 1)  # the last row that was known may be a top: now the row after it is known
            contact.tops = [
                _top(block, column, range(start, stop), max(onset, 0), known)
                for column, known in zip(values, contact.tops, strict=True)
            ]
            left = leaves[leaves.searchsorted(start) : leaves.searchsorted(stop, side="right")]
            if stop == count and touching[-1]:
                contact.left = None
            elif len(left):
                contact.left = float(t[left[-1]])
            self.contact, self.age = contact, count - onset
            if stop < count:
                over.append(contact)
                self.contact = None
        return over


def _top(block: History, values: np.ndarray, rows: range, onset: int, known: _Top | None) -> _Top:
    """Return the largest of the values at some rows and the known one; rows before the onset are left out."""
    i = rows.start + int(values[rows.start : rows.stop].argmax())
    value = float(values[i])
    if known is not None and not (value > known.value or (known.at_end and i == rows.start)):
        return known
    return _Top(value, block.rows[max(i - 1, onset) : i + 2].copy(), at_end=i + 1 == len(values))


class Contacts:
    """Observer of every contact of a run; keeps only rows beside the largest values of open contacts."""

    def __init__(self, model: Model) -> None:
        self._pairs = [_Pair(j) for j in range(model.k)]
        self._found: list[Impact] = []
        self._block: History | None = None

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        over = [(pair.track.pair, contact) for pair in self._pairs for contact in pair.take(block, fresh)]
        self._found += _impacts(block, over)
        self._block = block

    def impacts(self) -> tuple[Impact, ...]:
        """Return every contact in the order of onset, open ones included.

        Peaks are found within the steps, to the accuracy of the run.
        """
        found = self._found
        if self._block is not None:
            left = [(pair.track.pair, pair.contact) for pair in self._pairs if pair.contact is not None]
            names = self._block.model.pairs
            found = sorted(found + _impacts(self._block, left), key=lambda i: (i.t, names.index(i.contact)))
        return tuple(found)


def _impacts(history: History, contacts: Sequence[tuple[int, _Contact]]) -> list[Impact]:
    """Convert contacts (pair, contact) to impacts, with peaks found within the steps."""
    if not contacts:
        return []
    with np.errstate(invalid="ignore"):  # a run that came to no good end may hold what is not a number
        peaks = _peaks(history, contacts).tolist()
    return [
        Impact(
            contact=history.model.pairs[j],
            t=contact.t,
            speed=contact.speed,
            peak_force=force,
            duration=None if contact.left is None else contact.left - contact.t,
            peak_penetration=penetration,
        )
        for (j, contact), (force, penetration) in zip(contacts, peaks, strict=True)
    ]


def _peaks(history: History, contacts: Sequence[tuple[int, _Contact]]) -> np.ndarray:
    """Return the peak values of contacts (pair, contact), shape (n, 2).

    The largest in the kept rows, or where sign * rate falls through zero within the steps between them.
    """
    groups = [top.rows for _, contact in contacts for top in contact.tops if top is not None]
    pairs = np.repeat([j for j, _ in contacts], len(_PEAKS))
    kinds = np.tile(np.arange(len(_PEAKS)), len(contacts))
    rows, owner = np.concatenate(groups), np.repeat(np.arange(len(groups)), [len(group) for group in groups])
    peaks = np.full(len(groups), -np.inf)
    np.maximum.at(peaks, owner, _values(history, rows, pairs[owner], kinds[owner]))
    low = np.flatnonzero(owner[:-1] == owner[1:])
    lower, upper, owner = rows[low], rows[low + 1], owner[low]
    column = np.array([history.columns(rate).start for _, rate, _, _ in _PEAKS])[kinds[owner]] + pairs[owner]
    sign = np.array([sign for _, _, sign, _ in _PEAKS])[kinds[owner]]
    modes, h = history.columns("mode"), upper[:, 0] - lower[:, 0]
    at_low, at_high = (sign * side[np.arange(len(low)), column] for side in (lower, upper))
    changed = np.flatnonzero(np.any(lower[:, modes] != upper[:, modes], axis=1))  # there the step ended otherwise
    ended = history.later(lower[changed], h[changed])
    at_high[changed] = sign[changed] * ended[np.arange(len(changed)), column[changed]]
    # a force begins with no slope, or none that is known, and rises
    at_low = np.where(at_low == 0, np.abs(at_high), at_low)
    within = np.flatnonzero((at_low > 0) & (at_high < 0))
    if len(within):
        given = (x[within] for x in (lower, column, sign, h, at_low, at_high))
        at_root, owner = _at_roots(history, _Bracket(*given)), owner[within]
        np.maximum.at(peaks, owner, _values(history, at_root, pairs[owner], kinds[owner]))
    return peaks.reshape(-1, len(_PEAKS))


def _values(history: History, rows: np.ndarray, pairs: np.ndarray, kinds: np.ndarray) -> np.ndarray:
    """Return the peaking quantity in each row, by the pair and the kind beside it."""
    found, values = history.of(rows), np.zeros(len(rows))
    for j in set(pairs.tolist()):
        for kind, (*_, name) in enumerate(_PEAKS):
            here = (pairs == j) & (kinds == kind)
            values[here] = found[f"{history.model.pairs[j]}.{name}"][here]
    return values


@dataclass(frozen=True)
class _Bracket:
    """Steps h (n,) [s] from rows (n, ns) in which a signed column falls from at_low > 0 to at_high < 0."""

    rows: np.ndarray
    column: np.ndarray
    sign: np.ndarray
    h: np.ndarray
    at_low: np.ndarray
    at_high: np.ndarray


def _at_roots(history: History, bracket: _Bracket) -> np.ndarray:
    """Return the rows (n, ns) at the roots, by regula falsi in the form of Anderson and Bjorck.

    BIT 13 (1973) 253; all brackets at once. A peak is flat: its value is right to rounding when its time is to PEAK
    of the step.
    """
    found, index = bracket.rows.copy(), np.arange(len(bracket.rows))
    low, high, at_low, at_high = np.zeros(len(index)), bracket.h.copy(), bracket.at_low.copy(), bracket.at_high.copy()
    before, rose = np.full(len(index), np.inf), np.zeros(len(index))
    for _ in range(MAX_ITERATIONS):
        root = low + (high - low) * at_low / (at_low - at_high)
        found[index] = history.later(bracket.rows[index], root)
        value = bracket.sign[index] * found[index, bracket.column[index]]
        rises = np.where(value > 0, 1.0, -1.0)
        weight = 1 - value / np.where(value > 0, at_low, at_high)
        weight = np.where(rises != rose, 1.0, np.where(weight > 0, weight, 0.5))
        low, high = np.where(value > 0, root, low), np.where(value > 0, high, root)
        at_low, at_high = np.where(value > 0, value, at_low * weight), np.where(value > 0, at_high * weight, value)
        goes_on = (np.abs(root - before) > PEAK * bracket.h[index]) & (value != 0)
        if not np.any(goes_on):
            break
        index, low, high, at_low, at_high, before, rose = (
            x[goes_on] for x in (index, low, high, at_low, at_high, root, rises)
        )
    return found
