"""What a request for an accuracy costs over the cheapest single run that has the error, and how much better than requested it is.

Over the scenes, as long as in `honesty`, by the default method, in evaluations of the equations and in processor time, which also
counts the comparison of the runs. The single runs are those at every half decade of tolerance, and that of the request itself; true
errors are those of the whole run (`honesty.apart`).
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from benchmarks.honesty import ROUNDING, Motion, apart, counted, scene

from hertzwerk.runtime import simulate
from hertzwerk.runtime.analysis.validation import scenarios

ACCURACIES = (1e-3, 1e-5, 1e-7, 1e-9)
TOLERANCES = tuple(10.0 ** -(k / 2) for k in range(4, 27))
TRUE, COST = (1, 30), 2.2  # issue 40, 3: requested over true error, and cost over the cheapest single run (medians)


@dataclass(frozen=True)
class Request:
    """A request that was met: requested, true and estimated error, evaluations of the call, of the cheapest single run; runs.

    time    processor time of the call over that of the cheapest single run
    """

    scene: str
    asked: float
    true: float
    estimated: float
    evaluations: int
    cheapest: int
    runs: int
    time: float = math.nan

    @property
    def cost(self) -> float:
        """Evaluations of the call over those of the cheapest single run with the requested error."""
        return self.evaluations / self.cheapest

    def __str__(self) -> str:
        costs = f"{self.runs} runs, cost {self.cost:.2f}, time {self.time:.1f}"
        return f"{self.scene}, {self.asked:g}: true {self.true:.2g}, estimated {self.estimated:.2g}, {costs}"


def requests(motion: Motion, accuracies: Sequence[float]) -> Iterator[Request]:
    """Yield the requests of a motion that are met and not below its floor."""
    accuracies = [asked for asked in accuracies if asked >= ROUNDING * motion.uncertain]
    if not accuracies:
        return
    truth = motion.known["dopri5"]  # the default method is dop853: no run is its own reference

    def true(run: Any, *times: np.ndarray) -> float:
        return max(apart(run, truth, each) for each in (motion.times, *times))

    singles = []
    for tolerance in TOLERANCES:
        run, seconds = _timed(lambda tolerance=tolerance: simulate(motion.model, tolerance=tolerance, **motion.given))
        if run.outcome.finished:
            singles.append((run.statistics.rhs_evaluations, seconds, true(run)))
    simulate(motion.model, accuracy=accuracies[0], **motion.given)  # builds what compares runs
    for asked in accuracies:
        with counted() as evaluations:
            run, seconds = _timed(lambda asked=asked: simulate(motion.model, accuracy=asked, **motion.given))
        if run.outcome.finished and run.error is not None and run.error.known:
            off = true(run, run.error.times)
            own = run.statistics.rhs_evaluations, math.nan, off
            sufficient = [(cost, plain) for cost, plain, error in [*singles, own] if error <= asked]
            if sufficient:
                cheapest, plain = min(sufficient)
                costs = sum(evaluations), cheapest, run.error.runs, seconds / plain
                yield Request(motion.name, asked, off, run.error.worst, *costs)


def _timed(simulated: Callable[[], Any]) -> tuple[Any, float]:
    """Return a run and its processor time [s]."""
    began = time.process_time()
    return simulated(), time.process_time() - began


def overpaid(scenes: Sequence[str] | None = None, accuracies: Sequence[float] = ACCURACIES) -> Iterator[str]:
    """Requested over true error and cost over the cheapest single run with the requested error."""
    found, without = list[Request](), list[str]()
    for motion in map(scene, scenarios.names() if scenes is None else scenes):
        found += requests(motion, accuracies)
        without += [motion.name] if motion.uncertain == np.inf else []
    for asked in accuracies:
        yield _line(f"{asked:g}", [request for request in found if request.asked == asked])
    yield _line("all", found)
    yield from (f"    {name}: without a reference" for name in without)
    yield from (f"    over its request: {request}" for request in found if request.true > request.asked)
    yield from (f"    dearest: {request}" for request in sorted(found, key=lambda request: -request.cost)[:5])


def _line(name: str, found: Sequence[Request]) -> str:
    if not found:
        return f"  {name}: no request was met"
    better = np.quantile([request.asked / request.true for request in found], (0.05, 0.5, 0.95))
    cost = np.quantile([request.cost for request in found], (0.5, 0.95, 1))
    kept = TRUE[0] <= better[1] <= TRUE[1], cost[0] <= COST
    verdicts = ["kept" if each else "MISSED" for each in kept]
    return (
        f"  {name:6} {len(found):3} requests: requested/true 5 % {better[0]:.2g}, 50 % {better[1]:.2g} ({TRUE[0]} to {TRUE[1]}: {verdicts[0]}), "
        f"95 % {better[2]:.2g}; cost 50 % {cost[0]:.2f} (<= {COST}: {verdicts[1]}), 95 % {cost[1]:.2f}, at most {cost[2]:.2f}, "
        f"in processor time 50 % {np.nanmedian([request.time for request in found]):.2f}; "
        f"runs {np.mean([request.runs for request in found]):.2f}"
    )
