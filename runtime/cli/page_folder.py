"""Page of a study on disk: one folder with figures, tables, a Markdown page, JSON, and its rows."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.studies.paper.study_page import Cell, Page, Table, Verdict
from hertzwerk.runtime.system.atomic_files import scratch_folder, write_atomically
from hertzwerk.runtime.system.digests import read_sealed, record_text
from hertzwerk.runtime.system.result_folder import failures_of, made_folder, new_folder
from hertzwerk.runtime.system.versions import versions

ROWS, REQUEST = "rows", "request.json"
COLUMNS = 80  # of prose
MARKS = {True: "holds", False: "fails", None: "found"}


class StudyFolder:
    """Folder of a study: `out`, or the next free runs/<name>-study-NNN.

    While the study goes on it holds rows/, with its request and the sweeps; at the end the page too.
    """

    def __init__(self, name: str, out: Path | None, request: dict[str, Any], *, begun: bool = False) -> None:
        self._name, self._out, self._request = f"{name}-study", out, request
        self.path = out if begun else None

    def rows(self) -> Path:
        """Make the folder, if need be, and return where the sweeps are stored in it."""
        if self.path is None:
            self.path = made_folder(self._name, self._out)
            (self.path / ROWS).mkdir()
            write_atomically(self.path / ROWS / REQUEST, record_text(self._request).encode())
        return self.path / ROWS

    def write(self, page: Page, about: Mapping[str, Any], missing: list[str]) -> tuple[Path, list[str]]:
        """Write the page, all of it at once; return folder and files.

        about: what made it, beside the versions. A figure that fails is left out, and reported in `missing`.
        """

        def fill(folder: Path) -> list[str]:
            return _fill(folder, page, about, missing)

        if self.path is None:
            return new_folder(self._name, self._out, fill)
        with scratch_folder(self.path) as temporary:
            files = fill(temporary)
            for file in files:
                (temporary / file).rename(self.path / file)
        return self.path, [*files, f"{ROWS}/"]


def read_study_request(folder: Path) -> dict[str, Any]:
    """Return the request in the folder of a study that has not ended; raises InputError."""
    expected = "the folder of a study that was stopped"
    if (folder / "study.json").exists():
        raise InputError("study", [Fault("--resume", f"{folder}, whose study is done", expected)])
    try:
        return read_sealed(folder / ROWS / REQUEST)
    except (OSError, ValueError) as error:
        raise InputError("study", [Fault("--resume", f"{folder} ({error})", expected)]) from error


def _fill(folder: Path, page: Page, about: Mapping[str, Any], missing: list[str]) -> list[str]:
    from hertzwerk.runtime.studies.paper.plot_page import save

    files: list[str] = []
    for table in page.tables:
        (folder / f"{table.name}.csv").write_text(table.csv(), encoding="utf-8")
        files.append(f"{table.name}.csv")
    for chart in page.charts:
        missing += failures_of(f"{chart.name}.svg", lambda chart=chart: files.extend(save(chart, folder)))  # type: ignore[misc]
    record = {**about, "versions": versions(), **page.record()}
    texts = {"study.json": record_text(record), "study.md": markdown(page)}
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    return ["study.md", *files, "study.json"]


def markdown(page: Page) -> str:
    """Return a page as Markdown, prose within 80 columns; tables with few digits."""
    return "\n\n".join(_parts(page)) + "\n"


def _parts(page: Page) -> Iterator[str]:
    yield f"# {page.title}"
    if page.missing:
        yield _prose(f"**Incomplete**: {page.missing}.", "> ")
    yield from map(_prose, page.paragraphs)
    if page.lacking:
        yield "\n".join(_prose(text, "> ") for text in page.lacking)
    if page.verdicts:
        yield "## Verdicts"
        yield "\n".join(_prose(said(verdict), "- ", "  ") for verdict in page.verdicts)
    for chart in page.charts:
        yield f"## {chart.title}"
        yield f"![{chart.title}]({chart.name}.svg)"
        if chart.note:
            yield _prose(chart.note)
    for table in page.tables:
        yield f"## {table.title}"
        yield "\n".join(_lines(table))


def said(verdict: Verdict) -> str:
    """Return a verdict as a sentence with its source."""
    return f"**{MARKS[verdict.holds]}**: {verdict.text}. *{verdict.source}*"


def _prose(text: str, first: str = "", rest: str | None = None) -> str:
    return textwrap.fill(
        text, COLUMNS, initial_indent=first, subsequent_indent=first if rest is None else rest,
        break_long_words=False, break_on_hyphens=False,
    )  # fmt: skip


def _lines(table: Table) -> Iterator[str]:
    rows: list[Sequence[str]] = [table.columns, ["---"] * len(table.header), *shown(table)]
    return ("| " + " | ".join(row) + " |" for row in rows)


def shown(table: Table) -> list[list[str]]:
    """Return the cells of a table as text with few digits."""
    return [[cell_text(cell) for cell in row] for row in table.rows]


def cell_text(cell: Cell) -> str:
    """Return a cell as text: numbers with four digits, nothing for a missing one."""
    if cell is None or cell != cell:
        return ""
    return f"{cell:.4g}" if isinstance(cell, float) else str(cell)
