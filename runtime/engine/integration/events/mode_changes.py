"""Mode changes of a pair, the latches and energy booked with them, and the modes at the start.

Modes: flight; contact; released (overlapping after the force ran out: no force until the gap has opened). They change
on accepted steps only, for all pairs at once, and by the state as reached, whether or not an event was aimed at:
otherwise a contact that ends at a gap of 1e-14 would never be left.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import mul
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.engine.integration.events.effect_events import due, jump, time_to_event
from hertzwerk.runtime.engine.integration.events.event_location import NEAR, ends_with_force, pulls, tolerances
from hertzwerk.runtime.engine.integration.events.stick_and_slip import resolve_slips
from hertzwerk.runtime.engine.integration.step.contact_classes import IDLE, class_of
from hertzwerk.runtime.engine.integration.step.layout import (
    CONTACT,
    FLIGHT,
    NOT_FINITE,
    OUTSIDE_LAW_RANGE,
    RELEASED,
    RUNNING,
    Layouts,
)
from hertzwerk.runtime.engine.integration.step.many_contacts import stored_energies
from hertzwerk.runtime.engine.integration.step.set_valued_friction import (
    LANDING,
    directed,
    margin_tolerances,
    slip_tolerances,
    undecided_and_breaking,
)
from hertzwerk.runtime.engine.integration.step.step_size_control import limited_by_surfaces
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.step.explicit_step import Flow

Parts = dict[str, Any]  # of a vector, by name

HERTZ = 2.94  # duration of a Hertz impact in depth/speed
# first step of the first contact: ONSET_STEP length/speed tolerance^ONSET_POWER
ONSET_STEP, ONSET_POWER = 1.6 * HERTZ, 2 / 7
UNTURNED = 10.0  # times the bound of its rounding: slip in two directions, a thousandth of it, that rounding does not turn step by step
FINITE = 1e300  # larger sums of magnitudes, and nan, are not finite


def next_modes(model: EngineModel, mode: Any, end: Parts, landed: Any, tolerance: tuple[Any, Any, Any]) -> Any:
    """Return the modes (k) after a step from `mode` to `end`; landed: the step was cut to an event."""
    gap, rate, acceleration = end["gap"], end["gap_rate"], end["gap_acceleration"]
    tol, _, tol_force = tolerance
    # an opening that would end within the tolerance is none: a body at rest stays in contact
    leaves = (rate > 0) * ((acceleration >= 0) + (rate * rate > -2 * acceleration * tol) > 0)
    opened = (gap > tol) + (gap >= -tol) * leaves > 0
    # landed a little short of where the force runs out: it has run out
    fading = landed * ends_with_force(model) * (end["force"] <= tol_force) * (end["force_rate"] < 0)
    spent = (pulls(model, end["force"]) + fading > 0) * (gap < -tol)
    apart = (gap > tol) + (gap >= -tol) * (rate >= 0) > 0
    from_flight = ca.if_else((gap <= tol) * _closing(rate, acceleration), CONTACT, FLIGHT)
    from_contact = ca.if_else(opened, FLIGHT, ca.if_else(spent, RELEASED, CONTACT))
    # pressed together again before the gap has opened: the contact goes on, with its old approach speed
    from_released = ca.if_else(apart, FLIGHT, ca.if_else(rate < 0, CONTACT, RELEASED))
    return ca.if_else(mode == FLIGHT, from_flight, ca.if_else(mode == CONTACT, from_contact, from_released))


def latch(model: EngineModel, run: Parts, m: Any, onset: Any, gap_rate: Any) -> tuple[Any, Any]:
    """Return the latches after the onsets (k), and how many approach speeds were raised to the floor."""
    pairs = [pair for _, _, pair in model.module.LATCHES]
    if not pairs:
        return m, ca.DM(0)
    n, each = len(pairs), sorted(set(pairs))
    known, others = ca.vertsplit(m, [0, n, m.numel()])
    latched = ca.if_else(onset[pairs], ca.fmax(-gap_rate[pairs], run["floor"]), known)
    return ca.vertcat(latched, others), ca.sum1(onset[each] * (-gap_rate[each] < run["floor"]))


@per_model
def switch(model: EngineModel, vectors: Layouts, right: Flow) -> Any:
    """Build the function (before, after, controls) -> state `after` with its mode changes carried out.

    The derivatives follow the new modes; the ledger, bristles and slips are updated, and states at events.
    """
    arguments, (before, after, run) = vectors.symbols("before after controls")
    y = after["y"]
    if model.has_ledger:
        y = _book_stored_energy(model, after["t"], y, run["c"], before["mode"], after["mode"])
    y, m = _reset_bristles(model, y, after["mode"]), after["m"]
    if model.ne:
        y = jump(model)(after["t"], y, run["c"], due(run, after))
    _, *tolerance = tolerances(model, run, {**after, "y": y})
    undecided, late = ca.DM(0, 1), ca.DM(0)
    if model.ns:
        small = margin_tolerances(model, run, m, after, *tolerance)
        undecided, breaks = undecided_and_breaking(
            model, after["mode"], m, after["margin"], after["margin_rate"], small, before["mode"]
        )
        late = _since_zero(after, breaks)
    problem = [after["t"], y, after["mode"], m, run["c"], undecided, *_slip_tolerances(model, run, m, after, tolerance)]
    booked = ca.Function("booked", arguments, [*problem, late])
    y, m, busy = (vectors.kind.sym(name, size) for name, size in (("y", y.numel()), ("m", model.nm), ("busy", 1)))
    end = right.symbols(vectors.kind)
    inputs = [*arguments[1:], m, y, busy, *end.values()]
    in_range = end.pop("in_range")
    finite = is_finite(end)
    status = ca.if_else(finite, after["status"], NOT_FINITE)
    if model.fed:  # what sticks now may be held in several ways
        status = ca.if_else((status == RUNNING) * any_of(in_range[model.k :] < 0.5), OUTSIDE_LAW_RANGE, status)
    new = {**after, **end, "y": y, "m": m, "status": status, "class": ca.if_else(finite, after["class"], IDLE)}
    if model.fed:
        new["class"] = ca.if_else(status == RUNNING, new["class"], IDLE)
    new["unsettled"] = after["unsettled"] + busy
    if model.ne:
        new["h"] = ca.fmin(after["h"], time_to_event(run, end, after["t"]))
    resumed = ca.Function("resumed", inputs, [vectors.state.join(new)])
    symbols, (_, after, run) = vectors.symbols("before after controls", ca.MX)
    *problem, late = booked.call(symbols)
    m, y, busy = resolve_slips(model).call(problem)
    ends = right.ends.call([after["t"], y, after["mode"], m, run["c"]])  # called: it runs seldom
    if model.ns:
        y += late * (ends[0] - after["dy"])
        ends = right.ends.call([after["t"], y, after["mode"], m, run["c"]])
    state = resumed(*symbols[1:], m, y, busy, *ends)
    return ca.Function("switch", symbols, [state], ["before", "after", "controls"], ["next"])


def _since_zero(after: Parts, breaks: Any) -> Any:
    """Return the time [s] since the margin (n) of what breaks loose fell through zero.

    A landing aims beyond the root, by more than rounding may be. Until then the force has been that of what sticks; where the holding
    force exceeds the sliding force, all methods at all tolerances would be late by as much.
    """
    late = ca.if_else(breaks * (after["margin_rate"] < 0), after["margin"] / after["margin_rate"], 0)
    return ca.fmin(ca.mmax(late), NEAR * after["h_contact"])


def enter(model: EngineModel, vectors: Layouts, right: Flow) -> Any:
    """Build the function (state, controls) -> state that goes on with the pieces that it has been given.

    What depends on the inputs is evaluated anew: derivatives, forces, margins; events that they bring about happen.
    The step goes on from those of the mode, as after an event.
    """
    arguments, (old, run) = vectors.symbols("state controls")
    end = right.at(old["t"], old["y"], old["mode"], old["m"], run["c"])
    end.pop("in_range")
    free = old["h_flight"]
    if model.k:
        free = ca.if_else(any_of(old["mode"] == CONTACT), ca.fmin(old["h_contact"], run["h_max"]), free)
        free = limited_by_surfaces(free, old["h_onset"], old["mode"], end)
    remaining = run["t_end"] - old["t"]
    new = {
        **old,
        **end,
        "h": ca.if_else(1.01 * free >= remaining, remaining, free),
        "class": class_of(model, old["mode"]),
        "status": ca.DM(RUNNING),
        "accepted": ca.DM(1),
        "after_rejection": ca.DM(0),
        "retakes": ca.DM(0),
        "events": old["events"] + (ca.sum1(end["event"] <= 0) if model.ne else 0),
        "evaluations": old["evaluations"] + 1,
    }
    evaluated = ca.Function("evaluated", arguments, [vectors.state.join(new)])
    state, controls = evaluated.mx_in()
    after = evaluated(state, controls)
    return ca.Function("enter", [state, controls], [switch(model, vectors, right)(after, after, controls)])


def begin(model: EngineModel, vectors: Layouts, right: Flow) -> Any:
    """Build the function (t, q, u, latches, controls) -> initial state.

    Overlapping pairs are in contact, or released where their law would pull. Positive latches are kept.
    """
    n, kind = len(model.latches), vectors.kind
    t, q, u = model.symbols("t q u", kind)
    known, controls = kind.sym("latches", n), vectors.controls.symbol("controls", kind)
    run = vectors.controls.split(controls)
    y = ca.vertcat(q, u, ca.DM.zeros(model.nz))
    if model.ne:
        y = jump(model)(t, y, run["c"], 0)
    mode, floored = ca.DM.zeros(model.k), ca.DM(0)
    m = ca.vertcat(ca.DM.ones(model.nm - model.ns), ca.DM.zeros(model.ns))
    end = right.at(t, y, mode, m, run["c"])
    gap, rate = end["gap"], end["gap_rate"]
    tol, *tolerance = tolerances(model, run, {**end, "t": t, "y": y})
    if model.k:
        touching = (gap < -tol) + (gap <= tol) * _closing(rate, end["gap_acceleration"]) > 0
        m, floored = latch(model, run, m, touching, rate)
        latches, others = ca.vertsplit(m, [0, n, model.nm])
        m = ca.vertcat(ca.if_else(known > 0, known, latches), others)
        end = right.at(t, y, touching, m, run["c"])
        spent = pulls(model, end["force"]) * (gap < -tol)
        mode = ca.if_else(touching, ca.if_else(spent, RELEASED, CONTACT), FLIGHT)
    asking = [t, y, mode, m, run["c"], ca.DM.ones(model.ns)]
    asking += _slip_tolerances(model, run, m, {**end, "t": t}, tolerance)
    touched = ca.Function("touched", [t, q, u, known, controls], [*asking, floored])
    arguments = touched.mx_in()
    *problem, booked = touched.call(arguments)
    slips = resolve_slips(model).call(problem)
    state = _first(model, vectors, right)(arguments[0], arguments[4], problem[2], *slips, booked)
    return ca.Function("begin", arguments, [state], ["t", "q", "u", "latches", "controls"], ["state"])


def _first(model: EngineModel, vectors: Layouts, right: Flow) -> Any:
    """Build the function (t, controls, mode, m, y, unsettled, floored) -> initial state under given modes."""
    t, unsettled, floored = (vectors.kind.sym(name) for name in ("t", "unsettled", "floored"))
    controls = vectors.controls.symbol("controls", vectors.kind)
    mode, m, y = (vectors.kind.sym(name, vectors.state.sizes[name]) for name in ("mode", "m", "y"))
    run = vectors.controls.split(controls)
    end = right.at(t, y, mode, m, run["c"])
    in_range = end.pop("in_range")
    in_contact = any_of(mode == CONTACT)
    finite = is_finite(end)
    status = ca.if_else(finite, ca.if_else(any_of(in_range < 0.5), OUTSIDE_LAW_RANGE, RUNNING), NOT_FINITE)
    fastest = ca.mmax(ca.fabs(end["dy"]) / run["scale"])  # [1/s]
    h = ca.fmin(0.1 / ca.fmax(fastest, 1 / FINITE), run["h_max"])
    h_onset = ONSET_STEP * run["tolerance"] ** ONSET_POWER * run["scales"][0] / run["scales"][1]
    ahead = time_to_event(run, end, t) if model.ne else h
    start = {
        **dict.fromkeys(vectors.state.sizes, ca.DM(0)),
        **end,
        "t": t,
        "y": y,
        "mode": mode,
        "m": m,
        "h": ca.fmin(ca.if_else(in_contact, ca.fmin(h, h_onset), h), ahead),
        "h_flight": h,
        "h_contact": ca.fmin(h, h_onset),
        "h_onset": h_onset,
        "class": ca.if_else(status == RUNNING, class_of(model, mode), IDLE),
        "status": status,
        "accepted": ca.DM(1),
        "fresh_contact": in_contact,
        "pieces": run["c"][model.nc - model.npieces :] if model.npieces else ca.DM(0, 1),  # of one constant 1 x 0
        "stop": run["t_end"] if model.inputs else ca.DM(0, 1),
        "evaluations": ca.DM(3 if model.k else 1),
        "floored": floored,
        "unsettled": unsettled,
    }
    return ca.Function("first", [t, controls, mode, m, y, unsettled, floored], [vectors.state.join(start)])


def _slip_tolerances(model: EngineModel, run: Parts, m: Any, at: Parts, tolerance: list[Any]) -> Sequence[Any]:
    """Return the tolerances of speeds and forces of the pairs with set-valued friction.

    Of speeds in two directions they give the slip its size, beside which rounding turns friction: where they are rounding, they are larger.
    """
    if not model.ns:
        return [ca.DM(0, 1)] * 2
    rate, force = slip_tolerances(model, run, m, at, *tolerance)
    for group in directed(model):
        rounded = rate[group] > LANDING * run["tolerance"] * run["scales"][1]
        rate[group] = ca.if_else(rounded, UNTURNED * rate[group], rate[group])
    return rate, force


def is_finite(end: Parts) -> Any:
    """Return 1 if the derivatives at the end of a step are finite."""
    return ca.sum1(ca.fabs(end["dy"])) + ca.sum1(ca.fabs(end["gap_acceleration"])) < FINITE  # false for NaN


def all_of(conditions: Any) -> Any:
    """Return 1 if all conditions of a column hold; 1 for an empty one."""
    if isinstance(conditions, ca.MX):
        return ca.mmin(conditions) if conditions.numel() else ca.DM(1)
    return reduce(mul, ca.vertsplit(conditions), ca.DM(1))


def any_of(conditions: Any) -> Any:
    """Return 1 if any condition of a column holds; 0 for an empty one."""
    return ca.mmax(conditions) if conditions.numel() else ca.DM(0)


def _closing(rate: Any, acceleration: Any) -> Any:
    return (rate < 0) + (rate == 0) * (acceleration < 0) > 0


def _reset_bristles(model: EngineModel, y: Any, mode: Any) -> Any:
    """Return the state with the bristles of ended contacts reset."""
    y = type(y)(y)
    for row, j in model.module.BRISTLES:
        i = model.nq + model.nu + row
        y[i] = ca.if_else(mode[j] == CONTACT, y[i], 0)
    return y


def _book_stored_energy(model: EngineModel, t: Any, y: Any, c: Any, before: Any, after: Any) -> Any:
    """Return the state with the stored energy of ended contacts booked as dissipated.

    It is booked back where a released contact resumes.
    """
    q, u = y[: model.nq], y[model.nq : model.nq + model.nu]
    stored = (
        stored_energies(model)(t, q, u, c) if isinstance(y, ca.MX) else model.function("energy").call([t, q, u, c])[2]
    )
    leaving = (before == CONTACT) * (after != CONTACT) - (before == RELEASED) * (after == CONTACT)
    rows = [model.nq + model.nu + row for row in model.module.DISSIPATED]
    shares = ca.DM.triplet(rows, range(model.k), ca.DM.ones(model.k), y.numel(), model.k)
    return y + ca.mtimes(shares, leaving * stored)
