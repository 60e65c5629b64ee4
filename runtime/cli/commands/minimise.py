"""`hertzwerk minimise`: best parameters for a number of a run."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import click

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.cli.designing import definition, keep, named
from hertzwerk.runtime.cli.target import ACCURACY, BY_METHOD, DURATION, JSON, VARIATION, assignments, unwritable_faults
from hertzwerk.runtime.cli.terminal import GOOD, OTHER_OUTCOME, print_prose, report_missing, reports_bad_input


@click.command()
@click.argument("target")
@click.option(
    "--objective",
    metavar="FORMULA",
    help='Output or formula: "main_bearing.reaction_x.rms**2 + main_bearing.reaction_y.rms**2".',
)
@click.option(
    "--over",
    metavar="NAME=RANGE",
    multiple=True,
    help='What is varied: clearance="0.05..0.5 mm", stiffness="1e6..1e9 N/m log".',
)
@click.option(
    "--constraint",
    "constraints",
    metavar="BOUND",
    multiple=True,
    help='Such as "slider_pin.peak_force <= 5 kN", or with >= or =.',
)
@click.option("--start", metavar="NAME=VALUE", multiple=True, help="Values to begin with (default: the model's).")
@click.option("--starts", metavar="NUMBER", type=int, help="Further starts, of a Latin hypercube (default: 0).")
@click.option("--seed", metavar="NUMBER", type=int, help="Of the hypercube (default: 0).")
@click.option("--max-runs", metavar="NUMBER", type=int, help="Where to stop, from each start (default: 200).")
@VARIATION
@DURATION
@ACCURACY
@click.option("--tolerance", metavar="NUMBER", help="In its place the local tolerance of one run each.")
@BY_METHOD
@click.option(
    "--into", metavar="DIR", type=click.Path(path_type=Path), help="New folder for a record, and a picture of all runs."
)
@JSON
@reports_bad_input
def minimise(target: str, into: Path | None, as_json: bool, **options: Any) -> int:
    """Find the parameters of TARGET for which a number of its run is least, by exact derivatives.

    TARGET may be a TOML file with the keys of `minimise`. Exit code 1: no minimum was found.
    """
    from hertzwerk.runtime.design import minimisation

    wrong = [
        replace(fault, where="--into", remedy="name another")
        for fault in unwritable_faults(into, wanted=into is not None)
    ]
    if wrong:
        raise InputError("minimise", wrong)

    def own(faults: list[Fault]) -> dict[str, Any]:
        return {
            "objective": options["objective"],
            "over": assignments("--over", options["over"], faults),
            "constraints": named("--constraint", options["constraints"], "<= >= =", faults),
            "start": assignments("--start", options["start"], faults) or None,
            **{name: options[name] for name in ("starts", "seed", "max_runs") if options[name] is not None},
        }

    found = minimisation.minimise(
        **definition(target, options, own, minimisation.minimise, ("target", "objective", "over", "duration"))
    )
    missing = [] if into is None else keep(found, into, "minimum")
    if as_json:
        click.echo(json.dumps(found.record(), indent=2, ensure_ascii=False))
    else:
        print_prose(str(found), indent=4)
    return GOOD if found.outcome.finished and not report_missing(missing) else OTHER_OUTCOME
