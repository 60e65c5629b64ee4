"""Page of a study: question, sentences, tables, charts and verdicts, as plain values.

Nothing here draws or writes: `studies/paper/plot_page.py` draws charts, `cli/page_folder.py` writes a folder.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np

from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps
from hertzwerk.runtime.system.arrays import Array

Cell = str | int | float | None


@dataclass(frozen=True)
class Axis:
    """Quantity along an axis, in `unit`; `history`: the history of a run that it shows, for measurements.

    `labels`: names of the positions 0, 1, ... where it shows no quantity; `least`: value that no interval reaches below.
    """

    name: str
    unit: str = ""
    log: bool = False
    history: str = ""
    labels: tuple[str, ...] = ()
    least: float = -math.inf

    def __str__(self) -> str:
        return f"{self.name} [{self.unit}]" if self.unit else self.name


@dataclass(frozen=True)
class Curve:
    """Values y (n,) over x (n,) in the units of the axes; half_width (n,) of their errors, if known."""

    label: str
    x: Array
    y: Array
    half_width: Array | None = None
    look: Literal["line", "dots", "both", "dashed", "reference", "measured"] = "line"

    def __post_init__(self) -> None:
        """Convert to arrays; raises ValueError if their lengths differ."""
        for name in ("x", "y", "half_width"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, np.asarray(getattr(self, name), dtype=float))
        if self.x.shape != self.y.shape or self.x.ndim != 1:
            raise ValueError(f"curve {self.label}: found x {self.x.shape} and y {self.y.shape}, expected equal lengths")


@dataclass(frozen=True)
class Panel:
    """Curves in one pair of axes; `marks`: vertical lines (x, text); `equal`: equal scales of both axes."""

    title: str
    x: Axis
    y: Axis
    curves: tuple[Curve, ...]
    marks: tuple[tuple[float, str], ...] = ()
    equal: bool = False
    y_limits: tuple[float, float] | None = None


@dataclass(frozen=True)
class Chart:
    """Figure of panels in rows of `columns`; `name` is that of its files, `note` stands below."""

    name: str
    title: str
    panels: tuple[Panel, ...]
    columns: int = 2
    note: str = ""


@dataclass(frozen=True)
class Table:
    """Rows under a header of (name, unit) pairs; `name` is that of its file."""

    name: str
    title: str
    header: tuple[tuple[str, str], ...]
    rows: tuple[tuple[Cell, ...], ...]

    def __post_init__(self) -> None:
        """Check the lengths of the rows; raises ValueError."""
        for row in self.rows:
            if len(row) != len(self.header):
                raise ValueError(f"table {self.name}: found a row of {len(row)} cells, expected {len(self.header)}")

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns, with their units."""
        return tuple(f"{name} [{unit}]" if unit else name for name, unit in self.header)

    def column(self, name: str) -> tuple[Cell, ...]:
        """Return the cells of a column; raises KeyError."""
        names = [name for name, _ in self.header]
        if name not in names:
            raise KeyError(f"no column {name!r}; there are {', '.join(names)}")
        return tuple(row[names.index(name)] for row in self.rows)

    def csv(self) -> str:
        """Return the table as CSV, numbers in full; missing ones are empty."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(self.columns)
        writer.writerows(self.rows)
        return text.getvalue()


@dataclass(frozen=True)
class Verdict:
    """Sentence with numbers, and the source they are compared with; `holds`: None where they are not."""

    text: str
    source: str
    holds: bool | None = None


def compared(subject: str, found: float, expected: float, tolerance: float, source: str) -> Verdict:
    """Return the verdict on a number, compared with an independent one to a relative tolerance."""
    off = abs(found - expected) / abs(expected) if expected else abs(found)
    text = f"{subject}: {found:.6g}, expected {expected:.6g}; off by {off:.1e} (limit {tolerance:.0e})"
    return Verdict(text, source, bool(off <= tolerance))


@dataclass(frozen=True)
class Page:
    """Result of a study. `lacking`: sentences on what could not be had of its sources.

    `missing`: says what it does not show, where it was stopped before its end.
    """

    title: str
    paragraphs: tuple[str, ...]
    tables: tuple[Table, ...] = ()
    charts: tuple[Chart, ...] = ()
    verdicts: tuple[Verdict, ...] = ()
    lacking: tuple[str, ...] = ()
    missing: str = ""

    @property
    def holds(self) -> bool:
        """Return whether no comparison of the page failed."""
        return all(verdict.holds is not False for verdict in self.verdicts)

    def record(self) -> dict[str, Any]:
        """Return the page as plain values for JSON; figures by the name of their files."""
        return {
            "title": self.title,
            "paragraphs": list(self.paragraphs),
            "lacking": list(self.lacking),
            "missing": self.missing,
            "verdicts": [{"text": v.text, "source": v.source, "holds": v.holds} for v in self.verdicts],
            "tables": [
                {
                    "name": t.name,
                    "title": t.title,
                    "header": [list(c) for c in t.header],
                    "rows": [list(r) for r in t.rows],
                }
                for t in self.tables
            ],
            "figures": [{"title": c.title, "path": f"{c.name}.svg", "note": c.note} for c in self.charts],
        }


Progress = Callable[[float], object]


@dataclass(frozen=True)
class Study:
    """Question, and `run(quick, progress, sweeps)` that returns its page.

    It calls progress(fraction done), and makes its sweeps by `sweeps(name, target, over, ...)`, which stores them.
    `histories`: those that its panels show over time, with a unit of each, which `--measured` may supply.
    """

    name: str
    question: str
    run: Callable[[bool, Progress, Sweeps], Page]
    histories: Mapping[str, str] = field(default_factory=dict)
