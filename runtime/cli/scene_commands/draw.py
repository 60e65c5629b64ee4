"""`hertzwerk draw`: pictures of mechanisms."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.runtime.cli.target_options import SET, assignments
from hertzwerk.runtime.cli.terminal import GOOD, Progress, line, reports_bad_input

if TYPE_CHECKING:
    from hertzwerk.runtime.output.drawings.places import Places

TOLERANCE = 1e-6  # local; finer than a picture shows


@click.command(epilog="Example: hertzwerk draw slider_crank --out crank.png")
@click.argument("targets", metavar="[TARGET]...", nargs=-1)
@SET
@click.option(
    "--duration",
    metavar="TIME",
    help='Time to simulate, such as "24 ms" (default: the scenario\'s, or the start alone).',
)
@click.option("--start", is_flag=True, help="Draw the start alone; nothing is simulated.")
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    help="PNG file to write (default: TARGET.png; of several, mechanisms.png).",
)
@click.option("--overwrite", is_flag=True, help="Replace an existing file.")
@reports_bad_input
def draw(
    targets: tuple[str, ...],
    settings: Sequence[str],
    duration: str | None,
    start: bool,
    out: Path | None,
    overwrite: bool,
) -> int:
    """Draw the mechanism of TARGET at its start and later.

    Clearances are enlarged. Several targets are drawn on one sheet (default: all built-in scenes).
    """
    from hertzwerk.runtime.engine.model.build import built_in_scenes
    from hertzwerk.runtime.system.result_folder import new_file_faults

    faults: list[Fault] = []
    values = assignments("--set", settings, faults)
    names = targets or built_in_scenes()
    if start and duration is not None:
        faults.append(Fault("--duration", repr(duration), "none beside --start"))
    if len(names) > 1 and (values or duration is not None):
        faults.append(Fault("--set, --duration", "several targets", "one"))
    path = out or Path(f"{Path(names[0]).stem}.png" if len(names) == 1 else "mechanisms.png")
    faults += new_file_faults("--out", path, "name another, or add --overwrite", overwrite=overwrite)
    refuse("draw", faults)
    with Progress("draw") as progress:
        from hertzwerk.runtime.engine.solution.solution import write
        from hertzwerk.runtime.output.drawings import picture
        from hertzwerk.runtime.output.drawings.gallery import sheet
        from hertzwerk.runtime.output.plots.save_figure import png_of

        views = [_places(name, values, duration, start) for name in progress.over(names)]
        progress.stage("the picture")
        page = picture.figure(*views[0]) if len(names) == 1 else sheet([places for places, *_ in views])
        content = png_of(page, dpi="figure", metadata={"Description": " ".join(map(str, names))})
    line("written", str(write(path, content, overwrite=overwrite)))
    return GOOD


def _places(
    target: str, values: dict[str, str], duration: str | None, start: bool
) -> tuple[Places, tuple[str, ...], str]:
    """Return the places of a mechanism in its scenario, notes, and what was given; raises InputError."""
    from hertzwerk.runtime.analysis.validation import scenarios
    from hertzwerk.runtime.engine.run.run_request import METHOD
    from hertzwerk.runtime.engine.run.run_warnings import unchecked
    from hertzwerk.runtime.engine.start.start_values import split_values
    from hertzwerk.runtime.loading import engine_model
    from hertzwerk.runtime.output.drawings.picture import notes_on
    from hertzwerk.runtime.output.drawings.places import Places
    from hertzwerk.runtime.output.plots.title import differences_of
    from hertzwerk.runtime.simulation import simulate

    model = engine_model(target)
    numbers = scenarios.read(target)
    parameters, initial = split_values(model, values)
    differences = differences_of(model, parameters, initial)
    until = duration or numbers.get("duration")
    if start or until is None:
        return Places.at_start(model, parameters, initial), unchecked(model), differences
    method = numbers.get("method", METHOD)
    run = simulate(model, duration=until, tolerance=TOLERANCE, method=method, parameters=parameters, initial=initial)
    return Places.over(run), notes_on(run), differences
