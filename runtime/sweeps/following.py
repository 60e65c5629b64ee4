"""Values followed one after another: each row starts from the final state of the one before.

Rows that differ in the followed parameter alone are a chain, from its smallest value up or its largest down. A chain is
computed in order, several of them side by side. The key of a row contains that of the row before, so the start that
it continued from. A row that did not get to its end hands on the start that it had.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Collection, Generator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace

import numpy as np

from hertzwerk.derive.faults import Fault, shown
from hertzwerk.runtime.inputs.choices import numbers_of
from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.model.si_values import latch_units, si_of
from hertzwerk.runtime.sweeps.batch import Batch
from hertzwerk.runtime.sweeps.kept.array_table import Packed
from hertzwerk.runtime.sweeps.kept.kept_arrays import END
from hertzwerk.runtime.sweeps.sweep_table import Row

DIRECTIONS = ("up", "down")


@dataclass(frozen=True)
class Chains:
    """Rows in the order in which they follow each other."""

    model: Model
    sets: Sequence[Mapping[str, Value]]
    rows: tuple[tuple[int, ...], ...]

    @property
    def length(self) -> int:
        """Number of rows of the longest."""
        return max(map(len, self.rows), default=0)

    def keys(self, keys: Sequence[str]) -> list[str]:
        """Return the keys of the rows, each with that of the row before it."""
        found = list(keys)
        for chain in self.rows:
            before = ""
            for i in chain:
                found[i] = before = hashlib.sha256(f"{keys[i]} after {before}".encode()).hexdigest()[:32]
        return found

    def computed(
        self, batch: Batch, keys: Sequence[str], left: Collection[int], end_of: Callable[[str], Packed | None]
    ) -> Generator[list[Row], None, None]:
        """Yield the rows that are left as they are done, some at a time.

        end_of    final state of a row that is stored, by its key
        """
        starts: list[dict[str, Value]] = [{} for _ in self.rows]
        ends: dict[str, Packed | None] = {}
        for k in range(self.length):
            here = {chain[k]: number for number, chain in enumerate(self.rows) if k < len(chain)}
            waiting = [i for i in here if i in left]
            if waiting:
                with closing(batch.rows(waiting, starts={i: starts[here[i]] for i in waiting})) as done:
                    for some in done:
                        ends |= {keys[row.index]: row.arrays.get(END) for row in some}
                        yield [self._as_given(row) for row in some]
            for i, number in here.items():
                key = keys[i]
                end = ends[key] if key in ends else end_of(key)
                if end is not None:
                    starts[number] = self._start(end.array)

    def _as_given(self, row: Row) -> Row:
        """Return a row with the values of its point, without the start that it continued from."""
        given = dict(self.sets[row.index])
        return replace(row, given=given, values=numbers_of(self.model, given))

    def _start(self, end: np.ndarray) -> dict[str, Value]:
        """Return the initial values that a final state is."""
        units, latches = state_units(self.model), self.model.latches
        values = zip(units.items(), end, strict=True)
        return {name: (float(value), unit) for (name, unit), value in values if value > 0 or name not in latches}


def state_units(model: Model) -> dict[str, str]:
    """Return the units of what is handed on: coordinates, speeds, latches of contacts in progress."""
    states = {name: model.units[name] for name in (*model.coordinates, *model.speeds)}
    return {**states, **latch_units(model)}


def read_chains(
    model: Model,
    sets: Sequence[Mapping[str, Value]],
    over: Mapping[str, object],
    continued: object,
    faults: list[Fault],
) -> Chains | None:
    """Return the chains along the first parameter that is varied; bad input is appended to `faults`."""
    if continued is None:
        return None
    if continued not in DIRECTIONS:
        faults.append(Fault("continued", shown(continued), "up or down"))
    if model.joints is not model:
        found = "a model in absolute coordinates: it ends in states of bodies, a start has those of joints, and nothing turns one into the other"
        faults.append(Fault("continued", found, "a model in joint coordinates", 'coordinates="tree"'))
    name = next((name for name in over if name in model.parameters), None)
    if name is None:
        faults.append(Fault("continued", "no parameter that is varied", "one to follow, among what is varied"))
    if faults or name is None:
        return None
    chains: dict[str, list[int]] = {}
    for i, values in enumerate(sets):
        others = {other: value for other, value in values.items() if other != name}
        chains.setdefault(repr(others), []).append(i)
    order = 1 if continued == "up" else -1
    followed = [si_of(model, name, values[name]) for values in sets]
    rows = (sorted(chain, key=lambda i: order * followed[i]) for chain in chains.values())
    return Chains(model, sets, tuple(map(tuple, rows)))
