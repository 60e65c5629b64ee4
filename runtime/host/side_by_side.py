"""Tasks done side by side by forked processes, each of which takes the next one when it is free."""

from __future__ import annotations

import os
import pickle
import sys
import warnings
from collections.abc import Callable, Sequence
from typing import TypeVar

Result = TypeVar("Result")
_WIDTH = 2  # bytes of a task's number


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
    queue, end = os.pipe()
    os.write(end, b"".join(i.to_bytes(_WIDTH) for i in range(1, len(tasks))))
    os.close(end)
    found: list[dict[int, Result]] = []
    others = [_forked(queue, tasks) for _ in range(processes - 1)]
    try:
        done = {0: tasks[0](), **_taken(queue, tasks)}
    finally:
        os.close(queue)
        found += [_result(*other) for other in others]
    return {i: result for results in (done, *found) for i, result in results.items()}


def _taken(queue: int, tasks: Sequence[Callable[[], Result]]) -> dict[int, Result]:
    """Do tasks from the queue until it is empty."""
    done: dict[int, Result] = {}
    while number := os.read(queue, _WIDTH):
        i = int.from_bytes(number)
        done[i] = tasks[i]()
    return done


def _forked(queue: int, tasks: Sequence[Callable[[], Result]]) -> tuple[int, int]:
    """Begin a process that does tasks; return its number and a pipe for its results."""
    results, end = os.pipe()
    with warnings.catch_warnings():  # Python 3.12 and later warn of threads when forking: NumPy's see to themselves
        warnings.simplefilter("ignore", DeprecationWarning)
        child = os.fork()
    if child:
        os.close(end)
        return child, results
    try:
        with os.fdopen(end, "wb") as stream:
            pickle.dump(_taken(queue, tasks), stream)
    finally:
        os._exit(0)  # without the exit of the process that was forked: what it would flush is not ours


def _result(child: int, results: int) -> dict[int, Result]:
    """Wait for a process; return its results, none if it ended before."""
    with os.fdopen(results, "rb") as stream:
        content = stream.read()
    os.waitpid(child, 0)
    try:
        found: dict[int, Result] = pickle.loads(content)
    except (EOFError, pickle.UnpicklingError):
        return {}
    return found
