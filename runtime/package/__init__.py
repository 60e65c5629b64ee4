"""hertzwerk: `from hertzwerk import Scene, load, simulate`; the rest is in `derive` and `runtime`.

This file is installed as `hertzwerk/__init__.py` (package-dir in pyproject.toml), so no plain folder of that name
shadows the package.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from hertzwerk.derive.declare.scene import Scene
    from hertzwerk.derive.faults import InputError
    from hertzwerk.runtime.loading import load
    from hertzwerk.runtime.simulation import simulate

    __version__: str

_PLACES = {
    "InputError": "hertzwerk.derive.faults",
    "Scene": "hertzwerk.derive.declare.scene",
    "load": "hertzwerk.runtime.loading",
    "simulate": "hertzwerk.runtime.simulation",
}

__all__ = ["InputError", "Scene", "__version__", "load", "simulate"]


def __getattr__(name: str) -> Any:
    """Return a name from its module, imported on first use (PEP 562)."""
    value: Any
    if name == "__version__":
        from importlib.metadata import version

        value = version("hertzwerk")
    elif name in _PLACES:
        from importlib import import_module

        value = getattr(import_module(_PLACES[name]), name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
