"""`hertzwerk animate`: films of mechanisms in motion."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime.cli.target import BY_METHOD, DURATION, LAW, SET, WITHOUT, assignments, loaded, number
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.simulation import Solution

TOLERANCE = 1e-6  # local; finer than a picture shows


@click.command()
@click.argument("target")
@SET
@WITHOUT
@LAW
@DURATION
@BY_METHOD
@click.option("--fps", metavar="NUMBER", default="25", help="Frames a second (default: 25).")
@click.option(
    "--slow",
    metavar="NUMBER",
    help="Seconds of film for a second of motion: 100 is slower, 0.1 faster (default: what makes about 8 s).",
)
@click.option(
    "--out", type=click.Path(path_type=Path), help="File to write: .gif, .mp4 or .html (default: TARGET.gif)."
)
@click.option("--overwrite", is_flag=True, help="Write it in place of another.")
@reports_bad_input
def animate(
    target: str,
    settings: Sequence[str],
    without: Sequence[str],
    laws: Sequence[str],
    duration: str | None,
    method: str | None,
    fps: str,
    slow: str | None,
    out: Path | None,
    overwrite: bool,
) -> int:
    """Film the mechanism of TARGET in motion, with clearances enlarged and contact forces as arrows.

    Paths of journals grow, the largest forces since the frame before are shown.
    Ctrl-C ends the film with the frames so far (exit code 1).
    """
    from hertzwerk.runtime.host.interrupt import raise_interrupts
    from hertzwerk.runtime.pictures.motion.film import animate as film_of
    from hertzwerk.runtime.pictures.motion.film import path_faults

    path = out or Path(f"{Path(target).stem}.gif")
    faults = path_faults(path, overwrite=overwrite)
    values = assignments("--set", settings, faults)
    model = loaded(target, without, laws, faults)
    if faults:
        raise InputError("animate", faults)
    with raise_interrupts(), Progress(target, shown=sys.stderr.isatty()) as progress:
        progress.stage("running")
        run = _run(model, target, values, duration, method, progress)
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
    model: Model, target: str, values: dict[str, str], duration: str | None, method: str | None, progress: Progress
) -> Solution:
    """Run the model in its scenario; raises InputError."""
    from hertzwerk.runtime.run.request import METHOD
    from hertzwerk.runtime.simulation import simulate
    from hertzwerk.runtime.start.start_values import split_values
    from hertzwerk.runtime.validate import scenarios

    numbers = scenarios.read(target)
    parameters, initial = split_values(model, values)
    run = simulate(
        model,
        duration=duration or numbers.get("duration"),
        tolerance=TOLERANCE,
        method=method or numbers.get("method", METHOD),
        parameters=parameters,
        initial=initial,
        progress=progress,
    )
    if run.outcome.name == "interrupted":
        raise KeyboardInterrupt
    return run
