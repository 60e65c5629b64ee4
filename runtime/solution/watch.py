"""Contacts of a run, found block by block among its steps."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from hertzwerk.runtime.integrate.step.layout import CONTACT, RELEASED
from hertzwerk.runtime.solution.impacts import KINDS, Impact, peaks

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

TOGETHER = 256  # contacts whose peaks are found at once
PIECE = 2**14  # rows followed at once: what is found of them is held no longer
BESIDE = np.array([-1, 0, 1])


class Contact(NamedTuple):
    """Contact of a pair, over or not.

    t, speed    onset [s] and approach speed [m/s]
    left     when the surfaces left each other last [s]; nan where they touch
    largest  values of the KINDS so far (kinds,)
    tops     rows of these values, each between its neighbours, none before the onset (kinds, 3, ns)
    """

    pair: int
    t: float
    speed: float
    left: float
    largest: np.ndarray
    tops: np.ndarray


class Watch:
    """Observer of every contact of a run; keeps only rows beside their tops.

    A contact begins at a row in contact and ends at the next in flight; between them it may be released and touch
    again.
    """

    def __init__(self, model: Model) -> None:
        self._model = model
        self._view: History
        self._open: dict[int, Contact] = {}  # that are not over, by pair
        self._ended: list[Contact] = []  # whose peaks are not known yet
        self._impacts: list[Impact] = []

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        self._view = block.of(block.rows[-1:].copy())
        for contact in self._open.values():
            _, top, after = contact.tops.swapaxes(0, 1)
            after[(top == after).all(axis=1)] = block.rows[fresh]  # that was not there yet
        for first in range(fresh, len(block.rows), PIECE):
            for j in range(self._model.k):
                ended, still = _contacts(block, j, slice(first, first + PIECE), self._open.pop(j, None))
                self._ended += ended
                if still is not None:
                    self._open[j] = still
            if len(self._ended) >= TOGETHER:
                self._impacts += self._impacts_of(self._ended)
                self._ended = []

    def impacts(self) -> tuple[Impact, ...]:
        """Return every contact in the order of onset, open ones included.

        Peaks are found within the steps, to the accuracy of the run.
        """
        place = self._model.pairs.index
        found = [*self._impacts, *self._impacts_of([*self._ended, *self._open.values()])]
        return tuple(sorted(found, key=lambda impact: (impact.t, place(impact.contact))))

    def _impacts_of(self, contacts: list[Contact]) -> list[Impact]:
        """Return contacts with their peaks."""
        if not contacts:
            return []
        found = peaks(
            self._view, np.array([each.pair for each in contacts]), np.stack([each.tops for each in contacts])
        )
        return [
            Impact(self._model.pairs[j], t, speed, force, None if math.isnan(left) else left - t, penetration)
            for (j, t, speed, left, *_), (force, penetration) in zip(contacts, found.tolist(), strict=True)
        ]


def _contacts(block: History, j: int, rows: slice, begun: Contact | None) -> tuple[list[Contact], Contact | None]:
    """Return the contacts of pair j that end in some rows, and the one that is open after them.

    begun    the one that is open before them
    """
    modes, t = block.part("mode")[rows, j], block.t[rows]
    is_open = goes_on(modes, begun is not None)
    within = np.flatnonzero(is_open)
    if not len(within) and begun is None:
        return [], None
    touching = np.concatenate([[begun is not None and math.isnan(begun.left)], modes == CONTACT])
    leaves = np.flatnonzero(touching[:-1] & ~touching[1:])
    times = np.append(t[leaves], math.nan if begun is None else begun.left)  # the last: before these rows

    def left(end: Any) -> Any:
        """Return when the surfaces left each other last, up to these rows."""
        return times[np.searchsorted(leaves, end, side="right") - 1]

    found: list[Contact] = []
    if begun is not None and not is_open[0]:
        found, begun = [begun._replace(left=float(left(0)))], None
    if len(within):
        starts = np.flatnonzero(within[1:] - within[:-1] > 1) + 1  # of all but the first, among the rows within
        begins, ends = within[np.append(0, starts)], within[np.append(starts, 0) - 1] + 1
        lefts = left(ends)
        if touching[-1]:
            lefts[-1] = math.nan
        onsets = rows.start + begins
        speeds = np.maximum(-block.part("gap_rate")[onsets, j], 0.0)
        if begun is not None:
            onsets[0] = 0  # or before
        tops = _tops(block, j, rows.start + within, np.append(0, starts), onsets)
        columns = (t[begins].tolist(), speeds.tolist(), lefts.tolist())
        contacts = [Contact(j, *each) for each in zip(*columns, *tops, strict=True)]
        if begun is not None:
            contacts[0] = _continued(begun, contacts[0])
        found += contacts
    return (found[:-1], found[-1]) if is_open[-1] else (found, None)


def goes_on(modes: np.ndarray, before: bool) -> np.ndarray:
    """Return whether a contact goes on at rows of these modes (n,): it may be released and touch again."""
    found: np.ndarray = modes == CONTACT
    released = modes == RELEASED
    if released.any():
        latest = np.maximum.accumulate(np.where(released, -1, np.arange(len(modes))))
        found = np.where(latest < 0, before, found[latest])
    return found


def _tops(
    block: History, j: int, within: np.ndarray, starts: np.ndarray, onsets: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the largest values in n contacts of pair j (n, kinds), and their rows (n, kinds, 3, ns).

    within, starts, onsets    rows in contact, where among them each contact starts, and the first row of each
    """
    largest, places = np.empty((len(starts), len(KINDS))), np.empty((len(starts), len(KINDS)), dtype=int)
    lengths = np.append(starts[1:], len(within)) - starts
    for kind, (part, _, sign) in enumerate(KINDS):
        values = sign * block.part(part)[within, j]
        values[np.isnan(values)] = math.inf  # what is no number counts as the largest
        largest[:, kind] = np.maximum.reduceat(values, starts)
        hits = np.flatnonzero(values == np.repeat(largest[:, kind], lengths))
        places[:, kind] = within[hits[np.searchsorted(hits, starts)]]
    beside = np.clip(places[:, :, None] + BESIDE, onsets[:, None, None], len(block.rows) - 1)
    return largest, block.rows[beside]


def _continued(begun: Contact, later: Contact) -> Contact:
    """Return a contact of which a part was known before."""
    higher = later.largest > begun.largest
    tops = np.where(higher[:, None, None], later.tops, begun.tops)
    return later._replace(t=begun.t, speed=begun.speed, largest=np.maximum(later.largest, begun.largest), tops=tops)
