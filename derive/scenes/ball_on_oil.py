"""A steel ball thrown at an oiled plane: it squeezes the film out and breaks through to dry contact.

The film ruptures as the ball leaves. Speed and time of the dry impact are integrals of Reynolds' film. Data of our choice.
"""

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Lubrication,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    X,
)
from hertzwerk.derive.laws import flores, power, sphere_film

m = Parameter("mass", "kg", 0.0327)
R = Parameter("radius", "mm", 10)
v = Parameter("speed", "m/s", 0.3, "of the ball in the oil, towards the plane")
height = Parameter("film_height", "mm", 0.5, "gap at the start")

ball = Body("ball", m)

mechanism = Mechanism(
    "ball_on_oil",
    joints=(Prismatic("path", GROUND, ball, axis=X),),
    pairs=(SphereOnPlane("wall", sphere=ball.at(0, 0, 0), radius=R, plane=GROUND.at(0, 0, 0), normal=X),),
)

scene = Scene(
    mechanism,
    effects=(
        Contact("wall", power(Parameter("stiffness", "N/m^1.5", 1.5e10), 1.5), flores(Parameter("restitution", "1", 0.9))),
        Lubrication("oil", "wall", sphere_film(Parameter("viscosity", "Pa s", 0.2)), Parameter("boundary_layer", "um", 1), cavitation=True),
        EnergyLedger(),
    ),
    start=Start(position={"path": R + height}, speed={"path": -v}),
    scales=Scales(length=height, speed=v),
    summary="ball through an oil film onto a plane",
)  # fmt: skip
