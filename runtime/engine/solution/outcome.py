"""Outcome of a run as a value: its name, a description, and a remedy, such as another method."""

from __future__ import annotations

import traceback
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.engine.accuracy.error_estimate import LEAST, ErrorEstimate, beyond_horizon, brief, reach
from hertzwerk.runtime.engine.integration.loop import method_choice
from hertzwerk.runtime.engine.integration.loop.chunk import EXCEPTION, INTERRUPTED, STALLED, WALL_TIME_LIMIT
from hertzwerk.runtime.engine.integration.step.layout import (
    CONSTRAINT_LOST,
    EVENT_LIMIT,
    FINISHED,
    NOT_FINITE,
    OUTSIDE_LAW_RANGE,
    STEP_TOO_SMALL,
    TOO_MANY_STEPS,
)
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.engine.integration.tableaux.methods import IMPLICIT, METHODS, SUNDIALS
from hertzwerk.runtime.engine.model.caller import Rowwise
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.history import History

LAST = 200  # rows examined
MOST = 0.5  # of these, for a cause to be recognised
AUTO = 'take method="auto"'

FRICTION_LOCKS = STALLED + 1  # which is found of a run that left the range of a law, or has come to a halt
REACHED_END = ("finished", "accuracy_unreachable", "beyond_horizon", "accuracy_unknown", "energy_not_closed")  # names
# statuses of runs whose steps were many or too small
STEPS = (STEP_TOO_SMALL, TOO_MANY_STEPS, WALL_TIME_LIMIT, STALLED)
CLOSES = 100  # times the accuracy: largest error of a run's energy balance; a run at a tolerance may add one tolerance per step


def _method_for_steps(method: str, history: History) -> str:
    """Recommend a method in place of one whose steps were many or too small; "" if none need be better."""
    (table, *others) = (table() for table in METHODS[method])
    if others or method in SUNDIALS or not len(history.rows):
        return ""
    rows = history.rows[-LAST:]
    (rates,) = _fastest(history.model)(history.controls, rows)
    stiff = bool(np.mean(rates[:, 0] > method_choice.STIFF / 2) > MOST)
    explicit = isinstance(table, RungeKutta)
    if explicit and stiff:
        return f"stability, not accuracy, limits the steps of {method}: {AUTO}, or {' or '.join(IMPLICIT)}"
    if explicit and _alternates(rates[:, 1:]):
        return f"step after step of {method} crosses the layer in which friction reverses: {AUTO}, or {' or '.join(IMPLICIT)}"
    if not explicit and not stiff:
        return f"nothing is stiff there, and steps of {method} are shorter than those of dop853: {AUTO}"
    return ""


@per_model
def _fastest(model: EngineModel) -> Rowwise:
    return Rowwise(method_choice.fastest(model), constant=1)


def _method_for_accuracy(method: str) -> str:
    """Recommend a method in place of one that cannot reach some error."""
    if method in ("auto", "dop853"):
        return ""
    return f"many steps of {method} leave more rounding than the few of dop853, of higher order: {AUTO}"


def _alternates(sliding: np.ndarray) -> bool:
    """Return whether a sliding velocity (rows, n) changes its sign about every other step."""
    turned = np.diff(np.sign(sliding), axis=0) != 0
    return bool(turned.size and np.max(np.mean(turned, axis=0)) > MOST / 2)


@dataclass(frozen=True)
class Outcome:
    """End of a run: `finished`, or the reason for the stop, with a description and a remedy."""

    name: str
    message: str
    remedy: str

    @property
    def finished(self) -> bool:
        """Return whether the run reached its end."""
        return self.name == "finished"


_OUTCOMES = {
    FINISHED: ("finished", "reached the end at t = {t:.6g} s", ""),
    STEP_TOO_SMALL: (
        "step_too_small",
        "at t = {t:.9g} s no step above rounding meets the local tolerance {tolerance:g}",
        "request less accuracy; if that does not help, the model is discontinuous or singular there: look at the last states",
    ),
    NOT_FINITE: (
        "not_finite",
        "at t = {t:.9g} s the equations give infinite or undefined values for every step",
        "look at the last states: a parameter far out of proportion, or a configuration where the mechanism is singular",
    ),
    CONSTRAINT_LOST: (
        "constraint_lost",
        "at t = {t:.9g} s no step leads to a position in which the loops are closed",
        "the mechanism locks or cannot follow a drive: check lengths and drives at the last states",
    ),
    OUTSIDE_LAW_RANGE: (
        "outside_law_range",
        "at t = {t:.9g} s a contact law was left where it is not defined: {where}",
        "choose a law (for boxes, a rounding radius) that is defined at this depth, or check load and stiffness",
    ),
    FRICTION_LOCKS: (
        "friction_locks",
        "at t = {t:.9g} s friction locks {where}: it increases the reaction on which it depends; no motion without impact exists, or several",
        "take less friction, a longer guide or a smaller arm; or replace the joint by contacts, which have a stiffness",
    ),
    EVENT_LIMIT: (
        "event_limit",
        "more than {max_events:,} contacts and events of effects by t = {t:.9g} s",
        "raise max_events; request more accuracy if contacts chatter; add hysteresis to a relay that chatters",
    ),
    TOO_MANY_STEPS: (
        "too_many_steps",
        "the run at tolerance {tolerance:.2g} ended at t = {t:.9g} s: {steps:,} steps accepted, {rejected:,} rejected, {whose} = {max_steps:,.0f}",
        "raise or omit max_steps, request less accuracy, or simulate a shorter time",
    ),
    INTERRUPTED: (
        "interrupted",
        "stopped by the user at t = {t:.9g} s",
        "the solution contains everything computed until then",
    ),
    WALL_TIME_LIMIT: (
        "wall_time_limit",
        "wall_time = {wall_time:g} s elapsed when the run at tolerance {tolerance:.2g} was at t = {t:.9g} s",
        "raise wall_time, request less accuracy, or simulate a shorter time",
    ),
    STALLED: (
        "stalled",
        "the run at tolerance {tolerance:.2g} makes hardly any progress at t = {t:.9g} s, after {steps:,} accepted and {rejected:,} rejected steps",
        "change the tolerance; add hysteresis to a relay that chatters; with a stated max_steps the run continues",
    ),
    EXCEPTION: (
        "exception",
        "after t = {t:.9g} s there was {error}",
        "the solution contains everything computed until then; remove the cause or, if memory ran out, keep a grid of states",
    ),
}


def unreachable(
    requested: float,
    floor: float,
    method: str,
    tighter: Outcome | None = None,
    *,
    when: float,
    rounded: bool = False,
    foreseen: bool = False,
    end: float | None = None,
) -> Outcome:
    """Return the outcome of a complete run whose requested error no tolerance meets.

    tighter: outcome of a run with a smaller tolerance; rounded: rounding dominates the errors; when: time of the largest [s]
    foreseen: the floor is expected of a tolerance that was not tried
    end: the error at the end, where that of the whole run was requested.
    """
    better = _method_for_accuracy(method)
    gives = "is expected to give" if foreseen else "that was tried gives"
    rounding = f"errors no longer decrease, because rounding dominates, most at t = {when:.4g} s"
    many = f"errors are proportional to the tolerance, and below {brief(LEAST)} rounding dominates"
    by, why = (f" of {method}", "") if better else ("", f": {many if foreseen else rounding}")
    if tighter is not None:
        first = f"{rounding}; " if rounded else ""
        why = f": {first}runs with a smaller tolerance end as {tighter.name}, {tighter.message}"
    alone = (
        f', or "{brief(requested, 3)} at the end", which this run meets' if end is not None and end <= requested else ""
    )
    return Outcome(
        "accuracy_unreachable",
        f"no tolerance{by} {gives} an error below {brief(floor, 2)}{' at the end' if end is None else ''}, {brief(requested, 3)} was requested{why}",
        _first(better, f"request an accuracy above {brief(floor, 2)}{alone}, or simulate a shorter time"),
    )


def unknown(requested: float, tighter: Outcome) -> Outcome:
    """Return the outcome of a complete run whose error is unknown because no other run reaches the end."""
    return Outcome(
        "accuracy_unknown",
        f"the run is complete, but whether its error is below {brief(requested, 3)} is not known: the runs to compare it with end as {tighter.name}, "
        f"{tighter.message}",
        "take another method, or request less accuracy; tolerance= in place of accuracy= makes one run without an estimate",
    )


def too_long(requested: float, error: ErrorEstimate, tolerance: float) -> Outcome:
    """Return the outcome of a complete run, at a tolerance, that is longer than its horizon of prediction."""
    known = reach(error, tolerance, requested)
    return Outcome(
        "beyond_horizon",
        f"an error of {brief(requested, 3)}{' at the end' if error.at_end else ''} is out of reach: {beyond_horizon(error)}",
        f"simulate {known:.4g} s, for which a smaller tolerance is expected to reach this accuracy, or somewhat longer; for statistics use this run, "
        "or tolerance= in place of accuracy=",
    )


def not_closed(unclosed: float, requested: float, tolerance: float, steps: int) -> Outcome | None:
    """Return the outcome of a complete run whose energy balance exceeds its accuracy; None if it closes."""
    most = max(CLOSES * requested, (CLOSES + steps) * tolerance)
    if unclosed <= most:
        return None
    return Outcome(
        "energy_not_closed",
        f"energy + dissipated - input changes by {unclosed:.2g} of the energy that moves, its accuracy allows {most:.2g}",
        "find the law or force whose energy is not that of its force: `hertzwerk audit` on the scene or file of laws, then `hertzwerk effects`",
    )


def outcome(status: int, method: str, history: History, *, error: Exception | None = None, **facts: object) -> Outcome:
    """Return the outcome of a status of the engine, after the last of the kept rows."""
    name, message, remedy = _OUTCOMES[status]
    better = _method_for_steps(method, history) if status in STEPS else ""
    if status == STALLED and not better:
        better = f"take {' or '.join(other for other in IMPLICIT if other != method)}"
    raised = "" if error is None else _raised(error)
    return Outcome(name, message.format(**facts, error=raised), _first(better, remedy))


def said_of(status: int) -> str:
    """Return a status of the engine in words that hold of any run, with the remedy."""
    name, _, remedy = _OUTCOMES[status]
    return f"{name}: {remedy}"


def _raised(error: Exception) -> str:
    """Describe an exception and the line that raised it."""
    (*_, last) = traceback.extract_tb(error.__traceback__)
    return (
        f"{type(error).__name__} in {last.name} ({Path(last.filename).name}, line {last.lineno}): {error}".removesuffix(
            ": "
        )
    )


def _first(better: str, remedy: str) -> str:
    return f"{better}; else {remedy}" if better else remedy
