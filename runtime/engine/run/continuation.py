"""Continuation of a run: what it takes over from the run before, and its steps made again."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeVar

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.integration.tableaux.methods import IN_GRAPH
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.run_request import Settings, read
from hertzwerk.runtime.engine.run.single_run import set_up
from hertzwerk.runtime.engine.solution.checkpoint import Checkpoint, digest
from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.engine.solution.solution import EngineSolution

REPEATABLE = 100_000  # most steps of a run that is made again for a picture

AnyRun = TypeVar("AnyRun", bound=EngineSolution)

# How a run may have ended that goes on where it is asked for more: any other would end so again.
CONTINUABLE = (
    "finished",
    "interrupted",
    "wall_time_limit",
    "too_many_steps",
    "exception",
    "event_limit",
    "accuracy_unreachable",
    "energy_not_closed",
)


def parameters_of(run: EngineSolution, model: EngineModel) -> dict[str, tuple[float, str]]:
    """Return the parameters of a run that differ from the model's own."""
    ports = model.parameters
    return {
        name: (value, unit)
        for name, (value, unit) in run.settings.parameters.items()
        if name not in ports or (value, unit) != (ports[name].default, ports[name].unit)
    }


def resumable(run: EngineSolution, model: EngineModel, *, saved: bool) -> Checkpoint:
    """Return the checkpoint of a run; raises InputError where it cannot be continued."""
    faults, checkpoint = [], run.engine.checkpoint
    if saved:
        remedy = f'name it: target="{run.engine.model.name}"'
        faults.append(Fault("model", "a saved run, which has no functions", "the model that was run", remedy))
    if run.outcome.name not in CONTINUABLE:
        expected = f"one of {', '.join(CONTINUABLE)}"
        faults.append(
            Fault(
                "outcome",
                run.outcome.name,
                expected,
                "it would end in the same way: change the model or its parameters",
            )
        )
    if checkpoint is None:
        expected = f"a run of the engine itself: {', '.join(IN_GRAPH)}"
        faults.append(Fault("method", f"{run.settings.method}, or a run without a checkpoint", expected))
    elif not saved:
        sizes = dict(layouts(model).state.sizes)
        if (
            checkpoint.model != digest(model)
            or checkpoint.layout != sizes
            or checkpoint.resume.state.shape != (sum(sizes.values()),)
        ):
            expected = "the model that was run, derived by the same version"
            actual = f"{model.name} with other equations{' or inputs' if model.inputs else ''}"
            faults.append(Fault("model", actual, expected, "run it anew from its start"))
    if faults or checkpoint is None:
        raise InputError(f"going on with {run.engine.model.name}", faults)
    return checkpoint


def with_steps(run: AnyRun) -> AnyRun:
    """Return a run with every accepted step: itself, or one made again that is bitwise the same.

    Itself too where only its rows are left: of a saved run, a continuation, or more than 100,000 steps.
    """
    engine, settings, counted = run.engine, run.settings, run.statistics
    if (
        engine.history.steps
        or engine.history.integrator is None
        or engine.checkpoint is None
        or engine.t_start > 0
        or counted.steps > REPEATABLE
    ):
        return run
    tried = max(counted.steps, counted.rejected + counted.retaken)
    again = Settings(settings.duration, None, settings.tolerance, settings.method, max_steps=tried + 1)
    inputs, _ = read(engine.model, again, parameters_of(run, engine.model), engine.checkpoint.initial)
    steps = set_up(engine.model, again, inputs).trace(settings.tolerance, engine.scales, None).recorded.history
    rows, beside = steps.rows[steps.t <= run.engine.t_end], engine.history.beside
    history = History(engine.model, rows, steps.controls, steps.integrator, p=steps.p, beside=beside)
    return replace(run, engine=replace(engine, history=history))
