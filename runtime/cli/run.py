"""`hertzwerk run`, `validate`: simulate, report, write one new folder; check what must come out."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime.cli.target import (
    DURATION,
    JSON,
    LAW,
    SET,
    WITHOUT,
    assignments,
    cannot_be_written,
    loaded,
    number,
)
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input

if TYPE_CHECKING:
    from hertzwerk.runtime.solution import Solution


@click.command()
@click.argument("target")
@SET
@WITHOUT
@LAW
@click.option(
    "--coordinates",
    metavar="NAME",
    help="tree (of the joints), absolute (of every body) or auto (what takes fewer operations); derives the variation.",
)
@DURATION
@click.option(
    "--accuracy",
    metavar="NUMBER",
    help="Error asked for at the end, in the scene's scales, 1e-12..1e-1 (default: the scenario's).",
)
@click.option(
    "--method", metavar="NAME", help="auto, dop853, dopri5, esdirk, rodas, cvodes or idas (default: the scenario's)."
)
@click.option(
    "--grid",
    metavar="POINTS|TIME",
    help='Keep so many equally spaced states (10000), or one each TIME ("0.1 ms"), in place of every accepted step.',
)
@click.option(
    "--averages", is_flag=True, help="Also averages with 95 % confidence: impact rates, mean and peak forces, powers."
)
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-NNN)."
)
@click.option("--no-plots", is_flag=True, help="Write the data only.")
@JSON
@reports_bad_input
def run(target: str, out: Path | None, no_plots: bool, as_json: bool, averages: bool, **options: Any) -> int:
    """Simulate TARGET and write data and plots into one new folder."""
    from hertzwerk.runtime import record

    solution = _simulate(target, out, quiet=as_json, **options)
    folder: tuple[Path, list[str]] | None = None
    if out is not None or not as_json:
        folder = record.write(solution, out, plots=not no_plots, averages=averages)
    if as_json:
        click.echo(record.json_text(record.summary(solution, averages=averages)))
    else:
        _report(solution)
        for average in solution.averages() if averages else ():
            line("average", str(average))
    if folder is not None and not as_json:
        line("written", f"{folder[0]}/ ({', '.join(folder[1])})")
    return GOOD if solution.outcome.finished else OTHER_OUTCOME


@click.command()
@click.argument("targets", metavar="[SCENARIO]...", nargs=-1)
@reports_bad_input
def validate(targets: tuple[str, ...]) -> int:
    """Run scenarios (built-in names or TOML files; default: all built-in) and check what must come out."""
    from hertzwerk.runtime import scenarios
    from hertzwerk.runtime.scenario import load_scenario
    from hertzwerk.runtime.validate import run_scenario
    from hertzwerk.runtime.validate import validate as verdicts_of

    good = True
    for scenario in [load_scenario(target) for target in targets or scenarios.names()]:
        solution = run_scenario(scenario)
        line(scenario.scene, str(solution))
        verdicts = verdicts_of(scenario, solution)
        for verdict in verdicts:
            line("passed" if verdict.passed else "failed", str(verdict))
        good = good and solution.outcome.finished and all(verdict.passed for verdict in verdicts)
    return GOOD if good else OTHER_OUTCOME


def _simulate(
    target: str,
    out: Path | None,
    *,
    quiet: bool,
    settings: Sequence[str],
    without: Sequence[str],
    laws: Sequence[str],
    coordinates: str | None,
    duration: str | None,
    accuracy: str | None,
    method: str | None,
    grid: str | None,
) -> Solution:
    """The solution a command line asks for; raises InputError with the faults of all its parts."""
    from hertzwerk.runtime import scenarios
    from hertzwerk.runtime.request import Settings
    from hertzwerk.runtime.simulation import simulate
    from hertzwerk.runtime.start import sorted_out

    faults = cannot_be_written(out)
    values = assignments("--set", settings, faults)
    numbers = scenarios.read(target) if target in scenarios.names() else {}
    accurate = number(accuracy) if accuracy is not None else numbers.get("accuracy")
    by = method or numbers.get("method", "dop853")
    settled = Settings(duration, accurate, None, by, "auto")
    model = loaded(target, without, laws, faults, coordinates=coordinates, beside=settled.faults)
    parameters, initial = sorted_out(model, values)
    limits: dict[str, Any] = {"max_steps": 1} if faults else {}  # reads the rest of the input completely, and no more
    with Progress(model.name, shown=not quiet and sys.stderr.isatty()) as progress:
        try:
            solution = simulate(
                model,
                duration=duration or numbers.get("duration"),
                accuracy=accurate,
                method=by,
                parameters=parameters,
                initial=initial,
                output="steps" if grid is None else int(grid) if grid.isdecimal() and len(grid) < 16 else grid,
                progress=progress,
                **limits,
            )
        except InputError as error:
            raise InputError(error.subject, [*faults, *error.faults]) from error
    if faults:
        raise InputError(model.name, faults)
    return solution


def _report(solution: Solution) -> None:
    """What a person wants to know of a run, in a few lines."""
    statistics, outcome = solution.statistics, solution.outcome
    line(solution.model.name, f"{_time(solution.duration)}, {solution.method}, tolerance {solution.tolerance:.2g}")
    count = len(solution.impacts)
    closed = "" if solution.energy_residual is None else f", energy closed to {solution.energy_residual:.1g}"
    beside = "" if solution.error is None else f", and {_time(solution.error.pilot_s)} for its estimate"
    line(
        outcome.name,
        f"{statistics.steps:,} steps, {count:,} impact{'s' if count != 1 else ''}{closed}, computed in {_time(statistics.wall_s)}{beside}",
    )
    if solution.error is not None and solution.accuracy is not None:
        from hertzwerk.runtime.accuracy import brief

        cost = solution.error.decade_cost
        more = "" if cost is None else f"; ten times more would cost about {cost:.1f} x the time"
        line("accuracy", f"asked {brief(solution.accuracy, 3)}, estimated {solution.error}{more}")
    if not outcome.finished:
        line("", outcome.message)
        line("remedy", outcome.remedy)
    for warning in solution.warnings:
        line("warning", warning)
    for text in solution.advice:
        line("advice", text)


def _time(seconds: float) -> str:
    return f"{seconds * 1e3:.4g} ms" if seconds < 1 else f"{seconds:.4g} s"
