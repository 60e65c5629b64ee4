"""Directions of sliding that turn faster than explicit steps can follow.

Where a pair may slide in two directions, that of its sliding velocity s relaxes to the one in which it accelerates, at the rate
(sliding force) x (mobility)/|s|: without bound where sliding begins or ends. Where a pair breaks loose |s| grows like t^2, so that stability would
hold explicit steps down ever longer the smaller the tolerance, and the errors that they leave in the direction of the force add up, unseen beside
those of a speed that is next to none. So explicit methods pass by implicit steps, as implicit ones pass singular positions by explicit steps
(`singular_positions`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE
from hertzwerk.runtime.engine.integration.step.layout import CALM, RUNNING, SUSPECT, layouts
from hertzwerk.runtime.engine.integration.step.set_valued_friction import directed, grips, mobility, slips_in
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.tableaux.methods import Table

FOLLOWED = 3.0  # step x rate up to which explicit steps follow a direction: dopri5 is stable up to 3.3, dop853 up to 6
PASSING = -1.0  # pressure of a run that takes implicit steps for a direction that turns, and not because they save any (see `method_choice`)


@per_model
def turning_rate(model: EngineModel) -> Any:
    """Build the function (state, controls) -> fastest rate [1/s] of directions, see `Grips.turning`."""
    arguments, (old, run) = layouts(model).symbols("state controls")
    t, y, mode, m, c = (*(old[name] for name in ("t", "y", "mode", "m")), run["c"])
    q, u, _ = model.parts(y)
    now = grips(model, BY_MODE, t, y, mode, m, c)
    rate = now.turning(ca.mtimes(now.across, mobility(model, t, q, u, now.along, c)))
    return ca.Function("turning_rate", arguments, [ca.cse(rate)], ["state", "controls"], ["rate"])


def passes_by_implicit_steps(model: EngineModel, tables: tuple[Table, ...]) -> bool:
    """Return whether a method begins with explicit steps, and directions may turn too fast for them."""
    return isinstance(tables[0], RungeKutta) and bool(directed(model))


def implicit_near_rest(model: EngineModel, tables: tuple[Table, ...], taken: tuple[Table, ...], *, alone: bool) -> Any:
    """Build the function (state, controls) -> state that goes on implicitly where directions turn fast.

    If that table is not among `taken`, the status SUSPECT requests it. A step that failed is tried again by its own method.

    alone: nothing else chooses, so that the run goes on with explicit steps where none turns fast
    """
    vectors, rate = layouts(model), turning_rate(model)
    state, controls = rate.mx_in()
    parts = vectors.state.split(state)
    slides = ca.mmax(ca.fabs(parts["m"][slips_in(model)])) > 0
    none = ca.Function("none", [state, controls], [ca.MX(0)])
    fast = parts["h"] * ca.Function.if_else("turning", rate, none)(slides, state, controls) > FOLLOWED
    implicit = next(i for i, table in enumerate(tables) if not isinstance(table, RungeKutta))
    if alone:
        parts["method"] = ca.if_else(parts["accepted"], 0, parts["method"])
    taken_up = tables[implicit] in taken
    goes_on = (
        ca.logic_or(parts["status"] == RUNNING, parts["status"] == CALM) if taken_up else parts["status"] == RUNNING
    )
    fast = ca.logic_and(fast, ca.logic_and(goes_on, parts["accepted"]))
    new = {"method": implicit, "pressure": PASSING, "status": RUNNING if taken_up else SUSPECT}
    parts |= {name: ca.if_else(fast, value, parts[name]) for name, value in new.items()}
    return ca.Function("implicit_near_rest", [state, controls], [vectors.state.join(parts)])
