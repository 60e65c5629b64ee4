"""A sphere meets an equal one at rest: 0.3 m/s, restitution 0.7, no gravity."""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Material,
    Mechanism,
    Parameter,
    Prismatic,
    Scales,
    Scene,
    SphereOnSphere,
    Start,
    X,
)
from hertzwerk.derive.laws import flores, hertz_point

m = Parameter("mass", "kg", 0.092, "of each sphere")
R = Parameter("radius", "m", 0.02, "of each sphere")
v = Parameter("speed", "m/s", 0.3, "of the striker at the start")
gap = Parameter("gap", "m", 0.01, "between the spheres at the start")
E = Parameter("youngs_modulus", "GPa", 207)
nu = Parameter("poissons_ratio", "1", 0.3)
e = Parameter("restitution", "1", 0.7)
steel = Material(E, nu, Parameter("density", "kg/m^3", 7800, "of the steel"))

striker = Body("striker", mass=m)
target = Body("target", mass=m)

mechanism = Mechanism(
    "two_spheres",
    joints=(Prismatic("striker_path", GROUND, striker, axis=X), Prismatic("target_path", GROUND, target, axis=X)),
    pairs=(SphereOnSphere("spheres", striker.at(0, 0, 0), target.at(0, 0, 0), R, R),),
)

K = sp.Rational(4, 3) * E / (2 * (1 - nu**2)) * sp.sqrt(R / 2)

scene = Scene(
    mechanism,
    effects=(Contact("spheres", hertz_point(steel, steel), flores(e)), EnergyLedger()),
    start=Start(position={"target_path": 2 * R + gap}, speed={"striker_path": v}),
    scales=Scales(length=(5 * m * v**2 / (8 * K)) ** sp.Rational(2, 5), speed=v),  # m_eff = m/2
    summary="a sphere meets an equal one at rest",
)
