"""Audit of the catalogue, and of files and folders: scenes and laws in Python, laws in TOML."""

from __future__ import annotations

import ast
import os
import tomllib
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from hertzwerk.derive.audit.admissibility import faults_if_consistent
from hertzwerk.derive.audit.audit import Finding, Findings, audit_law, verdict
from hertzwerk.derive.common.execute_file import names_defined_by, sympy_remedy
from hertzwerk.derive.common.faults import Fault, InputError, as_path, refuse
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.common.module_format import refuse_generated
from hertzwerk.derive.common.toml_file import MAX_BYTES
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.derivation import audit_scene
from hertzwerk.derive.exchange.user_files.law_file import audit_laws_as_written
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import Law

_RECORDS = ("StiffnessLaw", "DampingLaw", "FrictionLaw", "FilmLaw")


def audit_catalogue() -> Findings:
    """Audit every law of the catalogue: one finding if consistent, else one per inconsistent expression."""
    return Findings(finding for law in LAWS.values() for finding in _of_law(law))


def differing_verdicts(findings: Iterable[Finding]) -> tuple[str, ...]:
    """Names of built-in laws whose verdict in `findings` differs from the catalogue's."""
    by_law = grouped((finding.law, finding) for finding in findings)
    return tuple(name for name, own in by_law.items() if verdict(own) != LAWS[name].verdict)


def _of_law(law: Law) -> tuple[Finding, ...]:
    findings = audit_law(law)
    wrong = [finding for finding in findings if finding.verdict != "consistent"]
    if not wrong:
        results = [finding for finding in findings if not finding.quantity.startswith("definition")]
        return (results or list(findings))[:1]  # type: ignore[return-value]
    named = f"repaired as {law.repair}" if law.repair else None
    return tuple(replace(finding, repair="; ".join(filter(None, (finding.repair, named))) or None) for finding in wrong)


def audit_path(path: str | Path) -> Findings:
    """All findings on a file or folder. Raises InputError."""
    return Findings(finding for findings in audit_files(path).values() for finding in findings)


def audit_files(
    path: str | Path, whole: Callable[[Scene], Iterable[Finding]] = audit_scene
) -> dict[Path, tuple[Finding, ...]]:
    """Findings by file, on a file or on every file of a folder that has scenes or laws.

    In a folder, Python files are parsed first, and executed only if they import hertzwerk and define `scene` or make
    a law; a file given by name is executed. Raises InputError with the faults of all files, those that are not parsed and
    mention hertzwerk or [[law]] among them, and where there is nothing to audit.

    whole    audits a scene
    """
    path = as_path("path", path)
    files = list(_files(path)) if path.is_dir() else [path]
    if not files:
        expected = "Python files that define a scene or laws, or TOML files with tables [[law]]"
        raise InputError(str(path), [Fault(str(path), "a folder without either", expected)])
    findings: dict[Path, tuple[Finding, ...]] = {}
    faults: list[Fault] = []
    for file in files:
        try:
            findings[file] = audit_laws_as_written(file) if file.suffix == ".toml" else _audit_python(file, whole)
        except InputError as error:
            if len(files) == 1:
                raise
            faults.extend(replace(fault, where=f"{file}: {fault.where}") for fault in error.faults)
    refuse(str(path), faults)
    return findings


def _audit_python(file: Path, whole: Callable[[Scene], Iterable[Finding]]) -> tuple[Finding, ...]:
    """Audit the laws made by a Python file, then its scenes."""
    refuse_generated(file)
    names = names_defined_by(file)
    values = {id(value): value for value in names.values()}.values()
    built_in = {id(law) for law in LAWS.values()}
    laws = [value for value in values if isinstance(value, Law) and id(value) not in built_in]
    scenes = [value for value in values if isinstance(value, Scene)]
    if not laws and not scenes:
        expected = "a file that defines `scene = Scene(...)`, or laws"
        raise InputError(str(file), [Fault(str(file), "neither a scene nor a law", expected, sympy_remedy(names))])
    findings = [finding for law in laws for finding in audit_law(law)]
    refuse(str(file), [fault for law in laws for fault in faults_if_consistent(law)])
    return (*findings, *(finding for scene in scenes for finding in whole(scene)))


def _files(folder: Path) -> Iterator[Path]:
    """Yield the files of a folder that have scenes or laws, sorted; skips hidden ones, executes nothing."""
    for file in sorted(folder.rglob("*")):
        parts = file.relative_to(folder).parts
        if any(part.startswith(".") or part == "__pycache__" for part in parts) or not file.is_file():
            continue
        if (file.suffix == ".toml" and _has_laws(file)) or (file.suffix == ".py" and _declares(file)):
            yield file


def _has_laws(file: Path) -> bool:
    try:
        if file.stat().st_size > MAX_BYTES:
            return _mentions(file, b"[[law]]")
        content = tomllib.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return _mentions(file, b"[[law]]")
    laws = content.get("law")
    return isinstance(laws, list) and bool(laws)


def _declares(file: Path) -> bool:
    try:
        tree = ast.parse(file.read_bytes())
    except (OSError, SyntaxError, ValueError, RecursionError, MemoryError):
        return _mentions(file, b"hertzwerk")
    imported = any(
        (isinstance(node, ast.ImportFrom) and (node.module or "").startswith("hertzwerk"))
        or (isinstance(node, ast.Import) and any(alias.name.startswith("hertzwerk") for alias in node.names))
        for node in tree.body
    )
    return imported and (
        any(isinstance(target, ast.Name) and target.id == "scene" for node in tree.body for target in _targets(node))
        or any(
            isinstance(node, ast.Call) and ast.unparse(node.func).split(".")[-1] in _RECORDS for node in ast.walk(tree)
        )
    )


def _mentions(file: Path, text: bytes) -> bool:
    """Return whether a file that is not parsed has a text; it is then refused later, with the reason."""
    return os.access(file, os.R_OK) and text in file.read_bytes()


def _targets(node: ast.stmt) -> list[ast.expr]:
    if isinstance(node, ast.Assign):
        return node.targets
    return [node.target] if isinstance(node, ast.AnnAssign) else []
