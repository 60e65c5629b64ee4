"""Rows of a design that a store lacks: looked for in batches, as workers become free."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from hertzwerk.runtime.sweeps.following import key_after
from hertzwerk.runtime.sweeps.kept.row import Packed, Row
from hertzwerk.runtime.sweeps.points.definition import Keys
from hertzwerk.runtime.sweeps.points.design import Design
from hertzwerk.runtime.sweeps.store import Store

BATCH = 256  # points whose keys are made together


class ToDo:
    """Rows that are to be computed and stored, each key once.

    Of a point that is not under way it knows one byte: whether its row is there.

    progress    called with the fraction of points whose rows are there
    """

    def __init__(
        self, design: Design, keys: Keys, store: Store, progress: Callable[[float], object] | None = None
    ) -> None:
        self._design, self._keys, self._store, self._progress = design, keys, store, progress
        self._done = store.done(len(design))
        self._there = self._done.count(1)
        self._key: dict[int, str] = {}  # of rows under way
        self._points: dict[str, list[int]] = {}  # that wait for a row under way, by its key

    @property
    def left(self) -> int:
        """Number of points whose rows are not known to be there."""
        return len(self._done) - self._there

    def missing(self) -> Iterator[int]:
        """Yield the rows to compute, in the order of the design."""
        place = 0
        while (place := self._done.find(0, place)) >= 0:
            batch = range(place, min(place + BATCH, len(self._done)))
            yield from self.wanted({i: self._keys.of(self._design[i]) for i in batch if not self._done[i]})
            place += BATCH

    def died(self) -> Iterator[int]:
        """Yield the rows whose process died in an earlier call."""
        for number, key in self._store.died().items():
            self._key[number], self._points[key] = key, [number]
            yield number

    def keys(self, after: Mapping[int, str]) -> dict[int, str]:
        """Return the key of every row, given that of the row before it."""
        known = self._store.keys(after)
        return {i: known.get(i) or key_after(self._keys.of(self._design[i]), key) for i, key in after.items()}

    def wanted(self, keys: Mapping[int, str]) -> list[int]:
        """Return the rows that are neither there nor under way, of rows by their keys."""
        there, found = self._store.found(keys.values()), []
        known = {i: key for i, key in keys.items() if key in there and not self._done[i]}
        if known:
            self._store.add({}, known)
            self._mark(known)
        for i, key in keys.items():
            if key not in there:
                if key not in self._points:
                    self._key[i] = key
                    found.append(i)
                self._points.setdefault(key, []).append(i)
        return found

    def store(self, rows: Iterable[Row]) -> None:
        """Store rows that were under way; raises sqlite3.Error."""
        done = {self._key.pop(row.index): row for row in rows}
        points = {i: key for key in done for i in self._points.pop(key)}
        self._store.add(done, points)
        self._mark(points)

    def end_of(self, key: str) -> Packed | None:
        """Return the final state of a row that is there, None where it got to no end."""
        return self._store.end_of(key)

    def _mark(self, points: Iterable[int]) -> None:
        for i in points:
            self._there += not self._done[i]
            self._done[i] = 1
        self.tell()

    def tell(self) -> None:
        """Report the progress."""
        if self._progress is not None:
            self._progress(self._there / max(len(self._done), 1))
