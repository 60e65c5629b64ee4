"""A disc on several feet that slides and spins on a floor, and a tippe-top."""

import math

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    Contact,
    EnergyLedger,
    Free,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Planar,
    Prismatic,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    Y,
)
from hertzwerk.derive.laws import kelvin_voigt, power

DISC, RING, GRAVITY = 2.0, 0.1, 9.81  # kg, m, m/s^2


def curling(law, feet):
    """A disc, m R^2/2, on feet at its rim, level: each carries its part of the weight."""
    mass, rim, radius = Parameter("mass", "kg", DISC), Parameter("rim", "m", RING), Parameter("radius", "m", 0.01)
    gravity, stiffness = Parameter("gravity", "m/s^2", GRAVITY), Parameter("stiffness", "N/m", 1e5)
    tray, disc = Body("tray", 0), Body("disc", mass=mass, inertia=mass * rim**2 / 2)
    joints = (Planar("floor", GROUND, tray, normal=Y), Prismatic("up", tray, disc, axis=Y))
    effects = [Gravity("gravity", gravity, direction=-Y), EnergyLedger()]
    pairs = []
    for i in range(feet):
        x, z = (sum_ * rim for sum_ in (math.cos(2 * math.pi * i / feet), math.sin(2 * math.pi * i / feet)))
        pairs.append(SphereOnPlane(f"foot_{i}", disc.at(x, 0, z), radius, GROUND.at(0, 0, 0), Y))
        effects += [Contact(f"foot_{i}", power(stiffness, 1), kelvin_voigt(Parameter("restitution", "1", 0.2)))]
        effects += [Friction(f"rub_{i}", f"foot_{i}", law)]
    return Scene(
        Mechanism("curling", joints, tuple(pairs)),
        tuple(effects),
        Scales(length=Parameter("depth", "mm", 0.1), speed=Parameter("pace", "m/s", 1), arm=rim),
        Start(
            position={"up": radius - mass * gravity / (feet * stiffness)},
            speed={"floor.x": Parameter("slide", "m/s", 1), "floor.angle": Parameter("spin", "rad/s", 10)},
        ),
    )


TOP, OFFSET, BALL = 0.006, 0.003, 0.015  # kg, m, m


def tippe_top(law):
    """A ball whose mass centre lies OFFSET below its middle, spun about its axis, which is tilted a little."""
    mass, radius, offset = (
        Parameter("mass", "kg", TOP),
        Parameter("radius", "m", BALL),
        Parameter("offset", "m", OFFSET),
    )
    gravity, stiffness = Parameter("gravity", "m/s^2", GRAVITY), Parameter("stiffness", "N/m", 2e3)
    axial = Parameter("axial", "1", 0.4) * mass * radius**2
    across = Parameter("across", "1", 131 / 132 * 0.4) * mass * radius**2
    top = Body("top", mass=mass, inertia=(across, axial, across))
    return Scene(
        Mechanism(
            "tippe_top",
            (Free("flight", GROUND, top),),
            (SphereOnPlane("floor", top.at(0, offset, 0), radius, GROUND.at(0, 0, 0), Y),),
        ),
        (
            Gravity("gravity", gravity, direction=-Y),
            Contact("floor", power(stiffness, 1), kelvin_voigt(Parameter("restitution", "1", 0.1))),
            Friction("rub", "floor", law),
            EnergyLedger(),
        ),
        Scales(length=Parameter("depth", "mm", 0.1), speed=Parameter("pace", "m/s", 0.5), arm=radius),
        Start(
            position={
                "flight.y": radius - offset * math.cos(0.1) - mass * gravity / stiffness,
                "flight.q0": math.cos(0.05),
                "flight.q3": math.sin(0.05),
            },
            speed={"flight.angular_speed_y": Parameter("spin", "rad/s", 155)},
        ),
    )
