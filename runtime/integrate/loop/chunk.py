"""Many attempts in one call, and the loop over such calls."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import casadi as ca
import numpy as np

from hertzwerk.runtime.host.interrupt import defer_interrupts
from hertzwerk.runtime.integrate.loop.attempt import Integrator
from hertzwerk.runtime.integrate.loop.choose import PATIENCE
from hertzwerk.runtime.integrate.step.layout import CALM, RUNNING, SUSPECT, TOO_MANY_STEPS
from hertzwerk.runtime.model.caller import Caller, Callers

ROOM = 1.05  # of a step: if less is left to the end, the step may have been cut to end there
SIZE = (16, 16)  # attempts per call, nested: calls of a function, attempts in it
# statuses that only the loop can give
INTERRUPTED, WALL_TIME_LIMIT, EXCEPTION = TOO_MANY_STEPS + 1, TOO_MANY_STEPS + 2, TOO_MANY_STEPS + 3


def chunk(integrator: Integrator, sizes: tuple[int, ...] = SIZE) -> Any:
    """Build the function (state, controls) -> states (ns, attempts), one column after each attempt.

    As CasADi's mapaccum, but without a copy of the constant controls for each attempt.
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
    """Last state of a run that is independent of its end time, from which a longer run continues.

    with_choice: continue with steps that choose between methods.
    """

    state: np.ndarray
    with_choice: bool


@dataclass(frozen=True)
class Ending:
    """End of the loop: last state (accepted or not), status, time taken [s], state to resume from, error.

    resume    None where that is not known
    error     exception that ended the loop
    """

    last: np.ndarray
    status: int
    wall_s: float
    resume: Resume | None = None
    error: Exception | None = None


class CallerProvider(Protocol):
    """Provider of a run's callers, which it may change between two chunks.

    `automatic.AutomaticCallers` is one.
    """

    callers: Callers

    def begin(self) -> None:
        """Start a run: `callers` are those of its first steps."""

    def use_choice(self, poll: Callable[[], object]) -> None:
        """Change `callers` to those that choose between methods."""

    @property
    def may_switch(self) -> bool:
        """Return whether `switch_if_faster` may change them in a run."""

    def switch_if_faster(self, elapsed: float, ahead: float, poll: Callable[[], object]) -> bool:
        """Change `callers` if it pays; return whether it did.

        elapsed, ahead: time [s] that attempts took and are about to take. Long operations call `poll` now and then.
        """


def march(
    provider: CallerProvider,
    integrator: Integrator,
    state: np.ndarray,
    controls: np.ndarray,
    keep: Callable[[np.ndarray], object],
    *,
    wall_time: float = np.inf,
    progress: Callable[[float], object] | None = None,
    with_choice: bool = False,
) -> Ending:
    """Call a chunk until the run is over; an exception ends it with the states so far.

    The interrupt is raised between two calls or by `progress`.

    keep    receives the states after the attempts in order, some at a time: rows (n, ns) that are overwritten after it returned,
            those that count are `accepted`
    with_choice   begin with steps that choose between methods
    """
    provider.begin()
    layout = integrator.layouts.state
    t, h, status, accepted = (layout[name].start for name in ("t", "h", "status", "accepted"))
    pressure = layout["pressure"].start
    t_end = float(controls[integrator.layouts.controls["t_end"].start])
    t_start = float(state[t])
    max_steps, steps = float(controls[integrator.layouts.controls["max_steps"].start]), layout["steps"].start
    rejected, retaken = (layout[name].start for name in ("rejected", "retaken"))
    most_in_vain = max_steps - state[steps] + state[rejected] + state[retaken]  # as many as steps may be accepted
    error: Exception | None = None
    callers, call = _called(provider, controls)
    may_switch = provider.may_switch
    start, done, resume = time.perf_counter(), 0.0, Resume(state, with_choice)
    spent = 0.0  # s of the processor on attempts alone: neither what else it does nor what is built tells the pace
    free = True  # of where the run is to end
    outcome = int(state[status])

    def poll() -> None:
        interrupts()
        if progress is not None:
            progress(done)

    try:
        with defer_interrupts() as interrupts:
            first = state[None].copy()
            first[0, accepted] = 1.0
            keep(first)
            if with_choice:
                provider.use_choice(poll)
                callers.give_back(call)
                callers, call = _called(provider, controls)
            while outcome == RUNNING:
                call.inputs[0][:] = state
                began = time.thread_time() if may_switch else 0.0
                (part,) = call()
                spent += time.thread_time() - began if may_switch else 0.0
                outcome, chooses = int(part[-1, status]), with_choice
                if outcome != RUNNING:  # attempts after the end repeat it
                    part = part[: np.flatnonzero(part[:, status] != RUNNING)[0] + 1]
                if outcome in (SUSPECT, CALM):
                    chooses = outcome == SUSPECT
                    outcome = part[-1, status] = RUNNING
                    # the next step that is stiff indeed decides
                    part[-1, pressure] = PATIENCE - 1 if chooses else 0.0
                state = part[-1].copy()
                if free and outcome == RUNNING and ROOM * part[:, h].max() < t_end - part[-1, t]:
                    resume = Resume(state, chooses)
                elif free:
                    bound = (part[:, status] != RUNNING) | (ROOM * part[:, h] >= t_end - part[:, t])
                    free = not bound.any()
                    last = len(part) if free else int(bound.argmax())
                    if last:
                        resume = Resume(part[last - 1].copy(), chooses if free else with_choice)
                keep(part)
                elapsed = time.perf_counter() - start
                if outcome == RUNNING and state[rejected] + state[retaken] > most_in_vain:
                    outcome = TOO_MANY_STEPS
                if outcome == RUNNING and elapsed > wall_time:
                    outcome = WALL_TIME_LIMIT
                done = (float(state[t]) - t_start) / (t_end - t_start)
                poll()
                turned, with_choice = chooses != with_choice, chooses
                if turned and chooses:
                    provider.use_choice(poll)
                elif turned:
                    provider.begin()
                changed = False
                if outcome == RUNNING and may_switch:
                    pace = max(done, float(state[steps]) / max_steps, 1e-9)
                    ahead = min(spent / pace - spent, wall_time - elapsed)
                    changed = provider.switch_if_faster(spent, ahead, poll)
                if turned or changed:
                    callers.give_back(call)
                    callers, call = _called(provider, controls)
    except KeyboardInterrupt:
        outcome = INTERRUPTED
    except Exception as raised:
        outcome, error = EXCEPTION, raised
    callers.give_back(call)
    return Ending(state, outcome, time.perf_counter() - start, resume, error)


def _called(provider: CallerProvider, controls: np.ndarray) -> tuple[Callers, Caller]:
    """Return the callers of a run, and a call with the controls of the run set."""
    callers = provider.callers
    call = callers.take()
    call.inputs[1][:] = controls
    return callers, call
