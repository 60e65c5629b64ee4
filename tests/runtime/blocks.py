"""Blocks that slide: a sphere that does not turn, carried along and across a plane on a ramp too heavy to move."""

import sympy as sp

from hertzwerk.derive import (  # fmt: skip
    GROUND,
    Body,
    ConstantSpeed,
    Contact,
    EnergyLedger,
    Friction,
    Gravity,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    Start,
    X,
    Y,
    Z,
)
from hertzwerk.derive.laws import kelvin_voigt, power

MASS, CARRIAGE, GRAVITY, STIFFNESS = 1.0, 0.25, 9.81, 1e5  # kg, kg, m/s^2, N/m
WEIGHT = MASS * GRAVITY  # N; the carriage is guided by the ramp: its weight does not press


def block(*friction, pull=None, turn=None):
    """One block per friction law, each on its own carriage. `pull` drives the first carriage, at that speed [m/s]; `turn` the ramp [rad/s]."""
    mass, radius, angle = Parameter("mass", "kg", MASS), Parameter("radius", "m", 0.1), Parameter("slope", "rad", 0)
    gravity, stiffness = Parameter("gravity", "m/s^2", GRAVITY), Parameter("stiffness", "N/m", STIFFNESS)
    damping = kelvin_voigt(Parameter("restitution", "1", 0.2))
    inertia = Parameter("inertia", "kg m^2", 1)
    ramp = Body("ramp", mass=Parameter("ramp_mass", "kg", 1), inertia=Parameter("ramp_inertia", "kg m^2", 1e16))
    joints, pairs, effects = [Revolute("tilt", GROUND, ramp, axis=Z)], [], []
    position = {"tilt": -angle}
    for i in range(len(friction)):
        carriage = Body(f"carriage_{i}", mass=Parameter("carriage_mass", "kg", CARRIAGE), inertia=inertia)
        ball = Body(f"ball_{i}", mass=mass, inertia=inertia)
        joints += [Prismatic(f"along_{i}", ramp, carriage, axis=X), Prismatic(f"up_{i}", carriage, ball, axis=Y)]
        pairs.append(SphereOnPlane(f"floor_{i}", ball.at(0, 0, 0), radius, ramp.at(0, 0, 0), Y))
        effects.append(Contact(f"floor_{i}", power(stiffness, 1), damping))
        resting = mass * gravity * sp.cos(angle) / stiffness
        position[f"up_{i}"] = radius - resting + Parameter("height", "mm", 0)
    rubs = [Friction(f"rub_{i}", f"floor_{i}", law) for i, law in enumerate(friction)]
    drive = [ConstantSpeed("belt", "along_0", Parameter("pull", "m/s", pull))] if pull else []
    if turn:
        drive.append(ConstantSpeed("crane", "tilt", Parameter("turn", "rad/s", turn)))
        del position["tilt"]
    speed = Parameter("slide", "m/s", 0)
    return Scene(
        Mechanism("block", tuple(joints), tuple(pairs)),
        (*rubs[::-1], Gravity("gravity", gravity, direction=-Y), *effects, *drive, EnergyLedger()),
        Scales(length=Parameter("depth", "mm", 0.1), speed=Parameter("pace", "m/s", 1), arm=radius),
        Start(position=position, speed={} if pull else {f"along_{i}": speed for i in range(len(friction))}),
    )
