"""One run at one tolerance: start the engine and pass its accepted steps to observers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from hertzwerk.runtime.engine.accuracy.error_estimate import LOOSEST, POINTS
from hertzwerk.runtime.engine.integration.loop.automatic_compilation import AutomaticCallers
from hertzwerk.runtime.engine.integration.loop.chunk import EXCEPTION, Ending, Resume, TimeOverError, keep_to
from hertzwerk.runtime.engine.integration.loop.near_list import Departures, constants_of, latches_of, scale_of
from hertzwerk.runtime.engine.integration.loop.reduced_rows import Rows
from hertzwerk.runtime.engine.integration.loop.tally import tally
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import NearModel
from hertzwerk.runtime.engine.integration.step.layout import NOT_FINITE, OUTSIDE_LAW_RANGE, STEP_TOO_SMALL
from hertzwerk.runtime.engine.integration.step.set_valued_friction import grips_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.built_engine import Engine, engine_for, provider_of
from hertzwerk.runtime.engine.run.energy_balance import Balance
from hertzwerk.runtime.engine.run.recorder import BLOCK, ENDS, Grid, Recorder, Sampled, Steps
from hertzwerk.runtime.engine.run.run_request import Limits, RunRequest, Settings
from hertzwerk.runtime.engine.solution import error_scales as scaling
from hertzwerk.runtime.engine.solution.error_scales import Scales
from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.engine.solution.outcome import FRICTION_LOCKS, Outcome, outcome
from hertzwerk.runtime.engine.solution.step_observers import EVERYTHING, Findings, Needs, Observer

APPROACH_FLOOR = 1e-3  # m/s, default for models with latches but without this parameter
LEAST_STEPS = 10  # least steps of a run in contact: at rest, steps grow until a short push would go unnoticed
CLOSE = 1e-3  # margin of a reaction that counts as none: nearer, its solution may not be found
ROUGH = LOOSEST  # tolerance of a run that only determines scales


@dataclass(frozen=True)
class Check:
    """Differences of a run that checks another.

    times    [s] at which the two are compared
    shorter    see `SingleRun.observe`
    """

    times: np.ndarray
    shorter: float


@dataclass(frozen=True)
class SingleRun:
    """A run but for its tolerance and scales."""

    model: EngineModel
    method: str
    engine: Engine
    request: RunRequest
    limits: Limits
    provider: AutomaticCallers | None
    start: Resume | None = None  # what it goes on from; None: the start of the motion
    needs: Needs = Needs.STEPS
    deadline: float = math.inf  # of `time.perf_counter` [s], of all its runs

    @property
    def begin(self) -> float:
        """Time [s] that the run begins at."""
        return (
            self.request.begin
            if self.start is None
            else float(self.start.state[self.engine.integrator.layouts.state["t"]][0])
        )

    def initial_count(self, counter: str) -> int:
        """Return the value of a counter at the start of the run."""
        return 0 if self.start is None else int(self.start.state[self.engine.counters[counter]])

    @property
    def floor(self) -> float:
        """Least approach speed [m/s] that is latched."""
        return self.request.bound["approach_floor"] if "approach_floor" in self.model.parameters else APPROACH_FLOOR

    def scales(self, tolerance: float | None) -> Scales:
        """Return the scene's scales, completed where they do not suffice by those of a rough run.

        The rough run is no tighter than `tolerance`.
        """
        stated = self.request.scales
        if stated.sound:
            return stated
        rough = max(tolerance or 0.0, ROUGH)  # of no run for an accuracy is the tolerance larger

        def run(scales: Scales, sizes: Observer) -> None:
            ending = self.observe(rough, scales, [sizes], BLOCK)
            if ending.error is not None:
                raise ending.error

        return scaling.of_run(self.model, stated, run)

    def trace(
        self,
        tolerance: float,
        scales: Scales,
        times: np.ndarray | None,
        *,
        progress: Callable[[float], object] | None = None,
        compared: bool = False,
        checks: Check | None = None,
    ) -> Trace:
        """Run and keep the states at some times [s], or every step, or the ends alone, with what is needed.

        compared: states are kept as well at which other runs are to be compared; checks: keep only those that such a run
        is compared at, and impacts.
        """
        needs, request = self.needs, self.request
        if checks is not None:
            times, needs = checks.times, Needs.IMPACTS if self.model.k else Needs.ENDS
        elif compared and self.model.k:
            needs |= Needs.IMPACTS
        if times is not None and Needs.STEPS in needs:
            needs = EVERYTHING
        record: Steps | Grid = Steps()
        if times is not None or Needs.STEPS not in needs:
            record = Grid(np.zeros(0) if times is None else times, compared=checks is not None)
        findings = Findings(
            self.model,
            self.method,
            needs=needs,
            duration=request.seconds,
            period=request.period,
            begin=self.begin,
        )
        later = isinstance(record, Steps)
        other = Sampled(self.begin, request.seconds, POINTS, later=later) if compared else record
        observers: list[Observer] = [record, findings]
        if other is not record:
            observers.append(other)
        block = None if later else BLOCK
        if other is record and needs is Needs.ENDS and times is None:
            block = ENDS
        before = (self.provider.compile_s, self.provider.build_s) if self.provider else (0.0, 0.0)
        ending = self.observe(tolerance, scales, observers, block, progress, 1.0 if checks is None else checks.shorter)
        compile_s, build_s = (self.provider.compile_s, self.provider.build_s) if self.provider else (0.0, 0.0)
        gained = ending.last if self.start is None else ending.last - self.start.state
        counted = {name: int(gained[row]) for name, row in self.engine.counters.items()}
        tallied = tally(self.model).layout.split(ending.tally)
        balance = None
        if self.model.has_ledger:
            error, moved, size = (float(tallied[name][0]) for name in ("error", "moved", "size"))
            balance = Balance(error, moved, size, float(scales.scene[3]), counted["steps"] + 1)
        return Trace(
            tolerance=tolerance,
            limits=self.limits,
            ending=ending,
            recorded=record,
            compared=other,
            findings=findings,
            counted=counted,
            tally=tallied,
            balance=balance,
            compiled=self.provider is not None and self.provider.compiled,
            compile_s=compile_s - before[0],
            build_s=build_s - before[1],
        )

    def outcome(self, trace: Trace) -> Outcome:
        """Return the outcome of a run."""
        limits, ends, counted, status = trace.limits, trace.recorded.ends, trace.counted, trace.ending.status
        left = status == OUTSIDE_LAW_RANGE
        locked = _locked(self.model, ends) if status in (OUTSIDE_LAW_RANGE, NOT_FINITE, STEP_TOO_SMALL) else ""
        return outcome(
            FRICTION_LOCKS if locked else status,
            self.method,
            trace.recorded.history,
            steps=counted["steps"],
            rejected=counted["rejected"] + counted["retaken"],
            error=trace.ending.error,
            t=float(ends.t[-1]),
            where=locked or (_deepest(self.model, ends) if left else ""),
            tolerance=trace.tolerance,
            **vars(limits),
        )

    def observe(
        self,
        tolerance: float,
        scales: Scales,
        observers: Sequence[Observer],
        block: int | None = BLOCK,
        progress: Callable[[float], object] | None = None,
        shorter: float = 1.0,
    ) -> Ending:
        """Run, passing the accepted steps to observers in blocks of so many bytes (see `Recorder`).

        block    None: all at once; ENDS: the first and the last state alone
        shorter  part of its length that the first step has, and the longest in contact
        """
        integrator = self.engine.integrator
        layout = integrator.layouts.controls
        controls = np.zeros(layout.size)
        numbers: dict[str, Any] = {
            "c": self.request.bound.c,
            "scale": scales.state,
            "scales": scales.scene,
            "speed_limits": self.request.speed_limits,
            "tolerance": tolerance,
            "t_end": self.request.seconds,
            "h_max": shorter * self.request.seconds / LEAST_STEPS,
            "floor": self.floor,
            "max_events": self.limits.max_events + self.initial_count("events"),
            "max_steps": self.limits.max_steps + self.initial_count("steps"),
        }
        near, departures = integrator.model, Departures()
        if isinstance(near, NearModel):
            numbers["c"] = constants_of(near, self.request.bound.c, self.request.begin, self.request.q)
            numbers["scale"] = scale_of(near, scales.state)
        layout.fill(controls, numbers)
        state = self._initial_state(controls) if self.start is None else self.start.state.copy()
        for name in ("h", "h_flight", "h_contact") if shorter != 1 else ():
            state[integrator.layouts.state[name]] *= shorter
        loop = self.engine.march if self.provider is None else partial(self.engine.march, self.provider, integrator)
        if self.start is not None:
            loop = partial(loop, with_choice=self.start.with_choice)
        if self.model.inputs:
            loop = partial(loop, schedule=self.model.schedule())
        if isinstance(near, NearModel):
            loop = partial(loop, departures=departures)
        p = self.request.bound.p
        accepted = integrator.layouts.state["accepted"].start

        def view(rows: Rows) -> History:
            return History(self.model, rows, controls, integrator, p=p, departures=departures)

        recorder = Recorder(view, observers, block or None)

        def keep(attempts: Rows) -> None:
            if block != ENDS:
                recorder.keep(attempts.compress(attempts[:, accepted] == 1, axis=0))

        ending: Ending = loop(state, controls, keep, deadline=self.deadline, progress=progress)
        if block == ENDS:
            recorder.keep(np.stack([state, ending.last]))
        with suppress(Exception):  # told by the recorder
            recorder.flush()
        if isinstance(near, NearModel):  # what pairs had summed that left the list is not in the state
            ending = replace(ending, resume=None)
        if recorder.error is None:
            return ending
        return replace(ending, status=EXCEPTION, error=ending.error or recorder.error, resume=None)

    def _initial_state(self, controls: np.ndarray) -> np.ndarray:
        """Return the state of the engine at the start of the motion."""
        request, latches, integrator = self.request, self.request.latches, self.engine.integrator
        if isinstance(integrator.model, NearModel):
            latches = latches_of(integrator.model, latches, controls[integrator.layouts.controls["c"]])
        (state,) = self.engine.begin(request.begin, request.q, request.u, latches, controls)
        return state


def set_up(
    model: EngineModel,
    settings: Settings,
    request: RunRequest,
    start: Resume | None = None,
    needs: Needs = Needs.STEPS,
    began: float = math.inf,
) -> SingleRun:
    """Return the requested run with its engine built.

    began: time of `time.perf_counter` [s] from which its wall time counts, which is over for a compiler as well.
    Raises InputError where C is requested and there is no compiler.
    """
    deadline, compiled = began + settings.limits.wall_time, settings.compiled
    independent = model.without_redundancy(request.dependent)
    try:
        engine = engine_for(independent, settings.method, compiled, partial(keep_to, deadline))
    except TimeOverError:
        compiled = False
        engine = engine_for(independent, settings.method, compiled)
    provider = provider_of(engine, independent, compiled)
    return SingleRun(model, settings.method, engine, request, settings.limits, provider, start, needs, deadline)


@dataclass(frozen=True)
class Trace:
    """Result of one run at one tolerance."""

    tolerance: float
    limits: Limits
    ending: Ending
    recorded: Steps | Grid
    compared: Steps | Grid | Sampled
    findings: Findings
    counted: Mapping[str, int]
    tally: Mapping[str, np.ndarray]  # by the names of its layout
    balance: Balance | None  # None without a ledger
    compiled: bool
    compile_s: float
    build_s: float


def _locked(model: EngineModel, history: History) -> str:
    """Return the joints and contacts whose force is not unique at the end; empty where all are."""
    if model.nr == model.k:
        return ""
    margins = np.nan_to_num(history.margins()[-1])
    names = (*model.loads, *((*grips_of(model), *model.loads, *grips_of(model)) if model.fed else ()))
    least = float(margins.min())
    locked = [name for name, margin in zip(names, margins, strict=True) if margin <= max(least, CLOSE)]
    return ", ".join(dict.fromkeys(locked)) if least <= CLOSE else ""


def _deepest(model: EngineModel, history: History) -> str:
    return ", ".join(f"{pair} at penetration {history[f'{pair}.penetration'][-1]:.4g} m" for pair in model.pairs)
