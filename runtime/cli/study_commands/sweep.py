"""`hertzwerk sweep`: a run for every point of a design, stored row by row, resumed where it ended."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager, ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.runtime.cli.continue_run import limits_of
from hertzwerk.runtime.cli.target_options import (
    ACCURACY,
    BY_METHOD,
    DURATION,
    JSON,
    TABLE,
    TOLERANCE,
    VARIATION,
    assignments,
    beside,
    run_settings,
    table_faults,
)
from hertzwerk.runtime.cli.terminal import (
    OTHER_OUTCOME,
    Progress,
    line,
    report_damage,
    report_missing,
    reports_bad_input,
    table,
    written_or_none,
)
from hertzwerk.runtime.system.digests import json_text

if TYPE_CHECKING:
    from distributed import Client

    from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep

BESIDE = "workers", "cluster", "widen", "file", "plot", "as_json"  # options that no definition has


@click.command(epilog='Example: hertzwerk sweep slider_crank --over clearance="0.05..0.5 mm:10"')
@click.argument("target", required=False)
@click.option(
    "--over",
    metavar="NAME=VALUES",
    multiple=True,
    help='Vary a parameter or an initial state: clearance="0.05..0.5 mm:10", stiffness="1e6..1e9 N/m:7 log", restitution=0.5,0.7,0.9. '
    "An input takes files, torque=calm.csv,gusty.csv:load, or a factor, torque.scale=0.5..1.5:5.",
)
@click.option(
    "--zip", is_flag=True, help="Combine the first values of all, then the second, and so on (default: each with each)."
)
@click.option(
    "--sample", metavar="NUMBER", help='Number of points spread over ranges such as clearance="0.05..0.5 mm".'
)
@click.option(
    "--sampler",
    metavar="NAME",
    help="How points are spread: latin, a hypercube, or sobol, a power of two of them (default: latin).",
)
@click.option("--seed", metavar="NUMBER", help="Seed of the samples (default: 0).")
@click.option(
    "--output",
    "outputs",
    metavar="NAME",
    multiple=True,
    help="Output of each row: final.guide.travel, slider_pin.peak_force, slider_pin.impact_rate, guide.travel.max (default: final states).",
)
@click.option(
    "--section",
    metavar="PLACE",
    help='Keep the states at which a condition holds: "main_bearing.angle = 0" (every return), "phase = 90 deg", "floor.gap = 0 m falling".',
)
@click.option(
    "--grid", metavar="SPACING", help='Keep histories at this number of points, or at a spacing such as "0.1 ms".'
)
@click.option(
    "--after", metavar="TIME", help='Transient that --section and --grid leave out, such as "100 rev" (default: none).'
)
@click.option(
    "--history",
    "histories",
    metavar="NAME",
    multiple=True,
    help="History that --section and --grid keep (default: coordinates and speeds).",
)
@click.option(
    "--continue",
    "continued",
    metavar="up|down",
    help="Increase or decrease the first parameter, each run starting from the final state of the one before.",
)
@VARIATION
@DURATION
@ACCURACY
@TOLERANCE
@BY_METHOD
@click.option(
    "--max-steps", metavar="NUMBER", help="Stop a row after this number of accepted steps (default: 1000000)."
)
@click.option(
    "--wall-time", metavar="TIME", help='Stop a row after this time by the clock, such as "10 min" (default: none).'
)
@click.option(
    "--out",
    metavar="DIR",
    type=click.Path(path_type=Path),
    help="Folder of the rows, new or of the same sweep (default: the next runs/SCENE-sweep-NNN).",
)
@click.option(
    "--resume",
    metavar="DIR",
    type=click.Path(path_type=Path),
    help="Compute the rows that are missing in this folder of a sweep.",
)
@click.option(
    "--widen", is_flag=True, help="Change the definition of the folder's sweep; rows that both have are kept."
)
@click.option("--plot", is_flag=True, help="Draw curves, maps, or the bifurcation diagram of a section.")
@click.option("--workers", metavar="NUMBER", help="Number of processes (default: one per core).")
@click.option("--cluster", metavar="ADDRESS", help="Dask scheduler whose workers compute the rows: tcp://host:8786.")
@TABLE
@JSON
@reports_bad_input
def sweep(
    target: str | None,
    resume: Path | None,
    out: Path | None,
    widen: bool,
    workers: str | None,
    cluster: str | None,
    plot: bool,
    file: Path | None,
    as_json: bool,
    **options: Any,
) -> int:
    """Simulate TARGET at every point of a design, on all cores.

    Each row is stored as soon as it is computed; --resume continues a sweep, whatever ended it. A TOML file with the
    same keys may take the place of TARGET and options. Exit code 1: a row has another outcome than `finished`, or is
    missing.
    """
    faults = table_faults(file)
    processes = _whole("--workers", workers, faults)
    if plot and as_json and out is None and resume is None:
        faults.append(Fault("--plot", "without a folder, as --json writes none", "--out DIR beside it"))
    folder = resume or out
    with ExitStack() as stack:
        progress = stack.enter_context(Progress(target or str(folder), shown=not as_json))
        from hertzwerk.runtime.studies.sweeps.parameter_sweep import sweep as swept
        from hertzwerk.runtime.studies.sweeps.sweep_store import PICTURE
        from hertzwerk.runtime.system.interrupt import raise_interrupts
        from hertzwerk.runtime.system.result_folder import failures_of, made_folder, remove_if_empty

        arguments = _arguments(target, resume, options, faults)
        if folder is None and not as_json:
            folder = made_folder(f"{Path(arguments['target']).stem}-sweep", None)
            stack.callback(remove_if_empty, folder)  # where the definition is refused
        client = stack.enter_context(_connected(cluster)) if cluster is not None else None
        progress.stage("building")
        begun: list[float] = []

        def rows(fraction: float) -> None:
            if not begun:
                begun.append(fraction)
                progress.stage("rows", fraction)
                stack.enter_context(raise_interrupts())  # from here on there is something to tell when it is stopped
            progress(fraction)

        result = swept(**arguments, out=folder, widen=widen, workers=processes, client=client, progress=rows)
    missing: list[str] = []
    if file is not None:
        written_or_none(lambda: result.to_file(file), missing, wanted=True)
    if plot and folder is not None:
        missing += failures_of(PICTURE, lambda: _draw(result, folder / PICTURE))
    whole = result.outcome.finished and set(result.counts()) <= {"finished"}
    if as_json:
        click.echo(json_text({**_record(result), "out": folder and str(folder)}))
    else:
        _report(result, folder, None if missing else file)
    code = report_missing(missing)
    return code if whole else OTHER_OUTCOME


def _connected(address: str) -> AbstractContextManager[Client]:
    """Connect to a Dask scheduler; raises InputError where there is none, or no Dask."""
    from hertzwerk.runtime.system.optional_packages import required

    required("distributed", "cluster")
    from hertzwerk.runtime.studies.sweeps.rows.cluster import connected

    return connected(address)


def _arguments(target: str | None, resume: Path | None, options: dict[str, Any], faults: list[Fault]) -> dict[str, Any]:
    """Return the arguments of the sweep, of a folder, a file or the command line; raises InputError."""
    expected = "the whole definition there; beside it --workers, --cluster, --widen, --table, --json"
    if resume is None and target is not None and target.endswith(".toml"):
        from hertzwerk.runtime.studies.sweeps.definition_file import read_definition_file
        from hertzwerk.runtime.studies.sweeps.parameter_sweep import sweep as swept

        refuse("sweep", [*faults, *beside(target, expected, "target", "out", *BESIDE)])
        return read_definition_file(Path(target), swept)
    if resume is not None:
        refuse("sweep", [*faults, *beside("--resume", expected, "resume", *BESIDE)])
        from hertzwerk.runtime.studies.sweeps.points.sweep_definition import arguments_of, read_definition

        definition = read_definition(resume)
        if definition is None:
            raise InputError("sweep", [Fault("--resume", f"{resume}, without a sweep", "the folder of a sweep")])
        return arguments_of(definition, resume)
    if target is None:
        expected = "a scene, a file, or --resume DIR"
        faults.append(Fault("TARGET", "none", expected, "`hertzwerk list` names the scenes"))
    arguments = _read(str(target), options, faults)
    refuse("sweep", faults)
    return arguments


def _read(target: str, options: dict[str, Any], faults: list[Fault]) -> dict[str, Any]:
    """Return the arguments of the sweep that options state; bad input is appended to `faults`."""
    sample, seed = (_whole(f"--{name}", options[name], faults) for name in ("sample", "seed"))
    return {
        "target": target,
        "over": assignments("--over", options["over"], faults),
        "zip": options["zip"],
        "sample": sample,
        "sampler": options["sampler"] or "latin",
        "seed": seed or 0,
        "parameters": assignments("--set", options["settings"], faults),
        "inputs": assignments("--input", options["inputs"], faults),
        "without": options["without"],
        "laws": assignments("--law", options["laws"], faults),
        "coordinates": options["coordinates"],
        "outputs": options["outputs"],
        **{name: options[name] for name in ("section", "after", "histories", "continued")},
        "grid": int(options["grid"]) if (options["grid"] or "").isdecimal() else options["grid"],
        **run_settings(target, **options),
        **limits_of(options["max_steps"], options["wall_time"], faults),
    }


def _whole(option: str, text: str | None, faults: list[Fault]) -> int | None:
    """Return the whole number that an option states; bad input is appended to `faults`."""
    if text is None:
        return None
    if text.isdecimal() and len(text) < 16:
        return int(text)
    faults.append(Fault(option, repr(text), "a whole number"))
    return None


def _draw(result: Sweep, file: Path) -> None:
    """Write the picture of a sweep."""
    from hertzwerk.runtime.output.plots.save_figure import png_of
    from hertzwerk.runtime.system.atomic_files import write_atomically

    write_atomically(file, png_of(result.plot()))


# -- as people and programs read it ------------------------------------------------------------------------------------


def _record(result: Sweep) -> dict[str, Any]:
    """Return the table and how the sweep ended as plain data, without a table too large for memory."""
    from hertzwerk.runtime.studies.sweeps.sweep_table import memory_faults

    table, arrays = {}, {}
    if not memory_faults(len(result)):
        table = {name: column.tolist() for name, column in result.read(*result.names).items()}
        arrays = {name: result.arrays_of(name).record() for name in result.arrays}
    return {
        "scene": result.scene,
        "outcome": result.outcome.name,
        "message": result.outcome.message,
        "remedy": result.outcome.remedy,
        "damage": result.damage,
        "rows": len(result),
        "outcomes": result.counts(),
        "units": dict(result.columns),
        "table": table,
        "arrays": arrays,
        "wall_s": result.wall_s,
        "workers": result.workers,
    }


def _report(result: Sweep, folder: Path | None, file: Path | None) -> None:
    """Print a sweep in a few lines."""
    line(
        result.scene,
        f"{len(result)} rows over {', '.join(result.varied)}, in {_time(result.wall_s)} on {result.workers} processes",
    )
    summary = result.summary
    for outcome, count in result.counts().items():
        rows = "1 row" if count == 1 else f"{count} rows"
        why = "" if outcome == "finished" else f"{'' if count == 1 else ', as the first'}: {summary.messages[outcome]}"
        line(outcome, rows + why)
    outputs = [name for name in result.columns if name not in ("outcome", "message", "warnings", *result.varied)]
    if len(result) and outputs:
        click.echo()
        table(("output", "unit", "minimum", "maximum"), [_extremes(result, name) for name in outputs])
        click.echo()
        _report_undetermined(result, outputs)
    for name in result.arrays:
        arrays = result.arrays_of(name)
        line(name, f"{arrays.points:,} points of {', '.join(arrays.units)}")
    warned = summary.warned
    if warned:
        line("warning", f"{'1 row has' if warned == 1 else f'{warned} rows have'} warnings (column `warnings`)")
    report_damage(result.damage)
    if not result.outcome.finished:
        line(result.outcome.name, result.outcome.message)
        line("remedy", result.outcome.remedy)
    if folder is not None:
        tables = [name for name in ("section.csv", "histories.csv", "sweep.png") if (folder / name).exists()]
        line(
            "written", f"{folder}/ ({', '.join(['table.csv', *tables, 'rows.sqlite', 'definition.json', 'model.py'])})"
        )
    if file is not None:
        line("written", str(file))
        if result.arrays and file.suffix.lower() == ".csv":
            line(
                "left out",
                f"{' and '.join(result.arrays)}, as CSV has no lists: --table FILE.parquet or FILE.nc has them",
            )


def _extremes(result: Sweep, name: str) -> Sequence[str]:
    spread = result.summary.spreads[name]
    ends = (f"{spread.least:.6g}", f"{spread.largest:.6g}") if spread.count else ("-", "-")
    return (name, result.unit(name), *ends)


def _report_undetermined(result: Sweep, outputs: Sequence[str]) -> None:
    """Print each reason why outputs have no number in any row that ran, once."""
    from hertzwerk.runtime.output.tables.column_meanings import reason_of_none

    if not result.summary.ran:
        return
    reasons = grouped((reason_of_none(name), name) for name in outputs if not result.summary.spreads[name].count)
    for reason, names in reasons.items():
        line("output", f"{', '.join(names)} not determined{reason and f': {reason}'}")


def _time(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    return f"{seconds:.3g} s" if seconds < 60 else f"{minutes // 60}:{minutes % 60:02d}:{rest:02d} h"
