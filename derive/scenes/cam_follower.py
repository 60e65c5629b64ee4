"""A cam whose roller follower lifts off above a speed that is known in closed form.

The cam's rim is the parallel curve, at the roller's radius, of the way of the roller's centre: base + lift/2 (1 - cos angle)
from the axis. A follower that stays on it is pressed by preload + stiffness (y - base) + m g + m y'', which vanishes first on
top, at angle pi, where w^2 = 2 (preload + stiffness lift + m g)/(m lift). Our choice of numbers.
"""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    CircleOnCurve,
    ConstantSpeed,
    Contact,
    Curve,
    EnergyLedger,
    Gravity,
    JointSpring,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    S,
    Scales,
    Scene,
    Start,
    Y,
    Z,
)
from hertzwerk.derive.laws import power, power_damping

base = Parameter("base", "mm", 40, "least distance of the roller's centre from the cam's axis")
lift = Parameter("lift", "mm", 10)
radius = Parameter("roller_radius", "mm", 10)
m = Parameter("follower_mass", "kg", 0.5)
g = Parameter("gravity", "m/s^2", 9.81)
speed = Parameter("cam_speed", "rpm", 1800)
stiffness, preload = Parameter("spring_stiffness", "N/mm", 2), Parameter("preload", "N", 50)
K = Parameter("contact_stiffness", "N/m", 1e8)

reach = base + lift / 2 * (1 - sp.sin(S))  # of the roller's centre, in the direction S; least upwards at the start
slope = sp.sqrt(reach**2 + reach.diff(S) ** 2)
rim = Curve(
    "rim",
    x=reach * sp.cos(S) - radius * (reach * sp.cos(S) + reach.diff(S) * sp.sin(S)) / slope,
    y=reach * sp.sin(S) - radius * (reach * sp.sin(S) - reach.diff(S) * sp.cos(S)) / slope,
)

cam = Body("cam", Parameter("cam_mass", "kg", 1), Parameter("cam_inertia", "kg m^2", 1e-3))
stem = Body.rod("stem", 5 * radius, mass=m, axis=Y, centre=(0, 5 * radius / 2, 0))
follower = Body("follower", m, shapes=stem.shapes)  # for pictures
pressed = preload + m * g + m * lift / 2 * speed**2  # at the start, where it is accelerated upwards

scene = Scene(
    Mechanism(
        "cam_follower",
        joints=(Revolute("shaft", GROUND, cam, axis=Z), Prismatic("guide", GROUND, follower, axis=Y)),
        pairs=(CircleOnCurve("roller", follower.at(0, 0, 0), radius, rim, cam.at(0, 0, 0)),),
    ),
    effects=(
        Gravity("gravity", g, direction=-Y),
        ConstantSpeed("motor", "shaft", speed),
        JointSpring("spring", "guide", stiffness, rest=base - preload / stiffness),
        Contact("roller", power(K, 1), power_damping(Parameter("contact_damping", "N s/m", 2000), 0)),
        EnergyLedger(),
    ),
    start=Start(position={"guide": base - pressed / K}),
    scales=Scales(length=lift, speed=lift * speed, arm=base),
    summary="cam whose roller follower lifts off",
)
