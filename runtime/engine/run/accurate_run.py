"""Runs at falling tolerance until the requested accuracy is known to be met."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from hertzwerk.runtime.engine.accuracy.error_estimate import (
    End,
    Ladder,
    LadderResult,
    Rung,
    Verdict,
    beyond_horizon,
    first_tolerance,
)
from hertzwerk.runtime.engine.integration.loop.chunk import EXCEPTION, INTERRUPTED, WALL_TIME_LIMIT
from hertzwerk.runtime.engine.integration.step.layout import FINISHED, TOO_MANY_STEPS
from hertzwerk.runtime.engine.run.run_difference import compared_histories, differences
from hertzwerk.runtime.engine.run.run_request import Request
from hertzwerk.runtime.engine.run.single_run import Check, SingleRun, Trace
from hertzwerk.runtime.engine.solution import error_scales as scaling
from hertzwerk.runtime.engine.solution.error_scales import Scales
from hertzwerk.runtime.engine.solution.outcome import Outcome, too_long, unknown, unreachable

SHORTER = 0.577  # of a first step: that of a run that checks another; between steps that grow threefold, as far from either as can be
MOST_STEPS = "the most steps of a run that checks another"
STOPS = (INTERRUPTED, WALL_TIME_LIMIT, EXCEPTION, TOO_MANY_STEPS)  # statuses that end the search


def run_to_accuracy(
    run: SingleRun,
    scales: Scales,
    times: np.ndarray | None,
    request: Request,
    progress: Callable[[float], object] | None,
) -> LadderResult[Trace]:
    """Run at falling tolerance until the requested error is met."""
    model, seconds, limits = run.model, run.request.seconds, run.limits
    made: list[Trace] = []

    def one(tolerance: float, checks: tuple[Rung[Trace], int] | None, most: float) -> Rung[Trace]:
        given_up = most < limits.max_steps
        own = replace(limits, max_steps=most, whose=MOST_STEPS) if given_up else limits
        shown = None if progress is None else _part(progress, len(made))
        limited = replace(run, limits=own)
        if checks is None:
            trace = limited.trace(tolerance, scales, times, progress=shown, compared=True)
        else:
            check = Check(checks[0].times, SHORTER ** (1 + checks[1]))
            trace = limited.trace(tolerance, scales, times, progress=shown, checks=check)
        made.append(trace)
        status = trace.ending.status
        given_up = given_up and status == TOO_MANY_STEPS
        end = End.REACHED if status == FINISHED else End.STOPPED if status in STOPS and not given_up else End.FAILED
        stopped = checks is None and end is End.STOPPED  # it is not compared with another
        history, counted = trace.recorded.ends if stopped else trace.compared.history, trace.counted
        y = history.part("y")
        return Rung(tolerance, end, history.t, y, counted["steps"], counted["evaluations"], trace.ending.wall_s, trace)

    def differ(one: Rung[Trace], other: Rung[Trace], n: int) -> np.ndarray:
        with np.errstate(all="ignore"):  # of a run that left all scales the error is not known
            return differences(model, scales, one.data, other.data, n)

    ladder = Ladder(
        one,
        differ,
        lambda y: scaling.rounding(model, scales, y),
        seconds,
        request.error,
        at_end=request.at_end,
        names=compared_histories(model),
    )
    return ladder.search(first_tolerance(request.error, seconds, *scales.scene[:2]))


def _part(progress: Callable[[float], object], before: int) -> Callable[[float], object]:
    """Return the progress callback of the next run: every run that is kept has one that checks it."""
    return lambda done: progress((before + done) / (2 * (before // 2) + 2))


def verdict_of(
    run: SingleRun, ladder_result: LadderResult[Trace], request: Request, result: Outcome
) -> tuple[Outcome, tuple[str, ...]]:
    """Return outcome and warnings of a run for an accuracy; a missed or unknown one is not `finished`."""
    error, verdict = ladder_result.error, ladder_result.verdict
    other = None if ladder_result.incomplete is None else run.outcome(ladder_result.incomplete.data)
    lost = error is not None and error.horizon is not None
    if result.finished and verdict is Verdict.STOPPED and other is not None:
        message = f"the run is complete, but the run with a smaller tolerance that would estimate its error is not: {other.message}"
        result = Outcome(other.name, message, other.remedy)
    elif result.finished and error is not None and verdict is not Verdict.MET:
        if verdict is Verdict.BEYOND:
            return too_long(request.error, error, ladder_result.run.tolerance), ()
        if error.floor is not None:
            end = None if request.at_end else error.end
            facts: dict[str, Any] = {"when": error.when, "foreseen": ladder_result.foreseen, "end": end}
            facts["rounded"] = verdict is Verdict.UNREACHABLE
            result = unreachable(request.error, error.floor, run.method, other, **facts)
        elif other is not None:
            result = unknown(request.error, other)
    return result, (beyond_horizon(error),) if lost and error is not None else ()
