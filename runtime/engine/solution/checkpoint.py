"""State of the engine that a run can be continued from."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from hertzwerk.runtime.engine.integration.loop.chunk import Ending, Resume
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.model.generated_text import text_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.model.signal import digest_of


@dataclass(frozen=True)
class Checkpoint:
    """State that a longer run continues from, with the identity of the model.

    resume   state of the engine (ns,): modes, latched memory, the step to try next, the choice of method, counters
    layout   names and sizes of its parts, in order
    model    digest of the generated module
    initial  the initial states that were given
    """

    resume: Resume
    layout: Mapping[str, int]
    model: str
    initial: Mapping[str, Value]

    def about(self) -> dict[str, Any]:
        """Everything but the state, as plain numbers and texts."""
        return {
            "whole": self.resume.with_choice,
            "layout": dict(self.layout),
            "model": self.model,
            "initial": dict(self.initial),
        }

    @classmethod
    def saved(cls, about: Mapping[str, Any], state: np.ndarray) -> Checkpoint:
        """Restore the checkpoint of a saved run."""
        initial = {name: tuple(value) if isinstance(value, list) else value for name, value in about["initial"].items()}
        return cls(Resume(state, bool(about["whole"])), dict(about["layout"]), about["model"], initial)


def checkpoint_of(model: EngineModel, ending: Ending, initial: Mapping[str, Value]) -> Checkpoint | None:
    """Return the checkpoint of a run; None where the method does not expose its state."""
    if ending.resume is None:
        return None
    return Checkpoint(ending.resume, layouts(model).state.sizes, digest(model), dict(initial))


def digest(model: EngineModel) -> str:
    """Return the digest of a generated module's text, and of the values of its inputs."""
    return "-".join(filter(None, (_text_digest(model), digest_of(model.signals)[:32])))


@per_model
def _text_digest(model: EngineModel) -> str:
    return hashlib.sha256(text_of(model.module).encode()).hexdigest()[:32]
