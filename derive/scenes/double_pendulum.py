"""Double pendulum of equal masses and massless rods, released far beyond small vibrations.

Its small vibrations are those of the textbooks: w^2 = (2 -+ sqrt 2) g/l, both masses in phase or in opposition, the
lower with sqrt 2 times the amplitude.

Source: Landau, Lifshitz, Mechanics, section 23, problem 2, with both masses and both lengths the same.
"""

import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Body,
    EnergyLedger,
    Gravity,
    Mechanism,
    Parameter,
    Revolute,
    Scales,
    Scene,
    Start,
    Y,
    Z,
)

m = Parameter("mass", "kg", 1.0, "of each bob")
l = Parameter("length", "m", 1.0, "of each rod")
g = Parameter("gravity", "m/s^2", 9.81)

upper = Body("upper", m, centre=(0, -l, 0))
lower = Body("lower", m, centre=(0, -l, 0))

scene = Scene(
    Mechanism(
        "double_pendulum",
        joints=(
            Revolute("shoulder", GROUND, upper, axis=Z),
            Revolute("elbow", upper.at(0, -l, 0), lower, axis=Z),
        ),
    ),
    effects=(Gravity("gravity", g, direction=-Y), EnergyLedger()),
    start=Start(
        position={
            "shoulder": Parameter("shoulder_angle", "deg", 120, "of the upper rod at the start, from hanging"),
            "elbow": Parameter("elbow_angle", "deg", -30, "of the lower rod at the start, from the upper"),
        }
    ),
    scales=Scales(length=l, speed=sp.sqrt(g * l), arm=l),
    summary="double pendulum",
)
