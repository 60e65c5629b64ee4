"""Singular positions, where constraints become dependent: steps pass over and never evaluate there.

The motion goes through such a position smoothly, but the constraint forces grow as 1/distance there, and with them
the stages' deviation from the constraints: shorter steps only evaluate nearer to the singularity. So a step over the
position places it in the widest gap between the method's nodes, and a step before it leaves room for such a step.

Off the constraints speeds grow at the rate 2/(time to the position) before it and decay likewise behind it: of the
size of 1/h in every step that comes near, however short, and of either sign within one step. The Jacobian at the
start then predicts nothing of the stages, and iterations diverge; explicit stages deviate a few times more, which the
projection at the end removes. So implicit methods pass by explicit steps.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.step.layout import RUNNING, SUSPECT, Layout
from hertzwerk.runtime.engine.integration.step.step_size_control import FAR
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.tableaux.methods import Table
    from hertzwerk.runtime.engine.model.model import EngineModel

NEARBY = 0.05  # independent part of a constraint's square below which a singular position may be near
MARGIN = 0.25  # of the gap between two nodes: distance that the position keeps from both
REACH = 2.0  # steps: distance below which none is implicit; with 1, esdirk still shrinks onto the position at a tolerance of 1e-13
AT_ONCE = 0.25  # of the first node: a position this close to the start of a step counts as passed


def time_to_singular(model: EngineModel, t: Any, q: Any, dq: Any, c: Any) -> Any:
    """Return the time [s] (1) until a constraint becomes dependent on others, or FAR; (0) for a tree.

    The independent remainder of a constraint is a square: near zero its root falls linearly.
    """
    if not model.nl:
        return ca.SX(0, 1)
    _, independence = model.function("projection")(t, q, ca.SX.zeros(model.nl), c)
    rate = ca.jtimes(independence, ca.vertcat(t, q), ca.vertcat(1, dq))
    falls = (independence < NEARBY) * (rate < 0)
    return ca.mmin(ca.if_else(falls, -2 * independence / ca.if_else(falls, rate, -1), FAR))


def limited_by_singular(table: Table, h: Any, ahead: Any) -> Any:
    """Limit the step h [s] so that a singular position lies well between its nodes or beyond it.

    ahead [s]: the time to the position (1), or (0) for a tree.
    """
    if not ahead.numel():
        return h
    first, low, high = _gap(table)
    over = ahead / ((low + high) / 2)
    before = ahead - h * (low + high) / 2
    clear = (ahead < AT_ONCE * first * h) + (ahead >= low * h) * (ahead <= high * h) + (before >= h) > 0
    return ca.if_else(clear, h, ca.if_else(ahead < low * h, over, before))


def explicit_near(state: Layout, tables: tuple[Table, ...], taken: tuple[Table, ...]) -> Any:
    """Build the CasADi function state -> state that selects the explicit method near a singular position.

    If that table is not among `taken`, the status SUSPECT requests it.
    """
    symbol = state.symbol("state")
    parts = state.split(symbol)
    explicit = next(i for i, table in enumerate(tables) if isinstance(table, RungeKutta))
    near = parts["ahead"] < REACH * parts["h"]
    parts["method"] = ca.if_else(near, explicit, parts["method"] if explicit == 0 else 0)
    if tables[explicit] not in taken:
        parts["status"] = ca.if_else(near * (parts["status"] == RUNNING), SUSPECT, parts["status"])
    return ca.Function("explicit_near", [symbol], [state.join(parts)], ["state"], ["chosen"])


def _gap(table: Table) -> tuple[float, float, float]:
    """Return the first node of a step and the usable part of its widest gap between nodes."""
    places = table.alpha if hasattr(table, "alpha") else table.c
    nodes = np.unique(np.clip([0.0, 1.0, *places], 0, 1))
    gaps = np.diff(nodes)
    widest = int(np.argmax(gaps))
    margin = MARGIN * gaps[widest]
    return float(nodes[1]), float(nodes[widest] + margin), float(nodes[widest + 1] - margin)
