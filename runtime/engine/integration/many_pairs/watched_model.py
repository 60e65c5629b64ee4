"""Models whose steps have to keep to a list of near pairs, or to a box of coordinates."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from typing import Any

from hertzwerk.runtime.engine.model.model import EngineModel


class WatchedModel(EngineModel):
    """Model without some pairs of a whole one; its steps are watched where these may come near."""

    whole: EngineModel

    @abstractmethod
    def used(self, run: Mapping[str, Any], start: Mapping[str, Any], end: Mapping[str, Any]) -> Any:
        """Return which part of the room a step uses up; above 1 a pair left out might touch."""

    @abstractmethod
    def time_left(self, run: Mapping[str, Any], at: Mapping[str, Any]) -> tuple[Any, Any]:
        """Return the longest step [s] that keeps to the room that is left, and whether there may be more."""
