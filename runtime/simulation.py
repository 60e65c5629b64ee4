"""Pipeline of a run: model and numbers -> bound -> start -> run -> solution.

1. model     a generated module, loaded; its functions are built once                         loading, model/
2. bound     parameters in SI, and everything else requested, read and checked                engine/run/run_request
3. start     positions and speeds with loops closed, journals seated                          start/
4. run       the engine of model and method, its accepted steps                               engine/run/single_run, integrate/
             for an accuracy as many runs as it takes to know the error of one                engine/run/accurate_run, accuracy/
5. solution  histories, impacts, balance, outcome, warnings                                   solution/
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from hertzwerk.derive.common.faults import Fault, InputError, as_path
from hertzwerk.runtime.engine.accuracy.error_estimate import LadderResult
from hertzwerk.runtime.engine.inputs.input_values import Input, with_input_values
from hertzwerk.runtime.engine.integration.step.layout import FINISHED
from hertzwerk.runtime.engine.model import model as plain
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.model import BoundParameters
from hertzwerk.runtime.engine.run.accurate_run import run_to_accuracy, verdict_of
from hertzwerk.runtime.engine.run.continuation import REPEATABLE, parameters_of, resumable, with_steps
from hertzwerk.runtime.engine.run.output_times import Grid
from hertzwerk.runtime.engine.run.run_request import (
    METHOD,
    Accuracy,
    Compiled,
    Request,
    Settings,
    progress_faults,
    read,
    steps_faults,
)
from hertzwerk.runtime.engine.run.run_warnings import (
    floored,
    open_forces,
    released,
    too_fast,
    unchecked,
    uncompiled,
    unsettled,
)
from hertzwerk.runtime.engine.run.single_run import SingleRun, Trace, set_up
from hertzwerk.runtime.engine.solution import solution as plain_solution
from hertzwerk.runtime.engine.solution.checkpoint import checkpoint_of
from hertzwerk.runtime.engine.solution.dense_output import Extremes, Samples
from hertzwerk.runtime.engine.solution.error_scales import Scales
from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.engine.solution.outcome import not_closed
from hertzwerk.runtime.engine.solution.solution import EngineRun, RunSettings, Statistics
from hertzwerk.runtime.engine.solution.step_observers import Needs
from hertzwerk.runtime.engine.start.start_values import stated_values
from hertzwerk.runtime.loading import Target, engine_model
from hertzwerk.runtime.output.tables import notebook
from hertzwerk.runtime.output.tables.data_frame import data_frame
from hertzwerk.runtime.output.tables.dataset import dataset
from hertzwerk.runtime.output.tables.history_table import history_table
from hertzwerk.runtime.output.tables.table_file import write_table
from hertzwerk.runtime.system.stages import Stages, in_stages

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame
    from xarray import Dataset

    from hertzwerk.runtime.engine.sensitivity.lyapunov import Lyapunov
    from hertzwerk.runtime.engine.sensitivity.sensitivities import Sensitivities

ACCURACY = Request(1e-6)  # where none is requested


def simulate(
    target: Target,
    *,
    duration: str | float | None = None,
    accuracy: Accuracy | None = None,
    tolerance: float | None = None,
    method: str = METHOD,
    parameters: Mapping[str, Value] | None = None,
    initial: Mapping[str, Value] | None = None,
    inputs: Mapping[str, Input] | None = None,
    grid: Grid = None,
    compiled: Compiled = "auto",
    max_steps: int | None = None,
    max_events: int | None = None,
    wall_time: float | None = None,
    sensitivities: Sequence[str] = (),
    progress: Callable[[float], object] | None = None,
) -> Solution:
    """Run a scene from its start for a duration (seconds, or text such as "24 ms", "2 rev").

    target      a built-in scene's name, a Python file, a Scene, or a Model; `load` varies it
    accuracy    largest error of the whole run, in the scene's scales, 1e-12..1e-1, by default 1e-6; "1e-6 at the end" limits the error at the end
                alone. Runs at decreasing tolerance are made until the error of one is below the request, by comparison with a tighter one.
                `Solution.error` is the estimate. The outcome is "accuracy_unreachable" or "beyond_horizon" where it exceeds the request,
                "accuracy_unknown" where it is unknown
    tolerance   local tolerance, 1e-13..1e-1, of one run without an error estimate, in place of an accuracy
    method      "auto": dop853, and esdirk where stability limits the step; explicit "dop853", "dopri5"; for stiff equations "esdirk", "rodas";
                "cvodes", "idas": SUNDIALS, slow, an independent reference
    parameters  values that replace the scene's, with units: {"clearance": "0.2 mm", "guide.travel": "0.17 m"}; initial states are allowed too
    initial     initial states, such as an equilibrium
    inputs      values of the scene's inputs: {"torque": "0.5 N m"}, two arrays (times, values) in s and the input's unit, `Samples` (held, linear or
                cubic, with units), "FILE.csv:column", a `Table`, or a function of the time, which is sampled to 1e-10. A step ends at every
                sample, and the values between samples are met exactly
    grid        states to keep: None, every accepted step; a number of points, start and end included (1000); a spacing ("0.1 ms"); or times [s].
                Dense output of the method's order evaluates them, and memory does not grow with the run
    compiled    run the same functions as C, with bitwise the same result; "auto" compiles where the remaining time exceeds the compilation
    max_steps (accepted; as many may be rejected), max_events (contacts begun) of each run, wall_time [s] of the call, compilation included: limits,
                each with an outcome of its own. Without max_steps a run ends as "stalled" where its steps make hardly any progress
    sensitivities    parameters and initial states: `run.sensitivities()["slider_pin.normal_force", "restitution"]` is then a history,
                computed after the run, from its steps
    progress    a function that is called now and then with the fraction done

    Invalid input raises InputError with every fault. Nothing else raises: `Solution.outcome` states how the run ended. An exception during the run,
    such as exhausted memory or one of `progress`, ends it with the outcome "exception" once a step was accepted; before that it is raised.
    """
    settings = Settings(
        duration,
        accuracy,
        tolerance,
        method,
        compiled,
        grid,
        max_steps=max_steps,
        max_events=max_events,
        wall_time=wall_time,
        sensitivities=sensitivities,
    )
    model, faults = engine_model(target), progress_faults(progress)
    values = stated_values(model, parameters, initial, faults)
    return solve(model, settings, *values, inputs, before=faults, progress=progress)


def solve(
    model: plain.EngineModel,
    settings: Settings,
    parameters: Mapping[str, Value],
    initial: Mapping[str, Value],
    inputs: Mapping[str, Input] | None = None,
    *,
    before: Sequence[Fault] = (),
    needs: Needs = Needs.STEPS,
    progress: Callable[[float], object] | None = None,
) -> Solution:
    """Run a model as `simulate` does, finding no more than is needed.

    The solution raises LookupError where more is requested.
    """
    stages = solving(model, settings, parameters, initial, inputs, before=before, needs=needs, progress=progress)
    return in_stages([stages])[0]


def solving(
    model: plain.EngineModel,
    settings: Settings,
    parameters: Mapping[str, Value],
    initial: Mapping[str, Value],
    inputs: Mapping[str, Input] | None = None,
    *,
    before: Sequence[Fault] = (),
    needs: Needs = Needs.STEPS,
    progress: Callable[[float], object] | None = None,
) -> Stages[Solution]:
    """Run a model as `solve` does, in stages: up to its start, the run, its solution."""
    began = time.perf_counter()
    # 2. bound, 3. start
    model, faults = with_input_values(model, inputs, settings.duration, parameters)
    run_inputs, times = read(model, settings, parameters, initial, [*before, *faults])
    # 4. run
    run = set_up(model, settings, run_inputs, needs=needs, began=began)
    tolerance, request = settings.tolerance, settings.request or ACCURACY
    scales = run.scales(tolerance)
    build_s = time.perf_counter() - began
    yield
    if settings.wall_time is not None:  # other runs have been made meanwhile
        run = replace(run, deadline=time.perf_counter() + settings.limits.wall_time - build_s)
    if tolerance is not None:
        trace = run.trace(tolerance, scales, times, progress=progress)
        yield
        # 5. solution
        solution = _solution_of(run, trace, scales, build_s)
    else:
        ladder_result = run_to_accuracy(run, scales, times, request, progress)
        yield
        solution = _solution_of(run, ladder_result.run.data, scales, build_s, request, ladder_result)
    return _with_derivatives(solution, settings.sensitivities)


def _with_derivatives(run: Solution, names: Sequence[str]) -> Solution:
    """Return a run with its derivatives by some names, or with a warning that says why not."""
    if not names:
        return run
    try:
        engine = replace(run.engine, derivatives=run.sensitivities(*names))
    except InputError as error:
        reason = "; ".join(f"no derivatives: {fault.found}. {fault.remedy}" for fault in error.faults)
        engine = run.engine.with_warning(reason)
    return replace(run, engine=engine)


def _solution_of(
    run: SingleRun,
    trace: Trace,
    scales: Scales,
    build_s: float,
    request: Request | None = None,
    ladder_result: LadderResult[Trace] | None = None,
) -> Solution:
    """Return the solution of a kept run; for an accuracy with the verdict of those that checked it."""
    model, bound, counted = run.model, run.request.bound, trace.counted
    if trace.ending.error is not None and not counted["steps"]:
        raise trace.ending.error
    warnings: tuple[str, ...] = ()
    result = run.outcome(trace)
    if ladder_result is not None and request is not None:
        result, warnings = verdict_of(run, ladder_result, request, result)
    if trace.ending.status == FINISHED and trace.balance is not None:
        result = (
            not_closed(
                trace.balance.unclosed, request.error if request else trace.tolerance, trace.tolerance, counted["steps"]
            )
            or result
        )
    return Solution(
        engine=EngineRun(
            history=trace.recorded.history,
            ends=trace.recorded.ends,
            findings=trace.findings,
            scales=scales,
            checkpoint=checkpoint_of(model, trace.ending, run.request.initial),
            known_warnings=(
                *unchecked(model),
                *open_forces(model, bound, run.request.q),
                *(
                    (*run.request.warnings, *released(model, trace.recorded.ends))
                    if run.start is None
                    else bound.warnings
                ),
                *floored(counted["floored"], run.floor),
                *unsettled(counted["unsettled"]),
                *too_fast(model, run.request.speed_limits, trace.tally),
                *uncompiled(run.engine.code),
                *warnings,
            ),
        ),
        outcome=result,
        settings=RunSettings(
            duration=run.request.seconds,
            accuracy=None if request is None else request.error,
            tolerance=trace.tolerance,
            method=run.method,
            compiled=trace.compiled,
            parameters=dict(bound.values),
        ),
        statistics=Statistics(
            steps=counted["steps"],
            rejected=counted["rejected"],
            retaken=counted["retaken"],
            rhs_evaluations=counted["evaluations"],
            events=counted["events"],
            wall_s=trace.ending.wall_s - trace.compile_s - trace.build_s,
            build_s=build_s + trace.build_s,
            compile_s=trace.compile_s,
        ),
        energy_residual=None if trace.balance is None else trace.balance.residual,
        error=None if ladder_result is None else ladder_result.error,
    )


@dataclass(frozen=True, repr=False, eq=False)
class Solution(plain_solution.EngineSolution):
    """Result of `simulate`: outcome, histories, derivatives, plots and drawings of a run."""

    def extremes(self, name: str) -> Extremes:
        """Return the minimum and the maximum of a history, and their times, found within the steps.

        As a sweep's `.min` and `.max`: `run[name]` has values at the steps alone, which may be some per cent lower.
        Raises KeyError for an unknown name, ValueError for a run that kept a grid or was saved.
        """
        return Samples(self).extremes(name)

    def continued(
        self,
        duration: str | float | None = None,
        *,
        target: Target | None = None,
        grid: Grid = None,
        compiled: Compiled = "auto",
        max_steps: int | None = None,
        max_events: int | None = None,
        wall_time: float | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> Solution:
        """Continue from the end of this run as if it had not ended there.

        With its model, parameters, start, method and tolerance.

        duration    of the whole motion from its start, longer than the run reached; by default the duration requested before
        target    the scene or the Model of a saved run, which has no functions: "slider_crank"
        grid    as of `simulate`: of one over the whole motion the part that is left
        max_steps, max_events, wall_time    of this run alone

        The result begins at t_start = `engine.t_start`, the last step that did not depend on where the run before ended: a step or two
        before that end, whose last ones were cut to arrive there. Where steps are kept, those of the run before with
        t < t_start and these are bitwise those of one run of that duration at that tolerance; steps as long as a
        tenth of the shorter duration, the longest in contact, are the exception. Impacts, energy balance, statistics
        and averages are of this part; a contact in progress at its start is listed in both, here from there on. There
        is no estimate of the error, neither of the part nor of the whole: it would take the runs that checked the one
        before as well.

        Raises InputError, with every fault.
        """
        began = time.perf_counter()
        live = self.engine.model if target is None else engine_model(target)
        checkpoint = resumable(self, live, saved=target is None and self.engine.history.integrator is None)
        whole = self.settings.duration if duration is None else duration
        settings = Settings(
            whole, None, self.settings.tolerance, self.settings.method, compiled, grid, max_steps, max_events, wall_time
        )
        run_inputs, times = read(live, settings, parameters_of(self, live), checkpoint.initial)
        if run_inputs.seconds <= self.engine.t_end:
            actual, expected = (
                f"{run_inputs.seconds:g} s",
                f"more than the {self.engine.t_end:g} s that the run reached",
            )
            raise InputError(live.name, [Fault("duration", actual, expected, "it is of the whole motion")])
        run = set_up(live, settings, run_inputs, checkpoint.resume, began=began)
        build_s = time.perf_counter() - began
        rest = None if times is None else times[times >= run.begin]
        trace = run.trace(self.settings.tolerance, self.engine.scales, rest, progress=progress)
        before = "" if self.error is None else f". That of the run before was {self.error} at its end"
        at = f"t = {run.begin:.9g} s at the tolerance {self.settings.tolerance:.2g}"
        note = f"continues from {at} of the run before, without an error estimate{before}"
        part = _solution_of(run, trace, self.engine.scales, build_s)
        return replace(part, engine=part.engine.with_warning(note))

    def sensitivities(self, *names: str) -> Sensitivities:
        """Return the exact derivatives of this run by parameters and initial states, through its impacts.

        `run.sensitivities("restitution", "guide.travel")["slider_pin.normal_force", "restitution"]` is a history over the
        run's steps, from which it is computed. Without names those of `simulate(..., sensitivities=...)` are returned. Raises InputError
        for names that are neither, and for a run without its steps or start: a saved one, a continuation, one of SUNDIALS.
        """
        from hertzwerk.runtime.engine.sensitivity.sensitivities import Sensitivities  # most runs import none of it

        if not names and self.engine.derivatives is not None:
            return self.engine.derivatives  # type: ignore[no-any-return]  # typed Any where the engine is below them

        history, bound, initial = self._from_its_start("sensitivities")
        return Sensitivities(history, bound, initial, names, compiled=self.settings.compiled)

    def lyapunov(self, count: int = 1) -> Lyapunov:
        """Return the largest Lyapunov exponents, from the variational equations, through impacts.

        `run.lyapunov().exponents[0]` is a mean with a 95 % confidence interval [1/s], as `averages` has them; `local` its
        finite-time spread, `horizon(error)` the time in which an error grows to 1 % of the scales. count: at most 8.
        Raises InputError as `sensitivities` does, and for a count beyond what the motion has.
        """
        from hertzwerk.runtime.engine.sensitivity.lyapunov import lyapunov

        history, bound, initial = self._from_its_start("Lyapunov exponents")
        return lyapunov(
            history, bound, frozenset(initial), self.engine.scales.state, count, compiled=self.settings.compiled
        )

    def _from_its_start(self, subject: str) -> tuple[History, BoundParameters, Mapping[str, Value]]:
        """Return steps, parameters and given initial states of a run from its start; raises InputError."""
        run, checkpoint = with_steps(self), self.engine.checkpoint
        faults = steps_faults(subject, self.settings.method, self.engine.model)
        if not faults and (not run.engine.history.steps or checkpoint is None or self.engine.t_start > 0):
            expected = f"a run from its start, with its steps; of at most {REPEATABLE:,} where it is to be made again"
            faults.append(Fault(subject, "a run without its steps or start", expected, "simulate(..., grid=None)"))
        if faults or checkpoint is None:
            raise InputError(self.engine.model.name, faults)
        return run.engine.history, self.engine.model.bind(parameters_of(self, self.engine.model)), checkpoint.initial

    def _repr_html_(self) -> str:
        return notebook.of_run(self, parameters_of(self, self.engine.model))

    def to_pandas(self) -> DataFrame:
        """Return every history as a pandas data frame over t [s]; raises InputError without the extra [data].

        Units, meanings and parameters are in its `attrs`.
        """
        return data_frame(history_table(self))

    def to_xarray(self) -> Dataset:
        """Return every history as an xarray dataset over t [s]; raises InputError without the extra [data].

        Units and meanings are attributes of its variables, parameters of the dataset.
        """
        return dataset(history_table(self))

    def to_file(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write every history as .csv, .parquet or .nc, by the ending; raises InputError."""
        return write_table(
            path, partial(history_table, self), partial(plain_solution.csv_of, self), overwrite=overwrite
        )

    def plot(self, *names: str | Sequence[str]) -> Figure:
        """Draw the overview, one contact pair, a pair's wear, or the named histories, also a list of them.

        Raises KeyError for an unknown name.
        """
        wanted = list(chain.from_iterable(x if isinstance(x, list | tuple) else [x] for x in names))
        worn = [name for name, kind, _ in self.engine.model.module.EFFECTS if kind == "wear"]
        for name in wanted:
            if not isinstance(name, str) or name not in (*self.engine.model.pairs, *worn, *self):
                self[name]
        from hertzwerk.runtime.output.plots import plot_run as plot

        return plot.plot(self, *wanted)

    def animate(
        self,
        path: str | Path,
        *,
        fps: float = 25.0,
        slow: float | None = None,
        overwrite: bool = False,
        progress: Callable[[float], object] | None = None,
    ) -> Path:
        """Write the mechanism in motion as .gif, .mp4 (by ffmpeg) or .html, clearances enlarged.

        fps    frames a second; slow: seconds of film for a second of motion, by default what makes about 8 s
        progress    called with the fraction done

        Raises InputError, for a saved run too. Ctrl-C writes the frames so far, and raises KeyboardInterrupt.
        """
        from hertzwerk.runtime.output.films.film import animate

        film = animate(self, as_path("path", path), fps=fps, slow=slow, overwrite=overwrite, progress=progress)
        if film.frames < film.of:
            raise KeyboardInterrupt
        return film.path

    def draw(self) -> Figure:
        """Draw the mechanism at its start and later, clearances enlarged; raises InputError for a saved run."""
        from hertzwerk.runtime.output.drawings import picture

        return picture.of_run(self)

    def report(self, path: str | Path, *, target: Target | None = None, overwrite: bool = False) -> Path:
        """Write the run as one self-contained HTML page; raises FileExistsError.

        target    the scene or the Model of a saved run, for its equations: "slider_crank"
        """
        path = as_path("path", path)
        from hertzwerk.runtime.output.reports.run_report import run_page

        page = run_page(self, model=None if target is None else engine_model(target))
        return plain_solution.write(path, page.encode(), overwrite=overwrite)
