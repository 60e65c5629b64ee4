"""Engine of a batch: workers that do its tasks, wherever they are.

studies/sweeps/batch        on this machine
studies/sweeps/rows/cluster      on many, by Dask
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from typing import Protocol

from hertzwerk.runtime.studies.sweeps.rows.row import Row
from hertzwerk.runtime.studies.sweeps.rows.row_job import Job, Task, Tasks


class EngineLostError(Exception):
    """No worker is left, nor can there be others."""


class RowEngine(Protocol):
    """Workers side by side, and the rows they make.

    workers    how many there are
    """

    workers: int

    def rows(self, job: Job, tasks: Tasks) -> Generator[list[Row], None, None]:
        """Yield the rows as they are done, some at a time; close it to end what is under way.

        Raises InputError for input that is bad for every row, EngineLostError, and KeyboardInterrupt.
        """


def every_row(
    job: Job, tasks: Tasks, together: Callable[[Tasks, list[Task]], Iterator[list[Row]]]
) -> Iterator[list[Row]]:
    """Yield the rows of all tasks: those that may have killed a worker are run again, each alone.

    together    does tasks side by side, taking them from the first, and leaves in the list those under way when
                a worker died
    """
    while tasks:
        suspects: list[Task] = []
        yield from together(tasks, suspects)
        for task in suspects:
            again: list[Task] = []
            yield from together(Tasks([task]), again)
            if again:
                yield [job.lost(task)]
