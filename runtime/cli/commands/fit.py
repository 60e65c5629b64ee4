"""`hertzwerk fit`: parameters from measurements."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.cli.target import (
    BY_METHOD,
    DURATION,
    JSON,
    VARIATION,
    assignments,
    loaded,
    number,
    unwritable_faults,
)
from hertzwerk.runtime.cli.terminal import OTHER_OUTCOME, Progress, conclude, line, reports_bad_input

if TYPE_CHECKING:
    from hertzwerk.runtime.fitting.fitted import Fitted
    from hertzwerk.runtime.model.model import Model


@click.command()
@click.argument("target")
@click.option(
    "--measured",
    metavar="FILE",
    multiple=True,
    required=True,
    help="CSV with headings `name [unit]`: over time, with a column `t [s]`, or of impacts, with a column `impact [1]`. "
    "Given again, several runs are fitted at once.",
)
@click.option(
    "--map",
    "columns",
    metavar="COLUMN=HISTORY",
    multiple=True,
    help="Column and what it is compared with: height=vertical.travel; of impacts t=impacts.t, v=floor.impacts.speed, "
    "rise=impacts.rebound.vertical.travel (default: equal names).",
)
@click.option(
    "--free",
    metavar="NAME=RANGE",
    multiple=True,
    required=True,
    help='What is fitted: restitution=0.3..1, stiffness="1e6..1e9 N/m log", clearance=log; NAME alone takes the range of its law.',
)
@click.option(
    "--noise",
    metavar="COLUMN=SIZE",
    multiple=True,
    help='Standard deviation of the measurement\'s noise: height="0.1 mm" (default: taken from the residuals; nothing is judged).',
)
@click.option(
    "--at",
    "made_at",
    metavar="FILE:NAME=VALUE",
    multiple=True,
    help='Value that one measured run was made at: --at second.csv:drop_height="0.5 m".',
)
@click.option(
    "--offset", metavar="RANGE", default="0 s", help='Run time less measured time: "-2..2 ms" is fitted for each run.'
)
@click.option(
    "--gain", metavar="COLUMN=RANGE", multiple=True, help="Gain of a sensor that is fitted: height=0.95..1.05."
)
@VARIATION
@DURATION
@click.option("--tolerance", metavar="NUMBER", help="Local, of the runs (default: 1e-9).")
@BY_METHOD
@click.option(
    "--starts", type=int, help="Points of a Latin hypercube to start from, beside the model's values (default: 16)."
)
@click.option("--seed", type=int, help="Of the hypercube (default: 0).")
@click.option(
    "--profile",
    type=click.Choice(["auto", "all", "none"]),
    default="auto",
    show_default=True,
    help="Whose intervals are by profile likelihood; auto: of what is badly told.",
)
@click.option(
    "--into", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-fit-NNN)."
)
@click.option("--no-plots", is_flag=True, help="Write the data only.")
@JSON
@reports_bad_input
def fit(target: str, into: Path | None, no_plots: bool, as_json: bool, **options: Any) -> int:
    """Fit parameters of TARGET to measured data, with exact derivatives through impacts.

    Reported are values with intervals and how each was obtained, combinations that the data cannot tell, goodness of fit.
    Exit code 1: the model is rejected at 5 %, or there is such a combination.
    """
    wanted = into is not None or not as_json
    faults = [replace(fault, where="--into", remedy="name another: --into FOLDER") if fault.where == "--out" else fault
              for fault in unwritable_faults(into, wanted=wanted)]  # fmt: skip
    with Progress(f"fit of {target}", shown=not as_json and sys.stderr.isatty()) as progress:
        found = _fitted(target, faults, progress, **options)
    code = conclude(
        lambda missing: _write(found, into, missing, plots=not no_plots),
        found.record,
        lambda: _report(found),
        wanted=wanted,
        as_json=as_json,
    )
    return OTHER_OUTCOME if found.explained is False or found.untold else code


def _fitted(
    target: str,
    faults: list[Fault],
    progress: Progress,
    *,
    settings: Sequence[str],
    inputs: Sequence[str],
    without: Sequence[str],
    laws: Sequence[str],
    coordinates: str | None,
    **options: Any,
) -> Fitted:
    """Return the fit of a command line; raises InputError with every fault."""
    from hertzwerk.runtime.fitting.fitting import fitted, read_fit

    values, given = assignments("--set", settings, faults), assignments("--input", inputs, faults)
    progress.stage("building")
    model = loaded(target, without, laws, faults, coordinates=coordinates)
    asked = read_fit(model, **_arguments(model, values, given, faults, **options), before=faults)
    progress.stage("fitting")
    return fitted(asked, progress)


def _arguments(
    model: Model,
    values: dict[str, str],
    inputs: dict[str, str],
    faults: list[Fault],
    *,
    measured: Sequence[str],
    columns: Sequence[str],
    free: Sequence[str],
    noise: Sequence[str],
    made_at: Sequence[str],
    offset: str,
    gain: Sequence[str],
    duration: str | None,
    tolerance: str | None,
    method: str | None,
    starts: int | None,
    seed: int | None,
    profile: str,
) -> dict[str, Any]:
    """Return the arguments of a fit; malformed options are appended to `faults`."""
    from hertzwerk.runtime.fitting.experiment import Experiment
    from hertzwerk.runtime.parameter_fit import STARTS, TOLERANCE
    from hertzwerk.runtime.run.request import METHOD
    from hertzwerk.runtime.start.start_values import split_values

    parameters, initial = split_values(model, values)
    own: dict[str, list[str]] = {file: [] for file in measured}
    for text in made_at:
        file, _, assigned = text.partition(":")
        if file in own:
            own[file].append(assigned)
        else:
            faults.append(Fault("--at", repr(text), f"FILE:NAME=VALUE, FILE one of {', '.join(measured)}"))
    twice = sorted({file for file in measured if list(measured).count(file) > 1})
    faults += [Fault("--measured", f"{file} twice", "each measured run once") for file in twice]
    ranged = assignments("--free", [text for text in free if "=" in text], faults)
    return {
        "data": [Experiment(file, assignments("--at", own[file], faults)) for file in measured],
        "free": {text.partition("=")[0].strip(): ranged.get(text.partition("=")[0].strip()) for text in free},
        "map": assignments("--map", columns, faults) or None,
        "noise": assignments("--noise", noise, faults),
        "parameters": parameters,
        "initial": initial,
        "inputs": inputs or None,
        "duration": duration,
        "offset": offset,
        "gain": assignments("--gain", gain, faults),
        "tolerance": TOLERANCE if tolerance is None else number(tolerance),
        "method": method or METHOD,
        "starts": STARTS if starts is None else starts,
        "seed": seed or 0,
        "profile": {"auto": "auto", "all": True, "none": False}[profile],
    }


def _write(found: Fitted, into: Path | None, missing: list[str], *, plots: bool) -> tuple[Path, list[str]]:
    from hertzwerk.runtime.cli.run_folder import json_text
    from hertzwerk.runtime.cli.target import command_line
    from hertzwerk.runtime.host.folder import failures_of, new_folder
    from hertzwerk.runtime.host.versions import versions

    def fill(folder: Path) -> list[str]:
        about = {"command": command_line(), "versions": versions()}
        texts = {
            "fit.json": json_text({**found.record(), **about}) + "\n",
            "fit.csv": found.csv(),
            "fit.md": found.markdown(),
        }
        for name, text in texts.items():
            (folder / name).write_text(text, encoding="utf-8")
        if not plots:
            return list(texts)
        from hertzwerk.runtime.pictures.studies.plot_fit import save

        failures = failures_of("fit.png", lambda: save(found, folder / "fit.png"))
        missing.extend(failures)
        return [*texts, *([] if failures else ["fit.png"])]

    try:
        return new_folder(f"{found.observed[0].model.name}-fit", into, fill)
    except InputError as error:
        raise InputError("fit", [replace(fault, where="--into") for fault in error.faults]) from error


def _report(found: Fitted) -> None:
    for label, text in found.lines():
        line(label, text)
