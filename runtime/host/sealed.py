"""Digests of records that are kept as JSON and read back: a damaged one is refused, not believed."""

from __future__ import annotations

import json
from collections.abc import Mapping
from hashlib import blake2b
from typing import Any

DIGEST = "digest"


def sealed(record: Mapping[str, Any]) -> dict[str, Any]:
    """Return plain data with the digest of the rest as its last entry."""
    return {**record, DIGEST: _digest(record)}


def is_sealed(record: Mapping[str, Any]) -> bool:
    """Return whether the digest of plain data is that of the rest."""
    return record.get(DIGEST) == _digest(record)


def _digest(record: Mapping[str, Any]) -> str:
    rest = json.dumps({name: value for name, value in record.items() if name != DIGEST}, sort_keys=True)
    return blake2b(rest.encode(), digest_size=16).hexdigest()
