"""Rows of a run with a list of near pairs, read pair by pair."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import APART, NearModel
from hertzwerk.runtime.engine.integration.step.layout import FLIGHT, PAIR_PARTS, Layout

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.loop.near_list import Departures

OF_PAIRS = ("mode", *PAIR_PARTS)
NOT_LISTED = dict.fromkeys(OF_PAIRS, 0.0) | {"mode": FLIGHT, "gap": APART}  # of a pair that is not listed


class NearRows:
    """Rows (n, ns) of a run with a list."""

    def __init__(self, model: NearModel, layout: Layout, rows: np.ndarray, departures: Departures) -> None:
        self._model, self._layout, self._rows, self._departures = model, layout, rows, departures
        near = rows[:, layout["pieces"]][:, : model.k]
        ends = [*np.flatnonzero(np.any(near[1:] != near[:-1], axis=1)) + 1, len(rows)]
        self._lists: list[tuple[slice, np.ndarray, np.ndarray]] = []
        for first, last in zip([0, *ends], ends, strict=False):
            if last > first:
                listed = np.flatnonzero(near[first] >= 0)
                pairs = near[first, listed].astype(int)
                self._lists.append((slice(first, last), listed, pairs))
        self._places = [dict(zip(pairs.tolist(), listed.tolist(), strict=True)) for _, listed, pairs in self._lists]

    def busy(self) -> list[int]:
        """Return the pairs that are not in flight at some row."""
        mode = self._rows[:, self._layout["mode"]]
        busy = [pairs[np.any(mode[rows][:, listed] != FLIGHT, axis=0)] for rows, listed, pairs in self._lists]
        return sorted({int(pair) for pairs in busy for pair in pairs})

    def _listed(self, pair: int) -> Iterator[tuple[slice, int]]:
        """Yield the rows at which a pair is listed, with its place there."""
        return ((rows, of[pair]) for (rows, *_), of in zip(self._lists, self._places, strict=True) if pair in of)

    def column(self, part: str, pair: int) -> np.ndarray:
        """Return a part of a pair (n,)."""
        start = self._layout.places[part]
        column = np.full(len(self._rows), NOT_LISTED[part])
        for rows, place in self._listed(pair):
            column[rows] = self._rows[rows, start + place]
        return column

    def latch(self, row: int, pair: int) -> np.ndarray:
        """Return a row of the whole model's latches, that is of a pair, at all rows (n,)."""
        i = self._model.whole_latches[pair].index(row)
        start, latch = self._layout.places["m"] + i * self._model.k, np.ones(len(self._rows))
        t = self._rows[:, self._layout.places["t"]]
        for left in self._departures.get(pair, ()):
            latch[t > left.t] = left.latches[i]
        for rows, place in self._listed(pair):
            latch[rows] = self._rows[rows, start + place]
        return latch

    def part(self, part: str) -> np.ndarray:
        """Return a part of the rows as of the whole model (n, size)."""
        whole, own = self._model.whole, self._rows[:, self._layout[part]]
        if part in OF_PAIRS:
            table = np.full((len(own), whole.k), NOT_LISTED[part])
            for rows, listed, pairs in self._lists:
                table[rows, pairs] = own[rows][:, listed]
            return table
        if part == "m":
            of_rows = [pair for *_, pair in whole.module.LATCHES]
            return np.array([self.latch(row, pair) for row, pair in enumerate(of_rows)]).reshape(-1, len(own)).T
        if part in ("y", "dy"):
            return np.hstack([own[:, : whole.nq + whole.nu], self._memory(own, summed=part == "y")])
        return own

    def _memory(self, own: np.ndarray, *, summed: bool) -> np.ndarray:
        """Return memory, or its rates, of all pairs (n, nz)."""
        model = self._model
        values, rows_of = own[:, model.nq + model.nu :], model.memory_rows
        memory = np.zeros((len(own), model.whole.nz))
        memory[:, model.others] = values[:, : len(model.others)]
        for rows, listed, pairs in self._lists:
            for place, pair in zip(listed.tolist(), pairs.tolist(), strict=True):
                memory[rows, rows_of[pair]] = values[rows][:, model.rows[place]]
        t = self._rows[:, self._layout.places["t"]]
        for pair, departures in self._departures.items() if summed else ():
            for left in departures:
                memory[:, rows_of[pair]] += (t > left.t)[:, None] * left.memory
        return memory

    def memory(self, row: int) -> np.ndarray:
        """Return a row of the whole model's memory, at all rows (n,)."""
        model = self._model
        start = self._layout.places["y"] + model.nq + model.nu
        if row in model.others:
            return np.array(self._rows[:, start + model.others.index(row)])
        pair, i = next((pair, of.index(row)) for pair, of in enumerate(model.memory_rows) if row in of)
        memory = np.zeros(len(self._rows))
        for rows, place in self._listed(pair):
            memory[rows] = self._rows[rows, start + model.rows[place][i]]
        t = self._rows[:, self._layout.places["t"]]
        for left in self._departures.get(pair, ()):
            memory[t > left.t] += left.memory[i]
        return memory


def places(model: NearModel, lists: np.ndarray, pairs: np.ndarray) -> np.ndarray:
    """Return the places of pairs (n,) in lists (n, size)."""
    columns: np.ndarray = np.argmax(lists[:, : model.k] == pairs[:, None], axis=1)
    return columns
