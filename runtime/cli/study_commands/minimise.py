"""`hertzwerk minimise`: best parameters for a number of a run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.runtime.cli.design_options import definition, keep, named
from hertzwerk.runtime.cli.target_options import (
    ACCURACY,
    BY_METHOD,
    DURATION,
    JSON,
    TOLERANCE,
    VARIATION,
    assignments,
    unwritable_faults,
)
from hertzwerk.runtime.cli.terminal import OTHER_OUTCOME, Progress, conclude, print_prose, reports_bad_input


@click.command(
    epilog='Example: hertzwerk minimise slider_crank --objective slider_pin.peak_force --over clearance="0.1..0.5 mm"'
)
@click.argument("target")
@click.option(
    "--objective",
    metavar="FORMULA",
    help='Output to minimise, or a formula of outputs: "main_bearing.reaction_x.rms**2 + main_bearing.reaction_y.rms**2".',
)
@click.option(
    "--over",
    metavar="NAME=RANGE",
    multiple=True,
    help='Parameter to vary and its range: clearance="0.05..0.5 mm", stiffness="1e6..1e9 N/m log".',
)
@click.option(
    "--constraint",
    "constraints",
    metavar="BOUND",
    multiple=True,
    help='Constraint on an output, by <=, >= or =: "slider_pin.peak_force <= 5 kN".',
)
@click.option(
    "--start",
    metavar="NAME=VALUE",
    multiple=True,
    help="Value of a parameter at which the search starts (default: the model's).",
)
@click.option(
    "--starts", metavar="NUMBER", type=int, help="Number of further starts, points of a Latin hypercube (default: 0)."
)
@click.option("--seed", metavar="NUMBER", type=int, help="Seed of the hypercube (default: 0).")
@click.option("--max-runs", metavar="NUMBER", type=int, help="Most runs from each start (default: 200).")
@VARIATION
@DURATION
@ACCURACY
@TOLERANCE
@BY_METHOD
@click.option(
    "--out",
    metavar="DIR",
    type=click.Path(path_type=Path),
    help="New folder of a record and a picture of all runs (default: none).",
)
@JSON
@reports_bad_input
def minimise(target: str, out: Path | None, as_json: bool, **options: Any) -> int:
    """Minimise an output of TARGET over its parameters.

    The search takes exact derivatives. A TOML file with the keys of `minimise` may take the place of TARGET and
    options. Exit code 1: no minimum was found.
    """
    refuse("minimise", unwritable_faults(out, wanted=out is not None))

    def own(faults: list[Fault]) -> dict[str, Any]:
        return {
            "objective": options["objective"],
            "over": assignments("--over", options["over"], faults),
            "constraints": named("--constraint", options["constraints"], "<= >= =", faults),
            "start": assignments("--start", options["start"], faults) or None,
            **{name: options[name] for name in ("starts", "seed", "max_runs") if options[name] is not None},
        }

    with Progress(f"minimum of {target}", shown=not as_json) as progress:
        progress.stage("searching")
        from hertzwerk.runtime.studies.minimisation import minimisation

        minimum = minimisation.minimise(
            **definition(target, options, own, minimisation.minimise),
            progress=progress,
        )
    code = conclude(
        lambda missing: keep(minimum, out or Path(), "minimum", missing),
        minimum.record,
        lambda: print_prose(str(minimum), indent=4),
        wanted=out is not None,
        as_json=as_json,
    )
    return code if minimum.outcome.finished else OTHER_OUTCOME
