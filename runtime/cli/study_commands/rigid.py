"""`hertzwerk rigid`: a scene with rigid contacts, beside compliant runs of growing stiffness."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import click

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.runtime.cli.target_options import DURATION, JSON, VARIATION, Variation, number, run_settings
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, Progress, draw_into, reports_bad_input, table
from hertzwerk.runtime.system.digests import json_text

PAIR = "for all contact pairs, or PAIR=VALUE for one"


@click.command(
    epilog="Example: hertzwerk rigid bouncing_ball --law floor=exact --restitution restitution --stiffness stiffness --duration '3 s'"
)
@click.argument("target")
@click.option("--restitution", metavar="[PAIR=]VALUE", multiple=True,
              help=f"Coefficient of restitution, a number or a parameter's name, {PAIR} (default: 0).")  # fmt: skip
@click.option("--friction", metavar="[PAIR=]VALUE", multiple=True,
              help=f"Coefficient of friction, likewise, {PAIR} (default: 0).")  # fmt: skip
@click.option(
    "--rule",
    default="newton",
    help="Meaning of the restitution: newton, of speeds, or poisson, of impulses (default: newton).",
)
@click.option("--impacts", default="together",
              help="Contacts that touch at one time take their impulses together, or 'in turn' (default: together).")  # fmt: skip
@click.option(
    "--stiffness",
    metavar="NAME",
    default="",
    help="Parameter whose multiples compliant runs take (default: no such runs).",
)
@click.option("--factors", metavar="NUMBERS", default="1,10,100", help="Those multiples (default: 1,10,100).")
@VARIATION
@DURATION
@click.option("--out", metavar="FILE", type=click.Path(path_type=Path), help="Draw into a new PNG file.")
@JSON
@reports_bad_input
def rigid(target: str, out: Path | None, as_json: bool, **options: Any) -> int:
    """Run TARGET with rigid contacts, impacts at an instant.

    With --stiffness, compliant runs of growing stiffness stand beside it. Exit code 1: the run ended early.
    """
    from hertzwerk.runtime.system.result_folder import new_file_faults

    faults = [] if out is None else new_file_faults("--out", out)
    varied = Variation.taken(target, options)
    if varied.inputs:
        faults.append(Fault("--input", "values of inputs", "a scene without inputs"))
    with Progress(target, shown=not as_json) as progress:
        from hertzwerk.runtime.analysis.rigid_limit.rigid_impact import RigidImpact
        from hertzwerk.runtime.analysis.rigid_limit.rigid_limit import rigid_limit

        progress.stage("building")
        model, values = varied.model(faults), varied.values(faults)
        restitution, friction = (
            _by_pair(f"--{name}", options[name], model.pairs, faults) for name in ("restitution", "friction")
        )
        refuse("rigid", faults)
        progress.stage("running")
        limit = rigid_limit(
            model,
            {pair: RigidImpact(restitution[pair], friction[pair], options["rule"]) for pair in model.pairs},
            duration=run_settings(target, duration=options["duration"])["duration"],
            parameters=values,
            impacts=options["impacts"],
            stiffness=options["stiffness"],
            factors=[number(text.strip()) for text in options["factors"].split(",")],
            progress=progress,
        )
    if as_json:
        click.echo(json_text(limit.record()))
    else:
        for text in limit.lines:
            click.echo(text)
        table(*limit.rows)
        if limit.outcome.finished:
            apart, end = limit.differences
            click.echo(
                f"error by a run with a hundredth of the tolerance: {apart:.1g} s of impacts, {end:.1g} of its scales at the end"
            )
    draw_into(out, limit.plot, announced=not as_json)
    return GOOD if limit.outcome.finished else OTHER_OUTCOME


def _by_pair(option: str, texts: Sequence[str], pairs: Sequence[str], faults: list[Fault]) -> dict[str, Any]:
    """Return the value of each pair by texts "VALUE" or "PAIR=VALUE"; faults are appended."""
    values: dict[str, Any] = dict.fromkeys(pairs, 0.0)
    for text in texts:
        pair, equals, value = (part.strip() for part in text.rpartition("="))
        if equals and pair not in pairs:
            faults.append(Fault(option, repr(text), f"VALUE, or PAIR=VALUE with one of {', '.join(pairs)}"))
        values |= dict.fromkeys([pair] if equals else pairs, number(value))
    return values
