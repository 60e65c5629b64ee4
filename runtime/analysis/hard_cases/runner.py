"""Runner of hard cases, by every claiming method in CasADi's virtual machine and as C.

Both paths must agree bitwise.
"""

from __future__ import annotations

import multiprocessing
import signal
import sys
import warnings
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import asdict, dataclass
from functools import cache
from typing import Any

import numpy as np

from hertzwerk.runtime.analysis.hard_cases.case import HardCase, Source
from hertzwerk.runtime.analysis.hard_cases.invariants import Measured, measure
from hertzwerk.runtime.engine.integration.loop.c_compilation import available
from hertzwerk.runtime.engine.integration.tableaux.methods import SUNDIALS
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.built_engine import compile_together
from hertzwerk.runtime.engine.run.run_request import Compiled
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.simulation import simulate
from hertzwerk.runtime.system.forked_tasks import cores
from hertzwerk.runtime.system.interrupt import raise_interrupts

FINER = 100  # ratio of a case's tolerance to that of a reference run
FINEST = 1e-12  # least tolerance of a reference run
MAX_STEPS, MAX_EVENTS = 20_000_000, 1_000_000
OUTCOME, SAME = "outcome", "C unlike machine"
PASSED, FAILED, KNOWN = "passed", "failed", "known failure"


@dataclass(frozen=True)
class Result:
    """Result of one case with one method.

    Outcome, every invariant, steps tried, evaluations, the time of both paths [s] (None without C). verdict:
    "passed", "failed", or "known failure" where exactly the failures declared by the case occur.
    """

    case: str
    method: str
    outcome: str
    verdict: str
    measured: tuple[Measured, ...]
    tries: int
    evaluations: int
    wall_s: float
    compiled_wall_s: float | None

    def record(self) -> dict[str, Any]:
        """Return the result as JSON."""
        invariants = [{**asdict(row), "holds": row.holds} for row in self.measured]
        return {**{name: value for name, value in vars(self).items() if name != "case"}, "measured": invariants}


def broken(case: HardCase, outcome: str, measured: Sequence[Measured]) -> tuple[str, ...]:
    """Return the names of violated invariants; "outcome" where the run ended otherwise than expected."""
    other = () if outcome == case.outcome else (OUTCOME,)
    return (*other, *(row.name for row in measured if not row.holds))


def solve(case: HardCase, method: str, *, compiled: Compiled) -> EngineSolution:
    """Run a case once; the independent references at a FINER tolerance, which for them is looser."""
    return simulate(
        model_of(case.source),
        duration=case.duration,
        tolerance=max(case.tolerance / FINER, FINEST) if method in SUNDIALS else case.tolerance,
        method=method,
        parameters=case.parameters,
        initial=case.initial,
        compiled=compiled,
        max_steps=MAX_STEPS,
        max_events=MAX_EVENTS,
    )


@cache
def model_of(source: Source) -> EngineModel:
    """Return the model of a case, loaded once."""
    return source.load()


def result(case: HardCase, method: str, *, native: bool = True) -> Result:
    """Run a case with one method and measure it; `native` compares with C where there is a compiler."""
    return _judged(case, method, solve(case, method, compiled=False), native=native)


def _judged(case: HardCase, method: str, run: EngineSolution, *, native: bool) -> Result:
    measured, compiled_wall_s = measure(case, method, run), None
    if native and method not in SUNDIALS and available():
        twin = solve(case, method, compiled=True)
        measured, compiled_wall_s = (*measured, same(run, twin)), twin.statistics.wall_s
    wrong, statistics = broken(case, run.outcome.name, measured), run.statistics
    foreseen = {name for of, name in case.failures if of == method}
    verdict = FAILED if set(wrong) != foreseen else KNOWN if wrong else PASSED
    tries = statistics.steps + statistics.rejected + statistics.retaken
    evaluations = statistics.rhs_evaluations
    return Result(
        case.name, method, run.outcome.name, verdict, measured, tries, evaluations, statistics.wall_s, compiled_wall_s
    )


def same(run: EngineSolution, twin: EngineSolution) -> Measured:
    """Count the entries of two runs' rows that differ in any bit.

    All of them where the runs differ in length.
    """
    one, two = (np.asarray(each.engine.history.rows) for each in (run, twin))
    alike = one.shape == two.shape
    differing = int(np.sum(one.view(np.uint64) != two.view(np.uint64))) if alike else max(one.size, two.size)
    return Measured(SAME, differing, 0, "1", f"entries of {one.size:,} that differ in any bit")


# -- many --------------------------------------------------------------------------------------------------------------

Work = Sequence[tuple["HardCase", str]]  # cases that share a model, and a method of each


def results(jobs: Sequence[tuple[HardCase, Sequence[str]]], workers: int | None = None) -> Iterator[Result]:
    """Yield the results of cases, each with its methods, as completed, on all cores.

    Cases that share a model are run by one process, and as one C program: what methods share is compiled once.
    """
    groups: dict[Source, list[tuple[HardCase, str]]] = {}
    for case, methods in jobs:
        groups.setdefault(case.source, []).extend((case, method) for method in methods)
    # a long one last would keep one core waiting
    work: list[Work] = sorted(groups.values(), key=lambda runs: any(case.long for case, _ in runs), reverse=True)
    count = min(workers or (cores() if sys.platform.startswith("linux") else 1), len(work))
    if count <= 1:
        for runs in work:
            yield from _of_model(runs)
        return
    others = multiprocessing.active_children()
    executor = ProcessPoolExecutor(count, multiprocessing.get_context("fork"), _enter, (work,))
    try:
        with raise_interrupts():
            yield from _as_done(executor, len(work))
    except KeyboardInterrupt:
        for process in set(multiprocessing.active_children()) - set(others):
            process.terminate()  # a case takes minutes
        raise
    finally:
        executor.shutdown(wait=True, cancel_futures=True)


def _as_done(executor: ProcessPoolExecutor, count: int) -> Iterator[Result]:
    with warnings.catch_warnings():  # Python 3.12 and later warn of threads when forking: NumPy's see to themselves
        warnings.simplefilter("ignore", DeprecationWarning)
        futures = [executor.submit(_results, i) for i in range(count)]
    for future in as_completed(futures):
        yield from future.result()


_work: list[Work] = []  # of a worker process, which has it from being forked


def _enter(work: list[Work]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches every process; the first one tells the others
    _work[:] = work


def _results(i: int) -> list[Result]:
    return list(_of_model(_work[i]))


def _of_model(work: Work) -> Iterator[Result]:
    """Yield the results of cases that share a model."""
    runs = [(case, method, solve(case, method, compiled=False)) for case, method in work]
    if available():
        compile_together(dict.fromkeys((run.engine.history.engine.model, method) for _, method, run in runs))
    for case, method, run in runs:
        yield _judged(case, method, run, native=True)
