"""A scene with one of every kind of thing that a picture of a mechanism shows."""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    APART,
    GROUND,
    Body,
    BodyTorque,
    ConstantSpeed,
    Contact,
    CustomPair,
    Cylindrical,
    Direction,
    EnergyLedger,
    Free,
    Gravity,
    JointDamper,
    JointForce,
    JointSpring,
    Mechanism,
    Parameter,
    Planar,
    PointForce,
    PointSpring,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    T,
    Universal,
    X,
    Y,
    Z,
)
from hertzwerk.derive.laws import power

SIDE, RADIUS, TILT = Parameter("side", "m", 0.2), Parameter("radius", "mm", 50), Parameter("tilt", "deg", 30)
MASS, FORCE = Parameter("mass", "kg", 1), Parameter("force", "N", 3)
INERTIA = (Parameter("inertia", "kg m^2", 0.01),) * 3


def workshop() -> Scene:
    """A post that slides and turns on a tilted axis, an arm on a universal joint, a free ball over a slope, and one effect of every kind."""
    post, arm, ball = (Body(name, MASS, INERTIA) for name in ("post", "arm", "ball"))
    bare = Body("bare", 0)
    crown = Body("crown", MASS, INERTIA, centre=(0, SIDE, 0))
    slope = SphereOnPlane("slope", ball.at(0, 0, 0), RADIUS, GROUND.at(0, 0, SIDE).turned(X, TILT), Z)
    own = CustomPair("own", ball.at(0, 0, 0), GROUND.at(0, 0, 0), APART[2] - RADIUS, (0, 0, 1), (APART[0], APART[1], 0))
    silent = SphereOnPlane("silent", ball.at(0, 0, 0), RADIUS, GROUND.at(0, 0, 0), Y)
    spring = Parameter("stiffness", "N/m", 40)
    return Scene(
        Mechanism(
            "workshop",
            (
                Cylindrical("column", GROUND.at(SIDE, 0, 0).turned(X, TILT), post, axis=Z),
                Universal("knee", post.at(0, 0, SIDE), arm, first=Direction((3, 4, 0)), second=Y),
                Planar("table", GROUND, bare, normal=Z),
                Revolute("seat", bare, crown, axis=Y),
                Free("fly", GROUND, ball),
            ),
            (slope, own, silent),
        ),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), -Z),
            *(Contact(name, power(Parameter("K", "N/m^1.5", 1e6), sp.Rational(3, 2))) for name in ("slope", "own")),
            ConstantSpeed("motor", "column.angle", Parameter("speed", "rad/s", 2)),
            JointSpring("lift", "column.travel", spring),
            JointDamper("ease", "knee.angle_2", Parameter("damping", "N m s", 1)),
            JointForce("shove", "table.x", FORCE),
            PointSpring("pull", arm.at(SIDE, 0, 0), GROUND.at(0, SIDE, 0), spring),
            PointForce("load", arm.at(SIDE, 0, 0), (0, 0, -FORCE)),
            PointForce("gust", arm.at(SIDE, 0, 0), (FORCE * sp.cos(Parameter("rate", "rad/s", 1) * T), 0, 0)),
            BodyTorque("twist", crown, (0, Parameter("torque", "N m", 5), 0), axes=crown),
            EnergyLedger(),
        ),
        scales=Scales(length=SIDE, speed=Parameter("pace", "m/s", 1), arm=SIDE),
    )
