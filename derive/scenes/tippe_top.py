"""A tippe-top: a ball with its mass centre below the middle, which turns over while it spins.

Friction at the point of contact raises it (Pliskin 1954, Cohen 1977). Whatever its law, it keeps Jellett's invariant, the
angular momentum times the way from mass centre to contact (Jellett, A Treatise on the Theory of Friction, 1872): upside
down it spins with (r cos(tilt) - offset)/(r + offset) of its spin at the start. Data: our choice, a sphere's inertia
about the axis and 131/132 of that across it.
"""

from sympy import cos, sin

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Free,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Y,
)
from hertzwerk.derive.laws import kelvin_voigt, power, smooth_coulomb

m = Parameter("mass", "g", 6)
r = Parameter("radius", "mm", 15)
offset = Parameter("offset", "mm", 3, "of the mass centre, below the middle of the ball")
axial = Parameter("axial_share", "1", 0.4, "of m r^2: moment of inertia about the axis")
across = Parameter("across_share", "1", 131 / 330, "of m r^2: moment of inertia across the axis")
g = Parameter("gravity", "m/s^2", 9.81)
K = Parameter("stiffness", "N/m", 2000)
tilt = Parameter("start_tilt", "rad", 0.1)
spin = Parameter("start_spin", "rad/s", 155, "about the axis")

top = Body("top", mass=m, inertia=(across * m * r**2, axial * m * r**2, across * m * r**2))

scene = Scene(
    Mechanism(
        "tippe_top",
        joints=(Free("flight", GROUND, top),),
        pairs=(SphereOnPlane("floor", top.at(0, offset, 0), r, GROUND.at(0, 0, 0), normal=Y),),
    ),
    effects=(
        Gravity("gravity", g, direction=-Y),
        Contact("floor", power(K, 1), kelvin_voigt(Parameter("restitution", "1", 0.1))),
        Friction(
            "rubbing",
            "floor",
            smooth_coulomb(Parameter("friction_coefficient", "1", 0.3), Parameter("friction_speed", "mm/s", 10)),
        ),
        EnergyLedger(),
    ),
    start=Start(
        position={
            "flight.y": r - offset * cos(tilt) - m * g / K,
            "flight.q0": cos(tilt / 2),
            "flight.q3": sin(tilt / 2),
        },
        speed={"flight.angular_speed_y": spin},
    ),
    scales=Scales(length=Parameter("depth", "mm", 0.1), speed=Parameter("pace", "m/s", 0.5), arm=r),
    summary="a top that turns over, raised by friction",
)
