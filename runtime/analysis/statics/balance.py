"""Balance of forces at rest: F + G^T lambda + D mu = 0 where the loops are closed.

F by loads, springs and the elastic forces of closed contacts, lambda of closed loops, mu of contacts that stick: the
force along the tangent of set-valued friction, or the deflection of the bristle of a LuGre law, which is a state.
Neither mu follows from the position, but both have a limit.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.friction.limit_sets import measured
from hertzwerk.runtime.engine.integration.step.set_valued_friction import grips_of, groups_of, pair_grips, pairs_of
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.solution.impacts import distances
from hertzwerk.runtime.system.arrays import Array

RANK = 1e-9  # singular value over the largest below which it counts as zero
STILL = 1e-9  # rate at rest over its terms that counts as zero
FOLLOWED = 4  # iterations for states of effects, whose rates are linear as a rule
UNDAMPED = 1e12  # m/s, approach speed at which damping laws vanish: at rest nothing approaches


@dataclass(frozen=True)
class Balance:
    """Forces and directions at a position, by the speeds' freedoms; n grips.

    force (nu), loops (nl) and their directions G (nl, nu); D (nu, n) by mu, S (n, nu) of sliding, limit (n) of mu;
    stiffness K (nu, nu), minus the derivative of F + G^T lambda + D mu; moves (nq, nu) of the coordinates, states of
    effects as they follow; gap (k) [m] and its directions W (k, nu), normal force (k) [N], in_range (k).
    """

    force: Array
    loops: Array
    G: Array
    D: Array
    S: Array
    limit: Array
    stiffness: Array
    moves: Array
    gap: Array
    W: Array
    normal: Array
    in_range: Array


def balance(
    model: EngineModel, bound: BoundParameters, t: float, q: Array, closed: Array, multipliers: Array, mu: Array
) -> Balance:
    """Evaluate the balance at q (nq,), with closed pairs (k,) [0 or 1], multipliers (nl,) and mu (n,)."""
    nu, nq, nl, k, n = model.nu, model.nq, model.nl, model.k, len(grip_pairs(model))
    shapes = ((nu,), (nl,), (nl, nu), (nu, n), (n, nu), (n,), (nu, nq), (nq, nu), (k,), (k, nu), (k,), (k,))
    results = _balance(model)(t, q, closed, multipliers, mu, bound.c)
    force, loops, G, D, S, limit, slopes, moves, *contacts = (
        np.asarray(x).reshape(shape) for x, shape in zip(results, shapes, strict=True)
    )
    own = list(followers(model))
    if own:
        _, change = drift(model, bound, t, q)
        others = [row for row in range(nq) if row not in own]
        moves[own] = np.linalg.lstsq(change[np.ix_(own, own)], -change[np.ix_(own, others)] @ moves[others])[0]
    gap, W, normal, in_range = contacts
    return Balance(force, loops, G, D, S, limit, -slopes @ moves, moves, gap, W, normal, in_range)


def drift(model: EngineModel, bound: BoundParameters, t: float, q: Array) -> tuple[Array, Array]:
    """Return the rates (nq,) of the coordinates at rest, and their derivatives (nq, nq) by q."""
    rates, change = _drift(model)(t, q, bound.c)
    return np.asarray(rates).reshape(model.nq), np.asarray(change).reshape(model.nq, model.nq)


def drifting(model: EngineModel, bound: BoundParameters, t: float, q: Array) -> dict[str, float]:
    """Return the rate of every state that goes on changing at rest, as a controller's integral.

    What only counts, as the time to a sample, is none of them: no force depends on it.
    """
    rates, change = drift(model, bound, t, q)
    moving = np.abs(rates) > STILL * (np.abs(change) @ np.abs(q))
    return {model.coordinates[i]: float(rates[i]) for i in felt(model) if moving[i]}


def followed(model: EngineModel, bound: BoundParameters, t: float, q: Array) -> Array:
    """Return q (nq,) with states of effects at rest, as a motor's current, by Newton's method."""
    own, at_rest = list(followers(model)), q.copy()
    for _ in range(FOLLOWED if own else 0):
        rates, change = drift(model, bound, t, at_rest)
        step = np.linalg.lstsq(change[np.ix_(own, own)], -rates[own])[0]
        if not np.all(np.isfinite(step)):
            break
        at_rest[own] += step
    return at_rest


def grip_pairs(model: EngineModel) -> tuple[int, ...]:
    """Return the pair of every grip: of set-valued friction, then of bristles."""
    return (*pairs_of(model), *(j for _, j in bristles_of(model)))


def grip_names(model: EngineModel) -> list[str]:
    """Return the name of every grip: of a pair or an effect, then of the friction whose bristle it is."""
    return [
        *grips_of(model),
        *(model.memory[row].rpartition(".")[0] for row, _ in bristles_of(model)),
    ]


def sizes_of(model: EngineModel, mu: Array) -> Array:
    """Return the size of each mu (n,): of a pair that may slide in two directions, that of all together."""
    sizes = np.abs(mu)
    for group in groups_of(grip_names(model)):
        sizes[group] = gauge_of(mu[group])
    return sizes


def gauge_of(mu: Array) -> float:
    """Return the size of what one grip holds with: the least limit that holds it."""
    return float(np.linalg.norm(mu)) if mu.size < 3 else float(measured()(mu))


def along_of(model: EngineModel, along: Array) -> Array:
    """Return the generalised forces (nf, n) along the n tangents of a pair, from their sequence."""
    return along.reshape(-1, model.function("applied").numel_out(0)).T


def memory_of(model: EngineModel, mu: Array) -> Array:
    """Return the memory z (nz,) at rest: the bristles deflected."""
    z = np.zeros(model.nz)
    for i, (row, _) in enumerate(bristles_of(model), model.ns):
        z[row] = mu[i]
    return z


def bristles_of(model: EngineModel) -> Sequence[tuple[int, int]]:
    """Return the entry of the memory and the pair of every bristle or of its parts."""
    bristles: Sequence[tuple[int, int]] = model.module.BRISTLES
    return bristles


@per_model
def followers(model: EngineModel) -> tuple[int, ...]:
    """Return the states, by coordinate, whose rates at rest depend on states: they come to rest."""
    _, (_, change) = _rates_at_rest(model)
    return tuple(sorted(set(change.sparsity().get_triplet()[0])))


@per_model
def felt(model: EngineModel) -> tuple[int, ...]:
    """Return the coordinates, states among them, on which forces or rates at rest depend."""
    (t, q, c), (_, change) = _rates_at_rest(model)
    u, reactions = model.symbols("u reactions")
    forces = [model.function("applied")(t, q, u, c)]
    if model.has_function("loads"):
        forces.append(model.function("loads")(t, q, u, reactions, c))
    jacobian = ca.vertcat(ca.jacobian(ca.vertcat(*forces), q), change)
    return tuple(sorted(set(jacobian.sparsity().get_triplet()[1])))


@per_model
def _drift(model: EngineModel) -> Callers:
    """Build the function (t, q, c) -> rates (nq) at rest, and their derivatives (nq, nq)."""
    arguments, results = _rates_at_rest(model)
    return Callers(ca.Function("drift", arguments, [ca.densify(x) for x in results]))


def _rates_at_rest(model: EngineModel) -> tuple[list[ca.SX], list[ca.SX]]:
    """Return the symbols t, q, c, and by them the rates (nq) at rest and their derivatives (nq, nq)."""
    t, q, c = model.symbols("t q c")
    rates = model.function("coordinate_rates")(t, q, ca.SX.zeros(model.nu), c)
    return [t, q, c], [rates, ca.jacobian(rates, q)]


@per_model
def _balance(model: EngineModel) -> Callers:
    """Build the function (t, q, closed, multipliers, mu, c) -> fields of `Balance`."""
    t, q, u, closed, multipliers, c, z = model.symbols("t q u mode multipliers c z")
    grips = grip_pairs(model)
    mu = ca.SX.sym("mu", len(grips))
    m = ca.vertcat(UNDAMPED * ca.SX.ones(model.nm - model.ns), ca.SX.zeros(model.ns))
    force = model.function("applied")(t, q, u, c)[: model.nu, :]
    normal, in_range = ca.SX.zeros(model.k), ca.SX.ones(model.k)
    D, S, limit = ca.SX.zeros(model.nu, len(grips)), ca.SX.zeros(len(grips), model.nu), ca.SX.zeros(len(grips))
    contact: list[ca.SX] = []
    for j, pair in enumerate(model.pairs):
        touches = closed[j] > 0
        f, _, pressing, sliding, in_range_j, *_ = model.function(f"contact_{pair}")(t, q, u, z, m, c)
        force += ca.if_else(touches, f[: model.nu, :], 0)
        contact.append(ca.if_else(touches, f, 0))
        normal[j], in_range[j] = ca.if_else(touches, pressing, 0), ca.if_else(touches, in_range_j, 1)
        slips = [i for i, own in enumerate(pairs_of(model)) if own == j]
        if slips:
            velocity, along, _, _, holding = pair_grips(model, j, t, q, u, z, m, c)
            D[:, slips] = ca.if_else(touches, along[: model.nu, :], 0)
            S[slips, :] = ca.jacobian(velocity, u)
            limit[slips] = ca.if_else(touches, holding, 0)
        own_bristles = [(i, row) for i, (row, own) in enumerate(bristles_of(model), model.ns) if own == j]
        for i, row in own_bristles:
            along = ca.jacobian(f, z[row])
            D[:, i] = ca.if_else(touches, along[: model.nu, :], 0)
            # of bristles that bend in two directions the force along each is its speed's direction too
            S[i, :] = along[: model.nu, :].T if len(own_bristles) > 1 else ca.jacobian(sliding, u)
            limit[i] = ca.if_else(touches, 1, 0)
    if model.has_function(
        "loads"
    ):  # by reactions and normal forces, which at rest are those of the accelerations' own solution
        whole = sum(contact, start=model.function("applied")(t, q, u, c))
        reactions = model.function("accelerations").call([t, q, u, whole, c])[1]
        force += model.function("loads")(t, q, u, reactions, c)[: model.nu, :]
    loops, rate = model.function("constraints")(t, q, u, c) if model.nl else (ca.SX(0, 1), ca.SX(0, 1))
    gap, gap_rate = model.function("gaps")(t, q, u, c) if model.k else (ca.SX(0, 1), ca.SX(0, 1))
    G, W, moves = (
        ca.jacobian(rate, u),
        ca.jacobian(gap_rate, u),
        ca.jacobian(model.function("coordinate_rates")(t, q, u, c), u),
    )
    total = force + ca.mtimes(G.T, multipliers) + ca.mtimes(D, mu)
    gap = distances(model, {"t": t, "y": ca.vertcat(q, u), "gap": gap}, c)
    results = [force, loops, G, D, S, limit, ca.jacobian(total, q), moves, gap, W, normal, in_range]
    at_rest = ca.substitute(results, [u, z], [ca.SX.zeros(model.nu), ca.SX.zeros(model.nz)])
    arguments = [t, q, closed, multipliers, mu, c]
    return Callers(ca.Function("balance", arguments, [ca.densify(x) for x in ca.cse(at_rest)]))


def limits(model: EngineModel, bound: BoundParameters, at: Balance) -> Array:
    """Return the limits of mu (n,): of friction forces [N], and of the deflection of bristles [m]."""
    bounds = at.limit.copy()
    if len(bounds) > model.ns:
        sizes = model.evaluate("scales", bound.p)[2]
        bounds[model.ns :] *= [sizes[row] for row, _ in bristles_of(model)]
    return np.abs(bounds)


def kernel(matrix: Array) -> Array:
    """Return an orthonormal basis (n, d) of what a matrix (m, n) sends to zero."""
    if not matrix.shape[0]:
        return np.eye(matrix.shape[1])
    _, sizes, ways = np.linalg.svd(matrix)
    rank = int(np.sum(sizes > RANK * max(float(sizes[0]), 1e-300))) if len(sizes) else 0
    return ways[rank:].T
