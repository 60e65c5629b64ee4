"""Planar chain that falls onto a table and comes to rest: six links, or a hundred.

Balls at the ends of the links touch the table. At rest each end of a link carries half of its weight.
`chain_on_table(100)` is a scene of 102 coordinates and 101 contacts. Sizes, stiffness and friction our choice.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Planar,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Y,
    Z,
)
from hertzwerk.derive.laws import power, smooth_coulomb, tsuji


def chain_on_table(n: int, name: str = "") -> Scene:
    """Return n equal slender links, straight and inclined, the first ball just above the table."""
    R, L, g = Parameter("ball_radius", "mm", 2), Parameter("link_length", "mm", 20), Parameter("gravity", "m/s^2", 9.81)
    links = [Body.rod(f"link_{i}", L, mass=Parameter("link_mass", "g", 5)) for i in range(1, n + 1)]
    ends = [links[0].at(-L / 2, 0, 0), *(link.at(L / 2, 0, 0) for link in links)]
    joints = [Revolute(f"pin_{i}", end, link.at(-L / 2, 0, 0), axis=Z)
              for i, (end, link) in enumerate(zip(ends[1:-1], links[1:], strict=True), 1)]  # fmt: skip
    balls = [SphereOnPlane(f"ball_{i}", end, R, plane=GROUND.at(0, 0, 0), normal=Y) for i, end in enumerate(ends)]
    law = (
        power(Parameter("stiffness", "N/m^1.5", 1e6), n=sp.Rational(3, 2)),
        tsuji(Parameter("restitution", "1", 0.3)),
    )
    friction = smooth_coulomb(Parameter("friction_coefficient", "1", 0.2), Parameter("friction_speed", "m/s", 0.01))
    return Scene(
        Mechanism(
            name or f"chain_on_table_{n}",
            (Planar("flight", GROUND, ends[0], normal=Z), *joints),
            tuple(balls),
        ),
        effects=(
            Gravity("gravity", g, direction=-Y),
            *(Contact(ball.name, *law) for ball in balls),
            *(Friction(f"{ball.name}_friction", ball.name, friction) for ball in balls),
            EnergyLedger(),
        ),
        start=Start(position={"flight.y": 2 * R, "flight.angle": Parameter("inclination", "deg", 15)}),
        scales=Scales(length=R / 10, arm=L, speed=sp.sqrt(2 * g * L)),
        summary=f"a chain of {n} links falls onto a table",
    )


scene = chain_on_table(6, name="chain_on_table")
