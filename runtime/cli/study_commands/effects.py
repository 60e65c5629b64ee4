"""`hertzwerk effects`: cost and influence of each effect of a scene, and the smallest scene."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.runtime.analysis.effect_study.effect_study import Change, Row, Study, percent
from hertzwerk.runtime.cli.target_options import (
    BY_METHOD,
    DURATION,
    INPUT,
    JSON,
    LAW,
    SET,
    WITHOUT,
    assignments,
    number,
    unwritable_faults,
)
from hertzwerk.runtime.cli.terminal import (
    OTHER_OUTCOME,
    Progress,
    conclude,
    line,
    print_prose,
    reports_bad_input,
    table,
)
from hertzwerk.runtime.system.digests import json_text

DEFAULT = 1e-9  # least default tolerance: an error of this size hides no effect


@click.command(epilog="Example: hertzwerk effects slider_crank --within 2%")
@click.argument("target")
@click.option(
    "--within", metavar="PERCENT", help="Find the smallest scene whose outputs change by at most this, such as 2%."
)
@click.option(
    "--output",
    "outputs",
    metavar="NAME",
    multiple=True,
    help="Output to compare: peak_force, peak_acceleration, impact_rate, mean_peak_force, journal_path; a history after max., min., mean. or "
    "amplitude.; an average, such as slider_pin.impact_rate (default: those that the scene has).",
)
@SET
@INPUT
@WITHOUT
@LAW
@DURATION
@click.option(
    "--tolerance",
    metavar="NUMBER",
    help="Local tolerance of the coarsest runs; runs at down to a 30th of it show their error (default: the scenario's).",
)
@BY_METHOD
@click.option(
    "--compiled", is_flag=True, help="Measure the time of compiled runs (default: of CasADi's virtual machine)."
)
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-effects-NNN)."
)
@click.option("--no-plots", is_flag=True, help="Write the data without pictures.")
@JSON
@reports_bad_input
def effects(target: str, out: Path | None, no_plots: bool, as_json: bool, **options: Any) -> int:
    """Show what each effect of TARGET costs and changes.

    Each is left out in turn. A change is that of the scene without the effect, relative to the whole scene; one below
    the error of both is marked.
    """
    wanted = out is not None or not as_json
    with Progress(f"effects of {target}", shown=not as_json) as progress:
        study = _study(target, out, progress, wanted=wanted, **options)
    code = conclude(
        lambda missing: _write(study, out, missing, plots=not no_plots),
        study.record,
        lambda: _report(study),
        wanted=wanted and bool(study.rows),
        as_json=as_json,
    )
    return code if study.outcome.finished else OTHER_OUTCOME


def _study(target: str, out: Path | None, progress: Progress, *, wanted: bool, **options: Any) -> Study:
    """Return the study of a command line; raises InputError."""
    from hertzwerk.runtime.analysis.effect_study.leaving_out import study_effects
    from hertzwerk.runtime.analysis.validation import scenarios
    from hertzwerk.runtime.engine.run.run_request import METHOD

    faults = unwritable_faults(out, wanted=wanted)
    values = assignments("--set", options["settings"], faults)
    inputs = assignments("--input", options["inputs"], faults)
    laws = assignments("--law", options["laws"], faults)
    within = None if options["within"] is None else _fraction(options["within"], faults)
    numbers = scenarios.read(target)
    tolerance = max(numbers.get("accuracy", 1e-6), DEFAULT)
    if options["tolerance"] is not None:
        tolerance = number(options["tolerance"])
        if not isinstance(tolerance, float):
            faults.append(Fault("--tolerance", repr(tolerance), "a number"))
    refuse("effects", faults)
    return study_effects(
        target,
        duration=options["duration"] or numbers.get("duration"),
        tolerance=tolerance,
        method=options["method"] or numbers.get("method", METHOD),
        parameters=values,
        inputs=inputs,
        outputs=options["outputs"],
        within=within,
        without=options["without"],
        laws=laws,
        compiled=options["compiled"],
        progress=progress,
    )


def _fraction(text: str, faults: list[Fault]) -> float | None:
    """Return a fraction given as "2%", "2 %" or "0.02"; anything else is appended to `faults`."""
    value = number(text.strip().removesuffix("%"))
    fraction = value / 100 if isinstance(value, float) and text.strip().endswith("%") else value
    if isinstance(fraction, float) and 0 < fraction < 1:
        return fraction
    faults.append(Fault("--within", repr(text), "a change above 0 and below 100 %, such as 2%"))
    return None


def _write(study: Study, out: Path | None, missing: list[str], *, plots: bool) -> tuple[Path, list[str]]:
    from hertzwerk.runtime.cli.run_folder import write_study

    def draw() -> Any:
        from hertzwerk.runtime.analysis.effect_study import plot_effects

        return plot_effects.figure(study)

    texts = {"effects.json": json_text(study.record()) + "\n"}
    return write_study(f"{study.scene}-effects", out, texts, draw if plots else None, missing)


# -- as people read it -------------------------------------------------------------------------------------------------


def _report(study: Study) -> None:
    coarse, fine = study.tolerances
    line(study.scene, f"{study.duration:g} s, {study.method}, local tolerances {coarse:.2g} to {fine:.2g}")
    if not study.outcome.finished:
        line(study.outcome.name, study.outcome.message)
        line("remedy", study.outcome.remedy)
        return
    for output in study.outputs:
        number = study.numbers[output.name]
        line("output", f"{output.name} = {number.value:.6g} {output.unit}, error {number.error:.1g}: {output.meaning}")
    if study.past_horizon:
        line(
            "warning",
            "beyond the horizon, where runs separate at any tolerance: outputs are means of 9 runs, averages those of one run, with 95 % intervals",
        )
    for warning in study.warnings:
        line("warning", warning)
    click.echo()
    columns = ("effect", "in flight", "in contact", "states", "events", "time")
    table((*columns, *(output.name for output in study.outputs)), [_cells(study, row) for row in study.rows])
    print_prose(
        "\nCost of an effect: operations of one evaluation, states, event functions, share of the time. "
        "Then the changes without it, relative to the whole scene."
    )
    for row in study.rows:
        for note in _notes(row):
            line("note", f"{row.effect}: {note}")
    if study.smallest is not None:
        _report_smallest(study)


def _cells(study: Study, row: Row) -> list[str]:
    if row.cost is None:
        return [row.effect, *[""] * (5 + len(study.outputs))]
    pairs = zip(vars(row.cost).values(), vars(study.cost).values(), strict=True)
    share = (
        "" if row.share is None else percent(row.share.median, sign=False) if row.share.significant else "below error"
    )
    costs = (f"{cost} of {whole}" if cost else "-" for cost, whole in pairs)
    return [row.effect, *costs, share, *(_cell(row.changes.get(output.name)) for output in study.outputs)]


def _cell(change: Change | None) -> str:
    if change is None:
        return ""
    return percent(change.relative) if change.relative is not None else change.why


def _notes(row: Row) -> list[str]:
    along = [f"left out together with {', '.join(row.along_with)}"] if row.along_with else []
    details = grouped((change.detail, name) for name, change in row.changes.items() if change.detail)
    of_outputs = [f"{', '.join(names)}: {detail}" for detail, names in details.items()]
    return [*along, *([row.fault] if row.fault else []), *row.notes, *of_outputs]


def _report_smallest(study: Study) -> None:
    smallest = study.smallest
    if smallest is None or study.within is None:
        return
    print_prose(
        f"\nSmallest scene within {100 * study.within:g} %: {', '.join(smallest.effects) or 'no effect at all'}."
    )
    if smallest.left_out:
        share = study.smallest_share
        saved = "" if share is None or not share.significant else f"; the time changes by {percent(-share.median)}"
        change = (
            "changes nothing"
            if smallest.change == 0
            else f"changes the outputs by at most {percent(smallest.change, sign=False)}, errors included"
        )
        line("left out", f"{', '.join(smallest.left_out)}: {change}{saved}")
    noisy = [name for name, number in study.numbers.items() if number.error > study.within * abs(number.value)]
    if noisy:
        line("warning", f"the error of {', '.join(noisy)} alone is larger than that, so the smallest scene is unknown; "
                        "take runs within the horizon, or other outputs")  # fmt: skip
    tried = "" if smallest.complete else ", the most that are tried: a smaller one may exist"
    line("found by", "effects were removed one after another, or two at once where no single one can be, and all outputs were measured each time; "
                     f"{smallest.tried} scenes tried{tried}")  # fmt: skip
