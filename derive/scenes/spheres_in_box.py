"""Equal rubber spheres that fall into a box and rest: a pyramid of five, or a heap of hundreds.

There is no friction. Four in the corners carry the fifth, with forces in closed form. `spheres_in_box(100, across=5)`
is a scene of 5,450 pairs, of which a run evaluates those that are near. Sizes, stiffness and restitution our choice.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Free,
    Gravity,
    Mechanism,
    Parameter,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    X,
    Y,
    Z,
    every_pair,
)
from hertzwerk.derive.laws import power, tsuji
from hertzwerk.derive.laws.law import BoundLaw


def spheres_in_box(n: int, across: int = 2, name: str = "", damping: BoundLaw | None = None) -> Scene:
    """Return n spheres, in layers of `across` by `across` that are pushed aside.

    One that is alone in its layer is in the middle. The damping of all contacts is `tsuji` with a restitution of 0.3
    by default.
    """
    R, W = Parameter("radius", "m", 0.02), Parameter("width", "m", 0.05 * across)
    g, K = Parameter("gravity", "m/s^2", 9.81), Parameter("stiffness", "N/m^1.5", 1e5)
    balls = [Body.sphere(f"ball_{i}", R, density=Parameter("density", "kg/m^3", 1100)) for i in range(1, n + 1)]
    planes = {
        "floor": (GROUND.at(0, 0, 0), Y),
        **{f"wall_{k}": (GROUND.at(*(-a * W / 2 for a in v.components)), v) for k, v in enumerate((X, -X, Z, -Z), 1)},
    }
    sides = tuple(
        SphereOnPlane(f"{name}_{i}", ball.at(0, 0, 0), R, plane=plane, normal=normal)
        for name, (plane, normal) in planes.items()
        for i, ball in enumerate(balls, 1)
    )
    position = {}
    for i in range(n):
        layer, k = divmod(i, across**2)
        alone = k == 0 and i == n - 1
        x, z = (0, 0) if alone else (2 * (k % across) - across + 1, 2 * (k // across) - across + 1)
        far = sp.Rational(2 * layer, across)
        aside = (far * sp.Rational((3 * i) % 5 - 2, 20), far * sp.Rational((5 * i) % 7 - 3, 30))
        for axis, off in (("x", x * sp.Rational(23, 20) + (0 if alone else aside[0])),
                          ("y", sp.Rational(21, 20) + sp.Rational(5, 2) * layer),
                          ("z", z * sp.Rational(23, 20) + (0 if alone else aside[1]))):  # fmt: skip
            position[f"flight_{i + 1}.{axis}"] = R * off
    law = (power(K, n=sp.Rational(3, 2)), damping or tsuji(Parameter("restitution", "1", 0.3)))
    return Scene(
        Mechanism(
            name or f"spheres_in_box_{n}",
            tuple(Free(f"flight_{i}", GROUND, ball) for i, ball in enumerate(balls, 1)),
            (*every_pair("balls", balls, R), *sides),
        ),
        effects=(
            Gravity("gravity", g, direction=-Y),
            Contact("balls", *law),
            *(Contact(side.name, *law) for side in sides),
            EnergyLedger(),
        ),
        start=Start(position=position),
        scales=Scales(length=R / 10, arm=R, speed=sp.sqrt(2 * g * R)),
        summary=f"{n} spheres fall into a box",
    )


scene = spheres_in_box(5, name="spheres_in_box")
