"""Start of a scene without a drive: that of the driven one, to compare the effect of the drive alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.solution import Solution

CORRECTIONS = 20  # Gauss-Newton iterations of the positions
AGREE = 1e-9  # relative: largest difference of equal poses and their rates


def driven_start(run: Solution, model: Model, parameters: Mapping[str, Value]) -> dict[str, tuple[float, str]]:
    """Return the additional coordinates and speeds of a scene so that every body starts as in a run.

    The others start as in the run. Empty where there are none, and where bodies cannot start so.
    """
    whole, joints = run.model, model.joints
    q_free = [i for i, name in enumerate(joints.coordinates) if name not in whole.joints.coordinates]
    u_free = [i for i, name in enumerate(joints.speeds) if name not in whole.joints.speeds]
    if whole.module.BODIES != model.module.BODIES or not (q_free or u_free):
        return {}
    known = run.initial
    start = (np.array([known[name] for name in names]) for names in (whole.coordinates, whole.speeds))
    there = _flat(_motion(whole)(0.0, *start, run.history.controls[: whole.nc]))
    bound = model.bind(parameters)
    q, u = _flat(joints.function("start")(bound.p))
    for values, names in ((q, joints.coordinates), (u, joints.speeds)):
        values[:] = [known.get(name, value) for name, value in zip(names, values, strict=True)]
    motion = _motion_of_joints(model)
    for _ in range(CORRECTIONS):
        poses, _, by_q, _ = motion(0.0, q, u, bound.c)
        q[q_free] += _least_squares(by_q, q_free, there[0] - np.array(poses).ravel())
    _, rates, _, by_u = motion(0.0, q, u, bound.c)
    u[u_free] += _least_squares(by_u, u_free, there[1] - np.array(rates).ravel())
    here = _flat(motion(0.0, q, u, bound.c)[:2])
    if any(
        np.max(np.abs(x - y)) > AGREE * max(1.0, float(np.max(np.abs(y)))) for x, y in zip(here, there, strict=True)
    ):
        return {}
    found = [(joints.coordinates[i], q[i]) for i in q_free] + [(joints.speeds[i], u[i]) for i in u_free]
    return {name: (float(value), joints.units[name]) for name, value in found}


def _flat(results: Sequence[Any]) -> list[np.ndarray]:
    return [np.array(result).ravel() for result in results]


@per_model
def _motion(model: Model) -> Any:
    """Build the CasADi function (t, q, u, c) -> poses of all bodies, and their rates."""
    t, q, u, c = symbols = model.symbols("t q u c")
    poses = ca.vertcat(*model.function("poses")(t, q, c))
    moves = ca.vertcat(1, model.function("coordinate_rates")(t, q, u, c))
    return ca.Function("motion", symbols, [poses, ca.jtimes(poses, ca.vertcat(t, q), moves)])


@per_model
def _motion_of_joints(model: Model) -> Any:
    """Build the function (t, q, u, c), q and u of joints -> poses, their rates, derivatives by q and u."""
    t, q, u, c = symbols = model.symbols("t joints joint_speeds c")
    placed = (q, u) if model.joints is model else model.function("placed")(t, q, u, c)
    poses, rates = _motion(model)(t, *placed, c)
    return ca.Function("motion_of_joints", symbols, [poses, rates, ca.jacobian(poses, q), ca.jacobian(rates, u)])


def _least_squares(columns: Any, free: Sequence[int], wanted: np.ndarray) -> np.ndarray:
    """Return the changes of the free variables that come closest to the wanted ones."""
    changes: np.ndarray = np.linalg.lstsq(np.array(columns)[:, free], wanted, rcond=None)[0]
    return changes
