"""Stick and slip of pairs that may slide in two directions: forces within discs.

With normal forces given, friction forces lambda and sliding accelerations a = W lambda + b are those of the least
lambda^T W lambda/2 + b^T lambda with each |lambda| below its limit: inside a disc a = 0, on its edge lambda opposes a.
First all pairs stick. Where that takes more than is held, pairs are limited by their sliding force, and the least is
found pair by pair, each exactly (the secular equation of a trust region), again and again until nothing changes.

De Saxce, Feng, Math. Comput. Modelling 28 (1998) 225; Conn, Gould, Toint, Trust-Region Methods (2000), section 7.3.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import casadi as ca

from hertzwerk.runtime.integrate.step.set_valued_friction import size_of, solve_sticking, unit_of

SWEEPS = 8  # over all pairs, between checks whether anything changes
ROUNDS = 50  # of as many sweeps; redundant pairs need hundreds, one in a hundred random bodies on eight feet more
SETTLED = 1e-10  # of the largest limit: change of a force by a sweep that counts as none
ON_EDGE = 1e-9  # of a limit: a force nearer to it slides
SINGULAR = 1e-12  # of a mobility: shift that keeps it regular where a pair can move in one direction only
SECULAR = 8  # Newton iterations of the secular equation; they converge quadratically, from one side

Groups = tuple[tuple[int, ...], ...]


@lru_cache(maxsize=16)
def settling(groups: Groups) -> Any:
    """Return the function (W, b, open, sliding, slip, bound) -> (slip, busy) for these pairs.

    groups: the places of each pair's tangents. slip: directions of sliding, 0 while sticking; kept for pairs that are not
    open. busy: 1 if the sweeps did not end.
    """
    given = _symbols(groups, "W b open sliding slip bound")
    W, b, still, sliding, _, bound = given
    force = solve_sticking(W, still, -b)
    over = still * (_sizes(groups, force) > bound)
    limit = still * ca.if_else(over, sliding, bound)
    stuck = ca.Function("stuck", given, ca.cse([_within(groups, force, limit), limit, ca.mmax(over)]))
    sweep, directions = _sweep(groups), _directions(groups)
    arguments = sweep.mx_in()
    lazy = ca.Function.if_else("lazy", sweep, ca.Function("unchanged", arguments, arguments[4:]))
    asked = stuck.mx_in()
    now = stuck.call(asked)
    for _ in range(ROUNDS if len(groups) > 1 else 1):
        now = lazy.call([now[2], *asked[:4], *now])
    slip = directions.call([*asked[:3], asked[4], *now[:2]])
    return ca.Function("settled", asked, [*slip, now[2]])


def _sweep(groups: Groups) -> Any:
    """Build the function (W, b, open, sliding, force, limit, busy) -> (force, limit, busy).

    Every pair changes a few times. Where nothing changes any more, pairs at a limit beyond their sliding force let go of it.
    """
    once = _once(groups)
    arguments = once.mx_in()
    now = arguments[4:]
    for _ in range(SWEEPS if len(groups) > 1 else 2):
        now = once.call([*arguments[:4], *now])
    return ca.Function("sweep", arguments, now)


def _once(groups: Groups) -> Any:
    """Build the function of one sweep."""
    given = [*_symbols(groups, "W b open sliding force limit"), ca.SX.sym("busy")]
    W, b, still, sliding, force, limit, _ = given
    new = ca.SX(force)
    for group in map(list, groups):
        inner = W[group, group]
        push = -(b[group] + ca.mtimes(W[group, :], new) - ca.mtimes(inner, new[group]))
        new[group] = still[group] * _least(inner, push, limit[group[0]])
    changes = ca.mmax(ca.fabs(new - force)) > SETTLED * ca.mmax(limit)
    lets_go = (1 - changes) * _on_edge(groups, still, new, limit) * (limit > sliding)
    outputs = [new, ca.if_else(lets_go, sliding, limit), changes + ca.mmax(lets_go) > 0]
    return ca.Function("once", given, ca.cse(outputs))


def _least(W: Any, push: Any, limit: Any) -> Any:
    """Return the force of one pair with |force| <= limit and the least force^T W force/2 - push^T force."""
    if push.numel() == 1:
        return ca.fmin(ca.fmax(push / ca.if_else(W > 0, W, 1), -limit), limit) * (W > 0)
    trace, bound = W[0, 0] + W[1, 1], ca.if_else(limit > 0, limit, 1)

    def solved(right: Any, shift: Any) -> Any:
        p, r, q = W[0, 0] + shift, W[1, 1] + shift, W[0, 1]
        determinant = p * r - q * q
        return ca.vertcat(r * right[0] - q * right[1], p * right[1] - q * right[0]) / ca.if_else(
            determinant > 0, determinant, 1
        )

    free = solved(push, SINGULAR * trace)
    shift = ca.fmax(size_of(push) / bound - trace, SINGULAR * trace)
    for _ in range(SECULAR):
        force = solved(push, shift)
        size = size_of(force)
        bend = ca.dot(force, solved(force, shift))
        shift = ca.fmax(shift + (size / bound - 1) * size**2 / ca.if_else(bend > 0, bend, 1), SINGULAR * trace)
    held = ca.if_else(size_of(free) <= limit, free, limit * unit_of(solved(push, shift)))
    return ca.if_else((trace > 0) * (limit > 0), held, 0)


def _directions(groups: Groups) -> Any:
    """Build the function (W, b, open, slip, force, limit) -> slip: directions of what slides.

    What sticks is held by the forces of least norm, as it will be from now on: who cannot hold his slides too.
    """
    given = _symbols(groups, "W b open slip force limit")
    W, b, still, slip, force, limit = given
    edge = _on_edge(groups, still, force, limit)
    driven = ca.if_else(edge, force, 0)
    b = b + ca.mtimes(W, driven)
    sticks = still * (1 - edge)
    held = solve_sticking(W, sticks, -b)
    beyond = sticks * (_sizes(groups, held) > limit * (1 + SETTLED))
    found = ca.if_else(still, 0, slip)
    for group in map(list, groups):
        # without a limit the force is none, and the pair goes where the others make it
        way = ca.if_else(limit[group[0]] > 0, -unit_of(force[group]), unit_of(b[group]))
        found[group] += edge[group] * way - beyond[group] * unit_of(held[group])
    return ca.Function("directions", given, [ca.cse(ca.densify(found))])


def _symbols(groups: Groups, names: str) -> list[Any]:
    n = sum(map(len, groups))
    return [ca.SX.sym(name, n, n if name == "W" else 1) for name in names.split()]


def _sizes(groups: Sequence[Sequence[int]], x: Any) -> Any:
    """Return the length of each pair's part of a vector, for each of its tangents."""
    found = ca.fabs(x)
    for group in map(list, groups):
        found[group] = size_of(x[group])
    return found


def _on_edge(groups: Groups, still: Any, force: Any, limit: Any) -> Any:
    return still * (_sizes(groups, force) >= (1 - ON_EDGE) * limit)


def _within(groups: Groups, force: Any, limit: Any) -> Any:
    """Return forces, those beyond their limits shortened to them."""
    sizes = _sizes(groups, force)
    return ca.if_else(sizes > limit, force * limit / ca.if_else(sizes > 0, sizes, 1), force)
