"""Coefficient tables: the number of conditions, a fault in any coefficient refused, the order measured."""

import dataclasses
import math

import pytest

from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import (
    ErrorEstimate,
    RungeKutta,
    dop853,
    dopri5,
    trees,
)

METHODS = {"dopri5": dopri5, "dop853": dop853}


def test_rooted_trees_are_counted_as_in_the_literature():
    assert [len(trees(nodes)) for nodes in range(1, 9)] == [1, 1, 2, 4, 9, 20, 48, 115]  # OEIS A000081
    assert all(len(set(trees(nodes))) == len(trees(nodes)) for nodes in range(1, 9))


def changed(table: RungeKutta, row: int, column: int, by: float) -> dict[str, object]:
    """Fields of a table with one entry of A changed, the node kept consistent, so that the row sum does not give it away."""
    A = [list(entries) for entries in table.A]
    A[row][column] += by
    c = list(table.c)
    c[row] += by
    return {"A": tuple(map(tuple, A)), "c": tuple(c)}


@pytest.mark.parametrize("method", METHODS)
def test_a_fault_seeded_in_any_coefficient_is_refused(method):
    table = METHODS[method]()
    for row in range(1, table.stages):
        for column in range(row):
            with pytest.raises(ValueError, match="found a fault in a coefficient table"):
                dataclasses.replace(table, **changed(table, row, column, 1e-9))
    for i in range(table.stages):
        b = [weight + 1e-9 * (i == j) for j, weight in enumerate(table.b)]
        with pytest.raises(ValueError, match="found a fault"):
            dataclasses.replace(table, b=tuple(b))
    for estimate in table.errors:
        for i in range(table.stages + 1):
            weights = tuple(weight + 1e-9 * (i == j) for j, weight in enumerate(estimate.weights))
            with pytest.raises(ValueError, match="error weights"):
                dataclasses.replace(table, errors=(ErrorEstimate(weights, estimate.order),))


@pytest.mark.parametrize("method", METHODS)
def test_more_order_than_there_is_cannot_be_claimed(method):
    table = METHODS[method]()
    with pytest.raises(ValueError, match=f"conditions of order {table.order + 1}"):
        dataclasses.replace(table, order=table.order + 1)
    for estimate in table.errors:
        with pytest.raises(ValueError, match=f"conditions of order {estimate.order + 1}"):
            dataclasses.replace(table, errors=(dataclasses.replace(estimate, order=estimate.order + 1),))


def test_shapes_and_an_estimate_of_nothing_are_refused():
    table = METHODS["dopri5"]()
    with pytest.raises(ValueError, match="rows of A"):
        dataclasses.replace(table, c=table.c[:-1])
    with pytest.raises(ValueError, match="all zero"):
        dataclasses.replace(table, errors=(ErrorEstimate((0.0,) * 7, 4),))


def integrate(table: RungeKutta, steps: int) -> float:
    """y' = y cos t from y(0) = 1 to t = 3, whose solution is exp(sin t); plain Python, no CasADi."""
    h, y = 3 / steps, 1.0
    for i in range(steps):
        slopes: list[float] = []
        for row, node in zip(table.A, table.c, strict=True):
            at = y + h * math.fsum(a * k for a, k in zip(row, slopes, strict=True))
            slopes.append(at * math.cos((i + node) * h))
        y += h * math.fsum(b * k for b, k in zip(table.b, slopes, strict=True))
    return y


@pytest.mark.parametrize(("method", "steps"), [("dopri5", 24), ("dop853", 8)])
def test_the_error_falls_at_the_method_s_order(method, steps):
    table = METHODS[method]()
    coarse, fine = (abs(integrate(table, n) - math.exp(math.sin(3))) for n in (steps, 2 * steps))
    assert math.log2(coarse / fine) == pytest.approx(table.order, abs=0.3)
