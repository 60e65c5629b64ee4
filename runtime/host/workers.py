"""Numbered tasks on all cores: each is done although workers die, and Ctrl-C ends them all."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import sys
import threading
import warnings
from collections import deque
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
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

# One pool at a time: a process forked while another pool is used would share its pipes, and outlive it.
_pool = threading.Lock()
AHEAD = 2  # tasks submitted per worker: keeps it busy, and few are lost if it dies

Result = TypeVar("Result")
Returned = TypeVar("Returned", covariant=True)


class Flag(Protocol):
    """Flag shared by workers; set to 1 it stops them."""

    value: int


@dataclass
class LocalFlag:
    """Flag within one process."""

    value: int = 0


class Job(Protocol[Returned]):
    """Tasks, and the flag `stop` that they check; forked processes inherit them, others are sent a pickle."""

    stop: Flag

    def do(self, i: int) -> Returned:
        """Do task i; raises KeyboardInterrupt where it was stopped."""

    def lost(self, i: int) -> Returned:
        """Return the result of task i if its process died, and died again where it ran alone."""


def results(job: Job[Result], left: list[int], workers: int) -> Generator[Result, None, None]:
    """Yield results as completed; tasks that may have killed a process are run again, each alone."""
    waiting = deque(left)
    while waiting and workers > 1:
        suspects: list[int] = []
        with _pool:
            yield from _together(job, waiting, workers, suspects)
        for i in suspects:
            again: list[int] = []
            with _pool:
                yield from _together(job, deque([i]), 1, again)
            if again:
                yield job.lost(i)
    for i in waiting:
        yield job.do(i)


def _together(job: Job[Result], waiting: deque[int], workers: int, suspects: list[int]) -> Iterator[Result]:
    """Yield results as completed, until all are or a process dies.

    `suspects` then holds the tasks in progress. Stops the workers when left.
    """
    under_way: dict[Future[Result], int] = {}
    executor, do = _executor(job, workers)
    try:
        while not suspects and (waiting or under_way):
            while not suspects and waiting and len(under_way) < AHEAD * workers:
                i = waiting.popleft()
                try:
                    # Python 3.12 and later warn of threads when forking: NumPy's see to themselves.
                    with warnings.catch_warnings():
                        warnings.simplefilter("ignore", DeprecationWarning)
                        under_way[executor.submit(do, i)] = i
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


def _executor(job: Job[Result], workers: int) -> tuple[Executor, Callable[[int], Result]]:
    """Return an executor of processes, or of threads where there can be none.

    Processes are forked where that is safe, and share the model's functions; started as `multiprocessing` was told to,
    they build their own. CasADi holds Python's lock, so threads gain little.
    """
    start = multiprocessing.get_start_method(allow_none=True) or ("fork" if sys.platform.startswith("linux") else None)
    if start is None or (start != "fork" and not _pickles(job)):
        return ThreadPoolExecutor(workers), job.do
    context: Any = multiprocessing.get_context(start)
    job.stop = context.Value("b", 0, lock=False)
    return ProcessPoolExecutor(workers, context, _enter, (job,)), _do


def _pickles(job: Job[Any]) -> bool:
    try:
        pickle.dumps(job)
    except (pickle.PicklingError, AttributeError, TypeError):  # a lambda is any of these
        return False
    return True


_job: Job[Any] | None = None  # of a worker process


def _enter(job: Job[Any]) -> None:
    global _job, _pool
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C reaches every process; the first one tells the others
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _job, _pool = job, threading.Lock()  # the one that was forked is held


def _end_with_parent() -> None:
    """End a worker whose parent was killed."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


def _do(i: int) -> Any:
    if _job is None:
        raise TypeError("a worker without a job")
    return _job.do(i)


def cores() -> int:
    """Return the number of cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
