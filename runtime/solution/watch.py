"""Contacts of a run, followed from step to step by a CasADi function."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.integrate.loop.tally import approach_speed, begin, is_open
from hertzwerk.runtime.integrate.step.layout import CONTACT, FLIGHT, Layout
from hertzwerk.runtime.model.caller import Scan
from hertzwerk.runtime.model.per_model import per_model
from hertzwerk.runtime.solution.impacts import KINDS, Impact, peaks

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.attempt import Integrator
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

PIECE = 2048  # rows followed at once: what is found of them fits into a cache
TOGETHER = 256  # contacts whose peaks are found at once
ONSET = ("t", "speed", "left")  # and end of a contact
BESIDE = np.array([-1, 0, 1])
TOPS = tuple(f"top_{part}" for part, *_ in KINDS)


class Watch:
    """Observer of every contact of a run; keeps only rows beside their tops.

    A contact begins at a row in contact and ends at the next in flight; between them it may be released and touch
    again.
    """

    def __init__(self, model: Model) -> None:
        self._model, self._layout = model, carried(model)
        self._last = np.zeros(self._layout.size)  # what is carried on
        self._view: History
        self._rows = 0
        self._kept: dict[int, np.ndarray] = {}  # rows beside the tops of open contacts, by number
        self._ended: list[np.ndarray] = []  # contacts that are over, as in `contacts`
        self._tops: list[np.ndarray] = []  # of contacts whose peaks are not known yet
        self._peaks: list[np.ndarray] = []

    def take(self, block: History, fresh: int) -> None:
        """Take the next accepted steps; see `Observer`."""
        self._view, before = block.of(block.rows[-1:].copy()), self._rows - fresh
        follow = following(self._model, block.engine)
        for first in range(fresh, len(block.rows), PIECE):
            found = follow(self._last, block.rows[first : first + PIECE])
            self._last, self._rows = found[-1].copy(), before + first + len(found)
            rows, pairs = np.nonzero(found[:, self._layout["ends"]])
            if len(rows):
                self._ended.append(self._table(found, rows, pairs))
                self._tops.append(self._rows_at(self._near(found, rows, pairs), block, before))
        near = self._near(*self._open)
        self._kept = dict(zip(near.ravel().tolist(), self._rows_at(near.ravel(), block, before), strict=True))
        if sum(map(len, self._tops)) >= TOGETHER:
            self._peaks.append(self._peaks_of(np.concatenate(self._ended), self._tops))
            self._tops.clear()

    @property
    def contacts(self) -> np.ndarray:
        """Every contact: pair, onset [s], approach speed [m/s], when it was left [s] or nan, shape (n, 4)."""
        *_, pairs = self._open
        last = self._table(*self._open)
        last[self._last[self._layout["touching"].start + pairs] > 0, 3] = math.nan
        return np.concatenate([*self._ended, last])

    def impacts(self) -> tuple[Impact, ...]:
        """Return every contact in the order of onset, open ones included.

        Peaks are found within the steps, to the accuracy of the run.
        """
        table, tops, near = self.contacts, list(self._tops), self._near(*self._open)
        if near.size:
            tops.append(np.array([self._kept[row] for row in near.ravel().tolist()]).reshape(*near.shape, -1))
        if not len(table):
            return ()
        found = np.concatenate([*self._peaks, *([self._peaks_of(table, tops)] if tops else [])])
        order = np.lexsort((table[:, 0], table[:, 1]))
        names = self._model.pairs
        return tuple(
            Impact(names[int(j)], t, speed, force, left - t if left == left else None, penetration)
            for (j, t, speed, left), (force, penetration) in zip(
                table[order].tolist(), found[order].tolist(), strict=True
            )
        )

    @property
    def _open(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Contacts that are not over: what is carried last, its row, the pairs."""
        pairs = np.flatnonzero(self._last[self._layout["open"]])
        return self._last[None], np.zeros_like(pairs), pairs

    def _of(self, found: np.ndarray, rows: np.ndarray, pairs: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
        """Return parts of what is carried at rows (n,) that belong to pairs (n,), shape (n, names)."""
        columns = np.array([self._layout[name].start for name in names])
        part: np.ndarray = found[rows[:, None], columns + pairs[:, None]]
        return part

    def _table(self, found: np.ndarray, rows: np.ndarray, pairs: np.ndarray) -> np.ndarray:
        table = np.empty((len(pairs), 1 + len(ONSET)))
        table[:, 0], table[:, 1:] = pairs, self._of(found, rows, pairs, ONSET)
        return table

    def _near(self, found: np.ndarray, rows: np.ndarray, pairs: np.ndarray) -> np.ndarray:
        """Return the numbers of the rows of `tops` (n, kinds, 3); a contact has no row before its onset."""
        numbers = self._of(found, rows, pairs, ("onset", *TOPS)).astype(int)[:, :, None]
        near: np.ndarray = np.clip(numbers[:, 1:] + BESIDE, numbers[:, :1], self._rows - 1)
        return near

    def _rows_at(self, numbers: np.ndarray, block: History, before: int) -> np.ndarray:
        """Return rows by their numbers, of which those before the block's first are kept."""
        rows: np.ndarray = block.rows[np.maximum(numbers - before, 0)]
        for place in zip(*np.nonzero(numbers < before), strict=True):
            rows[place] = self._kept[int(numbers[place])]
        return rows

    def _peaks_of(self, table: np.ndarray, tops: list[np.ndarray]) -> np.ndarray:
        """Return the peaks of the last contacts of a table by their tops."""
        last = np.concatenate(tops)
        return peaks(self._view, table[len(table) - len(last) :, 0].astype(int), last)


@per_model
def carried(model: Model) -> Layout:
    """Return the layout of what is carried from row to row: the number of rows, then of each pair.

    Whether its contact is open, whether it touches, whether its contact ends at this row, and of the last contact
    onset t [s], approach speed [m/s], when it was left [s], onset and tops (rows), and largest values.
    """
    of_pairs = ("open", "touching", "ends", *ONSET, "onset", *TOPS, *(part for part, *_ in KINDS))
    return Layout({"row": 1, **dict.fromkeys(of_pairs, model.k)})


@per_model
def following(model: Model, integrator: Integrator) -> Scan:
    """Build the function (carried, state) -> carried after one more row."""
    vectors, layout = integrator.layouts.state, carried(model)
    last, state = layout.symbol("carried"), vectors.symbol("state")
    new = {"row": last[0] + 1, **_of_pairs(vectors.split(state), layout.split(last))}
    return Scan(ca.Function("following", [last, state], [layout.join(new)]))


def _of_pairs(at: dict[str, Any], was: dict[str, Any]) -> dict[str, Any]:
    """Return what is carried of the pairs after a row."""
    touching, begins = at["mode"] == CONTACT, begin(at, was)
    onset = {"t": at["t"], "speed": approach_speed(at)}
    new = {
        "open": is_open(at, was),
        "touching": touching,
        "ends": was["open"] * (at["mode"] == FLIGHT),
        **{name: ca.if_else(begins, value, was[name]) for name, value in onset.items()},
        "left": ca.if_else(was["touching"] * (1 - touching), at["t"], ca.if_else(begins, math.nan, was["left"])),
        "onset": ca.if_else(begins, was["row"], was["onset"]),
    }
    for part, _, sign in KINDS:
        value = ca.if_else(at[part] == at[part], sign * at[part], math.inf)  # what is no number counts as the largest
        higher = ca.logic_or(begins, new["open"] * (value > was[part]))
        new |= {
            part: ca.if_else(higher, value, was[part]),
            f"top_{part}": ca.if_else(higher, was["row"], was[f"top_{part}"]),
        }
    return new
