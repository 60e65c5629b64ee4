"""Page of a report: title, contents, sections; one HTML document that fetches nothing."""

from __future__ import annotations

import base64
import hashlib
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from importlib import resources

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
