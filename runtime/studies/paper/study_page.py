"""Studies and their pages: question, sentences, tables, charts and verdicts, as plain values.

A measurement is laid over the panels that show histories which it has.

Nothing here draws or writes: `studies/paper/plot_page.py` draws charts, `cli/page_folder.py` writes a folder.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from hertzwerk.derive.common.execute_file import names_defined_by
from hertzwerk.derive.common.faults import Fault, InputError, refuse, unknown
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.inputs.measurement_csv import Measurement

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


NAMES = ("exponents", "stiffness", "restitution", "bouncing", "slider_crank")
"""Built-in studies: NAME is `STUDY` of `study_NAME.py`."""


def study_of(target: str) -> Study:
    """Return a built-in study, or `study` of a Python file, which is executed; raises InputError."""
    from hertzwerk.runtime.engine.model.build import is_file

    if target in NAMES:
        study: Study = import_module(f"hertzwerk.runtime.studies.paper.study_{target}").STUDY
        return study
    if not is_file(target):
        raise InputError("study", [unknown("study", target, NAMES, "or a Python file (its name ends in .py)")])
    own = names_defined_by(Path(target)).get("study")
    if not isinstance(own, Study):
        actual = "no `study`" if own is None else f"`study` of type {type(own).__name__}"
        raise InputError(target, [Fault(target, actual, "a file that defines `study = Study(name, question, run)`")])
    return own


def require_columns(study: Study, measured: Measurement) -> None:
    """Raise InputError where a measured unit does not fit, and where a study shows no measured history."""
    shown = study.histories
    faults = [
        Fault(f"column {name}", f"[{measured.units[name]}]", f"a unit like {unit}")
        for name, unit in shown.items()
        if name in measured.columns and parse_unit(unit).exponents != measured.unit(name).exponents
    ]
    if not shown.keys() & measured.columns.keys():
        expected = f"some of {', '.join(shown)}" if shown else f"histories of study {study.name}, which states none"
        faults.append(Fault("columns", ", ".join(measured.columns), expected))
    refuse(measured.source, faults)


def laid_over(page: Page, measured: Measurement) -> Page:
    """Return a page whose panels of a measured history over time show the measurement too."""
    charts = (replace(chart, panels=tuple(_over(panel, measured) for panel in chart.panels)) for chart in page.charts)
    caption = f"Black dots: measured, from {Path(measured.source).name}, as they are, neither filtered nor shifted."
    return replace(page, charts=tuple(charts), paragraphs=(*page.paragraphs, caption))


def _over(panel: Panel, measured: Measurement) -> Panel:
    name = panel.y.history
    if panel.x.history != "t" or name not in measured.columns:
        return panel
    time, unit = (parse_unit(axis.unit.replace("²", "^2")) for axis in (panel.x, panel.y))
    there = np.isfinite(measured.columns[name])
    x, y = measured.times[there] / time.factor, measured.si(name)[there] / unit.factor
    return replace(panel, curves=(*panel.curves, Curve("measured", x, y, look="measured")))
