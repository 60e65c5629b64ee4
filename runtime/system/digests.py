"""Records as JSON, with digests where they are read back: a damaged one is refused, not believed."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from hashlib import blake2b
from pathlib import Path
from typing import Any

DIGEST = "digest"


def finite(value: Any) -> Any:
    """Return plain data with None in place of numbers that are not finite, which JSON has not."""
    if isinstance(value, dict):
        return {key: finite(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def json_text(content: dict[str, Any]) -> str:
    """Return standard JSON; numbers that are not finite are null."""
    return json.dumps(finite(content), indent=2, allow_nan=False)


def record_text(content: dict[str, Any]) -> str:
    """Return the content of a file of JSON that is read back, with its digest."""
    return json_text(sealed(finite(content))) + "\n"


def sealed(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return plain data, as JSON has it, with the digest of the rest as its last entry."""
    plain = json.loads(json.dumps(record))
    return {**plain, DIGEST: _digest(plain)}


def is_sealed(record: Mapping[str, Any]) -> bool:
    """Return whether the digest of plain data is that of the rest."""
    return record.get(DIGEST) == _digest(record)


def read_sealed(path: Path) -> dict[str, Any]:
    """Return the record in a file; raises OSError, and ValueError for one that is not as it was written."""
    record = json.loads(path.read_text(encoding="utf-8"))
    if not isinstance(record, dict):
        raise ValueError(f"found {type(record).__name__}")
    if not is_sealed(record):
        raise ValueError("another content than was written: its digest does not fit")
    return record


def _digest(record: Mapping[str, Any]) -> str:
    rest = json.dumps({name: value for name, value in record.items() if name != DIGEST}, sort_keys=True)
    return blake2b(rest.encode(), digest_size=16).hexdigest()
