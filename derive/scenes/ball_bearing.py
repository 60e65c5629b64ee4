"""A ball bearing with radial clearance under load: balls roll between a driven ring and a fixed one.

The cage keeps the balls apart; each is free along its pocket, spins, and touches both rings with friction. Balls that
carry turn the cage at half the speed of the ring times 1 - d/D; as they pass the line of load the ring moves at the
frequency of their passing. Diameters about those of a 6205 (grade C); number of balls, stiffness, load our choice.
Damping is given outright: by restitution it goes with 1/(approach speed), and a ball rolls into the load at next to none.

Source of the kinematics: Harris, Kotzalas, Essential Concepts of Bearing Technology (5th ed. 2006), 8.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    BallInSocket,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Friction,
    JointDamper,
    Mechanism,
    Parameter,
    Planar,
    PointForce,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    SphereOnSphere,
    Start,
    X,
    Z,
)
from hertzwerk.derive.laws import power, power_damping, smooth_coulomb

d, D = Parameter("ball_diameter", "mm", 7.94), Parameter("pitch_diameter", "mm", 39.04)
c = Parameter("clearance", "um", 10, "radial, between balls and rings together")
K, loss = Parameter("stiffness", "N/m^1.5", 1e10), Parameter("damping", "N s/m^2.5", 1e11)
rubbing = smooth_coulomb(Parameter("friction_coefficient", "1", 0.1), Parameter("friction_speed", "mm/s", 10))
w = Parameter("speed", "rpm", 3000, "of the inner ring")
r, inner, outer = d / 2, (D - d - c) / 2, (D + d + c) / 2  # radii of balls and races

cage = Body("cage", Parameter("cage_mass", "g", 10), Parameter("cage_inertia", "kg m^2", 4e-6))
ring = Body("ring", Parameter("ring_mass", "kg", 0.5, "with its shaft"), Parameter("ring_inertia", "kg m^2", 1e-4))
m, J = Parameter("ball_mass", "g", 2.05), Parameter("ball_inertia", "kg m^2", 1.3e-8)
support = Parameter("support_damping", "N s/m", 500, "what the shaft's support damps")


def bearing(count: int, name: str) -> Scene:
    """Return the bearing with a number of balls, of which many need a smaller diameter."""
    pockets = [Body(f"pocket_{k}", 0) for k in range(count)]
    balls = [Body(f"ball_{k}", m, J) for k in range(count)]

    joints = [Planar("shaft", GROUND, ring, normal=Z), Revolute("cage_turn", GROUND, cage, axis=Z)]
    pairs, effects = [], []
    for k, (pocket, ball) in enumerate(zip(pockets, balls, strict=True)):
        place = cage.at(0, 0, 0).turned(Z, 2 * sp.pi * k / count)
        joints += [Prismatic(f"way_{k}", place, pocket, axis=X), Revolute(f"spin_{k}", pocket, ball, axis=Z)]
        pairs += [
            SphereOnSphere(f"inner_{k}", ball.at(0, 0, 0), ring.at(0, 0, 0), r, inner),
            BallInSocket(f"outer_{k}", ball.at(0, 0, 0), GROUND.at(0, 0, 0), outer, clearance=outer - r),
        ]
    for pair in pairs:
        effects += [
            Contact(pair.name, power(K, 1.5), power_damping(loss, 1.5)),
            Friction(f"{pair.name}_friction", pair.name, rubbing),
        ]

    orbit = w / 2 * (1 - d / D)
    rolling = -w / 2 * (D / d) * (1 - (d / D) ** 2)  # of a ball against the cage
    start = Start(
        position={"shaft.y": -c / 2} | {f"way_{k}": D / 2 + c / 4 for k in range(count)},
        speed={"cage_turn": orbit} | {f"spin_{k}": rolling for k in range(count)},
    )
    return Scene(
        Mechanism(name, tuple(joints), tuple(pairs)),
        effects=(
            ConstantSpeed("motor", "shaft.angle", w),
            PointForce("load", ring.at(0, 0, 0), (0, -Parameter("load", "N", 500), 0)),
            JointDamper("support_x", "shaft.x", support),
            JointDamper("support_y", "shaft.y", support),
            *effects,
            EnergyLedger(),
        ),
        start=start,
        scales=Scales(length=c, speed=Parameter("pace", "m/s", 1), arm=D),
        summary="ball bearing: cage speed and passing frequency",
    )


scene = bearing(6, "ball_bearing")
