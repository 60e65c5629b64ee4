"""Work-precision study: true error and time of runs over methods, accuracies and compilation."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product
from statistics import fmean, median
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.analysis.work_precision.reference_run import Problem, Reference, reference
from hertzwerk.runtime.analysis.work_precision.timed_runs import LATE, RunSpec, TimedRun, make, ready, repeat
from hertzwerk.runtime.engine.accuracy.horizon import Growth, crossing, growth
from hertzwerk.runtime.engine.integration.tableaux.methods import EXPLICIT, IN_GRAPH
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.sensitivity.lyapunov import Lyapunov


ACCURACIES = tuple(10.0**-k for k in range(3, 10))
WALL_TIME = 5.0  # s, of a run
STARTED = 0.01  # of the local tolerance: least error that shows growth; before it may be a free flight without error
APART = 0.3  # least decades between two errors that a cost is computed from
FIRST = (0.1, 0.5)  # progress after the reference, and after the first run of each kind
DEAR = 20_000  # implicit steps: derivatives of more take too long
NOT_TRIED = "not_tried"


@dataclass(frozen=True)
class Row:
    """One run of a study: accuracy requested, error reached, time taken.

    error       true error of the whole run, in the scene's scales; None where the run did not get there
    estimate    the run's own estimate of it
    time        [s] the whole call takes its user, median of several; None where it was not tried
    floor       least error that the run found to be possible, where that is more than was requested
    horizon     time [s] up to which the trajectory stays within 1 %, extrapolated beyond the end of the run by the growth of errors; infinite where
                they do not grow; None where that is unknown
    """

    method: str
    compiled: bool
    accuracy: float
    outcome: str
    message: str
    error: float | None = None
    estimate: float | None = None
    steps: int | None = None
    rhs_evaluations: int | None = None
    time: float | None = None
    floor: float | None = None
    horizon: float | None = None


@dataclass(frozen=True)
class Study:
    """Rows by method, in the virtual machine and as C, each from loose to tight.

    requested   duration requested [s]; longer than the runs where the reference does not hold so long
    along       error and departure (n,) at the times of the reference, of the runs of each method and accuracy
    lyapunov    exponent along the reference; None where that has no derivatives, or a run to find them in is too dear
    taken       of the time simulated by `auto`, the share of each of its methods, by accuracy
    """

    problem: Problem
    reference: Reference
    requested: float
    rows: tuple[Row, ...]
    growth: Growth
    lyapunov: Lyapunov | None
    along: Mapping[tuple[str, float], tuple[Array, Array]]
    taken: Mapping[float, Mapping[str, float]]

    @property
    def shortened(self) -> bool:
        """Return whether runs end where the reference is no longer known, before the requested duration."""
        return float(self.reference.t[-1]) < self.requested

    @property
    def compiled(self) -> bool:
        """Return whether there are compiled rows; methods are then compared by these."""
        return any(row.compiled for row in self.rows)

    @cached_property
    def methods(self) -> tuple[str, ...]:
        """Methods in the order of their rows."""
        return tuple(dict.fromkeys(row.method for row in self.rows))

    def of(self, method: str, *, compiled: bool | None = None) -> list[Row]:
        """Return the rows of a method, by default those by which methods are compared."""
        compiled = self.compiled if compiled is None else compiled
        return [row for row in self.rows if row.method == method and row.compiled == compiled]

    @property
    def least(self) -> float:
        """The least measurable error."""
        return self.reference.least

    @cached_property
    def levels(self) -> tuple[float, ...]:
        """The requested accuracies that are measurable."""
        return tuple(a for a in dict.fromkeys(row.accuracy for row in self.rows) if a >= self.least)

    @cached_property
    def times(self) -> dict[str, dict[float, float]]:
        """Least time [s] of each method's runs with an error within a level; no entry where there is none."""
        least: dict[str, dict[float, float]] = {}
        for method in self.methods:
            rows = [(row.error, row.time) for row in self.of(method) if row.error is not None and row.time is not None]
            by_level = {level: [time for error, time in rows if error <= level] for level in self.levels}
            least[method] = {level: min(times) for level, times in by_level.items() if times}
        return least

    @cached_property
    def cheapest(self) -> dict[float, str]:
        """Fastest method at each level that some method reaches."""
        cheapest = {}
        for level in self.levels:
            able = [method for method in self.methods if level in self.times[method]]
            if able:
                cheapest[level] = min(able, key=lambda method: self.times[method][level])
        return cheapest

    @cached_property
    def recommended(self) -> str | None:
        """Method that reaches most levels and is the fastest on average; None where no run reaches any."""

        def score(method: str) -> tuple[int, float]:
            over = [math.log(t / self.times[self.cheapest[x]][x]) for x, t in self.times[method].items()]
            return len(over), -fmean(over) if over else 0.0

        return max(self.methods, key=score) if self.cheapest else None

    @cached_property
    def decade_costs(self) -> dict[str, float | None]:
        """Factor of time for ten times less error, of each method.

        Where errors are not measurable, for ten times less requested.
        """
        costs = {}
        for method in self.methods:
            measurable = self._measurable(method)
            cost = decade_cost([error for error, _, _ in measurable], [time for _, time, _ in measurable])
            rows = [row for row in self.of(method) if row.time and row.error is not None and row.error <= row.accuracy]
            requested = decade_cost([row.accuracy for row in rows], [row.time or math.nan for row in rows])
            costs[method] = requested if cost is None else cost
        return costs

    @property
    def decade_cost(self) -> float | None:
        """Factor of time for ten times less error, of the recommended method."""
        return None if self.recommended is None else self.decade_costs[self.recommended]

    @cached_property
    def orders(self) -> dict[str, float | None]:
        """Observed order of each method."""
        rows = {method: self._measurable(method) for method in self.methods}
        return {
            m: order([e for e, _, _ in measurable], [n for _, _, n in measurable]) for m, measurable in rows.items()
        }

    @cached_property
    def relative_times(self) -> dict[str, float | None]:
        """Time of each method over that of the recommended one, at the same levels on average."""
        best = self.times[self.recommended] if self.recommended else {}
        ratios: dict[str, float | None] = {}
        for method in self.methods:
            logs = [math.log(t / best[x]) for x, t in self.times[method].items() if x in best]
            ratios[method] = math.exp(fmean(logs)) if logs else None
        return ratios

    @property
    def gain_of_compilation(self) -> float | None:
        """Time in the virtual machine over time as C, of the recommended method."""
        both = (self.of(self.recommended or "", compiled=compiled) for compiled in (False, True))
        ratios = [a.time / b.time for a, b in zip(*both, strict=False) if a.time and b.time]
        return median(ratios) if ratios else None

    def _measurable(self, method: str) -> list[tuple[float, float, float]]:
        """Return error, time [s] and evaluations of the runs with a measurable error."""
        return [
            (row.error, row.time, float(row.rhs_evaluations))
            for row in self.of(method)
            if row.error is not None and row.error >= self.least and row.time and row.rhs_evaluations
        ]


def study(
    problem: Problem,
    *,
    methods: Sequence[str] = tuple(IN_GRAPH),
    accuracies: Sequence[float] = ACCURACIES,
    wall_time: float = WALL_TIME,
    progress: Callable[[float], object] = lambda _: None,
    arrived: Callable[[Reference, Sequence[Row]], object] = lambda *_: None,
) -> Study:
    """Make the reference, then every run, one after the other: in the virtual machine, then as C.

    Runs timed at once would disturb each other.

    accuracies    from loose to tight; where a run takes longer than wall_time [s], the tighter ones of its method are not tried
    arrived       called with the rows of each method as soon as they are made, with times of one run and without horizons

    Raises InputError for bad input, NoReferenceError where there is no reference.
    """
    held = reference(problem, lambda part: progress(FIRST[0] * part))
    requested = held.run.settings.duration
    if held.known < requested:
        problem = replace(problem, duration=held.known)
        held = reference(problem)
    series = [(method, compiled) for compiled in (False, True) for method in methods]
    made: list[TimedRun] = []
    rows: list[Row] = []  # of what is not tried
    for i, (method, compiled) in enumerate(series):
        progress(FIRST[0] + (FIRST[1] - FIRST[0]) * i / len(series))
        if i == len(methods) and not ready(problem, methods):
            break
        runs, left = _series(problem, held, method, accuracies, compiled=compiled, wall_time=wall_time)
        made, rows = [*made, *runs], [*rows, *left]
        arrived(held, [*(_row(this, held) for this in runs), *left])
    repeat(made, lambda part: progress(FIRST[1] + (1 - FIRST[1]) * part))
    reached = [this for this in made if this.reached]
    floors = [np.maximum(held.floor_of_departure, STARTED * this.tolerance) for this in reached]
    grows = growth(held.t, [this.departure for this in reached], floors)
    exponent = _lyapunov(held)
    if exponent is not None and exponent.chaotic:
        grows = exponent.law  # of small changes: errors of runs show it where they are small, and known
    rows += [_row(this, held, grows) for this in made]
    places = {(m, c, a): i for i, (m, c, a) in enumerate(product(methods, (False, True), accuracies))}
    return Study(
        problem=problem,
        reference=held,
        requested=requested,
        rows=tuple(sorted(rows, key=lambda row: places[row.method, row.compiled, row.accuracy])),
        growth=grows,
        lyapunov=exponent,
        along={(this.by.method, this.by.accuracy): (this.error, this.departure) for this in reached},
        taken={this.by.accuracy: this.taken for this in made if this.taken},
    )


def _series(
    problem: Problem,
    held: Reference,
    method: str,
    accuracies: Sequence[float],
    *,
    compiled: bool,
    wall_time: float,
) -> tuple[list[TimedRun], list[Row]]:
    """Make the runs of a method from loose to tight; return them, and rows of those not tried."""
    made: list[TimedRun] = []
    for i, accuracy in enumerate(accuracies):
        made.append(make(RunSpec(problem, method, compiled, accuracy, wall_time), held))
        if made[-1].outcome.name in LATE:
            message = f"with {accuracy:.0e} {made[-1].outcome.message}"
            return made, [Row(method, compiled, tighter, NOT_TRIED, message) for tighter in accuracies[i + 1 :]]
    return made, []


def _lyapunov(held: Reference) -> Lyapunov | None:
    """Return the largest exponent along the reference, by the cheaper of its two runs."""
    runs = [run for run in (held.run, held.partner) if run.settings.method in EXPLICIT or run.statistics.steps <= DEAR]
    if not runs:
        return None
    exponents = min(runs, key=lambda run: (run.settings.method not in EXPLICIT, run.statistics.steps)).lyapunov()
    return None if exponents.reason else exponents


def decade_cost(errors: Sequence[float], times: Sequence[float]) -> float | None:
    """Return the factor of time for ten times less error; None where errors scatter too much.

    10^(1/p) where the time is proportional to error^(-1/p).
    """
    slope = _slope(np.log10(errors), np.log10(times))
    return None if slope is None else float(10.0**-slope)


def order(errors: Sequence[float], evaluations: Sequence[float]) -> float | None:
    """Return p, where the error is proportional to evaluations^-p; None where errors scatter too much."""
    slope = _slope(np.log10(errors), np.log10(evaluations))  # of errors, which are further apart than the evaluations
    return None if slope is None or slope >= 0 else -1 / slope


def _slope(x: Array, y: Array) -> float | None:
    """Return the median of the slopes between distant points (Theil and Sen), robust to single errors."""
    apart = [(i, j) for i, j in combinations(range(len(x)), 2) if abs(x[j] - x[i]) >= APART]
    return median(float((y[j] - y[i]) / (x[j] - x[i])) for i, j in apart) if len(apart) > 1 else None


def _row(this: TimedRun, held: Reference, grows: Growth | None = None) -> Row:
    horizon: float | None = None
    if this.reached and grows is not None:
        left = crossing(held.t, this.departure)
        if math.isinf(left):
            last = slice(-max(1, len(held.t) // 10), None)
            left = grows.reaches(float(np.median(np.maximum(this.departure, held.floor_of_departure)[last])))
        horizon = None if math.isnan(left) else left
    by = this.by
    return Row(
        method=by.method,
        compiled=by.compiled,
        accuracy=by.accuracy,
        outcome=this.outcome.name,
        message=this.outcome.message,
        error=float(np.max(this.error)) if this.reached else None,
        estimate=this.estimate,
        steps=this.steps,
        rhs_evaluations=this.rhs_evaluations,
        time=this.time,
        floor=this.floor,
        horizon=horizon,
    )
