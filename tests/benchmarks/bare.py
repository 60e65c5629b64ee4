"""What one evaluation of a generated right-hand side costs by itself, and how many evaluations of each kind a run makes."""

from __future__ import annotations

from typing import Any, NamedTuple

import casadi as ca
import numpy as np
from benchmarks.ratios import hot

from hertzwerk.runtime.engine.integration.loop.c_compilation import Program
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import CONTACT

SIZE = (16, 16)  # evaluations per call, one waiting for the other
TINY = 1e-22  # of a rate, added to the next state: too little to be seen, and yet to be waited for


class Evaluations(NamedTuple):
    """Of one mode: its number in a run, and the time of one alone [s]."""

    number: int
    seconds: float


def evaluations(run: Any, *, compiled: bool) -> dict[str, Evaluations]:
    """Evaluations in flight and in contact of a run of a one-pair model, timed at the run's own states.

    What is tried after an accepted state, rejected or not, is tried under that state's mode.
    """
    history = run.engine.history
    touching = history.part("mode")[:, 0] == CONTACT
    counted = np.diff(history.part("evaluations")[:, 0], append=run.statistics.rhs_evaluations)
    return {
        name: Evaluations(int(counted[rows].sum()), _seconds(run, rows, contacts, compiled=compiled))
        for name, rows, contacts in (("flight", ~touching, ()), ("contact", touching, (0,)))
    }


def _seconds(run: Any, rows: np.ndarray, contacts: tuple[int, ...], *, compiled: bool) -> float:
    history, model = run.engine.history, run.engine.model
    chain = _chain(model, contacts)
    chosen = np.resize(np.flatnonzero(rows), np.prod(SIZE))
    states = (history.part(name)[chosen].ravel() for name in ("t", "y", "m"))
    arguments = [np.zeros(1), *(np.ascontiguousarray(values) for values in states), history.controls[: model.nc].copy()]
    result = np.zeros(1)
    buffer, evaluate = (Program(chain).load()[0] if compiled else chain).buffer()  # no conversion to DM
    for i, values in enumerate(arguments):
        buffer.set_arg(i, memoryview(values))
    buffer.set_res(0, memoryview(result))
    time = hot(evaluate, calls=101)() / len(chosen)
    if not np.isfinite(result[0]):
        raise ValueError("a right-hand side is not finite at the states of its own run")
    return time


def _chain(model: Any, contacts: tuple[int, ...]) -> Any:
    """CasADi function (last, t (1, n), y (ny, n), m (nm, n), c) -> a number: n evaluations, each at a state that the last one moves."""
    link = _link(model, contacts)
    for i, size in enumerate(SIZE):
        symbol = (ca.SX if i == 0 else ca.MX).sym  # the inner ones are written out, as the stages of a step are
        last, c = symbol("last"), symbol("c", model.nc)
        each = [symbol(name, link.size1_in(j), link.size2_in(j) * size) for j, name in enumerate("tym", 1)]
        value = last
        for parts in zip(*(ca.horzsplit(matrix, matrix.shape[1] // size) for matrix in each), strict=True):
            value = link(value, *parts, c)
        link = ca.Function("chain", [last, *each, c], [value])
    return link


def _link(model: Any, contacts: tuple[int, ...]) -> Any:
    """CasADi function (last, t, y, m, c) -> a number: one evaluation."""
    sizes = {"last": 1, "t": 1, "y": model.nq + model.nu + model.nz, "m": model.nm, "c": model.nc}
    last, t, y, m, c = (ca.SX.sym(name, size) for name, size in sizes.items())
    rate = flow(model, contacts).rates(t + TINY * last, y + TINY * last, ca.SX.ones(model.k), m, c)
    return ca.Function("link", [last, t, y, m, c], [ca.cse(ca.sum1(rate[model.nq : model.nq + model.nu]))])
