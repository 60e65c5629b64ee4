"""Modules written by hand to the contract of generated ones, for laws and motions that no built-in scene has.

A point of mass 1 kg on a line above a surface at x = 0, under a constant force and one contact law F(d, v, v0).
"""

from collections.abc import Callable

import casadi as ca

from hertzwerk.runtime.engine.model.generated_text import with_tables
from hertzwerk.runtime.engine.model.model import EngineModel

Law = Callable[..., object]


def point(
    law: Law | None = None,
    *,
    push: Law = lambda t, x, v: 0 * t,
    scales: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0),
    stored: Law | None = None,
    in_range: Law = lambda d: 1,
    floor: float = 1e-3,
) -> EngineModel:
    """law(d, v, v0) [N] with v the speed of approach; push(t, x, v) [N] everything else; scales of length, speed, force, energy."""
    module = with_tables(
        NAME="point", SOURCE="tests/runtime/handmade.py", SUMMARY="a point above a surface",
        PARAMETERS=(("x0", "m", 1.0, "start"), ("v0", "m/s", 0.0, "start"), ("approach_floor", "m/s", floor, "floor")),
        COORDINATES=(("path.travel", "m"),), SPEEDS=(("path.speed", "m/s"),), MEMORY=(("surface.dissipated", "J"),) if stored else (),
        LATCHES=(("surface.approach_speed", "m/s", 0),) if law else (), PAIRS=(("surface", "sphere_on_plane"),) if law else (),
        RELEASES=("force",) if law else (), DISSIPATED=(0,) if stored else (), CONSTANTS=(("one", "1"),), BODIES=("point",),
        constants=lambda p: ca.SX(1), start=lambda p: (p[0], p[1]),
        scales=lambda p: (scales[0], scales[1], ca.SX([scales[3]] if stored else []), ca.SX(list(scales))), coordinate_rates=lambda t, q, u, c: u,
        gaps=lambda t, q, u, c: (q, u) if law else (ca.SX(0, 1), ca.SX(0, 1)), gap_accelerations=lambda t, q, u, a, c: a if law else ca.SX(0, 1),
        applied=lambda t, q, u, c: push(t, q, u), accelerations=lambda t, q, u, f, c: (f, ca.SX(0, 1)),
        poses=lambda t, q, c: (ca.vertcat(q, 0, 0), ca.SX([1, 0, 0, 0, 1, 0, 0, 0, 1])), outputs=lambda t, q, u, c: ca.SX(0, 1),
    )  # fmt: skip
    if law:

        def contact_surface(t, q, u, z, m, c):
            force = ca.if_else(q < 0, law(-q, -u, m), 0)
            power = (force - ca.if_else(q < 0, law(-q, 0 * u, m), 0)) * -u if stored else ca.SX(0, 1)
            return force, power, force, ca.SX(0, 1), in_range(-q)

        module.contact_surface = contact_surface
    if stored:
        module.ledger = lambda t, q, u, reactions, c: 0 * t
        module.energy = lambda t, q, u, c: (u * u / 2, 0 * q, ca.if_else(q < 0, stored(-q), 0))
    return EngineModel(module)
