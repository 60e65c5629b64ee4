"""`hertzwerk propagate`: propagate parameter uncertainty to the outputs of a run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.runtime.cli.design_options import definition, keep
from hertzwerk.runtime.cli.target_options import (
    ACCURACY,
    BY_METHOD,
    DURATION,
    JSON,
    TOLERANCE,
    VARIATION,
    assignments,
    number,
)
from hertzwerk.runtime.cli.terminal import (
    OTHER_OUTCOME,
    Progress,
    conclude,
    print_prose,
    report_damage,
    reports_bad_input,
)


@click.command(epilog='Example: hertzwerk propagate bouncing_ball --uncertain "restitution=Uniform(0.7, 0.9)"')
@click.argument("target")
@click.option(
    "--uncertain",
    metavar="NAME=DISTRIBUTION",
    multiple=True,
    help='Distribution of a parameter or initial state: clearance="Normal(0.5 mm, 0.02 mm)", '
    'restitution="TruncatedNormal(0.9, 0.05, 0, 1)"; or Uniform(low, high), Triangular(low, mode, high), LogNormal(median, factor).',
)
@click.option(
    "--correlation",
    metavar="NAME,NAME=NUMBER",
    multiple=True,
    help='Correlation of two of them, by normal scores: "clearance, restitution=-0.8" (default: 0).',
)
@click.option(
    "--fitted",
    metavar="FOLDER",
    type=click.Path(path_type=Path),
    help="Take distribution and correlation from this folder, which `hertzwerk fit` wrote.",
)
@click.option(
    "--output",
    "outputs",
    metavar="NAME",
    multiple=True,
    help="Output, named as in `hertzwerk sweep`: slider_pin.peak_force (default: final states).",
)
@click.option("--sample", metavar="NUMBER", type=int, help="Number of samples, a power of two (default: 256).")
@click.option("--seed", metavar="NUMBER", type=int, help="Seed of the samples (default: 0).")
@click.option("--no-indices", is_flag=True, help="Compute no Sobol indices: one run per sample.")
@VARIATION
@DURATION
@ACCURACY
@TOLERANCE
@BY_METHOD
@click.option(
    "--out",
    metavar="DIR",
    type=click.Path(path_type=Path),
    help="Folder of the runs, a record and a picture, new or of the same command, which it continues (default: none).",
)
@click.option(
    "--table", "file", metavar="FILE", type=click.Path(path_type=Path), help="Write one line per output to a new file."
)
@JSON
@reports_bad_input
def propagate(target: str, out: Path | None, file: Path | None, as_json: bool, **options: Any) -> int:
    """Propagate uncertain parameters through TARGET.

    By derivatives and by samples, with Sobol indices. A TOML file with the keys of `propagate` may take the place of
    TARGET and options. Exit code 1: runs are missing.
    """
    from hertzwerk.runtime.system.result_folder import new_file_faults

    def own(faults: list[Fault]) -> dict[str, Any]:
        stated = assignments("--uncertain", options["uncertain"], faults)
        tied = {a: number(b) for a, b in assignments("--correlation", options["correlation"], faults).items()}
        return {
            "uncertain": stated if options["fitted"] is None else _of_fit(options["fitted"], stated or tied, faults),
            **({"correlation": tied} if tied else {}),
            "outputs": options["outputs"],
            **{name: options[name] for name in ("sample", "seed") if options[name] is not None},
            **({"indices": False} if options["no_indices"] else {}),
        }

    refuse("propagate", [] if file is None else new_file_faults("--table", file))
    with Progress(f"uncertainty of {target}", shown=not as_json) as progress:
        from hertzwerk.runtime.studies.uncertainty import propagation

        arguments = definition(target, options, own, propagation.propagate)
        propagated = propagation.propagate(**arguments, out=out, progress=progress)
    if file is not None:
        propagated.to_csv(file)

    def report() -> None:
        print_prose(str(propagated), indent=4)
        report_damage(propagated.samples.damage)

    code = conclude(
        lambda missing: keep(propagated, out or Path(), "propagation", missing),
        propagated.record,
        report,
        wanted=out is not None,
        as_json=as_json,
    )
    return OTHER_OUTCOME if propagated.notes else code


def _of_fit(folder: Path, beside: object, faults: list[Fault]) -> Any:
    """Return the distribution that a fit wrote into a folder; bad input is appended to `faults`."""
    from hertzwerk.runtime.studies.uncertainty.correlation import Correlated
    from hertzwerk.runtime.system.digests import read_sealed

    if beside:
        faults.append(Fault("--fitted", "beside --uncertain or --correlation", "one of the two"))
    try:
        distribution = read_sealed(folder / "fit.json")["distribution"]
        return Correlated(**distribution)
    except (OSError, ValueError, KeyError, TypeError) as error:
        expected = "a folder that `hertzwerk fit` wrote, of a fit whose data identify all its quantities"
        faults.append(Fault("--fitted", f"{folder}: {type(error).__name__}: {error}", expected))
    return {}
