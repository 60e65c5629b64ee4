"""Pinocchio: its algorithm of articulated bodies (`aba`) as the right-hand side of SciPy's `solve_ivp`, as it has no integrator of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from benchmarks.contact.problem import Problem, Result
from benchmarks.ratios import decades
from scipy.integrate import solve_ivp

NAME, PACKAGE, MODULE = "Pinocchio", "pin", "pinocchio"
METHODS = ("RK23", "RK45", "DOP853", "Radau", "BDF", "LSODA")


def settings(problem: Problem) -> dict[str, Sequence[float]]:
    """Return the relative tolerances of each integrator; the absolute one is a thousandth."""
    return dict.fromkeys(METHODS, decades(3, 12, 1)) if problem.kind == "chain" else {}


def model_of(numbers: Any) -> Any:
    """Return the model of a chain whose joints turn about z."""
    import pinocchio as pin

    model = pin.Model()
    model.gravity.linear = np.array([0.0, -numbers.gravity, 0.0])
    place = pin.SE3.Identity()
    inertia = numbers.mass * numbers.length**2 / 12
    rod = pin.Inertia(numbers.mass, np.array([numbers.length / 2, 0.0, 0.0]), np.diag([0.0, inertia, inertia]))
    joint = 0
    for i in range(numbers.links):
        joint = model.addJoint(joint, pin.JointModelRZ(), place, f"joint_{i}")
        model.appendBodyToJoint(joint, rod, pin.SE3.Identity())
        place = pin.SE3(np.eye(3), np.array([numbers.length, 0.0, 0.0]))
    return model


def prepare(problem: Problem, integrator: str, setting: float) -> Callable[[], Result]:
    """Return the call that is measured."""
    import pinocchio as pin

    model = model_of(problem.physics)
    data = model.createData()
    n, none = model.nv, np.zeros(model.nv)
    start = np.concatenate([np.diff(part, prepend=0.0) for part in np.split(problem.start, 2)])

    def rates(t: float, y: np.ndarray) -> np.ndarray:
        return np.concatenate((y[n:], pin.aba(model, data, y[:n], y[n:], none)))

    def run() -> Result:
        found = solve_ivp(
            rates,
            (0.0, problem.times[-1]),
            start,
            method=integrator,
            t_eval=problem.times,
            rtol=max(setting, 3e-14),
            atol=setting / 1000,
        )
        if found.status < 0:
            raise ArithmeticError(found.message)
        return Result(np.cumsum(found.y[:n], axis=0).T)

    return run
