"""Scan of damaged SQLite files for entries: every page is read by itself, whatever leads to it.

A table leaf is a page that begins with 13; behind its number of cells stand their places. A cell has the size of its record, the
rowid, and the record, which ends in a chain of overflow pages where it is long. A write-ahead log has further versions of
pages. All of them are read, since digests tell which entries are whole. See https://www.sqlite.org/fileformat2.html.
"""

from __future__ import annotations

import mmap
import struct
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from hertzwerk.runtime.sweeps.kept.entries import POINT, ROW, SIZE, Entry, is_whole

PAGE = 4096  # bytes, as a store sets it
LEAF, OVERFLOW = 13, 4  # mark of a table leaf; bytes of the number of the page that follows
LOG, FRAME = 32, 24  # bytes before a log, and before each of its pages
LONGEST = PAGE - 35  # bytes of a record that has no overflow
SHORTEST = (PAGE - 12) * 32 // 255 - 23  # bytes that one with overflow has in its cell, at least
INTEGERS = {1: 1, 2: 2, 3: 3, 4: 4, 5: 6, 6: 8}  # bytes by kind


def scanned(files: Iterable[Path]) -> Iterator[Entry]:
    """Yield the points and rows in SQLite files and their logs, whole or not, some repeatedly.

    Raises OSError.
    """
    for file in files:
        with _Pages(file) as pages:
            for page in pages:
                yield from _entries(page, pages)


class _Pages:
    """Pages of a file and of its log; those of the log stand for `latest` before those of the file."""

    def __init__(self, file: Path) -> None:
        self._files = [path.open("rb") for path in (file, file.with_name(f"{file.name}-wal")) if path.exists()]
        self._maps: list[mmap.mmap | bytes] = []
        for each in self._files:
            size = each.seek(0, 2)
            self._maps.append(mmap.mmap(each.fileno(), 0, access=mmap.ACCESS_READ) if size else b"")
        self._logged: dict[int, int] = {}
        if len(self._maps) > 1:
            for place in range(LOG, len(self._maps[1]) - FRAME, FRAME + PAGE):
                self._logged[struct.unpack_from(">I", self._maps[1], place)[0]] = place + FRAME

    def __enter__(self) -> _Pages:
        return self

    def __exit__(self, *_: object) -> None:
        for each in (*self._maps, *self._files):
            if not isinstance(each, bytes):
                each.close()

    def __iter__(self) -> Iterator[bytes]:
        for each, begin, step in zip(self._maps, (0, LOG + FRAME), (PAGE, PAGE + FRAME), strict=False):
            for place in range(begin, len(each), step):
                yield each[place : place + PAGE].ljust(PAGE, b"\0")  # as SQLite reads a file that is cut

    def chain(self, number: int, size: int, *, logged: bool) -> bytes:
        """Return what overflow pages from one on hold, as far as they lead: at most `size` bytes."""
        parts = []
        most = sum(map(len, self._maps)) // PAGE
        for _ in range(min(-(-size // (PAGE - OVERFLOW)), most)):
            if logged and number in self._logged:
                place = self._logged[number]
                page = self._maps[1][place : place + PAGE]
            else:
                page = self._maps[0][(number - 1) * PAGE : number * PAGE] if number else b""
            if not page:
                break
            page = page.ljust(PAGE, b"\0")
            parts.append(page[OVERFLOW:])
            (number,) = struct.unpack_from(">I", page)
        return b"".join(parts)[:size]


def _entries(page: bytes, pages: _Pages) -> Iterator[Entry]:
    if page[0] != LEAF:  # that of the first page tells of tables alone
        return
    (count,) = struct.unpack_from(">H", page, 3)
    for place in range(8, min(8 + 2 * count, PAGE - 1), 2):
        cell = struct.unpack_from(">H", page, place)[0] % PAGE
        for logged in (True, False):
            with suppress(IndexError, struct.error, UnicodeDecodeError):
                entry = _entry(page, cell, pages, logged=logged)
                if entry is not None:
                    yield entry
                    if len(entry) == POINT or is_whole(entry):
                        break


def _entry(page: bytes, place: int, pages: _Pages, *, logged: bool) -> Entry | None:
    """Return the entry of a cell, None for anything else.

    Raises IndexError, struct.error, UnicodeDecodeError.
    """
    size, place = _varint(page, place)
    rowid, place = _varint(page, place)
    record = page[place : place + size]
    if size > LONGEST:
        here = SHORTEST + (size - SHORTEST) % (PAGE - OVERFLOW)
        here = here if here <= LONGEST else SHORTEST
        (number,) = struct.unpack_from(">I", page, place + here)
        record = page[place : place + here] + pages.chain(number, size - here, logged=logged)
    columns = _columns(record)
    if len(columns) == POINT and isinstance(columns[0], bytes):
        return (columns[0], rowid, *columns[2:])  # a number that is the rowid is not in the record
    if len(columns) == ROW and isinstance(columns[0], bytes):
        wall_s = columns[7]  # whole numbers are stored as integers
        return (*columns[:7], float(wall_s) if isinstance(wall_s, int) else wall_s, *columns[8:])
    return None


def _columns(record: bytes) -> Sequence[Any]:
    """Return the values of a record; raises IndexError, struct.error, UnicodeDecodeError."""
    end, place = _varint(record, 0)
    kinds: list[int] = []
    while place < end and len(kinds) <= ROW:
        kind, place = _varint(record, place)
        kinds.append(kind)
    if not kinds or kinds[0] != 12 + 2 * SIZE:
        return ()
    values: list[Any] = []
    place = end
    for kind in kinds:
        size = INTEGERS.get(kind, 8 if kind == 7 else (kind - 12) // 2 if kind >= 12 else 0)
        part = record[place : place + size]
        place += size
        if kind >= 12:
            values.append(part.decode() if kind % 2 else part)
        elif kind == 7:
            values.append(struct.unpack(">d", part)[0])
        elif kind == 0:
            values.append(None)
        else:
            values.append(int.from_bytes(part, "big", signed=True) if kind < 7 else kind - 8)
    return values


def _varint(content: bytes, place: int) -> tuple[int, int]:
    """Return a number of one to nine bytes, and the place behind it; raises IndexError."""
    value = 0
    for i in range(8):
        byte = content[place + i]
        value = value << 7 | byte & 127
        if byte < 128:
            return value, place + i + 1
    return value << 8 | content[place + 8], place + 9
