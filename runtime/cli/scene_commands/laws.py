"""`hertzwerk laws`: the catalogue, and the sheet of a law."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.runtime.cli.target_options import JSON
from hertzwerk.runtime.cli.terminal import GOOD, line, print_prose, reports_bad_input, table

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.law_sheets.law_sheet import Formula, Restitution, Sheet


@click.command(epilog="Example: hertzwerk laws flores")
@click.argument("names", metavar="[NAME]...", nargs=-1)
@click.option(
    "--form",
    type=click.Choice(["point", "line", "surface"]),
    help="List only the consistent laws for this form of contact: a pin in a bush touches along a line.",
)
@click.option("--markdown", is_flag=True, help="Print the catalogue as Markdown, derive/laws/README.md.")
@click.option("--stub", is_flag=True, help="Print the catalogue for type checkers, derive/laws/__init__.pyi.")
@click.option(
    "--picture",
    type=click.Path(path_type=Path),
    metavar="FILE.png",
    help="Draw the candidates for one reconstructed law (grade R) into a new file.",
)
@JSON
@reports_bad_input
def laws(
    names: tuple[str, ...],
    form: str | None,
    markdown: bool,
    stub: bool,
    picture: Path | None,
    as_json: bool,
) -> int:
    """List the contact laws, or print the sheet of each NAME.

    A sheet has formula, units, ranges, source, behaviour and cost.
    """
    from hertzwerk.runtime.engine.model import build

    if form and (names or markdown or stub or picture is not None):
        raise InputError("laws", [Fault("--form", f"{form} with other arguments", "it alone, or --json beside it")])
    if markdown or stub:
        if names or picture is not None or sum((markdown, stub, as_json)) > 1:
            actual = f"--{'markdown' if markdown else 'stub'} with other arguments"
            raise InputError("laws", [Fault("laws", actual, "it alone: it prints the whole catalogue")])
        click.echo(build.law_listing(stub=stub), nl=False)
        return GOOD
    if names or picture is not None:
        sheets = build.law_sheets(names)
        if picture is not None:
            _draw(sheets, picture)
        if as_json:
            click.echo(json.dumps({"laws": [sheet.record() for sheet in sheets]}, indent=2, ensure_ascii=False))
        else:
            for i, sheet in enumerate(sheets):
                click.echo("\n" if i else "", nl=False)
                _print_sheet(sheet)
            if picture is not None:
                line("written", str(picture))
        return GOOD
    rows = build.law_summaries(form)
    if as_json:
        click.echo(json.dumps({"laws": rows}, indent=2, ensure_ascii=False))
    else:
        columns = (
            ("law", "made for", "grade", "title") if form else ("law", "kind", "grade", "verdict", "memory", "title")
        )
        table(columns, [[row[name] for name in columns] for row in rows])
        print_prose(
            "Memory: v0 is the approach speed, latched at the onset of a contact; where contacts last, take a damping law without it."
        )
        print_prose("Grades: A checked here, B seen in a public source, C from general knowledge, R reconstruction.")
    return GOOD


def _draw(sheets: Sequence[Sheet], picture: Path) -> None:
    """Write the picture of one reconstruction; raises InputError if there is none or the file exists."""
    from hertzwerk.runtime.system.result_folder import new_file_faults

    faults = []
    if len(sheets) != 1 or sheets[0].band is None:
        actual = ", ".join(f"{sheet.law.name} of grade {sheet.law.grade}" for sheet in sheets) or "no law"
        faults.append(Fault("--picture", actual, "one reconstruction, such as wang_liu_internal"))
    if picture.suffix != ".png":
        faults.append(Fault("--picture", str(picture), "a file FILE.png"))
    faults += new_file_faults("--picture", picture)
    refuse("laws", faults)
    from hertzwerk.runtime.engine.solution.solution import write
    from hertzwerk.runtime.output.plots.plot_band import figure
    from hertzwerk.runtime.output.plots.save_figure import png_of

    write(picture, png_of(figure(sheets[0])), overwrite=False)


# -- one law -----------------------------------------------------------------------------------------------------------


def _print_sheet(sheet: Sheet) -> None:
    line(sheet.law.name, sheet.law.title)
    kind = f"{sheet.law.kind}, of {sheet.form} contact" if sheet.form != "any" else sheet.law.kind
    line("kind", ", made for ".join(filter(None, (kind, ", ".join(sheet.law.pairs)))))
    line("grade", f"{sheet.law.grade}: {sheet.grade_meaning}")
    line("source", sheet.law.source)
    fitted = f"; its constants are of {sheet.law.fitted_in}" if sheet.law.fitted_in else ""
    line(sheet.law.verdict, f"units, as published{fitted}")
    if sheet.law.repair:
        line("repair", f"hertzwerk laws {sheet.law.repair}")
    if sheet.law.note:
        line("note", sheet.law.note)
    line("formula", "\n".join(_formula_texts(sheet.formulas)))
    if sheet.definitions:
        line("where", "\n".join(_formula_texts(sheet.definitions)))
    line("latex", "\n".join(f.latex for f in (*sheet.formulas, *sheet.definitions)))
    if sheet.exponent:
        form = "n of K d^n" if sheet.law.kind == "stiffness" else "m of chi d^m v"
        line("exponent", f"{form} is {sheet.exponent}")
    if sheet.local_exponent:
        line("local", f"dlnF/dlnd = {sheet.local_exponent}, at every penetration")
    for label, texts in (("memory", sheet.memory), ("modes", sheet.modes), ("release", (sheet.release,))):
        if any(texts):
            line(label, "\n".join(texts))
    once, each = sheet.operations
    line("operations", f"{each} per evaluation, and {once} once per run, in the generated text of the force")
    click.echo()
    table(
        ("symbol", "unit", "given by", "defined for", "recommended", "meaning"),
        [(s.name, s.unit, s.origin, s.defined, s.recommended, s.meaning) for s in sheet.symbols],
    )
    if sheet.points:
        print_prose(f"\n{sheet.example}:")
        forces = [point.force for point in sheet.points if point.force is not None]  # none where the units do not hold
        columns = ("penetration [m]", *(("force [N]",) if forces else ()), "dlnF/dlnd", 'with smooth="1 um"')
        rows = [
            (
                *(f"{p.penetration:g}", *([f"{p.force:.6g}"] if forces else []), f"{p.exponent:.4f}"),
                f"{p.smoothed:+.2%}",
            )
            for p in sheet.points
        ]
        table(columns, rows)
        print_prose(
            "A contact with smooth=EPSILON has two derivatives at its onset; beyond 2 EPSILON the same force is EPSILON deeper."
        )
    if sheet.band is not None:
        _print_band(sheet)
    if sheet.restitution is not None:
        click.echo()
        _print_restitution(sheet.restitution)
    elif sheet.law.kind == "damping":
        line("restitution", "takes no e; `hertzwerk study restitution` shows what it returns")


def _print_band(sheet: Sheet) -> None:
    """Print the forces of all candidates of a reconstruction, at the penetrations of the example."""
    band = sheet.band
    if band is None:
        return
    shown = {point.penetration for point in sheet.points}
    rows = [
        (f"{depth:g}", *(f"{candidate.forces[k]:.6g}" for candidate in band.candidates), f"{band.spread[k]:.2f}")
        for k, depth in enumerate(band.penetrations)
        if any(abs(depth - other) < 1e-6 * other for other in shown)
    ]
    print_prose(
        "\nThe expression of the paper was not available. The band of its candidates, forces in N, largest over smallest:"
    )
    table(("penetration [m]", *(candidate.law for candidate in band.candidates), "band"), rows)
    print_prose(f"As a picture: hertzwerk laws {sheet.law.name} --picture {sheet.law.name}.png")


def _formula_texts(formulas: Sequence[Formula]) -> list[str]:
    return [f"{f.symbol} = {f.text}{'' if f.unit == '1' else f'  [{f.unit}]'}  ({f.meaning})" for f in formulas]


def _print_restitution(restitution: Restitution) -> None:
    beside = f"beside K d^n with n = {restitution.beside}" if restitution.beside else "beside every elastic law"
    if restitution.points:
        print_prose(f"One free impact, {beside}; no other force, whatever the masses and the speed:")
        table(
            ("e in", restitution.coefficient, "e out", "e out - e in"),
            [(f"{e:.2f}", f"{c:.5g}", f"{out:.4f}", f"{out - e:+.4f}") for e, c, out in restitution.points],
        )
    for limit, coefficient, out in (
        ("e -> 1", restitution.coefficient_at_one, restitution.out_at_one),
        ("e -> 0", restitution.coefficient_at_zero, restitution.out_at_zero),
    ):
        elastic = ", the elastic law" if coefficient == "0" else ", infinite damping" if coefficient == "oo" else ""
        returned = "" if out is None else f"; e out -> {out:.4g}"
        line(
            limit,
            f"{restitution.coefficient} -> {'infinity' if coefficient == 'oo' else coefficient}{elastic}{returned}",
        )
