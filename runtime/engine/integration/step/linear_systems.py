"""Linear systems of implicit methods, (I - h gamma J) x = r, by elimination unrolled in the graph.

The structure of J, known when the graph is built, does most of the work. Coordinates whose rates are speeds alone
have the pivot 1 and go first, which leaves (I - h gamma df/du - (h gamma)^2 df/dq dq'/du) for the speeds; unknowns
that no equation depends on, such as the energy ledger, follow by substitution. (CasADi's csparse, lapackqr and
symbolicqr generate no C.)

Without row exchanges a pivot may be small by chance; the caller checks the solution (`implicit_step`), and a shorter step
is nearer to I.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import casadi as ca

PIVOTED = 4  # most unknowns with row exchanges by size; beyond, the order is structural: I - h gamma J is sparse and near M + h C + h^2 K


@dataclass(frozen=True)
class Elimination:
    """Factorised MX system: `known` holds the factors, `solve` is the function (known, r) -> x."""

    known: Any
    solve: Any

    def __call__(self, r: Any) -> Any:
        """Return x (n)."""
        return self.solve(self.known, r)


def solver_of_calls(jacobian: Any, step: Any, nq: int) -> Elimination:
    """Build the solver of an MX matrix J from two functions: eliminate once, then solve."""
    shape = jacobian.sparsity()
    eliminate, solve = _elimination(shape.size1(), tuple(shape.colind()), tuple(shape.row()), nq)
    return Elimination(eliminate(jacobian, step), solve)


@lru_cache(maxsize=8)
def _elimination(n: int, colind: tuple[int, ...], row: tuple[int, ...], nq: int) -> tuple[Any, Any]:
    """Build the CasADi functions (J, step) -> known and (known, r) -> x for one sparsity pattern."""
    J, h, r = ca.SX.sym("J", ca.Sparsity(n, n, colind, row)), ca.SX.sym("h"), ca.SX.sym("r", n)
    entries: list[Any] = []
    symbols: list[Any] = []

    def keep(entry: Any) -> Any:
        if entry.is_constant():
            return entry
        entries.append(entry)
        symbols.append(ca.SX.sym("entry"))
        return symbols[-1]

    solved = solver(J, h, nq, keep)(r)
    eliminate = ca.Function("eliminate", [J, h], [ca.vertcat(ca.SX(0, 1), *entries)])
    return eliminate, ca.Function("solve", [ca.vertcat(ca.SX(0, 1), *symbols), r], [solved])


def solver(jacobian: Any, step: Any, nq: int, keep: Callable[[Any], Any] = lambda entry: entry) -> Callable[[Any], Any]:
    """Return r (n) -> x (n) with (I - step J) x = r, for an SX matrix J (n, n).

    The first nq rows of J are the coordinates'. keep: replaces an entry that does not depend on r, to be stored.
    """
    n = jacobian.size1()
    matrix = {(i, j): -step * jacobian[i, j] for i, j in zip(*jacobian.sparsity().get_triplet(), strict=True)}
    columns = {j for _, j in matrix}
    last = [i for i in range(n) if i not in columns]
    first: list[int] = []
    for i in range(min(nq, n)):
        if i not in last and not any((i, j) in matrix or (j, i) in matrix for j in (*first, i)):
            first.append(i)
    core = [i for i in range(n) if i not in last and i not in first]
    if len(core) > PIVOTED:
        core = _ordered(core, first, matrix)
    reduced = [
        [
            matrix.get((i, j), ca.SX(0)) + (i == j) - _dot(_row(matrix, i, first), _column(matrix, first, j))
            for j in core
        ]
        for i in core
    ]
    solve_core = eliminated(reduced, pivoting=len(core) <= PIVOTED, keep=keep)
    of_core, of_first, of_last = (
        [{j: keep(entry) for j, entry in _row(matrix, i, columns).items()} for i in rows]
        for rows, columns in ((core, first), (first, core), (last, first + core))
    )

    def solve(r: Any) -> Any:
        known = [r[i] - _times(row, r) for i, row in zip(core, of_core, strict=True)]
        x = dict(zip(core, solve_core(known), strict=True))
        for rows, entries in ((first, of_first), (last, of_last)):
            x |= {i: r[i] - _times(row, x) for i, row in zip(rows, entries, strict=True)}
        return ca.vertcat(*(x[i] for i in range(n)))

    return solve


def eliminated(
    a: list[list[Any]], *, pivoting: bool, keep: Callable[[Any], Any] = lambda entry: entry
) -> Callable[[list[Any]], list[Any]]:
    """Return a solver by Gaussian elimination that skips zeros; pivoting is without branches."""
    n = len(a)
    a = [list(row) for row in a]
    exchanges: list[tuple[int, int, Any]] = []
    inverse: list[Any] = []
    for k in range(n):
        for i in range(k + 1, n) if pivoting else ():
            if not a[i][k].is_zero():
                larger = ca.fabs(a[i][k]) > ca.fabs(a[k][k])
                exchanges.append((k, i, larger))
                pairs = [_exchanged(larger, x, y) for x, y in zip(a[k], a[i], strict=True)]
                a[k], a[i] = [x for x, _ in pairs], [y for _, y in pairs]
        inverse.append(1 / a[k][k])
        ahead = [j for j in range(k + 1, n) if not a[k][j].is_zero()]
        entries = ca.vertcat(ca.SX(0, 1), *(a[k][j] for j in ahead))
        for i in range(k + 1, n):
            if not a[i][k].is_zero():
                a[i][k] = a[i][k] * inverse[k]
                changed = ca.vertcat(ca.SX(0, 1), *(a[i][j] for j in ahead)) - a[i][k] * entries
                for j, entry in zip(ahead, ca.vertsplit(changed), strict=True):
                    a[i][j] = entry
    below = [[i for i in range(k + 1, n) if not a[i][k].is_zero()] for k in range(n)]
    right = [[j for j in range(k + 1, n) if not a[k][j].is_zero()] for k in range(n)]
    a = [
        [entry if i == j or entry.is_zero() else keep(entry) for j, entry in enumerate(row)] for i, row in enumerate(a)
    ]
    inverse = [keep(entry) for entry in inverse]
    exchanges = [(k, i, keep(larger)) for k, i, larger in exchanges]

    def solve(r: list[Any]) -> list[Any]:
        x = list(r)
        for k, i, larger in exchanges:  # all at once: the multipliers were exchanged with their rows
            x[k], x[i] = _exchanged(larger, x[k], x[i])
        for k in range(n):
            for i in below[k]:
                x[i] = x[i] - a[i][k] * x[k]
        for k in reversed(range(n)):
            for j in right[k]:
                x[k] = x[k] - a[k][j] * x[j]
            x[k] = x[k] * inverse[k]
        return x

    return solve


def _exchanged(condition: Any, x: Any, y: Any) -> tuple[Any, Any]:
    if x.is_zero() and y.is_zero():
        return x, y
    return ca.if_else(condition, y, x), ca.if_else(condition, x, y)


def _ordered(core: list[int], first: list[int], matrix: dict[tuple[int, int], Any]) -> list[int]:
    """Order the unknowns for little fill-in: approximate minimum degree."""
    place = {i: at for at, i in enumerate(core)}
    through = [[place[i] for i, j in matrix if j == f and i in place] for f in first]
    onward = [[place[j] for i, j in matrix if i == f and j in place] for f in first]
    filled = {(place[i], place[j]) for i, j in matrix if i in place and j in place}
    filled |= {(i, j) for rows, columns in zip(through, onward, strict=True) for i in rows for j in columns}
    filled |= {(j, i) for i, j in filled} | {(i, i) for i in place.values()}
    rows, columns = zip(*sorted(filled), strict=True)
    return [core[i] for i in ca.Sparsity.triplet(len(core), len(core), rows, columns).amd()]


def _row(matrix: dict[tuple[int, int], Any], i: int, columns: list[int]) -> dict[int, Any]:
    return {j: matrix[i, j] for j in columns if (i, j) in matrix}


def _column(matrix: dict[tuple[int, int], Any], rows: list[int], j: int) -> dict[int, Any]:
    return {i: matrix[i, j] for i in rows if (i, j) in matrix}


def _dot(a: dict[int, Any], b: dict[int, Any]) -> Any:
    return sum((a[i] * b[i] for i in a if i in b), start=ca.SX(0))


def _times(row: dict[int, Any], x: Any) -> Any:
    return sum((entry * x[j] for j, entry in row.items()), start=ca.SX(0))
