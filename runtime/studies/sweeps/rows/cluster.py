"""Rows on the workers of a Dask cluster: text and numbers go there, rows come back.

A job is sent once, as the text of its model, its settings, the names of its outputs and the code of own functions;
each worker builds and compiles it once. A row is a task: if its worker dies, Dask gives it to another.
"""

from __future__ import annotations

import pickle
import platform
import socket
import sys
import threading
import time
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import ExitStack, closing, contextmanager, suppress
from dataclasses import replace
from functools import lru_cache
from queue import Empty, SimpleQueue
from typing import Any

import cloudpickle
from distributed import CancelledError, Client, Future, KilledWorker, Reschedule, get_worker
from distributed.client import ClosedClientError
from distributed.comm import get_address_host_port

from hertzwerk.derive.common.faults import Fault, InputError, shown
from hertzwerk.runtime.engine.model.generated_text import text_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.studies.sweeps.points.sweep_definition import LIBRARIES, versions
from hertzwerk.runtime.studies.sweeps.rows.row import Row
from hertzwerk.runtime.studies.sweeps.rows.row_job import EngineLostError, Job, LocalFlag, Task, Tasks, every_row

AHEAD = 4  # tasks submitted per thread of a worker: keeps it busy, and a scheduler is not flooded
LOOK = 1.0  # s between two looks at who is there
PATIENCE = 10.0  # s to wait for a scheduler, and for one worker at least
CONNECTION = (OSError, CancelledError, ClosedClientError)  # errors of a scheduler that is gone


@contextmanager
def connected(address: str) -> Iterator[Client]:
    """Connect to the scheduler at an address; raises InputError where there is none."""
    try:
        socket.create_connection(get_address_host_port(address), PATIENCE).close()  # says at once why not
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:  # a port that is no number is a ValueError
        way_out = "`dask scheduler` starts one, `dask worker ADDRESS` its workers"
        expected = "the address of a Dask scheduler that runs, such as tcp://host:8786"
        raise InputError("cluster", [Fault(address, f"no scheduler ({error})", expected, way_out)]) from error
    with closing(client):
        yield client


class Cluster:
    """Engine of a Dask cluster, by the client that is connected with it; raises InputError.

    Every worker must have the versions that are in use here.
    """

    def __init__(self, client: object) -> None:
        if not isinstance(client, Client) or client.asynchronous:
            raise InputError("cluster", [Fault("client", shown(client), "a distributed.Client, not asynchronous")])
        self._client = client
        self._answered = self._looked = time.monotonic()
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
            self.workers = self._threads()
            there = client.run(in_use, on_error="return")
        except CONNECTION as error:
            actual = f"a cluster without workers ({error})"
            way_out = f"`dask worker {client.scheduler.address if client.scheduler else 'ADDRESS'}` starts one"
            raise InputError("cluster", [Fault("client", actual, "a cluster with workers", way_out)]) from error
        if faults := [
            fault for worker, installed in there.items() for fault in _differing(worker, in_use(), installed)
        ]:
            raise InputError("cluster", faults)

    def rows(self, job: Job, tasks: Tasks) -> Generator[list[Row], None, None]:
        """Yield rows as completed; tasks that Dask gives up, as workers died, are run again, each alone."""
        packed = _packed(job)
        yield from every_row(job, tasks, lambda waiting, suspects: self._together(job, packed, waiting, suspects))

    def _together(self, job: Job, packed: bytes, waiting: Tasks, suspects: list[Task]) -> Iterator[list[Row]]:
        """Yield rows as completed; `suspects` then holds the tasks that Dask has given up.

        Cancels what is under way when left. Raises EngineLostError where there is no scheduler or no worker left.
        """
        client, done = self._client, SimpleQueue[Future]()
        sent = client.submit(bytes, packed, key=f"hertzwerk-job-{id(done)}-{time.time_ns()}")
        under_way: dict[Any, tuple[Future, Task]] = {}
        try:
            while waiting or under_way:
                self._look()
                while waiting and len(under_way) < AHEAD * self.workers:
                    task = waiting.take()
                    future = client.submit(_do, sent, task, pure=False)
                    under_way[future.key] = future, task
                    future.add_done_callback(done.put)
                with suppress(Empty):
                    future, task = under_way.pop(done.get(timeout=LOOK).key)
                    try:
                        row, job.compiled = future.result()
                    except KilledWorker:
                        suspects.append(task)
                    else:
                        yield [row]
        except CONNECTION as error:
            raise EngineLostError(f"the scheduler has stopped ({error})") from error
        finally:
            with suppress(*CONNECTION):
                client.cancel([sent, *(future for future, _ in under_way.values())])

    def _look(self) -> None:
        """Count the threads of the workers, now and then; raises EngineLostError where there is none for long."""
        now = time.monotonic()
        if now - self._looked < LOOK:
            return
        self._looked, threads = now, self._threads()
        if threads:
            self._answered, self.workers = now, threads
        elif now - self._answered > PATIENCE:
            raise EngineLostError(f"no worker was available for {PATIENCE:g} s")

    def _threads(self) -> int:
        return sum(self._client.nthreads().values())


# -- what is sent ------------------------------------------------------------------------------------------------------


def in_use() -> dict[str, str]:
    """Return the versions that are in use; those of Python differ in the code of functions."""
    return {**versions(), "python": ".".join(platform.python_version_tuple()[:2])}


def _differing(worker: str, here: Mapping[str, str], there: Mapping[str, str] | Exception) -> list[Fault]:
    """Return a fault for every version of a worker that differs from those in use here."""
    way_out = "install the same versions everywhere"
    if isinstance(there, Exception):  # without hertzwerk
        expected = ", ".join(f"{name} {version}" for name, version in here.items())
        return [Fault(f"worker {worker}", f"{type(there).__name__}: {there}", expected, way_out)]
    return [
        Fault(f"worker {worker}, {name}", there.get(name, "none"), f"{version}, as here", way_out)
        for name, version in here.items()
        if there.get(name) != version
    ]


def _packed(job: Job) -> bytes:
    """Return a job as text and numbers, with the code of own functions; raises InputError."""
    model = job.model
    if not text_of(model.module):
        fault = Fault("client", "a model whose generated text is not known", "a model that `load` returned")
        raise InputError(model.name, [fault])
    bare = replace(job, model=EngineModel(model.module, dependent=model.dependent), stop=LocalFlag())
    functions = [output.function for output in job.outputs if output.function is not None]
    try:
        with _by_value(functions):
            return pickle.dumps((in_use(), cloudpickle.dumps(bare)))
    except (pickle.PicklingError, TypeError, AttributeError, ValueError) as error:
        way_out = "create the values that it uses within it, or pass them as numbers or text"
        raise InputError(model.name, [Fault("functions", str(error), "functions that pickle", way_out)]) from error


@contextmanager
def _by_value(functions: Sequence[Callable[..., Any]]) -> Iterator[None]:
    """Pickle functions with their code and what they use of their modules, which workers need not have."""
    with ExitStack() as stack:
        for function in functions:
            name = getattr(getattr(function, "func", function), "__module__", None) or ""  # `func` of a partial
            known = cloudpickle.list_registry_pickle_by_value()
            if name in sys.modules and name.partition(".")[0] not in (*LIBRARIES, *known, "builtins"):
                cloudpickle.register_pickle_by_value(sys.modules[name])
                stack.callback(cloudpickle.unregister_pickle_by_value, sys.modules[name])
        yield


# -- on a worker -------------------------------------------------------------------------------------------------------

_one = threading.Lock()  # rows of a process are run one at a time: CasADi holds Python's lock, threads gain nothing


class _Cancelled:
    """Flag of the task that a thread of a worker is doing: whether nobody wants it any more."""

    def __init__(self) -> None:
        self._worker = get_worker()
        self._key = self._worker.get_current_task()

    @property
    def value(self) -> bool:
        task = self._worker.state.tasks.get(self._key)
        return task is None or task.state == "cancelled"


def _do(packed: bytes, task: Task) -> tuple[Row, bool]:
    """Run a row; return it and whether compiled. Raises InputError."""
    with _one:
        job = _opened(packed)
        job.stop = _Cancelled()
        try:
            (row,) = job.do(task)
            return row, job.compiled
        except KeyboardInterrupt as interrupt:  # of a task that was cancelled; itself it would end the worker
            raise Reschedule from interrupt


@lru_cache(maxsize=4)
def _opened(packed: bytes) -> Job:
    """Return a job that was sent, built and compiled; raises InputError where it cannot be."""
    here, content = pickle.loads(packed)
    worker = get_worker().address
    if faults := _differing(worker, here, in_use()):  # of one that came later
        raise InputError("cluster", faults)
    try:
        job: Job = pickle.loads(content)
    except Exception as error:  # of own functions: what they import is not there
        expected = "a worker that has what the functions import"
        actual = f"{type(error).__name__}: {error}"
        raise InputError("cluster", [Fault(f"worker {worker}", actual, expected)]) from error
    job.prepare()
    return job
