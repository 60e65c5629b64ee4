"""Derivatives of a model's functions along directions, changes of its parameters, at rows of a run.

A function of (t, y, mode, m, c, p) changes by its derivatives to y and m, which a caller multiplies with what is known of
those, and by the change of parameters and constants. The derivatives are CasADi's, of the graph that the run was made of.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import dataclass
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.step.explicit_step import written_flow
from hertzwerk.runtime.engine.model.caller import Callers, Rowwise
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.history import History

PARTS = ("t", "y", "mode", "m")
ARGUMENTS = "t y mode m c p"
"""Arguments of the functions whose derivatives are taken."""


@dataclass(frozen=True)
class Tangent:
    """A function's value (size), and its derivatives, at n rows.

    value (n, size); to_time (n, size); to_state (n, size, ny); to_memory (n, size, nm); by_constants (n, size, P): the change by
    the constants alone, of P directions.
    """

    value: np.ndarray
    to_time: np.ndarray
    to_state: np.ndarray
    to_memory: np.ndarray
    by_constants: np.ndarray

    def __getitem__(self, rows: Any) -> Tangent:
        """The same of some rows."""
        return Tangent(*(part[rows] for part in vars(self).values()))

    def along(self, state: np.ndarray, memory: np.ndarray) -> np.ndarray:
        """Return the change (n, size, P) where y and m change by these (n, ny, P), (n, nm, P), at fixed time."""
        change: np.ndarray = self.to_state @ state + self.to_memory @ memory + self.by_constants
        return change

    def rate(self, slope: np.ndarray) -> np.ndarray:
        """Return the rate (n, size) of the value where y moves at dy/dt (n, ny)."""
        rate: np.ndarray = self.to_time + (self.to_state @ slope[..., None])[..., 0]
        return rate


@dataclass(frozen=True)
class Directions:
    """P changes of the parameters: numbers of the run and derivatives of its constants.

    p (np,): the parameters in SI; dp (np, P): their changes; c (nc,), dc (nc, P); sizes (P,): usual sizes of what is changed
    """

    p: np.ndarray
    dp: np.ndarray
    c: np.ndarray
    dc: np.ndarray
    sizes: np.ndarray

    @property
    def count(self) -> int:
        """Number P of directions."""
        return int(self.dp.shape[1])


def with_shapes(model: EngineModel) -> EngineModel:
    """Return the model with derivatives by the shapes of its curves too; itself if it has no curves."""
    return _shaped(model).with_signals(model.signals) if hasattr(model.module, "_SHAPED") else model


@per_model
def _shaped(model: EngineModel) -> EngineModel:
    shaped = copy(model)  # of a module of its own
    vars(shaped.module)["_SHAPED"] = True
    return shaped


def directions_by(model: EngineModel, bound: BoundParameters, names: Sequence[str]) -> Directions:
    """Return the directions of parameters by name; that of an initial state changes no parameter."""
    dp = [[float(parameter == name) for name in names] for parameter in model.parameters]
    return directions_of(model, bound.p, bound.c, np.array(dp).reshape(-1, len(names)))


def directions_of(model: EngineModel, p: np.ndarray, c: np.ndarray, dp: np.ndarray) -> Directions:
    """Return the directions (np, P) with the change of the constants."""
    (to_p,) = _constants_by_parameters(model)(p)
    sizes = np.abs(p) @ (dp != 0)
    return Directions(p, dp, c, to_p.reshape(model.nc, len(p)) @ dp, np.where(sizes > 0, sizes, 1.0))


@per_model
def _constants_by_parameters(model: EngineModel) -> Callers:
    p = ca.SX.sym("p", len(model.parameters))
    return Callers(ca.Function("constants_by_p", [p], [ca.densify(ca.jacobian(ca.SX(model.module.constants(p)), p))]))


def tangent(build: Callable[[EngineModel], Any], history: History, rows: np.ndarray, directions: Directions) -> Tangent:
    """Return value and derivatives at rows (n, ns) of a run.

    build    returns the function (t, y, mode, m, c, p) -> column of a model
    """
    model, layout = history.model, history.engine.layouts.state
    changes = np.concatenate([directions.dc, directions.dp])
    constant = np.concatenate([directions.c, directions.p, changes.T.ravel()])
    pieces = [rows[:, layout["pieces"]]] if model.inputs else []
    value, to_time, *parts = rowwise(model, build, directions.count)(
        constant, *(rows[:, layout[part]] for part in PARTS), *pieces
    )
    widths, (n, size) = (layout.sizes["y"], model.nm, directions.count), value.shape
    shaped = (part.reshape(n, width, size).swapaxes(1, 2) for part, width in zip(parts, widths, strict=True))
    return Tangent(value, to_time, *shaped)


@per_model
def rowwise(model: EngineModel, build: Callable[[EngineModel], Any], count: int) -> Rowwise:
    """Return the function of value and derivatives that `tangent` calls row by row."""
    *rest, c, p = model.symbols(ARGUMENTS)
    _, y, _, m = rest
    size = model.nc + len(model.parameters)
    change = ca.SX.sym("change", size, count)
    pieces = [ca.SX.sym("pieces", model.npieces)] if model.inputs else []
    now = ca.vertcat(c[: model.nc - model.npieces], *pieces)  # those of the inputs change from row to row
    value = build(model)(*rest, now, p)
    by_constants = ca.jtimes(value, c, change[: model.nc, :]) + ca.jtimes(value, p, change[model.nc :, :])
    results = [value, ca.jtimes(value, rest[0], ca.SX(1)), ca.jacobian(value, y), ca.jacobian(value, m), by_constants]
    made = ca.Function(
        "tangent", [c, p, change, *rest, *pieces], ca.cse([ca.densify(ca.vec(result)) for result in results])
    )
    both, rest = ca.SX.sym("both", size * (1 + count)), [*rest, *pieces]
    split = *ca.vertsplit(both[:size], [0, model.nc, size]), ca.reshape(both[size:], size, count)
    return Rowwise(ca.Function("tangent_at", [both, *rest], made.call([*split, *rest])), constant=0)


_JUMPING = (
    ca.OP_LT,
    ca.OP_LE,
    ca.OP_EQ,
    ca.OP_NE,
    ca.OP_SIGN,
    ca.OP_FLOOR,
    ca.OP_CEIL,
    ca.OP_FMOD,
    ca.OP_COPYSIGN,
    ca.OP_CALL,
)


@per_model
def moves_with_events(model: EngineModel) -> bool:
    """Return whether the rates jump at no time of their own: changes may be taken since an event."""
    function = rates(model)
    by_time, by_state = 1, 2
    of_input, depends = (by_time, by_state, 0, by_state), [0] * function.sz_w()
    for k in range(function.n_instructions()):
        operation, of, to = function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        if operation == ca.OP_INPUT:
            depends[to[0]] = of_input[of[0]] if of[0] < len(of_input) else 0
        elif operation != ca.OP_OUTPUT:
            on = reduce(or_, (depends[i] for i in of), 0)
            for i in to:
                depends[i] = on
            if operation in _JUMPING and on == by_time:
                return False
    return not model.inputs  # which may jump


@per_model
def rates(model: EngineModel) -> Any:
    """Return the function of dy/dt (ny)."""
    arguments = model.symbols(ARGUMENTS)
    return ca.Function("rates", arguments, [written_flow(model).rates(*arguments[:-1])])
