"""Bricard's mechanism: five uniform rods and the ground along edges of a cube, joined by six hinges.

Benchmark A04 of the IFToMM library. It has one degree of freedom although Gruebler's formula gives none: one of its
constraints is redundant. Order of the edges, 1 m, 1 kg and gravity as in two public codes of the benchmark (grade B);
the rods are slender as in one of them, the other gives them a square section of 0.1 m.

Source: https://www.iftomm-multibody.org/benchmark, A04; Gonzalez, Dopico, Lugris, Cuadrado, Multibody Syst. Dyn. 16
(2006) 263.
"""

from hertzwerk.derive import GROUND, Body, EnergyLedger, Gravity, Mechanism, Parameter, Revolute, Scales, Scene, X, Y, Z

L = Parameter("length", "m", 1.0, "of each rod")
m = Parameter("mass", "kg", 1.0, "of each rod")
v = Parameter("speed_scale", "m/s", 1.0)

# Edges of a cube of side L, from the origin on; each hinge is across the edges that meet in it.
rods, tips = [], []
for name, edge in (("a", (1, 0, 0)), ("b", (0, -1, 0)), ("c", (0, 0, 1)), ("d", (-1, 0, 0)), ("e", (0, 1, 0))):
    inertia = tuple(m * L**2 / 12 * (1 - abs(component)) for component in edge)
    x, y, z = (component * L / 2 for component in edge)
    rods.append(Body(f"rod_{name}", m, inertia, centre=(x, y, z)))
    tips.append(rods[-1].at(*(component * L for component in edge)))

mechanism = Mechanism(
    "bricard",
    joints=(
        Revolute("hinge_a", GROUND, rods[0], axis=Y),
        Revolute("hinge_b", tips[0], rods[1], axis=Z),
        Revolute("hinge_c", tips[1], rods[2], axis=X),
        Revolute("hinge_d", tips[2], rods[3], axis=Y),
        Revolute("hinge_e", tips[3], rods[4], axis=Z),
        Revolute("hinge_f", GROUND.at(0, 0, L), tips[4], axis=X),
    ),
)

scene = Scene(
    mechanism,
    effects=(Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y), EnergyLedger()),
    scales=Scales(length=L, speed=v, arm=L),
    summary="five rods, six hinges, one redundant constraint",
)
