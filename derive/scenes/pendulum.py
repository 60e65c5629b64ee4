"""Simple pendulum released horizontally: benchmark A01 of the IFToMM library.

A point mass on a massless rod. Energy counts from the lowest point.

Source: https://www.iftomm-multibody.org/benchmark, A01; Gonzalez, Dopico, Lugris, Cuadrado, Multibody Syst. Dyn. 16
(2006) 263.
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

# Numbers with units. Change any of them for one run: --set length="0.8 m".
m = Parameter("mass", "kg", 1.0)
L = Parameter("length", "m", 1.0, "of the rod")
g = Parameter("gravity", "m/s^2", 9.81)
angle = Parameter("start_angle", "deg", -90, "from hanging")

# A point mass; the frame of the body is at the hinge.
bob = Body("bob", m, centre=(0, -L, 0))

# Everything that acts. An effect that is not listed here enters no equation.
scene = Scene(
    Mechanism("pendulum", joints=(Revolute("hinge", GROUND.at(0, L, 0), bob, axis=Z),)),
    effects=(Gravity("gravity", g, direction=-Y), EnergyLedger()),
    # Where it starts: positions and speeds of joints by their names; those omitted are zero.
    start=Start(position={"hinge": angle}),
    # Typical sizes, of lengths and speeds: errors count by them.
    scales=Scales(length=L, speed=sp.sqrt(g * L), arm=L),
    summary="pendulum let go horizontal",
)
