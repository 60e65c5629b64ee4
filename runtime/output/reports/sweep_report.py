"""Report of a sweep: how its rows ended, its definition, its table."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.markup import Markup, joined
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.output.reports import scene_sections
from hertzwerk.runtime.output.reports.html_page import (
    Cell,
    Origin,
    Section,
    bullets,
    facts,
    number_text,
    page,
    paragraphs,
    table,
    verdict,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST = 1000  # rows of the table
DIGESTS = {"text": "digest of the module", "readings": "digest of the histories beside it"}  # entries that hold one
RANGES = ("column", "unit", "minimum", "median", "maximum", "rows")


def sweep_page(
    scene: str,
    outcome: Outcome,
    columns: Mapping[str, str],
    rows: Sequence[Sequence[str | float]],
    outcomes: Mapping[str, int],
    ranges: Sequence[Sequence[Cell]],
    warnings: Sequence[str],
    definition: Mapping[str, Any],
    origin: Origin,
    whole: str,
    draw: Callable[[], Figure],
) -> str:
    """Return the page of a sweep.

    columns    unit by name of column; `rows`, the first of them, have an entry for each
    outcomes    number of rows by outcome
    ranges    name, unit, minimum, median, maximum and number of each column of numbers
    warnings    those of the rows, whose column has their numbers
    definition    what the sweep computes, as plain data
    draw    draws it
    whole    where all rows are, beyond those that are listed
    """
    count = sum(outcomes.values())
    counts = {name.replace("_", " "): number_text(number) for name, number in outcomes.items()}
    top = joined([
        verdict(outcome.name.replace("_", " "), outcome.finished, outcome.message, outcome.remedy),
        facts({"rows": number_text(count), **counts}),
    ])  # fmt: skip
    sections = [
        Section("Picture", scene_sections.drawn(draw, "sweep", f"Outputs of {scene} over what was varied")),
        *([Section("Warnings", bullets([f"({i}) {text}" for i, text in enumerate(warnings, 1)]))] if warnings else []),
        Section("Rows", _table(columns, rows, count, whole)),
        Section("Ranges", table(RANGES, ranges)),
        Section("Definition", _definition(definition)),
    ]
    return page("sweep", scene, "", top, sections, origin)


def _table(columns: Mapping[str, str], rows: Sequence[Sequence[str | float]], count: int, whole: str) -> Markup:
    """Return the rows, without columns that are empty throughout."""
    filled = [j for j in range(len(columns)) if any(row[j] not in ("", None) for row in rows)]
    heads = [(name, unit) for j, (name, unit) in enumerate(columns.items()) if j in filled]
    remarks = [f"The first {len(rows):,} of {count:,} rows; all of them are in {whole}."] if count > len(rows) else []
    shown: list[list[Cell]] = [[row[j] for j in filled] for row in rows]
    return joined([paragraphs(remarks, "note"), table(heads, shown)])


def _definition(definition: Mapping[str, Any]) -> Markup:
    rows: list[list[Cell]] = [
        [DIGESTS.get(name, name), _plain(value)]
        for name, value in definition.items()
        if value not in (None, [], {}, "", False)
    ]
    return table(("setting", "value"), rows)


def _plain(value: Any) -> str:
    """Return a setting as a reader writes it, deeper nested ones as JSON."""
    if isinstance(value, str):
        return value
    if isinstance(value, list) and all(isinstance(entry, str) for entry in value):
        return ", ".join(value)
    if isinstance(value, dict) and all(isinstance(entry, str) for entry in value.values()):
        return "; ".join(f"{name} = {entry}" for name, entry in value.items())
    return json.dumps(value, ensure_ascii=False)
