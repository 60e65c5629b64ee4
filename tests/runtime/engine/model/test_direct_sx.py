"""Expressions made by direct calls have the nodes of those that CasADi's operators make."""

from typing import Any

import casadi as ca
import numpy as np
import pytest
from each import each

from hertzwerk.runtime.engine.model.direct_sx import DirectSX, direct
from hertzwerk.runtime.loading import engine_model


def nodes(function: Any) -> list[Any]:
    """Return the operations of a function with what they read and write, and its numbers."""
    return [
        (
            function.instruction_id(k), function.instruction_input(k), function.instruction_output(k),
            function.instruction_constant(k) if function.instruction_id(k) == ca.OP_CONST else None,
        )
        for k in range(function.n_instructions())
    ]  # fmt: skip


OPERATIONS = {
    "sum": lambda x, y: x + y, "difference": lambda x, y: x - y, "product": lambda x, y: x * y, "quotient": lambda x, y: x / y,
    "power": lambda x, y: x**y, "mixed": lambda x, y: -(2.5 * x - y) * ca.sqrt(x) / (1 - y / x) + ca.if_else(x < y, x, 3 * y),
}  # fmt: skip


@each("operation", OPERATIONS.values())
@each("right", [2.5, 3, np.float64(1.5), "scalar", "vector", ca.DM([1, 2, 3])])
def test_the_nodes_are_those_of_casadi_on_both_sides(operation: Any, right: Any) -> None:
    x, y = ca.SX.sym("x"), ca.SX.sym("y", 3 if right == "vector" else 1) if isinstance(right, str) else right
    inputs = ca.symvar(ca.veccat(ca.SX(x), ca.SX(y)))
    mine = operation(direct(ca.SX(x)), y), operation(y, direct(ca.SX(x)))
    theirs = operation(x, y), operation(y, x)
    for one, other in zip(mine, theirs, strict=True):
        assert nodes(ca.Function("f", inputs, [one])) == nodes(ca.Function("f", inputs, [other]))


def test_sums_products_and_entries_stay_direct_and_what_was_given_does_not_become_so() -> None:
    x = ca.SX.sym("x", 3)
    u = direct(ca.SX(x))
    results = (u[0], u[:2], -u, u + 1, 1 + u, u - 1, 1 - u, u * 2, 2 * u, u / 2, 2 / u, u[0] * u[1])
    assert all(type(each) is DirectSX for each in results)
    assert type(x) is ca.SX


@pytest.mark.parametrize("name", ["slider_crank", "ball_bearing"])
def test_results_of_a_model_are_plain(name: str) -> None:
    model = engine_model(name)
    arguments = model.symbols("t q u c")
    assert all(type(each) is ca.SX for each in [*arguments, *model.expressions("gaps", *arguments)])
