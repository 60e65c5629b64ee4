"""Constant speed of the one drive of a scene: so a revolution is a time, and the angle is known."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

CONSTANT = "constant speed of "  # what the drive says of itself
TIMES = (0.37, 1.7, 23.0, 1.1e3, 1.3e6)  # over the speed at the start: when it must be the same
SAME = 1e-9  # relative


def drive_speed(model: EngineModel, bound: BoundParameters) -> float | None:
    """Return the angular speed [rad/s] of a scene's only drive; None where it varies, or there are others."""
    if [kind for _, kind, _ in model.module.EFFECTS].count("drive") != 1 or model.smooth:
        return None  # none, several, or as an input says
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


def drive_angle(model: EngineModel) -> str | None:
    """Return the name of the angle of a scene's only drive, 0 at the start.

    None where it turns at no constant speed.
    """
    drives = [(name, text) for name, kind, text in model.module.EFFECTS if kind == "drive"]
    if len(drives) != 1 or not drives[0][1].startswith(CONSTANT) or _axis(model, drives[0][0]) is None:
        return None
    joint = drives[0][1].removeprefix(CONSTANT)
    return joint if "." in joint else f"{joint}.angle"


def drive_rate(model: EngineModel, bound: BoundParameters) -> float | None:
    """Return the rate [rad/s] of `drive_angle`, negative where it falls; None where it stands still."""
    speed = drive_speed(model, bound)
    if speed is None:
        return None
    ((name, *_),) = (row for row in model.module.EFFECTS if row[1] == "drive")
    row = _axis(model, name)
    if row is None:
        return None
    axis = model.evaluate("landmarks", bound.p)[row][3:6]
    body = model.module.BODIES.index(model.module.LANDMARKS[row][3])
    begin, later = (
        model.evaluate("poses", t, _driven(model, bound, t), bound.c)[1][9 * body : 9 * body + 9].reshape(3, 3)
        for t in (0.0, math.pi / 2 / speed)
    )
    quarter = later @ begin.T
    turned = np.array([quarter[2, 1] - quarter[1, 2], quarter[0, 2] - quarter[2, 0], quarter[1, 0] - quarter[0, 1]])
    return math.copysign(speed, float(turned @ begin @ axis))


def _axis(model: EngineModel, drive: str) -> int | None:
    """Return the row of LANDMARKS with the axis of a drive that turns."""
    rows = enumerate(model.module.LANDMARKS)
    return next((i for i, (part, kind, *_) in rows if part == drive and kind == "turn_drive"), None)


def _driven(model: EngineModel, bound: BoundParameters, t: float) -> np.ndarray:
    """Return the coordinates at a time [s] where nothing but the drive moves."""
    if not model.has_function("placed"):
        return _still(model)
    joints = model.joints
    return model.evaluate("placed", t, _still(joints), np.zeros(joints.nu), bound.c)[0]


@per_model
def _speeds(model: EngineModel) -> Callers:
    """Build the function c -> speeds [rad/s] of the bodies where nothing but the drive moves.

    A column at the start, and at TIMES over the largest speed there.
    """
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.nc)
    if model.has_function("placed"):
        joints = model.joints
        _, u = model.function("placed")(t, _still(joints), np.zeros(joints.nu), c)
        bodies = grouped(
            (name.partition(".")[0], i) for i, name in enumerate(model.speeds) if model.units[name] == "rad/s"
        )
        speeds = [ca.sumsqr(u[rows]) for rows in bodies.values()]
    else:
        _, rotations = model.function("poses")(t, _still(model), c)
        rates = ca.jacobian(rotations, t)  # of a rotation at w the squares of the rates of its matrix sum to 2 w^2
        speeds = [ca.sumsqr(rates[9 * i : 9 * i + 9]) / 2 for i in range(rates.numel() // 9)]
    at = ca.Function("at", [t, c], [ca.densify(ca.sqrt(ca.vertcat(*speeds)))])
    begin = at(0, c)
    later = (at(time / ca.mmax(begin), c) for time in TIMES)
    return Callers(ca.Function("drive_speeds", [c], [ca.horzcat(begin, *later)]))


def _still(model: EngineModel) -> np.ndarray:
    """Return coordinates zero, quaternions of no rotation."""
    q = np.zeros(model.nq)
    q[list(model.quaternions)] = 1
    return q
