"""A block that smoothed friction brings to rest on an incline, declared and derived as a user would."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

SLOPE, FRICTION, LAYER, STIFFNESS = math.atan(0.15), 0.3, 1e-7, 1e8  # rad, 1, m/s, N/m^1.5
BLOCK, CARRIAGE, GRAVITY, START = 1.0, 0.25, 9.81, 1.0  # kg, kg, m/s^2, m/s downhill
PRESS = BLOCK * GRAVITY * math.cos(SLOPE)  # N; the carriage is guided by the ramp: its weight does not press
PULL = (BLOCK + CARRIAGE) * GRAVITY * math.sin(SLOPE)  # N, downhill
BRAKING = (FRICTION * PRESS - PULL) / (BLOCK + CARRIAGE)  # m/s^2 while the block slides
CREEP = LAYER * math.atanh(PULL / (FRICTION * PRESS))  # m/s, at which smoothed friction holds it


@cache
def incline() -> Any:
    """The model: on a ramp too heavy to move a carriage slides along and guides the block across, pressed onto the ramp by its weight."""
    from hertzwerk.derive import (
        GROUND,
        Body,
        Contact,
        Friction,
        Gravity,
        Mechanism,
        Parameter,
        Prismatic,
        Revolute,
        Scales,
        Scene,
        SphereOnPlane,
        Start,
        X,
        Y,
        Z,
    )
    from hertzwerk.derive.laws import hunt_crossley, power, smooth_coulomb
    from hertzwerk.runtime.engine.model.build import build
    from hertzwerk.runtime.engine.model.model import EngineModel

    radius, speed = Parameter("radius", "m", 0.1), Parameter("speed", "m/s", START)
    depth = Parameter("static_depth", "m", (PRESS / STIFFNESS) ** (2 / 3))
    ramp = Body("ramp", mass=Parameter("ramp_mass", "kg", 1), inertia=Parameter("ramp_inertia", "kg m^2", 1e16))
    carriage = Body(
        "carriage", mass=Parameter("carriage_mass", "kg", CARRIAGE), inertia=Parameter("inertia", "kg m^2", 1)
    )
    block = Body("block", mass=Parameter("mass", "kg", BLOCK), inertia=carriage.inertia)
    rubbing = smooth_coulomb(
        Parameter("friction_coefficient", "1", FRICTION), Parameter("friction_speed", "m/s", LAYER)
    )
    damped = hunt_crossley(Parameter("restitution", "1", 0.5))
    scene = Scene(
        Mechanism(
            "incline",
            joints=(
                Revolute("tilt", GROUND, ramp, axis=Z),
                Prismatic("along", ramp, carriage, axis=X),
                Prismatic("up", carriage, block, axis=Y),
            ),
            pairs=(SphereOnPlane("floor", sphere=block.at(0, 0, 0), radius=radius, plane=ramp.at(0, 0, 0), normal=Y),),
        ),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", GRAVITY), direction=-Y),
            Contact("floor", power(Parameter("stiffness", "N/m^1.5", STIFFNESS), 1.5), damped),
            Friction("floor_friction", pair="floor", law=rubbing),
        ),
        start=Start(position={"tilt": -Parameter("slope", "rad", SLOPE), "up": radius - depth}, speed={"along": speed}),
        scales=Scales(length=Parameter("length_scale", "m", 0.1), speed=speed, arm=radius),
    )
    return EngineModel(build(scene))
