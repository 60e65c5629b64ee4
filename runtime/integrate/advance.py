"""The plain attempt, by far the most frequent: one step that nothing speaks against and that changes nobody's mode.

It is one function without branches. Whatever is not plain is left to `settle` and `reject`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.choose import choice
from hertzwerk.runtime.integrate.classes import BY_MODE, modes
from hertzwerk.runtime.integrate.control import factor, near_surfaces, remembered, roughness
from hertzwerk.runtime.integrate.events import all_clear
from hertzwerk.runtime.integrate.layout import (
    CONTACT,
    FLIGHT,
    PLAIN,
    REJECTED,
    RELEASED,
    SPECIAL,
    Layouts,
)
from hertzwerk.runtime.integrate.methods import stepper
from hertzwerk.runtime.integrate.modes import all_of, is_finite

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.classes import Contacts
    from hertzwerk.runtime.integrate.methods import Table
    from hertzwerk.runtime.model import Model


def advance(model: Model, vectors: Layouts, table: Table, contacts: Contacts, *, chooses: bool = False) -> Any:
    """CasADi function (state, controls) -> (next, verdict) of the class of attempts with these contacts.

    next: the state after the step, if verdict says it is plain; otherwise its t, y, dy and pair parts are those of the end of the step.
    chooses: whether the table is one of two to choose from.
    """
    contact = contacts != ()
    state, controls = vectors.state.symbol("state"), vectors.controls.symbol("controls")
    old, run = vectors.state.split(state), vectors.controls.split(controls)
    if contacts is BY_MODE:
        mode, plain = old["mode"], all_of(old["mode"] != RELEASED)
    else:  # the class says it, so that nothing is left to decide but whether a pair is released in flight
        mode, plain = modes(model, contacts), ca.SX(1) if contact else all_of(old["mode"] == FLIGHT)
    h, steps = old["h"], old["steps"] + 1
    end = stepper(model, table, contacts)({**old, "mode": mode}, run, h)
    if contact:
        end["error"] *= roughness(mode == CONTACT, old["gap"], end["gap"])
    error, in_range = end.pop("error"), end.pop("in_range")
    left = run["t_end"] - end["t"]
    passed = (error <= 1) * is_finite(end)
    clear = plain * (1 - old["fresh_contact"]) * (left > 0) * (steps < run["max_steps"])
    if model.k:
        clear *= all_of(all_clear(model, run, mode, old, end))
    if contact:
        clear *= all_of(in_range > 0.5)

    grown = factor(table, error)
    grown = h * ca.if_else(old["after_rejection"], ca.fmin(grown, 1), grown)
    own = "h_contact" if contact else "h_flight"
    kept = remembered(h, old[own], grown)
    free = ca.fmin(kept, run["h_max"]) if contact else kept
    if model.k:
        free = near_surfaces(free, old["h_onset"], mode, end)
    new = {
        **old,
        **end,
        own: kept,
        "h": ca.if_else(1.01 * free >= left, left, free),
        "accepted": ca.SX(1),
        "after_rejection": ca.SX(0),
        "retakes": ca.SX(0),
        "steps": steps,
        "evaluations": old["evaluations"] + table.stages,
    }
    if chooses:
        new |= choice(model, contacts, {**old, "mode": mode}, run, end, kept)
    judged = REJECTED + passed * (SPECIAL - REJECTED + clear * (PLAIN - SPECIAL))
    verdict = {"kind": judged, "error": error, "in_range": in_range}
    return ca.Function(
        "advance_in_contact" if contact else "advance_in_flight",
        [state, controls],
        ca.cse([vectors.state.join(new), vectors.verdict.join(verdict)]),
        ["state", "controls"],
        ["next", "verdict"],
    )
