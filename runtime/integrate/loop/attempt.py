"""One attempt: a step is tried, then accepted, shortened for its error, or retaken to land on an event; as CasADi functions state -> state."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.events.modes import begin
from hertzwerk.runtime.integrate.events.settle import reject, settle
from hertzwerk.runtime.integrate.loop.advance import advance, near
from hertzwerk.runtime.integrate.loop.choose import Choosing
from hertzwerk.runtime.integrate.step.classes import BY_MODE, kinds
from hertzwerk.runtime.integrate.step.explicit import flow
from hertzwerk.runtime.integrate.step.layout import REJECTED, Layouts, layouts
from hertzwerk.runtime.integrate.step.methods import Table, stepper
from hertzwerk.runtime.integrate.step.singular import explicit_near
from hertzwerk.runtime.integrate.tableaux.explicit_tableaux import RungeKutta, dopri5

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.step.explicit import Flow
    from hertzwerk.runtime.model.model import Model


@dataclass(frozen=True)
class Integrator:
    """The functions of one model and method: `begin` makes the first state, `attempt` one from another, `step` is the dense output.

    tables   by the state's `method`; where `attempt` takes steps by the first alone, a state may go on with those of `whole`
    """

    layouts: Layouts
    begin: Any  # (t, q, u, controls) -> state
    attempt: Any  # (state, controls) -> state
    model: Model
    tables: tuple[Table, ...]
    whole: Callable[[], Integrator] | None = None
    _steps: dict[int, Any] = field(default_factory=dict)

    def step(self, method: int = 0) -> Any:
        """(state, controls, h) -> trial, by the table of a method; made when first asked for, as a run itself needs none."""
        if method not in self._steps:
            vectors, h = self.layouts, ca.SX.sym("h")
            state, controls = vectors.state.symbol("state"), vectors.controls.symbol("controls")
            start, run = vectors.state.split(state), vectors.controls.split(controls)
            trial = vectors.trial.join(stepper(self.model, self.tables[method], BY_MODE)(start, run, h))
            names = ["state", "controls", "h"]
            self._steps[method] = ca.Function("step", [state, controls, h], [ca.cse(trial)], names, ["trial"])
        return self._steps[method]


def integrator(model: Model, tables: tuple[Table, ...]) -> Integrator:
    """Build the attempt of a model with a method of one table, or of two that it chooses from on the way (`choose`).

    The attempt is that of the first table alone, which looks whether there may be something to choose; `whole` has that which chooses. An implicit
    table has an explicit one beside it for singular positions, which only closed loops have.
    """
    alone = len(tables) == 1
    if alone and (isinstance(tables[0], RungeKutta) or not model.nl):
        return _integrator(model, tables, tables, Choosing.NONE)
    tables = (*tables, dopri5()) if alone else tables
    first, later = (Choosing.NONE,) * 2 if alone else (Choosing.ON_SUSPICION, Choosing.EVERY_STEP)
    whole = cache(lambda: _integrator(model, tables, tables, later))
    return replace(_integrator(model, tables[:1], tables, first), whole=whole)


def _integrator(model: Model, taken: tuple[Table, ...], tables: tuple[Table, ...], choosing: Choosing) -> Integrator:
    """An attempt that takes steps by some of a method's tables."""
    vectors, right = layouts(model), flow(model)
    # called with MX, so that one branch of each is evaluated; SX would evaluate all
    ends = [after for table in taken for after in _ends(model, vectors, table, right)]
    state, controls, end, verdict = ends[0].mx_in()
    method = state[vectors.state["method"]]
    plain = _plain(ends[0])
    finish = ca.Function.conditional("finish", [plain, *ends[:-1]], ends[-1])
    idle = ca.Function("idle", [state, controls], [state, ca.MX.zeros(vectors.verdict.size)])
    classes = kinds(model)
    tries = [advance(model, vectors, table, contacts, choosing) for table in taken for contacts in classes]
    advanced = ca.Function.conditional("advance", [idle, *tries[:-1]], tries[-1])
    end, verdict = advanced(_case(state[vectors.state["class"]], method, len(classes)), state, controls)
    done = finish(_case(verdict[vectors.verdict["kind"]], method, REJECTED), state, controls, end, verdict)
    if model.nl and not all(isinstance(table, RungeKutta) for table in taken):
        done = explicit_near(vectors.state, tables, taken)(done)
    return Integrator(
        layouts=vectors,
        begin=begin(model, vectors, right),
        attempt=ca.Function("attempt", [state, controls], [done], ["state", "controls"], ["next"]),
        model=model,
        tables=tables,
    )


def _ends(model: Model, vectors: Layouts, table: Table, right: Flow) -> Iterator[Any]:
    """What follows from a step that is NEAR, SPECIAL, REJECTED."""
    special = settle(model, vectors, table, right)
    given = special.mx_in()
    if model.k > 1:
        judge = ca.Function.if_else("judge", _plain(special), special)
        yield ca.Function("asked", given, [judge(near(model, vectors)(*given[:3]), *given)])
    else:
        yield special  # one pair is always asked
    yield special
    yield reject(vectors, table)


def _plain(like: Any) -> Any:
    """A step that stays as it is; arguments as of another."""
    given = like.mx_in()
    return ca.Function("plain", given, [given[2]])


def _case(number: Any, method: Any, count: int) -> Any:
    """Number among the cases (0, those of the first table, those of the second): 0, or one of 1, ..., count under the method 0 or 1."""
    return number + count * method * (number > 0)
