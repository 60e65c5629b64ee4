"""`hertzwerk compare`: a run beside measured data."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault, InputError, noted
from hertzwerk.runtime.cli.continue_run import limits_of
from hertzwerk.runtime.cli.stop_signals import Stopping
from hertzwerk.runtime.cli.target_options import (
    ACCURACY,
    BY_METHOD,
    DURATION,
    JSON,
    MAX_STEPS,
    READING,
    VARIATION,
    WALL_TIME,
    Variation,
    assignments,
    reading_of,
    run_settings,
    unwritable_faults,
    with_inputs,
)
from hertzwerk.runtime.cli.terminal import (
    OTHER_OUTCOME,
    Progress,
    conclude,
    line,
    reports_bad_input,
    table,
)
from hertzwerk.runtime.system.digests import json_text

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.studies.comparison.comparison_request import ComparisonRequest
    from hertzwerk.runtime.studies.comparison.comparison_result import Comparison


@click.command(epilog="Example: hertzwerk compare slider_crank --measured bench.csv --map acc=guide.acceleration")
@click.argument("target")
@click.option(
    "--measured",
    metavar="FILE",
    required=True,
    help="Table with headings `name [unit]` and a time column `t [s]`, as instruments and spreadsheets write it.",
)
@click.option(
    "--map",
    "columns",
    metavar="COLUMN=HISTORY",
    multiple=True,
    help="Column and the history it is compared with: acceleration=guide.acceleration (default: the one of equal name).",
)
@click.option(
    "--bandwidth",
    metavar="FREQUENCY",
    help='Cut-off frequency of the instrument, by which the run is filtered too: "5 kHz" (default: none).',
)
@click.option("--order", type=int, default=4, show_default=True, help="Order of its Butterworth low-pass.")
@click.option(
    "--zero-phase",
    is_flag=True,
    help="Filter forwards and backwards, 6 dB down at the cut-off (default: causal, 3 dB down).",
)
@click.option(
    "--offset",
    metavar="RANGE",
    default="0 s",
    help='Run time less measured time: a range to search, "-2..2 ms", or a value, "1 ms" (default: 0 s).',
)
@click.option(
    "--drift",
    metavar="RANGE",
    default="0",
    help='Drift of the measured clock: a range to search, "-1e-4..1e-4", or a value (default: 0).',
)
@click.option(
    "--noise",
    metavar="COLUMN=SIZE",
    multiple=True,
    help='Standard deviation of the noise of a column, by which residuals are judged: acceleration="5 m/s^2" (default: not judged).',
)
@READING
@VARIATION
@DURATION
@ACCURACY
@BY_METHOD
@MAX_STEPS
@WALL_TIME
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-compare-NNN)."
)
@click.option("--no-plots", is_flag=True, help="Write the data without pictures.")
@JSON
@reports_bad_input
def compare(target: str, out: Path | None, no_plots: bool, as_json: bool, **options: Any) -> int:
    """Compare a run of TARGET with measured data.

    By residuals, spectra, statistics and a picture. Without --duration the run is as long as the data. Trajectories
    are compared as long as the numerical error of the run is within 0.1 % of its scales, statistics after that. The
    measurement in the paper of Wang and Liu (2020) is not to be had; provide your own data. Exit code 1: run and data
    differ by more than the stated noise.
    """
    from hertzwerk.runtime.engine.inputs.measurement_csv import Reading

    wanted = out is not None or not as_json
    faults = unwritable_faults(out, wanted=wanted)
    options["measured"] = Reading(options["measured"], **reading_of(options, faults))
    with (
        Progress(f"comparison of {target}", shown=not as_json) as progress,
        Stopping(progress) as stopping,
    ):
        comparison = _compared(Variation.taken(target, options), faults, stopping, **options)
    code = conclude(
        lambda missing: _write(comparison, out, missing, plots=not no_plots),
        comparison.record,
        lambda: _report(comparison),
        wanted=wanted,
        as_json=as_json,
    )
    return (
        OTHER_OUTCOME
        if comparison.differs or comparison.solution.engine.t_end < comparison.solution.settings.duration
        else code
    )


def _compared(
    varied: Variation,
    faults: list[Fault],
    stopping: Stopping,
    *,
    duration: str | None,
    accuracy: str | None,
    method: str | None,
    max_steps: str | None,
    wall_time: str | None,
    **measured: Any,
) -> Comparison:
    """Return the comparison of a command line; raises InputError with every fault before it runs."""
    from hertzwerk.runtime.engine.run.run_request import Settings, check
    from hertzwerk.runtime.engine.start.start_values import split_values
    from hertzwerk.runtime.simulation import solve
    from hertzwerk.runtime.studies.comparison.compare_run import match

    values = varied.values(faults)
    stopping.stage("building")
    limits = limits_of(max_steps, wall_time, faults)
    model = varied.model(faults)
    request = _request(model, faults, **measured)
    stated = run_settings(varied.target, duration=duration, accuracy=accuracy, method=method)
    until = stated["duration"] = duration or (request.lasts if request is not None else stated["duration"] or 1.0)
    settled = Settings(**stated, **limits)
    parameters, initial = split_values(model, values)
    model = with_inputs(model, varied.inputs, until, parameters, faults)
    check(model, settled, parameters, initial, faults)
    if request is None:  # its faults are among those that `check` raises
        raise InputError(model.name, faults)
    run = solve(model, settled, parameters, initial, progress=stopping)
    if run.outcome.name == "interrupted" and not run.statistics.steps:
        raise KeyboardInterrupt
    stopping.stage("comparing")
    return match(run, request)


def _request(
    model: EngineModel, faults: list[Fault], *, measured: Any, columns: Sequence[str], noise: Sequence[str], **how: Any
) -> ComparisonRequest | None:
    """Return what is compared; None with its faults appended."""
    from hertzwerk.runtime.engine.solution.history import units_of
    from hertzwerk.runtime.studies.comparison.comparison_request import read_comparison_request

    mapped, sizes = assignments("--map", columns, faults), assignments("--noise", noise, faults)
    with noted(faults):
        return read_comparison_request(units_of(model, None), measured, mapped or None, noise=sizes, **how)
    return None


def _write(comparison: Comparison, out: Path | None, missing: list[str], *, plots: bool) -> tuple[Path, list[str]]:
    from hertzwerk.runtime.cli.run_folder import record, write_study

    content = {**comparison.record(), "run": record(comparison.solution)}
    texts = {"comparison.json": json_text(content) + "\n", "comparison.csv": comparison.csv()}
    name = f"{comparison.solution.engine.model.name}-compare"
    return write_study(name, out, texts, comparison.plot if plots else None, missing)


def _report(comparison: Comparison) -> None:
    """Print the sentences, then the statistics as a table."""
    for label, text in comparison.lines(statistics=False):
        line(label, text)
    rows = [
        [signal.channel.column, each.name, each.unit, str(each.measured), str(each.run), each.verdict]
        for signal in comparison.signals
        for each in signal.statistics
    ]
    if rows:
        click.echo()
        table(("beyond the horizon", "statistic", "unit", "measured", "run", ""), rows)
