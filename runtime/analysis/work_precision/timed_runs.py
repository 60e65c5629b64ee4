"""Timed runs of one problem, measured against its reference; built beforehand, in alternating rounds.

Runs are timed one after the other in one process, round after round: a disturbance of the machine then affects all of
them alike, and the median of the rounds leaves it out. The time is the processor's, which a run, being one thread
that waits for nothing, has all to itself on an idle machine; on a busy one the clock on the wall also includes the
turns of others.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from statistics import median
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.engine.integration.loop.method_choice import IMPLICIT
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS
from hertzwerk.runtime.engine.run.built_engine import prepare
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.analysis.work_precision.reference_run import Problem, Reference
    from hertzwerk.runtime.engine.solution.outcome import Outcome
    from hertzwerk.runtime.simulation import Solution


MAX_STEPS = 1_000_000
LATE = ("wall_time_limit", "too_many_steps")  # outcomes after which tighter accuracies would also take too long
# least and most rounds; after the least only within so many seconds in all
ROUNDS, BUDGET = (3, 9), 15.0
ONCE = 1.0  # s: longer runs are not repeated
SHORT, IN_A_ROW = 0.02, 3  # s: shorter runs are repeated this often in a round


@dataclass(frozen=True)
class RunSpec:
    """One way to run the problem; called, it returns the time [s] of the whole call and the run."""

    problem: Problem
    method: str
    compiled: bool
    accuracy: float
    wall_time: float

    def __call__(self) -> tuple[float, Solution]:
        """Run once."""
        began = time.process_time()
        limits = {"wall_time": self.wall_time, "max_steps": MAX_STEPS}
        run = self.problem(accuracy=self.accuracy, method=self.method, compiled=self.compiled, **limits)
        return time.process_time() - began, run


@dataclass
class TimedRun:
    """Result of a try: outcome, errors, cost and times [s].

    error, departure    (n,) at the times of the reference (see `Reference`), nan after the end of the run
    taken               of the time simulated by `auto`, the share of each of its methods
    """

    by: RunSpec
    outcome: Outcome
    reached: bool  # the end
    error: Array
    departure: Array
    estimate: float | None
    floor: float | None
    tolerance: float
    steps: int
    rhs_evaluations: int
    taken: dict[str, float]
    times: list[float] = field(default_factory=list)

    @property
    def time(self) -> float:
        """Median [s]."""
        return median(self.times)


def ready(problem: Problem, methods: Sequence[str]) -> bool:
    """Build, and compile if possible, what the methods run with; return whether there is a compiler."""
    try:
        for method in methods:
            prepare(problem.model, method, True)
    except InputError:
        return False
    return True


def make(by: RunSpec, held: Reference) -> TimedRun:
    """Run once and measure."""
    by.problem.build(by.method, compiled=by.compiled)
    seconds, run = by()
    return TimedRun(
        by=by,
        outcome=run.outcome,
        reached=run.engine.t_end == held.t[-1],
        error=held.error(run),
        departure=held.departure(run),
        estimate=run.error.worst if run.error is not None and run.error.known else None,
        floor=None if run.error is None else run.error.floor,
        tolerance=run.settings.tolerance,
        steps=run.statistics.steps,
        rhs_evaluations=run.statistics.rhs_evaluations,
        taken=_shares(run) if by.method == "auto" else {},
        times=[seconds],
    )


def repeat(made: Sequence[TimedRun], progress: Callable[[float], object]) -> None:
    """Repeat short runs in rounds and add their times."""
    least, most = ROUNDS
    short = [this for this in made if this.times[0] < ONCE and this.outcome.finished]
    began = time.perf_counter()
    for done in range(most):
        spent = time.perf_counter() - began
        if done >= least and spent * (done + 1) / done > BUDGET:
            break
        for this in short:
            for _ in range(IN_A_ROW if this.times[0] < SHORT else 1):
                this.times.append(this.by()[0])
            progress(min(1.0, (time.perf_counter() - began) / BUDGET))


def _shares(run: Solution) -> dict[str, float]:
    """Return the share of simulated time for each of the two methods of `auto`."""
    implicit = np.diff(run.t) @ (run.engine.history.part("method")[1:, 0] == IMPLICIT) / run.t[-1]
    explicit, other = (table().name for table in METHODS["auto"])
    return {explicit: float(1 - implicit), other: float(implicit)}
