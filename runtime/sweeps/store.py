"""Store of a sweep: one folder that survives whatever ends the process that fills it.

definition.json    what is computed, by which versions
model.py           text of the model's generated module
rows.sqlite        points, a row for each that is done, and its arrays: float64, little-endian, compressed by zlib
table.csv          the table, written whenever the computing ends; section.csv, histories.csv    its arrays, up to 50 MB

Only the process that holds `lock` writes. Rows that arrive together are one transaction of SQLite in WAL mode: once `add`
returns they are with the operating system, so that no end of the process loses them, and half a row is never read. A commit
does not wait for the disk, which would cost as much as a short run (synchronous=NORMAL); a thread has what was committed written through
every SYNC seconds, log first, so that a loss of power costs the rows of the last second.
"""

from __future__ import annotations

import json
import math
import os
import sqlite3
import sys
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.runtime.host.folder import unwritable
from hertzwerk.runtime.host.scratch import UNFINISHED, write_atomically
from hertzwerk.runtime.solution.outcome import Outcome
from hertzwerk.runtime.sweeps.definition import differences
from hertzwerk.runtime.sweeps.kept.array_table import Packed
from hertzwerk.runtime.sweeps.kept.kept_arrays import END, place_of
from hertzwerk.runtime.sweeps.sweep_table import COMPLETE, LOST, Row, Sweep

DEFINITION, MODEL, ROWS, TABLE, LOCK = "definition.json", "model.py", "rows.sqlite", "table.csv", "lock"
PICTURE = "sweep.png"
OURS = {
    DEFINITION,
    MODEL,
    *(TABLE, "section.csv", "histories.csv", PICTURE),
    *(f"{name}{end}" for name in (ROWS, LOCK) for end in ("", "-wal", "-shm", "-journal")),
}
SYNC = 0.5  # s between two writes to the disk
PATIENCE = 30.0  # s to wait for a reader
_TABLES = """
CREATE TABLE IF NOT EXISTS points (number INTEGER PRIMARY KEY, key TEXT NOT NULL, given TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS rows (
    key TEXT PRIMARY KEY, outcome TEXT NOT NULL, message TEXT NOT NULL,
    si TEXT NOT NULL, outputs TEXT NOT NULL, warnings TEXT NOT NULL, wall_s REAL
);
CREATE TABLE IF NOT EXISTS arrays (
    key TEXT NOT NULL, name TEXT NOT NULL, shape TEXT NOT NULL, data BLOB NOT NULL, PRIMARY KEY (key, name)
);
"""


class Store:
    """Open store of the one process that fills it; `stored` are the keys of the rows that are there.

    lost    keys of the rows there whose process died, by a lack of memory as likely as by what they are: to be replaced
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._rows = _connected(folder / ROWS)
        self._rows.execute("PRAGMA journal_mode=WAL")
        self._rows.execute("PRAGMA synchronous=NORMAL")
        self._rows.executescript(_TABLES)
        found = self._rows.execute("SELECT key, outcome FROM rows").fetchall()
        self.stored = {key for key, _ in found}
        self.lost = {key for key, outcome in found if outcome == LOST}
        self._syncing = _Syncing(folder / ROWS)

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
        before, now = read_definition(self.folder), json.loads(json.dumps(definition))
        if before is not None and not widen:
            faults = differences(before, now)
            if faults:
                raise InputError(f"sweep in {self.folder}", faults)
        if before != now:
            _write_definition(self.folder, now, text)
        self._plan(keys, points)

    def _plan(self, keys: Sequence[str], points: Sequence[Mapping[str, Any]]) -> None:
        given = [
            (i, key, json.dumps(values, default=shown))
            for i, (key, values) in enumerate(zip(keys, points, strict=True))
        ]
        if self._rows.execute("SELECT * FROM points ORDER BY number").fetchall() == given:
            return
        with self._transaction():
            self._rows.execute("DELETE FROM points")
            self._rows.executemany("INSERT INTO points VALUES (?, ?, ?)", given)

    @contextmanager
    def _transaction(self) -> Iterator[None]:
        """Commit what is done within as one, or nothing of it."""
        self._rows.execute("BEGIN IMMEDIATE")
        try:
            yield
            self._rows.execute("COMMIT")
        except BaseException:
            with suppress(sqlite3.Error):  # of a disk that is full, which has rolled back already
                self._rows.execute("ROLLBACK")
            raise

    def add(self, rows: Mapping[str, Row]) -> None:
        """Store rows by their keys, all or none.

        Raises sqlite3.Error where that is not possible, as on a full disk, or one is there.
        """
        if self._syncing.error is not None:
            raise self._syncing.error
        arrays = [
            (key, name, json.dumps(packed.shape), packed.data)
            for key, row in rows.items()
            for name, packed in row.arrays.items()
        ]
        with self._transaction():
            self._rows.executemany("DELETE FROM rows WHERE key = ?", [(key,) for key in self.lost & rows.keys()])
            self._rows.executemany("INSERT INTO arrays VALUES (?, ?, ?, ?)", arrays)
            self._rows.executemany("INSERT INTO rows VALUES (?, ?, ?, ?, ?, ?, ?)", map(_entry, rows.items()))
        self.lost -= rows.keys()
        self.stored.update(rows)
        self._syncing.pending.set()

    def end_of(self, key: str) -> Packed | None:
        """Return the final state of a row that is stored, None where it got to no end."""
        found = self._rows.execute("SELECT shape, data FROM arrays WHERE key = ? AND name = ?", (key, END)).fetchone()
        return None if found is None else Packed(tuple(json.loads(found[0])), found[1])

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


def _entry(keyed: tuple[str, Row]) -> tuple[Any, ...]:
    key, row = keyed
    texts = (json.dumps(_nulled(part)) for part in (row.values, row.outputs))
    return (key, row.outcome, row.message, *texts, json.dumps(row.warnings), row.wall_s)


def _nulled(numbers: Mapping[str, float]) -> dict[str, float | None]:
    """Return numbers with null, which JSON has, in place of nan, which it has not."""
    return {name: None if math.isnan(value) else value for name, value in numbers.items()}


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
            others = sorted({path.name for path in folder.iterdir() if not UNFINISHED.fullmatch(path.name)} - OURS)
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


def read_definition(folder: Path) -> dict[str, Any] | None:
    """Return the definition in a folder, None where there is none; raises InputError for a broken one."""
    file = folder / DEFINITION
    if not file.is_file():
        return None
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise InputError("sweep", [Fault(str(file), str(error), "a definition as a sweep wrote it")]) from error
    if not isinstance(found, dict):
        raise InputError("sweep", [Fault(str(file), "no definition", "a definition as a sweep wrote it")])
    return found


def loaded(folder: Path) -> Sweep:
    """Return the table of the rows in a folder; raises InputError where there is no sweep."""
    definition = read_definition(folder)
    if definition is None:
        raise InputError("sweep", [Fault(str(folder), "no sweep", "a folder that a sweep was stored in")])
    rows, count = read_rows(folder)
    missing = count - len(rows)
    outcome = Outcome("incomplete", f"{missing:,} of {count:,} rows are missing", f"hertzwerk sweep --resume {folder}")
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


def read_rows(folder: Path) -> tuple[list[Row], int]:
    """Return the rows in a folder in the order of the points, and how many points there are."""
    file = folder / ROWS
    if not file.is_file():
        return [], 0
    with closing(_connected(file)) as connection:
        (count,) = connection.execute("SELECT count(*) FROM points").fetchone()
        found = connection.execute(
            "SELECT number, given, outcome, message, si, outputs, warnings, wall_s "
            "FROM points JOIN rows USING (key) ORDER BY number"
        )
        rows = [_row(*entry) for entry in found]
        arrays: dict[int, dict[str, Packed]] = {}
        for number, name, shape, data in connection.execute(
            "SELECT number, name, shape, data FROM points JOIN arrays USING (key)"
        ):
            arrays.setdefault(number, {})[name] = Packed(tuple(json.loads(shape)), data)
        return [replace(row, arrays=arrays[row.index]) if row.index in arrays else row for row in rows], count


def _row(number: int, given: str, outcome: str, message: str, si: str, outputs: str, warnings: str, wall_s: Any) -> Row:
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
    )
