"""Slider-crank with clearance in the slider's guide: four corners against two bounded faces.

Crank, rod and slider move freely. Data: the set on which two public codes for rigid contact agree (grade B), after
Flores, Leine, Glocker, Multibody Syst. Dyn. 23 (2010) 165. The stiffness, the speed over which friction builds up and
the length of the guide are our choice.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    CornerOnFace,
    EnergyLedger,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Revolute,
    Scales,
    Scene,
    Start,
    X,
    Y,
    Z,
)
from hertzwerk.derive.laws import flores, power, smooth_coulomb

r = Parameter("crank_length", "m", 0.153)
l = Parameter("rod_length", "m", 0.306)
a = Parameter("half_length", "m", 0.05, "of the slider")
b = Parameter("half_width", "m", 0.025, "of the slider")
c = Parameter("clearance", "m", 0.001, "of the guide, on each side of the slider")
guide = Parameter("guide_length", "m", 0.45)
crank_speed, rod_speed = (
    Parameter("crank_speed", "rad/s", 150),
    Parameter("rod_speed", "rad/s", -75, "at the start, against the ground"),
)
K = Parameter("stiffness", "N/m^1.5", 1e9)
e, mu, v_s = (
    Parameter("restitution", "1", 0.4),
    Parameter("friction_coefficient", "1", 0.01),
    Parameter("friction_speed", "m/s", 0.1),
)

crank = Body(
    "crank",
    mass=Parameter("crank_mass", "kg", 0.038),
    inertia=Parameter("crank_inertia", "kg m^2", 7.4e-5),
    centre=(r / 2, 0, 0),
)
rod = Body(
    "rod",
    mass=Parameter("rod_mass", "kg", 0.038),
    inertia=Parameter("rod_inertia", "kg m^2", 5.9e-4),
    centre=(l / 2, 0, 0),
)
slider = Body(
    "slider", mass=Parameter("slider_mass", "kg", 0.076), inertia=Parameter("slider_inertia", "kg m^2", 2.7e-6)
)

CORNERS = {
    f"{end}_{side}": CornerOnFace(
        f"{end}_{side}",
        corner=slider.at(along * a, across * b, 0),
        face=GROUND.at(l, across * (b + c), 0),
        normal=Y if across < 0 else -Y,
        along=X,
        length=guide,
    )
    for end, along in (("rear", -1), ("front", 1))
    for side, across in (("lower", -1), ("upper", 1))
}

mechanism = Mechanism(
    "translational_clearance",
    joints=(
        Revolute("main_bearing", GROUND, crank, axis=Z),
        Revolute("crank_pin", crank.at(r, 0, 0), rod, axis=Z),
        Revolute("slider_pin", rod.at(l, 0, 0), slider, axis=Z),
    ),
    pairs=tuple(CORNERS.values()),
)

scene = Scene(
    mechanism,
    effects=(
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
        *(Contact(name, power(K, sp.Rational(3, 2)), flores(e)) for name in CORNERS),
        *(Friction(f"{name}_friction", pair=name, law=smooth_coulomb(mu, v_s)) for name in CORNERS),
        EnergyLedger(),
    ),
    start=Start(speed={"main_bearing": crank_speed, "crank_pin": rod_speed - crank_speed, "slider_pin": -rod_speed}),
    scales=Scales(length=c, speed=r * crank_speed, arm=l),
    summary="slider-crank, clearance between slider and guide",
)
