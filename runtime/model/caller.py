"""CasADi functions called through their buffers: for one state, or row by row over a table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

BLOCKS = (256, 64, 16, 4, 1)  # rows per call of a mapped function


class Caller:
    """CasADi function of dense vectors called through its buffer; arguments and results are NumPy arrays."""

    def __init__(self, function: Any) -> None:
        self.name: str = function.name()
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

    def read(self, i: int, values: np.ndarray) -> None:
        """Take argument i from an array itself, which has to live as long; `inputs[i]` is its own."""
        self._buffer.set_arg(i, values.data)


def _table(size: tuple[int, int]) -> np.ndarray:
    """Return an array for a CasADi matrix: a column there is a row here."""
    rows, columns = size
    return np.zeros((columns, rows))


@dataclass(frozen=True)
class Callers:
    """Pool of callers of one function: threads never share one, and memory is reused between runs."""

    function: Any
    _free: list[Caller] = field(default_factory=list)

    def __call__(self, *arguments: float | np.ndarray) -> list[np.ndarray]:
        """Evaluate on numbers and vectors.

        A result of one column is a vector, any other has its shape (rows, columns).
        """
        caller = self.take()
        for place, value in zip(caller.inputs, arguments, strict=True):
            place[:] = value
        results = [x[0].copy() if len(x) == 1 else x.T.copy() for x in caller()]
        self.give_back(caller)
        return results

    def take(self) -> Caller:
        """Return a caller for exclusive use."""
        try:
            return self._free.pop()
        except IndexError:
            return Caller(self.function)

    def give_back(self, caller: Caller) -> None:
        """Return a caller to the pool."""
        self._free.append(caller)


class Blocks:
    """Function of one row made one of blocks of fixed sizes, once, so that a call builds nothing.

    functions  of those blocks, by `sizes`, the largest first
    """

    def __init__(self, sizes: Sequence[int], functions: Sequence[Any]) -> None:
        self._sizes, self.functions = sizes, functions
        self.use(functions)

    @property
    def compiled(self) -> bool:
        """Return whether other functions than `functions` are called."""
        return self._blocks[0][1].function is not self.functions[0]

    def use(self, functions: Sequence[Any]) -> None:
        """Call these functions in place of `functions`: the same, compiled."""
        self._blocks = [(rows, Callers(function)) for rows, function in zip(self._sizes, functions, strict=True)]


class Scan(Blocks):
    """CasADi function of what is carried from row to row of a table, applied one after another.

    function    (carried, row) -> carried
    """

    def __init__(self, function: Any) -> None:
        self._width = function.size1_out(0)
        many, made = function, {1: function}
        for kind, count in ((ca.SX, 4), (ca.MX, 8), (ca.MX, 8)):  # the innermost are written out: a call costs
            columns = many.size2_in(1)
            carried, rows = given = [
                kind.sym(name, many.size1_in(i), count * columns if i else 1)
                for i, name in enumerate(("carried", "rows"))
            ]
            found: list[Any] = []
            for part in ca.horzsplit(rows, columns):
                found.append(many(found[-1][:, -1] if found else carried, part))
            many = ca.Function(f"{function.name()}_{count * columns}", given, [ca.horzcat(*found)])
            made[count * columns] = many
        sizes = sorted(made, reverse=True)
        super().__init__(sizes, [made[size] for size in sizes])

    def __call__(self, carried: np.ndarray, table: np.ndarray) -> np.ndarray:
        """Return what is carried after each row of a table, shape (rows, size); rows are read where they are."""
        table = np.ascontiguousarray(table)
        count, first, found = len(table), 0, np.empty((len(table), self._width))
        for rows, callers in self._blocks:
            if count - first < rows:
                continue
            caller = callers.take()
            while count - first >= rows:
                caller.inputs[0][:] = carried
                caller.read(1, table[first : first + rows])
                found[first : first + rows] = caller()[0]
                first += rows
                carried = found[first - 1]
            caller.read(1, caller.inputs[1])
            callers.give_back(caller)
        return found


class Rowwise(Blocks):
    """CasADi function of columns, applied to tables row by row; one argument is the same for all rows.

    A call computes no surplus rows.
    """

    def __init__(self, function: Any, constant: int) -> None:
        self._constant = constant
        self._widths = [function.size1_out(i) for i in range(function.n_out())]
        name = function.name()
        super().__init__(BLOCKS, [function.map(f"{name}_{rows}", "serial", rows, [constant], []) for rows in BLOCKS])

    def __call__(self, constant: np.ndarray, *tables: np.ndarray) -> list[np.ndarray]:
        """Return results (rows, size) for the other arguments' tables (rows, size), in the function's order."""
        count, first = len(tables[0]), 0
        results = [np.empty((count, size)) for size in self._widths]
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
