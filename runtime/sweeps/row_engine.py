"""Engine of a batch: workers that do its tasks, wherever they are.

sweeps/processes    on this machine
sweeps/cluster      on many, by Dask
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from typing import Protocol

from hertzwerk.runtime.sweeps.row_job import Job, Task
from hertzwerk.runtime.sweeps.sweep_table import Row


class RowEngine(Protocol):
    """Workers side by side, and the rows they make.

    workers    how many there are
    """

    workers: int

    def rows(self, job: Job, tasks: Sequence[Task]) -> Generator[Row, None, None]:
        """Yield the rows as they are done; close it to end what is under way.

        A task whose worker died is done again, and lost where that repeats itself though it ran alone. Raises
        InputError for input that is bad for every row, and KeyboardInterrupt.
        """
