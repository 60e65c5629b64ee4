"""Changes of the start of a motion with parameters and initial states."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.integrate.events.jumps import jump
from hertzwerk.runtime.model.caller import Callers
from hertzwerk.runtime.model.model import Bound, Model
from hertzwerk.runtime.model.per_model import per_model
from hertzwerk.runtime.start.start_values import assembled, read_start

if TYPE_CHECKING:
    from hertzwerk.runtime.model.binding import Value

STEP = 1e-3  # relative, of differences: two of them, extrapolated, are right to about its fourth power


def start_changes(model: Model, bound: Bound, initial: Mapping[str, Value], names: tuple[str, ...]) -> np.ndarray:
    """Return the changes (nq + nu, P) of the start with parameters, or initial states of the joints.

    Those of a tree are derivatives of its start; where a start is assembled, with loops to be closed or bodies to be
    seated, or effects have events at it, as the first sample of a controller, they are extrapolated differences of
    starts, right to about 1e-11.
    """
    if hasattr(model.module, "GIVEN") or model.joints is not model or model.quaternions or model.ne:
        columns = [_difference(model, bound, initial, name) for name in names]
        return np.stack(columns, axis=1)
    states, parameters = [*model.coordinates, *model.speeds], list(model.parameters)
    (by_parameters,) = _start_by_parameters(model)(bound.p)
    by_parameters = by_parameters.reshape(len(states), len(parameters))
    by_parameters[[states.index(name) for name in initial if name in states]] = 0
    unit = np.eye(len(states))
    return np.stack(
        [
            by_parameters[:, parameters.index(name)] if name in parameters else unit[states.index(name)]
            for name in names
        ],
        axis=1,
    )


@per_model
def _start_by_parameters(model: Model) -> Callers:
    p = ca.SX.sym("p", len(model.parameters))
    start = ca.vertcat(*map(ca.SX, model.module.start(p)))
    return Callers(ca.Function("start_by_p", [p], [ca.densify(ca.jacobian(start, p))]))


@per_model
def _jumped(model: Model) -> Callers:
    return Callers(jump(model))


def _difference(model: Model, bound: Bound, initial: Mapping[str, Value], name: str) -> np.ndarray:
    parameters, joints = list(model.parameters), model.joints
    now = dict(zip(parameters, bound.p, strict=True))
    if name not in now:
        q, u = assembled(model, bound, initial, [])
        now = dict(zip((*joints.coordinates, *joints.speeds), (*q, *u), strict=True))
    value = float(now[name])
    step = STEP * (abs(value) or 1.0)

    def at(change: float) -> np.ndarray:
        moved, given = bound, dict(initial)
        if name in parameters:
            p = bound.p.copy()
            p[parameters.index(name)] += change
            c = model.evaluate("constants", p)[0]
            c[model.nc - model.npieces :] = bound.c[model.nc - model.npieces :]
            moved = replace(bound, p=p, c=c)
        else:
            given[name] = (value + change, joints.units[name])
        faults: list[Fault] = []
        q, u = read_start(model, moved, given, faults)
        if faults:
            raise InputError(f"start of {model.name} with another {name}", faults)
        if model.ne:
            q = _jumped(model)(0.0, np.concatenate([q, u, np.zeros(model.nz)]), moved.c, np.zeros(model.ne))[0][
                : model.nq
            ]
        return np.concatenate([q, u])

    whole, half = ((at(d) - at(-d)) / (2 * d) for d in (step, step / 2))
    found: np.ndarray = (4 * half - whole) / 3
    return found
