"""Spatial slider-crank with clearance in the spherical joint of crank and rod, at constant speed.

Lengths, masses and inertias: the spatial slider-crank of Haug, Computer-Aided Kinematics and Dynamics of Mechanical
Systems (1989), 12.2, as in two public codes that agree (grade B). Its crank turns about X, 0.1 m beside and 0.12 m
above the line the slider moves along. Speed, ball and material are our choice.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    BallInSocket,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Gravity,
    Material,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    Start,
    Universal,
    X,
    Y,
    Z,
)
from hertzwerk.derive.laws import flores, hertz_point

r = Parameter("crank_length", "m", 0.08)
l = Parameter("rod_length", "m", 0.3)
beside, above = Parameter("bearing_y", "m", 0.1), Parameter("bearing_z", "m", 0.12)
w = Parameter("crank_speed", "rad/s", 60, "constant speed of the crank")
R = Parameter("socket_radius", "mm", 10)
c = Parameter("clearance", "mm", 0.2, "socket radius minus ball radius")
steel = Material(Parameter("youngs_modulus", "GPa", 207), Parameter("poissons_ratio", "1", 0.3),
                 Parameter("density", "kg/m^3", 7800, "of the steel"))  # fmt: skip

crank = Body(
    "crank",
    mass=Parameter("crank_mass", "kg", 0.12),
    inertia=(
        Parameter("crank_inertia_x", "kg m^2", 1e-4),
        Parameter("crank_inertia_y", "kg m^2", 1e-5),
        Parameter("crank_inertia_z", "kg m^2", 1e-4),
    ),
)
rod = Body(
    "rod",
    mass=Parameter("rod_mass", "kg", 0.5),
    inertia=(
        Parameter("rod_inertia_x", "kg m^2", 4e-4),
        Parameter("rod_inertia_y", "kg m^2", 4e-3),
        Parameter("rod_inertia_z", "kg m^2", 4e-3),
    ),
    centre=(-l / 2, 0, 0),
)
slider = Body("slider", mass=Parameter("slider_mass", "kg", 2.0))

# At the start the crank points along Z, its end at (0, bearing_y, bearing_z + r) moves at -r w along Y, and the slider is at (way, 0, 0).
height = above + r
way = sp.sqrt(l**2 - beside**2 - height**2)

mechanism = Mechanism(
    "spatial_slider_crank",
    joints=(
        Revolute("main_bearing", GROUND.at(0, beside, above), crank, axis=X),
        Prismatic("guide", GROUND, slider, axis=X),
        Universal("slider_joint", slider, rod, first=Z, second=Y),
    ),
    pairs=(BallInSocket("crank_ball", ball=rod.at(-l, 0, 0), socket=crank.at(0, 0, r), socket_radius=R, clearance=c),),
)

scene = Scene(
    mechanism,
    effects=(
        ConstantSpeed("crank_drive", joint="main_bearing", speed=w),
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Z),
        Contact("crank_ball", hertz_point(steel, steel), flores(Parameter("restitution", "1", 0.9))),
        EnergyLedger(),
    ),
    # The ideal mechanism, the ball centred in its socket.
    start=Start(
        position={
            "guide": way,
            "slider_joint.angle_1": -sp.atan(beside / way),
            "slider_joint.angle_2": sp.asin(height / l),
        },
        speed={"guide": beside * r * w / way, "slider_joint.angle_1_speed": r * w / way},
    ),
    scales=Scales(length=c, speed=r * w, arm=l),
    summary="spatial slider-crank, clearance in a ball joint",
)
