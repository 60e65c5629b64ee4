"""Values followed one after another: each row starts from the final state of the one before.

Rows that differ in the followed parameter alone are a chain, from its smallest value up or its largest down. A chain is
computed in order, several of them side by side. The key of a row contains that of the row before, so the start that
it continued from. A row that did not get to its end hands on the start that it had.
"""

from __future__ import annotations

import hashlib
from collections.abc import Generator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from math import prod
from typing import Any, Protocol

import numpy as np

from hertzwerk.derive.common.faults import Fault, among, shown
from hertzwerk.runtime.engine.inputs.inputs_by_row import numbers_of
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.si_values import latch_units, si_of
from hertzwerk.runtime.studies.sweeps.batch import Batch
from hertzwerk.runtime.studies.sweeps.points.design_points import Design
from hertzwerk.runtime.studies.sweeps.rows.row import Packed, Row
from hertzwerk.runtime.studies.sweeps.rows.row_arrays import END

DIRECTIONS = ("up", "down")
TOGETHER = 1000  # chains side by side


class Ledger(Protocol):
    """Rows that are there, by their keys."""

    def keys(self, after: Mapping[int, str]) -> dict[int, str]:
        """Return the key of every row, given that of the row before it, "" of the first."""

    def wanted(self, keys: Mapping[int, str]) -> list[int]:
        """Return the rows that are to be computed, each key once."""

    def end_of(self, key: str) -> Packed | None:
        """Return the final state of a row that is there, None where it got to no end."""


class InMemory:
    """Ledger of rows that are nowhere but in memory: all are wanted, by their numbers."""

    def __init__(self) -> None:
        self._ends: dict[str, Packed | None] = {}

    def noted(self, made: Generator[list[Row], None, None]) -> Generator[list[Row], None, None]:
        """Yield rows, and note their final states."""
        with closing(made):
            for rows in made:
                self._ends |= {str(row.index): row.arrays.get(END) for row in rows}
                yield rows

    def keys(self, after: Mapping[int, str]) -> dict[int, str]:
        """Return the numbers of rows as their keys."""
        return {i: str(i) for i in after}

    def wanted(self, keys: Mapping[int, str]) -> list[int]:
        """Return all."""
        return list(keys)

    def end_of(self, key: str) -> Packed | None:
        """Return the final state of a row, None where it got to no end."""
        return self._ends.get(key)


def key_after(key: str, before: str) -> str:
    """Return the key of a row that continues another."""
    return hashlib.sha256(f"{key} after {before}".encode()).hexdigest()[:32]


@dataclass(frozen=True)
class Grid(Sequence[Sequence[int]]):
    """Chains of a grid of points along one axis.

    order    places on the axis; `stride` is the number of points from one of them to the next
    """

    order: Sequence[int]
    stride: int
    chains: int

    def __len__(self) -> int:
        return self.chains

    def __getitem__(self, i: Any) -> Any:
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(self.chains))]
        outer, inner = divmod(i, self.stride)
        first = outer * self.stride * len(self.order) + inner
        return [first + self.stride * k for k in self.order]


@dataclass(frozen=True)
class Chains:
    """Rows in the order in which they follow each other."""

    model: EngineModel
    sets: Design
    rows: Sequence[Sequence[int]]

    def computed(self, batch: Batch, ledger: Ledger) -> Generator[list[Row], None, None]:
        """Yield the rows that are missing as they are done, some at a time.

        What is yielded is to be there, in the ledger, before the next are wanted.
        """
        for begin in range(0, len(self.rows), TOGETHER):
            chains = self.rows[begin : begin + TOGETHER]
            starts: list[dict[str, Value]] = [{} for _ in chains]
            before = [""] * len(chains)
            for k in range(max(map(len, chains))):
                here = {chain[k]: number for number, chain in enumerate(chains) if k < len(chain)}
                keys = ledger.keys({i: before[number] for i, number in here.items()})
                waiting = ledger.wanted(keys)
                if waiting:
                    following = {i: starts[here[i]] for i in waiting}
                    with closing(batch.rows(waiting, starts=following, count=len(waiting))) as done:
                        for some in done:
                            yield [self._without_start(row) for row in some]
                for i, number in here.items():
                    before[number] = keys[i]
                    end = ledger.end_of(keys[i])
                    if end is not None:
                        starts[number] = self._start(end.array)

    def _without_start(self, row: Row) -> Row:
        """Return a row with the values of its point, without the start that it continued from."""
        stated = self.sets[row.index]
        return replace(row, stated=stated, values=numbers_of(self.model, stated))

    def _start(self, end: np.ndarray) -> dict[str, Value]:
        """Return the initial values that a final state is."""
        units, latches = state_units(self.model), self.model.latches
        values = zip(units.items(), end, strict=True)
        return {name: (float(value), unit) for (name, unit), value in values if value > 0 or name not in latches}


def state_units(model: EngineModel) -> dict[str, str]:
    """Return the units of what is handed on: coordinates, speeds, latches of contacts in progress."""
    states = {name: model.units[name] for name in (*model.coordinates, *model.speeds)}
    return {**states, **latch_units(model)}


def read_chains(
    model: EngineModel,
    sets: Design,
    over: Mapping[str, object],
    continued: object,
    faults: list[Fault],
) -> Chains | None:
    """Return the chains along the first parameter that is varied; bad input is appended to `faults`."""
    if continued is None:
        return None
    if not among(continued, *DIRECTIONS):
        faults.append(Fault("continued", shown(continued), "up or down"))
    if model.joints is not model:
        actual = "a model in absolute coordinates: it ends in states of bodies, a start has those of joints, which cannot be converted"
        faults.append(Fault("continued", actual, "a model in joint coordinates", 'coordinates="tree"'))
    name = next((name for name in over if name in model.parameters), None)
    if name is None:
        faults.append(Fault("continued", "no parameter that is varied", "one to follow, among what is varied"))
    if faults or name is None:
        return None
    order = 1 if continued == "up" else -1
    if name in sets.grid:
        axis: list[Any] = list(sets.grid[name])
        after = list(sets.grid)[list(sets.grid).index(name) + 1 :]
        followed = [order * si_of(model, name, value) for value in axis]
        places = sorted(range(len(axis)), key=followed.__getitem__)
        return Chains(model, sets, Grid(places, prod(len(sets.grid[one]) for one in after), len(sets) // len(axis)))
    chains: dict[str, list[int]] = {}
    for i, values in enumerate(sets):
        others = {other: value for other, value in values.items() if other != name}
        chains.setdefault(repr(others), []).append(i)
    followed = [order * si_of(model, name, values[name]) for values in sets]
    return Chains(model, sets, [sorted(chain, key=followed.__getitem__) for chain in chains.values()])
