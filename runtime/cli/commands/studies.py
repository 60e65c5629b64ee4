"""`hertzwerk study`: comparisons with figures, tables and verdicts, the paper's and users' own."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime.cli.target import JSON, unwritable_faults
from hertzwerk.runtime.cli.terminal import (
    GOOD,
    OTHER_OUTCOME,
    Progress,
    conclude,
    line,
    reports_bad_input,
)

if TYPE_CHECKING:
    from hertzwerk.runtime.studies.page import Page


@click.command()
@click.argument("name", required=False)
@click.option("--quick", is_flag=True, help="Fewer cases and shorter runs: seconds instead of minutes.")
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/NAME-study-NNN)."
)
@click.option(
    "--measured",
    type=click.Path(path_type=Path),
    metavar="FILE.csv",
    help="Lay measured signals over the figures: columns named as histories, t [s],guide.acceleration [m/s^2].",
)
@JSON
@reports_bad_input
def study(name: str | None, quick: bool, out: Path | None, measured: Path | None, as_json: bool) -> int:
    """Make the study NAME, or that of a Python file that defines `study`: figures, tables, verdicts.

    Without NAME, list the built-in studies. Exit code 1 where a number differs from the independent one it is compared
    with.
    """
    from hertzwerk.runtime.cli import page_folder
    from hertzwerk.runtime.measured.measurement import read_measurement
    from hertzwerk.runtime.studies.known_studies import NAMES, study_of
    from hertzwerk.runtime.studies.overlay import laid_over

    if name is None:
        for known in NAMES:
            line(known, study_of(known).question)
        return GOOD
    wanted = out is not None or not as_json
    found = study_of(name)
    if faults := unwritable_faults(out, wanted=wanted):
        raise InputError("study", faults)
    laid = None if measured is None else read_measurement(measured)
    with Progress(f"study {found.name}", shown=not as_json and sys.stderr.isatty()) as progress:
        page = found.run(quick, progress)
    page = page if laid is None else laid_over(page, laid)
    about = {"study": found.name, "question": found.question, "quick": quick}
    given = [*(["--quick"] if quick else []), *([] if measured is None else ["--measured", str(measured)])]
    about |= {"command": shlex.join(["hertzwerk", "study", name, *given])}
    code = conclude(
        lambda missing: page_folder.write(page, found.name, out, about, missing),
        lambda: {**about, **page.record()},
        lambda: _report(page),
        wanted=wanted,
        as_json=as_json,
    )
    return code if page.holds else OTHER_OUTCOME


def _report(page: Page) -> None:
    """Print the verdicts of a page, and what its sources lack."""
    from hertzwerk.runtime.cli.page_folder import MARKS

    for verdict in page.verdicts:
        line(MARKS[verdict.holds], f"{verdict.text} ({verdict.source})")
    for text in page.lacking:
        line("lacking", text)
