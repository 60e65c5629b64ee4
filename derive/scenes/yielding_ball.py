"""A hardened steel ball dropped on steel that yields: restitution by the dent, by Thornton's law.

Each impact meets the surface elsewhere. The bounces get lower until the ball no longer yields, and then bounces elastically.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Gravity,
    Material,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Y,
)
from hertzwerk.derive.laws import thornton

R = Parameter("radius", "mm", 25)
g = Parameter("gravity", "m/s^2", 9.81)
height = Parameter("drop_height", "m", 0.5, "gap at the start")
E, nu = Parameter("youngs_modulus", "GPa", 207), Parameter("poissons_ratio", "1", 0.3)
rho = Parameter("density", "kg/m^3", 7800)
steel = Material(E, nu, rho, yield_strength=Parameter("yield_strength", "MPa", 1000, "of ball and plane"))

ball = Body.sphere("ball", R, density=steel)
m = ball.mass

mechanism = Mechanism(
    "yielding_ball",
    joints=(Prismatic("vertical", GROUND, ball, axis=Y),),
    pairs=(SphereOnPlane("floor", sphere=ball.at(0, 0, 0), radius=R, plane=GROUND.at(0, 0, 0), normal=Y),),
)

v = sp.sqrt(2 * g * height)
K = sp.Rational(4, 3) * E / (2 * (1 - nu**2)) * sp.sqrt(R)

scene = Scene(
    mechanism,
    effects=(Gravity("gravity", g, direction=-Y), Contact("floor", thornton(steel, steel)), EnergyLedger()),
    start=Start(position={"vertical": R + height}),
    scales=Scales(length=(5 * m * v**2 / (4 * K)) ** sp.Rational(2, 5), speed=v),  # of an elastic impact
    summary="ball that yields when dropped on a plane",
)
