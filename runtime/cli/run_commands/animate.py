"""`hertzwerk animate`: films of mechanisms in motion."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.cli.continue_run import grid_of
from hertzwerk.runtime.cli.target_options import BY_METHOD, DURATION, GRID, VARIATION, Variation, number, run_settings
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input

if TYPE_CHECKING:
    from hertzwerk.runtime.simulation import Solution

TOLERANCE = 1e-6  # local; finer than a picture shows


@click.command(epilog="Example: hertzwerk animate slider_crank --out crank.mp4")
@click.argument("target")
@VARIATION
@DURATION
@click.option(
    "--accuracy",
    metavar="NUMBER",
    help="Largest error of the whole run, in the scene's scales (default: a local tolerance of 1e-6 instead).",
)
@BY_METHOD
@GRID
@click.option("--fps", metavar="NUMBER", default="25", help="Frames per second (default: 25).")
@click.option(
    "--slow",
    metavar="NUMBER",
    help="Seconds of film per second of motion: 100 is slow motion (default: a film of about 8 s).",
)
@click.option(
    "--out", type=click.Path(path_type=Path), help="File to write: .gif, .mp4 or .html (default: TARGET.gif)."
)
@click.option("--overwrite", is_flag=True, help="Replace an existing file.")
@reports_bad_input
def animate(
    target: str,
    fps: str,
    slow: str | None,
    out: Path | None,
    overwrite: bool,
    **options: Any,
) -> int:
    """Film the mechanism of TARGET as GIF, MP4 or HTML.

    Clearances are enlarged. Contact forces are arrows, each the largest since the last frame; the paths of journals
    grow. With --grid, up to 100000 steps are still kept for the film. Ctrl-C ends the film with the frames so far
    (exit code 1).
    """
    from hertzwerk.runtime.system.interrupt import raise_interrupts

    path = out or Path(f"{Path(target).stem}.gif")
    with raise_interrupts(), Progress(target) as progress:
        from hertzwerk.runtime.output.films.film import animate as film_of
        from hertzwerk.runtime.output.films.film import path_faults

        progress.stage("running")
        run = _run(Variation.taken(target, options), path_faults(path, overwrite=overwrite), progress, **options)
        progress.stage("drawing")
        made = film_of(
            run,
            path,
            fps=number(fps),
            slow=None if slow is None else number(slow),
            overwrite=overwrite,
            progress=progress,
        )
    if not run.outcome.finished:
        line(run.outcome.name, run.outcome.message)
    line("film", f"{made.frames} frames, {made.clock.pace()[0].lower()}{made.clock.pace()[1:]}")
    line("written", str(made.path))
    if made.frames < made.of:
        line("interrupted", f"it ends at {made.clock.shown(made.frames - 1)}, after {made.frames} of {made.of} frames")
    return GOOD if made.frames == made.of and run.outcome.finished else OTHER_OUTCOME


def _run(
    varied: Variation,
    faults: list[Fault],
    progress: Progress,
    *,
    duration: str | None,
    accuracy: str | None,
    method: str | None,
    grid: str | None,
) -> Solution:
    """Run the model in its scenario; raises InputError with `faults` and those of every option."""
    from hertzwerk.runtime.engine.run.run_request import Settings

    stated = run_settings(varied.target, duration=duration, accuracy=accuracy, method=method)
    stated |= {"accuracy": None, "tolerance": TOLERANCE} if accuracy is None else {}
    settled = Settings(**stated, grid=grid_of(grid))
    run = varied.solved(settled, faults, progress)
    if run.outcome.name == "interrupted":
        raise KeyboardInterrupt
    return run
