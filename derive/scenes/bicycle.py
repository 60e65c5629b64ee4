"""A bicycle that rides by itself: Whipple's model, four rigid bodies on wheels that roll without slip.

Data: the benchmark of Meijaard, Papadopoulos, Ruina, Schwab, Linearized dynamics equations for the balance and steer of a
bicycle, Proc. R. Soc. A 463 (2007) 1955, table 1; its z points down, ours up. It is stable by itself from 4.29 to
6.02 m/s.
"""

from math import pi

from sympy import cos, sin

from hertzwerk.derive import (
    GROUND,
    Body,
    Direction,
    EnergyLedger,
    Gravity,
    Mechanism,
    Parameter,
    Planar,
    Prismatic,
    Revolute,
    RimOnPlane,
    RollingWithoutSlip,
    Scales,
    Scene,
    Start,
    X,
    Y,
    Z,
)

w = Parameter("wheel_base", "m", 1.02)
c = Parameter("trail", "m", 0.08)
tilt = Parameter("steer_axis_tilt", "rad", pi / 10)
rear, front = Parameter("rear_radius", "m", 0.3), Parameter("front_radius", "m", 0.35)
v = Parameter("speed", "m/s", 5)
origin, upright = Parameter("origin", "m", 0), Parameter("upright", "rad", 0)


def body(name: str, mass: float, inertia: tuple[float, float, float, float], x: float = 0, z: float = 0) -> Body:
    """A body with its inertias about x, y, z, the product xz, and its mass centre."""
    ends = ("xx", "yy", "zz", "xz")
    xx, yy, zz, xz = (Parameter(f"{name}_{e}", "kg m^2", I) for e, I in zip(ends, inertia, strict=True))
    centre = (Parameter(f"{name}_x", "m", x), 0, Parameter(f"{name}_z", "m", z)) if x else (0, 0, 0)
    tensor = ((xx, 0, xz), (0, yy, 0), (xz, 0, zz)) if inertia[3] else (xx, yy, zz)
    return Body(name, Parameter(f"{name}_mass", "kg", mass), tensor, centre)


frame = body("frame", 85, (9.2, 11, 2.8, -2.4), 0.3, 0.9)
fork = body("fork", 4, (0.05892, 0.06, 0.00708, 0.00756), 0.9, 0.7)
rear_wheel = body("rear_wheel", 2, (0.0603, 0.12, 0.0603, 0))
front_wheel = body("front_wheel", 3, (0.1405, 0.28, 0.1405, 0))
heading, lifted, leaning = (Body(name, mass=0) for name in ("heading", "lifted", "leaning"))

scene = Scene(
    Mechanism(
        "bicycle",
        joints=(
            Planar("path", GROUND, heading, normal=Z),
            Prismatic("height", heading, lifted, axis=Z),
            Revolute("lean", lifted, leaning, axis=X),
            Revolute("pitch", leaning.at(0, 0, rear), frame.at(0, 0, rear), axis=Y),
            Revolute("rear_hub", frame.at(0, 0, rear), rear_wheel, axis=Y),
            Revolute("steer", frame.at(w + c, 0, 0), fork.at(w + c, 0, 0), axis=Direction((-sin(tilt), 0, cos(tilt)))),
            Revolute("front_hub", fork.at(w, 0, front), front_wheel, axis=Y),
        ),
        pairs=(
            RimOnPlane("rear_tyre", rear_wheel.at(0, 0, 0), Y, rear, GROUND.at(0, 0, 0), normal=Z),
            RimOnPlane("front_tyre", front_wheel.at(0, 0, 0), Y, front, GROUND.at(0, 0, 0), normal=Z),
        ),
    ),
    effects=(
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Z),
        RollingWithoutSlip("rear_grip", "rear_tyre"),
        RollingWithoutSlip("front_grip", "front_tyre"),
        EnergyLedger(),
    ),
    start=Start(
        position={"path.x": origin, "path.y": origin}
        | dict.fromkeys(("path.angle", "lean", "steer", "rear_hub", "front_hub"), upright),
        speed={
            "lean": Parameter("push", "rad/s", 0.5, "speed of leaning at the start"),
            "steer": Parameter("steering", "rad/s", 0),
            "rear_hub": v / rear,
        },
    ),
    scales=Scales(length=rear, speed=Parameter("pace", "m/s", 5), arm=rear),
    summary="self-stable bicycle on wheels without slip",
)
