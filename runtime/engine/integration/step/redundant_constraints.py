"""Redundant constraints, relaxed for the length of a step.

The stages of a step lie off the constraints by far more than its error, and there a redundant constraint contradicts
the others: by no more than the stages are off, but divided by a pivot as small. So each step keeps a maximal
independent set of constraints, the same in all its stages, chosen at its start by pivoting; the set changes along the
motion. The end of a step must close all of them (`projection`).

Businger, Golub, Linear least squares solutions by Householder transformations, Numer. Math. 7 (1965) 269 (choice,
here by Gram-Schmidt).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel

OUT = 1e20  # softness of a relaxed constraint


def relax_redundant(model: EngineModel) -> Callable[[Mapping[str, Any], Mapping[str, Any]], Mapping[str, Any]]:
    """Return (start, run) -> run with the constraints relaxed that are redundant at the step's start."""
    if not model.dependent:
        return lambda start, run: run
    function = _softness(model)
    speeds = slice(model.nq, model.nq + model.nu)

    def without(start: Mapping[str, Any], run: Mapping[str, Any]) -> Mapping[str, Any]:
        c = run["c"]
        softness = function(start["t"], start["y"][: model.nq], c, run["scale"][speeds], run["scales"][0])
        return {**run, "c": ca.vertcat(c[: model.nc - model.nl], softness)}

    return without


@per_model
def _softness(model: EngineModel) -> Any:
    """Build the function (t, q, c, scales of speeds (nu), length) -> softness of each constraint (nl)."""
    t, q, u, c = model.symbols("t q u c")
    size, length = ca.SX.sym("size", model.nu), ca.SX.sym("length")
    _, rate = model.function("constraints")(t, q, u, c)
    rows = ca.mtimes(ca.jacobian(rate, u), ca.diag(size))
    softness = c[model.nc - model.nl :]
    for members, rank in model.dependent:
        independent = _independent(
            [ca.densify(rows[i, :]) / (length if model.is_length[i] else 1) for i in members], rank
        )
        for i, stays in zip(members, independent, strict=True):
            softness[i] = ca.if_else(stays, softness[i], OUT)
    return ca.Function("softness", [t, q, c, size, length], [ca.cse(softness)])


def _independent(rows: list[Any], rank: int) -> list[Any]:
    """Select `rank` independent rows by greedy pivoting (largest remainder first); 1 if kept, else 0."""
    selected = [ca.SX(0)] * len(rows)
    remainders = [ca.sumsqr(row) for row in rows]
    for k in range(rank):
        largest = ca.mmax(ca.vertcat(*remainders))
        chosen, taken = [], ca.SX(0)
        for square in remainders:  # of equals the first
            chosen.append((square >= largest) * (1 - taken))
            taken += chosen[-1]
        selected = [a + b for a, b in zip(selected, chosen, strict=True)]
        if k + 1 < rank:
            unit = sum((row * one for row, one in zip(rows, chosen, strict=True)), start=ca.SX(0)) / ca.sqrt(largest)
            rows = [row - ca.dot(row, unit) * unit for row in rows]
            remainders = [ca.if_else(stays, -1, ca.sumsqr(row)) for row, stays in zip(rows, selected, strict=True)]
    return selected
