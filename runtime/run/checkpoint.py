"""Going on from the end of a run: what of its engine is kept for that, and the run that begins there."""

from __future__ import annotations

import hashlib
import linecache
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.integrate.loop.chunk import Resume
from hertzwerk.runtime.integrate.step.layout import layouts
from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.run.request import MAX_EVENTS, MAX_STEPS, Compiled, Settings, read

if TYPE_CHECKING:
    from hertzwerk.runtime.integrate.loop.chunk import Ending
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.run.output_times import Output
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


def continued(
    run: Solution,
    duration: str | float | None = None,
    *,
    model: Model | None = None,
    output: Output = "steps",
    compiled: Compiled = "auto",
    max_steps: int = MAX_STEPS,
    max_events: int = MAX_EVENTS,
    wall_time: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> Solution:
    """Go on from the end of a run, with its model, parameters, start, method and tolerance, as if it had not ended there.

    duration    of the whole motion from its start, longer than what the run reached; by default what the run was asked for
    model    the model of a saved run, which has no functions: load("slider_crank")
    output    as of `simulate`: of a grid over the whole motion the part that is left
    max_steps, max_events, wall_time    of this run alone

    What is returned begins at `t_start`, the last step that did not depend on where the run before ended: a step or two before that end, whose last
    ones were cut to arrive there. Where steps are kept, those of the run before with t < t_start and these are bitwise those of one run of that
    duration at that tolerance; steps as long as a tenth of the shorter duration, the longest in contact, are the exception. Impacts, energy
    balance, statistics and averages are of this part; a contact that is under way where it begins is listed in both, here from there on. There is
    no estimate of the error, neither of the part nor of the whole: it would take the runs that checked the one before as well.

    Raises InputError, with every fault.
    """
    from hertzwerk.runtime.integrate.loop.automatic import Gear
    from hertzwerk.runtime.run.engine import engine_for
    from hertzwerk.runtime.run.single_run import SingleRun
    from hertzwerk.runtime.simulation import solution_of

    began = time.perf_counter()
    live = model if model is not None else run.model
    kept = _going_on(run, live, saved=model is None and run.history.integrator is None)
    whole = run.duration if duration is None else duration
    settings = Settings(whole, None, run.tolerance, run.method, compiled, output, max_steps, max_events, wall_time)
    given, times = read(live, settings, parameters_of(run, live), kept.initial)
    start = float(kept.resume.state[0])
    if given.seconds <= run.t_end:
        expected = f"more than the {run.t_end:g} s that the run reached"
        raise InputError(live.name, [Fault("duration", f"{given.seconds:g} s", expected, "it is of the whole motion")])
    engine = engine_for(live.without_redundancy(given.dependent), run.method, compiled)
    gear = Gear(engine.code, compiled=compiled is True, changes=compiled == "auto") if engine.code else None
    part = SingleRun(live, run.method, engine, given, settings.limits, gear, kept.resume)
    build_s = time.perf_counter() - began
    rest = None if times is None else times[times >= start]
    found = solution_of(part, part.trace(run.tolerance, run.scales, rest, progress=progress), run.scales, build_s)
    before = "" if run.error is None else f"; that of the run before was {run.error} at its end"
    told = f"goes on from t = {start:.9g} s at the tolerance {run.tolerance:.2g} of the run before, without an estimate of its error{before}"
    return replace(found, warnings=(*found.warnings, told))


def parameters_of(run: Solution, model: Model) -> dict[str, tuple[float, str]]:
    """The parameters of a run that are not the model's own."""
    ports = model.parameters
    return {
        name: (value, unit)
        for name, (value, unit) in run.parameters.items()
        if name not in ports or (value, unit) != (ports[name].default, ports[name].unit)
    }


def _going_on(run: Solution, model: Model, *, saved: bool) -> Checkpoint:
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
