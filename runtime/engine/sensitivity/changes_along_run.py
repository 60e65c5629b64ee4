"""Changes followed along a run, from its start through steps and events."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from hertzwerk.runtime.engine.integration.loop.automatic_compilation import use_compiled
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.sensitivity.saltation import (
    Jumps,
    events_of,
    switched,
    tables_of_events,
    watched,
    watched_columns,
)
from hertzwerk.runtime.engine.sensitivity.step_chain import NOISE, along, chained
from hertzwerk.runtime.engine.sensitivity.tangent import Directions, tangent
from hertzwerk.runtime.engine.sensitivity.transitions import transitions
from hertzwerk.runtime.engine.solution.history import History

Renew = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""Takes rows (l,) and the changes (l, P, n) at them; returns those (P, n) to go on with from the last."""


@dataclass(frozen=True)
class Followed:
    """Changes of states y, memory m and a shift of time, P columns, at the rows of a run.

    after (rows, n, P)      at a fixed time since the last event (`step_chain`); nan beyond `until`
    slopes (rows, ny)       dy/dt there
    apart (rows - 1,)       whether a step was solved apart
    switched (rows,)        whether a row follows an event
    jumps, at_rows (rows,)  the events, and the one that each row follows, or -1
    times (j, P)            of the events [s], nan where sliding in two directions ends
    then (j, size, P)       of what is `watched`, at the events; both nan beyond `until`
    determined              number of events before `until`
    until, reason           time [s] up to which there are derivatives, and why not to the end of the run, else empty
    """

    after: np.ndarray
    slopes: np.ndarray
    apart: np.ndarray
    switched: np.ndarray
    jumps: Jumps
    at_rows: np.ndarray
    times: np.ndarray
    then: np.ndarray
    determined: int
    until: float
    reason: str


def at_fixed_time(changes: np.ndarray, slopes: np.ndarray) -> np.ndarray:
    """Return the changes (j, ny + nm, P) at a fixed time of the run, where dy/dt is `slopes` (j, ny)."""
    fixed = changes[:, :-1].copy()
    fixed[:, : slopes.shape[1]] -= slopes[:, :, None] * changes[:, -1:]
    return fixed


def follow(
    history: History,
    directions: Directions,
    begin: np.ndarray,
    stated: frozenset[str],
    *,
    compiled: bool,
    renew: Renew | None = None,
    most: int | None = None,
) -> Followed:
    """Follow changes from row to row, through steps and events.

    begin (nq + nu or ny, P)    changes of the start; given: names of the memory that it was given
    renew                 takes the changes at rows, and returns those to go on with, after at most so many links
    """
    rows, sizes = len(history.rows), history.engine.layouts.state.sizes
    ny, floor = sizes["y"], _floor_changes(history, directions)
    first = np.zeros((ny + history.model.nm + 1, directions.count))
    first[: len(begin)] = begin
    _latch(history, directions, floor, first[:ny], first[ny:-1], stated)
    after_event = switched(history)
    if compiled and after_event[1:].any():
        use_compiled(tables_of_events(history, directions.count))
    jumps = events_of(history, after_event, directions)
    at_rows = np.full(rows, -1)
    at_rows[jumps.rows], maps = np.arange(len(jumps.rows)), jumps.maps(floor)
    slopes = history.part("dy").copy()
    slopes[jumps.rows] = jumps.slopes[1]
    h = np.diff(history.t)
    over = partial(transitions, history, switched=after_event, directions=directions)
    changes = chained(
        history,
        first,
        maps,
        jumps.rows,
        lambda index: over(index, h[index]),
        directions,
        switched=after_event,
        compiled=compiled,
        renew=partial(_renewed, renew, slopes) if renew else None,
        most=most,
    )
    length, speed, *_ = history.controls[history.engine.layouts.controls["scales"]]
    determined, reason = jumps.first_without(changes.before, NOISE * length / speed / directions.sizes)
    last = jumps.rows[determined] if reason else rows
    lost = np.flatnonzero(~np.isfinite(changes.after[:last]).all(axis=(1, 2)))
    if len(lost):
        last = int(lost[0])
        determined = int(np.searchsorted(jumps.rows, last))
        reason = f"the equations have no finite derivatives in the step before {history.t[last]:.6g} s"
    changes.after[last:] = np.nan
    times, then = along(jumps.time[:, None], changes.before)[:, 0], along(jumps.then, changes.before)
    times[determined:], then[determined:] = np.nan, np.nan
    times[jumps.stops] = np.nan  # the direction of what stops in two is rounding at that instant, and so is its change
    until = float(history.t[last] if reason else history.t[-1])
    return Followed(
        changes.after, slopes, changes.apart, after_event, jumps, at_rows, times, then, determined, until, reason
    )


def _renewed(renew: Renew, slopes: np.ndarray, index: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return what renews changes (l, P, n) at rows, as changes at a fixed time of the run."""
    fixed = at_fixed_time(x.swapaxes(1, 2), slopes[index]).swapaxes(1, 2)
    return np.pad(renew(index, fixed), ((0, 0), (0, 1)))


def _floor_changes(history: History, directions: Directions) -> np.ndarray:
    """Return the changes (P,) of the least approach speed."""
    parameters = list(history.model.parameters)
    if "approach_floor" not in parameters:
        return np.zeros(directions.count)
    changes: np.ndarray = directions.dp[parameters.index("approach_floor")]
    return changes


def _latch(
    history: History,
    directions: Directions,
    floor: np.ndarray,
    state: np.ndarray,
    memory: np.ndarray,
    stated: frozenset[str],
) -> None:
    """Set the changes of the approach speeds of pairs that touch at the start."""
    places = watched_columns(history.model)["gap_rate"]
    change = tangent(watched, history, history.rows[:1], directions).along(state, memory)[0, places]
    least = history.controls[history.engine.layouts.controls["floor"]][0]
    mode, rates = history.part("mode")[0], history.part("gap_rate")[0]
    for row, (name, _, pair) in enumerate(history.model.module.LATCHES):
        if mode[pair] == CONTACT and name not in stated:
            memory[row] = -change[pair] if -rates[pair] > least else floor
