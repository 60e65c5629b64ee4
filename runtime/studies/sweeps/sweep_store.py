"""Store of a sweep: one folder that survives whatever ends the process that fills it.

definition.json    what is computed, by which versions
model.py           text of the model's generated module
rows.sqlite        a row for each that is done, its arrays: float64, little-endian, compressed by zlib; the points that rows are of
rows.damaged-001.sqlite    a damaged one that was replaced, as it was found
table.csv          the table, written whenever the computing ends; section.csv, histories.csv    its arrays, up to 50 MB

Only the process that holds `lock` writes. Rows that arrive together are one transaction of SQLite in WAL mode: once `add`
returns they are with the operating system, so that no end of the process loses them, and half a row is never read. A commit
does not wait for the disk, which would cost as much as a short run (synchronous=NORMAL); a thread has what was committed written through
every SYNC seconds, log first, so that a loss of power costs the rows of the last second.

A point is stored with its row, and names its key: what is missing is known without the key of any other. SQLite's own check
comes before anything is written, that of the digests when the rows are read. A file in which anything is damaged is replaced by one
with all that is whole in it.
"""

from __future__ import annotations

import json
import os
import sqlite3
import sys
import threading
from collections.abc import Collection, Iterator, Mapping
from contextlib import closing, contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.runtime.studies.sweeps.points.sweep_definition import DEFINITION, differences, read_definition
from hertzwerk.runtime.studies.sweeps.rows.row import LOST, Packed, Row
from hertzwerk.runtime.studies.sweeps.rows.row_arrays import END
from hertzwerk.runtime.studies.sweeps.stored_rows import (
    ASIDE,
    INSERT,
    PLACE,
    ROWS,
    Damage,
    DamagedError,
    arrays_of,
    asides,
    check,
    connected,
    make_tables,
    mended,
    point_entry,
    row_entry,
    transaction,
)
from hertzwerk.runtime.system.atomic_files import UNFINISHED, scratch_folder, write_atomically
from hertzwerk.runtime.system.digests import sealed
from hertzwerk.runtime.system.result_folder import unwritable

MODEL, TABLE, LOCK = "model.py", "table.csv", "lock"
PICTURE = "sweep.png"
OURS = {
    DEFINITION,
    MODEL,
    *(TABLE, "section.csv", "histories.csv", PICTURE),
    *("report.html", "propagation.json", "propagation.png"),  # of commands that read a sweep, or make one
    *(f"{name}{end}" for name in (ROWS, LOCK) for end in ("", "-wal", "-shm", "-journal")),
}
SYNC = 0.5  # s between two writes to the disk


class Store:
    """Open store of the one process that fills it.

    lost    keys of rows there whose process died, by a lack of memory as likely as by what they are: to be replaced
    plan    digest of the definition that the points are of
    damage    what was found damaged, and replaced
    """

    def __init__(self, folder: Path) -> None:
        self.folder, self.plan = folder, ""
        self.damage: Damage | None = None
        self.lost: set[str] = set()
        try:
            check(folder)
        except DamagedError:
            with suppress(InputError):  # of a damaged definition: its points are found again by their keys
                self.plan = (read_definition(folder) or {}).get("digest", "")
            self._replace()
        self._open()

    def _open(self) -> None:
        self._rows = connected(self.folder / ROWS)
        self._rows.execute("PRAGMA journal_mode=WAL")
        self._rows.execute("PRAGMA synchronous=NORMAL")
        make_tables(self._rows)
        self._syncing = _Syncing(self.folder / ROWS)

    def mend(self) -> None:
        """Replace the file, in which something was found damaged."""
        self.close()
        self._replace()
        self._open()

    def _replace(self) -> None:
        """Replace a damaged file by one with every row that is whole in it or in one that it replaced."""
        folder = self.folder
        with scratch_folder(folder) as scratch:
            damage = mended(folder, self.plan, scratch / ROWS)
            aside = folder / f"rows.damaged-{max(asides(folder), default=0) + 1:03d}.sqlite"
            for end in ("-wal", "-shm", ""):
                part = folder / f"{ROWS}{end}"
                if part.exists():
                    part.replace(aside.with_name(f"{aside.name}{end}"))
            (scratch / ROWS).replace(folder / ROWS)
        self.damage = replace(damage, aside=aside if aside.exists() else None)

    @property
    def go_on(self) -> str:
        """Phrase: how to go on."""
        return f"the same call, or hertzwerk sweep --resume {self.folder}, goes on"

    def define(self, definition: Mapping[str, Any], text: str, *, widen: bool) -> None:
        """Keep what is computed: definition, text of the model.

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
            refuse(f"sweep in {self.folder}", differences(before, now))
        if before != now or _content(self.folder / MODEL) != text.encode():
            with transaction(self._rows):
                self._rows.execute("DELETE FROM points")
            _write_definition(self.folder, now, text)
        self.plan = now["digest"]

    def done(self, count: int) -> bytearray:
        """Return for every point whether its row is known to be there."""
        done = bytearray(count)
        for (number,) in self._rows.execute("SELECT number FROM points CROSS JOIN rows USING (key)"):
            if 0 <= number < count:
                done[number] = 1
        return done

    def keys(self, numbers: Collection[int]) -> dict[int, str]:
        """Return the keys of points whose rows are there."""
        among = f"SELECT number, key FROM points CROSS JOIN rows USING (key) WHERE number IN ({', '.join('?' * len(numbers))})"
        return dict(self._rows.execute(among, tuple(numbers)))

    def present(self, keys: Collection[str]) -> set[str]:
        """Return which of these keys have rows."""
        among = f"SELECT key, outcome FROM rows WHERE key IN ({', '.join('?' * len(keys))})"
        there = dict(self._rows.execute(among, tuple(keys)))
        self.lost |= {key for key, outcome in there.items() if outcome == LOST}
        return set(there)

    def died(self) -> dict[int, str]:
        """Return the points whose rows were lost, each key once."""
        lost = self._rows.execute("SELECT key FROM rows WHERE outcome = ?", (LOST,)).fetchall()
        self.lost |= {key for (key,) in lost}
        if not lost:
            return {}
        rows = self._rows.execute("SELECT min(number), key FROM points GROUP BY key")
        return {number: key for number, key in rows if key in self.lost}

    def add(self, rows: Mapping[str, Row], points: Mapping[int, str]) -> None:
        """Store rows by their keys, and the keys of points, all or none.

        Raises sqlite3.Error where that is not possible, as on a full disk, or a row is there.
        """
        if self._syncing.error is not None:
            raise self._syncing.error
        with transaction(self._rows):
            self._rows.executemany("DELETE FROM rows WHERE key = ?", [(key,) for key in self.lost & rows.keys()])
            self._rows.executemany(INSERT, (row_entry(key, row) for key, row in rows.items()))
            self._rows.executemany(PLACE, (point_entry(self.plan, number, key) for number, key in points.items()))
        self.lost -= rows.keys()
        self._syncing.pending.set()

    def end_of(self, key: str) -> Packed | None:
        """Return the final state of a row that is stored, None where it got to no end."""
        row = self._rows.execute("SELECT sizes, arrays FROM rows WHERE key = ?", (key,)).fetchone()
        return None if row is None else arrays_of(*row).get(END)

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
        """Check every SYNC seconds, until the end is set."""
        try:
            with closing(connected(self._file)) as connection:
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
            expected, way_out = "a folder that no other process uses", "wait for its end, or take another folder"
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
    return None if reason is None else Fault("out", reason, expected)


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
