"""A Geneva drive: a pin that turns a wheel of four slots by a quarter, and a disc that locks it.

The pin enters and leaves a slot along it, where its circle of radius arm = distance/sqrt(2) touches the slot's middle. In between
tan(b) = arm sin(a)/(distance - arm cos(a)) for the angles a of the crank and b of the wheel from the line of centres, but for the play of
the pin: it is turned fastest there, sqrt(2) + 1 times as fast as the crank. The disc fills a hollow of the wheel, but for its own
play: the wheel then turns until the one or the other tip of the hollow is on the disc, which is a triangle of known sides. The
disc's recess, which lets the wheel pass, begins a right angle wide as the pin enters. Our choice of numbers.
"""

import sympy as sp

from hertzwerk.derive import (
    GROUND,
    Arc,
    Body,
    CircleOnCurve,
    ConstantSpeed,
    Contact,
    CurveOnCurve,
    EnergyLedger,
    Line,
    Mechanism,
    Outline,
    Parameter,
    Revolute,
    Scales,
    Scene,
    Start,
    Z,
)
from hertzwerk.derive.laws import power, power_damping

distance = Parameter("distance", "mm", 60, "of the axes")
pin = Parameter("pin_radius", "mm", 4)
play = Parameter("play", "mm", 0.01, "half the width of a slot less the pin's radius")
rim, root, lock = (Parameter(name, "mm", value) for name, value in (("rim", 43.5), ("root", 13), ("lock_radius", 30)))
speed = Parameter("crank_speed", "rpm", 120)
lock_play = Parameter("lock_play", "mm", 0.01, "radius of the hollows less that of the locking disc")
hub = Parameter("hub", "mm", 5, "from the crank's axis to the bottom of the disc's recess")
K = Parameter("contact_stiffness", "N/m", 1e8)
chi = Parameter("contact_damping", "N s/m^2", 1e9)

arm = distance / sp.sqrt(2)
half = pin + play
mouth = sp.sqrt(rim**2 - half**2)
# where the arc of the locking disc, about the crank's axis while it is away, cuts the rim
across = (rim**2 + distance**2 - lock**2) / (2 * distance)
beside = sp.sqrt(rim**2 - across**2)
COS, SIN = sp.sqrt(2) / 2, sp.sqrt(2) / 2


def turned(k: int, along: sp.Expr, beyond: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Point of the wheel along the slot k and beyond it, to the left."""
    x, y = ((1, 0), (0, 1), (-1, 0), (0, -1))[k % 4]
    return x * along - y * beyond, y * along + x * beyond


def between(k: int, along: sp.Expr, beyond: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Point of the wheel in the direction between the slots k and k + 1."""
    return turned(k, COS * along - SIN * beyond, SIN * along + COS * beyond)


pieces: list[Line | Arc] = []
for k in range(4):
    pieces += [
        Line(turned(k, root, -half)),
        Arc(turned(k, root, half), turned(k, root, 0), clockwise=True),
        Line(turned(k, mouth, half)),
        Arc(between(k, across, -beside), (0, 0)),
        Arc(between(k, across, beside), between(k, distance, 0), clockwise=True),
        Arc(turned(k + 1, mouth, -half), (0, 0)),
    ]
slots = Outline("slots", turned(0, mouth, -half), pieces)
disc_radius = lock - lock_play
end = COS * disc_radius
disc = Outline("disc", (end, end), [Arc((end, -end), (0, 0)), Line((hub, 0)), Line((end, end))])  # the pin is along X

crank = Body("crank", Parameter("crank_mass", "kg", 0.3), Parameter("crank_inertia", "kg m^2", 2e-4))
wheel = Body("wheel", Parameter("wheel_mass", "kg", 0.2), Parameter("wheel_inertia", "kg m^2", 1e-4))
tip = crank.at(arm / 2, -arm * sp.sqrt(3) / 2, 0)  # 60 degrees before the line of centres at the start

scene = Scene(
    Mechanism(
        "geneva_drive",
        joints=(Revolute("shaft", GROUND, crank, axis=Z), Revolute("axle", GROUND.at(distance, 0, 0), wheel, axis=Z)),
        pairs=(
            CircleOnCurve("slot", tip, pin, slots, wheel.at(0, 0, 0)),
            CurveOnCurve("lock", disc, crank.at(0, 0, 0).turned(Z, -sp.pi / 3), slots, wheel.at(0, 0, 0)),
        ),
    ),
    effects=(
        ConstantSpeed("motor", "shaft", speed),
        Contact("slot", power(K, n=1), power_damping(chi, m=1)),
        Contact("lock", power(K, n=1), power_damping(chi, m=1)),
        EnergyLedger(),
    ),
    start=Start(position={"axle": Parameter("start_angle", "deg", 45)}),
    scales=Scales(length=play, speed=speed * arm / 10, arm=distance),
    summary="a pin turns a slotted wheel, a disc locks it",
)
