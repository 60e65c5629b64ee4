"""A ball dropped on a plane: Hertz's law with given stiffness, damping of Flores et al."""

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
from hertzwerk.derive.laws import flores, power

# Numbers with units. Change any of them for one run: --set drop_height="0.5 m".
m = Parameter("mass", "kg", 1)
g = Parameter("gravity", "m/s^2", 9.81)
radius = Parameter("radius", "m", 0.1)
height = Parameter("drop_height", "m", 1, "gap at the start")
n = Parameter("exponent", "1", 1.5, "exponent of the force law")
K = Parameter("stiffness", "N/m^exponent", 2.4e10)

ball = Body("ball", mass=m)

# A joint gives the ball its coordinate; the two surfaces of a pair may touch, and separate again.
mechanism = Mechanism(
    "bouncing_ball",
    joints=(Prismatic("vertical", GROUND, ball, axis=Y),),
    pairs=(SphereOnPlane("floor", sphere=ball.at(0, 0, 0), radius=radius, plane=GROUND.at(0, 0, 0), normal=Y),),
)

# The speed at the first impact.
v = sp.sqrt(2 * g * height)

# Everything that acts. An effect that is not listed here enters no equation.
scene = Scene(
    mechanism,
    effects=(
        Gravity("gravity", g, direction=-Y),
        Contact("floor", power(K, n), flores(Parameter("restitution", "1", 0.9))),
        EnergyLedger(),
    ),
    # Where it starts: positions and speeds of joints by their names.
    start=Start(position={"vertical": radius + height}),
    # Typical sizes, by which errors count: the penetration of an elastic impact at the speed of the fall.
    scales=Scales(length=((n + 1) * m * v**2 / (2 * K)) ** (1 / (n + 1)), speed=v),
    summary="ball dropped on a plane",
)
