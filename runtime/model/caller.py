"""CasADi functions called through their buffers: one state after the other, or row by row over a whole table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

BLOCKS = (256, 16, 1)  # rows per call of a mapped function


class Caller:
    """A CasADi function of dense vectors called through its buffer: inputs and results stay NumPy arrays."""

    def __init__(self, function: Any) -> None:
        self._buffer, self._evaluate = function.buffer()
        self.inputs = [_table(function.size_in(i)) for i in range(function.n_in())]
        self.results = [_table(function.size_out(i)) for i in range(function.n_out())]
        for i, values in enumerate(self.inputs):
            self._buffer.set_arg(i, values.data)
        for i, values in enumerate(self.results):
            self._buffer.set_res(i, values.data)

    def __call__(self) -> list[np.ndarray]:
        """Evaluate on `inputs`; the arrays returned are overwritten by the next call."""
        self._evaluate()
        return self.results


def _table(size: tuple[int, int]) -> np.ndarray:
    """An array for a matrix of CasADi's: a column there is a row here."""
    rows, columns = size
    return np.zeros((columns, rows))


@dataclass(frozen=True)
class Callers:
    """Callers of one function, made when none is free: two threads never share one, and a second run pays for no new memory."""

    function: Any
    _free: list[Caller] = field(default_factory=list)

    def take(self) -> Caller:
        """A caller for one user at a time."""
        try:
            return self._free.pop()
        except IndexError:
            return Caller(self.function)

    def give_back(self, caller: Caller) -> None:
        """The caller is free for the next user."""
        self._free.append(caller)


class Rowwise:
    """A CasADi function of columns, one input of which is the same for all rows, over tables of rows; each row as if it were alone.

    It is mapped to blocks of fixed sizes, once: a call builds nothing, and computes no row that nobody asked for.
    """

    def __init__(self, function: Any, constant: int) -> None:
        self._constant = constant
        self._sizes = [function.size1_out(i) for i in range(function.n_out())]
        self._blocks = [
            (rows, Callers(function.map(f"{function.name()}_{rows}", "serial", rows, [constant], [])))
            for rows in BLOCKS
        ]

    def __call__(self, constant: np.ndarray, *tables: np.ndarray) -> list[np.ndarray]:
        """Results (rows, size) of the other inputs' tables (rows, size), in the function's order."""
        count, first = len(tables[0]), 0
        results = [np.empty((count, size)) for size in self._sizes]
        for rows, callers in self._blocks:
            if count - first < rows:
                continue
            caller = callers.take()
            inputs = list(caller.inputs)
            inputs.pop(self._constant)[:] = constant
            while count - first >= rows:
                self._block(caller, inputs, tables, results, slice(first, first + rows))
                first += rows
            callers.give_back(caller)
        return results

    @staticmethod
    def _block(
        caller: Caller,
        inputs: Sequence[np.ndarray],
        tables: Sequence[np.ndarray],
        results: Sequence[np.ndarray],
        rows: slice,
    ) -> None:
        for place, table in zip(inputs, tables, strict=True):
            place[:] = table[rows]
        for table, values in zip(results, caller(), strict=True):
            table[rows] = values
