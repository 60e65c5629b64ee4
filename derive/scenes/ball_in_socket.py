"""A ball that swings at the bottom of a hollow sphere under its weight.

It is a spherical pendulum whose length is the clearance plus the penetration. Closed forms: penetration at rest (m
g/K)^(2/3); small oscillation with the period 2 pi sqrt((clearance + penetration)/g). Data: our choice.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    BallInSocket,
    Body,
    Contact,
    EnergyLedger,
    Free,
    Gravity,
    Mechanism,
    Parameter,
    Scales,
    Scene,
    Start,
    Z,
)
from hertzwerk.derive.laws import power

m = Parameter("mass", "kg", 0.5)
g = Parameter("gravity", "m/s^2", 9.81)
R = Parameter("socket_radius", "mm", 25)
c = Parameter("clearance", "mm", 5, "socket radius minus ball radius")
K = Parameter("stiffness", "N/m^1.5", 1e7, "of a soft lining")
angle = Parameter("start_angle", "rad", 0.05, "from the lowest position, towards x")

ball = Body("ball", mass=m, inertia=(2 * m * (R - c) ** 2 / 5,) * 3)
reach = c + (m * g / K) ** sp.Rational(2, 3)

mechanism = Mechanism(
    "ball_in_socket",
    joints=(Free("float", GROUND, ball),),
    pairs=(BallInSocket("ball_joint", ball=ball.at(0, 0, 0), socket=GROUND.at(0, 0, 0), socket_radius=R, clearance=c),),
)

scene = Scene(
    mechanism,
    effects=(Gravity("gravity", g, direction=-Z), Contact("ball_joint", power(K, sp.Rational(3, 2))), EnergyLedger()),
    start=Start(position={"float.x": reach * sp.sin(angle), "float.z": -reach * sp.cos(angle)}),
    scales=Scales(length=reach - c, speed=angle * sp.sqrt(g * c), arm=R),
    summary="ball swinging at the bottom of a socket",
)
