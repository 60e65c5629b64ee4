"""Events of effects: where a margin falls through zero, states of the effect change.

A margin is the cubic through its values and rates at both ends of a step, in units of its size. A step ends beyond the
root by half the tolerance, and an event happens by the margin as reached: where an accepted step ends at zero or below
it. One that is due at the end of the run happens, though rounding may leave its margin just above zero. One that has
happened and is still there happens again after the next step, so that none is lost; a relay without hysteresis then
switches as fast as the tolerance lets it, until the run has had the events that it may have.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.step.rounding_errors import EPS
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

LANDING = 1e-2  # of the tolerance: accuracy of an event, in units of its size
ROUNDINGS = 4  # of the time and of the margin
LOCATED = 16  # retakes of one step after which its end is taken as it is
CASCADE = 4  # most events that follow each other at one instant
FAR = 1e300


def tolerance(run: Mapping[str, Any], t: Any, end: Mapping[str, Any]) -> Any:
    """Return the tolerance (ne) of the margins, not below the rounding of the time and that of the state."""
    located = LANDING * run["tolerance"] + ROUNDINGS * EPS * (1 + ca.fabs(end["event_rate"]) * ca.fabs(t))
    return ca.fmax(located, ROUNDINGS * end["event_rounding"])


def due(run: Mapping[str, Any], end: Mapping[str, Any]) -> Any:
    """Return the levels (ne) of the margins at or below which events happen where a step ends.

    0, or at the end of the run what falling margins are uncertain by: every step rounds them once.
    """
    uncertain = tolerance(run, end["t"], end) + EPS * end["steps"]
    return ca.if_else((end["t"] >= run["t_end"]) * (end["event_rate"] < 0), uncertain, 0)


def cubics(start: Mapping[str, Any], end: Mapping[str, Any]) -> list[Any]:
    """Return the Bernstein coefficients (ne each) of the margins over a step."""
    third = start["h"] / 3
    first, last = start["event"], end["event"]
    return [first, first + third * start["event_rate"], last - third * end["event_rate"], last]


def none_possible(start: Mapping[str, Any], end: Mapping[str, Any]) -> Any:
    """Return 1 if no event can happen in a step."""
    return ca.mmin(ca.vertcat(*(coefficient > 0 for coefficient in cubics(start, end))))


def falls(run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any]) -> tuple[Any, list[Any], Any]:
    """Return, for the events (ne): whether a root is to be located, the cubics, the tolerances."""
    small, cubic = tolerance(run, end["t"], end), cubics(start, end)
    lowest = ca.fmin(ca.fmin(cubic[1], cubic[2]), cubic[3])
    return (cubic[0] > -small / 2) * (lowest < -small) * (start["retakes"] < LOCATED), cubic, small


def time_to_event(run: Mapping[str, Any], end: Mapping[str, Any], t: Any) -> Any:
    """Return the time [s] until a margin that goes on falling as now is beyond zero."""
    event, rate = end["event"], end["event_rate"]
    ahead = (event + tolerance(run, t, end) / 2) / -rate
    return ca.mmin(ca.if_else((event > 0) * (rate < 0), ahead, FAR))


@per_model
def jump(model: EngineModel) -> Any:
    """Return the function (t, y, c, levels (ne)) -> y after the events with margins up to their levels.

    Each happens at most once; one may bring about another.
    """
    (t, y, c), levels = model.symbols("t y c"), ca.SX.sym("levels", model.ne)
    q, u, z = model.parts(y)
    happened = ca.SX.zeros(model.ne)
    for _ in range(min(model.ne, CASCADE)):
        now = (model.function("margins")(t, q, u, c) <= levels) * (1 - happened)
        then, after, place = model.function("jumps")(t, q, u, c), ca.SX(q), 0
        for i, (_, rows) in enumerate(model.events):
            for row in rows:
                after[row] = ca.if_else(now[i], then[place], after[row])
                place += 1
        q, happened = after, happened + now
    return ca.Function("jump", [t, y, c, levels], [ca.cse(ca.vertcat(q, u, z))])
