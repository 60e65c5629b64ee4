"""Job of a batch: what is the same for all of its rows, and each row from its values."""

from __future__ import annotations

import importlib
import math
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import reduce
from itertools import islice
from operator import or_
from typing import Any, Protocol, TypeAlias

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.engine.inputs.inputs_by_row import NO_CHOICES, Choices, numbers_of
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.built_engine import prepare
from hertzwerk.runtime.engine.run.run_request import Settings
from hertzwerk.runtime.engine.sensitivity.output_derivatives import NoDerivativeError
from hertzwerk.runtime.engine.solution.step_observers import Findings, Needs
from hertzwerk.runtime.engine.start.start_values import split_values
from hertzwerk.runtime.simulation import Solution, solving
from hertzwerk.runtime.studies.sweeps.rows.row import LOST, Packed, Row
from hertzwerk.runtime.studies.sweeps.rows.row_arrays import RowArrays, Times
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import Measured, NotANumberError, Output, derived_by, named
from hertzwerk.runtime.system.lazy import cached_property
from hertzwerk.runtime.system.stages import Stages, in_stages

# outcomes of rows without a run or some of its numbers
BAD_INPUT, BAD_OUTPUT, NO_NUMBER, FAILED = "bad_input", "bad_output", "output_no_number", "failed"
NO_DERIVATIVE = "no_derivative"
PROBE = 0.3  # s: longest trial run, from which the time of all is estimated

Own: TypeAlias = Callable[[Solution], float]
Task: TypeAlias = tuple[int, Mapping[str, Value]]
"""Number of a row, and the values in place of the model's: parameters, initial states, inputs."""


class Tasks:
    """Tasks in their order, made as they are taken.

    count    how many they are, about
    """

    def __init__(self, made: Iterable[Task], count: int = 0) -> None:
        self._made, self._drawn, self._count = iter(made), deque[Task](), count

    def __bool__(self) -> bool:
        self._drawn.extend(islice(self._made, 0 if self._drawn else 1))
        return bool(self._drawn)

    def __len__(self) -> int:
        """Return how many are left, about: at least one where there is any."""
        return max(self._count, int(bool(self)))

    def __iter__(self) -> Iterator[Task]:
        while self:
            yield self.take()

    @property
    def first(self) -> Task:
        """The next one, which stays; raises IndexError where there is none."""
        if not self:
            raise IndexError("no task is left")
        return self._drawn[0]

    def take(self) -> Task:
        """Take the next one; raises IndexError where there is none."""
        task = self.first
        self._drawn.popleft()
        self._count -= 1
        return task


class Flag(Protocol):
    """Flag that runs look at; where it is true they stop."""

    @property
    def value(self) -> int:
        """Whether to stop."""


@dataclass
class LocalFlag:
    """Flag within one process."""

    value: int = 0


@dataclass
class Job:
    """Runs of one model, each a task for the workers of an engine.

    row_arrays    arrays that every row keeps
    choices    what rows choose their inputs among
    foreseen    time [s] that all take uncompiled, on all workers
    compiled    whether they are, once prepared
    """

    model: EngineModel
    settings: Settings
    outputs: list[Output]
    row_arrays: RowArrays | None = None
    foreseen: float = 0.0
    stop: Flag = field(default_factory=LocalFlag)
    compiled: bool = False
    choices: Choices = NO_CHOICES

    def __post_init__(self) -> None:
        self.settings = replace(self.settings, sensitivities=derived_by(self.outputs))

    @cached_property
    def needs(self) -> Needs:
        """Parts of a run that outputs and arrays are computed from."""
        first = Needs.ENDS if self.row_arrays is None else self.row_arrays.needs
        return reduce(or_, (output.needs for output in self.outputs), first)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle outputs by their names, for a process that shares nothing."""
        outputs = [(output.name, output.function) for output in self.outputs]
        return _sent, (self.model, self.settings, outputs, self.row_arrays, self.foreseen, self.stop, self.choices)

    def prepare(self) -> None:
        """Build what all rows need, compiled where that saves time; raises InputError without a compiler."""
        if Needs.SUMS in self.needs:
            importlib.import_module("scipy.special")  # of confidence intervals: once, not in every forked process
        settings = self.settings
        compared = settings.request is not None
        self.compiled = prepare(
            self.model, settings.method, settings.compiled, self.foreseen, self.needs, compared=compared
        )
        self.settings = replace(settings, compiled=self.compiled)

    def do(self, *tasks: Task) -> list[Row]:
        """Run rows, all of them in stages; raises KeyboardInterrupt where they were stopped."""
        made = in_stages([self._running(task) for task in tasks])
        runs = [run[0].engine.findings for run in made if not isinstance(run, Row)]
        try:
            if Needs.STEPS not in self.needs:  # where each run is kept, what is read of it is found then
                Findings.find_impacts(runs)
        except Exception:  # of any of them: each alone says so
            if len(runs) > 1:
                return [row for task in tasks for row in self.do(task)]
        return [self._made(task, run) for task, run in zip(tasks, made, strict=True)]

    def _running(self, task: Task) -> Stages[tuple[Solution, Times | None] | Row]:
        """Run a row in stages; return its run and the times of its arrays, or the row where there is no run."""
        try:
            return (yield from self._solving(task, self.settings, progress=self._poll))
        except Exception as error:  # a row says so: hours of other runs are not lost for it
            return self._without_run(task, error)

    def _made(self, task: Task, run: tuple[Solution, Times | None] | Row) -> Row:
        """Return the row of a run, or the one that is there in its place."""
        try:
            return run if isinstance(run, Row) else self._row(task, *run)
        except Exception as error:  # as above
            return self._without_run(task, error)

    def lost(self, task: Task) -> Row:
        """Return the row of a run whose process died repeatedly."""
        message = "its process died, and died again when the row ran alone; where rows are stored, the next call tries it again"
        return Row(*task, LOST, message, self._values(task))

    def probe(self, left: Tasks, workers: int, later: int = 0) -> Iterator[Row]:
        """Run the first good row for at most PROBE [s] to foresee the uncompiled time of all that follow.

        Yield the rows that are done, taken from `left`.
        """
        while left:
            task = left.first
            try:
                wall_time = min(PROBE, self.settings.wall_time or PROBE)
                settings = replace(self.settings, compiled=False, wall_time=wall_time)
                ((solution, times),) = in_stages([self._solving(task, settings)])
            except Exception as error:  # as in `do`
                yield self._without_run(left.take(), error)
                continue
            whole = solution.outcome.name != "wall_time_limit"
            if whole:
                left.take()
            done = 1.0 if whole else max(solution.engine.t_end / solution.settings.duration, 1e-9)
            wall_s = solution.statistics.wall_s + (solution.error.pilot_s if solution.error is not None else 0.0)
            one = min(wall_s / done, self.settings.wall_time or math.inf)
            self.foreseen = one * math.ceil((len(left) + later) / workers)
            if whole:
                yield self._row(task, solution, times)
            return

    def _solving(
        self, task: Task, settings: Settings, progress: Callable[[float], object] | None = None
    ) -> Stages[tuple[Solution, Times | None]]:
        """Simulate a row in stages; return its run, and the times of its arrays.

        Raises InputError, and KeyboardInterrupt where the run was stopped.
        """
        model, values = self.choices.of(self.model, task[1])
        parameters, initial = split_values(model, values)
        times = None if self.row_arrays is None else self.row_arrays.times(model, parameters)
        if times is not None and Needs.STEPS not in self.needs and len(times.all):
            settings = replace(settings, grid=times.all)
        solution = yield from solving(model, settings, parameters, initial, needs=self.needs, progress=progress)
        if solution.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return solution, times

    def _without_run(self, task: Task, error: Exception) -> Row:
        """Return the row of values without a run."""
        if isinstance(error, InputError):
            outcome, message = BAD_INPUT, "; ".join(str(fault) for fault in error.faults)
        else:
            outcome, message = FAILED, f"{type(error).__name__}: {error}"
        return Row(*task, outcome, message, self._values(task))

    def _poll(self, _: float) -> None:
        if self.stop.value:
            raise KeyboardInterrupt

    def _row(self, task: Task, solution: Solution, times: Times | None) -> Row:
        i, point = task
        outcome, message = solution.outcome.name, "" if solution.outcome.finished else solution.outcome.message
        measured = Measured(solution)
        numbers: dict[str, float] = {}
        for output in self.outputs:
            try:
                numbers.update(zip(output.columns, output.of(measured), strict=True))
            except NotANumberError as error:
                outcome, message = NO_NUMBER, str(error)
            except NoDerivativeError as error:
                if solution.outcome.finished:
                    outcome, message = NO_DERIVATIVE, f"{output.name}: {error}"
            except (Exception, SystemExit) as error:  # a row says so: hours of other runs are not lost for it
                outcome, message = BAD_OUTPUT, f"output {output.name} raised {type(error).__name__}: {error}"
        arrays: Mapping[str, Packed] = {}
        if times is not None:
            try:
                arrays = times.arrays(solution)
            except Exception as error:  # as above
                outcome, message = BAD_OUTPUT, f"section or histories raised {type(error).__name__}: {error}"
        return Row(
            index=i,
            stated=point,
            outcome=outcome,
            message=message,
            values=self._values(task),
            outputs=numbers,
            warnings=solution.warnings,
            wall_s=solution.statistics.wall_s,
            arrays=arrays,
        )

    def _values(self, task: Task) -> dict[str, float]:
        """Return the values of a row in SI."""
        return numbers_of(self.model, task[1])


def _sent(
    model: EngineModel,
    settings: Settings,
    outputs: list[tuple[str, Own | None]],
    row_arrays: RowArrays | None,
    foreseen: float,
    stop: Flag,
    choices: Choices,
) -> Job:
    return Job(model, settings, named(model, outputs), row_arrays, foreseen, stop, choices=choices)


# -- engine of a batch: workers that do its tasks, wherever they are ---------------------------------------------------


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
