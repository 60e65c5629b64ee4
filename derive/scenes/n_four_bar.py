"""N windows of uniform rods, hinged to the ground and to each other; here N = 2.

Benchmark A02 of the IFToMM library. Rods of 1 kg and 1 m, upright, the first at 1 m/s, as also in the public code
MBS-BOS (grade B). Lying flat, all rods in one line, it has N + 1 degrees of freedom instead of one: it passes through
singular positions.

Source: https://www.iftomm-multibody.org/benchmark, A02; Bayo, Avello, Nonlinear Dynamics 5 (1994) 209.
"""

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

L = Parameter("length", "m", 1.0, "of each rod")
m = Parameter("mass", "kg", 1.0, "of each rod")
v = Parameter("speed", "m/s", 1.0, "of the upper hinges at the start")


def n_four_bar(windows: int) -> Scene:
    """Scene with the given number of windows along X."""
    inertia = m * L**2 / 12
    posts = [Body(f"post_{i}", m, inertia, centre=(0, L / 2, 0)) for i in range(windows + 1)]
    beams = [Body(f"beam_{i}", m, inertia, centre=(L / 2, 0, 0)) for i in range(windows)]
    feet = (Revolute(f"foot_{i}", GROUND.at(i * L, 0, 0), post, axis=Z) for i, post in enumerate(posts))
    lefts = (Revolute(f"left_{i}", posts[i].at(0, L, 0), beam, axis=Z) for i, beam in enumerate(beams))
    rights = (
        Revolute(f"right_{i}", posts[i + 1].at(0, L, 0), beam.at(L, 0, 0), axis=Z) for i, beam in enumerate(beams)
    )
    return Scene(
        Mechanism("n_four_bar", joints=(*feet, *lefts, *rights)),
        effects=(Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y), EnergyLedger()),
        start=Start(speed={"foot_0": -v / L}),
        scales=Scales(length=L, speed=v, arm=L),
        summary=f"{windows} four-bar windows, through singular positions",
    )


scene = n_four_bar(2)
