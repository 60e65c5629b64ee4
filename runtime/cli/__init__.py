"""Command line. Exit codes: 0 good, 1 another outcome, 2 bad input; commands import lazily."""

from __future__ import annotations

import os
import sys
from importlib import import_module
from inspect import cleandoc
from pathlib import Path

import click

GROUPS = {  # commands by what they are for, each with its file
    "Run and look": {
        "run": "run_commands.run",
        "list": "scene_commands.derive",
        "draw": "scene_commands.draw",
        "animate": "run_commands.animate",
        "report": "run_commands.report",
        "handbook": "run_commands.handbook",
    },
    "Vary": {
        "sweep": "study_commands.sweep",
        "propagate": "study_commands.propagate",
        "minimise": "study_commands.minimise",
        "effects": "study_commands.effects",
        "study": "study_commands.study",
    },
    "Analyse": {
        "statics": "run_commands.statics",
        "modes": "run_commands.statics",
        "rigid": "study_commands.rigid",
        "accuracy": "study_commands.accuracy",
        "validate": "run_commands.run",
        "hardcases": "study_commands.hardcases",
    },
    "Measure and fit": {"compare": "study_commands.compare", "fit": "study_commands.fit"},
    "Equations and files": {
        "new": "scene_commands.new",
        "derive": "scene_commands.derive",
        "export": "scene_commands.export",
        "laws": "scene_commands.laws",
        "audit": "scene_commands.audit",
    },
}
FILES = {name: file for group in GROUPS.values() for name, file in group.items()}
FIRST = {  # lines to type, in this order
    "hertzwerk list": "list the built-in scenes",
    "hertzwerk run slider_crank": "simulate one, with pictures in runs/",
    "hertzwerk list slider_crank": "list its effects and histories",
    "hertzwerk new my_mechanism.py": "write a scene of your own to begin with",
    "hertzwerk COMMAND --help": "describe a command, with an example",
}

TARGET = (
    "TARGET is a built-in scene (`hertzwerk list`), a Python file that defines `scene`, which is executed, FILE.py:NAME, "
    "package.module:NAME, or a generated module."
)


class _Commands(click.Group):
    """Commands by name, each imported when it is needed: a run has no use for the others."""

    def list_commands(self, _: click.Context) -> list[str]:
        return sorted({*FILES, *self.commands})

    def get_command(self, context: click.Context, name: str) -> click.Command | None:
        if name in FILES and name not in self.commands:
            there = vars(import_module(f"hertzwerk.runtime.cli.{FILES[name]}")).values()
            command = next(command for command in there if isinstance(command, click.Command) and command.name == name)
            if any((each.metavar or str(each.name).upper()).strip("[].") == "TARGET" for each in command.params):
                command.help = f"{cleandoc(str(command.help))}\n\n{TARGET}"
            self.add_command(command)
        return super().get_command(context, name)

    def format_commands(self, context: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the commands to begin with, then all by what they are for."""
        with formatter.section("To begin with"):
            formatter.write_dl(list(FIRST.items()))
        width = max(map(len, FILES))
        for title, names in GROUPS.items():
            rows = [(name.ljust(width), command) for name in names if (command := self.get_command(context, name))]
            with formatter.section(title):
                formatter.write_dl([(name, command.get_short_help_str(formatter.width)) for name, command in rows])


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
        from hertzwerk.runtime.system.versions import versions

        click.echo(", ".join(f"{name} {version}" for name, version in versions().items()))
        context.exit()


@click.group(cls=_Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
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

    TARGET is a built-in scene, or a Python file that defines `scene`, which is executed.
    """
    _open_streams()
    if os.environ.get("NO_COLOR"):  # https://no-color.org
        click.get_current_context().color = False
