"""`hertzwerk report`: one self-contained HTML page of a run, a sweep, a study or a scene."""

from __future__ import annotations

from pathlib import Path

import click

from hertzwerk.derive.common.faults import refuse
from hertzwerk.runtime.cli.terminal import GOOD, Progress, line, reports_bad_input


@click.command(epilog="Example: hertzwerk report runs/slider_crank-001")
@click.argument("target", metavar="FOLDER|FILE|TARGET")
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    help="HTML file to write (default: report.html in FOLDER, or beside FILE).",
)
@click.option("--scene", metavar="FILE", help="Python file of the run's scene, which is executed, for its equations.")
@click.option("--overwrite", is_flag=True, help="Replace an existing file.")
@reports_bad_input
def report(target: str, out: Path | None, scene: str | None, overwrite: bool) -> int:
    """Write an HTML page of a run, sweep, study or scene.

    The page holds numbers, warnings, pictures, equations and origin, and needs no other file. FOLDER is one that
    `hertzwerk run`, `sweep`, `study`, `fit`, `propagate` or `minimise` wrote, FILE one of `Solution.save`, TARGET a
    built-in scene or a Python file that defines `scene`, which is executed.
    """
    from hertzwerk.runtime.cli.report_subjects import page_of
    from hertzwerk.runtime.engine.solution.solution import write
    from hertzwerk.runtime.system.result_folder import new_file_faults

    place = Path(target)
    path = out or (place / "report.html" if place.is_dir() else Path(f"{place.stem}.html"))
    refuse("report", new_file_faults("--out", path, "name another, or add --overwrite", overwrite=overwrite))
    with Progress(f"report of {target}") as progress:
        progress.stage("making the page")
        page = page_of(place, target, scene).encode()
    line("written", str(write(path, page, overwrite=overwrite)))
    return GOOD
