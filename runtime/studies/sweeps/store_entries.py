"""Entries of a store's tables: columns and digests.

Every entry begins with the digest of the rest, so that a damaged one is found wherever it is read. The key of a row is
the digest of what it was computed from: an entry that is whole is right, in whichever file it is found.
"""

from __future__ import annotations

from hashlib import blake2b
from typing import Any, TypeAlias

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
