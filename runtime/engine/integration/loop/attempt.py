"""One attempt, state -> state: try a step, then accept, shorten, or retake it to land on an event."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.events.event_landing import reject, settle
from hertzwerk.runtime.engine.integration.events.mode_changes import begin, enter
from hertzwerk.runtime.engine.integration.loop.method_choice import Choosing
from hertzwerk.runtime.engine.integration.loop.near_list import keeps_to_list
from hertzwerk.runtime.engine.integration.loop.plain_attempt import advance, lean, no_event_of_any_pair
from hertzwerk.runtime.engine.integration.loop.turning_slip import implicit_near_rest, passes_by_implicit_steps
from hertzwerk.runtime.engine.integration.many_pairs.watched_model import WatchedModel
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, Contacts, contact_classes
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import REJECTED, RUNNING, Layouts, event_layouts, layouts
from hertzwerk.runtime.engine.integration.step.singular_positions import explicit_near
from hertzwerk.runtime.engine.integration.step.stepper import stepper
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta, dopri5
from hertzwerk.runtime.engine.integration.tableaux.implicit_tableaux import esdirk54
from hertzwerk.runtime.engine.integration.tableaux.methods import Table
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

FINISH = "finish"  # name of the function that completes an attempt, by an event or a rejection


@dataclass(frozen=True, eq=False)
class Integrator:
    """CasADi functions of one model and method: initial state, attempt, dense output.

    requested    tables that `integrator` was given
    tables   by the state's `method`; a run whose `attempt` uses only the first may continue with the integrator `with_choice`
    """

    layouts: Layouts
    begin: Any  # (t, q, u, latches, controls) -> state
    attempt: Any  # (state, controls) -> state
    enter: Any  # (state, controls) -> state with other pieces of the inputs; None without inputs
    model: EngineModel
    tables: tuple[Table, ...]
    requested: tuple[Table, ...] = ()
    with_choice: Callable[[], Integrator] | None = None
    _steps: dict[Hashable, Any] = field(default_factory=dict)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle and copy what it was made of; it is built anew."""
        return integrator, (self.model, self.requested)

    def step(self, method: int = 0, contacts: Contacts = BY_MODE, parts: tuple[str, ...] | None = None) -> Any:
        """Return (state, controls, h) -> trial, or parts of it, by a method's table; built on first use."""
        known = method, contacts, parts
        if known not in self._steps:
            h = self.layouts.kind.sym("h")
            arguments, (start, run) = self.layouts.symbols("state controls")
            trial = stepper(self.model, self.tables[method], contacts)(start, run, h)
            result = self.layouts.trial.join(trial) if parts is None else ca.vertcat(*(trial[part] for part in parts))
            names = ["state", "controls", "h"]
            which = ("by_mode",) if contacts is BY_MODE else contacts
            name = "_".join(map(str, ("step", method, *which, "of", result.numel())))  # one C program may have several
            self._steps[known] = lean(name, [*arguments, h], [ca.densify(result)], names, ["trial"])
        return self._steps[known]


def integrator(model: EngineModel, tables: tuple[Table, ...]) -> Integrator:
    """Build the attempt of a model with a method of one table, or of two to choose from (`method_choice`).

    With two, the attempt steps by the first and watches for stiffness; `with_choice` chooses in every step. For closed
    loops an implicit table is joined by an explicit one to pass singular positions, and an explicit one by an implicit one where
    directions of sliding turn too fast for it.
    """
    alone, explicit = len(tables) == 1, isinstance(tables[0], RungeKutta)
    if alone and not (passes_by_implicit_steps(model, tables) if explicit else model.nl):
        return replace(_integrator(model, tables, tables, Choosing.NONE), requested=tables)
    requested, tables = tables, (*tables, esdirk54() if explicit else dopri5()) if alone else tables
    first, later = (Choosing.NONE,) * 2 if alone else (Choosing.ON_SUSPICION, Choosing.EVERY_STEP)
    with_choice = cache(lambda: _integrator(model, tables, tables, later))
    return replace(_integrator(model, tables[:1], tables, first), requested=requested, with_choice=with_choice)


def _integrator(
    model: EngineModel, taken: tuple[Table, ...], tables: tuple[Table, ...], choosing: Choosing
) -> Integrator:
    """Build an attempt that steps by some (`taken`) of a method's tables."""
    vectors, right = layouts(model), flow(model)
    # called with MX, so that one branch of each is evaluated; SX would evaluate all
    ends = [after for table in taken for after in _completions(model, table)]
    state, controls, end, verdict = ends[0].mx_in()
    method = state[vectors.state["method"]] if len(taken) > 1 else None
    plain = _unchanged(ends[0])
    finish = ca.Function.conditional(FINISH, [plain, *ends[:-1]], ends[-1])
    idle = ca.Function("idle", [state, controls], [state, ca.MX.zeros(vectors.verdict.size)])
    classes = contact_classes(model)
    tries = [advance(model, vectors, table, contacts, choosing) for table in taken for contacts in classes]
    advanced = ca.Function.conditional("advance", [idle, *tries[:-1]], tries[-1])
    taking = state[vectors.state["class"]]
    if len(tables) > 1 or isinstance(model, WatchedModel):  # others are to go on from a SUSPECT, CALM or STALE state
        taking *= state[vectors.state["status"]] >= RUNNING
    end, verdict = advanced(_case(taking, method, len(classes)), state, controls)
    done = finish(_case(verdict[vectors.verdict["kind"]], method, REJECTED), state, controls, end, verdict)
    if isinstance(model, WatchedModel):
        done = keeps_to_list(model, vectors)(done, controls)
    if passes_by_implicit_steps(model, tables):
        done = implicit_near_rest(model, tables, taken, alone=choosing is Choosing.NONE)(done, controls)
    if model.nl and not all(isinstance(table, RungeKutta) for table in taken):
        done = explicit_near(vectors.state, tables, taken)(done)
    return Integrator(
        layouts=vectors,
        begin=begin(model, event_layouts(model), right),
        enter=enter(model, event_layouts(model), right) if model.inputs else None,
        attempt=ca.Function("attempt", [state, controls], [done], ["state", "controls"], ["next"]),
        model=model,
        tables=tables,
    )


@per_model
def _completions(model: EngineModel, table: Table) -> tuple[Any, Any, Any]:
    """Return the functions that complete a step that is NEAR, SPECIAL, REJECTED."""
    vectors = event_layouts(model)
    special = settle(model, vectors, table, flow(model))
    near = special
    if model.k > 1:  # one pair is always asked
        arguments = special.mx_in()
        judge = ca.Function.if_else("judge", _unchanged(special), special)
        near = ca.Function(
            "asked", arguments, [judge(no_event_of_any_pair(model, vectors)(*arguments[:3]), *arguments)]
        )
    return near, special, reject(vectors, table)


def _unchanged(like: Any) -> Any:
    """Return the function that leaves a step as it is; arguments as of another."""
    arguments = like.mx_in()
    return ca.Function("plain", arguments, [arguments[2]])


def _case(number: Any, method: Any, count: int) -> Any:
    """Return the index among the cases: 0, those of the first table, those of the second.

    method: None where there is one table.
    """
    return number if method is None else number + count * method * (number > 0)
