"""Tasks done side by side by forked processes, each of which takes the next one when it is free."""

from __future__ import annotations

import multiprocessing
import os
import sys
import warnings
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from multiprocessing.process import BaseProcess

Result = TypeVar("Result")


def cores() -> int:
    """Return the number of cores this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def side_by_side(tasks: Sequence[Callable[[], Result]]) -> dict[int, Result]:
    """Do tasks on all cores in their order, the first in this process; return results by position.

    Results must pickle. The result of a task whose process ended is missing. What a task raises in this process is raised; in another, it
    ends that one. Without processes that can be forked safely, all is done in this one.
    """
    processes = min(cores() if sys.platform.startswith("linux") else 1, len(tasks))
    if processes < 2:
        return {i: task() for i, task in enumerate(tasks)}
    fork = multiprocessing.get_context("fork")
    queue = fork.SimpleQueue()
    for i in (*range(1, len(tasks)), *[None] * processes):
        queue.put(i)

    def taken() -> dict[int, Result]:
        return {i: tasks[i]() for i in iter(queue.get, None)}

    def begun() -> tuple[BaseProcess, Connection]:
        results, end = fork.Pipe(duplex=False)
        with (
            end,
            warnings.catch_warnings(),
        ):  # Python 3.12 and later warn of threads when forking: NumPy's see to themselves
            warnings.simplefilter("ignore", DeprecationWarning)
            process = fork.Process(target=lambda: end.send(taken()))
            process.start()
        return process, results

    others, done = [begun() for _ in range(processes - 1)], {}
    try:
        done = {0: tasks[0](), **taken()}
    finally:
        for process, results in others:
            with results, suppress(EOFError, OSError):  # of one that ended before
                done |= results.recv()
            process.join()
    return done
