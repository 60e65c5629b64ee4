"""`hertzwerk new`: a scene of one's own to begin with, a copy of a built-in one."""

from __future__ import annotations

import shlex
from pathlib import Path

import click

from hertzwerk.runtime.cli.terminal import GOOD, line, reports_bad_input

TEMPLATES = {  # built-in scenes by what they are called here
    "ball": "bouncing_ball",
    "pendulum": "pendulum",
    "slider-crank": "slider_crank",
    "four-bar": "four_bar_clearance",
}


@click.command(epilog="Example: hertzwerk new my_mechanism.py --template slider-crank")
@click.argument("file", type=click.Path(path_type=Path))
@click.option(
    "--template",
    type=click.Choice([*TEMPLATES]),
    default="ball",
    show_default=True,
    help="Mechanism to begin with.",
)
@reports_bad_input
def new(file: Path, template: str) -> int:
    """Write a commented scene to begin with into a new FILE.

    FILE ends in .py; an existing one is never replaced. The scene is named after it.
    """
    from hertzwerk.derive.common.faults import Fault, refuse
    from hertzwerk.derive.common.identifiers import name_faults
    from hertzwerk.runtime.analysis.validation import scenarios
    from hertzwerk.runtime.system.atomic_files import write_atomically
    from hertzwerk.runtime.system.result_folder import new_file_faults

    faults = [*name_faults(f"{file}, without its ending", file.stem), *new_file_faults("FILE", file, "name another")]
    if file.suffix != ".py":
        faults.append(Fault("FILE", str(file), "a name that ends in .py", f"{file.with_suffix('.py')}"))
    refuse("new", faults)
    scene = TEMPLATES[template]
    command = shlex.join(["hertzwerk", "run", str(file), "--duration", scenarios.read(scene)["duration"]])
    write_atomically(file, _text(scene, file.stem, command).encode())
    line("written", str(file))
    line("run it by", command)
    return GOOD


def _text(scene: str, name: str, command: str) -> str:
    """Return the text of a built-in scene under another name, and how to run it ahead of its source."""
    from hertzwerk.runtime.engine.model.build import scene_text

    about = f"{name}: a copy of the built-in scene {scene}, to begin with.\n\nRun it by `{command}`.\n\n"
    return scene_text(scene).replace('"""', f'"""{about}', 1).replace(f'"{scene}"', f'"{name}"')
