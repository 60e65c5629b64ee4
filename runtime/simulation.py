"""From a model and numbers to a solution: one run at a tolerance, or as many as it takes to know the error of one."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from hertzwerk.runtime.accuracy.ladder import (
    POINTS,
    Climbed,
    End,
    Ladder,
    Rung,
    Verdict,
    beyond_horizon,
    first_tolerance,
)
from hertzwerk.runtime.integrate.loop.automatic import Gear
from hertzwerk.runtime.integrate.loop.chunk import INTERRUPTED, WALL_TIME_LIMIT
from hertzwerk.runtime.integrate.step.layout import FINISHED, TOO_MANY_STEPS
from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.run import scales as scaling
from hertzwerk.runtime.run.checkpoint import checkpoint_of
from hertzwerk.runtime.run.engine import engine_for
from hertzwerk.runtime.run.output_times import Output
from hertzwerk.runtime.run.request import MAX_EVENTS, MAX_STEPS, METHOD, Compiled, Limits, Settings, read
from hertzwerk.runtime.run.scales import Scales
from hertzwerk.runtime.run.single_run import SingleRun, Trace
from hertzwerk.runtime.solution.caveats import floored, open_forces, too_fast, unchecked
from hertzwerk.runtime.solution.outcome import Outcome, not_closed, too_long, unknown, unreachable
from hertzwerk.runtime.solution.solution import Solution, Statistics

ACCURACY = 1e-6  # where none is asked for
STOPS = (INTERRUPTED, WALL_TIME_LIMIT, TOO_MANY_STEPS)  # what ends all runs


def simulate(
    model: Model,
    *,
    duration: str | float | None = None,
    accuracy: float | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    output: Output = "steps",
    compiled: Compiled = "auto",
    max_steps: int = MAX_STEPS,
    max_events: int = MAX_EVENTS,
    wall_time: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> Solution:
    """Run a model from its start for a duration (seconds, or text such as "24 ms").

    accuracy    the error asked for at the end, in the scene's scales, 1e-12..1e-1, by default 1e-6: runs at falling tolerance are made until the
                error of one, by comparison with a tighter one, is known to be so small. `Solution.error` says what it is; where it is more
                than was asked for, the outcome is "accuracy_unreachable", or "beyond_horizon"; where it is not known, "accuracy_unknown"
    tolerance   in place of an accuracy the local tolerance, 1e-13..1e-1, of one run without an estimate
    method      "auto": dop853, and esdirk where stability would hold that down; explicit "dop853", "dopri5"; for what is stiff "esdirk", "rodas";
                "cvodes", "idas": SUNDIALS, slow, as an independent reference
    parameters, initial    values in place of the model's, each with its unit: {"clearance": "0.2 mm"}, {"guide.travel": "0.17 m"}
    output      what is kept: "steps", all that were accepted; or the states at a number of points, start and end included (1000), at a
                spacing ("0.1 ms"), at times [s] of your own, by dense output of the method's order; memory then does not grow with the run
    compiled    run the same functions as C; the result is bitwise the same; "auto" does so from where the time to go exceeds the compilation
    max_steps, wall_time [s]    of all runs together, max_events (contacts begun) of each: where to stop, with an outcome that says so
    progress    called now and then with the fraction done

    Raises InputError, with every fault, for bad input and for nothing else: how the run ended is `Solution.outcome`.
    """
    began = time.perf_counter()
    settings = Settings(
        duration,
        accuracy,
        tolerance,
        method,
        compiled,
        output,
        max_steps=max_steps,
        max_events=max_events,
        wall_time=wall_time,
    )
    given, times = read(model, settings, {} if parameters is None else parameters, {} if initial is None else initial)
    engine = engine_for(model.without_redundancy(given.dependent), method, compiled)
    gear = Gear(engine.code, compiled=compiled is True, changes=compiled == "auto") if engine.code else None
    run = SingleRun(model, method, engine, given, settings.limits, gear)
    scales = run.scales(tolerance)
    build_s = time.perf_counter() - began
    if tolerance is not None:
        return solution_of(run, run.trace(tolerance, scales, times, progress=progress), scales, build_s)
    return _as_accurate(run, scales, times, accuracy or ACCURACY, build_s, progress)


def _as_accurate(
    run: SingleRun,
    scales: Scales,
    times: np.ndarray | None,
    asked: float,
    build_s: float,
    progress: Callable[[float], object] | None,
) -> Solution:
    """Runs at falling tolerance; limits of steps and time are of all of them, the limit of events is of the motion, and so of each."""
    model, seconds, limits = run.model, run.given.seconds, run.limits
    grid = np.linspace(0.0, seconds, POINTS)
    made: list[tuple[float, int]] = []  # times [s] and steps spent

    def one(tolerance: float, keep: bool, most: float) -> Rung[Trace]:
        spent_s, steps = (sum(each) for each in zip(*made, strict=True)) if made else (0.0, 0)
        of_all = max(limits.max_steps - int(steps), 1)
        left = Limits(int(min(of_all, most)), limits.max_events, max(limits.wall_time - spent_s, 0.0))
        beside = None if progress is None else _part(progress, len(made))
        here = replace(run, limits=left).trace(tolerance, scales, times, progress=beside, beside=grid, alone=not keep)
        made.append((here.ending.wall_s, here.counted["steps"]))
        status = here.ending.status
        given_up = status == TOO_MANY_STEPS and most < of_all
        end = End.REACHED if status == FINISHED else End.STOPPED if status in STOPS and not given_up else End.FAILED
        states = here.beside.history.part("y")
        counted = here.counted
        return Rung(tolerance, end, states, counted["steps"], counted["evaluations"], here.ending.wall_s, here)

    def differ(y: np.ndarray, reference: np.ndarray) -> np.ndarray:
        return scaling.error(model, scales, y, reference)

    ladder = Ladder(one, differ, lambda y: scaling.rounding(model, scales, y), grid, asked)
    climbed = ladder.climb(first_tolerance(asked, seconds, *scales.scene[:2]))
    return solution_of(run, climbed.run.kept, scales, build_s, asked, climbed)


def _part(progress: Callable[[float], object], before: int) -> Callable[[float], object]:
    """Progress of the next run after so many: every run that is kept has one that checks it."""
    return lambda done: progress((before + done) / (2 * (before // 2) + 2))


def solution_of(
    run: SingleRun,
    trace: Trace,
    scales: Scales,
    build_s: float,
    asked: float | None = None,
    climbed: Climbed[Trace] | None = None,
) -> Solution:
    """What a run returns that was kept, for an accuracy beside those that checked it."""
    model, bound, counted = run.model, run.given.bound, trace.counted
    found: tuple[str, ...] = ()
    result = run.outcome(trace)
    if climbed is not None and asked is not None:
        result, found = _verdict(run, climbed, asked, result)
    if trace.ending.status == FINISHED:
        open_by = trace.findings.energy_unclosed
        result = not_closed(open_by, asked or trace.tolerance, trace.tolerance, counted["steps"]) or result
    return Solution(
        history=trace.kept.history,
        ends=trace.kept.ends,
        findings=trace.findings,
        outcome=result,
        duration=run.given.seconds,
        accuracy=asked,
        tolerance=trace.tolerance,
        method=run.method,
        compiled=trace.compiled,
        parameters=dict(bound.values),
        statistics=Statistics(
            steps=counted["steps"],
            rejected=counted["rejected"],
            retaken=counted["retaken"],
            rhs_evaluations=counted["evaluations"],
            events=counted["events"],
            wall_s=trace.ending.wall_s - trace.compile_s - trace.build_s,
            build_s=build_s + trace.build_s,
            compile_s=trace.compile_s,
        ),
        warnings=(
            *unchecked(model),
            *open_forces(model, bound, run.given.q),
            *bound.warnings,
            *floored(counted["floored"], run.floor),
            *too_fast(model, trace.speeds),
            *_uncompiled(run),
            *found,
        ),
        scales=scales,
        error=None if climbed is None else climbed.error,
        checkpoint=checkpoint_of(model, trace.ending, run.given.initial),
    )


def _uncompiled(run: SingleRun) -> tuple[str, ...]:
    """A warning where C would have saved time and the compiler was of no use."""
    complaint = run.engine.code.complaint if run.engine.code is not None else ""
    return (f"not compiled, which costs time and no accuracy: {complaint}",) if complaint else ()


def _verdict(run: SingleRun, climbed: Climbed[Trace], asked: float, result: Outcome) -> tuple[Outcome, tuple[str, ...]]:
    """Outcome and warnings of a run for an accuracy: what was asked for and is missed, or is not known, is never finished."""
    error, verdict = climbed.error, climbed.verdict
    other = None if climbed.broken is None else run.outcome(climbed.broken.kept)
    lost = error is not None and error.horizon is not None
    if result.finished and verdict is Verdict.STOPPED and other is not None:
        message = f"the run is complete, a run with a smaller tolerance to know its error by is not: {other.message}"
        result = Outcome(other.name, message, other.remedy)
    elif result.finished and error is not None and verdict is not Verdict.MET:
        if verdict is Verdict.BEYOND:
            return too_long(asked, error), ()
        if error.floor is not None:
            result = unreachable(asked, error.floor, run.method, other)
        elif other is not None:
            result = unknown(asked, other)
    return result, (beyond_horizon(error),) if lost and error is not None else ()
