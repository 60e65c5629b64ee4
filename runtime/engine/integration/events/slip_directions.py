"""Stick and slip of pairs that may slide in two directions: forces within discs, and other limit sets.

With normal forces given, friction forces lambda and sliding accelerations a = W lambda + b are those of the least
lambda^T W lambda/2 + b^T lambda with each |lambda| below its limit: inside a disc a = 0, on its edge lambda opposes a.
First all pairs stick. Where that takes more than is held, pairs are limited by their sliding force, and the least is
found by an interior point method. Corners of one body may share a force in many ways, W is then singular: sweeps over
the pairs, one by one, need thousands there, Newton steps from within the discs about ten. For a patch (`limit_sets`) |x|
is the gauge of its body, with whose gradient and curvature a step is as good, but for its end, which is cut where it is outside.

De Saxce, Feng, Math. Comput. Modelling 28 (1998) 225; Nocedal, Wright, Numerical Optimization (2006), section 19.3;
Colombo, Gondzio, Comput. Optim. Appl. 41 (2008) 277, on the weight of a corrector.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.friction.limit_sets import (
    gauge,
    normal_and_curvature,
    outward,
    positive,
    unit_of,
)
from hertzwerk.runtime.engine.integration.step.linear_systems import eliminated
from hertzwerk.runtime.engine.integration.step.set_valued_friction import REDUNDANT, solve_sticking

ITERATIONS = 40  # of Newton's method; 9 to 13 end in random bodies on up to 16 feet
COMPLEMENTARY = 1e-18  # product of a pair's room in its disc and its sliding, both relative, that counts as none
BALANCED = 1e-11  # of its terms: error of an equation that counts as none
INSIDE = 0.995  # of the way to the nearest edge that a step goes
ON_EDGE = 1e-9  # of a limit: a force nearer to it slides
CUTS, EXACT = (
    4,
    1e-9,
)  # of a step beyond the edge of a patch's body, by halves; room from which it is known by the gauge
TINY = 1e-300

Groups = tuple[tuple[int, ...], ...]


@lru_cache(maxsize=16)
def settling(groups: Groups) -> Any:
    """Return the function (W, b, open, sliding, slip, bound) -> (slip, busy) for these pairs.

    groups: the places of each pair's tangents. slip: directions of sliding, 0 while sticking; kept for pairs that are not
    open. busy: 1 if no forces were found.
    """
    system = _symbols(groups, "W b open sliding slip bound")
    W, b, still, sliding, _, bound = system
    force = solve_sticking(W, still, -b)
    over = still * (_sizes(groups, force) > bound)
    limit = still * ca.if_else(over, sliding, bound)
    stuck = ca.Function("stuck", system, ca.cse([_within(groups, force, limit), limit, ca.mmax(over), 0]))
    limited, directions = _limited(groups), _directions(groups)
    arguments = limited.mx_in()
    lazy = ca.Function.if_else("lazy", limited, ca.Function("unchanged", arguments, arguments[4:]))
    inputs = stuck.mx_in()
    now = stuck.call(inputs)
    for _ in groups:
        now = lazy.call([now[2], *inputs[:4], *now])
    slip = directions.call([*inputs[:3], *inputs[4:], *now[:2]])
    return ca.Function("settled", inputs, [*slip, now[3]])


def _limited(groups: Groups) -> Any:
    """Build the function (W, b, open, sliding, force, limit, again, busy) -> (force, limit, again, busy).

    Forces within their limits. Pairs at one beyond their sliding force let go of it, and the forces are computed `again`.
    """
    starts, step, limited_force = _start(groups), _newton(groups), _limited_force(groups)
    arguments = step.mx_in()
    lazy = ca.Function.if_else("lazy", step, ca.Function("unchanged", arguments, arguments[3:]))
    n = sum(map(len, groups))
    system = [ca.MX.sym(name, n, n if name == "W" else 1) for name in ("W", "b", "open", "sliding", "force", "limit")]
    system += [ca.MX.sym("again"), ca.MX.sym("busy")]
    W, b, still, sliding, _, limit = system[:6]
    scaled = starts.call([W, b, limit])
    now = [ca.MX.zeros(n), ca.MX.ones(len(groups)), ca.MX.ones(len(groups)) / 2, ca.MX(1)]
    for _ in range(ITERATIONS):
        now = lazy.call([now[3], *scaled, *now])
    return ca.Function("limited", system, limited_force.call([still, sliding, limit, *now]))


def _start(groups: Groups) -> Any:
    """Build the function (W, b, limit) -> (W, b, size (k)) of forces as parts of their limits.

    size: of the terms in each pair's equations.
    """
    arguments = _symbols(groups, "W b limit")
    W, b, limit = arguments
    W, b = (W + REDUNDANT * ca.diag(ca.diag(W))) * ca.mtimes(limit, limit.T), b * limit
    terms = ca.fabs(b) + ca.sum2(ca.fabs(W))
    size = ca.vertcat(*(ca.mmax(terms[list(group)]) for group in groups))
    return ca.Function("start", arguments, ca.cse([W, b, ca.if_else(size > 0, size, 1)]))


def _newton(groups: Groups) -> Any:
    """Build the function (W, b, size, x, push, room, busy) -> (x, push, room, busy) of one step.

    A predictor and a corrector. x (n): forces in unit discs; push (k): what the edges press with, beside the size;
    room (k): (1 - |x|^2)/2. Solved are W x + b + size push x = 0 and push room = mu, with mu falling to zero.
    normal (n): x, or the gradient of minus the room.
    """
    n, k = sum(map(len, groups)), len(groups)
    W, b, x = ca.SX.sym("W", n, n), ca.SX.sym("b", n), ca.SX.sym("x", n)
    size, push, room = (ca.SX.sym(name, k) for name in ("size", "push", "room"))

    def each(of_pairs: Any) -> Any:
        result = ca.SX(x)
        for i, group in enumerate(groups):
            result[list(group)] = of_pairs[i]
        return result

    def dots(u: Any, v: Any) -> Any:
        return ca.vertcat(*(ca.dot(u[list(group)], v[list(group)]) for group in groups))

    edges = [normal_and_curvature(x[list(group)]) for group in groups]
    normal = ca.vertcat(*(of for of, _ in edges))
    bends = {i: curvature for i, (_, curvature) in enumerate(edges) if len(groups[i]) > 2}
    error, product = ca.mtimes(W, x) + b + each(size * push) * normal, push * room
    # along x and across it, since the press of an edge, along x, would drown what there is across
    axes, pressed, curved = ca.SX(n, n), each(size * push), ca.SX(W)
    for i, group in enumerate(map(list, groups)):
        way = ca.if_else(ca.sumsqr(normal[group]) > 0, unit_of(normal[group]), ca.DM([1.0, *[0.0] * (len(group) - 1)]))
        axes[group, group] = _axes(way)
        if i in bends:
            pressed[group] = 0
            curved[group, group] += size[i] * push[i] * bends[i]
        pressed[group[0]] += size[i] * push[i] / room[i] * ca.sumsqr(normal[group])
    matrix = ca.mtimes(axes.T, ca.mtimes(curved, axes)) + ca.diag(pressed)
    solve = eliminated([[matrix[i, j] for j in range(n)] for i in range(n)], pivoting=False)

    def squares(dx: Any) -> Any:
        result = dots(dx, dx)
        for i, curvature in bends.items():
            result[i] = ca.dot(dx[list(groups[i])], ca.mtimes(curvature, dx[list(groups[i])]))
        return result

    def inside(x: Any) -> Any:
        return ca.vertcat(*((1 - gauge(x[list(groups[i])]) ** 2) / 2 for i in bends))

    def step(aim: Any) -> tuple[Any, Any, Any]:
        right = -error - each(size * aim / room) * normal
        dx = ca.mtimes(axes, ca.vertcat(*solve(ca.vertsplit(ca.mtimes(axes.T, right)))))
        dpush = (aim + push * dots(normal, dx)) / room
        along, square = dots(normal, dx), squares(dx)
        edge = 2 * room / ca.fmax(along + ca.sqrt(along**2 + 2 * room * square), TINY)
        end = ca.if_else(dpush < 0, -push / ca.fmin(dpush, -TINY), 1 / TINY)
        return dx, dpush, ca.fmin(ca.mmin(edge), ca.mmin(end))

    def moved(dx: Any, share: Any) -> Any:
        left = room - share * dots(normal, dx) - share**2 * squares(dx) / 2
        return ca.fmax(left, (1 - INSIDE) * room)  # as much is left but for rounding

    dx, dpush, share = step(-product)
    share, mean = ca.fmin(share, 1), ca.sum1(product) / k
    left = ca.sum1((push + share * dpush) * moved(dx, share)) / k
    mu = mean * ca.fmin(ca.fmax(left / mean, 0), 1) ** 3
    second = share * (dpush * dots(normal, dx) + push * squares(dx) / 2)  # whole after a whole step: else it zigzags
    dx, dpush, share = step(mu - product + second)
    share = ca.fmin(INSIDE * share, 1)
    for _ in range(CUTS if bends else 0):
        share = ca.if_else(ca.mmin(inside(x + share * dx)) < -EXACT, share / 2, share)
    after, push, room, arguments = x + share * dx, push + share * dpush, moved(dx, share), [W, b, size, x, push, room]
    if bends:
        remaining, of = inside(after), list(bends)
        room[of] = ca.if_else(remaining > EXACT, remaining, room[of])
        normal = ca.vertcat(*(normal_and_curvature(after[list(group)])[0] for group in groups))
    else:
        normal = after
    error = ca.mtimes(W, after) + b + each(size * push) * normal
    done = (ca.sum1(push * room) <= k * COMPLEMENTARY) * (ca.sum1(ca.fabs(error) / each(size)) <= n * BALANCED)
    arguments.append(ca.SX.sym("busy"))
    return ca.Function("newton", arguments, ca.cse([after, push, room, 1 - done]))


def _limited_force(groups: Groups) -> Any:
    """Build the function (open, sliding, limit, x, push, room, busy) -> (force, limit, again, busy)."""
    k = len(groups)
    still, sliding, limit, x = _symbols(groups, "open sliding limit x")
    push, room, busy = ca.SX.sym("push", k), ca.SX.sym("room", k), ca.SX.sym("busy")
    force = ca.SX(x)
    for i, group in enumerate(map(list, groups)):
        at_edge = ca.if_else(push[i] > room[i], x[group] / positive(gauge(x[group])), x[group])
        force[group] = still[group] * limit[group] * at_edge
    lets_go = _on_edge(groups, still, force, limit) * (limit > sliding)
    arguments = [still, sliding, limit, x, push, room, busy]
    return ca.Function("found", arguments, ca.cse([force, ca.if_else(lets_go, sliding, limit), ca.mmax(lets_go), busy]))


def _directions(groups: Groups) -> Any:
    """Build the function (W, b, open, slip, bound, force, limit) -> slip: directions of what slides.

    What sticks is held by the forces of least norm, as it will be from now on: a pair that these exceed slides too. An
    onset is located where they exceed the bound by less than the forces of the interior point are known to.
    """
    arguments = _symbols(groups, "W b open slip bound force limit")
    W, b, still, slip, bound, force, limit = arguments
    edge = _on_edge(groups, still, force, limit)
    driven = ca.if_else(edge, force, 0)
    sticks = still * (1 - edge)
    held = solve_sticking(W, sticks, -(b + ca.mtimes(W, driven)))
    a = b + ca.mtimes(W, driven + held)
    beyond = sticks * (_sizes(groups, held) > ca.fmin(limit * (1 + ON_EDGE), bound))
    directions = ca.if_else(still, 0, slip)
    for group in map(list, groups):
        # without a limit the force is none, and the pair goes where the others make it, or nowhere
        away = ca.if_else(ca.sumsqr(a[group]) > 0, unit_of(a[group]), ca.DM([1.0, *[0.0] * (len(group) - 1)]))
        way = ca.if_else(limit[group[0]] > 0, outward(-force[group]), away)
        directions[group] += edge[group] * way + beyond[group] * outward(-held[group])
    return ca.Function("directions", arguments, [ca.cse(ca.densify(directions))])


def _symbols(groups: Groups, names: str) -> list[Any]:
    n = sum(map(len, groups))
    return [ca.SX.sym(name, n, n if name == "W" else 1) for name in names.split()]


def _sizes(groups: Sequence[Sequence[int]], x: Any) -> Any:
    """Return the gauge of each pair's part of a vector, for each of its tangents."""
    sizes = ca.fabs(x)
    for group in map(list, groups):
        sizes[group] = gauge(x[group])
    return sizes


def _axes(way: Any) -> Any:
    """Return an orthogonal matrix whose first column is a unit vector of one to three entries.

    Duff et al., Journal of Computer Graphics Techniques 6 (2017) 1.
    """
    if way.numel() < 3:
        return way if way.numel() == 1 else ca.horzcat(way, ca.vertcat(-way[1], way[0]))
    x, y, z = ca.vertsplit(way)
    side = ca.if_else(z >= 0, 1, -1)
    a = -1 / (side + z)
    one, two = (
        ca.vertcat(1 + side * x * x * a, side * x * y * a, -side * x),
        ca.vertcat(x * y * a, side + y * y * a, -y),
    )
    return ca.horzcat(way, one, two)


def _on_edge(groups: Groups, still: Any, force: Any, limit: Any) -> Any:
    return still * (_sizes(groups, force) >= (1 - ON_EDGE) * limit)


def _within(groups: Groups, force: Any, limit: Any) -> Any:
    """Return forces, those beyond their limits shortened to them."""
    sizes = _sizes(groups, force)
    return ca.if_else(sizes > limit, force * limit / ca.if_else(sizes > 0, sizes, 1), force)
