"""Housner's block, let go from a tilt, which rocks from corner to corner.

Its natural description is the rigid limit. Data of our choice.
The corners hardly rebound: restitution 0.001 by the exact factor of Hunt and Crossley's damping.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    BoxOnPlane,
    Contact,
    EnergyLedger,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Planar,
    Scales,
    Scene,
    Start,
    Y,
    Z,
)
from hertzwerk.derive.laws import coulomb, exact, power

width, height = Parameter("width", "m", 0.5), Parameter("height", "m", 2)
m, g = Parameter("mass", "kg", 1000), Parameter("gravity", "m/s^2", 9.81)
tilt = Parameter("tilt", "rad", 0.1, "at the start, on the left corner")
K, mu = Parameter("stiffness", "N/m", 1e9, "of a corner"), Parameter("friction", "1", 0.8)

block = Body("block", m, m * (width**2 + height**2) / 12)

scene = Scene(
    Mechanism(
        "housner_block",
        joints=(Planar("move", GROUND, block, normal=Z),),
        pairs=(BoxOnPlane("foot", block.at(0, 0, 0), width, height, GROUND.at(0, 0, 0), Y),),
    ),
    effects=(
        Gravity("gravity", g, direction=-Y),
        Contact("foot", power(K, 1), exact(Parameter("restitution", "1", 0.001))),
        Friction("foot_friction", "foot", coulomb(mu, mu)),
        EnergyLedger(),
    ),
    start=Start(position={"move.angle": tilt, "move.y": height / 2 * sp.cos(tilt) + width / 2 * sp.sin(tilt)}),
    scales=Scales(length=Parameter("size", "mm", 1), speed=Parameter("pace", "m/s", 0.1), arm=width),
    summary="block that rocks from corner to corner",
)
