"""Text of a generated module: header, tables, helpers, functions."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from typing import Any

from hertzwerk.derive.common.faults import visible
from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.common.module_format import FORMAT, command, sealed
from hertzwerk.derive.program.emit.cost import operations
from hertzwerk.derive.program.emit.equal_parts_text import kind_tables, loops, table
from hertzwerk.derive.program.emit.helpers import HELPERS, helpers_in
from hertzwerk.derive.program.emit.printer import (
    WIDTH,
    Draft,
    builder_text,
    curve_text,
    draft,
    prose,
    prose_lines,
    shared_text,
)
from hertzwerk.derive.program.expression_text import curve_names
from hertzwerk.derive.program.program import OWN, Function, Program, curves_in
from hertzwerk.derive.program.repetition import share

_PROSE = ("PARAMETERS", "LIMITS", "INPUTS", "SMOOTH_INPUTS", "ADVICE", "CONTRADICTIONS")  # tables of one row a line
FLIGHT = ("applied", "accelerations", "gaps", "gap_accelerations")  # cost of a right-hand side without contact


def emit(program: Program, source: str, coordinates: str | None = None) -> str:
    """Text of the generated module of an audited program.

    source         the file of the scene
    coordinates    those of the program, where the file's scene has others
    """
    scene = program.scene
    kinds = Counter((function.arguments, *(r.name for r in function.results)) for function in program.functions)
    drafts = [
        draft(program, function, whole=kinds[function.arguments, *(r.name for r in function.results)] > 1)
        for function in program.functions
    ]
    counts = _counts(program, {drafted.function.name: operations(builder_text(program, drafted)) for drafted in drafts})
    shared = share([drafted.block for drafted in drafts], program.parts, _names_in(program, drafts))
    before = _equally_returning(program.functions)
    units = {program.names.get(symbol.name, symbol.name): unit for symbol, unit in program.units.items()}
    tables = {name: rows for name, rows in program.tables.items() if name != "FAMILIES" or not program.pairs}
    tables["CONSTANTS"] = tuple(
        (name, program.units[symbol]) for symbol in program.constants for name in program.entries(symbol)
    )
    tables["OPERATIONS"] = tuple(counts.items())
    curves = curves_in(program)
    tables |= {curve_names(curve)[1]: curve.row for curve in curves}
    casadi = program.tape.own("ca")
    parts = [
        _header(program, source, coordinates, counts),
        "import casadi as ca" + (f"\nimport casadi as {casadi}" if casadi != "ca" else ""),
        "\n".join(f"{name} = {_literal(text)}" for name, text in
                  (("NAME", scene.name), ("SOURCE", source), ("SUMMARY", scene.summary), ("FORMAT", FORMAT), ("DIGEST", ""))),
        *_kind_tables(program),
        *(_table(name, rows, program) for name, rows in tables.items() if rows),
        *(_without_rows([name for name, rows in tables.items() if rows == value], value) for value in ((), None)),
    ]  # fmt: skip
    texts = [
        *map(curve_text, curves),
        *(shared_text(program, each, units) for each in shared),
        *(builder_text(program, each, before[each.function.name]) for each in drafts),
        *([loops(program)[1]] if program.pairs else []),
    ]
    return sealed("\n\n".join(filter(None, parts)) + "\n\n\n" + "\n\n\n".join((*helpers_in(texts), *texts)) + "\n")


def _without_rows(names: list[str], value: tuple[()] | None) -> str:
    """Tables without rows, as many in a line as it holds."""
    lines: list[str] = []
    for name in names:
        longer = f"{lines[-1]} = {name}" if lines else name
        lines[-1:] = [longer] if len(longer) <= WIDTH - len(f" = {value}") else [*lines[-1:], name]
    return "\n".join(f"{line} = {value}" for line in lines)


def _kind_tables(program: Program) -> list[str]:
    """Tables of kinds, and what they call."""
    if not program.pairs:
        return []
    return [f"\n{loops(program)[0]}\n", *(f"{name} = {text}" for name, text in kind_tables(program, _literal))]


def _counts(program: Program, counts: dict[str, int]) -> dict[str, int]:
    """Operations by function; of one that calls those of trees and pairs, the sum."""
    for kind in (*program.trees, *program.pairs):
        for name in [name for name in counts if name.endswith(f"_of_{kind.name}")]:
            whole = name.removesuffix(f"_of_{kind.name}")
            times = len(kind.members) * counts.pop(name)
            whole = name if whole == "contact" else {"stored_energy": "energy"}.get(whole, whole)
            counts[whole] = counts.get(whole, 0) + times
    return counts


def _equally_returning(functions: Iterable[Function]) -> dict[str, Function | None]:
    """The first function before each that has its arguments and returns, if there is one."""
    first: dict[Any, Function] = {}
    earlier: dict[str, Function | None] = {}
    for function in functions:
        key = function.arguments, *((result.name, result.units) for result in function.results)
        earlier[function.name] = first.get(key)
        first.setdefault(key, function)
    return earlier


def _names_in(program: Program, drafts: Iterable[Draft]) -> set[str]:
    """Names that are in use in the module's functions."""
    names = {*program.tape.names, *OWN.values(), *HELPERS}
    for drafted in drafts:
        names |= {drafted.function.name, *drafted.block.inputs, *drafted.block.place}
    return names


def _header(program: Program, source: str, coordinates: str | None, counts: dict[str, int]) -> str:
    scene = program.scene
    assignments = sum(1 for _ in program.assignments())
    outputs = sum(len(result.expressions) for function in program.functions for result in function.results)
    contacts = ", ".join(f"{name} {count}" for name, count in counts.items() if name.startswith("contact_"))
    unchecked = [effect for effect, _ in program.tables["UNCHECKED"]]
    verdict = (
        f"UNCHECKED, INCONSISTENT LAWS RUN ON PURPOSE IN SI VALUES: {', '.join(unchecked)}"
        if unchecked
        else f"{assignments} assignments and {outputs} outputs checked, all consistent"
    )
    effects = grouped((effect.text, effect.name) for effect in scene.effects)
    about = f": {prose(scene.summary)}" if scene.summary else ""
    contact = f"; in contact also {contacts}" if contacts else ""
    return "\n".join(
        (
            f'"""{scene.name}{about}. Generated from {prose(source) or "a scene"}.',
            "",
            f"Do not edit; regenerate with `{prose(command(source, scene.name, coordinates))}`.",
            "Effects:",
            *(
                line
                for text, names in effects.items()
                for line in prose_lines(f"{_listed(names, program)}: {text}", "    ", " " * 8)
            ),
            f"Units: {verdict}",
            *(f"AGAINST ITS OWN POSITIONS: {prose(where)}" for where, *_ in program.tables.get("CONTRADICTIONS", ())),
            *([f"Coordinates: {prose(program.note)}"] if program.note else []),
            f"Operations: flight {sum(counts.get(name, 0) for name in FLIGHT)} (equations of motion and gaps){contact}",
            '"""',
        )
    )


def _listed(names: list[str], program: Program) -> str:
    """Names, of many alike the first and the last."""
    return ", ".join(names) if not program.pairs or len(names) < 4 else f"{names[0]} to {names[-1]}, {len(names)}"


def _table(name: str, rows: tuple[Any, ...], program: Program) -> str:
    """Table with as many rows on a line as it holds; with one where they hold prose, or numbers alone."""
    texts = table(program, rows, _literal) if program.pairs else [_literal(row) for row in rows]
    if name in _PROSE or (isinstance(rows[0], tuple) and not isinstance(rows[0][0], str)):
        return "\n".join([f"{name} = (", *(f"    {text}," for text in texts), ")"])
    whole = f"{name} = ({', '.join(texts)}{',' * (len(texts) == 1)})"
    if len(whole) <= WIDTH:
        return whole
    lines = [""]
    for text in texts:
        if len(f"   {lines[-1]} {text},") > WIDTH:
            lines.append("")
        lines[-1] += f" {text},"
    return "\n".join([f"{name} = (", *(f"   {line}" for line in lines if line), ")"])


def _literal(value: Any) -> str:
    if isinstance(value, tuple):
        return f"({', '.join(map(_literal, value))}{',' if len(value) == 1 else ''})"
    if isinstance(value, str):
        return visible(json.dumps(value, ensure_ascii=False))  # JSON escapes are valid in Python
    return repr(float(value)) if isinstance(value, float) else repr(value)  # the repr of a NumPy float is different
