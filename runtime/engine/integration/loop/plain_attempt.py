"""The plain attempt, by far the most frequent: an accepted step without event or mode change.

It is one function without branches. Everything else is left to `settle` and `reject`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.engine.integration.events.effect_events import none_possible, time_to_event
from hertzwerk.runtime.engine.integration.events.event_location import far_apart, no_event_possible, unresolved
from hertzwerk.runtime.engine.integration.events.mode_changes import all_of, is_finite
from hertzwerk.runtime.engine.integration.loop.method_choice import Choosing, choice, suspicion
from hertzwerk.runtime.engine.integration.many_pairs.watched_model import WatchedModel
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, Contacts, modes
from hertzwerk.runtime.engine.integration.step.implicit_step import linearised, uses_calls
from hertzwerk.runtime.engine.integration.step.layout import (
    CONTACT,
    FLIGHT,
    NEAR,
    PLAIN,
    REJECTED,
    RELEASED,
    SPECIAL,
    Layouts,
)
from hertzwerk.runtime.engine.integration.step.set_valued_friction import margins_positive, may_slip
from hertzwerk.runtime.engine.integration.step.singular_positions import limited_by_singular
from hertzwerk.runtime.engine.integration.step.step_size_control import (
    factor,
    limited_by_surfaces,
    roughness,
    step_to_continue,
)
from hertzwerk.runtime.engine.integration.step.stepper import stages_inlined, stepper
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.system.interrupt import poll

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.tableaux.methods import Table


LARGE = 5000  # operations
CALLED = 100_000  # operations of the functions that are called


def lean(name: str, arguments: Any, results: Any, *names: Any) -> Any:
    """Build a function that does nothing twice, or a large one as it is.

    To find the 3 to 8 % that are done twice takes half the time that it takes to build a large one, or that of 10,000
    of its calls. Among calls of large functions, these are compared as well: a second for each 150,000 operations.
    """
    made = ca.Function(name, arguments, results, *names)
    called = sum(f.n_instructions() for f in made.find_functions() if f.is_a("SXFunction"))
    if made.n_instructions() > LARGE or called > CALLED:
        return made
    return ca.Function(name, arguments, ca.cse(results), *names)


def pairs_by_polynomial(model: EngineModel, contacts: Contacts) -> list[int]:
    """Return the pairs whose gap polynomials are checked in every step of a class.

    Those in contact, and all where there is only one.
    """
    return list(range(model.k)) if contacts is BY_MODE or model.k == 1 else list(contacts)


@per_model
def no_event_of_any_pair(model: EngineModel, vectors: Layouts) -> Any:
    """Build the function (state, controls, next) -> 1 if no pair can have an event in the step."""
    arguments, (old, run, end) = vectors.symbols("state controls next")
    clear = all_of(no_event_possible(model, run, old["mode"], old, end, list(range(model.k))))
    return ca.Function("near", arguments, [ca.cse(clear)], ["state", "controls", "next"], ["clear"])


def advance(
    model: EngineModel, vectors: Layouts, table: Table, contacts: Contacts, choosing: Choosing = Choosing.NONE
) -> Any:
    """Build the function (state, controls) -> (next, verdict) of attempts with these contacts.

    next: the state after the step if the verdict is plain; otherwise its t, y, dy and pair parts are those of the end
    of the step.
    """
    arguments, (old, run) = vectors.symbols("state controls")
    poll()  # each part takes up to a second of a large model
    mode = old["mode"] if contacts is BY_MODE else modes(model, contacts)
    name = "advance_in_contact" if contacts != () else "advance_in_flight"
    names = ["state", "controls"], ["next", "verdict"]
    as_vectors = vectors.kind is ca.MX
    calls_step = not stages_inlined(model, table, contacts)
    calls_jacobian = uses_calls(model) and choosing is Choosing.EVERY_STEP
    if as_vectors or not (calls_step or calls_jacobian):
        details: dict[str, Any] = {}
        end = stepper(model, table, contacts, details)({**old, "mode": mode}, run, old["h"])
        poll()
        return lean(name, arguments, _judged(model, vectors, table, contacts, choosing, old, run, end, details), *names)

    # what is called is computed from MX, and judged by a function of its results
    state, controls = (ca.MX.sym(part, vector.numel()) for part, vector in zip(names[0], arguments, strict=True))
    called_old = vectors.state.split(state)
    called_run = vectors.within(vectors.controls.split(controls), called_old)
    start = called_old if contacts is BY_MODE else {**called_old, "mode": ca.MX(ca.DM(mode))}
    results: dict[str, Any] = {}
    if calls_step:
        end = stepper(model, table, contacts, results)(start, called_run, called_old["h"])
        results["trial"] = ca.vertcat(*(ca.densify(ca.MX(end[part])) for part in vectors.trial.sizes))
    if calls_jacobian and "J" not in results:
        results["J"], _ = linearised(model, contacts)(
            *(start[part] for part in ("t", "y", "mode", "m")), called_run["c"]
        )
    poll()
    details = {part: ca.SX.sym(part, value.sparsity()) for part, value in results.items()}
    end = (
        vectors.trial.split(details["trial"])
        if calls_step
        else stepper(model, table, contacts, details)({**old, "mode": mode}, run, old["h"])
    )
    inputs = [details[part] for part in results]
    judged = lean(
        "judged", [*arguments, *inputs], _judged(model, vectors, table, contacts, choosing, old, run, end, details)
    )
    poll()
    return ca.Function(name, [state, controls], list(judged.call([state, controls, *results.values()])), *names)


def _judged(
    model: EngineModel,
    vectors: Layouts,
    table: Table,
    contacts: Contacts,
    choosing: Choosing,
    old: dict[str, Any],
    run: dict[str, Any],
    end: dict[str, Any],
    details: dict[str, Any],
) -> list[Any]:
    """Return [next, verdict] of a step from `old` that ends in the trial `end`."""
    contact = contacts != ()
    if contacts is BY_MODE:
        mode, plain = old["mode"], all_of(old["mode"] != RELEASED)
    else:  # the class says it, so that nothing is left to decide but whether a pair is released in flight
        mode, plain = modes(model, contacts), ca.DM(1) if contact else all_of(old["mode"] == FLIGHT)
    h, steps = old["h"], old["steps"] + 1
    if contact:
        end["error"] *= roughness(mode == CONTACT, old["gap"], end["gap"])
    error, in_range = end.pop("error"), end.pop("in_range")
    if model.k:
        unseen = unresolved(run, mode, old, end)
        if isinstance(model, WatchedModel):
            used = model.used(run, old, end)
            unseen = ca.fmax(unseen, ca.if_else(used > 1, used, 0))  # no error that a shorter step has less of
        error = ca.if_else(unseen > error, unseen, error)  # one that is not finite stays
    remaining = run["t_end"] - end["t"]
    passed = (error <= 1) * is_finite(end)
    clear = plain * (1 - old["fresh_contact"]) * (remaining > 0) * (steps < run["max_steps"])
    polynomial = pairs_by_polynomial(model, contacts)
    if model.ne:
        clear *= none_possible(old, end)
    others = [j for j in range(model.k) if j not in polynomial]
    if polynomial:
        clear *= all_of(no_event_possible(model, run, mode, old, end, polynomial))
    if not polynomial and may_slip(model, contacts):
        clear *= margins_positive(model, mode, old, end)
    apart = all_of(far_apart(model, run, old, end, others)) if others else ca.DM(1)
    if contact or model.nr > model.k:
        clear *= all_of(in_range > 0.5)

    grown = factor(table, error)
    grown = h * ca.if_else(old["after_rejection"], ca.fmin(grown, 1), grown)
    own = "h_contact" if contact else "h_flight"
    to_continue = step_to_continue(h, old[own], grown)
    free = ca.fmin(to_continue, run["h_max"]) if contact else to_continue
    if model.k:
        free = limited_by_surfaces(free, old["h_onset"], mode, end)
    if model.ne:
        free = ca.fmin(free, time_to_event(run, end, end["t"]))
    free = limited_by_singular(table, free, end["ahead"])
    new = {
        **old,
        **end,
        own: to_continue,
        "h": ca.if_else(1.01 * free >= remaining, remaining, free),
        "accepted": ca.DM(1),
        "after_rejection": ca.DM(0),
        "retakes": ca.DM(0),
        "steps": steps,
        "evaluations": old["evaluations"] + table.stages,
    }
    if choosing is Choosing.EVERY_STEP:
        new |= choice(model, contacts, {**old, "mode": mode}, run, end, to_continue, details.get("J"))
    elif choosing is Choosing.ON_SUSPICION:
        new |= suspicion(model, contacts, old, run, end, to_continue, details)
    judged = REJECTED + passed * (SPECIAL - REJECTED + clear * (NEAR - SPECIAL + apart * (PLAIN - NEAR)))
    verdict = {"kind": judged, "error": error, "in_range": in_range}
    return [vectors.state.join(new), vectors.verdict.join(verdict)]
