"""Annotations of an audit: workflow commands of GitHub, and SARIF 2.1.0 (OASIS, 2020).

Each stands at the line that declares what it is of, line 1 where a file does not name that.
"""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple
from urllib.parse import quote

from hertzwerk.derive.common.faults import InputError

if TYPE_CHECKING:
    from hertzwerk.derive.audit.audit import Finding

RULES = {  # level, and what it is
    "inconsistent-units": ("error", "Units that do not agree"),
    "start": ("error", "A start from which no run begins"),
    "advice": ("warning", "A law or an expression to be looked at, whose units agree"),
    "input": ("error", "A file that cannot be audited"),
}
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
    """Return the line that declares the first name that a file has; of a law in TOML its part."""
    text = file.read_text(encoding="utf-8", errors="replace") if file is not None and file.is_file() else ""
    lines = text.splitlines()
    for name in names if file is not None and file.suffix == ".toml" else ():
        for i, line in enumerate(lines):
            if re.match(rf"\s*name\s*=\s*[\"']{re.escape(name)}[\"']", line):
                parts = (k for k, part in enumerate(lines[i:], i) if re.match(rf"\s*{re.escape(entry)}\s*=", part))
                return next(parts, i) + 1
    try:
        nodes = list(ast.walk(ast.parse(text if file is not None and file.suffix == ".py" else "")))
    except (SyntaxError, ValueError, RecursionError):
        return 1
    calls: dict[object, int] = {}
    for node in nodes:
        if isinstance(node, ast.Call):
            arguments = [*node.args[:1], *(word.value for word in node.keywords if word.arg == "name")]
            calls |= {
                arg.value: max(node.lineno, calls.get(arg.value, 1))
                for arg in arguments
                if isinstance(arg, ast.Constant)
            }
    return next((calls[name] for name in names if name in calls), 1)


def _relative(file: Path) -> str:
    """Return a file as seen from the working folder, that of the repository."""
    place = file.resolve()
    return (place.relative_to(Path.cwd()) if place.is_relative_to(Path.cwd()) else place).as_posix()


def _escaped(value: object, further: str = "") -> str:
    return "".join(f"%{ord(c):02X}" if c in f"%\r\n{further}" else c for c in str(value))
