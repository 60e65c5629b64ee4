"""`hertzwerk statics`, `modes`: where a mechanism comes to rest, and its small vibrations about that."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import InputError, refuse
from hertzwerk.runtime.cli.target_options import JSON, VARIATION, Variation, assignments, together
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, draw_into, line, reports_bad_input, table
from hertzwerk.runtime.system.digests import json_text

if TYPE_CHECKING:
    from hertzwerk.runtime.analysis.statics.equilibrium import Equilibrium
    from hertzwerk.runtime.analysis.statics.vibrations import Modes

MOVED = 1e-6  # part of a shape below which a coordinate is not printed
EQUILIBRIUM = together(
    click.argument("target"),
    VARIATION,
    click.option(
        "--at",
        metavar="TIME",
        default="0",
        help='Time at which drives and loads are held, such as "2 ms" (default: 0).',
    ),
    click.option(
        "--nearest", is_flag=True, help="Find the equilibrium nearest to the start, stable or not, by Newton's method."
    ),
    click.option("--out", metavar="FILE", type=click.Path(path_type=Path), help="Draw into a new PNG file."),
    JSON,
)


@click.command(epilog="Example: hertzwerk statics four_bar_clearance")
@EQUILIBRIUM
@reports_bad_input
def statics(out: Path | None, as_json: bool, **options: Any) -> int:
    """Find where TARGET comes to rest.

    Drives are held. It prints position, contact and drive forces, and stability. Exit code 1: there is no position of
    rest.
    """
    rest = _read(Variation.taken(options.pop("target"), options), out=out, **options)
    if as_json:
        record = {
            "scene": rest.model.name,
            "outcome": {"name": rest.outcome.name, "message": rest.outcome.message, "remedy": rest.outcome.remedy},
            "stable": rest.stable,
            "values": [dict(zip(("kind", "name", "value", "unit"), row, strict=True)) for row in rest.rows],
            "indifferent": rest.indifferent,
            "indeterminate": rest.indeterminate,
            "notes": rest.notes,
        }
        click.echo(json_text(record))
    else:
        line(rest.model.name, rest.outcome.message)
        if rest.outcome.remedy:
            line("remedy", rest.outcome.remedy)
        if rest.converged:
            table(("what", "name", "value", "unit"), [(kind, name, f"{x:.9g}", of) for kind, name, x, of in rest.rows])
        for note in rest.notes:
            line("note", note)
    if rest.converged:
        draw_into(out, rest.plot, announced=not as_json)
    return GOOD if rest.converged else OTHER_OUTCOME


@click.command(epilog="Example: hertzwerk modes double_pendulum")
@EQUILIBRIUM
@reports_bad_input
def modes(out: Path | None, as_json: bool, **options: Any) -> int:
    """Compute the small vibrations of TARGET about its rest.

    Drives are held. It prints frequencies, damping ratios and shapes. Exit code 1: there is no position of rest.
    """
    rest = _read(Variation.taken(options.pop("target"), options), out=out, **options)
    from hertzwerk.runtime.analysis.statics.vibrations import modes as modes_of

    vibrations = modes_of(rest) if rest.converged else None
    if as_json:
        record = {
            "scene": rest.model.name,
            "equilibrium": rest.outcome.name,
            "stable": vibrations is not None and vibrations.stable,
            "modes": [
                {
                    "eigenvalue": [mode.eigenvalue.real, mode.eigenvalue.imag],
                    "frequency": mode.frequency,
                    "damping_ratio": mode.damping_ratio if mode.eigenvalue else None,
                    "shape": {name: [x.real, x.imag] for name, x in mode.shape.items()},
                }
                for mode in vibrations or ()
            ],
            "notes": vibrations.notes if vibrations else rest.outcome.remedy,
        }
        click.echo(json_text(record))
    elif vibrations is None:
        line(rest.model.name, rest.outcome.message)
        line("remedy", rest.outcome.remedy)
    else:
        count = f"{len(vibrations)} mode{'' if len(vibrations) == 1 else 's'}"
        line(rest.model.name, f"{rest.outcome.message}; {count}")
        for number, mode in enumerate(vibrations, 1):
            line(f"mode {number}", str(mode))
        table(("mode", "coordinate", "amplitude", "unit", "phase [deg]"), list(_shapes(vibrations)))
        for note in vibrations.notes:
            line("note", note)
    if vibrations is None:
        return OTHER_OUTCOME
    if any(mode.eigenvalue for mode in vibrations):
        draw_into(out, vibrations.plot, announced=not as_json)
    return GOOD


def _shapes(vibrations: Modes) -> Iterator[tuple[str, ...]]:
    """Yield mode, coordinate, amplitude, unit and phase [deg] of what moves in each mode."""
    for number, mode in enumerate(vibrations, 1):
        moving = [name for name, x in mode.shape.items() if abs(x) > MOVED]
        for i, name in enumerate(moving):
            x = mode.shape[name]
            phase = math.degrees(cmath.phase(x)) if abs(x.imag) > MOVED * abs(x) else 180.0 if x.real < 0 else 0.0
            yield "" if i else str(number), name, f"{abs(x):.4g}", vibrations.model.units[name], f"{phase:.4g}"


def _read(
    varied: Variation,
    *,
    at: str,
    nearest: bool,
    out: Path | None,
) -> Equilibrium:
    """Return the equilibrium of a target's variation; raises InputError with every fault."""
    from hertzwerk.runtime.system.result_folder import new_file_faults

    faults = [] if out is None else new_file_faults("--out", out)
    values = varied.values(faults)
    with Progress(varied.target) as progress:
        from hertzwerk.runtime.analysis.statics.equilibrium import equilibrium
        from hertzwerk.runtime.engine.start.start_values import split_values

        progress.stage("building")
        model = varied.model(faults)
        parameters, initial = split_values(model, values)
        progress.stage("finding the position of rest")
        try:
            inputs = assignments("--input", varied.inputs, faults)
            rest = equilibrium(model, parameters=parameters, initial=initial, inputs=inputs, at=at, nearest=nearest)
        except InputError as error:
            raise InputError(error.subject, [*faults, *error.faults]) from error
    refuse(model.name, faults)
    return rest
