"""Models for statics: by the joints' coordinates, with drives held where they are at a time."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.loading import load
from hertzwerk.runtime.model import build
from hertzwerk.runtime.model.per_model import per_model
from hertzwerk.runtime.start.assembly import closed_near, journals
from hertzwerk.runtime.start.start_values import start_of
from hertzwerk.runtime.statics.balance import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.model.binding import Value
    from hertzwerk.runtime.model.model import Bound, Model

FOLLOWED = 100  # steps in which a start is followed to a later time
TIME = "held_time"  # parameter: time at whose positions the drives are held


@per_model
def held(model: Model) -> Model:
    """Return a model for statics: itself, or its scene by the joints' coordinates with every drive held.

    A held drive stands where it would be at the parameter `held_time`. Raises InputError for a model without its
    scene, as a saved run has it.
    """
    drives = drives_of(model)
    if not drives and model.joints is model:
        return model
    if model.declaration is None:
        found = "a model without its scene, as a saved run has it"
        raise InputError(model.name, [Fault("statics", found, "a model that `load` returned")])
    scene = model.declaration.scene()
    return load(replace(build.held(scene) if drives else scene, coordinates="tree"))


def drives_of(model: Model) -> tuple[str, ...]:
    """Return the names of a model's drives."""
    return tuple(name for name, kind, _ in model.module.EFFECTS if kind == "drive")


def parameters_at(model: Model, held: Model, parameters: Mapping[str, Value], t: float) -> dict[str, Value]:
    """Return parameters of a model as those of its held one at a time t [s]; raises InputError.

    A drive whose speed or acceleration is given is integrated: where it is at a later time is not known beforehand.
    """
    integrated = [name for name in model.coordinates if name not in held.coordinates] if t and held is not model else []
    if integrated:
        found = f"t = {t:g} s, for which {', '.join(integrated)} would have to be integrated"
        raise InputError(model.name, [Fault("at", found, "0 s, or drives whose position is given")])
    known = {
        name: value for name, value in parameters.items() if name in held.parameters or name not in model.parameters
    }
    return {**known, TIME: (t, "s")} if TIME in held.parameters else known


def start_at(
    model: Model, held: Model, given: Mapping[str, Value], initial: Mapping[str, Value], t: float
) -> tuple[Bound, Array]:
    """Return the numbers at a time t [s], and a position q (nq,) to search from; raises InputError.

    The scene states its start at t = 0: closed loops and journals are followed from there, within a period, unless
    something is given for the time itself.
    """
    if held is model or not t or initial or not (held.nl or journals(held)):
        bound, q, _ = start_of(held, given, initial)
        return bound, q
    bound, q, _ = start_of(held, {**given, TIME: (0.0, "s")}, initial)
    period = model.period(model.bind({name: value for name, value in given.items() if name in model.parameters}))
    for part in np.linspace(0, 1, FOLLOWED + 1)[1:]:
        there = held.bind({**given, TIME: (part * (t % period if period else t), "s")})
        q = closed_near(held, there, q, t, centred=bool(journals(held)))
    return held.bind(given), q


def drive_units(held: Model) -> dict[str, str]:
    """Return the unit of what every drive of a held model supplies, in the order of the model's reactions."""
    if not drives_of(held) or held.declaration is None:
        return {}
    scene: Any = held.declaration.scene()
    closing = scene.prescribed
    freedoms = [*(freedom for freedom in scene.mechanism.freedoms if freedom not in closing), *closing]
    force = {"rad": "N m", "m": "N"}
    driven = scene.driven
    return {driven[freedom.key].name: force[freedom.units[0]] for freedom in freedoms if freedom.key in driven}
