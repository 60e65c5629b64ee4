"""Many runs of one model on all cores: a row each in the given order, failed runs included."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field, replace
from functools import reduce
from operator import or_
from typing import Any

from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.derive.units import parse_unit
from hertzwerk.runtime.host.lazy import cached_property
from hertzwerk.runtime.host.workers import Flag, LocalFlag, cores, results
from hertzwerk.runtime.model.binding import Value, read_state
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.run.engine import prepare
from hertzwerk.runtime.run.request import METHOD, Compiled, Settings
from hertzwerk.runtime.simulation import solve
from hertzwerk.runtime.solution.findings import Needs
from hertzwerk.runtime.solution.outcome import Outcome
from hertzwerk.runtime.solution.solution import Solution
from hertzwerk.runtime.start.start_values import split_values
from hertzwerk.runtime.sweeps.row_outputs import Measured, NotANumberError, Output, finals, named, of_every_run, own
from hertzwerk.runtime.sweeps.sweep_table import COMPLETE, TEXTS, Row, Sweep, columns_of

Own = Callable[[Solution], float]
# outcomes of rows without a run or some of its numbers
BAD_INPUT, BAD_OUTPUT, NO_NUMBER, FAILED, LOST = "bad_input", "bad_output", "output_no_number", "failed", "lost"
PROBE = 0.3  # s: longest trial run, from which the time of all is estimated
INTERRUPTED = Outcome("interrupted", "stopped by the user", "the rows that were done are there")


def _sets(given: object) -> list[dict[str, Value]]:
    """Return the sets of values; raises InputError for malformed ones."""
    expected = 'mappings of values by name, such as [{"clearance": "0.2 mm"}, {"clearance": "0.4 mm"}]'
    if isinstance(given, str | Mapping) or not isinstance(given, Iterable):
        raise InputError("simulate_many", [Fault("parameter_sets", shown(given), expected)])
    rows = list(given)
    faults = [
        Fault(f"parameter_sets, row {i}", shown(row), expected)
        for i, row in enumerate(rows)
        if not isinstance(row, Mapping)
    ]
    if faults:
        raise InputError("simulate_many", faults)
    return [dict(row) for row in rows]


def simulate_many(
    model: Model,
    parameter_sets: Iterable[Mapping[str, Value]],
    *,
    duration: str | float | None = None,
    accuracy: float | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    compiled: Compiled = "auto",
    workers: int | None = None,
    outputs: Mapping[str, Own] | None = None,
    progress: Callable[[float], object] | None = None,
    **limits: Any,
) -> Sweep:
    """Run a model once for each set of values, on all cores.

    Each run is bitwise the one that `simulate` makes.

    parameter_sets    values in place of the model's, parameters and initial states alike: [{"clearance": "0.2 mm"}, ...]
    compiled    "auto" compiles once for all where that saves time; duration, accuracy or tolerance, method, and limits as in `simulate`
    workers    processes, by default as many as there are cores (threads where processes cannot be forked: correct, slower)
    outputs    further columns, each a function of the Solution: {"stroke": lambda run: np.ptp(run["guide.travel"])}
    progress    called now and then with the fraction of runs done

    Bad input of a set, a run that does not finish or fails, an output that raises or exits give rows with that
    outcome. Raises InputError for input that is bad for every run; an output that is not a number is found in the
    first row. Ctrl-C returns the rows that are done.
    """
    began = time.perf_counter()
    sets = _sets(parameter_sets)
    if not (outputs is None or isinstance(outputs, Mapping)):
        raise InputError(model.name, [Fault("outputs", shown(outputs), "a dictionary of functions of the Solution")])
    Settings(duration, accuracy, tolerance, method, compiled, **limits).check(model)
    _check(model, workers, outputs or {})
    settings = {"duration": duration, "accuracy": accuracy, "tolerance": tolerance, "method": method, **limits}
    wanted = [
        *of_every_run(model),
        *(own(name, function) for name, function in (outputs or {}).items()),
        *finals(model),
    ]
    units = ports(model)
    varied = {name: units[name] for name in dict.fromkeys(name for values in sets for name in values) if name in units}
    results = {name: unit for output in wanted for name, unit in output.columns.items()}
    batch = Batch(model, sets, settings, wanted, compiled, workers)
    rows: dict[int, Row] = {}
    interrupted = False
    try:
        with closing(batch.rows(range(len(sets)))) as done:  # its workers end here, whatever is raised
            for row in done:
                rows[row.index] = row
                if progress is not None:
                    progress(len(rows) / len(sets))
    except KeyboardInterrupt:
        interrupted = True
    return Sweep(
        scene=model.name,
        rows=tuple(rows[i] for i in sorted(rows)),
        columns=columns_of(varied, {**results, "wall_s": "s"}),
        varied=tuple(varied),
        outcome=INTERRUPTED if interrupted else COMPLETE,
        workers=batch.workers,
        compiled=batch.compiled,
        wall_s=time.perf_counter() - began,
    )


class Batch:
    """Runs of one model, each a row.

    sets    values of every row, parameters and initial states alike
    settings    arguments of `simulate` for all of them
    compiled    as asked for; once rows were made, whether they are
    workers    processes
    """

    def __init__(
        self,
        model: Model,
        sets: Sequence[Mapping[str, Value]],
        settings: Mapping[str, Any],
        outputs: Sequence[Output],
        compiled: Compiled,
        workers: int | None,
    ) -> None:
        asked = Settings(**settings, compiled=compiled)
        self._job = _Job(model, [dict(values) for values in sets], asked, list(outputs))
        self._asked = compiled
        self.workers = min(workers or cores(), max(len(sets), 1))
        self.compiled = False

    def rows(self, wanted: Sequence[int]) -> Generator[Row, None, None]:
        """Yield the rows of these sets as they are done; close it to end the workers.

        Raises InputError for input that is bad for every run, or where the first row shows that an output is not a
        number, and KeyboardInterrupt.
        """
        job, left = self._job, deque(wanted)
        if self._asked == "auto":
            yield from _first_a_number(job, job.probe(left, self.workers))
        self.compiled = prepare(job.model, job.settings.method, self._asked, job.foreseen, job.needs)
        job.settings = replace(job.settings, compiled=self.compiled)
        with closing(results(job, list(left), min(self.workers, max(len(left), 1)))) as done:
            yield from _first_a_number(job, done)


@dataclass
class _Job:
    """The runs, each a task for the workers."""

    model: Model
    sets: list[dict[str, Value]]
    settings: Settings
    outputs: list[Output]
    stop: Flag = field(default_factory=LocalFlag)
    foreseen: float = 0.0
    begun: bool = False

    @cached_property
    def needs(self) -> Needs:
        """Parts of a run that the outputs are computed from."""
        return reduce(or_, (output.needs for output in self.outputs), Needs.ENDS)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle outputs by their names, for a process that shares nothing."""
        outputs = [(output.name, output.function) for output in self.outputs]
        return _sent, (self.model, self.sets, self.settings, outputs, self.stop)

    def do(self, i: int) -> Row:
        """Run set i; raises KeyboardInterrupt where it was stopped."""
        try:
            return self._row(i, self._solve(i, self.settings, progress=self._poll))
        except Exception as error:  # a row says so: hours of other runs are not lost for it
            return self._without_run(i, error)

    def lost(self, i: int) -> Row:
        """Return the row of a run whose process died twice."""
        return Row(i, self.sets[i], LOST, "its process died, and died again where it ran alone")

    def probe(self, left: deque[int], cores: int) -> Iterator[Row]:
        """Run the first good set for at most PROBE [s] to foresee the uncompiled time [s] of the rest.

        Yield the rows that are done, taken from `left`.
        """
        while left:
            i = left[0]
            try:
                wall_time = min(PROBE, self.settings.wall_time or PROBE)
                solution = self._solve(i, replace(self.settings, compiled=False, wall_time=wall_time))
            except Exception as error:  # as in `do`
                left.popleft()
                yield self._without_run(i, error)
                continue
            whole = solution.outcome.name != "wall_time_limit"
            if whole:
                left.popleft()
            done = 1.0 if whole else max(solution.t_end / solution.duration, 1e-9)
            wall_s = solution.statistics.wall_s + (solution.error.pilot_s if solution.error is not None else 0.0)
            one = min(wall_s / done, self.settings.wall_time or math.inf)
            self.foreseen = one * math.ceil(len(left) / cores)
            if whole:
                yield self._row(i, solution)
            return

    def _solve(self, i: int, settings: Settings, progress: Callable[[float], object] | None = None) -> Solution:
        """Simulate set i; raises InputError, and KeyboardInterrupt where the run was stopped."""
        values = split_values(self.model, self.sets[i])
        solution = solve(self.model, settings, *values, needs=self.needs, progress=progress)
        if solution.outcome.name == "interrupted":
            raise KeyboardInterrupt
        return solution

    def _without_run(self, i: int, error: Exception) -> Row:
        """Return the row of a set without a run."""
        if isinstance(error, InputError):
            return Row(i, self.sets[i], BAD_INPUT, "; ".join(str(fault) for fault in error.faults))
        return Row(i, self.sets[i], FAILED, f"{type(error).__name__}: {error}")

    def _poll(self, _: float) -> None:
        if self.stop.value:
            raise KeyboardInterrupt

    def _row(self, i: int, solution: Solution) -> Row:
        outcome, message = solution.outcome.name, "" if solution.outcome.finished else solution.outcome.message
        measured = Measured(solution)
        numbers: dict[str, float] = {}
        for output in self.outputs:
            try:
                numbers.update(zip(output.columns, output.of(measured), strict=True))
            except NotANumberError as error:
                outcome, message = NO_NUMBER, str(error)
            except (Exception, SystemExit) as error:  # a row says so: hours of other runs are not lost for it
                outcome, message = BAD_OUTPUT, f"output {output.name} raised {type(error).__name__}: {error}"
        return Row(
            index=i,
            given=self.sets[i],
            outcome=outcome,
            message=message,
            values=self._values(self.sets[i], solution),
            outputs=numbers,
            warnings=solution.warnings,
            wall_s=solution.statistics.wall_s,
        )

    def _values(self, given: Mapping[str, Value], solution: Solution) -> dict[str, float]:
        """Return the given values in SI."""
        found = {}
        for name, value in given.items():
            if name in solution.parameters:
                number, unit = solution.parameters[name]
                found[name] = parse_unit(unit).to_si(number)
            else:
                found[name], _ = read_state(name, self.model.joints.units[name], value)
        return found


def _sent(
    model: Model,
    sets: list[dict[str, Value]],
    settings: Settings,
    outputs: list[tuple[str, Own | None]],
    stop: Flag,
) -> _Job:
    return _Job(model, sets, settings, named(model, outputs), stop)


def _first_a_number(job: _Job, rows: Iterable[Row]) -> Iterator[Row]:
    """Yield rows; raise InputError where the first of all shows that an output is not a number."""
    for row in rows:
        if not job.begun and row.outcome == NO_NUMBER:
            remedy = 'one number of a history: lambda run: np.ptp(run["guide.travel"]); several are several outputs'
            raise InputError(job.model.name, [Fault("outputs", row.message, "a number", remedy)])
        job.begun = True
        yield row


def _check(model: Model, workers: object, outputs: Mapping[str, Own]) -> None:
    faults = [
        Fault(f"outputs[{name!r}]", repr(output), "a name, and a function of the Solution")
        for name, output in outputs.items()
        if not (isinstance(name, str) and callable(output))
    ]
    if faults:
        raise InputError(model.name, faults)
    if workers is not None and not (isinstance(workers, int) and not isinstance(workers, bool) and workers > 0):
        faults.append(Fault("workers", repr(workers), "a positive whole number", "None takes every core"))
    taken = {*TEXTS, *ports(model), "wall_s", *(name for output in of_every_run(model) for name in output.columns)}
    faults += [
        Fault(f"outputs[{name!r}]", "the name of another column", "a name of its own")
        for name in outputs
        if name in taken or name.startswith("final.")
    ]
    if faults:
        raise InputError(model.name, faults)


def ports(model: Model) -> dict[str, str]:
    """Return the SI unit text of every parameter and state that a set may name."""
    declared = {**{name: port.unit for name, port in model.parameters.items()}, **model.joints.units, **model.units}
    return {name: si_text(unit) for name, unit in declared.items()}


def si_text(unit: str) -> str:
    """Return the text of a unit's SI unit, angles named: mm -> m, rpm -> rad/s, "" for a number."""
    read = parse_unit(unit)
    text = str(read)
    if read.angle == 1:
        return text.replace("1", "rad", 1)
    return "" if text == "1" else text
