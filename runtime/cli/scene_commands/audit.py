"""`hertzwerk audit`: units and starts of scenes, files, folders; the laws; one expression.

Annotations are workflow commands of GitHub, or SARIF 2.1.0 (OASIS, 2020). Each stands at the line that declares what it
is of, line 1 where a file does not name that.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import quote

import click

from hertzwerk.derive.common.faults import Fault, InputError, faults_if, refuse
from hertzwerk.runtime.cli.terminal import BAD_INPUT, GOOD, OTHER_OUTCOME, Progress, line, reports_bad_input, table

if TYPE_CHECKING:
    from hertzwerk.derive.audit.audit import Finding
    from hertzwerk.derive.declare.scene.scene import Scene

RULES = {  # level, and what it is
    "inconsistent-units": ("error", "Units that do not agree"),
    "start": ("error", "A start from which no run begins"),
    "advice": ("warning", "A law or an expression to be looked at, whose units agree"),
    "input": ("error", "A file that cannot be audited"),
}
_DECLARED = r"""(?:\((?:\s|#.*\n)*|\bname\s*=\s*)["']{}["']"""  # as the first argument of a call, or by `name =`
_FILE = re.compile(r"(?P<file>[^:]*\.(?:py|toml))(?:, line (?P<line>\d+))?")


class Remark(NamedTuple):
    """Remark on a line of a file; of a built-in scene `file` is None."""

    rule: str
    title: str
    text: str
    file: Path | None
    line: int


def remarks(audited: Mapping[str, Sequence[Finding]]) -> Iterator[Remark]:
    """Yield the remarks on findings by target."""
    from hertzwerk.runtime.engine.model.build import file_of

    for target, findings in audited.items():
        file = Path(target) if target.endswith(".toml") else file_of(target)
        for finding in findings:
            text = (
                finding.reason if finding.verdict == "advice" else finding.advice if finding.sound else finding.sentence
            )
            if text:
                rule = "advice" if finding.sound else "start" if finding.kind == "start" else "inconsistent-units"
                title = ", ".join(filter(None, (finding.effect, finding.quantity)))
                yield Remark(rule, title, text, file, _line(file, (finding.effect, finding.law), finding.quantity))


def faults_as_remarks(error: InputError) -> Iterator[Remark]:
    """Yield the faults of files that cannot be audited."""
    for fault in error.faults:
        places = [*_FILE.finditer(fault.where)] or [*_FILE.finditer(error.subject)]
        place = places[-1] if places else None
        file = Path(place["file"].strip()) if place else None
        line = int(place["line"]) if place and place["line"] else _line(file, re.findall(r"\w+", fault.where)[::-1], "")
        yield Remark("input", fault.where, f"found {fault.found}; expected {fault.expected}", file, line)


def github(notes: Sequence[Remark]) -> str:
    """Return remarks as workflow commands, one a line."""
    lines = []
    for remark in notes:
        where = {} if remark.file is None else {"file": _relative(remark.file), "line": remark.line}
        properties = ",".join(
            f"{name}={_escaped(value, ':,')}" for name, value in {**where, "title": remark.title}.items()
        )
        lines.append(f"::{RULES[remark.rule][0]} {properties}::{_escaped(remark.text)}")
    return "\n".join(lines)


def sarif(notes: Sequence[Remark]) -> str:
    """Return remarks as one log of the Static Analysis Results Interchange Format."""
    from hertzwerk.version import __version__

    rules = [{"id": name, "shortDescription": {"text": text}} for name, (_, text) in RULES.items()]
    results = [
        {
            "ruleId": remark.rule,
            "level": RULES[remark.rule][0],
            "message": {"text": f"{remark.title}: {remark.text}"},
            "locations": [
                {"physicalLocation": {"artifactLocation": {"uri": quote(_relative(file))}, "region": {"startLine": remark.line}}}
                for file in [remark.file] if file is not None
            ],
        }
        for remark in notes
    ]  # fmt: skip
    driver = {"name": "hertzwerk", "version": __version__, "rules": rules}
    schema = "https://json.schemastore.org/sarif-2.1.0.json"
    log = {"$schema": schema, "version": "2.1.0", "runs": [{"tool": {"driver": driver}, "results": results}]}
    return json.dumps(log, indent=2, ensure_ascii=False)


FORMATS = {"github": github, "sarif": sarif}


def _line(file: Path | None, names: Sequence[str], entry: str) -> int:
    """Return the line that declares the first name that a file has, or an entry of that declaration."""
    text = file.read_text(encoding="utf-8", errors="replace") if file is not None and file.is_file() else ""
    for name in names:
        declared = [*re.finditer(_DECLARED.format(re.escape(name)), text)]
        if declared:
            part = re.compile(rf"^[ \t]*{re.escape(entry)}\s*=", re.MULTILINE).search(text, declared[-1].start())
            return text.count("\n", 0, (part or declared[-1]).start()) + 1
    return 1


def _relative(file: Path) -> str:
    """Return a file as seen from the working folder, that of the repository."""
    place = file.resolve()
    return (place.relative_to(Path.cwd()) if place.is_relative_to(Path.cwd()) else place).as_posix()


def _escaped(value: object, further: str = "") -> str:
    return "".join(f"%{ord(c):02X}" if c in f"%\r\n{further}" else c for c in str(value))


@click.command(epilog='Example: hertzwerk audit --expr "K*d**n" --unit K=N/m^1.5 --unit d=m --value n=1.1 --expect N')
@click.argument("targets", metavar="[SCENE|FILE|FOLDER]...", nargs=-1)
@click.option("--laws", is_flag=True, help="Audit the catalogue of laws. Exit code 0: every verdict is the stated one.")
@click.option("--expr", metavar="TEXT", help='Audit one expression in Python syntax: --expr "K*d**n".')
@click.option("--unit", "units", metavar="NAME=UNIT", multiple=True, help="Unit of a name in --expr: --unit K=N/m^1.5.")
@click.option(
    "--value",
    "values",
    metavar="NAME=NUMBER",
    multiple=True,
    help="Value of a dimensionless name in --expr: --value n=1.1 (default: it is a symbol).",
)
@click.option("--expect", metavar="UNIT", help="Unit that --expr must have, such as N (default: any).")
@click.option("--json", "as_json", is_flag=True, help='Print one JSON object, {"findings": [...]}.')
@click.option(
    "--format",
    "form",
    type=click.Choice([*FORMATS]),
    help="Print annotations of files and lines: workflow commands of github, or sarif 2.1.0 (default: text).",
)
@reports_bad_input
def audit(
    targets: tuple[str, ...],
    laws: bool,
    expr: str | None,
    units: tuple[str, ...],
    values: tuple[str, ...],
    expect: str | None,
    as_json: bool,
    form: str | None,
) -> int:
    """Check the units of scenes, files, laws or one expression.

    Exit code 0: consistent, 1: inconsistent, or a start from which no run begins, 2: bad input. SCENE is a built-in
    scene, FILE a Python or TOML file of scenes or laws, FOLDER a folder of them.
    """
    _must_name_one(
        targets, laws, expr, stray=bool(units or values or expect), alone=bool(form and (as_json or not targets))
    )
    if expr is not None:
        return _audit_expression(expr, units, values, expect, as_json)
    if laws:
        return _audit_laws(as_json)
    from hertzwerk.runtime.engine.model.build import audit_targets

    try:
        with Progress("audit", shown=form is None and not as_json) as progress:
            audited = audit_targets(progress.over(targets), _start_faults)
    except InputError as error:
        if form is None:
            raise
        click.echo(FORMATS[form]([*faults_as_remarks(error)]))
        return BAD_INPUT
    findings = [finding for group in audited.values() for finding in group]
    if as_json:
        _print_json([{"file": target, **finding.record()} for target, group in audited.items() for finding in group])
    if form is not None:
        click.echo(FORMATS[form]([*remarks(audited)]))
    for target, group in () if as_json or form else audited.items():
        if len(audited) > 1:
            click.echo(f"{target}:")
        _report(group)
    return GOOD if all(finding.sound for finding in findings) else OTHER_OUTCOME


def _start_faults(target: str | Scene) -> Sequence[Fault]:
    """Return what a run with the values of the scene would refuse at its start."""
    from hertzwerk.runtime.engine.start.separation import overlaps
    from hertzwerk.runtime.engine.start.start_values import start_of
    from hertzwerk.runtime.loading import engine_model

    try:
        model = engine_model(target)
        bound, q, u = start_of(model, {}, {})
    except InputError as error:
        return error.faults
    return overlaps(model, bound, {}, q, u)[0]


def _must_name_one(targets: Sequence[str], laws: bool, expr: str | None, *, stray: bool, alone: bool) -> None:
    named = [bool(targets), laws, expr is not None]
    actual = "nothing to audit" if not any(named) else "several things at once"
    faults = faults_if(
        (sum(named) != 1, Fault("audit", actual, "scenes, files or folders; or --laws; or --expr")),
        (stray and expr is None, Fault("audit", "--unit, --value or --expect without --expr", "--expr TEXT beside them")),
        (alone, Fault("audit", "--format with --json, or without files", "scenes, files or folders, and one of both")),
    )  # fmt: skip
    refuse("audit", faults)


def _audit_expression(text: str, units: Sequence[str], values: Sequence[str], expect: str | None, as_json: bool) -> int:
    from hertzwerk.runtime.engine.model.build import audit_text

    finding = audit_text(text, units, values, expect)
    if as_json:
        _print_json([finding.record()])
    else:
        line(finding.verdict, finding.sentence)
        _advise([finding])
    return GOOD if finding.verdict == "consistent" else OTHER_OUTCOME


def _audit_laws(as_json: bool) -> int:
    from hertzwerk.runtime.engine.model.build import audit_catalogue

    with Progress("audit", shown=not as_json) as progress:
        progress.stage("laws of the catalogue")
        findings, differing = audit_catalogue()
    if as_json:
        _print_json([finding.record() for finding in findings])
        return OTHER_OUTCOME if differing else GOOD
    table(
        ("verdict", "kind", "grade", "law", "unit", "what is wrong"),
        [
            (f.verdict, f.kind, f.grade, f.law, f.found if f.verdict == "consistent" else f"{f.found}, not {f.expected}",
             "" if f.verdict == "consistent" else f"{f.subexpression}: {f.repair or f.reason}")
            for f in findings
        ],
    )  # fmt: skip
    if differing:
        line("different", f"verdicts that differ from the catalogue: {', '.join(differing)}")
        return OTHER_OUTCOME
    line("consistent", f"{len({f.law for f in findings})} laws, each with the verdict its record states")
    return GOOD


def _report(every: Sequence[Finding]) -> None:
    findings = [finding for finding in every if finding.verdict != "advice"]
    rows = [
        (f.verdict, ", ".join(filter(None, (f.effect, f.quantity))), f.law,
         "" if f.kind == "start" else f.found if f.found == f.expected else f"{f.found}, not {f.expected}")
        for f in findings
    ]  # fmt: skip
    if rows:
        table(("verdict", "checked", "law", "unit"), rows)
    faulty = [finding for finding in findings if finding.verdict != "consistent"]
    for finding in faulty:
        click.echo(f"\n{finding}")
    if faulty:
        click.echo()
    if faulty and all(finding.kind == "start" for finding in faulty):
        line("refused", "no run begins from this start; the units are consistent")
    elif faulty:
        line("inconsistent", f"{len(faulty)} of {len(findings)} findings; an inconsistent scene is not derived")
    else:
        laws = f"{len(findings)} law expression{'s' if len(findings) != 1 else ''}"
        program = any(f.effect for f in findings) or not findings  # a scene without laws has its program alone
        line("consistent", f"{laws}{', and every assignment and output of the program' if program else ''}")
    _advise(every)


def _advise(findings: Sequence[Finding]) -> None:
    """Print what is to be heeded beside the units."""
    for finding in findings:
        text = finding.reason if finding.verdict == "advice" else finding.advice
        if text:
            line("advice", f"{finding.effect}: {text}" if finding.effect and finding.advice else text)


def _print_json(records: list[dict[str, str | None]]) -> None:
    click.echo(json.dumps({"findings": records}, indent=2, ensure_ascii=False))
