"""Page of a report: title, contents, sections; one HTML document that fetches nothing."""

from __future__ import annotations

import base64
import hashlib
import math
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from importlib import resources
from typing import TypeAlias

from hertzwerk.derive.common.markup import Markup, joined, tag

FEW = 3  # sections that need no table of contents


@dataclass(frozen=True)
class Section:
    """Titled part of a page."""

    title: str
    content: Markup


@dataclass(frozen=True)
class Origin:
    """Origin of what a page shows: the command or the call that made it, the versions that computed it."""

    command: str
    versions: Mapping[str, str] | None = None


def page(kind: str, title: str, lead: str, top: Markup, sections: Sequence[Section], origin: Origin) -> str:
    """Return a page as text; it holds everything it shows, and its policy forbids to fetch anything."""
    sections = [*sections, Section("Origin", _origin(origin))]
    ids = _ids([section.title for section in sections])
    script, style = (resources.files(__package__).joinpath(name).read_text("utf-8") for name in ("page.js", "page.css"))
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    policy = f"default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{digest}'"
    head = tag(
        "head",
        tag("meta", charset="utf-8"),
        tag("meta", http_equiv="Content-Security-Policy", content=policy),
        tag("meta", name="viewport", content="width=device-width, initial-scale=1"),
        tag("title", f"{title}: hertzwerk {kind}"),
        tag("style", Markup(style)),
    )
    contents = tag("nav", tag("ol", *(
        tag("li", tag("a", section.title, href=f"#{at}")) for section, at in zip(sections, ids, strict=True)
    )), aria_label="Contents")  # fmt: skip
    body = tag(
        "body",
        tag("header", tag("p", f"hertzwerk {kind}", class_="kind"), tag("h1", title), tag("p", lead, class_="lead")),
        top,
        contents if len(sections) > FEW else None,
        tag(
            "main", *(tag("section", tag("h2", s.title), s.content, id=at) for s, at in zip(sections, ids, strict=True))
        ),
        tag("script", Markup(script)),
    )
    return f"<!DOCTYPE html>\n{tag('html', head, body, lang='en')}\n"


def paragraphs(texts: Sequence[str], look: str | None = None) -> Markup:
    """Return texts as paragraphs, what stands between backticks as code."""
    return joined(tag("p", _prose(text), class_=look) for text in texts)


def bullets(texts: Sequence[str | Markup]) -> Markup:
    """Return texts as a list, what stands between backticks as code."""
    return tag("ul", *(tag("li", _prose(text)) for text in texts))


def _prose(text: str | Markup) -> Markup:
    if isinstance(text, Markup):
        return text
    return joined(tag("code", part) if i % 2 else part for i, part in enumerate(text.split("`")))


def facts(named: Mapping[str, str]) -> Markup:
    """Return numbers by name, side by side."""
    return tag("dl", *(tag("div", tag("dt", name), tag("dd", text)) for name, text in named.items()), class_="facts")


def verdict(word: str, good: bool | None, *texts: str) -> Markup:
    """Return a word on the outcome, and sentences below."""
    look = "neutral" if good is None else "good" if good else ""
    return tag("div", tag("p", tag("span", word, class_=f"badge {look}".strip())), paragraphs([t for t in texts if t]),
               class_=f"outcome {look}".strip())  # fmt: skip


def guarded(subject: str, make: Callable[[], Markup]) -> Markup:
    """Return a part of a page, or the reason why there is none."""
    try:
        return make()
    except Exception as error:  # whatever it is: the numbers are there
        return tag("p", f"{subject} could not be made: {type(error).__name__}: {error}", class_="note")


def _origin(origin: Origin) -> Markup:
    known = origin.versions
    software = (
        "the file does not state it"
        if known is None
        else ", ".join(f"{name} {version}" for name, version in known.items())
    )
    return joined(
        [tag("p", "Made by"), tag("pre", origin.command), tag("p", f"Computed by: {software}.", class_="note")]
    )


def _ids(titles: Sequence[str]) -> list[str]:
    """Return a distinct fragment name for each title."""
    names: list[str] = []
    for number, title in enumerate(titles):
        name = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-") or "section"
        names.append(name if name not in names else f"{name}-{number}")
    return names


# -- tables of a report: numbers to the right, units in the heads, sorted by a click where scripts run -----------------


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
