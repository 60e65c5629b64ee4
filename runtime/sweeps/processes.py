"""Rows on all cores of this machine: each is done although processes die, and Ctrl-C ends them all."""

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
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    Executor,
    Future,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
    wait,
)
from functools import partial
from itertools import islice
from typing import Any

from hertzwerk.runtime.host.heap import keep_freed
from hertzwerk.runtime.host.side_by_side import cores
from hertzwerk.runtime.sweeps.kept.row import Row
from hertzwerk.runtime.sweeps.row_engine import every_row
from hertzwerk.runtime.sweeps.row_job import Job, LocalFlag, Task, Tasks

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

        A single task has a process of its own too, unless one worker was asked for: it may be the one that dies.
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

    Processes are forked where that is safe, and share the model's functions; started as `multiprocessing` was told to,
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
