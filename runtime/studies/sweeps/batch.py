"""Many runs of one model on all cores: a row each in the given order, failed runs included.

Each is done although processes die, and Ctrl-C ends them all.
"""

from __future__ import annotations

import gc
import multiprocessing
import os
import pickle
import signal
import sys
import threading
import time
import warnings
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from contextlib import closing
from functools import partial
from itertools import chain, islice
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault, InputError, refuse, shown, unknown
from hertzwerk.runtime.engine.inputs.input_values import Input, with_input_values
from hertzwerk.runtime.engine.inputs.inputs_by_row import NO_CHOICES, Choices, read_rows, units_of_inputs
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.si_values import si_units
from hertzwerk.runtime.engine.run.output_times import Grid
from hertzwerk.runtime.engine.run.run_request import (
    METHOD,
    Accuracy,
    Compiled,
    Settings,
    progress_faults,
    read_duration,
)
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.engine.start.start_values import stated_values
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.studies.sweeps.points.design_points import Design
from hertzwerk.runtime.studies.sweeps.rows.row import TEXTS, Row
from hertzwerk.runtime.studies.sweeps.rows.row_arrays import RowArrays
from hertzwerk.runtime.studies.sweeps.rows.row_job import (
    NO_NUMBER,
    EngineLostError,
    Job,
    LocalFlag,
    Own,
    RowEngine,
    Task,
    Tasks,
    every_row,
)
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import Output, finals, of_every_run, own
from hertzwerk.runtime.studies.sweeps.sweep_table import COMPLETE, Sweep, columns_of
from hertzwerk.runtime.system.forked_tasks import cores
from hertzwerk.runtime.system.heap import keep_freed
from hertzwerk.runtime.system.optional_packages import required

if TYPE_CHECKING:
    from distributed import Client

# One pool at a time: a process forked while another pool is used would share its pipes, and outlive it.
_pool = threading.Lock()
COLLECTED = 200_000  # objects between searches for garbage in a worker
AHEAD = 2  # tasks submitted per worker: keeps it busy, and few are lost if it dies
TOGETHER = 0.05  # s of rows that are a task: what a task costs beside them is small, and so is what is under way


class Processes:
    """Engine of processes on this machine, by default as many as there are cores.

    Forked ones inherit the job, others are sent a pickle of it. Short rows are done some at a time.
    """

    def __init__(self, workers: int | None) -> None:
        self.workers = workers or cores()

    def rows(self, job: Job, tasks: Tasks) -> Generator[list[Row], None, None]:
        """Yield rows as completed; tasks that may have killed a process are run again, each alone.

        A single task has a process of its own too, unless one worker was requested: it may be the one that dies.
        """
        job.prepare()
        if self.workers > 1:
            yield from every_row(job, tasks, partial(self._together, job))
        else:
            yield from (job.do(task) for task in tasks)

    def _together(self, job: Job, waiting: Tasks, suspects: list[Task]) -> Iterator[list[Row]]:
        with _pool:
            yield from _side_by_side(job, min(self.workers, len(waiting)), waiting, suspects)


def _side_by_side(job: Job, workers: int, waiting: Tasks, suspects: list[Task]) -> Iterator[list[Row]]:
    """Yield rows as completed, until all are or a process dies.

    `suspects` then holds the tasks in progress. Stops the workers when left.
    """
    under_way: dict[Future[tuple[list[Row], float]], list[Task]] = {}
    executor, do, stop = _executor(job, workers)
    count = 1  # of rows at a time
    try:
        while not suspects and (waiting or under_way):
            while not suspects and waiting and len(under_way) < AHEAD * workers:
                tasks = list(islice(waiting, min(count, -(-len(waiting) // (AHEAD * workers)))))
                try:
                    # Python 3.12 and later warn of threads when forking: NumPy's see to themselves.
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore", DeprecationWarning)
                        under_way[executor.submit(do, tasks)] = tasks
                except BrokenExecutor:
                    suspects += tasks
            for future in wait(under_way, return_when=FIRST_COMPLETED).done:
                try:
                    rows, seconds = future.result()
                except BrokenExecutor:
                    suspects += under_way[future]
                else:
                    count = max(int(TOGETHER * len(rows) / seconds), 1)
                    yield rows
                del under_way[future]
        suspects += (task for tasks in under_way.values() for task in tasks)
    finally:
        stop.value = 1
        executor.shutdown(wait=True, cancel_futures=True)


def _executor(job: Job, workers: int) -> tuple[Executor, Callable[[list[Task]], tuple[list[Row], float]], Any]:
    """Return an executor of processes, or of threads where there are none, its function, its stop flag.

    Processes are forked where that is safe, and share the model's functions; started as `multiprocessing` is set to,
    they build their own. CasADi holds Python's lock, so threads gain little.
    """
    start = multiprocessing.get_start_method(allow_none=True) or ("fork" if sys.platform.startswith("linux") else None)
    if start is None or (start != "fork" and not _pickles(job)):
        job.stop = local = LocalFlag()
        return ThreadPoolExecutor(workers), partial(_timed, job), local
    context: Any = multiprocessing.get_context(start)
    job.stop = shared = context.Value("b", 0, lock=False)
    return ProcessPoolExecutor(workers, context, _enter, (job,)), _do, shared


def _pickles(job: Job) -> bool:
    try:
        pickle.dumps(job)
    except (pickle.PicklingError, AttributeError, TypeError):  # a lambda is any of these
        return False
    return True


_job: Job | None = None  # of a worker process


def _enter(job: Job) -> None:
    global _job, _pool
    keep_freed()
    gc.freeze()  # what was forked is no garbage: to look through it takes as long as 50 rows, and copies its pages
    gc.set_threshold(COLLECTED)  # rows make hardly any
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches every process; the first one tells the others
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _job, _pool = job, threading.Lock()  # the one that was forked is held


def _end_with_parent() -> None:
    """End a worker whose parent was killed."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _do(tasks: list[Task]) -> tuple[list[Row], float]:
    if _job is None:
        raise TypeError("a worker without a job")
    return _timed(_job, tasks)


def _timed(job: Job, tasks: list[Task]) -> tuple[list[Row], float]:
    """Do tasks; return their rows and the time of the processor that they took [s]."""
    began = time.thread_time()
    return job.do(*tasks), time.thread_time() - began


INTERRUPTED = Outcome("interrupted", "stopped by the user", "the rows that were done are there")


def _sets(sets: object) -> list[dict[str, Value]]:
    """Return the sets of values; raises InputError for malformed ones."""
    expected = 'mappings of values by name, such as [{"clearance": "0.2 mm"}, {"clearance": "0.4 mm"}]'
    if isinstance(sets, str | Mapping) or not isinstance(sets, Iterable):
        raise InputError("simulate_many", [Fault("parameter_sets", shown(sets), expected)])
    rows = list(sets)
    refuse(
        "simulate_many",
        [
            Fault(f"parameter_sets, row {i}", shown(row), expected)
            for i, row in enumerate(rows)
            if not isinstance(row, Mapping)
        ],
    )
    return [dict(row) for row in rows]


def simulate_many(
    target: Target,
    parameter_sets: Iterable[Mapping[str, Value]],
    *,
    duration: str | float | None = None,
    accuracy: Accuracy | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    grid: Grid = None,
    compiled: Compiled = "auto",
    max_steps: int | None = None,
    max_events: int | None = None,
    wall_time: float | None = None,
    workers: int | None = None,
    client: Client | None = None,
    functions: Mapping[str, Own] | None = None,
    progress: Callable[[float], object] | None = None,
) -> Sweep:
    """Run a scene once for each set of values, on all cores.

    Each run is bitwise the one that `simulate` makes.

    target    a scene or a Model, as `simulate` takes it
    parameter_sets    values that replace the scene's: parameters, initial states and inputs, [{"clearance": "0.2 mm"}, ...];
                      an input as `simulate` takes it, or a factor on it: {"torque": "bench.csv:load"}, {"torque.scale": 0.5}
    parameters, initial, inputs    values for all runs, as `simulate` takes them; those of a set take precedence
    compiled    "auto" compiles once for all where that saves time
    workers    number of processes, by default one per core (threads where processes cannot be forked: correct, slower)
    client    a Dask cluster in their place, by a connected `distributed.Client`
    grid    states that functions see of each run, as of `simulate`
    functions    further columns, each a function of the Solution: {"stroke": lambda run: np.ptp(run["guide.travel"])}
    progress    a function that is called now and then with the fraction of runs done

    The other arguments are those of `simulate`. A row states in its outcome that its input is invalid, that its run does not
    finish or fails, or that an output raises or exits. Raises InputError for input that is invalid for every run. An output that is not a
    number is found in the first row. Ctrl-C returns the finished rows, and so does a cluster that has stopped.
    """
    began = time.perf_counter()
    model, sets, wrong = engine_model(target), _sets(parameter_sets), progress_faults(progress)
    own_values, states = stated_values(model, parameters, initial, wrong)
    named = dict.fromkeys(name for values in sets for name in values)
    sets = [{**own_values, **states, **values} for values in sets]
    if not (functions is None or isinstance(functions, Mapping)):
        wrong.append(Fault("functions", shown(functions), "a dictionary of functions of the Solution"))
        functions = None
    limits = {"max_steps": max_steps, "max_events": max_events, "wall_time": wall_time}
    settings: dict[str, Any] = {
        **{"duration": duration, "accuracy": accuracy, "tolerance": tolerance, "method": method},
        **{"grid": grid, **limits},
    }
    Settings(**settings, compiled=compiled).check(model)
    units = {**si_units(model), **units_of_inputs(model)}
    wrong += [unknown("parameter or state", name, units) for name in (*own_values, *states) if name not in units]
    model, bad = with_input_values(model, inputs, duration, {})
    _check(model, [*wrong, *bad, *worker_faults(workers, client)], functions or {})
    sets, choices = read_rows(model, sets, read_duration(model, {}, duration, []))
    wanted = [
        *of_every_run(model),
        *(own(name, function) for name, function in (functions or {}).items()),
        *finals(model),
    ]
    units |= dict.fromkeys(choices.signals, "")
    varied = {name: units[name] for name in named if name in units}
    results = {name: unit for output in wanted for name, unit in output.columns.items()}
    batch = Batch(model, sets, settings, wanted, compiled, engine_of(workers, client), choices=choices)
    rows, outcome = in_memory(batch.rows(range(len(sets))), len(sets), progress)
    return Sweep(
        scene=model.name,
        rows=rows,
        columns=columns_of(varied, {**results, "wall_s": "s"}),
        varied=tuple(varied),
        outcome=outcome,
        workers=batch.workers,
        compiled=batch.compiled,
        wall_s=time.perf_counter() - began,
    )


def in_memory(
    made: Generator[list[Row], None, None], count: int, progress: Callable[[float], object] | None
) -> tuple[tuple[Row, ...], Outcome]:
    """Return the rows that are done, and how it ended; raises InputError."""
    rows: dict[int, Row] = {}
    outcome = COMPLETE
    try:
        with closing(made) as done:  # its workers end here, whatever is raised
            for some in done:
                rows |= {row.index: row for row in some}
                if progress is not None:
                    progress(len(rows) / count)
    except KeyboardInterrupt:
        outcome = INTERRUPTED
    except EngineLostError as error:
        outcome = engine_lost(error, "the rows that were done are there")
    return tuple(rows[i] for i in sorted(rows)), outcome


def engine_lost(error: EngineLostError, remedy: str) -> Outcome:
    """Return the outcome of a sweep whose engine is gone."""
    return Outcome("cluster_lost", str(error), remedy)


def worker_faults(workers: object, client: object) -> list[Fault]:
    """Return the faults of what is to compute the rows."""
    if workers is None:
        return []
    if client is not None:
        return [Fault("workers", f"{shown(workers)} beside a client", "one of the two", "a cluster has its own")]
    if isinstance(workers, int) and not isinstance(workers, bool) and workers > 0:
        return []
    return [Fault("workers", shown(workers), "a positive whole number", "None takes every core")]


def engine_of(workers: int | None, client: object) -> RowEngine:
    """Return the engine of a client, or else of so many processes; raises InputError."""
    if client is None:
        return Processes(workers)
    required("distributed", "cluster")
    from hertzwerk.runtime.studies.sweeps.rows.cluster import Cluster

    return Cluster(client)


class Batch:
    """Runs of one model, each a row, by the workers of an engine.

    sets    values of every row, parameters, initial states and inputs alike
    settings    arguments of `simulate` for all of them
    compiled    as requested
    later    rows for which there will be further calls, foreseen where it is chosen whether to compile
    kept    arrays that every row keeps
    choices    what rows choose their inputs among
    """

    def __init__(
        self,
        model: EngineModel,
        sets: Design | Sequence[Mapping[str, Value]],
        settings: Mapping[str, Any],
        outputs: Sequence[Output],
        compiled: Compiled,
        engine: RowEngine,
        row_arrays: RowArrays | None = None,
        later: int = 0,
        choices: Choices = NO_CHOICES,
    ) -> None:
        self._job = Job(model, Settings(**settings, compiled=compiled), list(outputs), row_arrays, choices=choices)
        self._sets, self._engine, self._later = sets, engine, later
        self._begun = False

    @property
    def workers(self) -> int:
        """Number of rows that are computed side by side."""
        return max(min(self._engine.workers, len(self._sets)), 1)

    @property
    def compiled(self) -> bool:
        """Whether rows that were made are compiled."""
        return self._job.compiled

    def rows(
        self,
        wanted: Iterable[int],
        lost: Iterable[int] = (),
        starts: Mapping[int, Mapping[str, Value]] | None = None,
        count: int | None = None,
    ) -> Generator[list[Row], None, None]:
        """Yield the rows of these sets as they are done, some at a time; close it to end the workers.

        Then those of sets whose process died in an earlier call, where workers have processes of their own. Sets are
        looked at as workers become free.

        count    how many are wanted, about, by default all
        starts    initial values by row in place of those of its set

        Raises InputError for input that is bad for every run, or where the first row shows that an output is not a
        number, KeyboardInterrupt, and EngineLostError.
        """
        begun, known = self._begun, starts or {}
        self._begun = True
        left, again = (((i, {**self._sets[i], **known.get(i, {})}) for i in sets) for sets in (wanted, lost))
        apart = again if self._engine.workers > 1 else ()
        with closing(self._rows(Tasks(left, len(self._sets) if count is None else count), apart)) as rows:
            yield from rows if begun else _first_a_number(self._job.model, rows)

    def _rows(self, left: Tasks, again: Iterable[Task]) -> Generator[list[Row], None, None]:
        if self._job.settings.compiled == "auto":
            yield from ([row] for row in self._job.probe(left, self.workers, self._later))
        tasks = Tasks(chain(left, again), len(left))
        if tasks:
            with closing(self._engine.rows(self._job, tasks)) as done:
                yield from done


def _first_a_number(model: EngineModel, rows: Iterable[list[Row]]) -> Iterator[list[Row]]:
    """Yield rows; raise InputError where the first of all shows that an output is not a number."""
    first = True
    for some in rows:
        if first and some[0].outcome == NO_NUMBER:
            remedy = 'one number of a history: lambda run: np.ptp(run["guide.travel"]); several are several outputs'
            raise InputError(model.name, [Fault("functions", some[0].message, "a number", remedy)])
        first = False
        yield some


def _check(model: EngineModel, faults: list[Fault], functions: Mapping[str, Own]) -> None:
    faults += [
        Fault(f"functions[{name!r}]", repr(function), "a name, and a function of the Solution")
        for name, function in functions.items()
        if not (isinstance(name, str) and callable(function))
    ]
    refuse(model.name, faults)
    taken = {
        *TEXTS,
        *si_units(model),
        *units_of_inputs(model),
        "wall_s",
        *(name for output in of_every_run(model) for name in output.columns),
    }
    faults += [
        Fault(f"functions[{name!r}]", "the name of another column", "a name of its own")
        for name in functions
        if name in taken or name.startswith("final.")
    ]
    refuse(model.name, faults)
