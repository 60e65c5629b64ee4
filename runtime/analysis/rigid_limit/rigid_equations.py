"""Equations of motion without contact forces, and the directions in which contacts act.

They follow from a model's own functions: normals from the gap rates, tangents from the sliding velocities, inverse inertia from
the accelerations, with loops closed. No module is derived for them.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.engine.integration.step.projection import closing
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.sensitivity.tangent import with_shapes
from hertzwerk.runtime.engine.solution.impacts import distances
from hertzwerk.runtime.system.arrays import Array

# kinds of effects that need a compliant contact
OF_CONTACTS = ("rolling_resistance", "drilling_resistance", "lubrication")


@dataclass(frozen=True)
class State:
    """Motion without contact forces at an instant; m rows: of each pair its normal, then its tangents.

    rates (nq), free accelerations (nu), pushed (nu, m): accelerations by a unit force along each row; D (m, m) of the rows;
    velocity (m) along the rows, bias (m): their rates by the free accelerations; gap (k) [m].
    """

    rates: Array
    free: Array
    pushed: Array
    D: Array
    velocity: Array
    bias: Array
    gap: Array


def refused(model: EngineModel) -> list[Fault]:
    """Return the faults of a scene whose motion depends on more than positions, speeds and contacts."""
    module, faults = model.module, []
    if not model.pairs:
        faults.append(Fault("scene", "no contact pair", "a scene with contacts"))
    resisting = [name for name, kind, _ in module.EFFECTS if kind in OF_CONTACTS]
    others = {
        "inputs": list(model.inputs),
        "events of effects": [row[0] for row in module.EVENTS],
        "forces that depend on reactions": [row[0] for row in (*module.LOADS, *module.RUBBING)],
        "rolling constraints": [row[0] for row in module.ROLLING],
        "resistance and films of contacts": resisting,
    }
    return faults + [
        Fault("scene", f"{kind}: {', '.join(map(str, names))}", "bodies, springs, drives and contacts alone",
              "leave the effect out: load(..., without=[...])")
        for kind, names in others.items() if names
    ]  # fmt: skip


@per_model
def _tangents(model: EngineModel) -> list[int]:
    """Return the number of tangents of each pair along which its sliding velocity is linear in the speeds."""
    t, q, u, c = model.symbols("t q u c")
    return [x.numel() if ca.is_linear(x, u) else 0 for x in _sliding(model, t, q, u, c)]


def rows_of(model: EngineModel) -> list[tuple[int, list[int]]]:
    """Return the rows of each pair: of its normal, and of its tangents."""
    ends = np.cumsum([1 + count for count in _tangents(model)]).tolist()
    return [(first, [*range(first + 1, end)]) for first, end in pairwise([0, *ends])]


def _sliding(model: EngineModel, t: ca.SX, q: ca.SX, u: ca.SX, c: ca.SX) -> list[ca.SX]:
    """Return the sliding velocities of each pair: none, one or two."""
    z, m = ca.SX.zeros(model.nz), ca.SX.zeros(model.nm)
    return [model.function(f"contact_{pair}")(t, q, u, z, m, c)[3] for pair in model.pairs]


def _velocity(model: EngineModel, t: ca.SX, q: ca.SX, u: ca.SX, c: ca.SX) -> ca.SX:
    """Return the velocities (m,) along the rows."""
    gap_rate, sliding = model.function("gaps")(t, q, u, c)[1], _sliding(model, t, q, u, c)
    return ca.vertcat(
        *(ca.vertcat(gap_rate[j], sliding[j] if count else ca.SX(0, 1)) for j, count in enumerate(_tangents(model)))
    )


@per_model
def _equations(model: EngineModel) -> Callers:
    """Build the function (t, q, u, c) -> fields of `State`."""
    t, q, u, c = symbols = model.symbols("t q u c")
    f = model.symbols("f")[0]
    rates = model.function("coordinate_rates")(t, q, u, c)
    gap, velocity = model.function("gaps")(t, q, u, c)[0], _velocity(model, t, q, u, c)
    R = ca.jacobian(velocity, u)
    forces = model.function("applied")(t, q, u, c)
    free = model.function("accelerations")(t, q, u, forces, c)[0]
    inverse = ca.substitute(ca.jacobian(model.function("accelerations")(t, q, u, f, c)[0], f), f, forces)
    pushed = ca.mtimes(inverse[:, : model.nu], R.T)
    bias = ca.mtimes(R, free) + ca.jtimes(velocity, ca.vertcat(t, q), ca.vertcat(1, rates))
    results = [rates, free, pushed, ca.mtimes(R, pushed), velocity, bias, gap]
    return Callers(ca.Function("rigid", symbols, [ca.densify(x) for x in ca.cse(results)]))


@per_model
def _work(model: EngineModel) -> Callers | None:
    """Build the function (t, q, u, x (m,), c) -> power [W] and work [J] of drives and effects.

    The power is that under forces x along the rows, less what effects dissipate, and the work that of drives at such impulses; None
    where nothing is booked. Contact forces act on driven bodies too: along the part of the rows' velocities that the drives impose.
    """
    if not model.has_ledger:
        return None
    t, q, u, c = model.symbols("t q u c")
    velocity, forces = _velocity(model, t, q, u, c), model.function("applied")(t, q, u, c)
    x, driven = ca.SX.sym("x", velocity.numel()), ca.substitute(velocity, u, ca.SX.zeros(model.nu))
    signs = ca.DM([-1 if name.endswith(".dissipated") else 1 for name, _ in model.module.MEMORY])

    def power(along: Any) -> Any:
        pushed = ca.vertcat(ca.mtimes(ca.jacobian(velocity, u).T, along), ca.SX.zeros(forces.numel() - model.nu))
        reactions = model.function("accelerations")(t, q, u, forces + pushed, c)[1]
        return ca.dot(signs, model.function("ledger")(t, q, u, reactions, c)) - ca.dot(along, driven)

    results = [power(x), power(x) - power(ca.SX.zeros(x.numel()))]
    if results[0].is_zero():
        return None
    return Callers(ca.Function("work", [t, q, u, x, c], [ca.densify(part) for part in ca.cse(results)]))


@per_model
def distance_of(model: EngineModel) -> Callers:
    """Build the function (t, q, c) -> distances (k,) of the surfaces of each pair, negative inside."""
    t, q, u, c = model.symbols("t q u c")
    gap = model.function("gaps")(t, q, u, c)[0]
    apart = distances(model, {"t": t, "y": ca.vertcat(q, u), "gap": gap}, c)
    return Callers(ca.Function("distance", [t, q, c], [ca.densify(ca.substitute(apart, u, ca.SX.zeros(model.nu)))]))


@per_model
def _changes(model: EngineModel) -> Callers:
    """Build the function (t, q, u, c, by) -> changes of the fields of `State` by those of q, u and c."""
    t, q, u, c = model.symbols("t q u c")
    to, results = ca.vertcat(q, u, c), _equations(model).function(t, q, u, c)
    by = ca.SX.sym("by", to.numel())
    return Callers(
        ca.Function("changes", [t, q, u, c, by], [ca.densify(ca.jtimes(ca.vec(x), to, by)) for x in results])
    )


class Equations:
    """Equations of a model with numbers."""

    def __init__(self, model: EngineModel, bound: BoundParameters) -> None:
        self.model, self.bound, self._c, self._evaluate = model, bound, bound.c, _equations(model)
        self._closing, self._work = closing(model), _work(model)
        self.booked = self._work is not None

    def at(self, t: float, y: Array) -> State:
        """Return the motion at a time and state y = (q, u)."""
        return self._state(self._evaluate, t, y)

    def _state(self, function: Callers, t: float, y: Array, *more: Array) -> State:
        nq, nu, k = self.model.nq, self.model.nu, self.model.k
        m = k + sum(_tangents(self.model))
        sizes = ((nq,), (nu,), (m, nu), (m, m), (m,), (m,), (k,))  # by columns
        results = function(t, y[:nq], y[nq:], self._c, *more)
        parts = [np.asarray(x).ravel("F").reshape(shape) for x, shape in zip(results, sizes, strict=True)]
        return State(parts[0], parts[1], parts[2].T, *parts[3:])

    def changes(self, t: float, y: Array, s: Array, dc: Array) -> State:
        """Return the changes of the motion by those of the state (nq + nu,) and of the constants (nc,)."""
        return self._state(_changes(with_shapes(self.model)), t, y, np.concatenate([s, dc]))

    def work(self, t: float, y: Array, forces: Array) -> tuple[float, float]:
        """Return the power [W] of drives and effects under forces (m,), and the work [J] at such impulses."""
        if self._work is None:
            return 0.0, 0.0
        power, work = self._work(t, y[: self.model.nq], y[self.model.nq :], forces, self._c)
        return float(np.sum(power)), float(np.sum(work))

    def closed(self, t: float, y: Array, normals: list[int], held: list[int], gaps: list[int]) -> Array:
        """Return a state on its constraints: of loops, gaps of pairs, velocities along rows, unit quaternions.

        The corrections are the least in kinetic energy.
        """
        model, y = self.model, y.copy()
        for first in model.quaternions:
            y[first : first + 4] /= np.linalg.norm(y[first : first + 4])
        if self._closing is not None:
            whole = np.concatenate([y, np.zeros(model.nz)])
            y = np.array(self._closing.function(t, whole, self._c)[0]).ravel()[: len(y)]
        if normals:
            at = self.at(t, y)
            moved = at.pushed[:, normals] @ np.linalg.lstsq(at.D[np.ix_(normals, normals)], -at.gap[gaps])[0]
            q = y[: model.nq].copy()  # whose rates by speeds are taken
            by, without = (model.evaluate("coordinate_rates", t, q, u, self._c)[0] for u in (moved, 0 * moved))
            y[: model.nq] += by - without
        if held:
            at = self.at(t, y)
            y[model.nq :] += at.pushed[:, held] @ np.linalg.lstsq(at.D[np.ix_(held, held)], -at.velocity[held])[0]
        return y
