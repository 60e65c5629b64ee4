"""The state of the engine that a run is continued from."""

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
from hertzwerk.runtime.model.binding import Value

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.chunk import Ending
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.solution import Solution

# How a run may have ended that goes on where it is asked for more: any other would end so again.
GOES_ON = (
    "finished",
    "interrupted",
    "wall_time_limit",
    "too_many_steps",
    "event_limit",
    "accuracy_unreachable",
    "energy_not_closed",
)


@dataclass(frozen=True)
class Checkpoint:
    """What a longer run goes on from, and what tells one model's runs apart.

    resume   its state, of the engine (ns,): modes, latched memory, the step to try next and what steps are chosen by, counters
    layout   names and sizes of its parts, in order
    model    digest of the generated module
    initial  the initial states that were given
    """

    resume: Resume
    layout: Mapping[str, int]
    model: str
    initial: Mapping[str, Value]

    def about(self) -> dict[str, Any]:
        """Plain numbers and texts: everything but the state."""
        return {
            "whole": self.resume.whole,
            "layout": dict(self.layout),
            "model": self.model,
            "initial": dict(self.initial),
        }

    @classmethod
    def saved(cls, about: Mapping[str, Any], state: np.ndarray) -> Checkpoint:
        """That of a run that was saved."""
        initial = {name: tuple(value) if isinstance(value, list) else value for name, value in about["initial"].items()}
        return cls(Resume(state, bool(about["whole"])), dict(about["layout"]), about["model"], initial)


def checkpoint_of(model: Model, ending: Ending, initial: Mapping[str, Value]) -> Checkpoint | None:
    """The checkpoint of a run that ended so; None where the method keeps its state to itself."""
    if ending.resume is None:
        return None
    return Checkpoint(ending.resume, dict(layouts(model).state.sizes), digest(model), dict(initial))


def digest(model: Model) -> str:
    """Tells the text of a generated module from any other."""
    file = getattr(model.module, "__file__", None) or ""
    return hashlib.sha256("".join(linecache.getlines(file)).encode()).hexdigest()[:32]


def parameters_of(run: Solution, model: Model) -> dict[str, tuple[float, str]]:
    """The parameters of a run that are not the model's own."""
    ports = model.parameters
    return {
        name: (value, unit)
        for name, (value, unit) in run.parameters.items()
        if name not in ports or (value, unit) != (ports[name].default, ports[name].unit)
    }


def resumable(run: Solution, model: Model, *, saved: bool) -> Checkpoint:
    """The checkpoint of a run; raises InputError where nothing goes on from it."""
    faults, kept = [], run.checkpoint
    if saved:
        remedy = f'name it: model=load("{run.model.name}")'
        faults.append(Fault("model", "a saved run, which has no functions", "the model that was run", remedy))
    if run.outcome.name not in GOES_ON:
        expected = f"one of {', '.join(GOES_ON)}"
        faults.append(
            Fault("outcome", run.outcome.name, expected, "it would end so again: change the model or its parameters")
        )
    if kept is None:
        expected = "a run of the engine itself: dop853, dopri5, esdirk, rodas, auto"
        faults.append(Fault("method", f"{run.method}, or a run without a checkpoint", expected))
    elif not saved:
        sizes = dict(layouts(model).state.sizes)
        if kept.model != digest(model) or kept.layout != sizes or kept.resume.state.shape != (sum(sizes.values()),):
            expected = "the model that was run, derived by the same version"
            faults.append(Fault("model", f"{model.name} with other equations", expected, "run it anew from its start"))
    if faults or kept is None:
        raise InputError(f"going on with {run.model.name}", faults)
    return kept
