"""`hertzwerk run`, `validate`: simulate, report, write one new folder; check results."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.units import time_text
from hertzwerk.runtime.cli.continue_run import continue_run, grid_of, limits_of
from hertzwerk.runtime.cli.stop_signals import Stopping
from hertzwerk.runtime.cli.target_options import (
    ACCURACY,
    BY_METHOD,
    DURATION,
    GRID,
    JSON,
    MAX_STEPS,
    TABLE,
    VARIATION,
    WALL_TIME,
    Variation,
    command_line,
    run_settings,
    table_faults,
    unwritable_faults,
)
from hertzwerk.runtime.cli.terminal import (
    GOOD,
    OTHER_OUTCOME,
    Progress,
    line,
    report_missing,
    reports_bad_input,
    table,
    written_or_none,
)
from hertzwerk.runtime.system.digests import json_text

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.averages import Average
    from hertzwerk.runtime.simulation import Solution

STOPPED = (
    "interrupted",
    "wall_time_limit",
    "too_many_steps",
    "exception",
)  # by something else than the motion


@click.command(epilog='Example: hertzwerk run slider_crank --set clearance="0.2 mm"')
@click.argument("target", required=False)
@VARIATION
@DURATION
@ACCURACY
@BY_METHOD
@GRID
@click.option(
    "--averages",
    is_flag=True,
    help="Print averages with their 95 % intervals too: impact rates, mean and peak forces, powers.",
)
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-NNN)."
)
@click.option(
    "--start",
    type=click.Choice(["equilibrium"]),
    help="Start from the position of rest that `hertzwerk statics` finds (default: the scene's start).",
)
@click.option(
    "--history",
    "histories",
    metavar="NAME",
    multiple=True,
    help="Write this history too: rod.x, crank_pin.reaction_x (`hertzwerk list TARGET` lists all).",
)
@click.option(
    "--sensitivity",
    "sensitivities",
    metavar="NAME",
    multiple=True,
    help="Write the derivatives of all histories by this parameter or initial state into sensitivities.csv.",
)
@MAX_STEPS
@WALL_TIME
@click.option(
    "--continue",
    "folder",
    metavar="FOLDER",
    type=click.Path(path_type=Path),
    help="Continue the run of this folder from its end, up to --duration, which counts from the start of the whole.",
)
@TABLE
@click.option("--no-plots", is_flag=True, help="Write the data without pictures.")
@JSON
@reports_bad_input
def run(
    target: str | None,
    folder: Path | None,
    out: Path | None,
    file: Path | None,
    no_plots: bool,
    as_json: bool,
    averages: bool,
    **options: Any,
) -> int:
    """Simulate TARGET and write data and pictures into a new folder.

    Ctrl-C or SIGTERM before the first step ends the command (exit code 130); after it, the run stops and its results
    are written. Exit code 1: the run has another outcome than `finished`.
    """
    wanted = out is not None or not as_json
    faults = [*unwritable_faults(out, wanted=wanted), *table_faults(file)]
    with (
        Progress(target or str(folder), shown=not as_json) as progress,
        Stopping(progress) as stopping,
    ):
        from hertzwerk.runtime.cli import run_folder

        if folder is not None:
            solution, request = continue_run(folder, target, faults, stopping, **options)
        else:
            request = _request(target, options)
            settings = dict(options)
            solution = _simulate(Variation.taken(str(target), settings), faults, stopping, **settings)
        solution = solution.with_histories(*options["histories"])
        request["command"] = command_line()
        if solution.outcome.name == "interrupted" and not solution.statistics.steps:
            raise KeyboardInterrupt
        missing: list[str] = []
        written = written_or_none(
            lambda: run_folder.write(
                solution, out, plots=not no_plots, averages=averages, stopping=stopping, request=request
            ),
            missing,
            wanted=wanted,
        )
        if file is not None:
            stopping.stage(f"writing {file}")
            written_or_none(lambda: solution.to_file(file), missing, wanted=True)
    if written is not None:
        missing += written.missing
    if as_json:
        click.echo(json_text(run_folder.summary(solution, averages=averages)))
        return report_missing(missing) if solution.outcome.finished else OTHER_OUTCOME
    _report(solution)
    if written is not None:
        _report_averages(written.averages)
        for text in written.left_out:
            line("left out", text)
        line("written", f"{written.folder}/ ({', '.join(written.files)})")
        if (
            solution.outcome.name in STOPPED
            and solution.engine.t_end < solution.settings.duration
            and "states.npz" in written.files
        ):
            line("go on", f"hertzwerk run --continue {written.folder}")
    if file is not None and file.exists():
        line("written", str(file))
    code = report_missing(missing)
    return code if solution.outcome.finished else OTHER_OUTCOME


@click.command(epilog="Example: hertzwerk validate bouncing_ball")
@click.argument("targets", metavar="[SCENARIO]...", nargs=-1)
@reports_bad_input
def validate(targets: tuple[str, ...]) -> int:
    """Run scenarios and compare results with published ones.

    SCENARIO is the name of a built-in one, or a TOML file (default: all built-in ones). Exit code 1: a check fails.
    """
    from hertzwerk.runtime.analysis.validation import scenarios
    from hertzwerk.runtime.analysis.validation.scenario import load_scenario
    from hertzwerk.runtime.analysis.validation.validate import run_scenario
    from hertzwerk.runtime.analysis.validation.validate import validate as verdicts_of

    checks = passed = unfinished = 0
    loaded = [load_scenario(target) for target in targets or scenarios.names()]
    with Progress("validate") as progress:
        for scenario in progress.over(loaded, lambda scenario: scenario.scene):
            solution = run_scenario(scenario)
            progress.aside(partial(line, scenario.scene, str(solution)))
            verdicts = verdicts_of(scenario, solution)
            for verdict in verdicts:
                line("passed" if verdict.passed else "failed", str(verdict))
            checks, passed = checks + len(verdicts), passed + sum(verdict.passed for verdict in verdicts)
            unfinished += solution.outcome.name != scenario.outcome
    good = passed == checks and not unfinished
    runs = f"; {unfinished} run{'s' if unfinished > 1 else ''} with another outcome" if unfinished else ""
    line("passed" if good else "failed", f"{passed} of {checks} checks hold{runs}")
    return GOOD if good else OTHER_OUTCOME


def _request(target: str | None, options: Mapping[str, Any]) -> dict[str, Any]:
    """Return the part of a command line that --continue needs; raises InputError without a target."""
    if target is None:
        expected = "a scene or a file, or --continue FOLDER"
        raise InputError("run", [Fault("TARGET", "none", expected, "`hertzwerk list` names the scenes")])
    from hertzwerk.runtime.engine.inputs.input_values import located
    from hertzwerk.runtime.engine.model.build import located_laws, located_target

    return {
        "target": located_target(target, Path.cwd()),
        **{name: options[name] for name in ("without", "coordinates", "grid")},
        "laws": [located_laws(text, Path.cwd()) for text in options["laws"]],
        "inputs": [located(text, Path.cwd()) for text in options["inputs"]],
    }


def _simulate(
    varied: Variation,
    faults: list[Fault],
    stopping: Stopping,
    *,
    duration: str | None,
    accuracy: str | None,
    method: str | None,
    grid: str | None,
    max_steps: str | None,
    wall_time: str | None,
    start: str | None,
    histories: Sequence[str],
    sensitivities: Sequence[str],
) -> Solution:
    """Return the solution of a command line; raises InputError with `faults` and those of all its parts."""
    from hertzwerk.runtime.engine.run.run_request import Settings

    stopping.stage("building")
    stated = run_settings(varied.target, duration=duration, accuracy=accuracy, method=method)
    limits = limits_of(max_steps, wall_time, faults)
    settled = Settings(**stated, grid=grid_of(grid), **limits, sensitivities=sensitivities)
    return varied.solved(settled, faults, stopping, histories=histories, at_rest=start is not None)


def _report_averages(averages: Sequence[Average]) -> None:
    """Print averages as a table, and each reason for what is missing once."""
    if not averages:
        return
    rows = [
        [a.name, *("" if x is None else f"{x:.4g}" for x in (a.mean, a.half_width)), a.unit, f"{a.blocks or ''}"]
        for a in averages
    ]
    table(("average", "mean", "+- 95 %", "unit", "blocks"), rows)
    for reason in dict.fromkeys(a.reason for a in averages if a.reason):
        of = [a.name for a in averages if a.reason == reason]
        whose = f"{', '.join(of)}: " if len(of) < len(averages) else "every 95 % interval: "
        line("missing", f"{whose}{reason}")


def _report(solution: Solution) -> None:
    """Print a run in a few lines."""
    from hertzwerk.runtime.engine.solution.step_warnings import headline

    statistics, outcome = solution.statistics, solution.outcome
    line(
        solution.engine.model.name,
        f"{time_text(solution.settings.duration, 4)}, {solution.settings.method}, tolerance {solution.settings.tolerance:.2g}",
    )
    count = len(solution.impacts)
    closed = "" if solution.energy_residual is None else f", energy closed to {solution.energy_residual:.1g}"
    checked = "" if solution.error is None else f", estimated in {time_text(solution.error.pilot_s, 3)}"
    line(
        outcome.name,
        f"{statistics.steps:,} steps, {count:,} impact{'s' if count != 1 else ''}{closed}, computed in {time_text(statistics.wall_s, 3)}{checked}",
    )
    if solution.error is not None and solution.settings.accuracy is not None:
        from hertzwerk.runtime.engine.accuracy.error_estimate import brief

        cost = solution.error.decade_cost
        more = "" if cost is None else f"; ten times more would cost about {cost:.1f} x the time"
        line(
            "accuracy",
            f"requested {brief(solution.settings.accuracy, 3)}{' at the end' if solution.error.at_end else ''}, estimated {solution.error}{more}",
        )
    if not outcome.finished:
        line("", outcome.message)
        line("remedy", outcome.remedy)
    findings = [
        *(("warning", text) for text in solution.warnings),
        *(("advice", text) for text in solution.engine.advice),
    ]
    for label, text in findings:
        line(label, headline(text))
    if findings:
        line("details", "`hertzwerk report` shows all that was found, as do `warnings` and `advice` in run.json")
