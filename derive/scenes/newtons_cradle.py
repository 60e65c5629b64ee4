"""Newton's cradle: five spheres on rigid strings, slightly apart, the first pulled aside and released.

Steel spheres, 2 % of their diameter apart. Linear stiffness and the damping factor that returns the coefficient of
restitution exactly, so that a transfer is a sequence of impacts of two.
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
    Revolute,
    Scales,
    Scene,
    SphereOnSphere,
    Start,
    Y,
    Z,
)
from hertzwerk.derive.laws import exact, power

SPHERES = 5

R = Parameter("radius", "m", 0.02, "of each sphere")
rho = Parameter("density", "kg/m^3", 7800)
L = Parameter("length", "m", 0.25, "pivot to the sphere's centre")
spacing = Parameter("spacing", "1", 1.02, "of the pivots, in diameters")
angle = Parameter("start_angle", "deg", -30, "of the first string, from hanging")
g = Parameter("gravity", "m/s^2", 9.81)
K = Parameter("stiffness", "N/m", 1e6)
e = Parameter("restitution", "1", 1)

m = sp.Rational(4, 3) * sp.pi * rho * R**3
balls = [Body(f"ball_{i}", m, sp.Rational(2, 5) * m * R**2, centre=(0, -L, 0)) for i in range(SPHERES)]
contacts = [f"contact_{i}" for i in range(SPHERES - 1)]

mechanism = Mechanism(
    "newtons_cradle",
    joints=tuple(
        Revolute(f"string_{i}", GROUND.at(2 * i * spacing * R, L, 0), ball, axis=Z) for i, ball in enumerate(balls)
    ),
    pairs=tuple(
        SphereOnSphere(name, balls[i].at(0, -L, 0), balls[i + 1].at(0, -L, 0), R, R) for i, name in enumerate(contacts)
    ),
)

speed = sp.sqrt(2 * g * L * (1 - sp.cos(angle)))

scene = Scene(
    mechanism,
    effects=(
        Gravity("gravity", g, direction=-Y),
        *(Contact(name, power(K, 1), exact(e)) for name in contacts),
        EnergyLedger(),
    ),
    start=Start(position={"string_0": angle}),
    scales=Scales(length=speed * sp.sqrt(m / (2 * K)), speed=speed, arm=L),
    summary="Newton's cradle",
)
