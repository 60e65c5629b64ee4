"""Many runs of one model on all cores: a row each in the given order, failed runs included."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Mapping
from contextlib import closing
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.runtime.host.workers import Flag, LocalFlag, cores, results
from hertzwerk.runtime.model.binding import Value, read_state
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.run.engine import prepare
from hertzwerk.runtime.run.request import METHOD, Compiled, Settings
from hertzwerk.runtime.simulation import simulate
from hertzwerk.runtime.solution.solution import Solution
from hertzwerk.runtime.start.start_values import split_values
from hertzwerk.runtime.sweeps.sweep_table import NUMBERS, TEXTS, Row, Sweep, ports

Output = Callable[[Solution], float]
# outcomes of rows without a run or some of its numbers
BAD_INPUT, BAD_OUTPUT, NO_NUMBER, FAILED, LOST = "bad_input", "bad_output", "output_no_number", "failed", "lost"
PROBE = 0.3  # s: longest trial run, from which the time of all is estimated


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
    outputs: Mapping[str, Output] | None = None,
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
    job = _Job(model, sets, settings, dict(outputs or {}))
    most = min(workers or cores(), max(len(sets), 1))
    rows: dict[int, Row] = {}
    interrupted = False
    try:
        foreseen = job.probe(rows, most) if compiled == "auto" else 0.0
        _refuse_arrays(model, rows)
        job.settings["compiled"] = prepare(model, method, compiled, foreseen)
        left = [i for i in range(len(sets)) if i not in rows]
        at_once = min(most, max(len(left), 1))
        with closing(results(job, left, at_once)) as done:  # its workers end here, whatever is raised
            for row in done:
                rows[row.index] = row
                _refuse_arrays(model, rows)
                if progress is not None:
                    progress(len(rows) / len(sets))
    except KeyboardInterrupt:
        interrupted = True
    return Sweep(
        model=model,
        rows=tuple(rows[i] for i in sorted(rows)),
        output_names=tuple(job.outputs),
        interrupted=interrupted,
        workers=most,
        compiled=bool(job.settings.get("compiled")),
        wall_s=time.perf_counter() - began,
    )


@dataclass
class _Job:
    """The runs, each a task for the workers."""

    model: Model
    sets: list[dict[str, Value]]
    settings: dict[str, Any]
    outputs: Mapping[str, Output]
    stop: Flag = field(default_factory=LocalFlag)

    def do(self, i: int) -> Row:
        """Run set i; raises KeyboardInterrupt where it was stopped."""
        try:
            return self._row(i, self._solve(i, progress=self._poll))
        except Exception as error:  # a row says so: hours of other runs are not lost for it
            return self._without_run(i, error)

    def lost(self, i: int) -> Row:
        """Return the row of a run whose process died twice."""
        return Row(i, self.sets[i], LOST, "its process died, and died again where it ran alone")

    def probe(self, rows: dict[int, Row], cores: int) -> float:
        """Run the first good set for at most PROBE [s]; estimate the uncompiled time [s] of the rest."""
        for i in range(len(self.sets)):
            try:
                solution = self._solve(i, compiled=False, wall_time=min(PROBE, self.settings.get("wall_time") or PROBE))
            except Exception as error:  # as in `do`
                rows[i] = self._without_run(i, error)
                continue
            if solution.outcome.name != "wall_time_limit":
                rows[i] = self._row(i, solution)
            done = max(solution.t_end / solution.duration, 1e-9) if i not in rows else 1.0
            wall_s = solution.statistics.wall_s + (solution.error.pilot_s if solution.error is not None else 0.0)
            one = min(wall_s / done, self.settings.get("wall_time") or math.inf)
            return one * math.ceil((len(self.sets) - len(rows)) / cores)
        return 0.0

    def _solve(self, i: int, **options: Any) -> Solution:
        """Simulate set i; raises InputError, and KeyboardInterrupt where the run was stopped."""
        parameters, initial = split_values(self.model, self.sets[i])
        solution = simulate(self.model, parameters=parameters, initial=initial, **{**self.settings, **options})
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
        outputs: dict[str, float] = {}
        for name, output in self.outputs.items():
            try:
                found = output(solution)
                if np.ndim(found):
                    outcome, message = NO_NUMBER, f"output {name} returned an array of shape {np.shape(found)}"
                else:
                    outputs[name] = float(found)
            except (Exception, SystemExit) as error:  # a row says so: hours of other runs are not lost for it
                outcome, message = BAD_OUTPUT, f"output {name} raised {type(error).__name__}: {error}"
        return Row(
            index=i,
            given=self.sets[i],
            outcome=outcome,
            message=message,
            values=self._values(self.sets[i]),
            impacts=len(solution.impacts),
            peak_force=max((impact.peak_force for impact in solution.impacts), default=0.0),
            energy_residual=solution.energy_residual,
            error_estimate=solution.error.end if solution.error is not None else None,
            final=solution.final,
            outputs=outputs,
            warnings=solution.warnings,
            statistics=solution.statistics,
        )

    def _values(self, given: Mapping[str, Value]) -> dict[str, float]:
        """Return the given values in SI."""
        model = self.model
        bound = model.bind({name: value for name, value in given.items() if name in model.parameters})
        return {
            name: bound[name] if name in model.parameters else read_state(name, model.joints.units[name], value)[0]
            for name, value in given.items()
        }


def _refuse_arrays(model: Model, rows: Mapping[int, Row]) -> None:
    """Raise InputError where the first row shows that an output is not a number."""
    first = next(iter(rows.values()), None)
    if len(rows) == 1 and first is not None and first.outcome == NO_NUMBER:
        remedy = 'one number of a history: lambda run: np.ptp(run["guide.travel"]); several are several outputs'
        raise InputError(model.name, [Fault("outputs", first.message, "a number", remedy)])


def _check(model: Model, workers: object, outputs: Mapping[str, Output]) -> None:
    faults = [
        Fault(f"outputs[{name!r}]", repr(output), "a name, and a function of the Solution")
        for name, output in outputs.items()
        if not (isinstance(name, str) and callable(output))
    ]
    if faults:
        raise InputError(model.name, faults)
    if workers is not None and not (isinstance(workers, int) and not isinstance(workers, bool) and workers > 0):
        faults.append(Fault("workers", repr(workers), "a positive whole number", "None takes every core"))
    taken = {*NUMBERS, *TEXTS, *ports(model)}
    faults += [
        Fault(f"outputs[{name!r}]", "the name of another column", "a name of its own")
        for name in outputs
        if name in taken or name.startswith("final.")
    ]
    if faults:
        raise InputError(model.name, faults)
