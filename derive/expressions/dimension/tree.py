"""Tree of an expression, from text or from SymPy: operations as written, nothing simplified."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

COMPARISONS = ("<", "<=", ">", ">=", "==", "!=")


@dataclass(frozen=True, slots=True, eq=False)
class Node:
    """One operation as written: `source[start:end]` of a text, or the SymPy expression `expr`.

    `op` is number, name, pi, inf, sum, product, neg, inverse, **, @, matrix, a comparison sign, and, or, not, true,
    or the name of a function. A sum of a text holds `a - b` as (a, neg b), a product `a/b` as (a, inverse b); `spans`
    are the positions of their operands, parentheses included. where holds its conditions, then its branches; diff (f,
    x, x) for the second derivative with respect to x, integrate (f, x) or (f, x, lower, upper), a matrix its entries
    row by row.
    """

    op: str
    start: int = 0
    end: int = 0
    args: tuple[Node, ...] = ()
    name: Any = ""  # text, or a SymPy symbol
    number: Any = None  # the value: of a text, if no name stands in it (of a condition 1 or 0); of a SymPy expression, if it is one number
    shape: tuple[int, int] | None = None  # of a matrix
    spans: tuple[tuple[int, int], ...] = ()
    power: float = 1.0  # bound on the total of nested exponents that are numbers
    branches: int = 0  # arguments of min and max in it
    nested: int = 0  # functions in each other's arguments, itself included
    expr: Any = None

    @property
    def condition(self) -> bool:
        """Whether it is true or false rather than a quantity."""
        return self.op in COMPARISONS or self.op in ("and", "or", "not", "true")

    def walk(self) -> Iterator[Node]:
        """Yield the node and all below it, in the order written."""
        yield self
        for arg in self.args:
            yield from arg.walk()
