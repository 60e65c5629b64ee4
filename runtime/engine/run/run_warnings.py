"""Warnings about a run that do not stop it, but for those found in its steps (`step_warnings`).

The first sentence of each states the way out, and fits a line of a terminal; others are its details.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from hertzwerk.derive.common.grouping import some
from hertzwerk.runtime.engine.integration.loop.automatic_compilation import Code
from hertzwerk.runtime.engine.integration.step.layout import RELEASED
from hertzwerk.runtime.engine.model.model import BoundParameters, EngineModel
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.solution.history import History, constraint_force


@per_model
def unchecked(model: EngineModel) -> tuple[str, ...]:
    """Return what a model runs on purpose: inconsistent effects, velocities against its positions."""
    return (
        *(
            f"{effect} is dimensionally inconsistent and runs UNCHECKED. {why}"
            for effect, why in model.module.UNCHECKED
        ),
        *(
            f"{where} is taken as given, against the model's positions. It is {was_set}; it would be {follows}"
            for where, was_set, follows in model.module.CONTRADICTIONS
        ),
    )


def open_forces(model: EngineModel, bound: BoundParameters, q: np.ndarray) -> Iterator[str]:
    """Yield a warning of redundant constraints at a start, whose forces the motion leaves undetermined."""
    if not model.nl:
        return
    from hertzwerk.runtime.engine.start.assembly import undetermined  # a tree needs none

    names = [constraint_force(name) for name in undetermined(model, bound, q)]
    if names:
        yield f"redundant constraints leave forces undetermined: free a direction of a joint. Those of least norm are reported: {', '.join(names)}"


def too_fast(model: EngineModel, limits: np.ndarray, tally: Mapping[str, np.ndarray]) -> Iterator[str]:
    """Yield one warning of contacts faster than the limits [m/s] of their laws (materials with a density)."""
    if not tally["over"].any():
        return
    parts = (part.tolist() for part in (limits, *(tally[name] for name in ("over", "begun", "fastest"))))
    limited = [each for each in zip(model.pairs, *parts, strict=True) if each[1] < math.inf]
    pairs, least, over = zip(*(each[:3] for each in limited if each[2]), strict=True)
    *_, begun, fastest = zip(*limited, strict=True)
    yield (
        f"{some(pairs)}: impacts are too fast for the law; fit it to measured impacts. Surfaces may yield: {sum(over):.0f} of {sum(begun):.0f} "
        f"impacts of {', '.join(pairs)} exceed the law's limit of {min(least):.3g} m/s (worst {max(fastest):.3g} m/s)"
    )


def released(model: EngineModel, first: History) -> Iterator[str]:
    """Yield a warning of surfaces that overlap at the start while they open, where their law would pull."""
    for pair in (pair for pair, mode in zip(model.pairs, first.part("mode")[0], strict=True) if mode == RELEASED):
        yield (
            f"{pair} starts {first[f'{pair}.penetration'][0]:.3g} m deep and opening: start with a gap or at rest. Its law would pull, so "
            "no force acts until it closes again"
        )


def floored(count: int, floor: float) -> Iterator[str]:
    """Yield a warning of contacts slower than the least latched approach speed [m/s]."""
    if not count:
        return
    contacts = "one contact began" if count == 1 else f"{count} contacts began"
    yield f"{contacts} slower than approach_floor = {floor:g} m/s: lower it if they matter. The damping law used it as their approach speed"


def unsettled(count: int) -> Iterator[str]:
    """Yield a warning of instants at which sticking and slipping contacts were not determined."""
    if count:
        instants = "an instant" if count == 1 else f"{count} instants"
        yield (
            f"which contacts stick was not determined at {instants}: compare another accuracy. The search for sticking and slipping contacts "
            "did not converge, and the run continued with its last state, perhaps wrongly"
        )


def uncompiled(code: Code | None) -> Iterator[str]:
    """Yield a warning where C would have saved time but the compiler failed."""
    if code is not None and code.compiler_failure:
        yield f"not compiled: the run is slower, its results are the same. {code.compiler_failure}"
