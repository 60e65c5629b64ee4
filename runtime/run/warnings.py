"""Warnings about a run that do not stop it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from hertzwerk.runtime.integrate.loop.automatic import Code
from hertzwerk.runtime.model.model import Bound, Model
from hertzwerk.runtime.solution.history import constraint_force
from hertzwerk.runtime.solution.impacts import ApproachSpeeds, Track


def unchecked(model: Model) -> tuple[str, ...]:
    """Return the dimensionally inconsistent effects that a model runs unchecked."""
    return tuple(
        f"{effect} is dimensionally inconsistent and runs unchecked: {why}" for effect, why in model.module.UNCHECKED
    )


def open_forces(model: Model, bound: Bound, q: np.ndarray) -> Iterator[str]:
    """Yield a warning of redundant constraints at a start, whose forces the motion leaves undetermined."""
    if not model.nl:
        return
    from hertzwerk.runtime.start.assembly import undetermined  # a tree needs none

    names = [constraint_force(name) for name in undetermined(model, bound, q)]
    if names:
        yield f"redundant constraints leave these forces undetermined; those of least norm are given: {', '.join(names)}"


def approach_speeds(model: Model, bound: Bound) -> Iterator[ApproachSpeeds]:
    """Yield observers of the pairs whose compliant law has a speed limit [m/s] (material with a density)."""
    pairs = getattr(model.module, "SPEED_LIMITED", ())
    limits = model.evaluate("speed_limits", bound.p)[0] if pairs else ()
    for pair, limit in zip(pairs, limits, strict=True):
        yield ApproachSpeeds(float(limit), Track(model.pairs.index(pair)))


def too_fast(model: Model, speeds: Sequence[ApproachSpeeds]) -> Iterator[str]:
    """Yield a warning of contacts faster than their compliant law allows, of all pairs together."""
    over, count = sum(seen.over for seen in speeds), sum(seen.count for seen in speeds)
    if not over:
        return
    pairs = [model.pairs[seen.track.pair] for seen in speeds if seen.over]
    worst, limit = max(seen.worst for seen in speeds), min(seen.limit for seen in speeds if seen.over)
    yield (
        f"{over} of {count} impacts of {', '.join(pairs)} exceed the law's limit "
        f"v0 <= 1e-5*sqrt(E/rho) = {limit:.3g} m/s (worst {worst:.3g} m/s)"
    )


def floored(count: int, floor: float) -> Iterator[str]:
    """Yield a warning of contacts slower than the least latched approach speed [m/s]."""
    if not count:
        return
    contacts = "one contact began" if count == 1 else f"{count} contacts began"
    yield f"{contacts} slower than approach_floor = {floor:g} m/s, which the damping law took for the approach speed"


def uncompiled(code: Code | None) -> Iterator[str]:
    """Yield a warning where C would have saved time but the compiler failed."""
    if code is not None and code.compiler_failure:
        yield f"not compiled, which costs time and no accuracy: {code.compiler_failure}"
