"""State of the engine that a run can be continued from."""

from __future__ import annotations

import hashlib
import linecache
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.integrate.loop.chunk import Resume
from hertzwerk.runtime.integrate.step.layout import layouts
from hertzwerk.runtime.integrate.tableaux.methods import IN_GRAPH
from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.chunk import Ending
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.solution import Solution

# How a run may have ended that goes on where it is asked for more: any other would end so again.
CONTINUABLE = (
    "finished",
    "interrupted",
    "wall_time_limit",
    "too_many_steps",
    "exception",
    "event_limit",
    "accuracy_unreachable",
    "energy_not_closed",
)


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


def checkpoint_of(model: Model, ending: Ending, initial: Mapping[str, Value]) -> Checkpoint | None:
    """Return the checkpoint of a run; None where the method does not expose its state."""
    if ending.resume is None:
        return None
    return Checkpoint(ending.resume, dict(layouts(model).state.sizes), digest(model), dict(initial))


@per_model
def digest(model: Model) -> str:
    """Return the digest of a generated module's text."""
    file = getattr(model.module, "__file__", None) or ""
    return hashlib.sha256("".join(linecache.getlines(file)).encode()).hexdigest()[:32]


def parameters_of(run: Solution, model: Model) -> dict[str, tuple[float, str]]:
    """Return the parameters of a run that differ from the model's own."""
    ports = model.parameters
    return {
        name: (value, unit)
        for name, (value, unit) in run.parameters.items()
        if name not in ports or (value, unit) != (ports[name].default, ports[name].unit)
    }


def resumable(run: Solution, model: Model, *, saved: bool) -> Checkpoint:
    """Return the checkpoint of a run; raises InputError where it cannot be continued."""
    faults, kept = [], run.checkpoint
    if saved:
        remedy = f'name it: model=load("{run.model.name}")'
        faults.append(Fault("model", "a saved run, which has no functions", "the model that was run", remedy))
    if run.outcome.name not in CONTINUABLE:
        expected = f"one of {', '.join(CONTINUABLE)}"
        faults.append(
            Fault("outcome", run.outcome.name, expected, "it would end so again: change the model or its parameters")
        )
    if kept is None:
        expected = f"a run of the engine itself: {', '.join(IN_GRAPH)}"
        faults.append(Fault("method", f"{run.method}, or a run without a checkpoint", expected))
    elif not saved:
        sizes = dict(layouts(model).state.sizes)
        if kept.model != digest(model) or kept.layout != sizes or kept.resume.state.shape != (sum(sizes.values()),):
            expected = "the model that was run, derived by the same version"
            faults.append(Fault("model", f"{model.name} with other equations", expected, "run it anew from its start"))
    if faults or kept is None:
        raise InputError(f"going on with {run.model.name}", faults)
    return kept
