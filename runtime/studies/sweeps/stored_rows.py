"""Rows in the folder of a sweep, read in the order of the design whenever they are looked at.

Whatever is read is checked by digests; of a file in which anything is damaged a copy is read, with all in it that is whole and
that SQLite reads.
"""

from __future__ import annotations

import json
import math
import re
import shutil
import sqlite3
import sys
import tempfile
import weakref
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from hashlib import blake2b
from itertools import chain, islice
from pathlib import Path
from typing import Any, TypeAlias

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.solution.outcome import Outcome
from hertzwerk.runtime.studies.sweeps.points.design_points import Design
from hertzwerk.runtime.studies.sweeps.points.sweep_definition import DEFINITION, design_of, read_definition
from hertzwerk.runtime.studies.sweeps.rows.row import LOST, Packed, Row
from hertzwerk.runtime.studies.sweeps.rows.row_arrays import place_of
from hertzwerk.runtime.studies.sweeps.sweep_table import COMPLETE, Sweep

TABLES = {
    "points": "CREATE TABLE points (digest BLOB NOT NULL, number INTEGER PRIMARY KEY, key TEXT NOT NULL)",
    "rows": "CREATE TABLE rows (digest BLOB NOT NULL, key TEXT PRIMARY KEY, outcome TEXT NOT NULL, message TEXT NOT NULL, "
    "si TEXT NOT NULL, outputs TEXT NOT NULL, warnings TEXT NOT NULL, wall_s REAL, sizes TEXT NOT NULL, arrays BLOB NOT NULL)",
}
POINT, ROW = 3, 10  # columns
SIZE, SHORTEST = 16, 64  # bytes of a digest; of a row, at least

Entry: TypeAlias = tuple[Any, ...]


def digest_of(rest: Entry, plan: str = "") -> bytes:
    """Return the digest of the other columns, of which the last may be bytes; of a point with its plan."""
    *plain, last = rest
    content = last if isinstance(last, bytes) else f"{last!r} {plan}".encode()
    return blake2b(repr(plain).encode() + content, digest_size=SIZE).digest()


def is_whole(entry: Entry, plan: str = "") -> bool:
    """Return whether the digest of an entry is that of the rest, of a point for a plan."""
    return bool(entry[0] == digest_of(entry[1:], plan))


def point_entry(plan: str, number: int, key: str) -> Entry:
    """Return the entry of a point; `plan`: digest of its definition, as points of an earlier one are none."""
    rest = (number, key)
    return (digest_of(rest, plan), *rest)


# ----------------------------------------------------------------------------------------------------------------------


ROWS = "rows.sqlite"
ASIDE = re.compile(r"rows\.damaged-(\d+)\.sqlite(-wal|-shm)?")
INSERT = f"INSERT INTO rows VALUES ({', '.join('?' * ROW)})"
PLACE = "INSERT OR REPLACE INTO points VALUES (?, ?, ?)"
HELD = 10_000  # rows of a table, beyond which they stay in the folder
PATIENCE = 30.0  # s to wait for a reader
PAGE = 4096  # bytes, as SQLite sets it
VERSIONS_AT = slice(18, 20)  # bytes of the first page: of writing and reading, of which SQLite writes no other
VERSIONS = b"\1\1", b"\2\2", b""  # without a log and with one, and of an empty file
SIZE_AT = slice(28, 32)  # those that say how many pages there are
FAILED = (sqlite3.Error, UnicodeError, OverflowError, MemoryError)  # to read what is damaged
SOUND = {  # what SQLite says of the system, not of the file
    *(sqlite3.SQLITE_PERM, sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED, sqlite3.SQLITE_READONLY),
    *(sqlite3.SQLITE_INTERRUPT, sqlite3.SQLITE_IOERR, sqlite3.SQLITE_FULL, sqlite3.SQLITE_CANTOPEN),
}


class DamagedError(OSError):
    """A file of rows that is not as it was written."""


class StoredRows(Sequence[Row]):
    """Rows in a file, in the order of the design; each is read and checked whenever it is looked at.

    plan    digest of the definition that the points are of
    last    number of the last one, in the order of storing: those that come later are none of these
    """

    def __init__(self, file: Path, plan: str, design: Design) -> None:
        self._file, self._plan, self._design = file, plan, design
        self._last, self._count = sys.maxsize, 0
        with _reading(file) as rows:
            if rows is not None:
                self._last = rows.execute("SELECT ifnull(max(rowid), 0) FROM rows").fetchone()[0]
                there = "SELECT count(*) FROM points CROSS JOIN rows USING (key) WHERE rows.rowid <= ?"
                (self._count,) = rows.execute(there, (self._last,)).fetchone()

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Row]:
        """Yield the rows; raises DamagedError at the first that is not as it was written."""
        return (_row_of(number, self._design, row) for number, row in self.entries())

    def __getitem__(self, i: Any) -> Any:
        if isinstance(i, slice):
            return tuple(islice(self, *i.indices(self._count)))
        if not -self._count <= i < self._count:
            raise IndexError(i)
        return next(islice(self, i % self._count, None))

    def entries(self) -> Iterator[tuple[int, Entry]]:
        """Yield the numbers of rows and their entries; raises DamagedError as above."""
        joined = "SELECT points.*, rows.* FROM points CROSS JOIN rows ON rows.key = points.key WHERE rows.rowid <= ? ORDER BY number"
        with _reading(self._file) as rows:
            for entry in rows.execute(joined, (self._last,)) if rows is not None else ():
                point, row = entry[:POINT], entry[POINT:]
                if not (is_whole(point, self._plan) and is_whole(row)):
                    raise DamagedError(f"{self._file} is damaged, or changed while it was read; load it again")
                yield point[1], row


@contextmanager
def _reading(file: Path) -> Iterator[sqlite3.Connection | None]:
    """Read a file as of one moment, None where there is none.

    Raises DamagedError, and sqlite3.Error where the system denies the file.
    """
    if not file.exists():
        yield None
        return
    try:
        # one that only reads leaves a damaged file and its log as they are
        with closing(sqlite3.connect(f"{file.resolve().as_uri()}?mode=ro", PATIENCE, 0, None, uri=True)) as connection:
            connection.execute("BEGIN")
            yield connection
    except FAILED as error:
        if getattr(error, "sqlite_errorcode", sqlite3.SQLITE_CORRUPT) & 0xFF in SOUND:
            raise
        raise DamagedError(f"{file}: {error}") from error


def check(folder: Path) -> None:
    """Raise DamagedError where SQLite finds the file of a folder damaged."""
    file = folder / ROWS
    log = file.with_name(f"{ROWS}-wal")
    if not file.exists():
        if asides(folder):  # the process that replaced it was killed
            raise DamagedError(f"{file} is missing")
        return
    with _reading(file) as rows:
        if rows is None:
            return
        tables = dict(rows.execute("SELECT name, sql FROM sqlite_master WHERE type = 'table'").fetchall())
        empty = file.stat().st_size + (log.stat().st_size if log.exists() else 0) <= PAGE
        if not tables and empty and not (folder / DEFINITION).exists():
            return  # whose process was killed before it wrote any
        with file.open("rb") as content:
            writable = content.read(VERSIONS_AT.stop)[VERSIONS_AT] in VERSIONS
        if not writable or tables != TABLES or rows.execute("PRAGMA integrity_check(1)").fetchone() != ("ok",):
            raise DamagedError(f"{file} is damaged")


def asides(folder: Path) -> dict[int, Path]:
    """Return the damaged files that were replaced, by their numbers."""
    matches = ((ASIDE.fullmatch(path.name), path) for path in folder.iterdir())
    return {int(place[1]): path for place, path in matches if place is not None and place[2] is None}


# -- damage ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Damage:
    """Damage that was found.

    whole    number of rows that are whole
    rows    those that are not, as far as that is known
    aside    the damaged file under its new name, None where it was not replaced
    """

    whole: int
    rows: tuple[int, ...]
    aside: Path | None = None

    def __str__(self) -> str:
        more = f", and {len(self.rows) - 20:,} more" if len(self.rows) > 20 else ""
        numbers = ", ".join(map(str, self.rows[:20]))
        named = f"; row{'s' * (len(self.rows) > 1)} {numbers}{more} damaged" if self.rows else ""
        where = f"; the damaged file is kept as {self.aside.name}" if self.aside is not None else ""
        return f"{ROWS} was damaged: {self.whole:,} rows of it are whole{named}{where}"


def mended(folder: Path, plan: str, file: Path) -> Damage:
    """Write a new file with every row that is whole in the files of a folder, and their points."""
    lost: list[Entry] = []

    def whole(table: str, plan: str) -> Iterator[Entry]:
        sources = [path for path in (folder / ROWS, *asides(folder).values()) if path.exists()]
        for path in sources:
            for entry in readable(path, table, first):
                if not is_whole(entry, plan):
                    continue
                if entry[2] == LOST:  # another of this key may be none
                    lost.append(entry)
                else:
                    yield entry

    with closing(connected(file)) as rows:
        make_tables(rows)
        first = file.read_bytes()[:PAGE]
        with transaction(rows):
            rows.executemany(PLACE, whole("points", plan))
            for entries in (whole("rows", ""), lost):
                rows.executemany(f"{INSERT} ON CONFLICT DO NOTHING", entries)
            without = "FROM points WHERE key NOT IN (SELECT key FROM rows)"
            broken = [number for (number,) in rows.execute(f"SELECT number {without} ORDER BY number")]
            rows.execute(f"DELETE {without}")
        (count,) = rows.execute("SELECT count(*) FROM rows").fetchone()
    return Damage(count, tuple(broken))


def readable(file: Path, table: str, first: bytes) -> Iterator[Entry]:
    """Yield the entries of a table that SQLite reads in a damaged file, whole or not, some repeatedly.

    first    page of a new file, under which a copy is read too: the first page leads to all others
    """
    with tempfile.TemporaryDirectory() as place:
        copy = Path(place) / file.name
        shutil.copyfile(file, copy)
        with copy.open("r+b") as content:
            content.write(first[: SIZE_AT.start] + bytes(4) + first[SIZE_AT.stop :])  # as many as there are
        for each in (file, copy):
            with suppress(DamagedError), _reading(each) as rows:
                yield from _readable(rows, f"SELECT * FROM {table} NOT INDEXED", each.stat().st_size // SHORTEST)


def _readable(rows: sqlite3.Connection | None, select: str, most: int) -> Iterator[Entry]:
    """Yield entries in order, and where that fails from the end, and one by one up to the rowid `most`."""
    if rows is None:
        return
    one_by_one = (f"WHERE rowid = {i}" for i in range(most))
    for which in chain(("ORDER BY rowid", "ORDER BY rowid DESC"), one_by_one):
        with suppress(*FAILED):
            yield from rows.execute(f"{select} {which}")
            if which == "ORDER BY rowid":
                return


def connected(file: Path) -> sqlite3.Connection:
    """Open a file to write."""
    return sqlite3.connect(file, timeout=PATIENCE, isolation_level=None)


@contextmanager
def transaction(rows: sqlite3.Connection) -> Iterator[None]:
    """Commit what is done within as one, or nothing of it."""
    rows.execute("BEGIN IMMEDIATE")
    try:
        yield
        rows.execute("COMMIT")
    except BaseException:
        with suppress(sqlite3.Error):  # of a disk that is full, which has rolled back already
            rows.execute("ROLLBACK")
        raise


def make_tables(rows: sqlite3.Connection) -> None:
    """Make the tables of a new file."""
    if not rows.execute("SELECT name FROM sqlite_master").fetchall():
        with transaction(rows):
            for statement in TABLES.values():
                rows.execute(statement)


# -- tables ------------------------------------------------------------------------------------------------------------


def loaded(folder: Path) -> Sweep:
    """Return the table of the rows in a folder; raises InputError where there is no sweep."""
    definition = read_definition(folder)
    if definition is None:
        raise InputError("sweep", [Fault(str(folder), "no sweep", "a folder that a sweep was stored in")])
    design, plan = design_of(definition), definition["digest"]
    damaged = ""
    try:
        check(folder)
        rows = held(StoredRows(folder / ROWS, plan, design))
    except DamagedError:
        place = Path(tempfile.mkdtemp())
        mended(folder, plan, place / ROWS)
        copy, damaged = StoredRows(place / ROWS, plan, design), f", as {ROWS} is damaged"
        weakref.finalize(copy, shutil.rmtree, place, ignore_errors=True)
        rows = held(copy)
    count = definition["points"]
    missing = count - len(rows)
    remedy = f"hertzwerk sweep --resume {folder}"
    outcome = Outcome("incomplete", f"{missing:,} of {count:,} rows are missing{damaged}", remedy)
    return Sweep(
        scene=definition["scene"],
        rows=rows,
        columns=definition["columns"],
        varied=tuple(definition["varied"]),
        design=design,
        arrays=definition["arrays"],
        place=place_of(definition["section"], definition["grid"], definition["after"]),
        outcome=outcome if missing else COMPLETE,
    )


def held(rows: StoredRows) -> Sequence[Row]:
    """Return rows that were checked, in memory where they are few; raises DamagedError."""
    if len(rows) <= HELD:
        return tuple(rows)
    for _ in rows.entries():
        pass
    return rows


# -- entries -----------------------------------------------------------------------------------------------------------


def row_entry(key: str, row: Row) -> Entry:
    """Return the entry of a row; its arrays follow each other in one column, as wide as `sizes` says."""
    si, outputs = (json.dumps(_nulled(part)) for part in (row.values, row.outputs))
    sizes = {name: [packed.shape, len(packed.data)] for name, packed in row.arrays.items()}
    arrays = b"".join(packed.data for packed in row.arrays.values())
    wall_s = None if math.isnan(row.wall_s) else float(row.wall_s)
    rest = (
        key,
        row.outcome,
        row.message,
        si,
        outputs,
        json.dumps(row.warnings),
        wall_s,
        json.dumps(sizes) if sizes else "{}",
        arrays,
    )
    return (digest_of(rest), *rest)


def _row_of(number: int, design: Design, entry: Entry) -> Row:
    """Return the row of an entry that is whole, at a point."""
    _, _, outcome, message, si, outputs, warnings, wall_s, sizes, arrays = entry
    *parts, warned = json.loads(f"[{si},{outputs},{warnings}]")  # at once: a call costs as much as a row
    values, numbers = ({n: math.nan if value is None else value for n, value in part.items()} for part in parts)
    return Row(
        index=number,
        stated=design[number],
        outcome=outcome,
        message=message,
        values=values,
        outputs=numbers,
        warnings=tuple(warned),
        wall_s=math.nan if wall_s is None else wall_s,
        arrays=arrays_of(sizes, arrays),
    )


def arrays_of(sizes: str, data: bytes) -> dict[str, Packed]:
    """Return the arrays of a row by name."""
    arrays: dict[str, Packed] = {}
    begin = 0
    if sizes == "{}":
        return arrays
    for name, (shape, size) in json.loads(sizes).items():
        arrays[name] = Packed(tuple(shape), data[begin : begin + size])
        begin += size
    return arrays


def _nulled(numbers: Mapping[str, float]) -> dict[str, float | None]:
    """Return numbers with null, which JSON has, in place of nan, which it has not."""
    return {name: None if math.isnan(value) else value for name, value in numbers.items()}
