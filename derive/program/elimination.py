"""Solution of symmetric systems on a tape: L D L^T without pivoting, structural zeros skipped."""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.algebra.vectors import less, product
from hertzwerk.derive.program.program import Tape


class Factor:
    """L D L^T of a symmetric matrix with named rows, unrolled on a tape, without pivoting."""

    def __init__(self, tape: Tape, order: list[str], matrix: dict[tuple[str, str], Any]) -> None:
        self.names, self._tape = order, tape
        self._label = label = {name: name.replace(".", "_") for name in order}
        self._lower: dict[tuple[str, str], Any] = {}
        self.diagonal: dict[str, Any] = {}
        work: dict[tuple[str, str], Any] = {}
        for i, row in enumerate(order):
            known: list[str] = []
            for k in order[:i]:
                terms = [product(self._lower[k, j], work[row, j]) for j in known if (k, j) in self._lower]
                value = tape.let(less(matrix.get((row, k), sp.S.Zero), *terms), f"L_{label[row]}_{label[k]}")
                if value != 0:
                    known.append(k)
                    work[row, k] = value
                    self._lower[row, k] = tape.let(value / self.diagonal[k], f"l_{label[row]}_{label[k]}")
            terms = [product(self._lower[row, j], work[row, j]) for j in known]
            self.diagonal[row] = tape.let(less(matrix[row, row], *terms), f"D_{label[row]}")

    def solve(self, right: dict[str, Any], label: str) -> dict[str, Any]:
        """Solve for one right-hand side by forward and back substitution."""
        tape, order, lower = self._tape, self.names, self._lower
        solved: dict[str, Any] = {}
        for i, row in enumerate(order):
            terms = [product(lower[row, k], solved[k]) for k in order[:i] if (row, k) in lower]
            solved[row] = tape.let(less(right[row], *terms), f"y_{self._label[row]}") if terms else right[row]
        result: dict[str, Any] = {}
        for i in reversed(range(len(order))):
            row = order[i]
            terms = [product(lower[k, row], result[k]) for k in order[i + 1 :] if (k, row) in lower]
            result[row] = tape.let(less(solved[row] / self.diagonal[row], *terms), f"{self._label[row]}_{label}")
        return result


def minimum_degree_order(names: list[str], matrix: dict[tuple[str, str], Any]) -> list[str]:
    """Order of elimination with little fill-in: next is always the name coupled to the fewest others."""
    tied = {name: {other for other in names if other != name and (name, other) in matrix} for name in names}
    order = []
    while tied:
        name = min(tied, key=lambda n: len(tied[n]))  # in case of a tie the first declared
        order.append(name)
        others = tied.pop(name)
        for other in others:
            tied[other] = (tied[other] | others) - {name, other}
    return order
