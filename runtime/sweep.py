"""Many runs of one model on all cores: a row each, in the order given; a run that fails is a row too."""

from __future__ import annotations

import csv
import io
import math
import multiprocessing
import os
import signal
import sys
import time
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.binding import Value, read_state
from hertzwerk.runtime.engine import prepare
from hertzwerk.runtime.model import Model
from hertzwerk.runtime.request import Compiled, Settings
from hertzwerk.runtime.simulation import simulate
from hertzwerk.runtime.solution import Solution, Statistics, write

Output = Callable[[Solution], float]
BAD_INPUT, BAD_OUTPUT, LOST = "bad_input", "bad_output", "lost"  # outcomes of rows without a run or some of its numbers
AHEAD = 2  # rows handed out per worker: none waits for the next, and few are under way where one dies
PROBE = 0.3  # s that the first run may take alone, to foresee how long all of them take
_NUMBERS = ("impacts", "peak_force", "energy_residual", "error_estimate", "steps", "rhs_evaluations", "wall_s")
_TEXTS = ("outcome", "message", "warnings")
_UNITS = {"peak_force": "N", "wall_s": "s"}


@dataclass(frozen=True)
class Row:
    """One run: `given` as it was given, `values` the same in SI; `final` every state at the end.

    Where there is no run, `outcome` is "bad_input" (or "lost", where its process died) and `message` holds the faults.
    """

    index: int
    given: Mapping[str, Value]
    outcome: str
    message: str = ""
    values: Mapping[str, float] = field(default_factory=dict)
    impacts: int = 0
    peak_force: float = math.nan
    energy_residual: float | None = None
    error_estimate: float | None = None  # at the end; see `ErrorEstimate`
    final: Mapping[str, float] = field(default_factory=dict)
    outputs: Mapping[str, float] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    statistics: Statistics | None = None

    def __getitem__(self, name: str) -> float | str:
        """Entry of a column."""
        if name in _TEXTS:
            return "; ".join(self.warnings) if name == "warnings" else str(getattr(self, name))
        if name.startswith("final."):
            return self.final.get(name.removeprefix("final."), math.nan)
        for known in (self.outputs, self.values):
            if name in known:
                return known[name]
        if self.statistics is None or name not in _NUMBERS:
            return math.nan
        value = getattr(self.statistics if hasattr(self.statistics, name) else self, name)
        return math.nan if value is None else float(value)


@dataclass(frozen=True)
class Sweep:
    """Rows in the order given. `sweep["peak_force"]` is a column, in SI; `sweep.names` lists what there is.

    interrupted    whether Ctrl-C ended it: the rows are those that were done
    """

    model: Model
    rows: tuple[Row, ...]
    output_names: tuple[str, ...]
    interrupted: bool
    workers: int
    compiled: bool
    wall_s: float

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Row]:
        return iter(self.rows)

    @property
    def names(self) -> tuple[str, ...]:
        """Every name that `sweep[name]` has: what was varied, what came out of it, the states at the end."""
        given = dict.fromkeys(name for row in self.rows for name in row.given if name in _ports(self.model))
        states = (*self.model.coordinates, *self.model.speeds, *self.model.memory)
        final = (f"final.{name}" for name in states)
        return (*given, "outcome", *_NUMBERS, *self.output_names, *final, "message", "warnings")

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.names:
            raise KeyError(f"no column {name!r}; there are {', '.join(self.names)}")
        return np.array([row[name] for row in self.rows], dtype=None if name in _TEXTS else float)

    def unit(self, name: str) -> str:
        """SI unit text of a column, "" where it has none to be stated."""
        return _UNITS.get(name) or _ports(self.model).get(name.removeprefix("final."), "")

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write a line per row, headed `name [unit]`, SI; raises FileExistsError."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["row", *(f"{name} [{self.unit(name)}]" if self.unit(name) else name for name in self.names)])
        for row in self.rows:
            entries = (row[name] for name in self.names)
            table.writerow([row.index, *(e if isinstance(e, str) else format(e, ".17g") for e in entries)])
        return write(Path(path), text.getvalue().encode(), overwrite=overwrite)

    def __str__(self) -> str:
        finished = sum(row.outcome == "finished" for row in self.rows)
        text = f"{len(self.rows)} runs, {finished} finished, in {self.wall_s:.3g} s on {self.workers} cores"
        return f"{text}; interrupted" if self.interrupted else text


def simulate_many(
    model: Model,
    parameter_sets: Iterable[Mapping[str, Value]],
    *,
    duration: str | float | None = None,
    accuracy: float | None = None,
    tolerance: float | None = None,
    method: str = "dop853",
    compiled: Compiled = "auto",
    workers: int | None = None,
    outputs: Mapping[str, Output] | None = None,
    progress: Callable[[float], object] | None = None,
    **limits: Any,
) -> Sweep:
    """Run a model once for each set of values, on all cores; each run is bitwise the one that `simulate` makes.

    parameter_sets    values in place of the model's, parameters and initial states alike: [{"clearance": "0.2 mm"}, ...]
    compiled    "auto" compiles once for all where that saves time; duration, accuracy or tolerance, method, and limits as in `simulate`
    workers    processes, by default as many as there are cores (threads where processes cannot be forked: correct, slower)
    outputs    further columns, each a function of the Solution: {"stroke": lambda run: np.ptp(run["guide.travel"])}
    progress    called now and then with the fraction of runs done

    A set with bad input, a run that does not finish, an output that raises are rows that say so. Raises InputError for what is
    bad input to every run. Ctrl-C returns the rows that are done.
    """
    began = time.perf_counter()
    sets = [dict(values) for values in parameter_sets]
    Settings(duration, accuracy, tolerance, method, compiled, **limits).check(model)
    _check(model, workers, outputs or {})
    settings = {"duration": duration, "accuracy": accuracy, "tolerance": tolerance, "method": method, **limits}
    job = _Job(model, sets, settings, dict(outputs or {}))
    cores = min(workers or _cores(), max(len(sets), 1))
    rows: dict[int, Row] = {}
    interrupted = False
    try:
        foreseen = job.probe(rows, cores) if compiled == "auto" else 0.0
        job.settings["compiled"] = prepare(model, method, compiled, foreseen)
        left = [i for i in range(len(sets)) if i not in rows]
        for row in _run(job, left, min(cores, max(len(left), 1))):
            rows[row.index] = row
            if progress is not None:
                progress(len(rows) / len(sets))
    except KeyboardInterrupt:
        interrupted = True
    return Sweep(
        model=model,
        rows=tuple(rows[i] for i in sorted(rows)),
        output_names=tuple(job.outputs),
        interrupted=interrupted,
        workers=cores,
        compiled=bool(job.settings.get("compiled")),
        wall_s=time.perf_counter() - began,
    )


class _Flag(Protocol):
    """Something shared by those who run; set to 1 it stops them."""

    value: int


@dataclass
class _Alone:
    """A flag within one process."""

    value: int = 0


@dataclass
class _Job:
    """Everything a worker needs; a forked process has it without being sent it."""

    model: Model
    sets: list[dict[str, Value]]
    settings: dict[str, Any]
    outputs: Mapping[str, Output]
    stop: _Flag = field(default_factory=_Alone)

    def row(self, i: int) -> Row:
        """Run set i; raises KeyboardInterrupt where it was stopped."""
        given = self.sets[i]
        try:
            solution = self._solve(i, progress=self._heed)
        except InputError as error:
            return Row(i, given, BAD_INPUT, "; ".join(str(fault) for fault in error.faults))
        if solution.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return self._row(i, solution)

    def probe(self, rows: dict[int, Row], cores: int) -> float:
        """Run the first good set for PROBE at most and foresee the time [s] that all those left take uncompiled."""
        for i in range(len(self.sets)):
            try:
                solution = self._solve(i, compiled=False, wall_time=min(PROBE, self.settings.get("wall_time") or PROBE))
            except InputError as error:
                rows[i] = Row(i, self.sets[i], BAD_INPUT, "; ".join(str(fault) for fault in error.faults))
                continue
            if solution.outcome.name == "interrupted":
                raise KeyboardInterrupt
            if solution.outcome.name != "wall_time_limit":
                rows[i] = self._row(i, solution)
            done = max(solution.t_end / solution.duration, 1e-9) if i not in rows else 1.0
            wall_s = solution.statistics.wall_s + (solution.error.pilot_s if solution.error is not None else 0.0)
            one = min(wall_s / done, self.settings.get("wall_time") or math.inf)
            return one * math.ceil((len(self.sets) - len(rows)) / cores)
        return 0.0

    def _solve(self, i: int, **options: Any) -> Solution:
        states = (*self.model.coordinates, *self.model.speeds)
        parameters = {name: value for name, value in self.sets[i].items() if name not in states}
        initial = {name: value for name, value in self.sets[i].items() if name in states}
        return simulate(self.model, parameters=parameters, initial=initial, **{**self.settings, **options})

    def _heed(self, _: float) -> None:
        if self.stop.value:
            raise KeyboardInterrupt

    def _row(self, i: int, solution: Solution) -> Row:
        outcome, message = solution.outcome.name, "" if solution.outcome.finished else solution.outcome.message
        outputs: dict[str, float] = {}
        for name, output in self.outputs.items():
            try:
                outputs[name] = float(output(solution))
            except Exception as error:  # a row says so: hours of other runs are not lost for it
                outcome, message = BAD_OUTPUT, f"output {name} raised {type(error).__name__}: {error}"
        return Row(
            index=i,
            given=self.sets[i],
            outcome=outcome,
            message=message,
            values=self._values(self.sets[i]),
            impacts=len(solution.impacts),
            peak_force=max((impact.peak_force for impact in solution.impacts), default=0.0),
            energy_residual=solution.energy_residual,
            error_estimate=solution.error.end if solution.error is not None else None,
            final=solution.final,
            outputs=outputs,
            warnings=solution.warnings,
            statistics=solution.statistics,
        )

    def _values(self, given: Mapping[str, Value]) -> dict[str, float]:
        """What was given, good as it is, in SI."""
        model = self.model
        bound = model.bind({name: value for name, value in given.items() if name in model.parameters})
        return {
            name: bound[name] if name in model.parameters else read_state(name, model.units[name], value)[0]
            for name, value in given.items()
        }


def _run(job: _Job, left: list[int], workers: int) -> Iterator[Row]:
    """Rows as they are done; where a process died, those it may have died of are run again, each alone."""
    waiting = deque(left)
    while waiting and workers > 1:
        suspects: list[int] = []
        yield from _together(job, waiting, workers, suspects)
        for i in suspects:
            again: list[int] = []
            yield from _together(job, deque([i]), 1, again)
            if again:
                yield Row(i, job.sets[i], LOST, "its process died, and died again where it ran alone")
    for i in waiting:
        yield job.row(i)


def _together(job: _Job, waiting: deque[int], workers: int, suspects: list[int]) -> Iterator[Row]:
    """Rows of those waiting as they are done, until all are or a process dies: then `suspects` are those that were under way.

    Stops the workers when it is left, however.
    """
    under_way: dict[Future[Row], int] = {}
    executor, row = _executor(job, workers)
    try:
        while not suspects and (waiting or under_way):
            while not suspects and waiting and len(under_way) < AHEAD * workers:
                i = waiting.popleft()
                try:
                    with (
                        warnings.catch_warnings()
                    ):  # Python 3.12 and later warn of threads when forking: NumPy's see to themselves
                        warnings.simplefilter("ignore", DeprecationWarning)
                        under_way[executor.submit(row, i)] = i
                except BrokenExecutor:
                    suspects.append(i)
            for future in wait(under_way, return_when=FIRST_COMPLETED).done:
                try:
                    yield future.result()
                except BrokenExecutor:
                    suspects.append(under_way[future])
                del under_way[future]
        suspects += under_way.values()
    finally:
        job.stop.value = 1
        executor.shutdown(wait=True, cancel_futures=True)


def _executor(job: _Job, workers: int) -> tuple[Executor, Callable[[int], Row]]:
    """Processes where they can be forked, as they then share the model's functions; CasADi holds Python's lock, so threads gain little."""
    if not sys.platform.startswith("linux"):
        return ThreadPoolExecutor(workers), job.row
    context = multiprocessing.get_context("fork")
    job.stop = context.Value("b", 0, lock=False)
    return ProcessPoolExecutor(workers, context, _enter, (job,)), _row


_job: _Job | None = None  # of a worker process


def _enter(job: _Job) -> None:
    global _job
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches every process; the first one tells the others
    _job = job


def _row(i: int) -> Row:
    if _job is None:
        raise TypeError("a worker without a job")
    return _job.row(i)


def _check(model: Model, workers: object, outputs: Mapping[str, Output]) -> None:
    faults = []
    if workers is not None and not (isinstance(workers, int) and not isinstance(workers, bool) and workers > 0):
        faults.append(Fault("workers", repr(workers), "a positive whole number", "None takes every core"))
    taken = {*_NUMBERS, *_TEXTS, *_ports(model)}
    faults += [
        Fault(f"outputs[{name!r}]", "the name of another column", "a name of its own")
        for name in outputs
        if name in taken or name.startswith("final.")
    ]
    if faults:
        raise InputError(model.name, faults)


def _ports(model: Model) -> dict[str, str]:
    """Unit text of every parameter and state: what a set may name."""
    return {**{name: port.unit for name, port in model.parameters.items()}, **model.units}


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
