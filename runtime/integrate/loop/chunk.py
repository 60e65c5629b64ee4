"""Many attempts in one call, and the loop over such calls."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import casadi as ca
import numpy as np

from hertzwerk.runtime.host.interrupt import deferred
from hertzwerk.runtime.integrate.loop.attempt import Integrator
from hertzwerk.runtime.integrate.loop.choose import PATIENCE
from hertzwerk.runtime.integrate.step.layout import RUNNING, SUSPECT, TOO_MANY_STEPS
from hertzwerk.runtime.model.caller import Caller, Callers

ROOM = 1.05  # of a step: with less to the end than that it may have been cut to end there
SIZE = (16, 16)  # attempts per call: so many calls of a function that makes so many attempts
INTERRUPTED, WALL_TIME_LIMIT = TOO_MANY_STEPS + 1, TOO_MANY_STEPS + 2  # statuses that only the loop can give


def chunk(integrator: Integrator, sizes: tuple[int, ...] = SIZE) -> Any:
    """CasADi function (state, controls) -> states (ns, attempts), one column after each attempt.

    What mapaccum makes, but for the copies of the constant controls that it takes one of for each attempt.
    """
    many = integrator.attempt
    for i, size in enumerate(sizes):
        first = state = ca.MX.sym("state", integrator.layouts.state.size)
        controls = ca.MX.sym("controls", integrator.layouts.controls.size)
        states = []
        for _ in range(size):
            states.append(many.call([state, controls], i == 0, False)[0])  # an attempt is written out: a call costs
            state = states[-1][:, -1]
        name = "chunk" if i + 1 == len(sizes) else f"attempts_{i}"
        many = ca.Function(name, [first, controls], [ca.horzcat(*states)], ["state", "controls"], ["states"])
    return many


@dataclass(frozen=True)
class Resume:
    """The last state of a run that does not depend on where it was to end: a longer one goes on from it; whole: with what chooses between methods."""

    state: np.ndarray
    whole: bool


@dataclass(frozen=True)
class Ending:
    """The last state of all, accepted or not, how the loop ended, the time it took [s], and what goes on from it; None where that is not known."""

    last: np.ndarray
    status: int
    wall_s: float
    resume: Resume | None = None


class Shift(Protocol):
    """Chooses what a run is called with, and may change it between two chunks (`automatic.Gear`)."""

    callers: Callers

    def begin(self) -> None:
        """A run begins: `callers` are those of its first steps."""

    def whole(self, heed: Callable[[], object]) -> None:
        """`callers` are those that choose between methods from now on."""

    def changed(self, elapsed: float, ahead: float, heed: Callable[[], object]) -> bool:
        """Whether `callers` are others from now on, after `elapsed` with about `ahead` [s] to go; what takes long calls `heed` now and then."""


def march(
    gear: Shift,
    integrator: Integrator,
    state: np.ndarray,
    controls: np.ndarray,
    keep: Callable[[np.ndarray], object],
    *,
    wall_time: float = np.inf,
    progress: Callable[[float], object] | None = None,
    whole: bool = False,
) -> Ending:
    """Call a chunk until the run is over; KeyboardInterrupt, raised between two calls or by `progress`, ends it with what there is.

    keep    is given the accepted states in order, some at a time: rows (n, ns) of its own
    whole   begin with what chooses between methods
    """
    gear.begin()
    layout = integrator.layouts.state
    t, h, status, accepted = (layout[name].start for name in ("t", "h", "status", "accepted"))
    pressure = layout["pressure"].start
    t_end = float(controls[integrator.layouts.controls["t_end"].start])
    t_start = float(state[t])
    max_steps, steps = float(controls[integrator.layouts.controls["max_steps"].start]), layout["steps"].start
    callers, call = _called(gear, controls)
    start, done, resume = time.perf_counter(), 0.0, Resume(state, whole)
    free = True  # of where the run is to end
    outcome = int(state[status])

    def heed() -> None:
        interrupts()
        if progress is not None:
            progress(done)

    try:
        with deferred() as interrupts:
            keep(state[None, :].copy())
            if whole:
                gear.whole(heed)
                callers.give_back(call)
                callers, call = _called(gear, controls)
            while outcome == RUNNING:
                call.inputs[0][:] = state
                (states,) = call()
                ended = np.flatnonzero(states[:, status] != RUNNING)
                part = states[: ended[0] + 1] if ended.size else states
                outcome = int(part[-1, status])
                suspect = outcome == SUSPECT
                if suspect:
                    outcome = part[-1, status] = RUNNING
                    part[-1, pressure] = PATIENCE - 1  # the next step that is stiff indeed decides
                state = part[-1].copy()
                if free:
                    bound = (part[:, status] != RUNNING) | (ROOM * part[:, h] >= t_end - part[:, t])
                    free = not bound.any()
                    last = len(part) if free else int(bound.argmax())
                    if last:
                        resume = Resume(part[last - 1].copy(), whole or (suspect and free))
                keep(part[part[:, accepted] == 1])
                elapsed = time.perf_counter() - start
                if outcome == RUNNING and elapsed > wall_time:
                    outcome = WALL_TIME_LIMIT
                done = (float(state[t]) - t_start) / (t_end - t_start)
                heed()
                pace = max(done, float(state[steps]) / max_steps, 1e-9)
                if suspect:
                    whole = True
                    gear.whole(heed)
                changed = outcome == RUNNING and gear.changed(elapsed, min(elapsed / pace, wall_time) - elapsed, heed)
                if suspect or changed:
                    callers.give_back(call)
                    callers, call = _called(gear, controls)
    except KeyboardInterrupt:
        outcome = INTERRUPTED
    callers.give_back(call)
    return Ending(state, outcome, time.perf_counter() - start, resume)


def _called(gear: Shift, controls: np.ndarray) -> tuple[Callers, Caller]:
    """What a run is called with, and a call of it with the numbers of the run."""
    callers = gear.callers
    call = callers.take()
    call.inputs[1][:] = controls
    return callers, call
