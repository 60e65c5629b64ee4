"""TOML files of the user's, read in bounded time; imports nothing heavy, so both sides read theirs alike."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from hertzwerk.derive.faults import Fault, InputError, unreadable

MAX_BYTES = 100_000
"""Of a file: `tomllib` takes time by the square of a dotted key's length."""


def read_toml(path: str | Path, content: str) -> dict[str, Any]:
    """The tables of a file, which should hold `content`. Raises InputError for whatever keeps it from being read."""
    expected = f"a TOML file with {content}"
    try:
        with Path(path).open("rb") as file:
            raw = file.read(MAX_BYTES + 1)
        if len(raw) > MAX_BYTES:
            raise InputError(str(path), [Fault("file", f"more than {MAX_BYTES // 1000} kB", expected, "Split it.")])
        return tomllib.loads(raw.decode())
    except OSError as error:
        raise InputError(str(path), [unreadable(path, error, expected)]) from error
    except RecursionError:
        found = "tables or arrays nested too deeply"
    except InputError:
        raise
    except ValueError as error:  # of syntax, of encoding, of numbers with thousands of digits
        found = str(error)
    raise InputError(str(path), [Fault("file", found, expected)])
