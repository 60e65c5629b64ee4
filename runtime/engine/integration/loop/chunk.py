"""Many attempts in one call, and the loop over such calls."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.loop.attempt import Integrator
from hertzwerk.runtime.engine.integration.loop.input_pieces import Pieces
from hertzwerk.runtime.engine.integration.loop.method_choice import EXPLICIT, IMPLICIT, PATIENCE
from hertzwerk.runtime.engine.integration.loop.near_list import Departures, renewed
from hertzwerk.runtime.engine.integration.loop.reduced_rows import Rows, first_of
from hertzwerk.runtime.engine.integration.loop.tally import tally
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import NearModel
from hertzwerk.runtime.engine.integration.step.layout import CALM, FINISHED, RUNNING, STALE, SUSPECT, TOO_MANY_STEPS
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.engine.model.caller import Caller, Callers
from hertzwerk.runtime.engine.model.signal import Schedule
from hertzwerk.runtime.system.interrupt import defer_interrupts, polled

ROOM = 1.05  # of a step: if less is left to the end, the step may have been cut to end there
SIZE = (16, 16)  # attempts per call, nested: calls of a function, attempts in it
# statuses that only the loop can give
INTERRUPTED, WALL_TIME_LIMIT, EXCEPTION, STALLED = range(TOO_MANY_STEPS + 1, TOO_MANY_STEPS + 5)
# A stall: so many attempts get ahead by less than this part of the time in which the scene's speed covers its length, or of the duration.
STALL, HARDLY = 1_000_000, 0.1
# Explicit steps fail where so many chunks in a row have more than this part of their attempts rejected and get ahead by less than this part
# of the duration. Half of the attempts are rejected in geneva_drive too, as contacts follow each other, but it gets ahead by a tenth.
FAILED, FAILING, STANDING = 2.0, 0.4, 1e-5
COMPILER_PART = (
    0.25  # of the processor's time left to a limit: a compiler takes up to twice what is estimated, and is to pay
)


class TimeOverError(Exception):
    """The time that a call may take is over."""


def keep_to(deadline: float, before: float = math.inf) -> float:
    """Return the time [s] of `time.perf_counter`.

    Raises TimeOverError where it is beyond the deadline, or as much time as since `before` leads beyond that.
    """
    now = time.perf_counter()
    if now > deadline or 2 * now - before > deadline:
        raise TimeOverError
    return now


def chunk(integrator: Integrator, sizes: tuple[int, ...] = SIZE, *, called: str = "chunk") -> Any:
    """Build the function (state, controls, tally) -> states (ns, attempts), tally after all of them.

    A column after each attempt, as CasADi's mapaccum, but without a copy of the constant controls for each attempt.
    After the end of a run, or of a piece of its inputs, many are passed over at once. C has a loop of its `one` attempt (`c_files.looped`).
    """
    counting, layouts = tally(integrator.model), integrator.layouts
    status = layouts.state.places["status"]
    lengths = {"state": layouts.state.size, "controls": layouts.controls.size, "tally": counting.layout.size}
    arguments = state, controls, counted = [ca.MX.sym(name, length) for name, length in lengths.items()]
    after = integrator.attempt.call([state, controls], True, False)[0]  # it is written out: a call costs
    names = [*lengths], ["states", "counted"]
    one: Any = ca.Function(called, arguments, [after, counting.add(counted, after, controls)], *names)
    many = one
    for i, size in enumerate(sizes):
        (state, _, counted), states = arguments, []
        for _ in range(size):
            inputs = [state, controls, counted]
            rows, counted = many.call([*([state[status] == RUNNING] if i else []), *inputs], i == 0, False)
            states.append(rows)
            state = rows[:, -1]
        name = called if i + 1 == len(sizes) else f"attempts_{i}"
        many = ca.Function(name, arguments, [ca.horzcat(*states), counted], *names)
        if i + 1 < len(sizes):
            state, _, counted = arguments
            over = ca.Function("over", arguments, [ca.repmat(state, 1, many.size2_out(0)), counted])
            many = ca.Function.if_else("unless_over", many, over)
    many.one, many.status = one, status
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
    """End of the loop: last state (accepted or not), tally, status, and time taken [s].

    resume     state to resume from, None where that is not known
    error      exception that ended the loop
    """

    last: np.ndarray
    tally: np.ndarray
    status: int
    wall_s: float
    resume: Resume | None = None
    error: Exception | None = None


class CallerProvider(Protocol):
    """Provider of a run's callers, which it may change between two chunks.

    `automatic_compilation.AutomaticCallers` is one.
    """

    callers: Callers
    watches: bool  # whether `enter` may change callers after each chunk, not after one that ends STALE alone
    build_s: float  # s that it took to build what chooses between methods

    def begin(self) -> None:
        """Start a run: `callers` are those of its first steps."""

    def enter(self, state: np.ndarray, controls: np.ndarray, poll: Callable[[], object], *, first: bool) -> np.ndarray:
        """Return the state to go on with.

        `callers` may change, and what states have to keep to, among the controls.
        """

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
    keep: Callable[[Rows], object],
    *,
    deadline: float = np.inf,
    progress: Callable[[float], object] | None = None,
    with_choice: bool = False,
    schedule: Schedule | None = None,
    departures: Departures | None = None,
) -> Ending:
    """Call a chunk until the run is over; an exception ends it with the states so far.

    The interrupt is raised between two calls or by `progress`.

    keep    receives the states after the attempts in order, some at a time: rows (n, ns) that are overwritten after it returned,
            those that count are `accepted`
    deadline   of `time.perf_counter` [s]: before which it ends, if another call takes as long as the last, but after one at least; what
               is built or compiled is stopped
    with_choice   begin with steps that choose between methods
    schedule   of the inputs: where a piece ends a step does, and a row before it and one after it are kept
    departures   receives what pairs had that left a list of near ones
    """
    pieces = None if schedule is None else Pieces(integrator, schedule, controls)
    run = _March(provider, integrator, Resume(state, with_choice), controls, pieces, departures)
    error: Exception | None = None
    before = math.inf

    def poll() -> None:
        nonlocal before
        interrupts()
        if run.status == RUNNING:
            before = keep_to(deadline, before)
        if progress is not None:
            progress(run.done)

    try:
        with defer_interrupts() as interrupts:
            keep(run.first(poll))
            run.change_method(with_choice, poll)
            while run.status == RUNNING:
                states, with_choice = run.attempts()
                run.note_resume(states, with_choice)
                keep(states)
                run.stop_at_limits()
                poll()
                run.change_method(with_choice, poll)
                run.compile_if_faster(deadline, poll)
    except KeyboardInterrupt:
        run.status = INTERRUPTED
    except TimeOverError:
        run.status = WALL_TIME_LIMIT
    except Exception as raised:
        run.status, error = EXCEPTION, raised
    return run.end(error)


class _March:
    """A run in progress: its last state and tally, its status, the state to resume from, and its pace."""

    def __init__(
        self,
        provider: CallerProvider,
        integrator: Integrator,
        start: Resume,
        controls: np.ndarray,
        pieces: Pieces | None,
        departures: Departures | None = None,
    ) -> None:
        if pieces is not None:
            start = Resume(pieces.with_pieces(start.state), start.with_choice)
        state, layouts, self._pieces = start.state, integrator.layouts, pieces
        self._provider, self._controls, self._at = provider, controls, layouts.state.places
        self._t_end, self._max_steps = (controls[layouts.controls.places[name]] for name in ("t_end", "max_steps"))
        self._t_start, self._most_rejected = state[self._at["t"]], self._max_steps - state[self._at["steps"]]
        self._most_rejected += self._rejected(state)  # as many as steps may be accepted
        length, speed = controls[layouts.controls["scales"]][:2]
        self._least = HARDLY * min(length / speed, self._t_end - self._t_start)  # s
        first, *others = integrator.tables
        self._automatic, self._failing = bool(others) and isinstance(first, RungeKutta), 0
        self.status, self._state, self._resume = int(state[self._at["status"]]), state, start
        self._stall = self._tried, self._t_start  # attempts and time from which progress is watched
        (self._tally,) = tally(integrator.model).first(state, controls)
        self._free = True  # of where the run is to end
        self._with_choice = False
        self._near: NearModel | None = integrator.model if isinstance(integrator.model, NearModel) else None
        self._departures: Departures = {} if departures is None else departures
        self._began = time.perf_counter()
        # s of the processor on attempts alone, and on the clock: neither what else it does nor what is built tells the pace
        self._spent = self._clocked = 0.0
        provider.begin()
        self._callers: Callers | None = None
        self._call: Caller

    @property
    def done(self) -> float:
        """Fraction of the run that is done."""
        return float((self._state[self._at["t"]] - self._t_start) / (self._t_end - self._t_start))

    def first(self, poll: Callable[[], object]) -> np.ndarray:
        """Return the first state as one that was accepted, shape (1, ns)."""
        self._poll = poll
        self._state = self._provider.enter(self._state, self._controls, poll, first=True)
        self._change_callers()
        first = self._state[None].copy()
        first[0, self._at["accepted"]] = 1.0
        return first

    def attempts(self) -> tuple[Rows, bool]:
        """Make attempts; return the states up to the end of the run, and whether to choose methods then.

        Where a piece of an input ends they end as well, with the state that goes on with the next one.
        """
        status, timed = self._at["status"], self._provider.may_switch
        self._call.inputs[0][:], self._call.inputs[2][:] = self._state, self._tally
        began, clock = (time.thread_time(), time.perf_counter()) if timed else (0.0, 0.0)
        states: Rows
        states, (tallied,) = self._call()
        if timed:
            self._spent += time.thread_time() - began
            self._clocked += time.perf_counter() - clock
        self.status, chooses = int(states[-1, status]), self._with_choice
        if self.status != RUNNING:  # attempts after the end repeat it
            states = first_of(states, 1 + int((states[:, status] != RUNNING).argmax()))
        if self.status in (SUSPECT, CALM):
            chooses = self.status == SUSPECT
            self.status = states[-1, status] = RUNNING
            # the next step that is stiff indeed decides
            states[-1, self._at["pressure"]] = PATIENCE - 1 if chooses else 0.0
        stale = self.status == STALE
        if stale:
            self.status = states[-1, status] = RUNNING
        if self._pieces is not None and self.status == FINISHED and self._pieces.ended(states[-1]):
            states[-1, status] = RUNNING
            states = np.vstack([states, self._pieces.with_pieces(states[-1])])
            self.status = int(states[-1, status])
        if self.status == RUNNING and self._automatic and self._fails(states):
            for name, value in (("method", IMPLICIT), ("pressure", PATIENCE), ("stiffness", 0.0)):
                states[-1, self._at[name]] = value
            chooses = True
        self._state, self._tally = states[-1].copy(), tallied.copy()
        if stale and self._near is not None:
            self._state = renewed(self._near, self._state, self._controls, self._departures)
        elif stale or (self._provider.watches and self.status == RUNNING):
            self._state = self._provider.enter(self._state, self._controls, self._poll, first=False)
            self._change_callers()
        return states, chooses

    def _fails(self, states: Rows) -> bool:
        """Return whether explicit steps fail: chunk after chunk many are rejected and time stands still.

        Where stability limits a contact's step, or it rests within the tolerance of its gap, a step too long ends in events that the motion does not
        have; each is retaken up to there. Such steps are no plain ones, and too short for signs of stiffness.
        """
        last, t = states[-1], self._at["t"]
        rejected = self._rejected(last) - self._rejected(self._state) > FAILING * len(states)
        stands = last[t] - self._state[t] < STANDING * (self._t_end - self._t_start)
        fails = rejected and stands and last[self._at["method"]] == EXPLICIT
        self._failing = self._failing + 1 if fails else 0
        return bool(self._failing >= FAILED * (1 + last[self._at["wary"]]))

    def note_resume(self, states: Rows, chooses: bool) -> None:
        """Note the last of the next states that is independent of where the run is to end."""
        if not self._free:
            return
        h = states[:, self._at["h"]]
        if self.status == RUNNING and ROOM * np.maximum.reduce(h) < self._t_end - self._state[self._at["t"]]:
            self._resume = Resume(self._state, chooses)
            return
        bound = ROOM * h >= self._t_end - states[:, self._at["t"]]
        if self.status != RUNNING:
            bound[-1] = True
        last = int(bound.argmax())
        self._free = not bound[last]
        last = len(states) if self._free else last
        if last:
            self._resume = Resume(states[last - 1].copy(), chooses if self._free else self._with_choice)

    def stop_at_limits(self) -> None:
        """End the run where its rejected attempts reach their limit or, without one, where it stalls."""
        if self.status != RUNNING:
            return
        if self._rejected(self._state) > self._most_rejected:
            self.status = TOO_MANY_STEPS
        (tried, before), t, now = self._stall, self._state[self._at["t"]], self._tried
        if self.status == RUNNING and now >= tried + STALL:
            self._stall = now, t
            if t - before < self._least and self._max_steps == np.inf:
                self.status = STALLED

    def change_method(self, chooses: bool, poll: Callable[[], object]) -> None:
        """Go on with steps that choose between methods, or with explicit ones alone."""
        turned, self._with_choice = chooses != self._with_choice, chooses
        if not turned:
            return
        if chooses:
            with polled(poll):
                self._provider.use_choice(poll)
        else:
            self._provider.begin()
        self._change_callers()

    def compile_if_faster(self, deadline: float, poll: Callable[[], object]) -> None:
        """Go on compiled, if that saves more time [s] than it takes, before the deadline as well."""
        if self.status != RUNNING or not self._provider.may_switch:
            return
        pace = max(self.done, self._state[self._at["steps"]] / self._max_steps, 1e-9)
        left = (deadline - time.perf_counter()) * min(
            self._spent / max(self._clocked, 1e-9), 1.0
        )  # others share the processor
        left -= self._provider.build_s  # to write a text takes about as long as to build what it is of
        ahead = min(self._spent / pace - self._spent, COMPILER_PART * left)
        if self._provider.switch_if_faster(self._spent, ahead, poll):
            self._change_callers()

    def end(self, error: Exception | None) -> Ending:
        """Return how the run ended."""
        self._give_back()
        vars(self).pop("_poll", None)  # which refers to the run: a cycle would wait for the collector
        wall_s = time.perf_counter() - self._began
        return Ending(self._state, self._tally, self.status, wall_s, self._resume, error)

    @property
    def _tried(self) -> float:
        """Number of attempts so far."""
        return float(self._state[self._at["steps"]]) + self._rejected(self._state)

    def _rejected(self, state: np.ndarray) -> float:
        """Return the number of attempts that were not accepted."""
        return float(state[self._at["rejected"]] + state[self._at["retaken"]])

    def _change_callers(self) -> None:
        """Call the provider's function from now on, with the controls of the run set."""
        self._give_back()
        self._callers = self._provider.callers
        self._call = self._callers.take()
        self._call.inputs[1][:] = self._controls

    def _give_back(self) -> None:
        if self._callers is not None:
            self._callers.give_back(self._call)
