"""Set-valued friction that changes what it depends on.

That is friction of joints under their own reaction, and of contacts beside loads by reactions. What sticks holds with forces lambda for
which its sliding accelerations vanish, D^T a(f + D lambda) + drift = 0, found by Newton's method, for loads by reactions make the
accelerations a depend on the forces f as magnitudes do. A joint that slides has its coefficient of friction, with the sign of slip, among
the forces, and its reaction is solved with the accelerations (`derive.equations.motion.reaction_loads`). That there is one solution is
certified in every state: `friction.uniqueness`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.friction.uniqueness import bound, monotone, pivots, reach
from hertzwerk.runtime.engine.integration.step.linear_systems import eliminated
from hertzwerk.runtime.engine.integration.step.set_valued_friction import NO_PAIR, Grips, pairs_of, solve_sticking
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

ITERATIONS = 8  # of Newton's method, quadratic within a sign of every reaction
SETTLED = 1e-9  # of the terms of a sliding acceleration: most that a solution leaves


@dataclass(frozen=True)
class Solved:
    """Frictions of a state, and what follows from them.

    `held` (n): forces of what sticks [N]; `friction` (n): all [N]; f: all generalised forces; `pressing` (n): what limits are
    multiplied with, the reactions of joints; `rate` (n): sliding accelerations, and the size of their `terms`;
    `settled`: 1 where what sticks has none.
    """

    held: Any
    friction: Any
    f: Any
    pressing: Any
    rate: Any
    terms: Any
    settled: Any


def solved(model: EngineModel, grip: Grips, t: Any, q: Any, u: Any, f: Any, c: Any) -> Solved:
    """Solve for the frictions of grips beside all other generalised forces f."""
    slides = ca.if_else(grip.sticks, 0, grip.slipping())
    f = f + ca.mtimes(grip.pushing, slides)
    held, free = _sticking(model, len(grip.places))(t, q, u, f, grip.along, grip.across, grip.drift, grip.sticks, c)
    f = f + ca.mtimes(grip.along, held)
    a, reactions, *_ = model.function("accelerations").call([t, q, u, f, c])
    pressing = _pressing(model, grip, t, q, u, reactions, c)
    friction = held + slides * pressing
    rate = grip.drift + ca.mtimes(grip.across, a)
    terms = ca.fabs(grip.drift) + ca.mtimes(ca.fabs(grip.across), ca.fabs(free) + ca.fabs(a))
    left = ca.mmax(ca.if_else(grip.sticks, ca.fabs(rate) - SETTLED * terms, 0))
    return Solved(held, friction, f, pressing, rate, terms, left <= 0)


def booked(model: EngineModel, grip: Grips, friction: Any) -> Any:
    """Return the rates (nz) of the ledger by frictions of pairs; joints' are booked with the loads."""
    own, of_pairs = joints(model, grip), ca.SX(friction)
    of_pairs[own] = 0
    return ca.mtimes(grip.power, of_pairs)


def joints(model: EngineModel, grip: Grips) -> list[int]:
    """Return which grips are those of joints."""
    return [i for i, place in enumerate(grip.places) if pairs_of(model)[place] == NO_PAIR]


def _pressing(model: EngineModel, grip: Grips, t: Any, q: Any, u: Any, reactions: Any, c: Any) -> Any:
    pressing, own = ca.SX.ones(len(grip.places)), joints(model, grip)
    if own:
        pressing[own] = model.function("rubbing")(t, q, u, reactions, c)[1]
    return pressing


@per_model
def _sticking(model: EngineModel, n: int) -> Any:
    """Return the function of the forces (n) of what sticks, and of the accelerations without loads.

    Arguments: t, q, u, f, along, across, drift, sticks, c. Accelerations and reactions are linear in the forces without loads (`unloaded`),
    and loads in the magnitudes N of these, so that Newton's method needs no more than their derivatives.
    """
    t, q, u, f, c = model.symbols("t q u f c")
    along, across = ca.SX.sym("along", f.numel(), n), ca.SX.sym("across", n, model.nu)
    drift, sticks = ca.SX.sym("drift", n), ca.SX.sym("sticks", n)
    reactions = ca.SX.zeros(model.symbols("reactions")[0].shape)
    for _, coefficient, _, place in model.rubbing:
        reactions[place] = f[coefficient]
    a, parts = model.function("unloaded").call([t, q, u, f, c])
    of_a, of_parts = (ca.jtimes(x, f, ca.horzcat(along, _loads(model, t, q, u, reactions, c))) for x in (a, parts))
    sliding, known = ca.mtimes(across, of_a), drift + ca.mtimes(across, a)
    W, G, S, B = sliding[:, :n], sliding[:, n:], of_parts[:, :n], of_parts[:, n:]
    held, N = ca.SX.zeros(n), _magnitudes(parts)[0]
    for _ in range(ITERATIONS):
        size, unit = _magnitudes(parts + ca.mtimes(S, held) + ca.mtimes(B, N))
        by_held, by_N = ca.mtimes(unit, S), ca.mtimes(unit, B)
        follows = _solved(ca.SX.eye(N.numel()) - by_N, ca.horzcat(by_held, size - N))
        left = known + ca.mtimes(W, held) + ca.mtimes(G, N + follows[:, n])
        change = solve_sticking(W + ca.mtimes(G, follows[:, :n]), sticks, -left)
        held, N = held + change, N + follows[:, n] + ca.mtimes(follows[:, :n], change)
    arguments = [t, q, u, f, along, across, drift, sticks, c]
    return ca.Function("sticking", arguments, ca.cse([ca.densify(held), ca.densify(a)]))


def _magnitudes(parts: Any) -> tuple[Any, Any]:
    """Magnitudes (K) of vectors (3 K), one below the other, and derivatives (K, 3 K), zero at zero."""
    count = parts.numel() // 3
    sizes, slopes = ca.SX(count, 1), ca.SX(count, 3 * count)
    for k in range(count):
        own = [i for i in range(3 * k, 3 * k + 3) if not parts[i].is_zero()]
        square = ca.sumsqr(parts[own]) if own else ca.SX(0)
        size = ca.sqrt(ca.if_else(square > 0, square, 1))
        sizes[k] = ca.if_else(square > 0, size, 0)
        for i in own:
            slopes[k, i] = parts[i] / size
    return sizes, slopes


def _solved(matrix: Any, right: Any) -> Any:
    """Solve a linear system (K, K) for several right-hand sides (K, m)."""
    n = matrix.shape[0]
    solve = eliminated([[matrix[i, j] for j in range(n)] for i in range(n)], pivoting=False)
    columns = [ca.vertcat(ca.SX(0, 1), *solve([column[i] for i in range(n)])) for column in ca.horzsplit(right)]
    return ca.horzcat(*columns)


def _loads(model: EngineModel, t: Any, q: Any, u: Any, reactions: Any, c: Any) -> Any:
    """Loads (nf, K) per magnitude."""
    symbol = model.symbols("reactions")[0]
    slopes = ca.jacobian(model.function("loads")(t, q, u, symbol, c), symbol)[:, list(model.carried)]
    return ca.sparsify(ca.substitute(slopes, symbol, reactions))


def certificate(model: EngineModel, grip: Grips, t: Any, q: Any, u: Any, reactions: Any, c: Any) -> Any:
    """Return the pivots (n + K) of the certificate that there is one solution: positive where there is."""
    n, count = len(grip.places), len(model.carried)
    f, by = model.symbols("f reactions")
    a, parts = model.function("unloaded").call([t, q, u, f, c])
    others = ca.SX(reactions)  # but those of the frictions that slide in joints
    others[[place for *_, place in model.rubbing]] = 0
    columns = ca.horzcat(grip.along, _loads(model, t, q, u, others, c))
    of_a = ca.substitute(ca.jtimes(a, f, columns), f, ca.SX.zeros(f.numel()))
    of_parts = ca.substitute(ca.jtimes(parts, f, columns), f, ca.SX.zeros(f.numel()))
    sizes = ca.vertcat(
        ca.SX(0, n + count),
        *(ca.horzcat(*(_size(of_parts[3 * k : 3 * k + 3, j]) for j in range(n + count))) for k in range(count)),
    )
    sliding = ca.mtimes(grip.across, of_a)
    limits, own = ca.SX.zeros(n, count), joints(model, grip)
    if own and count:
        pressing = model.function("rubbing")(t, q, u, by, c)[1]
        limits[own, :] = ca.jacobian(pressing, by)[:, list(model.carried)]
    still = ca.if_else(grip.sticks + (grip.velocity == 0) > 0, grip.touching, 0)
    limits = limits * ca.repmat(ca.if_else(still, grip.holding, grip.sliding), 1, count)
    W, G, P = sliding[:, :n], sliding[:, n:], sizes[:, n:]
    margins = pivots(bound(still, W, G, limits, sizes[:, :n], P))
    if own:
        return margins
    # limits are known: where frictions are redundant, as of corners of one body, what they move together is unique
    loads = reach(solve_sticking, W, still, G)
    reactions = [
        ca.sqrt(ca.sumsqr(reach(solve_sticking, W, still, of_parts[3 * k : 3 * k + 3, :n].T))) for k in range(count)
    ]
    return ca.if_else(monotone(loads, ca.vertcat(ca.SX(0, 1), *reactions), P) > 0, 1, margins)


def _size(vector: Any) -> Any:
    parts = [vector[i] for i in range(3) if not vector[i].is_zero()]
    return ca.SX(0) if not parts else ca.fabs(parts[0]) if len(parts) == 1 else ca.sqrt(ca.sumsqr(ca.vertcat(*parts)))
