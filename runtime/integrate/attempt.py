"""One attempt: a step is tried, then accepted, shortened for its error, or retaken to land on an event; as CasADi functions state -> state."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.integrate.advance import advance
from hertzwerk.runtime.integrate.explicit import Flow, flow, step
from hertzwerk.runtime.integrate.layout import IN_CONTACT, IN_FLIGHT, Layouts, layouts
from hertzwerk.runtime.integrate.modes import begin
from hertzwerk.runtime.integrate.settle import reject, settle

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.tables import RungeKutta
    from hertzwerk.runtime.model import Model


@dataclass(frozen=True)
class Integrator:
    """The functions of one model and method: `begin` makes the first state, `attempt` one from another, `step` is the dense output."""

    layouts: Layouts
    begin: Any  # (t, q, u, controls) -> state
    attempt: Any  # (state, controls) -> state
    table: RungeKutta
    flow: Flow

    @cached_property
    def step(self) -> Any:
        """(state, controls, h) -> trial; made when first asked for, as a run itself needs none."""
        return step(self.layouts, self.table, self.flow)


def integrator(model: Model, table: RungeKutta) -> Integrator:
    """Build the attempt of a model with an explicit method."""
    vectors, right = layouts(model), flow(model)
    # called with MX, so that one branch of each is evaluated; SX would evaluate all
    special = settle(model, vectors, table, right)
    state, controls, end, verdict = special.mx_in()
    plain = ca.Function("plain", [state, controls, end, verdict], [end])
    finish = ca.Function.conditional("finish", [plain, special], reject(vectors, table))
    idle = ca.Function("idle", [state, controls], [state, ca.MX.zeros(vectors.verdict.size)])
    kinds = (IN_FLIGHT, IN_CONTACT) if model.k else (IN_FLIGHT,)
    *others, last = [idle, *(advance(model, vectors, table, kind) for kind in kinds)]
    advanced = ca.Function.conditional("advance", others, last)
    end, verdict = advanced(state[vectors.state["class"]], state, controls)
    done = finish(verdict[vectors.verdict["kind"]], state, controls, end, verdict)
    return Integrator(
        layouts=vectors,
        begin=begin(model, vectors, right),
        attempt=ca.Function("attempt", [state, controls], [done], ["state", "controls"], ["next"]),
        table=table,
        flow=right,
    )
