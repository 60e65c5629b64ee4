"""`hertzwerk study`: comparisons with figures, tables and verdicts, the paper's and users' own."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.runtime.cli.target_options import JSON, READING, beside, command_line, reading_of, unwritable_faults
from hertzwerk.runtime.cli.terminal import (
    GOOD,
    OTHER_OUTCOME,
    Progress,
    conclude,
    line,
    report_damage,
    reports_bad_input,
)

if TYPE_CHECKING:
    from hertzwerk.runtime.studies.paper.study_page import Page


@click.command(epilog="Example: hertzwerk study bouncing --quick")
@click.argument("name", required=False)
@click.option("--quick", is_flag=True, help="Run fewer cases for a shorter time: seconds instead of minutes.")
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/NAME-study-NNN)."
)
@click.option(
    "--measured",
    type=click.Path(path_type=Path),
    metavar="FILE.csv",
    help="Table of signals to draw over the figures, its columns named as histories: t [s], guide.acceleration [m/s^2]; "
    '--columns names others: --columns "guide.acceleration=CH 2".',
)
@READING
@click.option(
    "--resume",
    metavar="DIR",
    type=click.Path(path_type=Path),
    help="Continue a study that was stopped; rows in this folder are not computed again.",
)
@JSON
@reports_bad_input
def study(
    name: str | None,
    quick: bool,
    out: Path | None,
    measured: Path | None,
    resume: Path | None,
    as_json: bool,
    **options: Any,
) -> int:
    """Run the study NAME and write figures, tables and verdicts.

    NAME is a built-in study, or a Python file that defines `study`, which is executed; without it the built-in
    studies are listed. The rows of its sweeps are stored in the folder as they are computed; --resume continues,
    whatever ended it. Ctrl-C between other cases ends the study with a page of those computed so far. Exit code 1: it
    was stopped, or a number differs from its independent reference.
    """
    from hertzwerk.runtime.cli import page_folder
    from hertzwerk.runtime.engine.inputs.measurement_csv import read_measurement
    from hertzwerk.runtime.engine.model.build import is_file
    from hertzwerk.runtime.studies.paper.study_page import NAMES, laid_over, require_columns, study_of
    from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps, SweepStoppedError

    faults: list[Fault] = []
    reading, command = reading_of(options, faults), command_line("out", "as_json")
    if resume is not None:
        refuse("study", beside("--resume", "the same options as there; beside them --json", "resume", "as_json"))
        request = page_folder.read_study_request(resume)
        name, quick, measured, reading, command = (
            request[key] for key in ("study", "quick", "measured", "reading", "command")
        )
    if any(reading.values()) and measured is None:
        faults.append(Fault("--measured", "none, and options that say how to read it", "--measured FILE"))
    if name is None:
        for known in NAMES:
            line(known, study_of(known).question)
        return GOOD
    wanted = resume is not None or out is not None or not as_json
    chosen = study_of(name)
    faults += [] if resume is not None else unwritable_faults(out, wanted=wanted)
    refuse("study", faults)
    laid = None if measured is None else read_measurement(measured, **reading)
    if laid is not None:
        require_columns(chosen, laid)
    target = str(Path(name).absolute()) if is_file(name) else name
    located = None if measured is None else str(Path(measured).absolute())
    request = {"study": target, "quick": quick, "measured": located, "reading": reading, "command": command}
    folder = page_folder.StudyFolder(chosen.name, resume or out, request, begun=resume is not None)
    sweeps = Sweeps(folder.rows if wanted else None)
    try:
        with Progress(f"study {chosen.name}", shown=not as_json) as progress:
            page = chosen.run(quick, progress, sweeps)
    except SweepStoppedError as stopped:
        report_damage(*sweeps.damage)
        line("stopped", str(stopped))
        if folder.path is not None:
            line("remedy", f"hertzwerk study --resume {folder.path}")
        return OTHER_OUTCOME
    page = page if laid is None else laid_over(page, laid)
    about = {"study": chosen.name, "question": chosen.question, "quick": quick, "damage": sweeps.damage}
    about["command"] = command
    code = conclude(
        lambda missing: folder.write(page, about, missing),
        lambda: {**about, **page.record()},
        lambda: _report(page, sweeps.damage),
        wanted=wanted,
        as_json=as_json,
    )
    return code if page.holds and not page.missing else OTHER_OUTCOME


def _report(page: Page, damage: Sequence[str]) -> None:
    """Print the verdicts of a page, what its sources lack, and what was damaged among its rows."""
    from hertzwerk.runtime.cli.page_folder import MARKS

    if page.missing:
        line("interrupted", page.missing)
    for verdict in page.verdicts:
        line(MARKS[verdict.holds], f"{verdict.text} ({verdict.source})")
    for text in page.lacking:
        line("lacking", text)
    report_damage(*damage)
