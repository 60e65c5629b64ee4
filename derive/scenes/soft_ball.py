"""A soft ball dropped on a plane, undamped unless a law is given.

Gravity adds 7.9e-4 to the penetration of the first impact.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Gravity,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Y,
)
from hertzwerk.derive.laws import power

m = Parameter("mass", "kg", 1)
g = Parameter("gravity", "m/s^2", 9.81)
radius = Parameter("radius", "m", 0.1)
height = Parameter("drop_height", "m", 1, "gap at the start")
K = Parameter("stiffness", "N/m^1.5", 1.4e8)

ball = Body("ball", mass=m)

mechanism = Mechanism(
    "soft_ball",
    joints=(Prismatic("vertical", GROUND, ball, axis=Y),),
    pairs=(SphereOnPlane("floor", sphere=ball.at(0, 0, 0), radius=radius, plane=GROUND.at(0, 0, 0), normal=Y),),
)

v = sp.sqrt(2 * g * height)

scene = Scene(
    mechanism,
    effects=(Gravity("gravity", g, direction=-Y), Contact("floor", power(K, sp.Rational(3, 2))), EnergyLedger()),
    start=Start(position={"vertical": radius + height}),
    scales=Scales(length=(5 * m * v**2 / (4 * K)) ** sp.Rational(2, 5), speed=v),
    summary="soft elastic ball dropped on a plane",
)
