"""Tables of a report: numbers to the right, units in the heads, sorted by a click where scripts run."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Sequence
from html import escape
from typing import TypeAlias

from hertzwerk.derive.common.markup import Markup, joined, tag

Cell: TypeAlias = "str | Markup | int | float | None"
LONG = 32  # characters from which a word is broken
BESIDE, KEYS = 7, 3  # columns of a table beside each other, and those at most that are repeated in a further one


def table(
    heads: Sequence[str | tuple[str, str]],
    rows: Sequence[Sequence[Cell]],
    *,
    marked: Collection[int] = (),
    digits: int = 5,
) -> Markup:
    """Return a table under heads, names or (name, unit); `marked` rows stand out, missing cells are empty.

    Columns whose cells are numbers are set to the right, with so many significant digits. Where there are more than fit
    beside each other further tables have the others, beside the first ones that distinguish the rows, or their numbers.
    """
    columns = [(head, "") if isinstance(head, str) else head for head in heads]
    if len(columns) > BESIDE:
        keys = _telling(rows)
        if keys > KEYS:
            columns, rows, keys = [("row", ""), *columns], [[i, *row] for i, row in enumerate(rows, 1)], 1
        size = BESIDE - keys
        parts = [[*range(keys), *range(k, min(k + size, len(columns)))] for k in range(keys, len(columns), size)]
    else:
        parts = [[*range(len(columns))]]
    return joined(
        [_table([columns[j] for j in part], [[row[j] for j in part] for row in rows], marked, digits) for part in parts]
    )


def _telling(rows: Sequence[Sequence[Cell]]) -> int:
    """Return how many of the first columns distinguish the rows; more than KEYS where none of so many do."""
    return next((k for k in range(1, KEYS + 1) if len({tuple(row[:k]) for row in rows}) == len(rows)), KEYS + 1)


def _table(
    columns: Sequence[tuple[str, str]], rows: Sequence[Sequence[Cell]], marked: Collection[int], digits: int
) -> Markup:
    numeric = [_numeric([row[j] for row in rows]) for j in range(len(columns))]
    heads = (
        tag("th", _breakable(name), *_unit_after(unit), scope="col", class_="number" if right else None)
        for (name, unit), right in zip(columns, numeric, strict=True)
    )
    lines = (
        tag("tr", *(_cell(cell, right, digits) for cell, right in zip(row, numeric, strict=True)),
            class_="changed" if i in marked else None)
        for i, row in enumerate(rows)
    )  # fmt: skip
    return tag("table", tag("thead", tag("tr", *heads)), tag("tbody", *lines), class_="sortable")


def unit_markup(unit: str) -> Markup:
    """Return the text of a unit with its exponents raised; nothing for 1."""
    return Markup("" if unit == "1" else re.sub(r"\^(-?[\w./]+|\([^()]*\))", r"<sup>\1</sup>", escape(unit)))


def number_text(value: float, digits: int = 5) -> str:
    """Return a number in few digits, with a true minus sign."""
    if isinstance(value, int):
        return f"{value:,}".replace(",", "\N{NARROW NO-BREAK SPACE}").replace("-", "−")
    return f"{value + 0.0:.{digits}g}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e").replace("-", "−")


def _numeric(cells: Sequence[Cell]) -> bool:
    known = [cell for cell in cells if cell is not None and cell != ""]
    return bool(known) and all(isinstance(cell, (int, float)) and not isinstance(cell, bool) for cell in known)


def _breakable(name: str) -> Markup:
    """Return a name that may go on in the next line after a stroke, a dot or a slash."""
    return joined(re.split(r"(?<=[/._])", name), tag("wbr"))


def _unit_after(unit: str) -> list[Markup]:
    shown = unit_markup(unit)
    return [Markup(" "), tag("span", joined(["[", shown, "]"]), class_="unit")] if shown else []


def _cell(cell: Cell, right: bool, digits: int) -> Markup:
    look = "number" if right else None
    if cell is None:
        return tag("td", class_=look)
    if isinstance(cell, str):
        long = not isinstance(cell, Markup) and any(len(word) > LONG for word in cell.split())
        return tag("td", cell, class_="long" if long else look)
    if isinstance(cell, float) and math.isnan(cell):
        return tag("td", "", class_=look)
    return tag("td", number_text(cell, digits), class_=look, data_value=repr(cell))
