"""Event location within a step: roots of gaps and forces as polynomials in Bernstein form.

Polynomials are in theta = (t - t0)/h. A gap is a quintic from its value, rate and acceleration at both ends of the
step, a force a cubic from value and rate. A polynomial whose Bernstein coefficients are all positive has no root in
the step; only otherwise is one searched for. Farin, Curves and Surfaces for CAGD, ch. 5.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, reduce
from math import comb
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.events.cubics import crest_of_cubic
from hertzwerk.runtime.engine.integration.events.effect_events import LOCATED, falls
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import BEYOND
from hertzwerk.runtime.engine.integration.many_pairs.selection import places_of
from hertzwerk.runtime.engine.integration.step.layout import CONTACT, FLIGHT, MANY, RELEASED, Layouts
from hertzwerk.runtime.engine.integration.step.rounding_errors import gap_rounding, time_rounding
from hertzwerk.runtime.engine.integration.step.set_valued_friction import (
    LANDING,
    margin_tolerances,
    margins,
    margins_positive,
    rubbing,
    touching,
)
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

GAP = ("gap", "gap_rate", "gap_acceleration")
ROUNDINGS = 4  # times the bound of a gap's rounding: locating an event takes a few operations more
DOUBT = 0.1  # of |quintic - cubic|: distance from zero below which a graze is in doubt
AGREE = 0.25  # part by which what tells of a dip within a step may differ
LOW = 0.1  # of the lower value at the ends of a step: a cubic that dips below may dip below zero
NEAR = 1 / 64  # of a step: most by which its end is moved to land on a surface, by the classical method of order 4
RESOLVED = 0.5  # of a gap and its way in a step: most that a step may leave open of its course
UNSEEN = 1e-10  # of the scene's length: what a step may leave open in any case
# what runs out where a mode ends, and its rate
RUNS_OUT = ((CONTACT, "force", "force_rate"), (RELEASED, "gap_rate", "gap_acceleration"))
PARTS = 8  # sub-intervals searched
SOME = 4  # events of many pairs that are looked for by their places
BELIEVED = 4  # retakes of one step after which cubics give way to chords; where a cubic fits, 1 to 3 land
CHORDS = 12  # retakes after which the step is halved: the chord of a force that flattens towards its root hardly moves
AT_START = 1e-8  # of a step, from its start: a kink there is one of its start, where a landing has come as near as rounding lets it
NEWTON_STEPS = 12  # within one of them, bisecting where Newton would leave the bracket
NO_EVENT = 2.0  # theta beyond every step


def floors(model: EngineModel, at: Mapping[str, Any], c: Any) -> Any:
    """Return the bounds of rounding of gaps and gap rates (2 k) in a state."""
    if not model.k:
        return ca.DM(0, 1)
    q, u = at["y"][: model.nq], at["y"][model.nq : model.nq + model.nu]
    return ca.vertcat(*gap_rounding(model)(at["t"], q, u, c))


def tolerances(
    model: EngineModel, run: Mapping[str, Any], at: Mapping[str, Any], known: Any = None
) -> tuple[Any, Any, Any]:
    """Return the landing tolerances of a gap (k) [m], a gap rate (k) [m/s] and a force (k) [N].

    A hundredth of the tolerance, but not below rounding: a gap is rounded with the coordinates and lengths it is a
    difference of (`rounding_errors`) and with the time of its landing; a force with that time and with the gap, by the
    stiffness of the scene's scales and by the contact's own, force over depth, which hard surfaces and strong damping
    raise far above.

    known    the `floors` there
    """
    if not model.k:
        return (ca.DM(0, 1),) * 3
    length, speed, force = (run["scales"][i] for i in range(3))
    bounds = floors(model, at, run["c"]) if known is None else known
    gap_floor, rate_floor = (ROUNDINGS * bound for bound in ca.vertsplit(bounds, model.k))
    small = LANDING * run["tolerance"]
    tol = ca.fmax(_landing(run, at["t"], at["gap_rate"]), gap_floor)
    own = gap_floor * ca.fabs(at["force"]) / ca.fmax(ca.fabs(at["gap"]), tol)
    own = ca.fmax(own, time_rounding(at["t"], at["force_rate"]))
    return (
        tol,
        ca.fmax(small * speed, rate_floor),
        ca.fmax(ca.fmax(small, gap_floor / length) * force, own),
    )


def _landing(run: Mapping[str, Any], t: Any, gap_rate: Any) -> Any:
    """Return the gap tolerance [m] without the coordinates' rounding, which is costlier to evaluate.

    Enough to see whether a step needs event location.
    """
    return ca.fmax(LANDING * run["tolerance"] * run["scales"][0], time_rounding(t, gap_rate))


def far_apart(
    model: EngineModel, run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any], pairs: list[int]
) -> Any:
    """Return 1 for pairs in flight so far apart that no event is possible in the step.

    A cheap sufficient condition for `no_event_possible`, without a polynomial.
    """
    h = start["h"]
    gap0, rate0, a0 = (start[part][pairs] for part in GAP)
    gap1, rate1, a1 = (end[part][pairs] for part in GAP)
    rates, accelerations = ca.fabs(rate0) + ca.fabs(rate1), ca.fabs(a0) + ca.fabs(a1)
    way = (BEYOND[0] + DOUBT / 32) * h + time_rounding(end["t"], 1)
    least = _landing(run, end["t"], 0) + way * rates + (BEYOND[1] + DOUBT / 64) * h * h * accelerations
    return ca.fmin(gap0, gap1) > least


def unresolved(run: Mapping[str, Any], mode: Any, start: Mapping[str, Any], end: Mapping[str, Any]) -> Any:
    """Return how badly the gaps of pairs in flight are resolved by a step; above 1 it has to be shorter.

    A surface that is driven, or turns in free flight, may come and go within a step in which every state moves along a
    line: no error of a state is seen, and the quintic knows the ends of the step alone. The evidence is the errors of the
    trapezoidal rule with its correction for the gap, and without it for the rate. Both vanish for no vibration, in any
    phase, that is not resolved; what they leave is small beside the gap, so that it cannot close it.
    """
    h, flying = start["h"], mode == FLIGHT
    (g0, rate0, a0), (g1, rate1, a1) = ([side[part] for part in GAP] for side in (start, end))
    error = ca.fabs(g1 - g0 - h / 2 * (rate0 + rate1) + h * h / 12 * (a1 - a0))
    error += h * ca.fabs(rate1 - rate0 - h / 2 * (a0 + a1))
    way = ca.fmax(ca.fabs(g0), ca.fabs(g1)) + h / 8 * (ca.fabs(rate0) + ca.fabs(rate1))
    least = ca.fmax(run["tolerance"], UNSEEN) * run["scales"][0]
    return ca.mmax(ca.if_else(flying, error / (RESOLVED * way + least), 0))


def no_event_possible(
    model: EngineModel,
    run: Mapping[str, Any],
    mode: Any,
    start: Mapping[str, Any],
    end: Mapping[str, Any],
    pairs: list[int],
) -> Any:
    """Return 1 for pairs to which no event is possible in a step nor just behind it.

    Modes (k) are flight or contact; clear means that no gap comes near zero and no force pulls.
    """
    h = start["h"]
    tol = _landing(run, end["t"], end["gap_rate"][pairs])
    before, after = ([x[pairs] for x in signed_gaps(mode, side)] for side in (start, end))
    b = _quintic(before, after, h)
    between = _graze_margin(before, after, h)
    soon = b[5] + NEAR * h * after[1]
    # where the tangent at its start pulls and the force rises at its end, it may run out and return: see `dips`
    returns = (mode == CONTACT) * (end["force_rate"] > 0)
    force = ca.fmin(end["force"], ca.if_else(returns, start["force"] + h * start["force_rate"], 0))
    leaving = (b[0] <= tol) * (before[1] >= 0)  # the root at the start is none: see `polynomials`
    clear = ((b[0] > tol) + leaving > 0) * (b[5] > tol) * (soon > tol) * (1 - pulls(model, force)[pairs])
    # cut to where a force runs out, but a little short of it: `next_modes` decides
    least = end["force"] <= LANDING * run["tolerance"] * run["scales"][2]
    faded = (mode == CONTACT) * (start["retakes"] > 0) * least * (end["force_rate"] < 0)
    clear *= 1 - (ends_with_force(model) * faded)[pairs]
    if any(rubs_till_it_pulls(model)):
        clear *= 1 - (ca.DM(rubs_till_it_pulls(model)) * (start["force"] * end["force"] < 0))[pairs]
    least = ca.if_else(leaving, b[0], between)
    for coefficient in b[1:5]:
        clear *= coefficient > least
    return clear * (margins_positive(model, mode, start, end) if model.ns else 1)


def pulls(model: EngineModel, force: Any) -> Any:
    """Return 1 (k) where a force is negative and the law ends its contact there, not with the gap."""
    return ends_with_force(model) * (force < 0)


def ends_with_force(model: EngineModel) -> Any:
    """Return 1 (k) for pairs whose law ends a contact at zero force, 0 where it ends with the gap."""
    releases = model.module.RELEASES
    return ca.DM([float(rule == "force") for rule in releases])


def rubs_till_it_pulls(model: EngineModel) -> list[float]:
    """Return 1 (k) for pairs whose set-valued friction ends where their law begins to pull."""
    ends = ends_with_force(model)
    return [float(j in rubbing(model) and not ends[j]) for j in range(model.k)]


def dips(
    model: EngineModel, run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any]
) -> list[tuple[Any, Any]]:
    """Return, for force and opening speed, the part of a step at which it is least, and what it is there.

    Each (k), by cubics that go low between two higher values; NO_EVENT where there is none, or a step is too long for the force,
    as where one decays at once by damping: the trapezoidal rule then misses the change of speed. What begins within the tolerance is none.
    """
    minima, h, (_, speed, a), (_, speed1, a1) = [], start["h"], *([side[part] for part in GAP] for side in (start, end))
    resolved = ca.fabs(speed1 - speed - h / 2 * (a + a1)) < AGREE * h / 2 * (ca.fabs(a) + ca.fabs(a1))
    small = LANDING * run["tolerance"]
    sizes = small * run["scales"][2], small * run["scales"][1]
    for counts, size, (mode, value, rate) in zip((ends_with_force(model), 1), sizes, RUNS_OUT, strict=True):
        f, f1, rise, rise1 = start[value], end[value], h * start[rate], h * end[rate]
        theta, least, _ = crest_of_cubic(ca, -f, -f1, -rise, -rise1)
        least = -least
        low = (
            counts
            * (start["mode"] == mode)
            * (start[rate] < 0)
            * (end[rate] > 0)
            * (ca.fmin(f, f1) > ca.fmax(least / LOW, size))
        )
        minima.append(
            (ca.if_else(low * resolved * (theta > NEAR) * (start["retakes"] < BELIEVED), theta, NO_EVENT), least)
        )
    return minima


@per_model
def polynomials(model: EngineModel, layouts: Layouts) -> Any:
    """Build the function of the gap polynomials over a step and their suspicions.

    (state, controls, next, floors) ->
    bernstein (6, k), margin (k), doubt (k), suspect (k), ending (n); without pairs the last alone. An event is the first theta where a
    polynomial, falling from above, has a root and goes on to -margin; a graze whose minimum is below doubt is
    resolved by a shorter step. suspect: 1 where any of this is possible; ending: 1 where `endings` has an event.
    """
    arguments, (start, run, end) = layouts.symbols("state controls next")
    arguments.append(layouts.kind.sym("floors", 2 * model.k))
    h = start["h"]
    if not model.k:
        return ca.Function("polynomials", arguments, [ca.densify(_beside_pairs(model, run, start, end, ca.DM(0, 1)))])
    tol, tol_rate, tol_force = tolerances(model, run, end, arguments[-1])
    before, after = signed_gaps(start["mode"], start), signed_gaps(start["mode"], end)
    g, rate, _ = before
    b = _quintic(before, after, h)
    # On the surface and leaving it: the root at 0 is no event, the return is. (g(theta) - g)/theta is a quartic, here raised to degree 5.
    leaving, resting = (g <= tol) * (rate >= 0), (g <= tol) * (rate < 0)
    deflated = _raise([5 * (b[i] - b[0]) / i for i in range(1, 6)])
    # At rest within the tolerance the end of the step decides, not the polynomial.
    b = [ca.if_else(leaving, d, ca.if_else(resting, 1, x)) for d, x in zip(deflated, b, strict=True)]
    between = _graze_margin(before, after, h)
    bernstein, margin = ca.vertcat(*(x.T for x in b)), ca.if_else(leaving, 2, 1) * tol
    doubt = ca.if_else((between > tol) * (1 - leaving), between, 0)
    suspect = reduce(ca.fmin, b) <= doubt
    ending = sum(falls for falls, *_ in _endings(model, start, end, tol, tol_rate, tol_force)) > 0
    ending = _beside_pairs(model, run, start, end, ending)
    outputs = ca.cse([*map(ca.densify, (bernstein, margin, doubt, suspect, ending))])
    return ca.Function("polynomials", arguments, outputs)


@per_model
def endings(model: EngineModel, layouts: Layouts) -> Any:
    """Build the function of the cubics of the force, opening speed and margins.

    (state, controls, next, floors) -> bernstein (6, n), margin (n), doubt (n). A mode also ends, before the gap opens, where one of these falls
    through zero: in contact the force, which would pull from there on; released, the opening speed, after which the
    bodies close again; for the ns pairs that slip or stick, the margin of that; for the ne events of effects their
    own. The root is aimed half the tolerance below zero, so that the landing is beyond it. Where stiff damping makes the
    force, its rate is dominated by the velocity error of a step: after BELIEVED retakes the chord replaces the cubic, and
    after CHORDS one whose root is halfway.
    """
    arguments, (start, run, end) = layouts.symbols("state controls next")
    arguments.append(layouts.kind.sym("floors", 2 * model.k))
    h = start["h"]
    rows, aim, margins_of = [ca.DM.ones(model.k)] * 6, ca.DM.zeros(model.k), []
    tolerance = tolerances(model, run, end, arguments[-1])
    if model.k:
        for ends, f, f1, rate, rate1, small in _endings(model, start, end, *tolerance):
            f = ca.if_else(start["retakes"] < CHORDS, f, -f1)
            rise, rise1 = (ca.if_else(start["retakes"] < BELIEVED, h * slope, f1 - f) for slope in (rate, rate1))
            cubic = _raise(_raise([f, f + rise / 3, f1 - rise1 / 3, f1]))
            rows = [ca.if_else(ends, x + small / 2, row) for x, row in zip(cubic, rows, strict=True)]
            aim = ca.if_else(ends, small / 2, aim)
    if model.ns:
        margins_of.append(_slipping(model, run, start, end))
    if model.ne:
        margins_of.append(falls(run, start, end))
    for ends, cubic, small in margins_of:
        cubic = _raise(_raise(cubic))
        rows = [ca.vertcat(row, ca.if_else(ends, x + small / 2, 1)) for x, row in zip(cubic, rows, strict=True)]
        aim = ca.vertcat(aim, small / 2)
    bernstein = ca.densify(ca.vertcat(*(row.T for row in rows)))
    doubt = ca.DM.zeros(model.k + model.ns + model.ne)
    return ca.Function("endings", arguments, ca.cse([bernstein, ca.densify(aim), doubt]))


def _beside_pairs(
    model: EngineModel, run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any], any_end: Any
) -> Any:
    """Return whether the modes of pairs end (k), followed by whether frictions change and events happen."""
    if model.ns:
        any_end = ca.vertcat(any_end, _slipping(model, run, start, end)[0])
    return ca.vertcat(any_end, falls(run, start, end)[0]) if model.ne else any_end


def _endings(
    model: EngineModel, start: Mapping[str, Any], end: Mapping[str, Any], tol: Any, tol_rate: Any, tol_force: Any
) -> list[Any]:
    """Return, for force and opening speed: falls below zero, values and rates at both ends, tolerance.

    A force that goes on beyond zero, pulling, takes friction with it and brings it back: a kink, located for both signs.
    """
    conditions = []
    for (mode, value, rate), small, counts in zip(
        RUNS_OUT, (tol_force, tol_rate), (ends_with_force(model), 1), strict=True
    ):
        falls = counts * (start["mode"] == mode) * (start[value] >= 0) * (end[value] < -small) * (end["gap"] < -tol)
        conditions.append((falls, start[value], end[value], start[rate], end[rate], small))
    if any(rubs_till_it_pulls(model)):
        goes_on = ca.DM(rubs_till_it_pulls(model)) * (start["mode"] == CONTACT) * (end["gap"] < -tol)
        for sign in (1, -1):
            values = [sign * side[part] for part in ("force", "force_rate") for side in (start, end)]
            falls = goes_on * (values[1] < -tol_force) * (values[0] > -AT_START * values[1])
            conditions.append((falls, *values, tol_force))
    return conditions


def _slipping(
    model: EngineModel, run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any]
) -> tuple[Any, list[Any], Any]:
    """Return, for the slip and stick margins (ns): falls below zero, cubic's coefficients, tolerance.

    The tolerance is the larger one of both ends: where a contact opens, that of the start decides whether its margin is above zero.
    """
    first, last = (
        margin_tolerances(model, run, start["m"], side, *tolerances(model, run, side)[1:]) for side in (start, end)
    )
    small = ca.fmax(first, last)
    cubic = margins(start, end)
    lowest = ca.fmin(ca.fmin(cubic[1], cubic[2]), cubic[3])
    falls = touching(model, start["mode"]) * (cubic[0] > -small / 2) * (lowest < -small)
    falls *= start["retakes"] < LOCATED  # nearly redundant friction forces jump with a step's error: they have no root
    return falls, cubic, small


def search(k: int) -> Any:
    """Build the function (wanted, bernstein, margin, doubt) -> theta of the first event of any.

    NO_EVENT where there is none. MX, lazy: pairs not wanted cost nothing, nor are they looked through where there are many.
    """
    wanted, margin, doubt = (ca.MX.sym(name, k) for name in ("wanted", "margin", "doubt"))
    arguments = [wanted, ca.MX.sym("bernstein", 6, k), margin, doubt]
    located = locate()
    none = ca.Function("none", located.mx_in(), [ca.MX(NO_EVENT)])
    lazy = ca.Function.if_else("lazy", located, none)

    def of(count: int, *arguments: Any) -> Any:
        wanted, bernstein, margin, doubt = arguments
        return ca.mmin(lazy.map(count)(wanted.T, bernstein, margin.T, doubt.T))

    every = ca.Function("every", arguments, [of(k, *arguments)])
    if k <= MANY:
        return every
    places = places_of(wanted, SOME)
    rows = ca.repmat(6 * places.T, 6, 1) + ca.DM(range(6))
    taken = (part.get_nz(False, at) for part, at in zip(arguments[1:], (rows, places, places), strict=True))
    some = ca.Function("some", arguments, [of(SOME, places < k, *taken)])
    few = ca.sum1(wanted) <= SOME
    return ca.Function("search", arguments, [ca.Function.if_else("searched", some, every)(few, *arguments)])


@cache
def locate() -> Any:
    """Build the function (bernstein (6), margin, doubt) -> theta in (0, 1] of the first event.

    NO_EVENT if there is none, 0.5 where a graze is in doubt and doubt is positive. The polynomial is evaluated at the
    ends of equal parts; the first part with a change of sign, or with a minimum that reaches -margin, brackets the
    root, which safeguarded Newton steps find, half of them only where the others have not settled.
    """
    bernstein, margin, doubt = ca.SX.sym("bernstein", 6), ca.SX.sym("margin"), ca.SX.sym("doubt")
    a: Any = ca.mtimes(ca.DM(_POWERS), bernstein)
    value = [a[j] for j in range(6)]
    slope = [j * value[j] for j in range(1, 6)]
    curvature = [j * slope[j] for j in range(1, 5)]
    nodes = [i / PARTS for i in range(PARTS + 1)]
    values = ca.horzcat(*(_horner(value, x) for x in nodes)) + margin
    slopes = ca.horzcat(*(_horner(slope, x) for x in nodes))
    above, falls = values > 0, slopes < 0
    index = ca.DM(range(PARTS)).T
    crosses = above[:, :-1] * (1 - above[:, 1:])
    dips = above[:, :-1] * above[:, 1:] * falls[:, :-1] * (1 - falls[:, 1:])
    crossing, dip = (
        reduce(ca.fmin, ca.horzsplit(ca.if_else(kind, index, PARTS))) for kind in (crosses, dips)
    )  # PARTS: none

    bottom = (dip + 0.5) / PARTS
    for _ in range(3):
        bend = _horner(curvature, bottom)
        step = ca.if_else(bend > 0, _horner(slope, bottom) / bend, 0)
        bottom = ca.fmin(ca.fmax(bottom - step, dip / PARTS), (dip + 1) / PARTS)
    lowest = _horner(value, bottom)
    in_dip = (dip < crossing) * (lowest <= -margin)
    # no doubt: within the margin it is none
    in_doubt = (dip < crossing) * (lowest > -margin) * (lowest < doubt) * (doubt > 0)
    part = ca.if_else(in_dip, dip, crossing)
    first = low = part / PARTS
    high = ca.if_else(in_dip, bottom, (part + 1) / PARTS)
    at_bottom = bottom - ca.sqrt(ca.fmax(-2 * lowest / _horner(curvature, bottom), 0))
    x = ca.if_else(in_dip, ca.fmax(at_bottom, low), (low + high) / 2)
    begun = ca.Function("begun", [bernstein, margin, doubt], ca.cse([a, x, low, high, first, part, in_doubt]))
    arguments, steps = begun.mx_in(), _newton_steps()
    start: list[Any] = begun.call(arguments)
    a, x, low, high, first, part, in_doubt = start
    same = ca.Function("same", (places := steps.mx_in()), [*places[1:], ca.MX(1)])
    x, low, high, settled = steps(a, x, low, high)
    x, _, high, _ = ca.Function.if_else("settled", same, steps)(settled, a, x, low, high)
    # within the margin of zero already at the part's left end: that end will do
    x = ca.if_else(_horner(ca.vertsplit(a), first) > 0, x, ca.fmax(first, high / PARTS))
    theta = ca.if_else(part < PARTS, x, ca.if_else(in_doubt, 0.5, NO_EVENT))
    return ca.Function("locate", arguments, [theta], ["bernstein", "margin", "doubt"], ["theta"])


def _newton_steps() -> Any:
    """Build the function (polynomial, x, low, high) -> x, low, high, settled, of half the steps."""
    a, x, low, high = arguments = [ca.SX.sym("a", 6), *map(ca.SX.sym, ("x", "low", "high"))]
    value = ca.vertsplit(a)
    slope = [j * value[j] for j in range(1, 6)]
    before = newton = x
    for _ in range(NEWTON_STEPS // 2):
        before, at_x = x, _horner(value, x)
        positive = at_x > 0
        low, high = ca.if_else(positive, x, low), ca.if_else(positive, high, x)
        newton = x - at_x / _horner(slope, x)
        x = ca.if_else((newton >= low) * (newton <= high), newton, (low + high) / 2)
    return ca.Function("newton_steps", arguments, ca.cse([x, low, high, newton == before]))


_POWERS = [
    [comb(5, j) * (-1) ** (i + j) * comb(j, i) if i <= j else 0 for i in range(6)] for j in range(6)
]  # of 1, theta, ..., theta^5


def signed_gaps(mode: Any, parts: Mapping[str, Any]) -> list[Any]:
    """Return gaps, rates and accelerations, signed so that an event is a fall through zero."""
    sign = ca.if_else(mode == FLIGHT, 1, -1)
    return [sign * parts[part] for part in GAP]


def _graze_margin(start: list[Any], end: list[Any], h: Any) -> Any:
    """Return the distance a graze must keep from zero: a part of |quintic - cubic| at mid-step."""
    return ca.fabs(DOUBT * h / 32 * (start[1] - end[1]) + DOUBT * h * h / 64 * (start[2] + end[2]))


def _quintic(start: list[Any], end: list[Any], h: Any) -> list[Any]:
    """Return the Bernstein coefficients of the quintic by value, rate and acceleration at both ends."""
    fifth, twentieth = h / 5, h * h / 20
    (g0, rate0, a0), (g1, rate1, a1) = start, end
    left = [g0, g0 + fifth * rate0, g0 + 2 * fifth * rate0 + twentieth * a0]
    right = [g1, g1 - fifth * rate1, g1 - 2 * fifth * rate1 + twentieth * a1]
    return [*left, *reversed(right)]


def _raise(b: list[Any]) -> list[Any]:
    """Raise the degree of a Bernstein form by one."""
    n = len(b)
    return [b[0], *(i / n * b[i - 1] + (1 - i / n) * b[i] for i in range(1, n)), b[-1]]


def _horner(a: list[Any], x: Any) -> Any:
    return reduce(lambda total, coefficient: total * x + coefficient, reversed(a))
