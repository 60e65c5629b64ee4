"""HTML by construction: every text is escaped, only what `tag` made is markup."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterable, Sequence
from typing import TypeAlias

EMPTY = ("br", "col", "img", "link", "meta", "wbr")  # elements without content
_FORBIDDEN = re.compile("[\\x00-\\x08\\x0b-\\x1f\\x7f-\\x9f\\ud800-\\udfff]")


class Markup(str):
    """HTML, as made by `tag` and `joined`; any other text is escaped where it is put into a page."""

    __slots__ = ()


Content: TypeAlias = "str | Markup | None"


def tag(name: str, /, *content: Content, **attributes: str | float | None) -> Markup:
    """Return an element; texts and values of attributes are escaped, None is left out.

    Underscores in the name of an attribute stand for hyphens, but the last one.
    """
    pairs = ((key.removesuffix("_").replace("_", "-"), value) for key, value in attributes.items())
    opened = "".join([name, *(f' {key}="{_escaped(str(value))}"' for key, value in pairs if value is not None)])
    return Markup(f"<{opened}>" if name in EMPTY else f"<{opened}>{joined(content)}</{name}>")


def embedded(png: bytes, label: str) -> Markup:
    """Return a picture that the page itself holds, no wider than its place; `label` describes it."""
    source = f"data:image/png;base64,{b64encode(png).decode()}"
    return tag("img", src=source, alt=label, style="max-width:100%")


def joined(parts: Iterable[Content], between: str = "") -> Markup:
    """Return parts one after another, texts escaped, None left out."""
    return Markup(between.join(escaped(part) for part in parts if part is not None))


def escaped(text: str) -> Markup:
    """Return a text as HTML; markup stays as it is."""
    return text if isinstance(text, Markup) else Markup(_escaped(text))


def _escaped(text: str) -> str:
    """Escape a text; what no HTML may hold, control characters and halves of surrogate pairs, is replaced."""
    import html  # slow, and nothing that every run needs

    return html.escape(_FORBIDDEN.sub("\N{REPLACEMENT CHARACTER}", text))


# -- tables and headings for notebooks, without scripts, style sheets, or anything fetched -----------------------------


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
