"""`hertzwerk export`: a scene for other programs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.cli.target_options import (
    ACCURACY,
    BY_METHOD,
    DURATION,
    VARIATION,
    Variation,
    run_settings,
    together,
)
from hertzwerk.runtime.cli.terminal import GOOD, Progress, line, reports_bad_input
from hertzwerk.runtime.export.formats import FORMATS, Format


def _option(each: Format) -> Callable[[Any], Any]:
    if not each.place:
        return click.option(each.option, each.name, is_flag=True, help=each.meaning)
    return click.option(
        each.option, each.name, metavar=each.place, type=click.Path(path_type=Path), help=f"New {each.meaning}"
    )


@click.command(epilog="Example: hertzwerk export slider_crank --fmu crank.fmu")
@click.argument("target")
@together(*map(_option, FORMATS), VARIATION, DURATION, ACCURACY)
@click.option("--tolerance", metavar="NUMBER", help="Local tolerance of the steps, in place of --accuracy.")
@BY_METHOD
@click.option(
    "--output",
    "outputs",
    metavar="NAME",
    multiple=True,
    help="Add this history to the outputs: floor.normal_force, rod.x (`hertzwerk list TARGET` lists all).",
)
@click.option("--fmi", type=click.Choice(["2", "3"]), default="3", help="Version of FMI (default: 3).")
@reports_bad_input
def export(
    target: str,
    duration: str | None,
    accuracy: str | None,
    tolerance: str | None,
    method: str | None,
    outputs: Sequence[str],
    fmi: str,
    **places: Any,
) -> int:
    """Export TARGET as a C library, an FMU or equations.

    Its parameters, start and method are part of it. At least one of --c, --fmu, --latex, --mathml and --sympy is
    required.
    """
    with Progress(f"export of {target}") as progress:
        from hertzwerk.runtime.engine.run.run_request import Settings, check
        from hertzwerk.runtime.engine.solution.history import unknown_histories
        from hertzwerk.runtime.export.export_contents import ExportRequest, with_zero_inputs

        varied = Variation.taken(target, places)
        wanted = [(each, place) for each in FORMATS if (place := places[each.name])]
        faults = [fault for each, place in wanted if isinstance(place, Path) for fault in each.faults(place)]
        if not wanted:
            options = ", ".join(f"{each.option} {each.place}".rstrip() for each in FORMATS)
            faults.append(Fault("export", "no format", f"one of {options}"))
        stated = run_settings(target, duration=duration, accuracy=accuracy, tolerance=tolerance, method=method)
        settings = Settings(**{**stated, "duration": stated["duration"] or "1 s"})
        model, parameters, initial = varied.bound(settings.duration, faults, settings.faults)
        faults += unknown_histories(model, outputs)
        model = with_zero_inputs(model)
        check(model, settings, parameters, initial, faults)
        request = ExportRequest(model, parameters, initial, settings, tuple(outputs), int(fmi))
        for each, place in progress.over(wanted, lambda format: format[0].option):
            report = each.write(request, place if isinstance(place, Path) else Path())
            progress.aside(partial(line, "written", report) if each.place else partial(click.echo, report))
    return GOOD
