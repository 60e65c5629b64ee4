"""One attempt: a step is tried, then accepted, shortened for its error, or retaken to land on an event; as CasADi functions state -> state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.events import NO_EVENT, locate, polynomials
from hertzwerk.runtime.integrate.explicit import EPS, flow, step
from hertzwerk.runtime.integrate.layout import (
    CONTACT,
    EVENT_LIMIT,
    FINISHED,
    FLIGHT,
    IDLE,
    IN_CONTACT,
    IN_FLIGHT,
    NOT_FINITE,
    OUTSIDE_LAW_RANGE,
    PAIR_PARTS,
    RUNNING,
    STEP_TOO_SMALL,
    TOO_MANY_STEPS,
    Layouts,
    layouts,
)
from hertzwerk.runtime.integrate.modes import FINITE, Parts, any_of, begin, latch, next_modes, switch

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.tables import RungeKutta
    from hertzwerk.runtime.model import Model

SAFETY = 0.9
SHRINK, GROW = 0.2, 6.0  # limits of the factor between steps
MEMORY = 0.04  # exponent of the last error in the controller (Hairer, Norsett, Wanner II.4, PI control)
LEAST_ERROR = 1e-4  # that is remembered, so that one lucky step does not count for more
ONSET_ORDER = 2.5  # a force like d^1.5 from zero: the first step's error falls with h^2.5 whatever the method
ONSET_DOUBT = 3  # the error estimate of that step is too small by about this: it assumes a smooth force
MAX_RETAKES = 60  # of one step; a landing needs 1 to 3


@dataclass(frozen=True)
class Integrator:
    """The functions of one model and method: `begin` makes the first state, `attempt` one from another, `step` is the dense output."""

    layouts: Layouts
    begin: Any  # (t, q, u, controls) -> state
    attempt: Any  # (state, controls) -> state
    step: Any  # (state, controls, h) -> trial


def integrator(model: Model, table: RungeKutta) -> Integrator:
    """Build the attempt of a model with an explicit method."""
    vectors = layouts(model)
    apart, full = flow(model, contacts=False), flow(model, contacts=True)
    steps = {IN_FLIGHT: step(vectors, table, apart), IN_CONTACT: step(vectors, table, full)}
    decide, change = _decide(model, vectors, table), switch(model, vectors, full) if model.k else None
    search = locate(2 * model.k) if model.k else None
    in_flight, in_contact = (_attempt(model, vectors, kind, steps[kind], search, decide, change) for kind in steps)
    state, controls = ca.MX.sym("state", vectors.state.size), ca.MX.sym("controls", vectors.controls.size)
    idle = ca.Function("idle", [state, controls], [state])
    # called with MX, so that one branch is evaluated; SX would evaluate all three
    choose = ca.Function.conditional("choose", [idle, in_flight], in_contact)
    chosen = choose(state[vectors.state["class"]], state, controls)
    return Integrator(
        layouts=vectors,
        begin=begin(model, vectors, full),
        attempt=ca.Function("attempt", [state, controls], [chosen], ["state", "controls"], ["next"]),
        step=steps[IN_CONTACT],
    )


def _attempt(model: Model, vectors: Layouts, kind: int, step: Any, search: Any, decide: Any, change: Any) -> Any:
    """CasADi function (state, controls) -> state of one class of attempts; MX, lazy where most attempts need nothing."""
    state, controls = ca.MX.sym("state", vectors.state.size), ca.MX.sym("controls", vectors.controls.size)
    trial = step(state, controls, state[vectors.state["h"]])
    if not model.k:
        decided, _ = decide(state, controls, trial, NO_EVENT)
    else:
        *possible, suspect = polynomials(model, vectors, contacts=kind == IN_CONTACT)(state, controls, trial)
        nothing = ca.Function("nothing", search.mx_in(), [ca.MX(NO_EVENT)])
        theta = ca.Function.if_else("search", search, nothing)(suspect, *possible)
        decided, switched = decide(state, controls, trial, theta)
        before, after, run = change.mx_in()
        stay = ca.Function("stay", [before, after, run], [after])
        decided = ca.Function.if_else("change", change, stay)(switched, state, decided, controls)
    return ca.Function(
        "attempt_in_contact" if kind == IN_CONTACT else "attempt_in_flight", [state, controls], [decided]
    )


def _decide(model: Model, vectors: Layouts, table: RungeKutta) -> Any:
    """CasADi function (state, controls, trial, theta) -> (state, switched): what follows from a trial step and its first event, if any.

    switched: 1 if a pair changes its mode, so that the right-hand side has to be evaluated again.
    """
    names = ("state", "controls", "trial")
    parts = (vectors.state, vectors.controls, vectors.trial)
    arguments = [layout.symbol(name) for layout, name in zip(parts, names, strict=True)]
    old, run, end = (layout.split(vector) for layout, vector in zip(parts, arguments, strict=True))
    theta = ca.SX.sym("theta")

    end["error"] *= ca.if_else(old["fresh_contact"], ONSET_DOUBT, 1)
    size = end["error"] + ca.sum1(ca.fabs(end["dy"])) + ca.sum1(ca.fabs(end["gap_acceleration"]))
    finite = size < FINITE  # false for NaN
    passed = finite * (end["error"] <= 1)
    retake = passed * (theta < 1)
    accepted = passed * (1 - retake)

    mode, m, floored, begun = old["mode"], old["m"], ca.SX(0), ca.SX(0)
    if model.k:
        mode = ca.if_else(accepted, next_modes(model, run, mode, end), mode)
        onset = (mode == CONTACT) * (old["mode"] == FLIGHT)
        m, floored = latch(model, run, m, onset, end["gap_rate"])
        begun = ca.sum1(onset)
    switched = any_of(mode != old["mode"])
    now_contact = any_of(mode == CONTACT)

    verdict = {"finite": finite, "accepted": accepted, "retake": retake, "begun": begun > 0}
    new = _remembered(table, old, end, verdict)
    left = run["t_end"] - old["t"]
    arrived = accepted * (old["h"] >= left)
    t = ca.if_else(accepted, ca.if_else(arrived, run["t_end"], end["t"]), old["t"])
    free = ca.if_else(now_contact, new["h_contact"], new["h_flight"])
    if model.k:  # near a surface the state itself knows best how far the step may go
        free = ca.if_else(accepted, ca.fmin(free, _to_surface(mode, end, old["retakes"] > 0)), free)
    left = run["t_end"] - t
    h = ca.if_else(retake, old["h"] * theta, ca.if_else(free * 1.01 >= left, left, free))
    new |= {part: ca.if_else(accepted, end[part], old[part]) for part in ("y", "dy", *PAIR_PARTS)}
    new |= {
        "t": t,
        "mode": mode,
        "m": m,
        "h": h,
        "accepted": accepted,
        "fresh_contact": ca.if_else(accepted, begun > 0, old["fresh_contact"]),
        "after_rejection": 1 - passed,
        "retakes": ca.if_else(retake, old["retakes"] + 1, 0),
        "steps": old["steps"] + accepted,
        "rejected": old["rejected"] + 1 - passed,
        "retaken": old["retaken"] + retake,
        "evaluations": old["evaluations"] + table.stages + switched,
        "events": old["events"] + begun,
        "floored": old["floored"] + floored,
    }
    least = ca.if_else(retake, 0, 4 * EPS * ca.fabs(t))  # the last correction of a landing may be smaller
    stuck = (1 - accepted) * ((h < least) + (t + h <= t) + (new["retakes"] > MAX_RETAKES) > 0)
    new["status"] = _first(
        (stuck * (1 - finite), NOT_FINITE),
        (stuck, STEP_TOO_SMALL),
        (accepted * any_of(end["in_range"] < 0.5), OUTSIDE_LAW_RANGE),
        (arrived, FINISHED),
        (new["events"] > run["max_events"], EVENT_LIMIT),
        (new["steps"] >= run["max_steps"], TOO_MANY_STEPS),
        otherwise=RUNNING,
    )
    new["class"] = ca.if_else(new["status"] == RUNNING, ca.if_else(now_contact, IN_CONTACT, IN_FLIGHT), IDLE)
    return ca.Function(
        "decide",
        [*arguments, theta],
        ca.cse([vectors.state.join(new), switched]),
        [*names, "theta"],
        ["next", "switched"],
    )


def _remembered(table: RungeKutta, old: Parts, end: Parts, verdict: Parts) -> Parts:
    """The steps that flight and contact go on with, and a contact begins with: h_flight, h_contact, h_onset [s]; and the error they follow from."""
    h, accepted = old["h"], verdict["accepted"]
    in_contact = old["class"] == IN_CONTACT
    first = in_contact * old["fresh_contact"]
    exponent = ca.if_else(first, 1 / ONSET_ORDER, 1 / table.error_order)
    error = ca.fmax(end["error"], 1e-30)
    factor = ca.fmin(ca.fmax(SAFETY * error**-exponent * old["error"] ** MEMORY, SHRINK), GROW)
    kept = ca.if_else(in_contact, old["h_contact"], old["h_flight"])
    shortened = h < kept * (1 - 1e-9)  # by an event or the end, which says nothing against a longer step
    grown = h * ca.if_else(old["after_rejection"], ca.fmin(factor, 1), factor)
    after_accepted = ca.if_else(shortened, ca.fmax(kept, grown), grown)
    after_rejected = h * ca.if_else(verdict["finite"], ca.fmin(factor, SAFETY), 0.1)
    kept = ca.if_else(accepted, after_accepted, ca.if_else(verdict["retake"], kept, after_rejected))
    h_onset = ca.if_else(accepted * first * (1 - shortened), h * factor, old["h_onset"])
    h_contact = ca.if_else(in_contact, kept, old["h_contact"])
    at_onset = ca.if_else(in_contact, ca.fmin(h_contact, h_onset), h_onset)  # another pair may be in contact already
    return {
        "h_flight": ca.if_else(in_contact, old["h_flight"], kept),
        "h_contact": ca.if_else(verdict["begun"], at_onset, h_contact),
        "h_onset": h_onset,
        "error": ca.if_else(accepted, ca.fmax(error, LEAST_ERROR), old["error"]),
    }


def _to_surface(mode: Any, end: Parts, retaken: Any) -> Any:
    """Time [s] until a gap closes, of a landing that fell short, or a contact opens; very large where neither is in sight.

    A contact's force only accelerates its opening, so speed alone bounds the time; a step beyond would meet the kink of the force and be rejected.
    """
    sign = ca.if_else(mode == FLIGHT, 1, -1)
    g, rate, acceleration = (sign * end[part] for part in ("gap", "gap_rate", "gap_acceleration"))
    root = ca.sqrt(ca.fmax(rate * rate - 2 * acceleration * g, 0))
    landing = 2 * g / (root - rate)  # of the two roots the first positive one, without cancellation
    time = ca.if_else(retaken, landing, ca.if_else(mode == CONTACT, -g / rate, FINITE))
    return ca.mmin(ca.if_else((g > 0) * (rate < 0), time, FINITE))


def _first(*cases: tuple[Any, int], otherwise: int) -> Any:
    """Value of the first condition that holds."""
    value = ca.SX(otherwise)
    for condition, result in reversed(cases):
        value = ca.if_else(condition, result, value)
    return value
