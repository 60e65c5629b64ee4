"""One step of any method."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeAlias

import casadi as ca

from hertzwerk.runtime.engine.integration.step import explicit_step, implicit_step
from hertzwerk.runtime.engine.integration.step.contact_classes import Contacts, contact_classes
from hertzwerk.runtime.engine.integration.step.redundant_constraints import relax_redundant
from hertzwerk.runtime.engine.integration.step.set_valued_friction import unresolved_grips
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.engine.model.model import EngineModel

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.tableaux.methods import Table

INLINED = 3000  # instructions of all stages of a step; more are called: inlined they take long to build and to compile
# The same of the steps of all classes: translational_clearance (11,400) compiles in 0.7 of the time, with the same bits and speed; woodpecker (9,400)
# would run a tenth longer.
INLINED_TOGETHER = 10_000
Take: TypeAlias = Callable[[Mapping[str, Any], Mapping[str, Any], Any], dict[str, Any]]


def stages_inlined(model: EngineModel, table: Table, contacts: Contacts) -> bool:
    """Return whether a step contains its stages; else each calls the right-hand side."""
    if not isinstance(table, RungeKutta):
        return not implicit_step.uses_calls(model)
    classes = contacts, *contact_classes(model)
    counts = [table.stages * explicit_step.flow(model, each).rates.n_instructions() for each in classes]
    together = sum(count for count in counts[1:] if count <= INLINED)
    return bool(counts[0] <= INLINED and together <= INLINED_TOGETHER)


def stepper(model: EngineModel, table: Table, contacts: Contacts, details: dict[str, Any] | None = None) -> Take:
    """Return (start, run, h) -> trial: one step of h [s] with the forces of these contacts.

    `details` as in `explicit_step.explicit_step`.
    """
    right, within = explicit_step.flow(model, contacts), relax_redundant(model)
    if isinstance(table, RungeKutta):

        def take(start: Mapping[str, Any], run: Mapping[str, Any], h: Any) -> dict[str, Any]:
            return explicit_step.explicit_step(table, right, start, within(start, run), h, details)
    else:
        implicitly = implicit_step.stepper(model, table, right, contacts)

        def take(start: Mapping[str, Any], run: Mapping[str, Any], h: Any) -> dict[str, Any]:
            return implicitly(start, within(start, run), h, details)

    if not model.ns:
        return take

    def resolved(start: Mapping[str, Any], run: Mapping[str, Any], h: Any) -> dict[str, Any]:
        trial = take(start, run, h)
        unseen = unresolved_grips(model, run, start, trial, h)
        return {**trial, "error": ca.if_else(unseen > ca.fmax(trial["error"], 1), unseen, trial["error"])}

    return resolved
