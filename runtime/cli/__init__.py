"""Command line. Exit codes: 0 good, 1 another outcome, 2 bad input; commands import lazily."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import click

from hertzwerk.runtime.cli.commands.accuracy import accuracy
from hertzwerk.runtime.cli.commands.animate import animate
from hertzwerk.runtime.cli.commands.audit import audit
from hertzwerk.runtime.cli.commands.compare import compare
from hertzwerk.runtime.cli.commands.derive import derive, list_scenes
from hertzwerk.runtime.cli.commands.draw import draw
from hertzwerk.runtime.cli.commands.effects import effects
from hertzwerk.runtime.cli.commands.export import export
from hertzwerk.runtime.cli.commands.fit import fit
from hertzwerk.runtime.cli.commands.hardcases import hardcases
from hertzwerk.runtime.cli.commands.laws import laws
from hertzwerk.runtime.cli.commands.minimise import minimise
from hertzwerk.runtime.cli.commands.propagate import propagate
from hertzwerk.runtime.cli.commands.reports import report
from hertzwerk.runtime.cli.commands.run import run, validate
from hertzwerk.runtime.cli.commands.statics import modes, statics
from hertzwerk.runtime.cli.commands.studies import study
from hertzwerk.runtime.cli.commands.sweep import sweep


def _open_streams() -> None:
    """Redirect closed standard streams (`>&-`) to the null device.

    The next file opened would get a closed stream's number, and with it the printed text.
    """
    while (number := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(number)
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open("w", encoding="utf-8"))  # noqa: SIM115 - for as long as the process lives


def _print_version(context: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted:
        from hertzwerk.runtime.host.versions import versions

        click.echo(", ".join(f"{name} {version}" for name, version in versions().items()))
        context.exit()


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_version,
    help="Show the version and exit.",
)
def main() -> None:
    """Derive, unit-check, generate, run and validate contact and impact in mechanisms.

    TARGET is the name of a built-in scene (see `hertzwerk list`) or a Python file that defines `scene`; a named file is executed.
    """
    _open_streams()
    if os.environ.get("NO_COLOR"):  # https://no-color.org
        click.get_current_context().color = False


OF_SCENES = (list_scenes, laws, derive, audit, run, sweep, statics, modes, draw, animate, report, export)
OF_STUDIES = (propagate, minimise, effects, compare, fit, validate, accuracy, hardcases, study)
for command in (*OF_SCENES, *OF_STUDIES):
    main.add_command(command)
