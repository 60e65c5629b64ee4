"""`hertzwerk accuracy`: the time that ten times more accuracy costs, and what it gains."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.runtime.cli.target_options import (
    DURATION,
    INPUT,
    JSON,
    LAW,
    SET,
    WITHOUT,
    Variation,
    unwritable_faults,
)
from hertzwerk.runtime.cli.terminal import OTHER_OUTCOME, Progress, conclude, line, reports_bad_input, table
from hertzwerk.runtime.system.digests import json_text

if TYPE_CHECKING:
    from hertzwerk.runtime.analysis.work_precision.reference_run import NoReferenceError, Problem, Reference
    from hertzwerk.runtime.analysis.work_precision.work_precision_study import Row, Study


@click.command(epilog="Example: hertzwerk accuracy bouncing_ball")
@click.argument("target")
@SET
@INPUT
@WITHOUT
@LAW
@DURATION
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-accuracy-NNN)."
)
@JSON
@reports_bad_input
def accuracy(target: str, out: Path | None, as_json: bool, **options: Any) -> int:
    """Measure run time against accuracy, of every method.

    In the virtual machine and as C. Each run requests an error of the whole run; the true error is measured against a
    reference computed by two independent methods. The growth of errors along the run shows how long a trajectory is
    valid, and what ten times more accuracy buys. Rows are printed as they are measured, with the time of one run; a
    table of medians follows.
    """
    wanted = out is not None or not as_json
    with Progress(f"{target}: accuracy", shown=not as_json) as progress:
        from hertzwerk.runtime.analysis.work_precision.accuracy_report import record
        from hertzwerk.runtime.analysis.work_precision.reference_run import NoReferenceError
        from hertzwerk.runtime.analysis.work_precision.work_precision_study import study

        problem = _problem(Variation.taken(target, options), out, wanted=wanted, **options)
        try:
            result = study(problem, progress=progress, arrived=_shown(problem, progress, quiet=as_json))
        except NoReferenceError as error:
            progress.aside(partial(_without_reference, problem, error, as_json=as_json))
            return OTHER_OUTCOME
    return conclude(
        lambda missing: _write(result, out, missing),
        lambda: record(result),
        lambda: _report(result),
        wanted=wanted,
        as_json=as_json,
    )


def _problem(varied: Variation, out: Path | None, *, wanted: bool, duration: str | None) -> Problem:
    """Return the problem of a command line; raises InputError with the faults of all its parts."""
    from hertzwerk.runtime.analysis.validation import scenarios
    from hertzwerk.runtime.analysis.work_precision.reference_run import Problem
    from hertzwerk.runtime.engine.run.run_request import Settings, check

    faults = unwritable_faults(out, wanted=wanted)
    until = duration or scenarios.read(varied.target).get("duration")
    model, parameters, initial = varied.bound(until, faults)
    problem = Problem(model, until, parameters, initial)
    check(model, Settings(problem.duration, None, None), problem.parameters, problem.initial, faults)
    return problem


def _write(result: Study, out: Path | None, missing: list[str]) -> tuple[Path, list[str]]:
    """Write data and picture of a study."""
    from hertzwerk.runtime.analysis.work_precision import plot_accuracy
    from hertzwerk.runtime.analysis.work_precision.accuracy_report import csv_text, record
    from hertzwerk.runtime.cli.run_folder import write_study
    from hertzwerk.runtime.system.versions import versions

    content = {**record(result), "versions": versions()}
    texts = {"accuracy.csv": csv_text(result), "accuracy.json": json_text(content) + "\n"}
    name = f"{result.problem.model.name}-accuracy"
    return write_study(name, out, texts, lambda: plot_accuracy.figure(result), missing)


def _shown(problem: Problem, progress: Progress, *, quiet: bool) -> Callable[[Reference, Sequence[Row]], None]:
    """Return what prints the rows of each method as they come."""
    begun = False

    def show(held: Reference, rows: Sequence[Row]) -> None:
        nonlocal begun
        if not begun:
            _head(problem, held)
        path = "time as C" if rows[0].compiled else "time in VM"
        table((*accuracy_report.NUMBERS, path, "outcome"), accuracy_report.first_rows(held, rows))
        begun = True

    from hertzwerk.runtime.analysis.work_precision import accuracy_report

    return lambda held, rows: None if quiet else progress.aside(lambda: show(held, rows))


def _head(problem: Problem, held: Reference) -> None:
    """Print what is measured, and by what."""
    from hertzwerk.runtime.analysis.work_precision.accuracy_report import seconds

    span = seconds(float(held.t[-1]))
    line(problem.model.name, f"{span}; error: the maximum over the run, in the scene's scales; times of one run each")
    methods = f"{held.run.settings.method} and {held.partner.settings.method}"
    line("reference", f"{methods} at a tolerance of {held.run.settings.tolerance:.0e} agree to {held.uncertainty:.1e}")


def _report(result: Study) -> None:
    from hertzwerk.runtime.analysis.work_precision import accuracy_report

    line("in all", f"{accuracy_report.seconds(float(result.reference.t[-1]))}, medians of the times of several runs")
    table(accuracy_report.COLUMNS, accuracy_report.rows(result))
    for warning in accuracy_report.warnings(result):
        line("warning", warning)
    for sentence in accuracy_report.conclusions(result):
        line("", sentence)


def _without_reference(problem: Problem, error: NoReferenceError, *, as_json: bool) -> None:
    """Report that no two methods reach the end, so that errors cannot be measured."""

    failed = {method: (run.outcome, run.engine.t_end) for method, run in error.runs.items()}
    if as_json:
        outcomes = {method: {"outcome": o.name, "message": o.message, "t_end": t} for method, (o, t) in failed.items()}
        nothing: dict[str, Any] = {"rows": [], "reference": None, "decade_cost": None, "recommended": None}
        click.echo(json_text({"scene": problem.model.name, **nothing, "outcomes": outcomes}))
        return
    line("no reference", "no two methods reach the end, so errors cannot be measured")
    for method, (outcome, _) in failed.items():
        line("", f"{method}: {outcome.message}")
    remedy = next(outcome.remedy for outcome, _ in failed.values())
    line("remedy", f"--duration with a shorter time; {remedy}")
