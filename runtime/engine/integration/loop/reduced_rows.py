"""Rows of a run by a reduced model, of which only the columns that the model has are stored."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from hertzwerk.runtime.engine.integration.step.layout import Layout

NONE = -1  # column of the reduced model's state, of what it does not have


class Columns:
    """Places of the entries of a vector of a reduced model in that of the whole."""

    def __init__(self, own: Layout, whole: Layout, entries: dict[str, list[int]]) -> None:
        places = [
            whole.places[name] + i for name, size in own.sizes.items() for i in [*entries.get(name, range(size))][:size]
        ]
        self.size, self.others = whole.size, np.setdiff1d(np.arange(whole.size), places)
        self.own = np.full(whole.size, NONE)
        self.own[places] = np.arange(own.size)
        self.places = np.array(places)


class ReducedRows:
    """States (n, ns) of the whole model, read by rows and slices of columns as arrays.

    own    (n, size) of the reduced model; others: state of the whole (ns), in which the other entries are those of all rows
    """

    def __init__(self, own: np.ndarray, columns: Columns, others: np.ndarray) -> None:
        self.own, self.columns, self.others = own, columns, others

    def __len__(self) -> int:
        return len(self.own)

    @property
    def nbytes(self) -> int:
        """Bytes that are stored."""
        return self.own.nbytes

    @property
    def shape(self) -> tuple[int, int]:
        """Shape of the whole model's states."""
        return len(self.own), self.columns.size

    def __getitem__(self, key: Any) -> Any:
        rows, columns = key if isinstance(key, tuple) else (key, slice(None))
        own, places, others = self.own[rows], self.columns.own[columns], self.others[columns]
        if places.ndim == 0:
            return own[..., places] if places != NONE else np.full(own.shape[:-1], others)
        if len(places) == self.columns.size:
            read = np.empty((*own.shape[:-1], len(places)))
            read[:], read[..., self.columns.places] = others, own
            return read
        if len(places) and places[0] != NONE and np.all(places == places[0] + np.arange(len(places))):
            return own[..., places[0] : places[-1] + 1]
        read = np.empty((*own.shape[:-1], len(places)))
        for i, (place, other) in enumerate(zip(places.tolist(), others.tolist(), strict=True)):
            read[..., i] = other if place == NONE else own[..., place]
        return read

    def __setitem__(self, key: tuple[int, int], value: float) -> None:
        row, column = key
        self.own[row, self.columns.own[column]] = value

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        return np.asarray(self[:], dtype)

    def compress(self, condition: np.ndarray, axis: int = 0) -> ReducedRows:
        """Return a copy of the rows at which a condition holds."""
        return ReducedRows(self.own.compress(condition, axis=axis), self.columns, self.others)

    def of(self, rows: np.ndarray | ReducedRows) -> np.ndarray | None:
        """Return the columns that are stored of other rows; None where these differ in another."""
        if isinstance(rows, ReducedRows):
            own, others = rows.own if rows.columns is self.columns else None, rows.others
        else:
            own, others = rows[:, self.columns.places], rows
        shared = self.columns.others
        return own if np.all(others[..., shared] == self.others[shared]) else None


Rows = np.ndarray | ReducedRows


def first_of(rows: Rows, count: int) -> Rows:
    """Return the first rows; a view of them."""
    return ReducedRows(rows.own[:count], rows.columns, rows.others) if isinstance(rows, ReducedRows) else rows[:count]


def joined(parts: Sequence[Rows]) -> Rows:
    """Return all rows in one piece, reduced where those of one reduced model suffice."""
    if ReducedRows in set(map(type, parts)):
        reduced = next(part for part in parts if isinstance(part, ReducedRows))
        own = [values for part in parts if (values := reduced.of(part)) is not None]
        if len(own) == len(parts):
            return ReducedRows(np.concatenate(own), reduced.columns, reduced.others)
    return np.concatenate(parts)
