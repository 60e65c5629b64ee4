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

m = Parameter("mass", "kg", 1.0)
L = Parameter("length", "m", 1.0, "of the rod")
g = Parameter("gravity", "m/s^2", 9.81)
angle = Parameter("start_angle", "deg", -90, "from hanging")

bob = Body("bob", m, centre=(0, -L, 0))

scene = Scene(
    Mechanism("pendulum", joints=(Revolute("hinge", GROUND.at(0, L, 0), bob, axis=Z),)),
    effects=(Gravity("gravity", g, direction=-Y), EnergyLedger()),
    start=Start(position={"hinge": angle}),
    scales=Scales(length=L, speed=sp.sqrt(g * L), arm=L),
    summary="pendulum let go horizontal",
)
