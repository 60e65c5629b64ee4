"""Solution of symmetric systems on a tape: L D L^T without pivoting, structural zeros skipped."""

from __future__ import annotations

from heapq import heappop, heappush
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.algebra.vectors import less, product
from hertzwerk.derive.program.program import Tape


class Factor:
    """L D L^T of a symmetric matrix with named rows, unrolled on a tape, without pivoting."""

    def __init__(self, tape: Tape, order: list[str], matrix: dict[tuple[str, str], Any]) -> None:
        self.names, self._tape = order, tape
        self._label = label = {name: name.replace(".", "_") for name in order}
        self._before: dict[str, dict[str, Any]] = {name: {} for name in order}  # row of L left of its diagonal
        self._after: dict[str, dict[str, Any]] = {name: {} for name in order}  # column of L below its diagonal
        self.diagonal: dict[str, Any] = {}
        place = {name: i for i, name in enumerate(order)}
        coupled: dict[str, list[int]] = {name: [] for name in order}
        for row, k in matrix:
            if place.get(k, len(order)) < place.get(row, -1):
                coupled[row].append(place[k])
        for row in order:
            work: dict[str, Any] = {}
            pending = sorted(coupled[row])  # a heap: columns of the matrix, then those that elimination fills in
            known = set(pending)
            while pending:
                k = order[heappop(pending)]
                terms = [product(lower, work[j]) for j, lower in self._before[k].items() if j in work]
                value = tape.let(less(matrix.get((row, k), sp.S.Zero), *terms), f"L_{label[row]}_{label[k]}")
                if value == 0:
                    continue
                work[k] = value
                filled = {place[name] for name in self._after[k]} - known
                for column in filled:
                    heappush(pending, column)
                known |= filled
                quotient = tape.let(value / self.diagonal[k], f"l_{label[row]}_{label[k]}")
                self._before[row][k] = self._after[k][row] = quotient
            terms = [product(lower, work[k]) for k, lower in self._before[row].items()]
            self.diagonal[row] = tape.let(less(matrix[row, row], *terms), f"D_{label[row]}")

    def solve(self, right: dict[str, Any], label: str) -> dict[str, Any]:
        """Solve for one right-hand side by forward and back substitution."""
        tape, zero = self._tape, sp.S.Zero
        solved: dict[str, Any] = {}
        for row in self.names:
            terms = [product(lower, solved[k]) for k, lower in self._before[row].items() if solved[k] is not zero]
            value = less(right[row], *terms)
            solved[row] = tape.let(value, f"y_{self._label[row]}") if self._before[row] and value is not zero else value
        result: dict[str, Any] = {}
        for row in reversed(self.names):
            terms = [product(lower, result[k]) for k, lower in self._after[row].items() if result[k] is not zero]
            value = zero if solved[row] is zero else solved[row] / self.diagonal[row]
            result[row] = (
                tape.let(less(value, *terms), f"{self._label[row]}_{label}") if terms or value is not zero else value
            )
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
