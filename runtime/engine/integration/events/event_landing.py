"""Handling of steps that are not plain: rejection, event landing, mode changes, end of the run."""

from __future__ import annotations

from functools import reduce
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.engine.integration.events.effect_events import LOCATED, due, time_to_event
from hertzwerk.runtime.engine.integration.events.event_location import (
    AGREE,
    LOW,
    NEAR,
    NO_EVENT,
    RUNS_OUT,
    dips,
    endings,
    ends_with_force,
    floors,
    polynomials,
    search,
    signed_gaps,
    tolerances,
)
from hertzwerk.runtime.engine.integration.events.mode_changes import (
    FINITE,
    Parts,
    all_of,
    any_of,
    is_finite,
    latch,
    next_modes,
    switch,
)
from hertzwerk.runtime.engine.integration.step.contact_classes import IDLE, IN_CONTACT, class_of
from hertzwerk.runtime.engine.integration.step.explicit_step import Flow, short_step
from hertzwerk.runtime.engine.integration.step.layout import (
    CONSTRAINT_LOST,
    CONTACT,
    END_PARTS,
    EVENT_LIMIT,
    FINISHED,
    FLIGHT,
    NOT_FINITE,
    OUTSIDE_LAW_RANGE,
    RELEASED,
    RUNNING,
    STEP_TOO_SMALL,
    TOO_MANY_STEPS,
    Layouts,
)
from hertzwerk.runtime.engine.integration.step.projection import LOST
from hertzwerk.runtime.engine.integration.step.rounding_errors import EPS
from hertzwerk.runtime.engine.integration.step.set_valued_friction import (
    margin_tolerances,
    margins_ahead,
    turned,
    undecided_and_breaking,
)
from hertzwerk.runtime.engine.integration.step.singular_positions import limited_by_singular
from hertzwerk.runtime.engine.integration.step.step_size_control import (
    ONSET_GROW,
    SAFETY,
    factor,
    limited_by_surfaces,
    onset_factor,
    step_to_continue,
    time_to_root,
)
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.tableaux.methods import Table

NUDGE_EVALUATIONS = 4
MAX_RETAKES = 60  # of one step; a landing needs 1 to 3
JUST_BEHIND = 1e4  # roundings of the time: shorter than any first step of a contact whose force does not jump
MOVED = ("t", "y", "dy", *END_PARTS)  # the parts of a state that a step moves


def settle(model: EngineModel, vectors: Layouts, table: Table, right: Flow) -> Any:
    """Build the function (state, controls, next, verdict) -> state of a step with accepted error.

    MX, lazy where most steps need nothing. `right` follows the modes.
    """
    names = ("state", "controls", "next", "verdict")
    parts = (vectors.state, vectors.controls, vectors.state, vectors.verdict)
    arguments = [ca.MX.sym(name, part.size) for name, part in zip(names, parts, strict=True)]
    state, controls, end, verdict = arguments
    decide = _decide(model, vectors, table)
    if not (model.k or model.ns or model.ne):
        decided, _ = decide(*arguments, NO_EVENT, 0, ca.DM(0, 1))
        return ca.Function("settle", arguments, [decided], names, ["new"])
    run = vectors.within(vectors.controls.split(controls), vectors.state.split(state))
    known = moved_floors = floors(model, vectors.state.split(end), run["c"])
    *gaps, ending = polynomials(model, vectors).call([state, controls, end, known])
    forces, count = endings(model, vectors), model.k + model.ns + model.ne
    at_gap = ca.MX(NO_EVENT)
    if model.k:
        suspect = gaps.pop()
        at_gap = _if(any_of(suspect), search(model.k), NO_EVENT, suspect, *gaps)
    wanted, of_forces = ca.MX.sym("wanted", count), forces.mx_in()
    searched = ca.Function("searched", [wanted, *of_forces], [search(count)(wanted, *forces(*of_forces))])
    at_force = _if(any_of(ending), searched, NO_EVENT, ending, state, controls, end, known)
    theta, delta = _aim(model, vectors, table)(*arguments, at_gap, at_force, known)
    if model.k:
        moved = _nudge(model, vectors, right)
        still = moved.mx_in()
        rest = ca.Function("rest", still, [*still[2:4], still[-1]])
        end, verdict, moved_floors = ca.Function.if_else("nudge", moved, rest)(delta != 0, *arguments, delta, known)
    decided, switched = decide(state, controls, end, verdict, theta, delta, moved_floors)
    if model.k and ca.mmax(ends_with_force(model)):
        lowest = _lowest(model, vectors)(state, controls, arguments[2], decided)
        retake = _without_pull(model, vectors, right, decide)
        decided, switched = retake(lowest[0] < NO_EVENT, *arguments, known, decided, switched, *lowest)
    changed = switch(model, vectors, right)
    before, after, run = changed.mx_in()
    keep = ca.Function("keep", [before, after, run], [after])
    decided = ca.Function.if_else("change", changed, keep)(switched, state, decided, controls)
    return ca.Function("settle", arguments, [decided], names, ["new"])


def reject(vectors: Layouts, table: Table) -> Any:
    """Build the function (state, controls, next, verdict) -> the old state with a shorter step to try."""
    arguments, (old, _, end, judged) = vectors.symbols("state controls next verdict")
    h, error = old["h"], judged["error"]
    finite = is_finite(end) * (error < FINITE)  # false for NaN
    in_contact = old["class"] >= IN_CONTACT
    shrunk = ca.if_else(in_contact * old["fresh_contact"], onset_factor(error), factor(table, error))
    h = h * ca.if_else(finite, ca.fmin(shrunk, SAFETY), 0.1)
    unlimited, h = h, limited_by_singular(table, h, old["ahead"])
    stuck = (h < 4 * EPS * ca.fabs(old["t"])) + (old["t"] + h <= old["t"]) > 0
    why = ca.if_else(finite, ca.if_else(error >= LOST, CONSTRAINT_LOST, STEP_TOO_SMALL), NOT_FINITE)
    status = ca.if_else(stuck, why, RUNNING)
    # a force that jumps at its onset is still nothing where a contact was landed on; what holds is just behind
    behind = in_contact * old["fresh_contact"] * finite * (old["h"] < JUST_BEHIND * EPS * ca.fabs(old["t"]))
    new = {
        **old,
        "dy": ca.if_else(behind, end["dy"], old["dy"]),
        "h": h,
        "h_flight": ca.if_else(in_contact, old["h_flight"], unlimited),
        "h_contact": ca.if_else(in_contact, unlimited, old["h_contact"]),
        "accepted": ca.DM(0),
        "after_rejection": ca.DM(1),
        "retakes": ca.DM(0),
        "rejected": old["rejected"] + 1,
        "evaluations": old["evaluations"] + table.stages,
        "status": status,
        "class": ca.if_else(stuck, IDLE, old["class"]),
    }
    return ca.Function("reject", arguments, ca.cse([vectors.state.join(new)]))


def _if(condition: Any, function: Any, otherwise: float, *arguments: Any) -> Any:
    """Return the function's only result if the condition holds, else a constant; evaluated lazily."""
    constant = ca.Function("otherwise", function.mx_in(), [ca.MX(otherwise)])
    return ca.Function.if_else("branch", function, constant)(condition, *arguments)


def _aim(model: EngineModel, vectors: Layouts, table: Table) -> Any:
    """Build the function that returns theta of a step's first event and a move delta [s] of its end.

    Arguments: state, controls, next, verdict, theta of the first gap, of the first other ending, floors. delta leads
    to a surface close by, or is 0.
    """
    arguments, (old, run, end, _) = vectors.symbols("state controls next verdict")
    theta, force, known = (vectors.kind.sym(name, n) for name, n in (("gap", 1), ("force", 1), ("floors", 2 * model.k)))
    inputs = [*arguments, theta, force, known]
    if not model.k:
        return ca.Function("aim", inputs, [ca.fmin(theta, force), ca.DM(0)])
    tol, _, _ = tolerances(model, run, end, known)
    times = time_to_root(*signed_gaps(old["mode"], end))
    # its fifth power, the nudge's error, is below the tolerance; its square where it crosses a jump
    jumps = _jumps(model, old["mode"])
    order = 0.2 if jumps is None else ca.if_else(jumps, 0.5, 0.2)
    near = ca.fmin(NEAR, run["tolerance"] ** order) * old["h"]
    # Whoever is on its surface already would be led past it by a move on to another's close by, and back by the retake: the step ends there.
    away = ca.if_else(ca.fabs(end["gap"]) > tol, times, 0)
    delta = ca.mmin(ca.if_else(ca.fabs(times) <= near, away, 2 * near))
    alone = (theta >= 1 - 2 * NEAR) * (force >= NO_EVENT)  # a force that runs out is no surface
    # nor is an event that the move may pass
    if model.ns:
        alone *= all_of(margins_ahead(model, old["mode"], old["m"], end, near))
    if model.ne:
        alone *= ca.mmin(end["event"] + near * end["event_rate"] > 0)
    within = (delta <= near) * (old["h"] + delta <= run["t_end"] - old["t"])
    within *= isinstance(table, RungeKutta)  # what is stiff is not moved by an explicit step
    return ca.Function("aim", inputs, ca.cse([ca.fmin(theta, force), ca.if_else(alone * within, delta, 0)]))


def _jumps(model: EngineModel, mode: Any) -> Any:
    """Return 1 where a contact may end with its gap, at a force other than zero; None without such laws."""
    ends = 1 - ends_with_force(model)
    return any_of(ends * (mode == CONTACT)) if ca.mmax(ends) else None


@per_model
def _nudge(model: EngineModel, vectors: Layouts, right: Flow) -> Any:
    """Build the function that moves the end of a step by delta [s].

    (state, controls, next, verdict, delta, floors) -> (next, verdict, floors).
    """
    arguments, (old, run, end, verdict) = vectors.symbols("state controls next verdict", ca.MX)
    delta = ca.MX.sym("delta")
    moved = short_step(right, old, end, run, delta, _jumps(model, old["mode"]))
    in_range = moved.pop("in_range")
    outputs = [vectors.state.join({**end, **moved}), vectors.verdict.join({**verdict, "in_range": in_range})]
    outputs.append(floors(model, moved, run["c"]))
    return ca.Function("moved", [*arguments, delta, ca.MX.sym("floors", 2 * model.k)], outputs)


def _without_pull(model: EngineModel, vectors: Layouts, right: Flow, decide: Any) -> Any:
    """Build the function that retakes a step within which a force pulls or a released contact closes.

    Arguments: whether it may, state, controls, next, verdict, floors, state and switched as decided, which it returns, and what
    `_lowest` returns. What falls through zero and returns is seen at neither end of a step. There the step is cut, so that
    the next attempt sees the fall.
    """
    below = _below(model, vectors, right)
    state, controls, end, theta, *levels = below.mx_in()
    step = [state, controls, end, ca.MX.sym("verdict", vectors.verdict.size), ca.MX.sym("floors", 2 * model.k)]
    inputs = [*step, *(ca.MX.sym(name, size) for name, size in (("decided", vectors.state.size), ("switched", 1)))]
    inputs += [theta, *levels]
    retaken = ca.Function("retaken", inputs, decide(*step[:4], theta, 0, step[4]))
    unchanged = ca.Function("kept", inputs, inputs[5:7])
    cut = ca.Function.if_else("unpulled", retaken, unchanged)(below(state, controls, end, theta, *levels), *inputs)
    return ca.Function.if_else("without_pull", ca.Function("cut", inputs, cut), unchanged)


def _lowest(model: EngineModel, vectors: Layouts) -> Any:
    """Build the function that returns the part of a step at which a contact may pull.

    Arguments: state, controls, next, decided; results: part, NO_EVENT if there is none, and (k each) the level below which a force pulls that ends,
    and what others and opening speeds are by cubics, or infinite. Where a contact opens it is just before the end, as the force
    returns to zero with the gap; elsewhere where a cubic is least.
    """
    arguments, (old, run, end, new) = vectors.symbols("state controls next after")
    ended = ends_with_force(model) * (old["mode"] == CONTACT) * (new["mode"] != CONTACT)
    most = ca.if_else(new["mode"] == RELEASED, ca.fmin(end["force"], 0), 0)  # where it runs out it is aimed below zero
    minima = dips(model, run, old, end)
    first = reduce(ca.fmin, (ca.mmin(at) for at, _ in minima))
    theta = ca.if_else(any_of(ended), 1 - NEAR, ca.if_else(new["accepted"], first, NO_EVENT))
    least = (ca.if_else(at == theta, value, ca.inf) for at, value in minima)
    results = [theta, ca.if_else(ended, most, -ca.inf), *least]
    return ca.Function("lowest", arguments, ca.cse([*map(ca.densify, results)]))


def _below(model: EngineModel, vectors: Layouts, right: Flow) -> Any:
    """Build the function that returns 1 if a force or an opening speed is below zero within a step.

    Arguments: state, controls, next, and the results of `lowest`. A force within its tolerance at the step's start has faded, as
    with strong damping: it may have either sign. What cubics of states give has to agree with the cubic of the force: in a
    contact at rest an implicit step is too long for either.
    """
    arguments, (old, run, end) = vectors.symbols("state controls next", ca.MX)
    theta, levels = ca.MX.sym("theta"), [ca.MX.sym(name, model.k) for name in ("most", "forces", "speeds")]
    back = (1 - theta) * old["h"]
    t, h, y0, y1 = end["t"] - back, old["h"], old["y"], end["y"]
    bent = theta * (2 * (y0 - y1) + h * (old["dy"] + end["dy"]))
    y = y0 + theta * (h * old["dy"] + theta * (3 * (y1 - y0) - h * (2 * old["dy"] + end["dy"]) + bent))
    inside = {"t": t, "y": y, **right.at(t, y, old["mode"], old["m"], run["c"])}
    tol, _, small = tolerances(model, run, inside)
    pulls = inside["force"] < levels[0]
    for (_, value, _), least in zip(RUNS_OUT, levels[1:], strict=True):
        now, higher = inside[value], ca.fmin(old[value], end[value])
        pulls += (now < LOW * higher) * (ca.fabs(now - least) < AGREE * (higher - least))
    pressed = (old["mode"] == RELEASED) + (old["force"] > small)
    below = any_of((pulls * pressed > 0) * (inside["gap"] < -tol)) * (old["retakes"] < LOCATED)
    return ca.Function("below", [*arguments, theta, *levels], [below])


def _decide(model: EngineModel, vectors: Layouts, table: Table) -> Any:
    """Build the function (state, controls, next, verdict, theta, delta, floors) -> (state, switched).

    Accepts the step or retakes it to its first event. switched: 1 if a pair changes its mode or an effect its state, so that
    the right-hand side has to be evaluated again.
    """
    arguments, (old, run, end, judged) = vectors.symbols("state controls next verdict")
    theta, delta = vectors.kind.sym("theta"), vectors.kind.sym("delta")
    known = vectors.kind.sym("floors", 2 * model.k)
    moved, finite = delta != 0, is_finite(end)
    aimed, retake = old["h"] * theta, theta < 1
    mode, m, floored, begun = old["mode"], old["m"], ca.DM(0), ca.DM(0)
    tol, *_ = tolerance = tolerances(model, run, end, known)
    if model.k:  # moved, but too far: the step is retaken to the root as it appears from there
        g, *rates = signed_gaps(mode, end)
        beyond = ca.mmin(ca.if_else(g < -tol, time_to_root(g, *rates), 0))
        retake = ca.if_else(moved, beyond < 0, retake)
        aimed = ca.if_else(moved, old["h"] + delta + beyond, aimed)
    aimed = ca.if_else(finite, aimed, old["h"] / 2)  # a nudge can lead out of the equations' domain
    # a force that jumps below zero, or a gap, has no root: where time can be told no finer, the jump is the event
    least = EPS * ca.fabs(old["t"])
    aimed = ca.fmax(aimed, least)
    retake = ca.if_else(finite, retake * (old["h"] > 2 * least), 1)
    accepted = 1 - retake
    if model.k:
        mode = ca.if_else(accepted, next_modes(model, mode, end, old["retakes"] > 0, tolerance), mode)
        onset = (mode == CONTACT) * (old["mode"] == FLIGHT)
        m, floored = latch(model, run, m, onset, end["gap_rate"])
        begun = ca.sum1(onset)
    switched = any_of(mode != old["mode"])
    if model.ns:
        small = margin_tolerances(model, run, old["m"], end, *tolerance[1:])
        turns = undecided_and_breaking(model, mode, old["m"], end["margin"], end["margin_rate"], small, old["mode"])
        following, some = turned(model, m, end["friction"], end["margin"])
        switched = switched + accepted * (any_of(sum(turns)) + some) > 0
        m = ca.if_else(accepted, following, m)
    arrived = accepted * ((1 - moved) * (old["h"] >= run["t_end"] - old["t"]) + (end["t"] >= run["t_end"]) > 0)
    t, steps = ca.if_else(accepted, ca.if_else(arrived, run["t_end"], end["t"]), old["t"]), old["steps"] + accepted
    happened = ca.DM(0)
    if model.ne:
        happened = accepted * ca.sum1(end["event"] <= due(run, {**end, "t": t, "steps": steps}))
        switched = switched + happened > 0
    now_contact = any_of(mode == CONTACT)

    new = old | _steps_to_continue(table, old, judged["error"], accepted, begun > 0)
    free = ca.if_else(now_contact, ca.fmin(new["h_contact"], run["h_max"]), new["h_flight"])
    if model.k:
        free = limited_by_surfaces(free, new["h_onset"], mode, end, resting=ca.fabs(end["gap"]) <= tol)
    if model.ne:
        free = ca.fmin(free, time_to_event(run, end, end["t"]))
    free = limited_by_singular(table, free, ca.if_else(accepted, end["ahead"], old["ahead"]))
    remaining = run["t_end"] - t
    h = ca.if_else(retake, aimed, ca.if_else(1.01 * free >= remaining, remaining, free))
    new |= {part: ca.if_else(accepted, end[part], old[part]) for part in MOVED}
    new |= {
        "t": t,
        "mode": mode,
        "m": m,
        "h": h,
        "accepted": accepted,
        "fresh_contact": ca.if_else(accepted, begun > 0, old["fresh_contact"]),
        "after_rejection": ca.DM(0),
        "retakes": ca.if_else(retake, old["retakes"] + 1, 0),
        "steps": steps,
        "rejected": old["rejected"],
        "retaken": old["retaken"] + retake,
        "evaluations": old["evaluations"] + table.stages + NUDGE_EVALUATIONS * moved + switched,
        "events": old["events"] + begun + happened,
        "floored": old["floored"] + floored,
    }
    new["status"] = _first(
        (retake * ((t + h <= t) + (new["retakes"] > MAX_RETAKES) > 0), STEP_TOO_SMALL),
        (accepted * any_of(judged["in_range"] < 0.5), OUTSIDE_LAW_RANGE),
        (arrived, FINISHED),
        (new["events"] > run["max_events"], EVENT_LIMIT),
        (new["steps"] >= run["max_steps"], TOO_MANY_STEPS),
        otherwise=RUNNING,
    )
    new["class"] = ca.if_else(new["status"] == RUNNING, class_of(model, mode), IDLE)
    return ca.Function("decide", [*arguments, theta, delta, known], ca.cse([vectors.state.join(new), switched]))


def _steps_to_continue(table: Table, old: Parts, error: Any, accepted: Any, begun: Any) -> Parts:
    """Return h_flight, h_contact, h_onset [s], the steps to continue with; a retake changes none."""
    h, in_contact = old["h"], old["class"] >= IN_CONTACT
    first = in_contact * old["fresh_contact"]
    change = ca.if_else(first, onset_factor(error), factor(table, error))
    planned = ca.if_else(in_contact, old["h_contact"], old["h_flight"])
    grown = h * ca.if_else(old["after_rejection"], ca.fmin(change, 1), ca.if_else(first, ONSET_GROW, change))
    full = h >= planned * (1 - 1e-9)
    planned = ca.if_else(accepted, step_to_continue(h, planned, grown), planned)
    h_onset = ca.if_else(accepted * first * full, h * change, old["h_onset"])
    h_contact = ca.if_else(in_contact, planned, old["h_contact"])
    at_onset = ca.if_else(in_contact, ca.fmin(h_contact, h_onset), h_onset)  # another pair may be in contact already
    return {
        "h_flight": ca.if_else(in_contact, old["h_flight"], planned),
        "h_contact": ca.if_else(begun, at_onset, h_contact),
        "h_onset": h_onset,
    }


def _first(*cases: tuple[Any, int], otherwise: int) -> Any:
    """Return the value of the first condition that holds."""
    value = ca.DM(otherwise)
    for condition, result in reversed(cases):
        value = ca.if_else(condition, result, value)
    return value
