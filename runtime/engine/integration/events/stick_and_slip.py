"""Stick and slip of all pairs after a change: a linear complementarity problem with bounds.

Unknown for the pairs that do not slide are the friction forces lambda and the sliding accelerations a = W lambda + b,
with |lambda| below the holding force where a = 0, and the sliding force opposing a elsewhere. Friction of corners on
one rigid body, or on links nearly in line, is all but redundant, W nearly singular: lambda is then not unique, but a
is, and the bounds of lambda hold regardless. Solved by principal pivoting on the set of sticking pairs: first all
violating pairs at once, then, for termination, the first of them.

Judice, Pires, A block principal pivoting algorithm for large-scale strictly monotone linear complementarity problems,
Computers and Operations Research 21 (1994) 587. Where a pair may slide in two directions, see `slip_directions`.
"""

from __future__ import annotations

from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.events.slip_directions import settling
from hertzwerk.runtime.engine.integration.friction.limit_sets import opposed, size_of, unit_of
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, active_contacts, masked
from hertzwerk.runtime.engine.integration.step.fed_friction import joints, solved
from hertzwerk.runtime.engine.integration.step.set_valued_friction import (
    AHEAD,
    BREAKS,
    STICK,
    Grips,
    grips,
    grips_of,
    groups_of,
    mobility,
    slips_in,
    solve_sticking,
    sticking,
)
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

TOGETHER = 5  # rounds in which all violating pairs change; nearly always enough
ONE_BY_ONE = 3  # rounds per pair in which the first one changes
ROUNDING = 1e-10  # of the terms of an acceleration, below which it has no sign
AT_REST = 1.5  # of the size of the slip, across which a little speed is left: sliding velocity in two directions that counts as none


@per_model
def resolve_slips(model: EngineModel) -> Any:
    """Return the CasADi function of the state (m, y) after stick and slip are resolved.

    Its third result is 1 where they could not be.
    Arguments: t, y, mode, m, c, asked (n), tolerances of speeds [m/s] and forces [N] (n). asked: pairs whose
    direction of sliding is open, at an onset or at rest. Pairs sliding faster than the tolerance keep their
    direction. Of the others the complementarity problem decides; those that stuck may exceed the holding force by a
    part of the tolerance. Sticking pairs are brought to rest by impulses, whose work is booked as friction's.
    """
    n = model.ns
    arguments = [*model.symbols("t y mode m c", ca.MX), *(ca.MX.sym(name, n) for name in ("asked", "rate", "force"))]
    if not n:
        return ca.Function("directed", arguments, [arguments[3], arguments[1], 0])
    groups = tuple(map(tuple, groups_of(grips_of(model))))
    if model.fed:
        slip, busy = settled_slips(model)(*arguments)
    else:
        solve = pivoting(n) if len(groups) == n else settling(groups)
        slip, busy = solve(*_problem(model)(*arguments))
    if len(groups) < n:
        slip = _ahead(model)(*arguments, slip)
    m, y = at_rest(model)(*arguments[:5], slip)
    return ca.Function("directed", arguments, [m, y, busy])


def pivoting(n: int) -> Any:
    """Return the function (W, b, open, sliding, slip, bound) -> (slip, busy) by pivoting.

    busy: 1 if no solution was found from the initial slips.
    """
    return rounds(n, *(_round(n, one=one) for one in (False, True)))


def rounds(n: int, together: Any, single: Any) -> Any:
    """Return the function (constants.., slip, bound) -> (slip, busy) that repeats a round.

    together, single: (constants.., slip, bound, busy) -> (slip, bound, busy), a round in which all violating pairs change, or the first.
    """
    arguments = together.mx_in()
    *constants, slip, bound, _ = arguments
    unchanged = ca.Function("unchanged", arguments, [slip, bound, ca.MX(0)])
    now: list[Any] = [slip, bound, ca.MX(1)]
    for i in range(TOGETHER + ONE_BY_ONE * n):
        lazy = ca.Function.if_else("round", single if i >= TOGETHER else together, unchanged)
        now = lazy.call([now[2], *constants, *now])
    return ca.Function("settled", arguments[:-1], [now[0], now[2]])


def _problem(model: EngineModel) -> Any:
    """Build the function (arguments of `resolve_slips`) -> W, b, open, sliding, initial slips and bounds.

    open: pairs in contact that do not slide; b includes the friction of the others.
    """
    n = model.ns
    t, y, mode, m, c = model.symbols("t y mode m c")
    undecided, rate, force = (ca.SX.sym(name, n) for name in ("asked", "rate", "force"))
    q, u, z = model.parts(y)
    now = grips(model, BY_MODE, t, y, mode, m, c)
    f = model.function("applied")(t, q, u, c)
    for _, contact, active in active_contacts(model, BY_MODE, mode):
        f += masked(active, contact(t, q, u, z, m, c)[0])
    stays = now.sticks * (1 - undecided)  # whatever errors have left it of speed
    slow, way = ca.fabs(now.velocity) <= rate, ca.sign(now.velocity)
    pull = ca.if_else(undecided, way, now.direction)
    ahead = ca.SX(pull)
    for group in now.groups:
        if len(group) > 1:
            # the slip's own size: that of a new one would be of rounding, which may have grown a thousandfold since this one began
            size = size_of(now.slip[group])
            size = ca.if_else(size > 0, size, AHEAD * rate[group])
            slow[group] = size_of(now.velocity[group]) <= ca.fmax(AT_REST * size, rate[group])
            way[group] = unit_of(now.velocity[group])
            pull[group] = ca.if_else(undecided[group], opposed(now.velocity[group]), now.direction[group])
            ahead[group] = ca.if_else(undecided[group], way[group], unit_of(now.slip[group]))
    still = now.touching * (slow + stays > 0)
    slides = now.touching * (1 - still)
    a = model.function("accelerations").call([t, q, u, f - ca.mtimes(now.along, slides * pull * now.sliding), c])[0]
    b = now.drift + ca.mtimes(now.along[: model.nu, :].T, a)
    W = ca.mtimes(now.along[: model.nu, :].T, mobility(model, t, q, u, now.along, c))
    bound = now.holding + ca.if_else(undecided, 0, BREAKS * force)
    first = ca.if_else(still, ca.if_else(undecided, STICK, ahead), slides * ahead)
    arguments = [t, y, mode, m, c, undecided, rate, force]
    return ca.Function("problem", arguments, ca.cse([*map(ca.densify, (W, b, still, now.sliding, first, bound))]))


def _round(n: int, *, one: bool) -> Any:
    """Build one round of pivoting, (W, b, open, sliding, slip, bound, busy) -> (slip, bound, busy).

    All violating pairs change, or the first `one`. A pair that returns to sticking is bounded by its sliding force,
    so that the final problem has a solution.
    """
    W, b, still, sliding, slip, bound = (
        ca.SX.sym(name, n, n if name == "W" else 1) for name in ("W", "b", "still", "sliding", "slip", "bound")
    )
    sticks = still * (slip == STICK)
    driven = -still * slip * sliding
    force = driven + solve_sticking(W, sticks, -(b + ca.mtimes(W, driven)))
    a = b + ca.mtimes(W, force)
    terms = ca.fabs(b) + ca.mtimes(ca.fabs(W), ca.fabs(force))
    lets_go = sticks * (ca.fabs(force) > bound)
    returns = still * (1 - sticks) * (slip * a < -ROUNDING * terms)
    changes = lets_go + returns
    if one:
        lets_go, returns = (part * first_of(changes) for part in (lets_go, returns))
    new = ca.if_else(lets_go, -ca.sign(force), ca.if_else(returns, STICK, slip))
    arguments = [W, b, still, sliding, slip, bound, ca.SX.sym("busy")]
    return ca.Function("round", arguments, ca.cse([new, ca.if_else(lets_go, sliding, bound), ca.mmax(changes) > 0]))


def first_of(changes: Any) -> Any:
    """Return 1 for the first of what changes (n)."""
    earlier, only = ca.SX(0), []
    for change in ca.vertsplit(changes):
        only.append(change * (earlier == 0))
        earlier += change
    return ca.vertcat(*only)


@per_model
def settled_slips(model: EngineModel) -> Any:
    """Return the function (arguments of `resolve_slips`) -> (slips (n), busy) of a fed model."""
    n = model.ns
    t, y, mode, m, c = model.symbols("t y mode m c")
    undecided, rate, force = (ca.SX.sym(name, n) for name in ("asked", "rate", "force"))
    now = grips(model, BY_MODE, t, y, mode, m, c)
    still = now.touching * ((ca.fabs(now.velocity) <= rate) + now.sticks * (1 - undecided) > 0)
    ahead = ca.if_else(undecided, ca.sign(now.velocity), now.slip)
    first = ca.if_else(still, ca.if_else(undecided, STICK, ahead), now.touching * ahead)
    slack = ca.if_else(undecided, 0, BREAKS * force)
    arguments = [t, y, mode, m, c, undecided, rate, force]
    begin = ca.Function("open", arguments, [ca.densify(part) for part in (still, slack, first, ca.SX.zeros(n))])
    asking = begin.mx_in()
    pivoting_rounds = rounds(n, *(_fed_round(model, one=one) for one in (False, True)))
    return ca.Function("settled", asking, list(pivoting_rounds.call([*asking[:5], *begin.call(asking)])))


def _fed_round(model: EngineModel, *, one: bool) -> Any:
    """Build one round of pivoting of a fed model.

    (t, y, mode, m, c, open, slack, slip, let go, busy) -> (slip, let go, busy), as `_round`, with limits and accelerations under the
    friction of the round; `let go` (n): 1 for what has slipped once.
    """
    n = model.ns
    t, y, mode, m, c = model.symbols("t y mode m c")
    still, slack, slip, free = (ca.SX.sym(name, n) for name in ("still", "slack", "slip", "free"))
    q, u, z = model.parts(y)
    latches, _ = ca.vertsplit(m, [0, slips_in(model).start, model.nm])
    now = grips(model, BY_MODE, t, y, mode, ca.vertcat(latches, slip), c)
    f = model.function("applied")(t, q, u, c)
    for _, contact, active in active_contacts(model, BY_MODE, mode):
        f += masked(active, contact(t, q, u, z, m, c)[0])
    solution = solved(model, now, t, q, u, f, c)
    limit = ca.if_else(free, now.sliding, now.holding) * solution.pressing + slack
    lets_go = still * now.sticks * (ca.fabs(solution.held) > limit)
    returns = still * (1 - now.sticks) * (slip * solution.rate < -ROUNDING * solution.terms)
    changes = lets_go + returns
    if one:
        lets_go, returns = (part * first_of(changes) for part in (lets_go, returns))
    new = ca.if_else(lets_go, -ca.sign(solution.held), ca.if_else(returns, STICK, slip))
    arguments = [t, y, mode, m, c, still, slack, slip, free, ca.SX.sym("busy")]
    results = [new, ca.if_else(lets_go, 1, free), ca.mmax(changes) > 0]
    return ca.Function("round", arguments, ca.cse([*map(ca.densify, results)]))


def _ahead(model: EngineModel) -> Any:
    """Build the function (arguments of `resolve_slips`, directions (n)) -> slips (n).

    Of pairs with two tangents; those that slid and go on keep theirs.
    """
    arguments = [
        *model.symbols("t y mode m c"),
        *(ca.SX.sym(name, model.ns) for name in ("asked", "rate", "force", "way")),
    ]
    m, undecided, rate, way = arguments[3], arguments[5], arguments[6], arguments[8]
    slips, slip, goes_on = ca.SX(way), m[slips_in(model)], (1 - undecided) * (1 - sticking(model, m))
    for group in groups_of(grips_of(model)):
        if len(group) > 1:
            new = AHEAD * rate[group] * way[group]
            slips[group] = ca.if_else(goes_on[group] * (ca.sumsqr(way[group]) > 0), slip[group], new)
    return ca.Function("ahead", arguments, [ca.densify(slips)])


def at_rest(model: EngineModel) -> Any:
    """Build the function (t, y, mode, m, c, slip (n)) -> (m, y): set slips, stop sticking pairs."""
    (t, y, mode, m, c), slip = model.symbols("t y mode m c"), ca.SX.sym("slip", model.ns)
    q, u, z = model.parts(y)
    latches, _ = ca.vertsplit(m, [0, slips_in(model).start, model.nm])
    new = ca.vertcat(latches, slip)
    now = grips(model, BY_MODE, t, y, mode, new, c)
    change = mobility(model, t, q, u, now.along, c)
    W = ca.mtimes(now.across, change)
    impulse = solve_sticking(W, now.sticks, -now.velocity)
    # the speed at which an impulse works is the mean of those before and after, and after it is none
    moved = ca.vertcat(q, u + ca.mtimes(change, impulse), z + ca.mtimes(_work(model, now), impulse) / 2)
    return ca.Function("at_rest", [t, y, mode, m, c, slip], [new, ca.if_else(ca.mmax(now.sticks), moved, y)])


def _work(model: EngineModel, now: Grips) -> Any:
    """Rates (nz, n) of the ledger per newton of each friction, of joints too."""
    work = ca.SX(now.power)
    for i, (name, *_) in zip(joints(model, now), model.rubbing, strict=True):
        if model.has_ledger:
            work[model.memory.index(f"{name}.dissipated"), i] = -now.velocity[i]
    return work
