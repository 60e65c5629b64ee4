"""Oil films of contact pairs, which are neither contact nor flight."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel


def films(model: EngineModel) -> dict[str, str]:
    """Return the lubrication effect of each pair that has one."""
    oils = [(name, text) for name, kind, text in model.module.EFFECTS if kind == "lubrication"]
    return {
        pair: name
        for pair in model.pairs
        for name, text in oils
        if text.removesuffix(", UNCHECKED").endswith(f" at {pair}")
    }
