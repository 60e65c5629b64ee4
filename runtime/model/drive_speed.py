"""Speed of the one drive of a scene, where it is constant: so a revolution is a time."""

from __future__ import annotations

import casadi as ca
import numpy as np

from hertzwerk.runtime.model.caller import Callers
from hertzwerk.runtime.model.model import Bound, Model
from hertzwerk.runtime.model.per_model import per_model

TIMES = (0.37, 1.7, 23.0, 1.1e3, 1.3e6)  # over the speed at the start: when it must be the same
SAME = 1e-9  # relative


def drive_speed(model: Model, bound: Bound) -> float | None:
    """Return the angular speed [rad/s] of a scene's only drive; None where it varies, or there are others."""
    if [kind for _, kind, _ in model.module.EFFECTS].count("drive") != 1:
        return None
    callers = _speeds(model)
    caller = callers.take()
    caller.inputs[0][:] = bound.c
    speeds = caller()[0].copy()
    callers.give_back(caller)
    begin = float(np.max(speeds[0], initial=0.0))
    if not begin > 0:
        return None
    turns = np.abs(speeds - begin) <= SAME * begin
    same = np.all(turns | (speeds <= SAME * begin)) and np.all(
        np.any(turns, axis=1)
    )  # bodies turn with it or not at all
    return begin if same else None


@per_model
def _speeds(model: Model) -> Callers:
    """Build the function c -> speeds [rad/s] of the bodies where nothing but the drive moves.

    A column at the start, and at TIMES over the largest speed there.
    """
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.nc)
    if model.has("placed"):
        joints = model.joints
        _, u = model.function("placed")(t, _still(joints), np.zeros(joints.nu), c)
        bodies: dict[str, list[int]] = {}
        for i, name in enumerate(model.speeds):
            if model.units[name] == "rad/s":
                bodies.setdefault(name.partition(".")[0], []).append(i)
        speeds = [ca.sumsqr(u[rows]) for rows in bodies.values()]
    else:
        _, rotations = model.function("poses")(t, _still(model), c)
        rates = ca.jacobian(rotations, t)  # of a rotation at w the squares of the rates of its matrix sum to 2 w^2
        speeds = [ca.sumsqr(rates[9 * i : 9 * i + 9]) / 2 for i in range(rates.numel() // 9)]
    at = ca.Function("at", [t, c], [ca.densify(ca.sqrt(ca.vertcat(*speeds)))])
    begin = at(0, c)
    later = (at(time / ca.mmax(begin), c) for time in TIMES)
    return Callers(ca.Function("drive_speeds", [c], [ca.horzcat(begin, *later)]))


def _still(model: Model) -> np.ndarray:
    """Return coordinates zero, quaternions of no rotation."""
    q = np.zeros(model.nq)
    q[list(model.quaternions)] = 1
    return q
