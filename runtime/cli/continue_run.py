"""`hertzwerk run --continue FOLDER`: continue a run from its end."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault, InputError, noted, refuse
from hertzwerk.runtime.cli.target_options import assignments, with_inputs

if TYPE_CHECKING:
    from hertzwerk.runtime.cli.stop_signals import Stopping
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.simulation import Solution

REMEDY = "omit it: a continued run keeps its settings"


def continue_run(
    folder: Path,
    target: str | None,
    faults: list[Fault],
    stopping: Stopping,
    *,
    duration: str | None,
    grid: str | None,
    max_steps: str | None,
    wall_time: str | None,
    histories: Sequence[str],
    sensitivities: Sequence[str],
    **others: Any,
) -> tuple[Solution, dict[str, Any]]:
    """Return the continued run and the request to be recorded with it.

    Raises InputError with `faults` and more, also for options that differ from the original run.
    """
    from hertzwerk.runtime.engine.run.continuation import parameters_of
    from hertzwerk.runtime.engine.solution.history import unknown_histories
    from hertzwerk.runtime.loading import engine_model

    before, request = _read(folder)
    limits = limits_of(max_steps, wall_time, faults)
    if sensitivities:
        actual = f"{', '.join(sensitivities)}, of a continued run"
        faults.append(Fault("--sensitivity", actual, "a run from its start", "run the whole without --continue"))
    stopping.stage("building")
    model = engine_model(
        request["target"],
        without=tuple(request["without"]),
        laws=assignments("--law", request["laws"], []),
        coordinates=request["coordinates"],
    )
    until = before.settings.duration if duration is None else duration
    model = with_inputs(model, request["inputs"], until, parameters_of(before, model), faults)
    faults += [*_differences(before, model, request, target, **others), *unknown_histories(model, histories)]
    spacing = grid if grid is not None else request["grid"]
    if grid is None and spacing is not None and spacing.isdecimal() and duration is not None:
        actual = f"{spacing} points over {before.settings.duration:g} s, of the run before"
        faults.append(Fault("--grid", actual, "points or a spacing for the longer motion", 'such as --grid "0.1 ms"'))
    refuse(f"--continue {folder}", faults)
    solution = before.continued(duration, target=model, grid=grid_of(spacing), progress=stopping, **limits)
    return solution, {**request, "grid": spacing, "continues": str(folder)}


def limits_of(max_steps: str | None, wall_time: str | None, faults: list[Fault]) -> dict[str, Any]:
    """Return the given limits; bad input is appended to `faults`."""
    from hertzwerk.runtime.engine.model.binding import read_time

    limits: dict[str, Any] = {}
    if max_steps is not None:
        if max_steps.isdecimal() and 0 < len(max_steps) < 16 and int(max_steps) > 0:
            limits["max_steps"] = int(max_steps)
        else:
            faults.append(Fault("--max-steps", repr(max_steps), "a positive whole number"))
    if wall_time is not None:
        limits["wall_time"] = read_time("--wall-time", wall_time, 'a positive time, such as "10 min"', faults)
    return limits


def grid_of(grid: str | None) -> str | int | None:
    """Return the grid that --grid requests."""
    return int(grid) if grid is not None and grid.isdecimal() and len(grid) < 16 else grid


def _read(folder: Path) -> tuple[Solution, dict[str, Any]]:
    """Return the run in a folder and its request; raises InputError."""
    from hertzwerk.runtime.simulation import Solution
    from hertzwerk.runtime.system.digests import read_sealed

    try:
        record = read_sealed(folder / "run.json")
        request = record["request"]
        names = ("target", "without", "laws", "coordinates", "grid")
        request = {**{name: request[name] for name in names}, "inputs": request.get("inputs", [])}
        return Solution.load(folder / "states.npz"), request
    except (OSError, ValueError, KeyError, TypeError) as error:
        actual = f"{folder}: {type(error).__name__}: {error}"
        raise InputError("--continue", [Fault("--continue", actual, "a folder that `hertzwerk run` wrote")]) from error


def _differences(
    before: Solution,
    model: EngineModel,
    request: Mapping[str, Any],
    target: str | None,
    *,
    settings: Sequence[str],
    inputs: Sequence[str],
    without: Sequence[str],
    laws: Sequence[str],
    coordinates: str | None,
    accuracy: str | None,
    method: str | None,
    start: str | None,
) -> list[Fault]:
    """Return faults for the options of a command line that differ from the original run."""
    from hertzwerk.runtime.engine.inputs.input_values import located
    from hertzwerk.runtime.engine.model.build import located_laws, located_target

    faults: list[Fault] = []
    if target is not None:
        target = located_target(target, Path.cwd())
    options = {
        "TARGET": (target, request["target"]),
        "--input": ([located(text, Path.cwd()) for text in inputs] or None, request["inputs"]),
        "--without": (sorted(without) or None, sorted(request["without"])),
        "--law": (
            assignments("--law", [located_laws(text, Path.cwd()) for text in laws], faults) or None,
            assignments("--law", request["laws"], faults),
        ),
        "--coordinates": (coordinates, request["coordinates"]),
        "--method": (method, before.settings.method),
    }
    faults += [
        Fault(option, str(now), f"{had or 'none'}, as of the run there", REMEDY)
        for option, (now, had) in options.items()
        if now is not None and now != had
    ]
    if accuracy is not None:
        expected = f"none: a run continues at its tolerance, {before.settings.tolerance:.2g}, without an estimate"
        faults.append(Fault("--accuracy", accuracy, expected, "leave it out"))
    if start is not None:
        faults.append(Fault("--start", start, "none: a run continues from its end", "leave it out"))
    return faults + _value_differences(before, model, assignments("--set", settings, faults))


def _value_differences(before: Solution, model: EngineModel, values: Mapping[str, str]) -> list[Fault]:
    """Return faults for parameters and initial states that differ from the run's."""
    from hertzwerk.runtime.engine.run.continuation import parameters_of
    from hertzwerk.runtime.engine.start.start_values import split_values

    faults: list[Fault] = []
    had = parameters_of(before, model)
    parameters, initial = split_values(model, values)
    bound = model.bind(had)
    for name, text in parameters.items():
        with noted(faults):
            if model.bind({**had, name: text})[name] != bound[name]:
                value, unit = before.settings.parameters[name]
                faults.append(Fault(f"--set {name}", text, f"{value:g} {unit}, as of the run there", REMEDY))
    stated = before.engine.checkpoint.initial if before.engine.checkpoint is not None else {}
    faults += [
        Fault(f"--set {name}", text, f"{stated.get(name, 'the start of the model')}, as of the run there", REMEDY)
        for name, text in initial.items()
        if stated.get(name) != text
    ]
    return faults
