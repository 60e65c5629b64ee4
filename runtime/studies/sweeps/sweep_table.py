"""Results of many runs: a row each, and their table by column."""

from __future__ import annotations

import csv
import io
import math
import re
from array import array
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from operator import itemgetter
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, as_path, refuse, unknown
from hertzwerk.derive.common.markup import heading, joined, table, tag
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.engine.inputs.inputs_by_row import Labels
from hertzwerk.runtime.engine.model.binding import Value, whole_faults
from hertzwerk.runtime.engine.model.ranges import ValueWithUnit
from hertzwerk.runtime.engine.model.si_values import ratio
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.engine.solution.solution import write
from hertzwerk.runtime.output.tables.column_meanings import meaning_of
from hertzwerk.runtime.output.tables.data_frame import data_frame
from hertzwerk.runtime.output.tables.dataset import dataset
from hertzwerk.runtime.output.tables.labelled_table import Column, LabelledTable, Points
from hertzwerk.runtime.output.tables.table_file import write_table
from hertzwerk.runtime.studies.sweeps.points.design_points import Design
from hertzwerk.runtime.studies.sweeps.rows.row import TEXTS, Arrays, Row
from hertzwerk.runtime.studies.sweeps.slope import Slope, slope_of
from hertzwerk.runtime.system.lazy import cached_property
from hertzwerk.runtime.system.versions import versions

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame
    from xarray import Dataset

COMPLETE = Outcome("finished", "every row is there", "")
SHOWN = 10  # rows in a notebook
IN_MEMORY = 100_000  # rows of a table in memory, at most
TOGETHER, PART = 1000, 20_000  # lines of a file, rows of a table, that are made before they are written


@dataclass(frozen=True)
class Sweep:
    """Result of `sweep`: rows in the order of the design; `sweep["peak_force"]` is a column, in SI.

    scene    name of the scene
    columns    unit text by name of column, "" where there is none
    varied    columns of the values that were given
    rows    in memory, or where there are many, in the folder that they are stored in: a pass over them reads them there
    design    points that the rows are of, None of those that were given one by one
    arrays    unit text of arrays by what they are of, "section" or "histories", and name
    place    phrase: where arrays were kept
    outcome    "finished", or the reason why rows are missing, with a remedy
    damage    sentence: what was damaged where rows were stored, and was computed again; else empty
    """

    scene: str
    rows: Sequence[Row]
    columns: Mapping[str, str]
    varied: tuple[str, ...]
    outcome: Outcome
    design: Design | None = None
    arrays: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    place: str = ""
    damage: str = ""
    workers: int = 0  # of a table that was loaded
    compiled: bool = False
    wall_s: float = math.nan

    @classmethod
    def load(cls, folder: str | Path) -> Sweep:
        """Read the stored rows of a sweep from its folder, also during the sweep; raises InputError."""
        from hertzwerk.runtime.studies.sweeps.stored_rows import loaded

        return loaded(as_path("folder", folder))

    def __repr__(self) -> str:
        return f"<Sweep {self.scene}: {self._summary()}>"

    def _repr_html_(self) -> str:
        columns, entries = self.in_stated_units(SHOWN)
        header = [f"{name} [{unit}]" if unit else name for name, unit in columns.items()]
        rows = [[_cell(entry) for entry in row] for row in entries]
        more = tag("p", f"and {len(self) - SHOWN:,} more rows") if len(self) > SHOWN else None
        name = self.outcome.name
        head = heading(self.scene, name, f": {self._summary()}", good=name == "finished")
        return joined([head, table(header, rows), more])

    def _summary(self) -> str:
        """Return the number of rows, and how they ended."""
        ends = ", ".join(f"{count:,} {outcome}" for outcome, count in self.counts().items())
        return f"{len(self):,} row{'s' if len(self) != 1 else ''}{f' ({ends})' if ends else ''}"

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Row]:
        return iter(self.rows)

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C ended the sweep; its rows are those finished before."""
        return self.outcome.name == "interrupted"

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all columns: varied values, outcome, results, texts."""
        return tuple(self.columns)

    def __getitem__(self, name: str) -> np.ndarray:
        return self.read(name)[name]

    def read(self, *names: str, **others: Callable[[Row], float | str]) -> dict[str, np.ndarray]:
        """Return columns by name in one pass over the rows: texts where any row has one, else float64, in SI.

        others    what else there is to read of each row, by name
        """
        for name in names:
            if name not in self.columns:
                raise KeyError(f"no column {name!r}; there are {', '.join(self.names)}")
        of: dict[str, Callable[[Row], float | str]] = {**{name: itemgetter(name) for name in names}, **others}
        numbers = {name: array("d") for name in of}
        texts: dict[str, list[float | str]] = {name: [] for name in TEXTS if name in names}
        for row in self.rows:
            for name, get in of.items():
                entry = get(row)
                if name in texts:
                    texts[name].append(entry)
                elif isinstance(entry, str):  # of an input whose rows choose by label
                    texts[name] = [*numbers[name], entry]
                else:
                    numbers[name].append(entry)
        return {name: np.array(texts.get(name, numbers[name])) for name in of}

    @cached_property
    def summary(self) -> Summary:
        """Counts, ranges and warnings of all rows, in one pass over them."""
        return Summary(self.rows, [name for name in self.names if name not in TEXTS])

    @property
    def gridded(self) -> bool:
        """Whether the rows are all combinations of the varied values."""
        return self.design is not None and bool(self.design.grid)

    @cached_property
    def axes(self) -> dict[str, Sequence[float | str]]:
        """Values in SI, or labels, of what was varied, where the rows are all combinations; else empty."""
        grid = {} if self.design is None else self.design.grid
        return {
            name: tuple(axis) if isinstance(axis, Labels) else tuple(_si(value, self.unit(name)) for value in axis)
            for name, axis in grid.items()
        }

    def in_stated_units(self, most: int | None = None) -> tuple[dict[str, str], list[list[float | str]]]:
        """Return units by column, and the first rows, in the stated units.

        What was varied is in the unit that it was given in, where that is one in all rows. Raises InputError.
        """
        refuse("in_stated_units", [] if most is None else whole_faults(most=most))
        units = self.stated_units
        rows = [
            [_stated_value(row.stated.get(name))[0] if name in units else row[name] for name in self.names]
            for row in islice(self.rows, most)
        ]
        return {**self.columns, **units}, rows

    @property
    def stated_units(self) -> dict[str, str]:
        """Stated unit of each varied parameter, where all rows share one other than 1."""
        if self.design is not None:
            return {name: unit for name, unit in self.design.units.items() if unit != "1"}
        units = {name: {_stated_value(row.stated.get(name))[1] for row in self.rows} for name in self.varied}
        return {name: unit for name, (unit, *others) in units.items() if unit and not others}

    @property
    def section(self) -> Arrays:
        """Points of the section of every row; raises LookupError where none was requested."""
        return self.arrays_of("section", 'sweep(..., section="main_bearing.angle = 0")')

    @property
    def histories(self) -> Arrays:
        """Histories of every row on the grid; raises LookupError where none was requested."""
        return self.arrays_of("histories", 'sweep(..., grid="0.1 ms")')

    def arrays_of(self, name: str, remedy: str = "a section or a grid") -> Arrays:
        """Return "section" or "histories"; raises LookupError where it was not requested."""
        if name not in self.arrays:
            raise LookupError(f"no {name} in this sweep: {remedy} keeps them")
        varied = {each: self.unit(each) for each in self.varied}
        return Arrays(name, self.scene, self.arrays[name], varied, self.rows)

    def plot(self, *names: str) -> Figure:
        """Draw the section as a bifurcation diagram, else outputs: curves over one parameter, maps over two.

        names    those to draw, by default all; with the names of outputs a sweep with a section draws these. Raises
        InputError for unknown ones, and where there is nothing to draw.
        """
        from hertzwerk.runtime.studies.sweeps.plot_sweep import figure

        return figure(self, names)

    def unit(self, name: str) -> str:
        """Return the SI unit text of a column; "" if it has none."""
        return self.columns[name]

    def slope(self, output: str, name: str, at: float | None = None) -> Slope:
        """Return the derivative of an output by a varied parameter, by regression over the finished rows.

        For what has none along one run, as averages in chaos. at: where [SI], by default in the middle of the rows. Other
        numbers that are varied count linearly. Raises InputError for names that are no such columns, and too few rows.
        """
        columns = self.read("outcome", *(column for column in self.names if column not in ("message", "warnings")))
        numbers = [column for column in self.varied if columns[column].dtype.kind == "f"]
        outputs = [column for column in self.names if column not in (*self.varied, *TEXTS)]
        faults = [] if name in numbers else [unknown("varied number", name, numbers)]
        faults += [] if output in outputs else [unknown("output", output, outputs)]
        refuse(f"slope over the sweep of {self.scene}", faults)
        wanted = [columns[each] for each in (name, output, *numbers)]
        known = (columns["outcome"] == "finished") & np.isfinite(wanted).all(axis=0)
        x, y, *others = (column[known] for column in wanted)
        others = [other for each, other in zip(numbers, others, strict=True) if each != name]
        try:
            unit = ratio(self.unit(output), self.unit(name))
            return slope_of(f"d({output})/d({name})", unit, x, y, others, at)
        except ValueError as error:
            where = f"slope over the sweep of {self.scene}"
            actual, expected = str(error).split(", ")
            raise InputError(where, [Fault(output, f"{actual} of {name} that finished", expected)]) from None

    def counts(self) -> dict[str, int]:
        """Return the number of rows by outcome, the most frequent first."""
        return dict(self.summary.counts.most_common())

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write a line per row, headed `name [unit]`, SI; raises FileExistsError."""
        return write(path, self._csv(), overwrite=overwrite)

    def to_pandas(self) -> DataFrame:
        """Return a pandas data frame, a line per row; units are in `attrs`.

        Raises InputError without the extra [data], and beyond 100,000 rows.
        """
        return data_frame(self._labelled())

    def to_xarray(self) -> Dataset:
        """Return an xarray dataset over the varied parameters, with units and outcome.

        Its dimensions are the varied names where the rows are all combinations, else `row`, with them as coordinates.
        Points of a section are `section.guide.travel` over `section.point`, those of shorter rows followed by nan.
        Raises InputError without the extra [data], and beyond 100,000 rows.
        """
        return dataset(self._labelled())

    def to_file(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write the table as .csv, .parquet or .nc, by the ending; raises InputError.

        Sections and histories are in the last two; `section.to_csv` writes them to a file of their own. A netCDF file has
        at most 100,000 rows.
        """
        return write_table(path, self._labelled, self._csv, self._parts, overwrite=overwrite)

    def _parts(self) -> Iterator[LabelledTable]:
        rows = iter(self.rows)
        part = tuple(islice(rows, PART))
        while part or not len(self):
            yield replace(self, rows=part, design=None)._labelled()  # without the values of all axes
            if not (part := tuple(islice(rows, PART))):
                return

    def _labelled(self) -> LabelledTable:
        refuse(f"table of {self.scene}", memory_faults(len(self)))
        index = Column(np.array([row.index for row in self.rows], dtype=int), "", "place in the design")
        columns = {
            name: Column(
                values,
                self.unit(name) if values.dtype.kind == "f" else None,
                meaning_of(name, varied=name in self.varied),
            )
            for name, values in self.read(*self.names).items()
        }
        first = self.rows[0].stated if self.rows else {}
        same = {
            f"parameter.{name}": " ".join(map(str, value)) if isinstance(value, tuple) else str(value)
            for name, value in first.items()
            if name not in self.varied
        }
        about = {"scene": self.scene, "outcome": self.outcome.name, "hertzwerk": versions()["hertzwerk"]}
        grid = {name: np.array(values) for name, values in self.axes.items()}
        points = {
            name: Points(units, [np.column_stack([*each.values()]) for each in self.arrays_of(name)])
            for name, units in self.arrays.items()
        }
        return LabelledTable("row", {"row": index, **columns}, {**about, **same}, self.varied, grid, points)

    def _csv(self) -> Iterator[bytes]:
        """Yield the lines, some at a time."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["row", *(f"{name} [{unit}]" if unit else name for name, unit in self.columns.items())])
        for i, row in enumerate(self.rows, 1):
            entries = (row[name] for name in self.names)
            table.writerow([row.index, *(e if isinstance(e, str) else format(e, ".17g") for e in entries)])
            if i % TOGETHER == 0:
                yield text.getvalue().encode()
                text.seek(0)
                text.truncate()
        yield text.getvalue().encode()

    def __str__(self) -> str:
        text = f"{len(self)} runs, {self.counts().get('finished', 0)} finished"
        if self.workers:
            text += f", in {self.wall_s:.3g} s on {self.workers} cores"
        return text if self.outcome.finished else f"{text}; {self.outcome.name}"


def memory_faults(count: int) -> list[Fault]:
    """Return the fault of a table of too many rows to be in memory."""
    if count <= IN_MEMORY:
        return []
    way_out = "out=FOLDER, or --out, stores each row as it is done; .csv and .parquet are written as rows are read"
    return [Fault("rows", f"{count:,} in memory", f"at most {IN_MEMORY:,}", way_out)]


def columns_of(varied: Mapping[str, str], results: Mapping[str, str]) -> dict[str, str]:
    """Return the columns of a table with their units: varied values, outcome, results, texts."""
    return {**varied, "outcome": "", **results, "message": "", "warnings": ""}


def _stated_value(value: Value | None) -> tuple[float, str]:
    """Return a number and the unit that it was given with, empty where there is none."""
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[0], int | float) and value[1] != "1":
        return value[0], value[1]
    return math.nan, ""


def _si(value: ValueWithUnit, declared: str) -> float:
    """Return a value in SI, nan where its unit is none of what is declared."""
    number, text = value
    unit, wanted = parse_unit(text), parse_unit(declared or "1")
    return unit.to_si(number) if unit.exponents == wanted.exponents or wanted.free_names else math.nan


def _cell(value: float | str) -> str:
    return value if isinstance(value, str) else f"{value:.6g}"


# -- summary of rows -----------------------------------------------------------------------------------------------------

SPREAD = 10_000  # rows whose numbers are kept for the median, at least, where there are so many


@dataclass
class Spread:
    """Least and largest of numbers, how many there are, and for the median some of them, spread evenly."""

    least: float = math.inf
    largest: float = -math.inf
    count: int = 0

    def __post_init__(self) -> None:
        self._some: list[float] = []
        self._step = 1

    def add(self, value: float) -> None:
        """Take one more; nan and infinities are none."""
        if not math.isfinite(value):
            return
        self.least, self.largest = min(self.least, value), max(self.largest, value)
        if self.count % self._step == 0:
            self._some.append(value)
            if len(self._some) > 2 * SPREAD:
                del self._some[1::2]
                self._step *= 2
        self.count += 1

    @property
    def median(self) -> float:
        """Median of the numbers, of many that of some; nan of none."""
        return median(self._some) if self._some else math.nan


@dataclass
class SharedWarning:
    """Warning that rows share but for its numbers: `text` that of the worst row, `where` which that is."""

    text: str
    size: float
    worst: int
    last: int
    rows: int = 1
    alike: bool = True

    def __str__(self) -> str:
        where = f", such as row {self.worst}" if math.isnan(self.size) else f", worst in row {self.worst}"
        return f"{self.rows:,} row{'s' * (self.rows > 1)}{'' if self.alike else where}: {self.text}"


_NUMBER = r"(?<![\w.])[-+]?\d+\.?\d*(?:e[-+]?\d+)?"


def form_of(warning: str) -> str:
    """Return what a warning shares with those of other rows: all but its numbers."""
    return re.sub(_NUMBER, "#", warning)


class Summary:
    """Counts, ranges and warnings of rows.

    counts, messages    number of rows by outcome, and the first row's reason
    spreads    least, median and largest of the columns of numbers
    warnings    each once, by its form; `warned` is the number of rows that have any
    ran    whether any row has outputs
    """

    def __init__(self, rows: Iterable[Row], names: Sequence[str]) -> None:
        self.counts: Counter[str] = Counter()
        self.messages: dict[str, str] = {}
        self.spreads = {name: Spread() for name in names}
        self.warnings: dict[str, SharedWarning] = {}
        self.warned, self.ran = 0, False
        for row in rows:
            self.counts[row.outcome] += 1
            self.messages.setdefault(row.outcome, row.message)
            for name, spread in self.spreads.items():
                entry = row[name]
                if not isinstance(entry, str):
                    spread.add(entry)
            self.ran = self.ran or bool(row.outputs)
            self.warned += bool(row.warnings)
            for text in row.warnings:
                self._warn(row.index, text)

    def _warn(self, index: int, text: str) -> None:
        worst = re.search(f"worst ({_NUMBER})", text)
        size = math.nan if worst is None else float(worst[1])
        form = form_of(text)
        shared = self.warnings.get(form)
        if shared is None:
            self.warnings[form] = SharedWarning(text, size, index, index)
            return
        shared.alike = shared.alike and text == shared.text
        shared.rows += index != shared.last
        shared.last = index
        if size > shared.size:
            shared.text, shared.size, shared.worst = text, size, index
