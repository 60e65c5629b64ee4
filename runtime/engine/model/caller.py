"""CasADi functions called through their buffers: for one state, or row by row over a table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

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


def _table(size: tuple[int, int]) -> np.ndarray:
    """Return an array for a CasADi matrix: a column there is a row here."""
    rows, columns = size
    return np.zeros((columns, rows))


@dataclass(frozen=True)
class Callers:
    """Pool of callers of one function: threads never share one, and memory is reused between runs.

    make: makes a caller of the function
    """

    function: Any
    make: Callable[[Any], Caller] = Caller
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
            return self.make(self.function)

    def give_back(self, caller: Caller) -> None:
        """Return a caller to the pool."""
        self._free.append(caller)


class Rowwise:
    """CasADi function of columns, applied to tables row by row; one argument may be the same for all rows.

    It is mapped over blocks of fixed sizes, once, so that a call builds nothing and computes no surplus rows.

    functions  of those blocks, the largest first
    """

    def __init__(self, function: Any, constant: int | None) -> None:
        self._constant = constant
        self._widths = [function.size1_out(i) for i in range(function.n_out())]
        name, same = function.name(), [] if constant is None else [constant]
        self.functions = [function.map(f"{name}_{rows}", "serial", rows, same, []) for rows in BLOCKS]
        self.use(self.functions)

    @property
    def compiled(self) -> bool:
        """Return whether other functions than `functions` are called."""
        return self._blocks[0][1].function is not self.functions[0]

    def use(self, functions: Sequence[Any]) -> None:
        """Call these functions in place of `functions`: the same, compiled."""
        self._blocks = [(rows, Callers(function)) for rows, function in zip(BLOCKS, functions, strict=True)]

    def __call__(self, *arguments: np.ndarray) -> list[np.ndarray]:
        """Return results (rows, size) for tables (rows, size) of arguments, after the constant one."""
        constant, tables = (None, arguments) if self._constant is None else (arguments[0], arguments[1:])
        count, first = len(tables[0]), 0
        results = [np.empty((count, size)) for size in self._widths]
        for rows, callers in self._blocks:
            if count - first < rows:
                continue
            caller = callers.take()
            inputs = list(caller.inputs)
            if self._constant is not None:
                inputs.pop(self._constant)[:] = constant
            while count - first >= rows:
                block = slice(first, first + rows)
                for place, table in zip(inputs, tables, strict=True):
                    place[:] = table[block]
                for table, values in zip(results, caller(), strict=True):
                    table[block] = values
                first += rows
            callers.give_back(caller)
        return results
