"""Store of a sweep: one folder that survives whatever ends the process that fills it.

definition.json    what is computed, by which versions
model.py           text of the model's generated module
rows.sqlite        points, a row for each that is done, and its arrays: float64, little-endian, compressed by zlib
rows.damaged-001.sqlite    a damaged one that was replaced, as it was found
table.csv          the table, written whenever the computing ends; section.csv, histories.csv    its arrays, up to 50 MB

Only the process that holds `lock` writes. Rows that arrive together are one transaction of SQLite in WAL mode: once `add`
returns they are with the operating system, so that no end of the process loses them, and half a row is never read. A commit
does not wait for the disk, which would cost as much as a short run (synchronous=NORMAL); a thread has what was committed written through
every SYNC seconds, log first, so that a loss of power costs the rows of the last second.

Whatever is read is checked by digests. A file in which anything is damaged is replaced by one with all that is whole in it.
"""

from __future__ import annotations

import json
import math
import os
import re
import sqlite3
import sys
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.runtime.host.folder import unwritable
from hertzwerk.runtime.host.scratch import UNFINISHED, scratch_folder, write_atomically
from hertzwerk.runtime.host.sealed import sealed
from hertzwerk.runtime.solution.outcome import Outcome
from hertzwerk.runtime.sweeps.definition import DEFINITION, differences, read_definition
from hertzwerk.runtime.sweeps.kept.array_table import Packed
from hertzwerk.runtime.sweeps.kept.entries import POINT, ROW, TABLES, Entry, digest_of, is_whole, point_entry
from hertzwerk.runtime.sweeps.kept.kept_arrays import END, place_of
from hertzwerk.runtime.sweeps.kept.page_scan import PAGE, scanned
from hertzwerk.runtime.sweeps.sweep_table import COMPLETE, LOST, Row, Sweep

MODEL, ROWS, TABLE, LOCK = "model.py", "rows.sqlite", "table.csv", "lock"
PICTURE = "sweep.png"
OURS = {
    DEFINITION,
    MODEL,
    *(TABLE, "section.csv", "histories.csv", PICTURE),
    *(f"{name}{end}" for name in (ROWS, LOCK) for end in ("", "-wal", "-shm", "-journal")),
}
INSERT = f"INSERT INTO rows VALUES ({', '.join('?' * ROW)})"
SYNC = 0.5  # s between two writes to the disk
PATIENCE = 30.0  # s to wait for a reader
ASIDE = re.compile(r"rows\.damaged-(\d+)\.sqlite(-wal|-shm)?")
SOUND = {  # what SQLite says of the system, not of the file
    *(sqlite3.SQLITE_PERM, sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED, sqlite3.SQLITE_READONLY),
    *(sqlite3.SQLITE_INTERRUPT, sqlite3.SQLITE_IOERR, sqlite3.SQLITE_FULL, sqlite3.SQLITE_CANTOPEN),
}


class DamagedError(Exception):
    """A file of rows that is not as it was written."""


@dataclass(frozen=True)
class Damage:
    """Damage that was found and mended.

    kept    number of rows that are whole
    keys    of the rows that are not, as far as these can be read
    aside    the damaged file under its new name, None where it was not replaced
    """

    kept: int
    keys: frozenset[str]
    aside: Path | None

    def said(self, keys: Sequence[str]) -> str:
        """Return what was found in a sentence; `keys` of all rows in order."""
        rows = [str(i) for i, key in enumerate(keys) if key in self.keys]
        more = f", and {len(rows) - 20} more" if len(rows) > 20 else ""
        named = f"; row{'s' * (len(rows) > 1)} {', '.join(rows[:20])}{more} damaged" if rows else ""
        where = f"; the damaged file is kept as {self.aside.name}" if self.aside is not None else ""
        return f"{ROWS} was damaged: {self.kept:,} rows of it are whole{named}{where}"


class Store:
    """Open store of the one process that fills it; `stored` are the keys of the rows that are there.

    lost    keys of the rows there whose process died, by a lack of memory as likely as by what they are: to be replaced
    plan    digest of the definition that the points are of
    damage    what was found damaged, and replaced
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.plan = ""
        self.damage: Damage | None = None
        self.stored: set[str] = set()
        self.lost: set[str] = set()
        try:
            self._look()
        except DamagedError:
            self.damage = _replaced(folder)
            self._look()
        self._rows = _connected(folder / ROWS)
        self._rows.execute("PRAGMA journal_mode=WAL")
        self._rows.execute("PRAGMA synchronous=NORMAL")
        _make_tables(self._rows)
        self._syncing = _Syncing(folder / ROWS)

    def _look(self) -> None:
        """Find out which rows are there; raises DamagedError."""
        self.stored.clear()
        self.lost.clear()
        for _, key, outcome, *_ in _checked(self.folder):
            self.stored.add(key)
            if outcome == LOST:
                self.lost.add(key)

    @property
    def go_on(self) -> str:
        """Phrase: how to go on."""
        return f"the same call, or hertzwerk sweep --resume {self.folder}, goes on"

    def define(
        self,
        definition: Mapping[str, Any],
        text: str,
        keys: Sequence[str],
        points: Sequence[Mapping[str, Any]],
        *,
        widen: bool,
    ) -> None:
        """Keep what is computed: definition, text of the model, key and given values of every point in order.

        Raises InputError with every difference where there is another definition that is not to be widened.
        """
        now = sealed(definition)
        try:
            before = read_definition(self.folder)
        except InputError:
            if not widen:
                raise
            before = None
        if before is not None and not widen:
            faults = differences(before, now)
            if faults:
                raise InputError(f"sweep in {self.folder}", faults)
        if before != now or _content(self.folder / MODEL) != text.encode():
            _write_definition(self.folder, now, text)
        self.plan = now["digest"]
        self._plan(keys, points)

    def _plan(self, keys: Sequence[str], points: Sequence[Mapping[str, Any]]) -> None:
        given = [
            point_entry(self.plan, i, key, json.dumps(values, default=shown))
            for i, (key, values) in enumerate(zip(keys, points, strict=True))
        ]
        with suppress(sqlite3.OperationalError):  # of damaged text, which is written anew
            if self._rows.execute("SELECT * FROM points ORDER BY number").fetchall() == given:
                return
        with _transaction(self._rows):
            self._rows.execute("DELETE FROM points")
            self._rows.executemany("INSERT INTO points VALUES (?, ?, ?, ?)", given)

    def add(self, rows: Mapping[str, Row]) -> None:
        """Store rows by their keys, all or none.

        Raises sqlite3.Error where that is not possible, as on a full disk, or one is there.
        """
        if self._syncing.error is not None:
            raise self._syncing.error
        with _transaction(self._rows):
            self._rows.executemany("DELETE FROM rows WHERE key = ?", [(key,) for key in self.lost & rows.keys()])
            self._rows.executemany(INSERT, (_row_entry(key, row) for key, row in rows.items()))
        self.lost -= rows.keys()
        self.stored.update(rows)
        self._syncing.pending.set()

    def end_of(self, key: str) -> Packed | None:
        """Return the final state of a row that is stored, None where it got to no end."""
        found = self._rows.execute("SELECT sizes, arrays FROM rows WHERE key = ?", (key,)).fetchone()
        return None if found is None else _arrays_of(*found).get(END)

    def close(self) -> None:
        """Write everything through and close."""
        self._syncing.end()
        self._rows.close()


class _Syncing(threading.Thread):
    """Thread that has committed rows written to the disk; `error`: why it could not."""

    def __init__(self, file: Path) -> None:
        super().__init__(daemon=True)
        self._file, self._ending = file, threading.Event()
        self.pending = threading.Event()
        self.error: sqlite3.Error | None = None
        self.start()

    def run(self) -> None:
        """Check every SYNC seconds, until told to end."""
        try:
            with closing(_connected(self._file)) as connection:
                while not self._ending.wait(SYNC):
                    if self.pending.is_set():
                        self.pending.clear()
                        connection.execute("PRAGMA wal_checkpoint(PASSIVE)")
        except sqlite3.Error as error:
            self.error = error

    def end(self) -> None:
        """End; what is left is written when the last connection closes."""
        self._ending.set()
        self.join()


def _connected(file: Path) -> sqlite3.Connection:
    return sqlite3.connect(file, timeout=PATIENCE, isolation_level=None)


@contextmanager
def _transaction(rows: sqlite3.Connection) -> Iterator[None]:
    """Commit what is done within as one, or nothing of it."""
    rows.execute("BEGIN IMMEDIATE")
    try:
        yield
        rows.execute("COMMIT")
    except BaseException:
        with suppress(sqlite3.Error):  # of a disk that is full, which has rolled back already
            rows.execute("ROLLBACK")
        raise


def _make_tables(rows: sqlite3.Connection) -> None:
    if not rows.execute("SELECT name FROM sqlite_master").fetchall():
        with _transaction(rows):
            for statement in TABLES.values():
                rows.execute(statement)


def _checked(folder: Path, plan: str | None = None) -> Iterator[Entry]:
    """Yield the points of a plan, where there is one, and the rows in a folder, in no order.

    Raises DamagedError at the first that is not as it was written, sqlite3.Error where the system denies the file.
    """
    file = folder / ROWS
    log = file.with_name(f"{ROWS}-wal")
    if not file.exists():
        if any(_asides(folder)):  # the process that replaced it was killed
            raise DamagedError
        return
    try:
        # one that only reads leaves a damaged file and its log as they are
        with closing(sqlite3.connect(f"{file.resolve().as_uri()}?mode=ro", PATIENCE, 0, None, uri=True)) as connection:
            connection.execute("BEGIN")  # all of one moment
            tables = dict(connection.execute("SELECT name, sql FROM sqlite_master WHERE type = 'table'").fetchall())
            empty = file.stat().st_size + (log.stat().st_size if log.exists() else 0) <= PAGE
            if not tables and empty and not (folder / DEFINITION).exists():
                return  # whose process was killed before it wrote any
            if tables != TABLES or connection.execute("PRAGMA integrity_check(1)").fetchone() != ("ok",):
                raise DamagedError
            if plan is not None:
                points = connection.execute("SELECT * FROM points NOT INDEXED")
                yield from (entry for entry in points if is_whole(entry, plan))
            for entry in connection.execute("SELECT * FROM rows NOT INDEXED"):
                if not is_whole(entry):
                    raise DamagedError
                yield entry
    except (sqlite3.Error, UnicodeError, OverflowError, MemoryError) as error:
        if getattr(error, "sqlite_errorcode", sqlite3.SQLITE_CORRUPT) & 0xFF in SOUND:
            raise
        raise DamagedError from error


def _asides(folder: Path) -> dict[int, Path]:
    """Return the damaged files that were replaced, by their numbers."""
    found = ((ASIDE.fullmatch(path.name), path) for path in folder.iterdir())
    return {int(place[1]): path for place, path in found if place is not None and place[2] is None}


def _sources(folder: Path) -> list[Path]:
    """Return the files that may hold rows: the one in use, and those that it replaced."""
    return [path for path in (folder / ROWS, *_asides(folder).values()) if path.exists()]


def _replaced(folder: Path) -> Damage:
    """Replace a damaged file by one with every row that is whole in it or in one that it replaced."""
    kept: set[str] = set()
    broken: set[str] = set()
    lost: list[Entry] = []

    def whole() -> Iterator[Entry]:
        for entry in scanned(_sources(folder)):
            if len(entry) == POINT:  # made anew from the definition
                continue
            if not is_whole(entry):
                broken.add(entry[1])
                continue
            kept.add(entry[1])
            if entry[2] == LOST:  # another of this key may be none
                lost.append(entry)
            else:
                yield entry

    with scratch_folder(folder) as scratch:
        with closing(_connected(scratch / ROWS)) as rows:
            _make_tables(rows)
            with _transaction(rows):
                rows.executemany(f"{INSERT} ON CONFLICT DO NOTHING", whole())
                rows.executemany(f"{INSERT} ON CONFLICT DO NOTHING", lost)
        aside = folder / f"rows.damaged-{max(_asides(folder), default=0) + 1:03d}.sqlite"
        for end in ("-wal", "-shm", ""):
            part = folder / f"{ROWS}{end}"
            if part.exists():
                part.replace(aside.with_name(f"{aside.name}{end}"))
        (scratch / ROWS).replace(folder / ROWS)
    return Damage(len(kept), frozenset(broken - kept), aside if aside.exists() else None)


@contextmanager
def opened(folder: Path) -> Iterator[Store]:
    """Open or make the store in a folder, for this process alone; raises InputError."""
    fault = _fault(folder)
    if fault is not None:
        raise InputError("sweep", [fault])
    folder.mkdir(parents=True, exist_ok=True)
    with closing(sqlite3.connect(folder / LOCK, timeout=0, isolation_level=None)) as lock:
        try:
            lock.execute("BEGIN EXCLUSIVE")  # ends with the process, however that ends, and no fork inherits it
        except sqlite3.OperationalError as error:
            expected, way_out = "a folder that no other process works on", "wait for its end, or take another folder"
            raise InputError("sweep", [Fault(str(folder), f"one in use ({error})", expected, way_out)]) from error
        try:
            with closing(Store(folder)) as store:
                yield store
        except sqlite3.Error as error:
            raise OSError(f"{folder / ROWS}: {error}") from error


def _fault(folder: Path) -> Fault | None:
    """Return the fault of a folder that can hold no store."""
    expected = "a new or empty folder, or one of a sweep"
    try:
        if not folder.exists():
            reason = unwritable(folder)
        elif not folder.is_dir():
            reason = f"{folder}, which is a file"
        else:
            there = (path.name for path in folder.iterdir())
            others = sorted(
                {name for name in there if not (UNFINISHED.fullmatch(name) or ASIDE.fullmatch(name))} - OURS
            )
            reason = f"{folder}, which has other content ({others[0]})" if others else unwritable(folder)
    except (OSError, ValueError) as error:
        reason = f"{folder}: {error}"
    return None if reason is None else Fault("into", reason, expected)


def _write_definition(folder: Path, definition: Mapping[str, Any], text: str) -> None:
    """Write what is computed, durably: the definition last, so that where it is there the rest is."""
    write_atomically(folder / MODEL, text.encode())
    write_atomically(folder / DEFINITION, (json.dumps(definition, indent=2) + "\n").encode())
    if sys.platform != "win32":  # there folders cannot be opened
        descriptor = os.open(folder, os.O_RDONLY)
        with suppress(OSError):  # of file systems that cannot
            os.fsync(descriptor)
        os.close(descriptor)


def _content(file: Path) -> bytes | None:
    """Return the content of a file, None where it cannot be read."""
    try:
        return file.read_bytes()
    except OSError:
        return None


def loaded(folder: Path) -> Sweep:
    """Return the table of the rows in a folder; raises InputError where there is no sweep."""
    definition = read_definition(folder)
    if definition is None:
        raise InputError("sweep", [Fault(str(folder), "no sweep", "a folder that a sweep was stored in")])
    rows, damaged = read_rows(folder, definition["digest"])
    count = definition["points"]
    missing = count - len(rows)
    why = f", as {ROWS} is damaged" if damaged else ""
    remedy = f"hertzwerk sweep --resume {folder}"
    outcome = Outcome("incomplete", f"{missing:,} of {count:,} rows are missing{why}", remedy)
    return Sweep(
        scene=definition["scene"],
        rows=tuple(rows),
        columns=definition["columns"],
        varied=tuple(definition["varied"]),
        axes={name: tuple(values) for name, values in definition["axes"].items()},
        arrays=definition["arrays"],
        place=place_of(definition["section"], definition["grid"], definition["after"]),
        outcome=outcome if missing else COMPLETE,
    )


def read_rows(folder: Path, plan: str) -> tuple[list[Row], bool]:
    """Return the rows in a folder in the order of its points, and whether anything was found damaged.

    plan    digest of the definition
    """
    damaged = False
    try:
        found: Iterable[Entry] = list(_checked(folder, plan))
    except DamagedError:
        found, damaged = filter(lambda entry: is_whole(entry, plan), scanned(_sources(folder))), True
    points: dict[int, Entry] = {}
    rows: dict[str, Entry] = {}
    for entry in found:
        if len(entry) == POINT:
            points[entry[1]] = entry
        elif entry[2] != LOST or entry[1] not in rows:
            rows[entry[1]] = entry
    there = ((number, key, given) for _, number, key, given in (points[i] for i in sorted(points)))
    return [_row_of(number, given, rows[key]) for number, key, given in there if key in rows], damaged


def _row_entry(key: str, row: Row) -> Entry:
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


def _row_of(number: int, given: str, entry: Entry) -> Row:
    """Return the row of an entry that is whole, at a point."""
    _, _, outcome, message, si, outputs, warnings, wall_s, sizes, arrays = entry
    known, *parts, warned = json.loads(f"[{given},{si},{outputs},{warnings}]")  # at once: a call costs as much as a row
    values, numbers = ({n: math.nan if value is None else value for n, value in part.items()} for part in parts)
    texts = {name: tuple(value) if isinstance(value, list) else value for name, value in known.items()}
    return Row(
        index=number,
        given=texts,
        outcome=outcome,
        message=message,
        values=values,
        outputs=numbers,
        warnings=tuple(warned),
        wall_s=math.nan if wall_s is None else wall_s,
        arrays=_arrays_of(sizes, arrays),
    )


def _arrays_of(sizes: str, data: bytes) -> dict[str, Packed]:
    """Return the arrays of a row by name."""
    arrays, begin = {}, 0
    for name, (shape, size) in json.loads(sizes).items():
        arrays[name] = Packed(tuple(shape), data[begin : begin + size])
        begin += size
    return arrays


def _nulled(numbers: Mapping[str, float]) -> dict[str, float | None]:
    """Return numbers with null, which JSON has, in place of nan, which it has not."""
    return {name: None if math.isnan(value) else value for name, value in numbers.items()}
