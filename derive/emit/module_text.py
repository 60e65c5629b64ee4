"""Text of a generated module: header, tables, helpers, functions."""

from __future__ import annotations

import json
from typing import Any

from hertzwerk.derive.audit.audit import count_checked
from hertzwerk.derive.emit.cost import operations
from hertzwerk.derive.emit.helpers import helpers_in
from hertzwerk.derive.emit.printer import curve_text, function_text, prose
from hertzwerk.derive.faults import visible
from hertzwerk.derive.program.expression_text import curve_names
from hertzwerk.derive.program.program import Program, curves_in

FLIGHT = ("applied", "accelerations", "gaps", "gap_accelerations")  # cost of a right-hand side without contact


def emit(program: Program, source: str) -> str:
    """Text of the generated module of an audited program; `source` names the scene's file."""
    scene = program.scene
    functions = {function.name: function_text(program, function) for function in program.functions}
    counts = {name: operations(text) for name, text in functions.items()}
    tables = dict(program.tables)
    tables["CONSTANTS"] = tuple(
        (name, program.units[symbol]) for symbol in program.constants for name in program.entries(symbol)
    )
    tables["OPERATIONS"] = tuple(counts.items())
    curves = curves_in(program)
    tables |= {curve_names(curve)[1]: curve.row for curve in curves}
    casadi = program.tape.own("ca")
    parts = [
        _header(program, source, counts),
        "import casadi as ca" + (f"\nimport casadi as {casadi}" if casadi != "ca" else ""),
        "\n".join(f"{name} = {_literal(text)}" for name, text in
                  (("NAME", scene.name), ("SOURCE", source), ("SUMMARY", scene.summary))),
        *(_table(name, rows) for name, rows in tables.items()),
    ]  # fmt: skip
    texts = [*map(curve_text, curves), *functions.values()]
    return "\n\n".join(parts) + "\n\n\n" + "\n\n\n".join((*helpers_in(texts), *texts)) + "\n"


def _header(program: Program, source: str, counts: dict[str, int]) -> str:
    scene = program.scene
    assignments, outputs = count_checked(program)
    contacts = ", ".join(f"{name} {count}" for name, count in counts.items() if name.startswith("contact_"))
    unchecked = [effect for effect, _ in program.tables["UNCHECKED"]]
    verdict = (
        f"UNCHECKED, INCONSISTENT LAWS RUN ON PURPOSE IN SI VALUES: {', '.join(unchecked)}"
        if unchecked
        else f"{assignments} assignments and {outputs} outputs checked, all consistent"
    )
    name = scene.name if source.startswith("derive/") else source or "FILE"
    contact = f"; in contact also {contacts}" if contacts else ""
    return "\n".join(
        (
            f'"""{scene.name}: {prose(scene.summary)}. Generated from {prose(source) or "a scene"}.',
            "",
            f"Do not edit; regenerate with `hertzwerk derive {prose(name)}`.",
            "Effects:",
            *(f"    {effect.name}: {prose(effect.text)}" for effect in scene.effects),
            f"Units: {verdict}",
            *([f"Coordinates: {prose(program.note)}"] if program.note else []),
            f"Operations: flight {sum(counts.get(name, 0) for name in FLIGHT)} (equations of motion and gaps){contact}",
            '"""',
        )
    )


def _table(name: str, rows: tuple[Any, ...]) -> str:
    if not rows:
        return f"{name} = ()"
    return "\n".join([f"{name} = (", *(f"    {_literal(row)}," for row in rows), ")"])


def _literal(value: Any) -> str:
    if isinstance(value, tuple):
        return f"({', '.join(map(_literal, value))}{',' if len(value) == 1 else ''})"
    if isinstance(value, str):
        return visible(json.dumps(value, ensure_ascii=False))  # JSON escapes are valid in Python
    return repr(float(value)) if isinstance(value, float) else repr(value)  # the repr of a NumPy float is different
