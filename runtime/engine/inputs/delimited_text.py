"""Tables of numbers in text, as instruments and spreadsheets write them.

Nothing is guessed. A cell that reads as two different numbers, such as 1,234, is refused unless other cells prove the
decimal mark or the caller states it. NumPy's reader takes plain numbers; what it refuses is read cell by cell.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import zip_longest
from pathlib import Path
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError, shown, unreadable
from hertzwerk.runtime.system.arrays import Array

HEAD = 500  # lines among which the headings stand
LISTED = 20  # most faults of numbers that are listed
DELIMITERS = ("\t", ";", ",", " ")  # in the order in which they are tried
MARKS = "nan -nan n/a na #n/a #nv null none - -- --- ∞ +∞ -∞ ol o.l o.l. ovl over overflow overload overrange nan(ind) -nan(ind) 1.#qnan -1.#ind"
MISSING = frozenset(("", *MARKS.split()))
"""Cells without a sample, in small letters: empty, not available, beyond the instrument's range."""
BEYOND = (9.9e37, -9.9e37, 9.91e37)  # infinite and not a number, as instruments write them (SCPI 1999, volume 1, 7.2.1)
GROUP = {".": ",", ",": "."}  # mark between thousands beside a decimal mark
NUMBER = {
    mark: re.compile(
        rf"[-+]?(?:(?:\d+(?:\{mark}\d*)?|\{mark}\d+)(?:[eE][-+]?\d+)?|[1-9]\d{{0,2}}(?:\{group}\d{{3}})+(?:\{mark}\d*)?)",
        re.ASCII,
    )
    for mark, group in GROUP.items()
}
COMMENT = re.compile(r"\s*(?:#(?!n/a|nv\b)|$)", re.IGNORECASE)  # not a cell of Excel's that is not available
PROOF = {  # of a decimal mark: what no number has whose marks part thousands
    mark: re.compile(rf"(?<![\d.,])(?:0*\{mark}\d|\d{{4,}}\{mark}|\d+\{mark}(?!\d{{3}}(?![\deE])))") for mark in GROUP
}
UNEVEN = "?"  # cells of a line with more or fewer than there are headings
LABVIEW, MOTION_CAPTURE = "LabVIEW Measurement", "PathFileType"  # the first words of files that state units in a header
REMARKS = "comment"  # heading of the last column that LabVIEW writes, whose cells may be left out
UNPRINTED = re.compile(r"[\0-\x08\x0e-\x1f]")  # in no text


def text_of(path: Path) -> str:
    """Return the text of a file in UTF-8, UTF-16 or Latin-1; raises InputError where it is none."""
    try:
        raw = path.read_bytes()
    except OSError as error:
        raise InputError("measurement", [unreadable(path, error, "a CSV file")]) from error
    text, marked = "\0", raw[:2] in (b"\xff\xfe", b"\xfe\xff")
    wide = "utf-16" if marked else "utf-16-be" if raw[:1] == b"\0" else "utf-16-le" if raw[1:2] == b"\0" else ""
    for encoding in [wide] if wide else ["utf-8-sig", "latin-1"]:
        with suppress(UnicodeDecodeError):
            text = raw.decode(encoding)
            break
    if UNPRINTED.search(text):
        actual = "bytes that are not UTF-8, UTF-16 or Latin-1 text; save a workbook as CSV first"
        raise InputError("measurement", [Fault(str(path), actual, "a CSV file")])
    return text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n").replace("\u2212", "-")


def cells_of(line: str, delimiter: str) -> list[str]:
    """Return the cells of a line; a delimiter " " stands for any space."""
    if delimiter == " ":
        return line.split()
    cells = (
        next(csv.reader([line], delimiter=delimiter, skipinitialspace=True)) if '"' in line else line.split(delimiter)
    )
    return [cell.strip() for cell in cells]


def is_number(cell: str) -> bool:
    """Return whether a cell is a number with either decimal mark."""
    return any(number.fullmatch(cell) for number in NUMBER.values())


@dataclass(frozen=True)
class Layout:
    """Where headings, the units below them, and numbers stand: these after line `start`."""

    delimiter: str
    line: int
    headings: list[str]
    below: list[str]
    start: int

    @cached_property
    def width(self) -> int:
        """Number of columns: headings but for empty ones, and LabVIEW's remarks, at the end."""
        return max(k for k, cell in enumerate(["", *self.headings]) if k == 0 or cell.lower() not in ("", REMARKS))


def layout_of(text: str, is_key: Callable[[int, str], bool], skip: int, places: Sequence[int] = ()) -> Layout | None:
    """Return the layout below the first key that stands above a number; None without lines.

    is_key    whether the heading at a place is that of the column that orders the rows
    places    of columns that are read without headings: numbers begin in the first line that has them all
    """
    lines = [(n, line) for n, line in enumerate(text.split("\n", skip + HEAD)[: skip + HEAD], 1) if n > skip]
    rows = [(n, line) for n, line in lines if not COMMENT.match(line)]
    likely: list[Layout] = []
    for n, line in rows if places else lines:
        for delimiter in DELIMITERS:
            cells = _headings(line, delimiter)
            if places and all(k < len(cells) and is_number(cells[k]) for k in places):
                return Layout(delimiter, n, [str(k + 1) for k in range(len(cells))], [], n - 1)
            keys = [k for k, cell in enumerate(cells) if len(cells) > 1 and not places and is_key(k, cell)]
            if not keys:
                continue
            following = [(m, cells_of(row, delimiter)) for m, row in rows if m > n]
            (m, below), (_, row) = [*following, (n, [""]), (n, [""])][:2]
            if any(cell.lower() not in MISSING for cell in below) and not any(map(is_number, below)):
                likely.append(Layout(delimiter, n, cells, below, m))
            else:
                likely.append(Layout(delimiter, n, cells, [], n))
                row = below
            even = len(row) == len(cells) if delimiter == " " else len(row) > 1
            if even and keys[0] < len(row) and is_number(row[keys[0]]):
                return likely[-1]
    if likely or not rows:
        return likely[0] if likely else None
    n, line = rows[0]
    delimiter = max(DELIMITERS[:3], key=line.count)
    return Layout(delimiter, n, _headings(line, delimiter), [], n)


def with_header(text: str, layout: Layout) -> Layout:
    """Return a layout with the names and units that a header of LabVIEW or of motion capture states."""
    above = [cells_of(line, layout.delimiter) for line in text.split("\n", layout.line)[: layout.line - 1]]
    if text.startswith(LABVIEW):
        tags = {tag: rest for tag, *rest in above}
        time = "s" if tags.get("X_Dimension", ["Time"])[0] == "Time" else ""
        return replace(layout, below=[time, *tags.get("Y_Unit_Label", [])])
    if text.startswith(MOTION_CAPTURE) and len(above) >= 3:
        length, marker = dict(zip(above[1], above[2], strict=False)).get("Units", ""), ""
        names, units = [], []
        for heading, axis in zip_longest(layout.headings, layout.below, fillvalue=""):
            marker = heading or marker
            names.append(f"{marker}.{axis.rstrip('0123456789')}" if axis else heading)
            units.append(length if axis else {"frame#": "1", "time": "s"}.get(heading.lower(), ""))
        return replace(layout, headings=names, below=units)
    return layout


def _headings(line: str, delimiter: str) -> list[str]:
    """Return the headings of a line; a unit in brackets belongs to the name before it."""
    bare = re.sub(r"^\s*[#%]+\s*", "", line)
    return re.split(r"\s+(?![\[(])", bare.strip()) if delimiter == " " else cells_of(bare, delimiter)


class Numbers:
    """Numbers of columns of a text, with the faults of those that are none.

    places, names    of the columns; decimal: their mark, "" where the cells prove it
    missing          further cells without a sample, text or numbers
    """

    def __init__(
        self, file: str, text: str, layout: Layout, places: Sequence[int], names: Sequence[str], decimal: str,
        missing: Iterable[str],
    ) -> None:  # fmt: skip
        self._file, self._text, self._layout = file, text, layout
        self._places, self._names = list(places), names
        self._missing = {mark.strip().lower() for mark in missing} | MISSING
        self._by_row: list[tuple[int, Fault]] = []
        plain = self._plain(decimal)
        self.values: Array = self._by_cells(decimal) if plain is None else plain
        texts = [mark.replace(decimal or ".", ".") for mark in self._missing]
        self.values[np.isin(self.values, [*BEYOND, *(float(x) for x in texts if NUMBER["."].fullmatch(x))])] = np.nan

    @property
    def faults(self) -> list[Fault]:
        """Faults in the order of the lines: of many the first, and the number of others."""
        ordered = [fault for _, fault in sorted(self._by_row, key=lambda each: each[0])]
        more = len(ordered) - LISTED
        return [*ordered[:LISTED], *([Fault(self._file, f"{more} faults more", "none")] if more > 0 else [])]

    def add(self, row: int, found: str, expected: str, remedy: str = "", column: int | None = None) -> None:
        """Add a fault of a row."""
        where = f"{self._file}, line {self._rows[row][0]}" + ("" if column is None else f", {self._names[column]}")
        self._by_row.append((row, Fault(where, found, expected, remedy)))

    def _plain(self, decimal: str) -> Array | None:
        """Return the numbers as NumPy reads them; None where a cell is no plain number."""
        body, delimiter = self._text.split("\n", self._layout.start)[-1], self._layout.delimiter
        mark = decimal or ("," if delimiter != "," and "," in body else ".")
        in_doubt = delimiter != "," and mark in body and not (decimal or PROOF[mark].search(body))
        mixed = mark == "," and (delimiter == "," or "." in body)
        if mixed or in_doubt or '"' in body or "#" in body or not body.strip():
            return None
        body = body.replace(",", ".") if mark == "," else body
        empty, gap = 2 * delimiter, f"{delimiter}nan{delimiter}"
        if delimiter != " ":
            body = body.replace(empty, gap).replace(empty, gap).replace(f"{delimiter}\n", f"{delimiter}nan\n")
        try:
            values = np.loadtxt(
                io.StringIO(body), delimiter=None if delimiter == " " else delimiter, comments=None, ndmin=2
            )
        except ValueError:
            return None
        width = self._layout.width
        even = values.shape[1] == len(self._layout.headings) and np.all(np.isnan(values[:, width:]))
        return values[:, self._places] if even and not np.any(np.isinf(values)) else None

    @cached_property
    def _rows(self) -> list[tuple[int, str]]:
        lines = enumerate(self._text.split("\n"), 1)
        return [(n, line) for n, line in lines if n > self._layout.start and not COMMENT.match(line)]

    def _by_cells(self, decimal: str) -> Array:
        rows = [cells_of(line, self._layout.delimiter) for _, line in self._rows]
        width, most = self._layout.width, len(self._layout.headings)
        remarks = self._layout.headings[-1].lower() == REMARKS
        most += not remarks and all(len(row) == most + 1 and not row[-1] for row in rows)
        for r, row in enumerate(rows):
            if not width <= len(row) <= most or (any(row[width:]) and not remarks):
                comma = self._layout.delimiter == "," and any(re.fullmatch(r"[-+\d]+,\d+", c) for c in row)
                remedy = "decimal commas need another delimiter, or quotes" if comma else ""
                self.add(r, f"{len(row)} cells", f"{width}, as there are headings", remedy)
                rows[r] = [UNEVEN] * width
        columns = [[row[place] for row in rows] for place in self._places]
        marks = decimal or self._proven(columns)
        values = np.full((len(rows), len(columns)), np.nan)  # inf where a cell is faulty
        for c, cells in enumerate(columns):
            for r, cell in enumerate(cells):
                if cell.lower() in self._missing:
                    continue
                fits = [mark for mark in marks if NUMBER[mark].fullmatch(cell)]
                values[r, c] = float(cell.replace(GROUP[fits[0]], "").replace(fits[0], ".")) if fits else np.inf
                if np.isinf(values[r, c]) and cell is not UNEVEN:
                    self.add(r, shown(cell), "a finite number, or nothing where a sample is missing", column=c)
        return values

    def _proven(self, columns: Sequence[Sequence[str]]) -> str:
        """Return the decimal mark that the cells prove; both with a fault where they prove none, or both."""
        if self._layout.delimiter == "," and '"' not in self._text:
            return "."
        # by the mark that reads the cell; "?," where both do and it has one
        firsts: dict[str, tuple[int, int, str]] = {}
        for c, cells in enumerate(columns):
            for r, cell in enumerate(cells):
                if "," in cell or "." in cell:
                    marks = [mark for mark, number in NUMBER.items() if number.fullmatch(cell)]
                    kind = marks[0] if len(marks) == 1 else f"?{',' if ',' in cell else '.'}" if marks else ""
                    firsts.setdefault(kind, (r, c, cell))
        mark = "," if "," in firsts else "." if "." in firsts or not {"?,", "?."} & firsts.keys() else ""
        if mark == "," and "." in firsts:
            (r, c, cell), (other, column, point) = firsts[","], firsts["."]
            actual = f"{shown(cell)}, and {shown(point)} in line {self._rows[other][0]}, {self._names[column]}"
            self.add(
                r, actual, "one decimal mark", 'decimal="," or decimal="." states it, and the other is then refused', c
            )
            return ".,"
        doubtful = None if mark == "," else firsts.get("?,")
        if doubtful := doubtful or (None if mark == "." else firsts.get("?.")):
            r, c, cell = doubtful
            readings = [f'decimal="{m}" reads {cell.replace(g, "").replace(m, ".")}' for m, g in GROUP.items()]
            self.add(
                r, f"{shown(cell)}, which is two numbers", "cells that prove the decimal mark", ", ".join(readings), c
            )
            return ".,"
        return mark


class Arrays:
    """Numbers of columns that a data frame or a dictionary holds, with the faults of those that are none."""

    def __init__(self, columns: Sequence[Any], names: Sequence[str], missing: Iterable[str]) -> None:
        self.faults: list[Fault] = []
        arrays = [np.ma.asanyarray(each) for each in columns]
        for name, array in zip(names, arrays, strict=True):
            if array.dtype.kind not in "iuf" or array.shape != (arrays[0].size,):
                actual = f"{array.dtype} of shape {array.shape}"
                self.faults.append(Fault(name, actual, f"numbers, {arrays[0].size} as {names[0]} has"))
        fine = [] if self.faults else [np.ma.filled(array.astype(float), np.nan) for array in arrays]
        self.values: Array = np.column_stack(fine) if fine else np.zeros((0, len(arrays)))
        marks = [float(mark) for mark in missing if NUMBER["."].fullmatch(mark)]
        self.values[np.isin(self.values, [*BEYOND, *marks])] = np.nan

    def add(self, row: int, found: str, expected: str) -> None:
        """Add a fault of a row."""
        self.faults.append(Fault(f"row {row + 1}", found, expected))
