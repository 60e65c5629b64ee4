"""Read TOML files of users in bounded time, for derivation and runtime."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError, unreadable

MAX_BYTES = 100_000
"""Largest file: the time of `tomllib` grows with the square of a dotted key's length."""


def read_toml(path: str | Path, content: str) -> dict[str, Any]:
    """Tables of a file that should have `content` (a phrase). Raises InputError if it cannot be read."""
    expected = f"a TOML file with {content}"
    raw = read_at_most(MAX_BYTES, path, expected, "Split it.")
    try:
        return tomllib.loads(raw.decode())
    except RecursionError:
        actual = "tables or arrays nested too deeply"
    except ValueError as error:  # syntax, encoding, numbers with thousands of digits
        actual = str(error)
    raise InputError(str(path), [Fault("file", actual, expected)])


def read_at_most(most: int, path: str | Path, expected: str, remedy: str = "") -> bytes:
    """Bytes of a file of at most so many. Raises InputError."""
    try:
        with Path(path).open("rb") as file:
            raw = file.read(most + 1)
    except OSError as error:
        raise InputError(str(path), [unreadable(path, error, expected)]) from error
    if len(raw) > most:
        raise InputError(str(path), [Fault("file", f"more than {most // 1000} kB", expected, remedy)])
    return raw
