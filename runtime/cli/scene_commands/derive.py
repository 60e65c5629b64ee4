"""`hertzwerk list`, `derive`: the built-in scenes, and the text of generated modules."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.runtime.cli.target_options import COORDINATES, LAW, WITHOUT, Variation
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input, table


@click.command("list", epilog="Example: hertzwerk list slider_crank")
@click.argument("target", required=False)
@WITHOUT
@LAW
@COORDINATES
@reports_bad_input
def list_scenes(target: str | None, **options: Any) -> int:
    """List the built-in scenes, or effects and histories of TARGET.

    Histories with unit and meaning.
    """
    if target is not None:
        return _list_contents(Variation.taken(target, options))
    from hertzwerk.runtime.engine.model.regenerate import generated_names, summary_of

    table(("scene", "summary"), [(name, summary_of(name)) for name in generated_names()])
    return GOOD


def _list_contents(varied: Variation) -> int:
    """Print the effects of a target, and every history: those always there, then those derived on request."""
    from hertzwerk.runtime.output.tables.history_meanings import SECTIONS, entries

    faults: list[Fault] = []
    model = varied.model(faults)
    refuse("list", faults)
    click.echo(f"{model.name}: effects")
    table(("effect", "meaning"), [(name, meaning) for name, _, meaning in model.module.EFFECTS])
    histories = entries(model)
    for derived, title in SECTIONS:
        rows = [(entry.name, entry.unit, entry.meaning) for entry in histories if entry.derived == derived]
        click.echo(f"{model.name}: {title}")
        table(("history", "unit", "meaning"), rows)
    return GOOD


@click.command(epilog="Example: hertzwerk derive my_ball.py --out modules")
@click.argument("targets", metavar="TARGET...", nargs=-1)
@click.option(
    "--check", is_flag=True, help="Write nothing; compare with the existing modules (default: of all built-in scenes)."
)
@click.option("--out", type=click.Path(path_type=Path), help="Folder to write to (default: that of the scene's file).")
@click.option(
    "--coordinates",
    metavar="NAME",
    help="Coordinates of the equations: tree (of the joints), absolute (of every body) or auto "
    "(default: the scene's; with --check those of the module in place).",
)
@click.option("--show", is_flag=True, help="Write nothing; print the equations as Markdown with LaTeX.")
@click.option("--json", "as_json", is_flag=True, help="With --show, print one JSON object.")
@reports_bad_input
def derive(
    targets: tuple[str, ...], check: bool, out: Path | None, coordinates: str | None, show: bool, as_json: bool
) -> int:
    """Derive the equations of TARGET and write its module.

    Every unit is checked. Exit code 1: with --check, a module differs.
    """
    from hertzwerk.runtime.engine.model import regenerate
    from hertzwerk.runtime.engine.model.build import built_in_scenes, in_python, require_targets
    from hertzwerk.runtime.system.result_folder import unwritable

    if show or as_json:
        beside = {"--check": check, "--out": out is not None, "--json without --show": not show}
        expected = "--show by itself, or with --json"
        refuse("derive", [Fault("derive", option, expected) for option, there in beside.items() if there])
    elif coordinates is not None and out is None and not all(map(in_python, targets)):
        expected = "a folder for modules other than those of generated/"
        raise InputError(
            "derive", [Fault("--coordinates without --out", coordinates, expected, "name a folder: --out DIR")]
        )
    if check:
        return _compare(targets or built_in_scenes(), coordinates, out, everything=not targets)
    if not targets:
        example = " ".join(built_in_scenes()[:2])
        raise InputError("derive", [Fault("TARGET", "none", f"scenes or files, such as {example}")])
    if show:
        return _show(targets, coordinates, as_json=as_json)
    require_targets(targets)
    folders = dict.fromkeys([out] if out is not None else map(regenerate.folder_of, targets))
    hindrances = [hindrance for folder in folders if (hindrance := unwritable(folder)) is not None]
    refuse("derive", [Fault("--out", each, "a folder that can be written to") for each in hindrances])
    with Progress("derive") as progress:
        modules = regenerate.derived(progress.over(targets), coordinates)
    for path in regenerate.write(modules, out):
        line("written", str(path))
    return GOOD


def _show(targets: Sequence[str], coordinates: str | None, *, as_json: bool) -> int:
    """Print the equations of all targets or of none."""
    from hertzwerk.runtime.engine.model import regenerate

    with Progress("derive", shown=not as_json) as progress:
        shown = regenerate.shown(progress.over(targets), coordinates)
    if as_json:
        click.echo(json.dumps({"equations": [each.record() for each in shown]}, indent=2, ensure_ascii=False))
    else:
        click.echo("\n".join(each.markdown() for each in shown))
    return GOOD


def _compare(targets: Sequence[str], coordinates: str | None, folder: Path | None, *, everything: bool) -> int:
    """Report for each module whether the one in place equals the one derived from its scene."""
    from hertzwerk.runtime.engine.model import regenerate

    with Progress("derive") as progress:
        modules = regenerate.compared(progress.over(targets), coordinates, folder)
    for name, difference in modules:
        if difference is None:
            line("consistent", f"{name}: the module in place equals the one derived from its scene")
            continue
        click.echo(difference.diff, nl=False)
        action = "accept" if difference.diff else f"no module at {difference.place}; write it"
        line("different", f"{name}: {action} with `{difference.accept}`")
    good = all(difference is None for _, difference in modules)
    orphans = set(regenerate.generated_names()) - {name for name, _ in modules} if everything else set()
    for name in sorted(orphans):
        line("different", f"{name}: a generated module without a scene; remove generated/{name}.py")
    return GOOD if good and not orphans else OTHER_OUTCOME
