"""Friction of contacts for pictures: its size from its power, its direction from the slip."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from hertzwerk.runtime.pictures.curves import Curves
from hertzwerk.runtime.pictures.draw.parts import Parts
from hertzwerk.runtime.pictures.draw.places import Array, Landmark, Places
from hertzwerk.runtime.solution.history import History

SLIDING = 1e-9  # of the fastest: slower surfaces have no direction


def friction_of(curves: Curves, pair: str) -> Array:
    """Return the size of the friction force of a pair over the curves' times [N].

    That of a set-valued law is a history, also while it sticks. Of others by the power that friction takes, over the
    sliding velocity; 0 where it does not slide, in a scene without a ledger, and in a run of which there are rows alone.
    """
    model, nothing = curves.run.model, np.zeros(len(curves.t))
    if f"{pair}.sliding_velocity" not in curves.run.names or not isinstance(curves.sampled, History):
        return nothing
    if is_set_valued(curves, pair):
        return np.abs(curves[f"{pair}.friction_force"])
    velocity = np.abs(curves[f"{pair}.sliding_velocity"])
    slides = velocity > SLIDING * np.max(velocity)
    entries = [
        f"{name}.dissipated"
        for name, kind, text in model.module.EFFECTS
        if kind == "friction" and text.endswith(f" at {pair}")
    ]
    rows = [model.memory.index(entry) for entry in entries if entry in model.memory]
    if not rows:
        return nothing
    powers = curves.sampled.map(f"contact_{pair}", "t q u z m")[1][:, rows].sum(axis=1)
    size: Array = np.divide(powers, velocity, out=nothing, where=slides)
    return np.maximum(size, 0.0)


def is_set_valued(curves: Curves, pair: str) -> bool:
    """Return whether the friction force of a pair, along its tangent, is a history of the run."""
    return f"{pair}.friction_force" in curves.run.names


def tangent_of(parts: Parts, marks: Sequence[Landmark], normal: Array) -> Array | None:
    """Return the tangent (3,) along which friction in plane motion counts; None in space."""
    for k in (2, 1, 0):
        if normal[k] == 0 and all(np.ptp(parts.positions[id(mark)][:, k]) == 0 for mark in marks[:2]):
            return np.cross(np.eye(3)[k], normal)
    return None


def slip_of(places: Places, marks: Sequence[Landmark], at: Array, j: int) -> Array:
    """Return the slip (3,) [m/s] of a pair at a point (3,): velocity of the first body less the second.

    At a row, by differences between the rows beside it.
    """
    before, after = max(j - 1, 0), min(j + 1, len(places.t) - 1)
    velocities = []
    for mark in marks[:2]:
        body = places.bodies.index(mark.body)
        within = places.rotations[j, body].T @ (at - places.origins[j, body])
        ends = [places.origins[k, body] + places.rotations[k, body] @ within for k in (before, after)]
        velocities.append((ends[1] - ends[0]) / max(places.t[after] - places.t[before], 1e-300))
    slip: Array = velocities[0] - velocities[1]
    return slip
