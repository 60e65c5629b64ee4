"""Measured data over time or by impacts, read from text, data frames or arrays with every fault."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError, among, refuse, shown, unknown
from hertzwerk.derive.common.identifiers import unit_faults
from hertzwerk.derive.common.units import Unit, UnitError, parse_unit
from hertzwerk.runtime.engine.inputs.delimited_text import Arrays, Numbers, layout_of, text_of, with_header
from hertzwerk.runtime.engine.model.binding import whole_faults
from hertzwerk.runtime.system.arrays import Array

TIMES = ("t", "time", "zeit", "x_value")  # names of a time column, in any case; the last one is LabVIEW's
NUMBERS = ("impact",)  # names of a column that counts impacts, in any case
KEY_UNITS = {TIMES: "s", NUMBERS: "1"}
HEADINGS = (  # name [unit], name (unit), name/unit
    re.compile(r"(?P<name>[^\[\]]*[^\[\]\s])\s*\[(?P<unit>[^\[\]]*)\]"),
    re.compile(r"(?P<name>[^()\[\]]*[^()\[\]\s])\s*\((?P<unit>[^\[\]]*)\)"),
    re.compile(r"(?P<name>[^/]*[^/\s])\s*/\s*(?P<unit>[^/()\[\]]+|\([^()]*\))"),
)
WORDS = {
    **{"second": "s", "sec": "s", "millisecond": "ms", "microsecond": "us"},
    **{"metre": "m", "meter": "m", "millimetre": "mm", "millimeter": "mm"},
    **{"volt": "V", "millivolt": "mV", "ampere": "A", "amp": "A", "newton": "N", "degree": "deg", "-": "1"},
}
"""Units that instruments write as words, in small letters, one of it."""
MeasuredTable: TypeAlias = Any  # file, data frame, or dictionary of arrays
Chosen = Sequence[str] | Mapping[str, str | int]  # names of columns, or names beside headings or numbers from 1 on
Column = tuple[int, str, str]  # place in a line, name and unit text of a column that is read


def _numbers(values: Any) -> Array:
    """Return values as an array of floats; of what are no numbers one of a shape that is a fault."""
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        return np.zeros((0, 0))


class Columns:
    """Columns with units; what a table of measured data is but for its rows."""

    columns: Mapping[str, Array]
    units: Mapping[str, str]
    source: str

    def si(self, name: str) -> Array:
        """Return a column in SI; raises KeyError for an unknown name."""
        return self.columns[name] * self.unit(name).factor

    def unit(self, name: str) -> Unit:
        """Return the unit of a column; raises KeyError for an unknown name."""
        return parse_unit(self.units[name])

    def _check(self, key: str, noun: str, sound: Callable[[Array], bool], expected: str) -> None:
        """Make arrays of the columns, and of the field that orders them; raises InputError with every fault."""
        along = _numbers(getattr(self, key))
        object.__setattr__(self, key, along)
        faults = self._column_faults(along.size, noun)
        if along.ndim != 1 or not np.all(np.isfinite(along)) or not sound(along):
            faults.append(Fault(key, shown(along), expected))
        refuse(str(self.source) or f"measured {noun}", faults)

    def _column_faults(self, rows: int, noun: str) -> list[Fault]:
        """Return the faults of the columns, which become arrays."""
        if not isinstance(self.columns, Mapping) or not isinstance(self.units, Mapping):
            actual = f"{shown(self.columns)} and {shown(self.units)}"
            return [Fault("columns, units", actual, "arrays and unit texts by the names of columns")]
        columns = {str(name): _numbers(values) for name, values in self.columns.items()}
        object.__setattr__(self, "columns", columns)
        faults = [
            Fault(name, f"values of shape {values.shape}", f"one for each of the {rows} {noun}")
            for name, values in columns.items()
            if values.shape != (rows,)
        ]
        for name in columns:
            faults += unit_faults(name, self.units.get(name))
        return faults


@dataclass(frozen=True)
class Measurement(Columns):
    """Measured columns over time; refuses to exist with faults (InputError).

    times     [s], shape (n,), increasing; n is at least 2
    columns   by name, shape (n,), in `units`; nan where a sample is missing
    units     unit text of every column
    source    path of the file; empty for data of another origin
    jumps     times that the file has twice, as a run does at an event; of them the later line is taken
    """

    times: Array
    columns: Mapping[str, Array]
    units: Mapping[str, str]
    source: str = ""
    jumps: int = 0

    def __post_init__(self) -> None:
        expected = "two or more finite times, increasing"
        self._check("times", "times", lambda times: times.size > 1 and bool(np.all(np.diff(times) > 0)), expected)


@dataclass(frozen=True)
class MeasuredImpacts(Columns):
    """Measured impacts: their times, speeds, peak forces; refuses to exist with faults (InputError).

    numbers   of the impacts in the order of their onsets, shape (n,), from 1 on, increasing; those between may be missing
    columns   by name, shape (n,), in `units`; nan where one was not measured
    """

    numbers: Array
    columns: Mapping[str, Array]
    units: Mapping[str, str]
    source: str = ""

    def __post_init__(self) -> None:
        def sound(numbers: Array) -> bool:
            return numbers.size > 0 and bool(np.all(np.diff(numbers, prepend=0) > 0)) and not np.any(numbers % 1)

        self._check("numbers", "impacts", sound, "whole numbers of impacts from 1 on, increasing")


@dataclass(frozen=True)
class Reading:
    """Table of measured data with what it does not state of itself, as `read_measurement` takes it."""

    data: MeasuredTable
    columns: Chosen | None = None
    units: Mapping[str, str] = field(default_factory=dict)
    skip: int = 0
    decimal: str | None = None
    missing: str | Iterable[str] = ()

    @property
    def source(self) -> str:
        """Path of the file; empty for data of another origin."""
        return str(self.data) if isinstance(self.data, str | Path) else ""

    @property
    def marks(self) -> list[str]:
        """Further cells without a sample."""
        return [str(mark) for mark in ([self.missing] if isinstance(self.missing, str | int | float) else self.missing)]

    def of(self, columns: Chosen | None) -> Reading:
        """Return the reading of columns, by their new names; that of the data, where these are a reading."""
        whole = self.data if isinstance(self.data, Reading) else self
        if columns is not None and isinstance(whole.columns, Mapping):
            keys = {new: old for new, old in whole.columns.items() if new.lower() in (*TIMES, *NUMBERS)}
            columns = {**keys, **{name: whole.columns.get(name, name) for name in columns}}
        return whole if columns is None else replace(whole, columns=columns)


def read_measurement(
    data: MeasuredTable,
    columns: Chosen | None = None,
    *,
    units: Mapping[str, str] | None = None,
    skip: int = 0,
    decimal: str | None = None,
    missing: str | Iterable[str] = (),
) -> Measurement:
    """Read measured data over time from a text file, a data frame or a dictionary of arrays.

    data       a file with headings `name [unit]`, `name (unit)` or `name/unit`, or units in the line below, and a time column (`t`, `time`); cells
               separated by commas, semicolons, tabs or spaces. Lines before the headings are left out, and lines that begin with #
    columns    names of those to read, by default all; or their names beside headings or numbers of columns from 1 on, {"t": 1, "force": "CH 2"}
    units      unit texts by column, {"force": "N"}, in place of those of the file
    skip       lines to leave out at the beginning, where headings are not found by themselves
    decimal    mark "." or ","; by default what the cells prove. The other one may separate thousands then
    missing    text or number of cells without a sample, beside empty ones, nan, N/A and the like, and marks of overflow

    Raises InputError with every fault and its line: units that are missing or unknown, cells that are no numbers or may be two
    (1,234), times that are missing or fall. Two lines of one time are a jump, as where a run writes an event: the later is
    taken; three are refused.
    """
    reading = Reading(data, None, {} if units is None else units, skip, decimal, missing).of(columns)
    times, series, read, jumps, source = _read(reading, TIMES)
    return Measurement(times, series, read, source, jumps)


def read_impacts(
    data: MeasuredTable,
    columns: Chosen | None = None,
    *,
    units: Mapping[str, str] | None = None,
    skip: int = 0,
    decimal: str | None = None,
    missing: str | Iterable[str] = (),
) -> MeasuredImpacts:
    """Read measured impacts from a table with a column `impact [1]` that counts them from 1.

    As `read_measurement` otherwise: `impact [1], t [ms], speed [m/s]`. Raises InputError with every fault and its line.
    """
    reading = Reading(data, None, {} if units is None else units, skip, decimal, missing).of(columns)
    numbers, series, read, _, source = _read(reading, NUMBERS)
    return MeasuredImpacts(numbers, series, read, source)


def counts_impacts(data: MeasuredTable) -> bool:
    """Return whether a table has a column that counts impacts; False for a file that cannot be read."""
    reading = Reading(data).of(None)
    names: Any = [] if reading.source else getattr(reading.data, "columns", reading.data)
    is_key = _key_test(reading.columns, NUMBERS)
    with suppress(InputError):
        layout = layout_of(text_of(Path(reading.source)), is_key, reading.skip) if reading.source else None
        names = names if layout is None else layout.headings
    return any(is_key(k, str(name)) for k, name in enumerate(names))


def _read(reading: Reading, keys: tuple[str, ...]) -> tuple[Array, dict[str, Array], dict[str, str], int, str]:
    """Return times in SI or numbers of impacts, columns and units by name, jumps, and the source."""
    faults = _option_faults(reading)
    refuse(reading.source or "measurement", faults)
    chosen, table = (_of_text if reading.source else _of_arrays)(reading, keys, faults)
    values = table.values
    if chosen and chosen[0][1].lower() in keys:
        values = values[~_repeated(table, keys)]
    faults += table.faults
    fewest = 2 if keys == TIMES else 1
    if not faults and len(values) < fewest:
        expected = "two or more" if fewest == 2 else "one or more"
        faults.append(Fault(reading.source or "data", f"{len(values)} lines of numbers", expected))
    if not faults:
        where = f"{Path(reading.source).name}, " if reading.source else ""
        empty = [name for (_, name, _), each in zip(chosen, values.T, strict=True) if not np.any(np.isfinite(each))]
        faults += [Fault(f"{where}{name}", "no sample", "a column of numbers") for name in empty]
    refuse(reading.source or "measurement", faults)
    (_, _, unit), *others = chosen
    along, *measured = values.T
    series = {name: each.copy() for (_, name, _), each in zip(others, measured, strict=True)}
    jumps = len(table.values) - len(values)
    return along * parse_unit(unit).factor, series, {name: text for _, name, text in others}, jumps, reading.source


def _of_text(reading: Reading, keys: tuple[str, ...], faults: list[Fault]) -> tuple[list[Column], Numbers]:
    path, columns = Path(reading.source), reading.columns
    text = text_of(path)
    olds = list(columns.values()) if isinstance(columns, Mapping) else []
    places = [old - 1 for old in olds if isinstance(old, int)]
    bare = bool(olds) and len(places) == len(olds)  # no headings are needed
    layout = layout_of(text, _key_test(columns, keys), reading.skip, places if bare else ())
    if layout is None:
        expected = "a line of headings, name [unit], and lines of numbers"
        raise InputError(reading.source, [Fault(reading.source, "no lines", expected)])
    layout = with_header(text, layout)
    where, headings = f"{path.name}, line {layout.line}", layout.headings[: layout.width]
    chosen = _chosen(where, headings, layout.below, columns, keys, reading.units, faults)
    at, names = [column[0] for column in chosen], [column[1] for column in chosen]
    return chosen, Numbers(path.name, text, layout, at, names, reading.decimal or "", reading.marks)


def _of_arrays(reading: Reading, keys: tuple[str, ...], faults: list[Fault]) -> tuple[list[Column], Arrays]:
    data = reading.data
    if not (isinstance(data, Mapping) or hasattr(data, "columns")):
        raise InputError("measurement", [Fault("data", shown(data), "a file, a data frame, or a dictionary of arrays")])
    data = data.reset_index() if getattr(getattr(data, "index", None), "name", None) else data
    names: Any = getattr(data, "columns", data)
    listed = list(names)
    units = {**getattr(data, "attrs", {}).get("units", {}), **reading.units}
    chosen = _chosen("columns", list(map(str, listed)), [], reading.columns, keys, units, faults)
    columns = [data[listed[column[0]]] for column in chosen]
    return chosen, Arrays(columns, [column[1] for column in chosen], reading.marks)


def _option_faults(reading: Reading) -> list[Fault]:
    columns, units, marks = reading.columns, reading.units, reading.missing
    marks = [marks] if isinstance(marks, str | int | float) else marks
    named = isinstance(columns, list | tuple | Mapping) and all(isinstance(name, str) for name in columns)
    sound = {
        "decimal": (among(reading.decimal, None, ".", ","), '"." or ","'),
        "columns": (columns is None or named, 'names, ["force"], or names beside headings, {"force": "CH 2"}'),
        "units": (isinstance(units, Mapping) and _all(str, units.values()), 'unit texts by column, {"force": "N"}'),
        "missing": (_all(str | int | float, marks), "texts or numbers of cells without a sample"),
        "skip": (not whole_faults(skip=reading.skip), "a number of lines"),
    }
    return [Fault(name, shown(getattr(reading, name)), to) for name, (good, to) in sound.items() if not good]


def _all(kind: Any, values: object) -> bool:
    """Return whether values are a collection, each of a kind."""
    return isinstance(values, Collection) and all(isinstance(value, kind) for value in values)


def _key_test(columns: Chosen | None, keys: tuple[str, ...]) -> Callable[[int, str], bool]:
    """Return whether the heading at a place is that of the column that orders the rows."""
    mapped = columns if isinstance(columns, Mapping) else {}
    wanted = {old for new, old in mapped.items() if new.lower() in keys}
    if not wanted:
        return lambda _, cell: _heading(cell)[0].lower() in keys
    return lambda place, cell: bool(wanted & {place + 1, cell, _heading(cell)[0]})


def _heading(cell: str) -> tuple[str, str]:
    """Return the name and the unit that a heading has; "" where it has none.

    What stands in brackets is a unit; in parentheses, or behind a stroke, only where it reads as one: `force (left)` is
    a name, `force (1)` may be the first one.
    """
    for pattern in HEADINGS:
        if match := pattern.fullmatch(cell):
            unit = _unit(match["unit"])
            one = pattern is HEADINGS[1] and match["unit"].strip() == "1"
            if pattern is HEADINGS[0] or (not one and not any(unit_faults("", unit))):
                return match["name"].strip(), unit
    return cell, ""


def _unit(text: str) -> str:
    """Return unit text without brackets, words as symbols."""
    bare = text.strip()
    bare = bare[1:-1].strip() if bare[:1] + bare[-1:] in ("()", "[]") else bare
    return WORDS.get(bare.lower().removesuffix("s"), bare)


def _chosen(
    where: str,
    headings: Sequence[str],
    below: Sequence[str],
    columns: Chosen | None,
    keys: tuple[str, ...],
    units: Mapping[str, str],
    faults: list[Fault],
) -> list[Column]:
    """Return the columns to be read, the key first; faults of their headings are appended."""
    names = [_heading(heading)[0] for heading in headings]
    free = [name for name in names if name.lower() not in keys]
    wanted: dict[str, str | int] = dict(columns) if isinstance(columns, Mapping) else {c: c for c in columns or ()}
    wanted = wanted if columns is not None else dict(zip(free, free, strict=True))
    times = [(new, old) for new, old in wanted.items() if new.lower() in keys]
    times = times or [(name, name) for name in names if name.lower() in keys]
    if len(times) != 1:
        actual = f"{', '.join(str(old) for _, old in times) or 'none'} among {shown(', '.join(names))}"
        expected = "one time column, such as t [s] or time [ms]" if keys == TIMES else "one column impact [1]"
        faults.append(Fault(where, actual, expected, f'columns={{"{keys[0]}": NAME}} says which' if names else ""))
    pairs = dict([*times[:1], *wanted.items()])
    faults += [unknown("column", name, names) for name in units if name not in {*pairs, *names, *headings}]
    chosen: list[Column] = []
    for new, old in pairs.items():
        places = [k for k, heading in enumerate(headings) if old in (k + 1, names[k], heading)]
        if not places:
            numbered = Fault(f"{where}, {new}", f"no column {old}", f"a number from 1 to {len(headings)}")
            faults.append(numbered if isinstance(old, int) else unknown("column", old, free))
            continue
        place, heading = places[0], headings[places[0]]
        if len(places) > 1:
            remedy = f"columns={{{new!r}: {place + 1}}} takes the first"
            faults.append(Fault(f"{where}, {new}", f"{len(places)} columns of this name", "one", remedy))
        stated = next((units[name] for name in (new, names[place], heading) if name in units), "")
        texts = [stated] if stated else [_heading(heading)[1], below[place] if place < len(below) else ""]
        unit = _stated_unit(f"{where}, {new}", heading, new, [_unit(text) for text in texts], faults)
        if unit and new.lower() in keys and parse_unit(unit).exponents != parse_unit(KEY_UNITS[keys]).exponents:
            expected = "a unit of time" if keys == TIMES else "[1]"
            faults.append(Fault(f"{where}, {new}", f"[{unit}]", expected))
        chosen += [(place, new, unit)] if unit else []
    return chosen


def _stated_unit(where: str, heading: str, name: str, texts: Sequence[str], faults: list[Fault]) -> str:
    """Return the unit that a heading and the line below it agree on; "" with a fault where there is none."""
    stated = list(dict.fromkeys(filter(None, texts)))
    remedy = f'units={{{name!r}: "..."}}'
    if len(stated) > 1:
        faults.append(Fault(where, f"the units [{stated[0]}] and, below, [{stated[1]}]", "one", remedy))
        return ""
    try:
        parse_unit(stated[0] if stated else "")
    except UnitError as error:
        reason = str(error) if stated else "[1] for a plain number"
        faults.append(Fault(where, shown(heading), "name [unit]", f"{reason}, or {remedy}"))
        return ""
    return stated[0]


def _repeated(table: Numbers | Arrays, keys: tuple[str, ...]) -> NDArray[np.bool_]:
    """Return which rows have the time of the next one; times that are missing or fall are faults."""
    along, noun = table.values[:, 0], "time" if keys == TIMES else "number"
    for row in np.flatnonzero(np.isnan(along)):
        table.add(int(row), f"no {noun}", f"a {noun} in every line")
    rows = np.flatnonzero(np.isfinite(along))
    known = along[rows]
    before, equal = np.maximum.accumulate(known)[:-1], np.diff(known) == 0
    wrong = known[1:] <= before if keys != TIMES else (known[1:] < before) | (equal & np.append(False, equal[:-1]))
    for k in np.flatnonzero(wrong):
        again = "a third time" if keys == TIMES else "again"
        place = again if known[k + 1] == before[k] else f"after {before[k]:.12g}"
        limit = ", at most two lines of one" if keys == TIMES else ""
        table.add(int(rows[k + 1]), f"the {noun} {known[k + 1]:.12g}, {place}", f"{noun}s that increase{limit}")
    for k in np.flatnonzero((known < 1) | (known % 1 != 0)) if keys != TIMES else ():
        table.add(int(rows[k]), f"the number {known[k]:.12g}", "a whole number of an impact, from 1 on")
    repeated = np.zeros(len(along), dtype=bool)
    repeated[rows[:-1][equal]] = True
    return repeated
