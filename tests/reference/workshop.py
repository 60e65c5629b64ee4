"""A scene with one of every kind of thing that a picture of a mechanism shows."""

import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import power

SIDE, RADIUS, TILT = hd.Parameter("side", "m", 0.2), hd.Parameter("radius", "mm", 50), hd.Parameter("tilt", "deg", 30)
MASS, FORCE = hd.Parameter("mass", "kg", 1), hd.Parameter("force", "N", 3)
INERTIA = (hd.Parameter("inertia", "kg m^2", 0.01),) * 3


def workshop() -> hd.Scene:
    """A post that slides and turns on a tilted axis, an arm on a universal joint, a free ball over a slope, and one effect of every kind."""
    post, arm, ball = (hd.Body(name, MASS, INERTIA) for name in ("post", "arm", "ball"))
    bare = hd.Body("bare", 0)
    crown = hd.Body("crown", MASS, INERTIA, centre=(0, SIDE, 0))
    slope = hd.SphereOnPlane("slope", ball.at(0, 0, 0), RADIUS, hd.GROUND.at(0, 0, SIDE).turned(hd.X, TILT), hd.Z)
    own = hd.CustomPair(
        "own", ball.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.APART[2] - RADIUS, (0, 0, 1), (hd.APART[0], hd.APART[1], 0)
    )
    silent = hd.SphereOnPlane("silent", ball.at(0, 0, 0), RADIUS, hd.GROUND.at(0, 0, 0), hd.Y)
    spring = hd.Parameter("stiffness", "N/m", 40)
    return hd.Scene(
        hd.Mechanism(
            "workshop",
            (
                hd.Cylindrical("column", hd.GROUND.at(SIDE, 0, 0).turned(hd.X, TILT), post, axis=hd.Z),
                hd.Universal("knee", post.at(0, 0, SIDE), arm, first=hd.Direction((3, 4, 0)), second=hd.Y),
                hd.Planar("table", hd.GROUND, bare, normal=hd.Z),
                hd.Revolute("seat", bare, crown, axis=hd.Y),
                hd.Free("fly", hd.GROUND, ball),
            ),
            (slope, own, silent),
        ),
        effects=(
            hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Z),
            *(hd.Contact(name, power(hd.Parameter("K", "N/m^1.5", 1e6), sp.Rational(3, 2))) for name in ("slope", "own")),
            hd.ConstantSpeed("motor", "column.angle", hd.Parameter("speed", "rad/s", 2)), hd.JointSpring("lift", "column.travel", spring),
            hd.JointDamper("ease", "knee.angle_2", hd.Parameter("damping", "N m s", 1)), hd.JointForce("shove", "table.x", FORCE),
            hd.PointSpring("pull", arm.at(SIDE, 0, 0), hd.GROUND.at(0, SIDE, 0), spring), hd.PointForce("load", arm.at(SIDE, 0, 0), (0, 0, -FORCE)),
            hd.PointForce("gust", arm.at(SIDE, 0, 0), (FORCE * sp.cos(hd.Parameter("rate", "rad/s", 1) * hd.T), 0, 0)),
            hd.BodyTorque("twist", crown, (0, hd.Parameter("torque", "N m", 5), 0), axes=crown), hd.EnergyLedger(),
        ),
        scales=hd.Scales(length=SIDE, speed=hd.Parameter("pace", "m/s", 1), arm=SIDE),
    )  # fmt: skip
