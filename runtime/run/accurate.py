"""Runs at falling tolerance until the requested accuracy is known to be met."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from hertzwerk.runtime.accuracy.ladder import (
    POINTS,
    End,
    Ladder,
    LadderResult,
    Rung,
    Verdict,
    beyond_horizon,
    first_tolerance,
)
from hertzwerk.runtime.integrate.loop.chunk import EXCEPTION, INTERRUPTED, WALL_TIME_LIMIT
from hertzwerk.runtime.integrate.step.layout import FINISHED, TOO_MANY_STEPS
from hertzwerk.runtime.run.single_run import SingleRun, Trace
from hertzwerk.runtime.solution import scales as scaling
from hertzwerk.runtime.solution.outcome import Outcome, too_long, unknown, unreachable
from hertzwerk.runtime.solution.scales import Scales

MOST_STEPS = "the most steps of a run that checks another"
STOPS = (INTERRUPTED, WALL_TIME_LIMIT, EXCEPTION, TOO_MANY_STEPS)  # statuses that end the search


def run_to_accuracy(
    run: SingleRun,
    scales: Scales,
    times: np.ndarray | None,
    asked: float,
    progress: Callable[[float], object] | None,
) -> LadderResult[Trace]:
    """Run at falling tolerance until the requested error is met."""
    model, seconds, limits = run.model, run.given.seconds, run.limits
    grid = np.linspace(0.0, seconds, POINTS)
    made: list[Trace] = []

    def one(tolerance: float, keep: bool, most: float) -> Rung[Trace]:
        given_up = most < limits.max_steps
        own = replace(limits, max_steps=most, whose=MOST_STEPS) if given_up else limits
        shown = None if progress is None else _part(progress, len(made))
        trace = replace(run, limits=own).trace(tolerance, scales, times, progress=shown, further=grid, alone=not keep)
        made.append(trace)
        status = trace.ending.status
        given_up = given_up and status == TOO_MANY_STEPS
        end = End.REACHED if status == FINISHED else End.STOPPED if status in STOPS and not given_up else End.FAILED
        states = trace.further.history.part("y")
        counted = trace.counted
        return Rung(tolerance, end, states, counted["steps"], counted["evaluations"], trace.ending.wall_s, trace)

    def differ(y: np.ndarray, reference: np.ndarray) -> np.ndarray:
        return scaling.error(model, scales, y, reference)

    ladder = Ladder(one, differ, lambda y: scaling.rounding(model, scales, y), grid, asked)
    return ladder.search(first_tolerance(asked, seconds, *scales.scene[:2]))


def _part(progress: Callable[[float], object], before: int) -> Callable[[float], object]:
    """Return the progress callback of the next run: every run that is kept has one that checks it."""
    return lambda done: progress((before + done) / (2 * (before // 2) + 2))


def verdict_of(
    run: SingleRun, ladder_result: LadderResult[Trace], asked: float, result: Outcome
) -> tuple[Outcome, tuple[str, ...]]:
    """Return outcome and warnings of a run for an accuracy; a missed or unknown one is not `finished`."""
    error, verdict = ladder_result.error, ladder_result.verdict
    other = None if ladder_result.incomplete is None else run.outcome(ladder_result.incomplete.kept)
    lost = error is not None and error.horizon is not None
    if result.finished and verdict is Verdict.STOPPED and other is not None:
        message = f"the run is complete, but the run with a smaller tolerance that would estimate its error is not: {other.message}"
        result = Outcome(other.name, message, other.remedy)
    elif result.finished and error is not None and verdict is not Verdict.MET:
        if verdict is Verdict.BEYOND:
            return too_long(asked, error), ()
        if error.floor is not None:
            result = unreachable(asked, error.floor, run.method, other, foreseen=ladder_result.foreseen)
        elif other is not None:
            result = unknown(asked, other)
    return result, (beyond_horizon(error),) if lost and error is not None else ()
