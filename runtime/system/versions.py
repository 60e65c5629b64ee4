"""Versions of the software that computes."""

from __future__ import annotations

import platform
from importlib import metadata


def versions() -> dict[str, str]:
    """Return the versions of the software that computed a run."""
    return {**{name: _version(name) for name in ("hertzwerk", "casadi", "numpy")}, "python": platform.python_version()}


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:  # run from the source tree
        return "not installed"
