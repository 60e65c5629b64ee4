"""Seated starts: journals rest in their bushes, pressed by the forces of their closed joints.

With the eccentricities e fixed, e'' = J a + ... = 0 with a from M a = f + J^T lambda gives the multipliers lambda:
the force of the closed joint on its journal. The contact exerts it where e is opposite to lambda, so deep that the
elastic force has its size. Both change with the position that they lead to by about the clearance over the lengths of
the mechanism: a fixed point, found by iteration.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.start.assembly import RANK, assemble_at, eccentricities

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
    from hertzwerk.runtime.system.arrays import Array

REPETITIONS = 100
SETTLED = 1e-8  # of the clearance: change of a seat that ends the iteration
NOTHING = 1e-12  # of the scene's force: smaller forces press nothing
SHALLOW = 1e-3  # of the clearance: first depth
POWER = 1.5  # assumed power of the depth in the force; then from two depths
UNDAMPED = 1e12  # m/s, approach speed at which damping laws vanish


@dataclass
class _Seat:
    """Iterate of a journal's seat: direction and depth found so far."""

    pair: str
    rows: list[int]  # among the eccentricities
    clearance: float
    depth: float
    power: float = POWER
    before: tuple[float, float] | None = None  # logarithms of a depth and its force

    def deepen(self, wanted: float, force: float) -> None:
        """Update the depth towards the wanted force, by a power law."""
        here = math.log(self.depth), math.log(force)
        if self.before is not None and abs(here[0] - self.before[0]) > 1e-6:
            self.power = min(max((here[1] - self.before[1]) / (here[0] - self.before[0]), 0.5), 5.0)
        self.before = here
        change = min(max((math.log(wanted) - here[1]) / self.power, -7.0), 7.0)
        self.depth *= math.exp(change)


def seat(
    model: EngineModel, bound: BoundParameters, q: Array, u: Array, fixed: Collection[str]
) -> tuple[Array, Array, tuple[Fault, ...]]:
    """Return coordinates (nq,), speeds (nu,) of the joints with journals seated, and faults.

    q, u: joints with the journals centred.
    """
    seats, scale = _initial_seats(model, bound, q, u), float(model.evaluate("scales", bound.p)[3][2])
    at: Array | None = None
    for _ in range(REPETITIONS):
        forces, loose = closed_forces(model, bound, q, u)
        if loose:
            return q, u, (_no_seat("their forces as closed joints are not determined: constraints are redundant"),)
        wanted = np.zeros(len(forces))
        for each in seats:
            force = float(np.linalg.norm(forces[each.rows]))
            if force <= NOTHING * scale:
                continue
            if at is not None and np.any(at[each.rows]):
                held = _elastic_force(model, bound, q, u, each.pair)
                if not (math.isfinite(held) and held > 0):
                    text = f"{each.pair} holds {held:.3g} N at a depth of {each.depth:.3g} m, pressed by {force:.3g} N"
                    return q, u, (_no_seat(text),)
                each.deepen(force, held)
            wanted[each.rows] = -forces[each.rows] / force * (each.clearance + each.depth)
        settled = at is not None and all(
            np.linalg.norm(wanted[each.rows] - at[each.rows]) <= SETTLED * each.clearance for each in seats
        )
        at = wanted
        q, u, faults = assemble_at(model, bound, q, u, fixed, at)
        if settled or faults:
            return q, u, faults
    return q, u, (_no_seat("their seats do not converge: the direction of their forces changes with their position"),)


def closed_forces(model: EngineModel, bound: BoundParameters, q: Array, u: Array) -> tuple[Array, bool]:
    """Return the forces [N] on journals as closed joints, and whether they are undetermined.

    They act along the eccentricities, caused by loads, gravity, inertia and drives at t = 0, in coordinates and
    speeds of the joints; no contact acts.
    """
    at = model.placed(bound, q, u)
    jacobian, applied = (np.array(x) for x in _moves(model)(0.0, *at, bound.c))

    def second(forces: Array) -> Array:
        a = model.function("accelerations")(0.0, *at, forces, bound.c)[0]
        return np.array(_second_rates(model)(0.0, *at, a, bound.c)).ravel()

    own = second(applied.ravel())
    columns = []
    for row in jacobian:
        pushed = applied.ravel().copy()
        pushed[: model.nu] += row
        columns.append(second(pushed) - own)
    yielding = np.array(columns).T
    sizes = np.sqrt(np.maximum(np.diag(yielding), 1e-300))
    multipliers, _, rank, _ = np.linalg.lstsq(yielding / np.outer(sizes, sizes), -own / sizes, rcond=RANK)
    return multipliers / sizes, bool(rank < len(own))


def _initial_seats(model: EngineModel, bound: BoundParameters, q: Array, u: Array) -> list[_Seat]:
    """Return the journals with initial depths."""
    there = 0.0, *model.placed(bound, q, u), bound.c
    e = np.array(eccentricities(model)(*there)[0]).ravel()
    gaps = dict(zip(model.pairs, model.evaluate("gaps", *there)[0], strict=True))
    seats, count = [], 0
    for pair, own in model.journals.items():
        rows = list(range(count, count := count + len(own)))
        clearance = gaps[pair] + math.hypot(gaps[pair], float(np.linalg.norm(e[rows])))  # of (c^2 - e^2)/2c
        seats.append(_Seat(pair, rows, clearance, SHALLOW * clearance))
    return seats


def _elastic_force(model: EngineModel, bound: BoundParameters, q: Array, u: Array, pair: str) -> float:
    """Return the normal force [N] of a pair at constant gap."""
    z, m = np.zeros(model.nz), np.full(model.nm, UNDAMPED)
    return float(model.evaluate(f"contact_{pair}", 0.0, *model.placed(bound, q, u), z, m, bound.c)[2][0])


@per_model
def _moves(model: EngineModel) -> Any:
    """Return the CasADi function (t, q, u, c) -> Jacobian of the eccentricities' rates, applied forces."""
    _, _, u, _ = at = model.symbols("t q u c")
    return ca.Function("moves", at, [ca.jacobian(eccentricities(model)(*at)[1], u), model.function("applied")(*at)])


@per_model
def _second_rates(model: EngineModel) -> Any:
    """Return the CasADi function (t, q, u, a, c) -> second derivatives of the eccentricities."""
    t, q, u, c = at = model.symbols("t q u c")
    (a,) = model.symbols("a")
    way = ca.vertcat(1, model.function("coordinate_rates")(*at), a)
    second = ca.jtimes(eccentricities(model)(*at)[1], ca.vertcat(t, q, u), way)
    return ca.Function("second_rates", [t, q, u, a, c], [second])


def _no_seat(problem: str) -> Fault:
    return Fault(
        "start, seated journals",
        problem,
        "journals that rest in their bushes",
        "Without seated=True they start centred.",
    )
