"""A ball between two walls: linear stiffness, Hunt-Crossley damping, no gravity."""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    X,
)
from hertzwerk.derive.laws import hunt_crossley, power

m = Parameter("mass", "kg", 1.6)
K = Parameter("stiffness", "N/m", 1e6)
e = Parameter("restitution", "1", 0.9)
v = Parameter("speed", "m/s", 10, "at the start, towards the right wall")
radius = Parameter("radius", "m", 0.1)
free = Parameter("gap", "m", 0.4, "from the ball in the middle to either wall")

ball = Body("ball", mass=m)
centre = ball.at(0, 0, 0)

mechanism = Mechanism(
    "ball_between_walls",
    joints=(Prismatic("track", GROUND, ball, axis=X),),
    pairs=(
        SphereOnPlane("left_wall", centre, radius, plane=GROUND.at(-radius - free, 0, 0), normal=X),
        SphereOnPlane("right_wall", centre, radius, plane=GROUND.at(radius + free, 0, 0), normal=-X),
    ),
)

scene = Scene(
    mechanism,
    effects=(
        Contact("left_wall", power(K, 1), hunt_crossley(e)),
        Contact("right_wall", power(K, 1), hunt_crossley(e)),
        EnergyLedger(),
    ),
    start=Start(speed={"track": v}),
    scales=Scales(length=v * sp.sqrt(m / K), speed=v),
    summary="ball between two walls",
)
