"""Measured data over time or by impacts, read from CSV with every fault and its line."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError, shown, unknown, unreadable
from hertzwerk.derive.common.units import Unit, UnitError, parse_unit

Array = NDArray[np.float64]

TIMES = ("t", "time")  # names of a time column, in any case
NUMBERS = ("impact",)  # names of a column that counts impacts, in any case
MISSING = ("", "nan")  # cells without a sample, in any case
LISTED = 20  # most faulty lines that are listed
HEADING = re.compile(r"(?P<name>[^\[\]]*[^\[\]\s])\s*\[(?P<unit>[^\[\]]*)\]")
DELIMITERS = (",", ";", "\t")


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

    def _column_faults(self, rows: int, what: str) -> list[Fault]:
        """Return the faults of the columns, which become arrays."""
        columns = {name: np.asarray(values, dtype=float) for name, values in self.columns.items()}
        object.__setattr__(self, "columns", columns)
        faults = [
            Fault(name, f"values of shape {values.shape}", f"one for each of the {rows} {what}")
            for name, values in columns.items()
            if values.shape != (rows,)
        ]
        for name in columns:
            try:
                parse_unit(self.units.get(name, ""))
            except UnitError as error:
                faults.append(Fault(name, shown(self.units.get(name)), "a unit", str(error)))
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
        object.__setattr__(self, "times", np.asarray(self.times, dtype=float))
        faults = self._column_faults(self.times.size, "times")
        times = self.times
        if times.ndim != 1 or times.size < 2 or not np.all(np.isfinite(times)) or np.any(np.diff(times) <= 0):
            faults.append(Fault("times", shown(self.times), "two or more finite times, increasing"))
        if faults:
            raise InputError(self.source or "measurement", faults)


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
        object.__setattr__(self, "numbers", np.asarray(self.numbers, dtype=float))
        faults = self._column_faults(self.numbers.size, "impacts")
        counted = self.numbers.ndim == 1 and self.numbers.size > 0 and bool(np.all(np.isfinite(self.numbers)))
        if not counted or np.any(np.diff(self.numbers, prepend=0) <= 0) or np.any(self.numbers % 1):
            faults.append(Fault("numbers", shown(self.numbers), "whole numbers of impacts from 1 on, increasing"))
        if faults:
            raise InputError(self.source or "measured impacts", faults)


def read_measurement(path: str | Path, columns: Sequence[str] | None = None) -> Measurement:
    """Read measured data from CSV, headed `name [unit]`, with a time column `t [s]` or `time [ms]`.

    Separated by commas, semicolons or tabs, with decimal points; lines that begin with # are left out, and a cell that
    is empty or nan is a missing sample. `columns` names those that are read, by default all. Raises InputError with
    every fault and its line: units that cannot be read, cells that are no numbers, times that are missing or fall. Two
    lines of one time are a jump, as where a run writes an event: the later one is taken; three are refused.
    """
    times, found, units, jumps = _read(Path(path), columns, TIMES)
    return Measurement(times, found, units, str(path), jumps)


def read_impacts(path: str | Path, columns: Sequence[str] | None = None) -> MeasuredImpacts:
    """Read measured impacts from CSV with a column `impact [1]` that counts them from 1.

    As `read_measurement` otherwise: `impact [1], t [ms], speed [m/s]`. Raises InputError with every fault and its line.
    """
    numbers, found, units, _ = _read(Path(path), columns, NUMBERS)
    return MeasuredImpacts(numbers, found, units, str(path))


def counts_impacts(path: str | Path) -> bool:
    """Return whether a CSV file has a column that counts impacts; False for one that cannot be read."""
    try:
        lines = _lines(Path(path))
    except InputError:
        return False
    return any(name.lower() in NUMBERS for name in _names(_cells_of(lines[0][1], _delimiter(lines[0][1]))))


def _lines(path: Path) -> list[tuple[int, str]]:
    """Return the numbered lines of a file but for comments; raises InputError where there are none."""
    try:
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, ValueError) as error:
        no_text = isinstance(error, UnicodeDecodeError)
        found: Exception = ValueError("bytes that are no UTF-8 text") if no_text else error
        raise InputError("measurement", [unreadable(path, found, "a CSV file")]) from error
    lines = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip() and line.lstrip()[0] != "#"]
    if not lines:
        expected = "a line of headings, name [unit], and lines of numbers"
        raise InputError(str(path), [Fault(str(path), "no lines", expected)])
    return lines


def _read(
    path: Path, columns: Sequence[str] | None, keys: tuple[str, ...]
) -> tuple[Array, dict[str, Array], dict[str, str], int]:
    """Return the rows' key in SI, times or numbers of impacts, columns and units by name, and the jumps."""
    lines = _lines(path)
    faults: list[Fault] = []
    (first, heading), *rows = lines
    delimiter = _delimiter(heading)
    headings = _cells_of(heading, delimiter)
    chosen = _chosen(f"{path.name}, line {first}", headings, columns, keys, faults)
    cells = _Cells(path.name, headings, chosen, keys)
    values = cells.read([(number, _cells_of(line, delimiter)) for number, line in rows])
    faults += cells.faults
    fewest = 2 if keys == TIMES else 1
    if not faults and len(values) < fewest:
        faults.append(
            Fault(str(path), f"{len(values)} lines of numbers", "two or more" if fewest == 2 else "one or more")
        )
    if faults:
        raise InputError(str(path), faults)
    (_, _, unit), *others = chosen
    along, *measured = values.T
    empty = [name for (_, name, _), each in zip(others, measured, strict=True) if not np.any(np.isfinite(each))]
    if empty:
        raise InputError(
            str(path), [Fault(f"{path.name}, {name}", "no sample", "a column of numbers") for name in empty]
        )
    found = {name: each for (_, name, _), each in zip(others, measured, strict=True)}
    return along * parse_unit(unit).factor, found, {name: text for _, name, text in others}, cells.jumps


def _names(headings: Sequence[str]) -> list[str]:
    found = [HEADING.fullmatch(heading) for heading in headings]
    return [match["name"].strip() if match else heading for match, heading in zip(found, headings, strict=True)]


def _delimiter(heading: str) -> str:
    return max(DELIMITERS, key=heading.count)


Chosen = tuple[int, str, str]  # place in a line, name and unit text of a column that is read


def _chosen(
    where: str, headings: Sequence[str], columns: Sequence[str] | None, keys: tuple[str, ...], faults: list[Fault]
) -> list[Chosen]:
    """Return the columns to be read, the key first; faults of their headings are appended."""
    found, names = [HEADING.fullmatch(heading) for heading in headings], _names(headings)
    times = [name for name in names if name.lower() in keys]
    key_unit = "s" if keys == TIMES else "1"
    if len(times) != 1:
        expected = "one time column, such as t [s] or time [ms]" if keys == TIMES else "one column impact [1]"
        faults.append(Fault(where, f"{', '.join(times) or 'none'} among {shown(', '.join(names))}", expected))
    wanted = [name for name in names if name not in times] if columns is None else list(dict.fromkeys(columns))
    chosen: list[Chosen] = []
    for name in [*times[:1], *wanted]:
        if name not in names:
            faults.append(unknown("column", name, [each for each in names if each not in times]))
            continue
        if names.count(name) > 1:
            faults.append(Fault(f"{where}, {name}", f"{names.count(name)} columns of this name", "one"))
        place = names.index(name)
        match = found[place]
        unit = match["unit"].strip() if match else ""
        try:
            exponents = parse_unit(unit).exponents
        except UnitError as error:
            is_given = bool(match and unit)
            remedy = str(error) if is_given else "[1] for a plain number"
            faults.append(Fault(f"{where}, {name}", shown(headings[place]), "name [unit]", remedy))
            continue
        if name in times and exponents != parse_unit(key_unit).exponents:
            faults.append(Fault(f"{where}, {name}", f"[{unit}]", "a unit of time" if keys == TIMES else "[1]"))
        chosen.append((place, name, unit))
    return chosen


class _Cells:
    """Reader of the numbers of chosen columns; the first is time. `faults` has those of the first lines.

    jumps    lines that were left out, as the next has their time
    """

    def __init__(self, file: str, headings: Sequence[str], chosen: Sequence[Chosen], keys: tuple[str, ...]) -> None:
        self._file, self._count, self._chosen, self._keys = file, len(headings), chosen, keys
        self._what = "time" if keys == TIMES else "number"
        self._found: list[Fault] = []
        self._more = 0
        self.jumps = 0

    @property
    def faults(self) -> list[Fault]:
        """Faults of the first lines, and the number of others."""
        more = [Fault(self._file, f"{self._more} faults more", "none")] if self._more else []
        return [*self._found, *more]

    def read(self, rows: Sequence[tuple[int, list[str]]]) -> Array:
        """Return the numbers, shape (rows, columns), of numbered lines."""
        values = np.full((len(rows), len(self._chosen)), np.nan)
        before: tuple[float, str] | None = None
        repeated: list[int] = []  # lines whose time the next one has
        for i, (number, row) in enumerate(rows):
            where = f"{self._file}, line {number}"
            if len(row) != self._count:
                self._add(Fault(where, f"{len(row)} cells", f"{self._count}, as there are headings", _comma(row)))
                continue
            for k, (place, name, _) in enumerate(self._chosen):
                cell = row[place]
                if cell.lower() not in MISSING:
                    values[i, k] = self._number(f"{where}, {name}", cell)
            if not self._chosen or self._chosen[0][1].lower() not in self._keys:
                continue
            time, cell = float(values[i, 0]), row[self._chosen[0][0]]
            if cell.lower() in MISSING:
                self._add(Fault(where, f"no {self._what}", f"a {self._what} in every line"))
            elif self._keys != TIMES and not (time >= 1 and time % 1 == 0):
                self._add(Fault(where, f"the number {cell}", "a whole number of an impact, from 1 on"))
            elif (
                self._keys == TIMES
                and before is not None
                and time == before[0]
                and i - 1 not in (r + 1 for r in repeated[-1:])
            ):
                repeated.append(i - 1)
            elif before is not None and time <= before[0]:
                again = "a third time" if self._keys == TIMES else "again"
                found = f"the {self._what} {cell}, {again if time == before[0] else f'after {before[1]}'}"
                limit = ", at most two lines of one" if self._keys == TIMES else ""
                self._add(Fault(where, found, f"{self._what}s that increase{limit}"))
            elif np.isfinite(time):
                before = time, cell
        self.jumps = len(repeated)
        return np.delete(values, repeated, axis=0)

    def _number(self, where: str, cell: str) -> float:
        try:
            value = float(cell)
        except ValueError:
            value = np.inf
        if np.isfinite(value):
            return value
        self._add(Fault(where, shown(cell), "a finite number, or nothing where a sample is missing", _comma([cell])))
        return np.nan

    def _add(self, fault: Fault) -> None:
        if len(self._found) < LISTED:
            self._found.append(fault)
        else:
            self._more += 1


def _cells_of(line: str, delimiter: str) -> list[str]:
    return [cell.strip().strip('"').strip() for cell in line.split(delimiter)]


def _comma(cells: Sequence[str]) -> str:
    """Return a remedy for cells with decimal commas; empty where there are none."""
    return "write decimal points in place of commas" if any(re.fullmatch(r"[-+\d]+,\d+", c) for c in cells) else ""
