"""`hertzwerk run`, `validate`: simulate, report, write one new folder; check what must come out."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input

if TYPE_CHECKING:
    from hertzwerk.runtime.solution import Solution


@click.command()
@click.argument("target")
@click.option(
    "--set",
    "settings",
    metavar="NAME=VALUE",
    multiple=True,
    help='Parameter or initial state, with its unit: --set clearance="0.2 mm".',
)
@click.option("--without", metavar="EFFECT", multiple=True, help="Leave an effect out (derives the variation).")
@click.option(
    "--law",
    "laws",
    metavar="EFFECT=NAME",
    multiple=True,
    help="Another law for a contact or friction (derives the variation).",
)
@click.option(
    "--coordinates",
    metavar="NAME",
    help="tree (of the joints), absolute (of every body) or auto (what takes fewer operations); derives the variation.",
)
@click.option("--duration", metavar="TIME", help='Such as "24 ms" (default: the scenario\'s).')
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
@click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON object, and write a folder only if --out is given."
)
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
    from hertzwerk.runtime.model import load
    from hertzwerk.runtime.record import destination_fault
    from hertzwerk.runtime.request import Settings
    from hertzwerk.runtime.simulation import simulate
    from hertzwerk.runtime.start import sorted_out

    faults: list[Fault] = []
    if out is not None and (fault := destination_fault(out)) is not None:
        faults.append(fault)
    values = assignments("--set", settings, faults)
    numbers = scenarios.read(target) if target in scenarios.names() else {}
    accurate = _number(accuracy) if accuracy is not None else numbers.get("accuracy")
    by = method or numbers.get("method", "dop853")
    try:
        model = load(target, without=without, laws=assignments("--law", laws, faults), coordinates=coordinates)
    except InputError as error:  # names of parameters and states cannot be checked then
        of_the_rest = Settings(duration, accurate, None, by, "auto").faults()
        raise InputError(error.subject, [*faults, *error.faults, *of_the_rest]) from error
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


def assignments(option: str, texts: Sequence[str], faults: list[Fault]) -> dict[str, str]:
    """NAME=VALUE texts as a dictionary; what is no assignment, or a second one of a name, becomes a fault."""
    found: dict[str, str] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals and value):
            faults.append(Fault(option, repr(text), "NAME=VALUE"))
        elif name in found:
            faults.append(Fault(option, f"{name} twice", "one value per name"))
        else:
            found[name] = value
    return found


def _number(text: str) -> Any:
    """The number a text is, or the text, for `simulate` to refuse."""
    try:
        return float(text)
    except ValueError:
        return text


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


def _time(seconds: float) -> str:
    return f"{seconds * 1e3:.4g} ms" if seconds < 1 else f"{seconds:.4g} s"
