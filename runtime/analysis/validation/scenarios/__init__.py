"""Numbers and checks of the built-in scenarios, one TOML file each.

`read` is all that a run needs: it parses, and does not validate. The files here are validated by the tests, others by `validate.scenario`.
"""

from __future__ import annotations

import tomllib
from importlib import resources
from typing import Any


def names() -> tuple[str, ...]:
    """Return the names of the built-in scenarios, sorted."""
    return tuple(
        sorted(entry.name[:-5] for entry in resources.files(__name__).iterdir() if entry.name.endswith(".toml"))
    )


def read(name: str) -> dict[str, Any]:
    """Return the content of a built-in scenario; empty for any other name, as that of a user's file."""
    if name not in names():
        return {}
    return tomllib.loads((resources.files(__name__) / f"{name}.toml").read_text(encoding="utf-8"))
