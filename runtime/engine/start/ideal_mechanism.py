"""Motion of the ideal mechanism, every clearance closed, as a reference for runs with clearance.

A joint with clearance reports its eccentricity in the outputs of the model. Where these
eccentricities and the constraints of closed loops are together as many as the speeds, the ideal motion is their
common zero e(t, q) = 0, found by Newton's method and followed in time; its speeds and accelerations solve the first
and second time derivative of the same equations, which are linear in them. Where they are fewer, the mechanism
without clearance still moves by its masses and forces, and its motion does not follow from geometry alone. A
coordinate that a drive integrates has no speed to be solved for: it is integrated here too. Nothing else of the model
enters: no mass, no force.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.step.explicit_step import unit_quaternions
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import dop853
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.start.assembly import journals
from hertzwerk.runtime.system.arrays import Array

_CORRECTIONS = 4  # Newton's, in one step in time
_CONTRACTION = 0.25  # of the second correction over the first (Deuflhard's test): a step that stays on its branch
_ROUNDING = 1e-12  # the last correction, relative to 1 + |q|
_SHORTEST = 2.0**-30  # step, over the interval between two wanted times
_SINGULAR = 1e-10  # reciprocal condition number below which the eccentricities do not determine the coordinates


@dataclass(frozen=True)
class IdealMotion:
    """Coordinates q (times, nq), speeds u and accelerations (times, nu) of the ideal mechanism, SI."""

    t: Array
    q: Array
    u: Array
    acceleration: Array
    coordinates: tuple[str, ...]
    speeds: tuple[str, ...]

    def __getitem__(self, name: str) -> Array:
        """History of one coordinate or speed, SI; KeyError for another name."""
        if name in self.coordinates:
            return self.q[:, self.coordinates.index(name)]
        if name in self.speeds:
            return self.u[:, self.speeds.index(name)]
        raise KeyError(f"{name!r}: the ideal mechanism has {', '.join(self.coordinates + self.speeds)}")

    def acceleration_of(self, speed: str) -> Array:
        """Time derivative of one speed, SI."""
        return self.acceleration[:, self.speeds.index(speed)]


def ideal_motion(model: EngineModel, times: Sequence[float] | Array, q: Array, c: Array) -> IdealMotion | None:
    """Follow the ideal mechanism through increasing times from an approximate position q (nq,).

    c (nc,) are the model's constants for the run's parameters. None where eccentricities and constraints do not
    determine the coordinates: no joint with clearance, fewer or more of them than the coordinates need (see
    `unknown_because`), a mechanism that cannot be assembled, or one that locks on the way.
    """
    closure = None if unknown_because(model) else _Closure.of(model)
    wanted = np.asarray(times, dtype=float)
    if closure is None or not len(wanted):
        return None
    here = closure.assemble(float(wanted[0]), np.asarray(q, dtype=float).ravel(), c)
    rows: list[_Position] = []
    for time in wanted:
        here = None if here is None else closure.follow(here, float(time), c)
        if here is None:
            return None
        rows.append(here)
    q_rows, u_rows, a_rows = (np.array(column) for column in zip(*((row.q, row.u, row.a) for row in rows), strict=True))
    return IdealMotion(wanted, q_rows, u_rows, a_rows, tuple(model.coordinates), tuple(model.speeds))


def has_clearance(model: EngineModel) -> bool:
    """Return whether some pair models a joint with clearance."""
    return bool(model.journals or model.guides)


def unknown_because(model: EngineModel) -> str:
    """Explain why geometry alone does not determine the ideal motion; empty where it may."""
    if not has_clearance(model):
        return "it has no joint with clearance"
    if model.guides:
        return f"{', '.join(model.guides)} guide with a clearance that cannot be closed"
    equations = len(journals(model)) + model.nl
    if equations != model.nu:
        return f"closed clearances and loops give {equations} equations for {model.nu} degrees of freedom, so its motion depends on masses and forces"
    return ""


@dataclass(frozen=True)
class _Position:
    t: float
    q: Array
    u: Array
    a: Array


@dataclass(frozen=True)
class _Closure:
    """Closure equations e(t, q) = 0 of the ideal mechanism and a Newton step of them, as CasADi functions."""

    jacobian: Callers  # (t, q, c) -> de/dt by the speeds
    step: Callers  # (t, q, u, dt, c) -> q, u, a at t + dt, the corrections in columns, the last with the error of what drives integrate
    nu: int

    @classmethod
    def of(cls, model: EngineModel) -> _Closure:
        """Build the closure equations of a model that has as many of them as speeds."""
        outputs, rates = model.function("outputs"), model.function("coordinate_rates")
        t, q, u, c = (ca.SX.sym(name, outputs.sparsity_in(i)) for i, name in enumerate("tquc"))
        a, dt = ca.SX.sym("a", u.sparsity()), ca.SX.sym("dt")
        dq = rates(t, q, u, c)
        e = outputs(t, q, u, c)[journals(model)]
        if model.nl:
            e = ca.vertcat(e, model.function("constraints")(t, q, u, c)[0])
        e_dot = ca.jtimes(e, ca.vertcat(t, q), ca.vertcat(1, dq))
        e_ddot = ca.jtimes(e_dot, ca.vertcat(t, q, u), ca.vertcat(1, dq, a))
        jacobian = ca.substitute(ca.jacobian(e_dot, u), u, ca.SX.zeros(model.nu))
        # along what the speeds can do, so that a quaternion keeps its norm to first order
        along, none = -ca.solve(jacobian, e), ca.SX.zeros(model.nu)
        correction = ca.Function("correction", [t, q, c], [rates(t, q, along, c) - rates(t, q, none, c)])
        speeds = ca.Function("speeds", [t, q, c], [_zero(e_dot, u)])
        accelerations = ca.Function("accelerations", [t, q, u, c], [_zero(e_ddot, a)])
        there, corrections = unit_quaternions(q + dt * dq, model.quaternions), []
        moved = set(ca.jacobian(dq, u).sparsity().row())
        driven = [i for i in range(model.nq) if i not in moved]
        there[driven], error = _integrated(ca.Function("driven", [t, q, c], [dq[driven]]), t, q, driven, dt, c)
        for _ in range(_CORRECTIONS):
            corrections.append(correction(t + dt, there, c))
            there = unit_quaternions(there + corrections[-1], model.quaternions)
        corrections[-1][driven] = error
        velocity = speeds(t + dt, there, c)
        results = [there, velocity, accelerations(t + dt, there, velocity, c), ca.horzcat(*corrections)]
        return cls(
            Callers(ca.Function("jacobian", [t, q, c], [ca.densify(jacobian)])),
            Callers(ca.Function("step", [t, q, u, dt, c], ca.cse([*map(ca.densify, results)]))),
            model.nu,
        )

    def assemble(self, t: float, q: Array, c: Array) -> _Position | None:
        """Return the closed position nearest to q, or None."""
        still = np.zeros(self.nu)
        for _ in range(10):
            here, corrections = self._step(_Position(t, q, still, still), t, c)
            if not np.all(np.isfinite(here.a)) or np.linalg.cond(self._jacobian(t, here.q, c)) > 1 / _SINGULAR:
                return None
            if _negligible(corrections[:, -1], here.q):
                return here
            q = here.q
        return None

    def follow(self, here: _Position, end: float, c: Array) -> _Position | None:
        """Continue the closed mechanism from `here` to the time `end`; None if it locks before."""
        shortest, target = _SHORTEST * (end - here.t), end
        while here.t < end:
            there, corrections = self._step(here, target, c)
            first, second = np.linalg.norm(corrections[:, :2], axis=0)
            contracts = second <= max(_CONTRACTION * first, _ROUNDING * (1 + float(np.linalg.norm(here.q))))
            if contracts and _negligible(corrections[:, -1], there.q) and np.all(np.isfinite(there.a)):
                here, target = there, end
            elif target - here.t > shortest:
                target = (here.t + target) / 2
            else:
                return None
        return here

    def _jacobian(self, t: float, q: Array, c: Array) -> Array:
        (matrix,) = self.jacobian(t, q, c)
        return matrix.reshape(self.nu, self.nu)  # of one freedom it is a vector

    def _step(self, here: _Position, t: float, c: Array) -> tuple[_Position, Array]:
        q, u, a, corrections = self.step(here.t, here.q, here.u, t - here.t, c)
        return _Position(t, q, u, a), corrections


def _integrated(rate: Any, t: Any, q: Any, driven: list[int], dt: Any, c: Any) -> tuple[Any, Any]:
    """Integrate the driven coordinates to t + dt by two steps of order 8; return them and an error.

    The error is the difference to one step.
    """
    table = dop853()

    def step(time: Any, start: Any, h: Any) -> Any:
        slopes: list[Any] = []
        for node, row in zip(table.c, table.A, strict=True):
            at = ca.SX(q)
            at[driven] = start + h * sum((weight * slope for weight, slope in zip(row, slopes, strict=False)), ca.SX(0))
            slopes.append(rate(time + node * h, at, c))
        return start + h * sum(weight * slope for weight, slope in zip(table.b, slopes, strict=True))

    end = step(t + dt / 2, step(t, q[driven], dt / 2), dt / 2)
    return end, end - step(t, q[driven], dt)


def _zero(residual: Any, unknown: Any) -> Any:
    """Solve a residual that is linear in the unknown for it.

    The derivative of a called function may name the unknown without depending on it, hence the substitution.
    """
    nothing = ca.SX.zeros(*unknown.shape)
    slope, rest = ca.substitute([ca.jacobian(residual, unknown), residual], [unknown], [nothing])
    return ca.solve(slope, -rest)


def _negligible(correction: Array, q: Array) -> bool:
    return bool(np.all(np.abs(correction) <= _ROUNDING * (1 + np.abs(q))))
