"""`hertzwerk hardcases`: runs that are hard to keep stable, and their invariants."""

from __future__ import annotations

import time
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault, refuse, unknown
from hertzwerk.runtime.cli.line_wrapping import GAP, PROSE, columns, wrapped
from hertzwerk.runtime.cli.terminal import COLOURS, GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input, table
from hertzwerk.runtime.system.digests import json_text

if TYPE_CHECKING:
    from hertzwerk.runtime.analysis.hard_cases.case import HardCase
    from hertzwerk.runtime.analysis.hard_cases.runner import Result


@click.command(epilog="Example: hertzwerk hardcases --case drop_to_rest --method dop853")
@click.option(
    "--case",
    "names",
    metavar="NAME",
    multiple=True,
    help="Run only this case; may be repeated (default: all but the long ones).",
)
@click.option(
    "--method", "methods", metavar="NAME", multiple=True, help="Run only this method; may be repeated (default: all)."
)
@click.option("--all", "everything", is_flag=True, help="Run the long cases too.")
@click.option("--list", "listing", is_flag=True, help="Run nothing; list the cases and what is hard about each.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@reports_bad_input
def hardcases(names: tuple[str, ...], methods: tuple[str, ...], everything: bool, listing: bool, as_json: bool) -> int:
    """Run the table of hard cases and measure their invariants.

    Each case is run with every method that claims it, in CasADi's virtual machine and, where there is a compiler, as
    C. A cell shows the measured value, with its limit before it or after the slash. Exit code 1: a failure that is
    not a known one.
    """
    with Progress("hard cases"):
        from hertzwerk.runtime.analysis.hard_cases import runner

        cases = _chosen(names, methods, everything=everything)
    if listing:
        return _list(cases, as_json=as_json)
    jobs = [(case, [m for m in case.methods if not methods or m in methods]) for case in cases]
    began, total = time.perf_counter(), sum(len(of) for _, of in jobs)
    by_case: dict[str, dict[str, Result]] = {case.name: {} for case in cases}
    printed = done = 0
    with Progress("hard cases") as progress:
        progress.stage(f"{total} runs")
        for result in runner.results(jobs):
            by_case[result.case][result.method] = result
            done += 1
            progress(done / total)
            while printed < len(jobs) and len(by_case[jobs[printed][0].name]) == len(jobs[printed][1]):
                if not as_json:
                    progress.aside(partial(_print_case, jobs[printed][0], by_case))
                printed += 1
    failed = [r for of in by_case.values() for r in of.values() if r.verdict == runner.FAILED]
    if as_json:
        _print_json(cases, by_case, failed)
    else:
        _print_summary(cases, by_case, time.perf_counter() - began)
    return OTHER_OUTCOME if failed else GOOD


def _chosen(names: Sequence[str], methods: Sequence[str], *, everything: bool) -> list[HardCase]:
    """Return the requested cases.

    Raises InputError with every unknown name, and every case that none of the requested methods claims.
    """
    from hertzwerk.runtime.analysis.hard_cases.case_table import BY_NAME, CASES

    known = dict.fromkeys(method for case in CASES for method in case.methods)
    faults = [
        unknown("case", name, BY_NAME, "as `hertzwerk hardcases --list` shows them")
        for name in names
        if name not in BY_NAME
    ]
    faults += [unknown("method", method, known) for method in methods if method not in known]
    cases = [BY_NAME[name] for name in dict.fromkeys(names) if name in BY_NAME]
    if not faults:
        faults += [
            Fault("--method", f"{case.name} with {' or '.join(methods)}", f"one of {', '.join(case.methods)}")
            for case in cases
            if methods and not set(methods) & set(case.methods)
        ]
    refuse("hardcases", faults)
    chosen = cases or [case for case in CASES if everything or not case.long]
    return [case for case in chosen if not methods or set(methods) & set(case.methods)]


def _list(cases: Sequence[HardCase], *, as_json: bool) -> int:

    if as_json:
        click.echo(json_text({"cases": [_about(case) for case in cases]}))
        return GOOD
    for theme in dict.fromkeys(case.theme for case in cases):
        click.echo(theme)
        for case in cases:
            if case.theme == theme:
                long = " (long)" if case.long else ""
                click.echo(wrapped(f"  {case.name:<28}{case.hard}{long}", columns() or PROSE, indent=28))
    return GOOD


def _about(case: HardCase) -> dict[str, Any]:
    return {"name": case.name, "theme": case.theme, "hard": case.hard, "scene": case.source.scene, "duration": case.duration,
            "tolerance": case.tolerance, "methods": list(case.methods), "expected_outcome": case.outcome, "long": case.long,
            "known_failures": [{"method": m, "invariant": i, "reason": why} for (m, i), why in case.failures.items()]}  # fmt: skip


def _print_json(cases: Sequence[HardCase], by_case: dict[str, dict[str, Result]], failed: Sequence[Result]) -> None:

    records = [
        {**_about(case), "results": [of[method].record() for method in case.methods if method in of]}
        for case, of in ((case, by_case[case.name]) for case in cases)
    ]
    click.echo(json_text({"passed": not failed, "cases": records}))


# -- as people read it -------------------------------------------------------------------------------------------------


def _print_case(case: HardCase, by_case: dict[str, dict[str, Result]]) -> None:
    """Print a case and its table: invariants down, methods across; violations begin with !."""
    methods = [method for method in case.methods if method in by_case[case.name]]
    results = [by_case[case.name][method] for method in methods]
    verdict = _worst(results)
    _print_beside([(verdict, COLOURS.get(verdict)), (case.name, None)], case.hard, indent=len(verdict) + 2)
    as_expected = [r.outcome == case.outcome for r in results]
    rows = [("outcome", "", *map(_cell, [r.outcome.replace("_", " ") for r in results], as_expected))]
    for name in dict.fromkeys(row.name for r in results for row in r.measured):
        across = [
            next((row for row in r.measured if row.name == name), None) for r in results
        ]  # of SUNDIALS there is no C
        limits = {_number(row.limit) for row in across if row is not None}
        alike = len(limits) == 1
        cells = (
            "" if row is None else _cell(_number(row.value) + ("" if alike else f"/{_number(row.limit)}"), row.holds)
            for row in across
        )
        rows.append((name, limits.pop() if alike else "", *cells))
    rows.append(("time [ms]", "", *(_milliseconds(r.wall_s) for r in results)))
    if any(r.compiled_wall_s is not None for r in results):
        rows.append(("time as C [ms]", "", *(_milliseconds(r.compiled_wall_s) for r in results)))
    table(("invariant", "limit", *methods), rows)
    for reason in dict.fromkeys(case.failures.values()):
        of = [pair for pair, other in case.failures.items() if other == reason and pair[0] in methods]
        if of:
            who, quantities = (", ".join(dict.fromkeys(pair[k] for pair in of)) for k in (0, 1))
            _print_beside([("known", "yellow")], f"{who} ({quantities}): {reason}", indent=7)
    click.echo()


def _cell(text: str, holds: bool) -> str:
    return text if holds else f"!{text}"


def _print_beside(heads: Sequence[tuple[str, str | None]], text: str, *, indent: int) -> None:
    """Print prose behind words, each coloured or bold."""
    plain = GAP.join(head for head, _ in heads)
    rest = wrapped(f"{plain}{GAP}{text}", columns() or PROSE, indent=indent).removeprefix(plain)
    click.echo(GAP.join(click.style(head, fg=colour, bold=colour is None) for head, colour in heads) + rest)


def _print_summary(cases: Sequence[HardCase], by_case: dict[str, dict[str, Result]], seconds: float) -> None:
    verdicts = {case.name: _worst(list(by_case[case.name].values())) for case in cases}
    for verdict, label, explanation in (
        ("passed", "passed", ""),
        ("known failure", "known", " fail in a known way"),
        ("failed", "failed", " fail"),
    ):
        names = [name for name in verdicts if verdicts[name] == verdict]
        if names:
            count = f"{len(names)} of {len(verdicts)} cases{explanation}"
            _print_beside(
                [(f"{label:<12}", COLOURS.get(verdict))],
                count + (f": {', '.join(names)}" if explanation else ""),
                indent=14,
            )
    runs = sum(len(of) for of in by_case.values())
    line("", f"{runs} run{'s' if runs != 1 else ''} in each path, {seconds:.0f} s")


def _worst(results: Sequence[Result]) -> str:
    verdicts = {result.verdict for result in results}
    return next(verdict for verdict in ("failed", "known failure", "passed") if verdict in verdicts)


def _number(value: float) -> str:
    if value != value:
        return "none"
    if value == int(value) and abs(value) < 1e7:
        return f"{int(value)}"
    return f"{value:.2g}" if value < 0.01 or value >= 1e7 else f"{value:.4g}"


def _milliseconds(seconds: float | None) -> str:
    if seconds is None:
        return ""
    return f"{seconds * 1e3:.3g}" if seconds < 1 else f"{seconds * 1e3:.0f}"
