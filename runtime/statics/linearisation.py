"""Linearisation of the equations of motion, reduced to what loops and sticking contacts leave free.

A small deviation of the state keeps the loops closed, its quaternions of unit norm, and what sticks at rest: it is
T x with T a basis of the kernel of all these conditions, which the linear motion does not leave. What drives
integrate, and what only counts energy or whole turns, deviates not at all. x are deviations of some of the states, so that x' = A x
holds too where constraints turn with the motion, and T with them; A is then another for other states.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np
import scipy.linalg
from numpy.typing import NDArray

from hertzwerk.runtime.integrate.step.implicit import linearised
from hertzwerk.runtime.integrate.step.layout import CONTACT
from hertzwerk.runtime.integrate.step.redundant import relax_redundant
from hertzwerk.runtime.integrate.step.set_valued_friction import NO_PAIR, pair_grips, pairs_of, sticking
from hertzwerk.runtime.model.caller import Callers
from hertzwerk.runtime.model.per_model import per_model
from hertzwerk.runtime.start import start_values
from hertzwerk.runtime.statics.balance import RANK, Array, kernel

if TYPE_CHECKING:
    from collections.abc import Sequence

    from hertzwerk.runtime.model.model import Bound, Model


@dataclass(frozen=True)
class Linearisation:
    """Linear equations x' = A x of deviations T x of the state; A (n, n) [1/s], T (ny, n) in SI.

    of: states (n) that x deviates from, each in its scale; turns: whether T changes with the motion.
    """

    A: Array
    T: Array
    of: Sequence[int]
    turns: bool


def linearise(
    model: Model, bound: Bound, t: float, q: Array, u: Array, z: Array, mode: Array, m: Array
) -> Linearisation:
    """Linearise at a state, with modes (k,) of the pairs and latches and slips m (nm,)."""
    live = model.without_redundancy(start_values.dependent(model, bound, q))
    c, scales = bound.c, model.evaluate("scales", bound.p)
    y = np.concatenate([q, u, z])
    unit = np.concatenate([np.where(np.isfinite(x) & (x > 0), x, 1.0) for x in scales[:3]])
    if live.dependent:
        c = np.array(_relaxed(live)(t, y, c, unit, scales[3])).ravel()
    J = np.array(_jacobian(live)(t, y, mode, m, c)[0])
    conditions = _conditions(model, bound, t, q, u, z, mode, m, J)
    rows = conditions * unit
    sizes = np.linalg.norm(rows, axis=1)
    rows[sizes > 0] /= sizes[sizes > 0, None]
    free = kernel(rows)
    of = _independent(free, np.split(np.arange(len(y)), [model.nq, model.nq + model.nu]))
    free = free @ np.linalg.inv(free[of])
    A = (J * unit / unit[:, None])[of] @ free
    turning = rows[model.nl : 2 * model.nl, : model.nq] @ free[: model.nq]  # of the loops' directions, by the motion
    return Linearisation(A, unit[:, None] * free, of, bool(np.any(np.abs(turning) > RANK)))


def _independent(free: Array, blocks: Sequence[NDArray[np.int64]]) -> list[int]:
    """Return n rows of a basis (ny, n) that determine a deviation, of the first blocks where possible."""
    chosen: list[int] = []
    for block in blocks:
        R, order = scipy.linalg.qr(free[block].T, mode="r", pivoting=True)
        picked = block[order[: np.count_nonzero(np.abs(np.diag(R)) > RANK)]]
        chosen += picked.tolist()
        free = free @ kernel(free[picked])
    return chosen


@per_model
def _jacobian(model: Model) -> Callers:
    function = linearised(model)
    given = function.sx_in() if function.is_a("SXFunction") else function.mx_in()
    return Callers(ca.Function("jacobian", given, [ca.densify(function(*given)[0])]))


@per_model
def _relaxed(model: Model) -> Any:
    """Return the function (t, y, c, scale, scales) -> c with redundant constraints relaxed."""
    t, y, c = model.symbols("t y c")
    scale, scales = ca.SX.sym("scale", y.numel()), ca.SX.sym("scales", 4)
    run = relax_redundant(model)({"t": t, "y": y}, {"c": c, "scale": scale, "scales": scales})
    return ca.Function("relaxed", [t, y, c, scale, scales], [run["c"]])


def _conditions(
    model: Model, bound: Bound, t: float, q: Array, u: Array, z: Array, mode: Array, m: Array, J: Array
) -> Array:
    """Return the linear conditions (any, ny) on deviations of the state."""
    nq, nu, ny = model.nq, model.nu, len(J)
    of_q, of_rates, sliding, moves = _derivatives(model)(t, q, u, z, m, bound.c)
    rows = [
        np.hstack([of_q.reshape(model.nl, nq), np.zeros((model.nl, ny - nq))]),
        np.hstack([of_rates.reshape(model.nl, nq + nu), np.zeros((model.nl, ny - nq - nu))]),
    ]
    for i in model.quaternions:
        rows.append(np.zeros((1, ny)))
        rows[-1][0, i : i + 4] = q[i : i + 4]
    moves = moves.reshape(nq, nu)
    counts = [f"{name}.near" for name, kind, _ in model.module.EFFECTS if kind == "counted_angle"]
    still = [
        i for i, name in enumerate(model.coordinates) if not np.any(moves[i]) or name in counts
    ]  # what drives integrate, what only counts
    idle = [nq + nu + i for i in range(model.nz) if not np.any(J[:, nq + nu + i])]  # what counts energy
    rows.append(np.eye(ny)[[*still, *idle]])
    at_rest, stuck = not np.any(u), sticking(model, m)
    for i, j in enumerate(pairs_of(model)):
        if (j == NO_PAIR or mode[j] == CONTACT) and stuck[i]:
            own = sliding.reshape(model.ns, nq + nu)[i]
            rows.append(np.concatenate([own, np.zeros(model.nz)])[None])
            if at_rest:  # what has not slid is where it was
                rows.append(np.concatenate([own[nq:] @ np.linalg.pinv(moves), np.zeros(ny - nq)])[None])
    return np.vstack(rows)


@per_model
def _derivatives(model: Model) -> Callers:
    """Build (t, q, u, z, m, c) -> derivatives of constraints, their rates, slips and coordinate rates."""
    t, q, u, _, _, c = given = model.symbols("t q u z m c")
    none = ca.SX(0, 1)
    loops, rates = model.function("constraints")(t, q, u, c) if model.nl else (none, none)
    of_joints = (
        model.function("rubbing")(t, q, u, ca.SX.zeros(*model.symbols("reactions")[0].shape), c)[0]
        if model.rubbing
        else none
    )
    sliding = [of_joints if j == NO_PAIR else pair_grips(model, j, *given)[0] for j in dict.fromkeys(pairs_of(model))]
    x, s = ca.vertcat(q, u), ca.vertcat(none, *sliding)
    moves = ca.jacobian(model.function("coordinate_rates")(t, q, u, c), u)
    results = [ca.jacobian(loops, q), ca.jacobian(rates, x), ca.jacobian(s, x), moves]
    return Callers(ca.Function("derivatives", given, [ca.densify(x) for x in ca.cse(results)]))
