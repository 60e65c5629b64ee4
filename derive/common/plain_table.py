"""Tables and headings for notebooks, without scripts, style sheets, or anything fetched."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from hertzwerk.derive.common.markup import Content, Markup, joined, tag

GOOD, OTHER = "#009E73", "#D55E00"
_LEFT = "text-align:left"


def table(header: Sequence[Content], rows: Iterable[Sequence[Content]]) -> Markup:
    """Return a table; texts are escaped."""
    head = tag("tr", *(tag("th", cell, style=_LEFT) for cell in header))
    body = (tag("tr", *(tag("td", cell, style=_LEFT) for cell in row)) for row in rows)
    return tag("table", tag("thead", head), tag("tbody", *body))


def heading(name: str, outcome: str, text: str, *, good: bool) -> Markup:
    """Return a line with a name, an outcome in its colour, and a text."""
    return tag("p", tag("b", name), " ", coloured(outcome, good), text)


def coloured(text: str, good: bool) -> Markup:
    """Return a text in the colour of what holds, or of what does not."""
    return tag("span", text, style=f"color:{GOOD if good else OTHER}")


def titled(title: str, header: Sequence[Content], rows: Iterable[Sequence[Content]]) -> Markup:
    """Return a table under its title; nothing without rows."""
    rows = list(rows)
    return joined([tag("p", tag("b", title)), table(header, rows)]) if rows else Markup("")
