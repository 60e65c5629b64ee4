"""Report of a sweep: how its rows ended, its definition, its table."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from statistics import median
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.html.markup import Markup, joined
from hertzwerk.runtime.report import scene_sections
from hertzwerk.runtime.report.html_page import Origin, Section, bullets, facts, page, paragraphs, verdict
from hertzwerk.runtime.report.html_table import Cell, number_text, table
from hertzwerk.runtime.solution.outcome import Outcome

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST = 1000  # rows of the table


def sweep_page(
    scene: str,
    outcome: Outcome,
    columns: Mapping[str, str],
    rows: Sequence[Sequence[str | float]],
    warnings: Sequence[str],
    definition: Mapping[str, Any],
    origin: Origin,
    whole: str,
    draw: Callable[[], Figure],
) -> str:
    """Return the page of a sweep.

    columns    unit by name of column; `rows` have an entry for each
    warnings    those of the rows, whose column has their numbers
    definition    what the sweep computes, as plain data
    draw    draws it
    whole    where all rows are, beyond those that are listed
    """
    ends = [str(row[list(columns).index("outcome")]) for row in rows]
    counts = {name.replace("_", " "): number_text(ends.count(name)) for name in dict.fromkeys(ends)}
    top = joined([
        verdict(outcome.name.replace("_", " "), outcome.finished, outcome.message, outcome.remedy),
        facts({"rows": number_text(len(rows)), **counts}),
    ])  # fmt: skip
    sections = [
        Section("Picture", scene_sections.drawn(draw, "sweep", f"Outputs of {scene} over what was varied")),
        *([Section("Warnings", bullets([f"({i}) {text}" for i, text in enumerate(warnings, 1)]))] if warnings else []),
        Section("Rows", _table(columns, rows, whole)),
        Section("Ranges", _ranges(columns, rows)),
        Section("Definition", _definition(definition)),
    ]
    return page("sweep", scene, "", top, sections, origin)


def _table(columns: Mapping[str, str], rows: Sequence[Sequence[str | float]], whole: str) -> Markup:
    """Return the rows, without columns that are empty throughout."""
    kept = [j for j in range(len(columns)) if any(row[j] not in ("", None) for row in rows)]
    heads = [(name, unit) for j, (name, unit) in enumerate(columns.items()) if j in kept]
    told = [f"The first {MOST} of {len(rows):,} rows; all of them are in {whole}."] if len(rows) > MOST else []
    shown: list[list[Cell]] = [[row[j] for j in kept] for row in rows[:MOST]]
    return joined([paragraphs(told, "note"), table(heads, shown)])


def _ranges(columns: Mapping[str, str], rows: Sequence[Sequence[str | float]]) -> Markup:
    """Return the least, median and largest value of every column of numbers."""
    found: list[list[Cell]] = []
    for j, (name, unit) in enumerate(columns.items()):
        numbers = (float(row[j]) for row in rows if isinstance(row[j], float))
        values = sorted(number for number in numbers if math.isfinite(number))
        if values:
            found.append([name, unit, values[0], median(values), values[-1], len(values)])
    heads = ("column", "unit", "least", "median", "largest", "rows")
    return table([(head, "") for head in heads], found)


def _definition(definition: Mapping[str, Any]) -> Markup:
    rows: list[list[Cell]] = [
        [name, value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)]
        for name, value in definition.items()
        if value not in (None, [], {}, "", False)
    ]
    return table([("setting", ""), ("value", "")], rows)
