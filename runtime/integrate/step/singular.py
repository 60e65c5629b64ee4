"""Singular positions, where constraints come to say the same: steps pass them in one stride, and none ends or looks there.

The motion goes through such a position smoothly, but what holds the loops closed grows as 1/distance there, and so does all that the stages of a step
are off the constraints by: the nearer a step looks, the less it sees, and steps that are shortened for that end nearer still. So a step that would go
over the position does so with it in the widest gap between the method's nodes, and a step before it leaves room for one that can.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import casadi as ca
import numpy as np

from hertzwerk.runtime.integrate.step.control import FAR

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.step.methods import Table
    from hertzwerk.runtime.model.model import Model

NEARBY = 0.05  # of a constraint's square that others leave of it: more is no singular position
KEPT = 0.25  # of the gap between two nodes: as far off them the position has to lie
AT_ONCE = 0.25  # of the first node: a position so close to the start of a step is behind it as good as over


def time_to_singular(model: Model, t: Any, q: Any, dq: Any, c: Any) -> Any:
    """Time [s] (1) until a constraint says only what others say; FAR where none is on the way to that. Of a tree (0).

    What others leave of a constraint is a square: near zero its root falls evenly.
    """
    if not model.nl:
        return ca.SX(0, 1)
    _, left = model.function("projection")(t, q, ca.SX.zeros(model.nl), c)
    rate = ca.jtimes(left, ca.vertcat(t, q), ca.vertcat(1, dq))
    falls = (left < NEARBY) * (rate < 0)
    return ca.mmin(ca.if_else(falls, -2 * left / ca.if_else(falls, rate, -1), FAR))


def clear_of_singular(table: Table, h: Any, ahead: Any) -> Any:
    """The step [s], `h` at most, that has a singular position `ahead` [s] (1, or none) well between its nodes, or leaves room for such a step."""
    if not ahead.numel():
        return h
    first, low, high = _gap(table)
    over = ahead / ((low + high) / 2)
    before = ahead - h * (low + high) / 2
    clear = (ahead < AT_ONCE * first * h) + (ahead >= low * h) * (ahead <= high * h) + (before >= h) > 0
    return ca.if_else(clear, h, ca.if_else(ahead < low * h, over, before))


def _gap(table: Table) -> tuple[float, float, float]:
    """The first node of a step, and the part of its widest gap between nodes in which a singular position does no harm."""
    found = table.alpha if hasattr(table, "alpha") else table.c
    nodes = np.unique(np.clip([0.0, 1.0, *found], 0, 1))
    gaps = np.diff(nodes)
    widest = int(np.argmax(gaps))
    margin = KEPT * gaps[widest]
    return float(nodes[1]), float(nodes[widest] + margin), float(nodes[widest + 1] - margin)
