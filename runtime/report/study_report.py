"""Report of a study: question, verdicts computed from the numbers, figures, tables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from hertzwerk.derive.html.markup import Markup, joined, tag
from hertzwerk.runtime.report.html_page import Origin, Section, bullets, guarded, page, paragraphs, verdict
from hertzwerk.runtime.report.html_table import table
from hertzwerk.runtime.report.inline_svg import picture

MARKS = {True: "holds", False: "fails", None: "found"}
MOST = 500  # rows of a table


def study_page(record: Mapping[str, Any], figures: Mapping[str, str], origin: Origin) -> str:
    """Return the page of a study from its record (`study.json`) and its figures (SVG), by their paths.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    verdicts = [(v["text"], v["source"], v["holds"]) for v in record["verdicts"]]
    compared = [holds for _, _, holds in verdicts if holds is not None]
    top = paragraphs([str(record["question"])], "lead") if "question" in record else Markup("")
    if compared:
        said = f"{sum(compared)} of {len(compared)} comparisons hold"
        top = joined([top, verdict(said, all(compared), "All numbers are in the verdicts and tables below.")])
    lacking = [str(text) for text in record["lacking"]]
    sections = [
        Section("What was done", paragraphs([str(text) for text in record["paragraphs"]])),
        *([Section("Verdicts", _verdicts(verdicts))] if verdicts else []),
        *([Section("What is lacking", bullets(lacking))] if lacking else []),
        *(Section(str(f["title"]), _figure(f, figures, i)) for i, f in enumerate(record["figures"])),
        *(Section(str(t["title"]), _table(t)) for t in record["tables"]),
    ]
    return page("study", str(record["title"]), "", top, sections, origin)


def _verdicts(verdicts: list[tuple[str, str, bool | None]]) -> Markup:
    looks = {True: "badge good", False: "badge", None: "badge neutral"}
    return bullets([
        joined([tag("span", MARKS[holds], class_=looks[holds]), f" {text} ", tag("span", f"({source})", class_="note")])
        for text, source, holds in verdicts
    ])  # fmt: skip


def _figure(figure: Mapping[str, Any], figures: Mapping[str, str], number: int) -> Markup:
    title, path = str(figure["title"]), str(figure["path"])
    if path not in figures:
        return paragraphs([f"{path} is not beside the record."], "note")
    return guarded(f"The picture {path}", lambda: picture(figures[path], f"figure-{number}", title))


def _table(content: Mapping[str, Any]) -> Markup:
    rows = content["rows"]
    told = (
        [f"The first {MOST} of {len(rows):,} rows; all of them are in {content['name']}.csv."]
        if len(rows) > MOST
        else []
    )
    heads = [(str(name), str(unit)) for name, unit in content["header"]]
    shown = [
        [cell if isinstance(cell, (int, float)) or cell is None else str(cell) for cell in row] for row in rows[:MOST]
    ]
    return joined([paragraphs(told, "note"), table(heads, shown, digits=4)])
