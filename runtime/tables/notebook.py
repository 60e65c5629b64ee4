"""HTML of results for notebooks: tables of plain text, without scripts and without anything fetched."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hertzwerk.runtime.solution.solution import Solution

SHOWN = 8  # impacts of a run
GOOD, OTHER = "#009E73", "#D55E00"


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table of texts, which are escaped."""
    head = "".join(f'<th style="text-align:left">{escape(cell)}</th>' for cell in header)
    body = "".join(
        "<tr>" + "".join(f'<td style="text-align:left">{escape(cell)}</td>' for cell in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def heading(name: str, outcome: str, text: str) -> str:
    """Return a line with a name, an outcome in its colour, and a text."""
    colour = GOOD if outcome == "finished" else OTHER
    return f'<p><b>{escape(name)}</b> <span style="color:{colour}">{escape(outcome)}</span>{escape(text)}</p>'


def of_run(run: Solution, given: Mapping[str, tuple[float, str]]) -> str:
    """Return outcome, warnings, given parameters, and the first impacts of a run."""
    first, *rest = str(run).split("\n")
    parts = [heading(run.model.name, run.outcome.name, first.removeprefix(run.outcome.name))]
    notes = [*rest, *run.warnings]
    parts += [f'<p style="color:{OTHER}">{escape(note)}</p>' for note in notes]
    if given:
        parts.append(table(("parameter", "value"), [(name, f"{x:.6g} {unit}") for name, (x, unit) in given.items()]))
    if run.impacts:
        header = ("impact", "t [s]", "speed [m/s]", "peak force [N]", "duration [s]")
        parts.append(table(header, [
            (i.contact, f"{i.t:.6g}", f"{i.speed:.4g}", f"{i.peak_force:.4g}", "" if i.duration is None else f"{i.duration:.4g}")
            for i in run.impacts[:SHOWN]
        ]))  # fmt: skip
    more = len(run.impacts) - SHOWN
    parts += [f"<p>and {more:,} more impacts</p>"] if more > 0 else []
    return "".join(parts)
