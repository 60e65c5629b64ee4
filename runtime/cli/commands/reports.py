"""`hertzwerk report`: one self-contained HTML page of a run, a sweep, a study or a scene."""

from __future__ import annotations

from pathlib import Path

import click

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime.cli.terminal import GOOD, line, reports_bad_input


@click.command()
@click.argument("target", metavar="FOLDER|FILE|TARGET")
@click.option(
    "--out", type=click.Path(path_type=Path), help="HTML to write (default: report.html in a folder, else beside)."
)
@click.option("--scene", metavar="FILE", help="Python file of a run's scene, which is executed, for its equations.")
@click.option("--overwrite", is_flag=True, help="Write it in place of another.")
@reports_bad_input
def report(target: str, out: Path | None, scene: str | None, overwrite: bool) -> int:
    """Write one HTML page that holds all it shows: numbers, warnings, pictures, equations, origin.

    Of a folder that `hertzwerk run`, `sweep`, `study`, `fit`, `propagate` or `minimise` wrote, of a file of Solution.save, or of a scene.
    """
    from hertzwerk.runtime.cli.reported import page_of
    from hertzwerk.runtime.host.folder import new_file_faults
    from hertzwerk.runtime.solution.solution import write

    place = Path(target)
    path = out or (place / "report.html" if place.is_dir() else Path(f"{place.stem}.html"))
    if faults := new_file_faults("--out", path, "name another, or say --overwrite", overwrite=overwrite):
        raise InputError("report", faults)
    line("written", str(write(path, page_of(place, target, scene).encode(), overwrite=overwrite)))
    return GOOD
