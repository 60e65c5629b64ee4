"""Blocks that slide: a sphere that does not turn, carried along and across a plane on a ramp too heavy to move."""

import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import kelvin_voigt, power

MASS, CARRIAGE, GRAVITY, STIFFNESS = 1.0, 0.25, 9.81, 1e5  # kg, kg, m/s^2, N/m
WEIGHT = MASS * GRAVITY  # N; the carriage is guided by the ramp: its weight does not press


def block(*friction, pull=None, turn=None):
    """One block per friction law, each on its own carriage. `pull` drives the first carriage, at that speed [m/s]; `turn` the ramp [rad/s]."""
    mass, radius, angle = (
        hd.Parameter("mass", "kg", MASS), hd.Parameter("radius", "m", 0.1), hd.Parameter("slope", "rad", 0),
    )  # fmt: skip
    gravity, stiffness = hd.Parameter("gravity", "m/s^2", GRAVITY), hd.Parameter("stiffness", "N/m", STIFFNESS)
    damping = kelvin_voigt(hd.Parameter("restitution", "1", 0.2))
    inertia = hd.Parameter("inertia", "kg m^2", 1)
    ramp = hd.Body(
        "ramp", mass=hd.Parameter("ramp_mass", "kg", 1), inertia=hd.Parameter("ramp_inertia", "kg m^2", 1e16)
    )
    joints, pairs, effects = [hd.Revolute("tilt", hd.GROUND, ramp, axis=hd.Z)], [], []
    position = {"tilt": -angle}
    for i in range(len(friction)):
        carriage = hd.Body(f"carriage_{i}", mass=hd.Parameter("carriage_mass", "kg", CARRIAGE), inertia=inertia)
        ball = hd.Body(f"ball_{i}", mass=mass, inertia=inertia)
        joints += [
            hd.Prismatic(f"along_{i}", ramp, carriage, axis=hd.X),
            hd.Prismatic(f"up_{i}", carriage, ball, axis=hd.Y),
        ]
        pairs.append(hd.SphereOnPlane(f"floor_{i}", ball.at(0, 0, 0), radius, ramp.at(0, 0, 0), hd.Y))
        effects.append(hd.Contact(f"floor_{i}", power(stiffness, 1), damping))
        resting = mass * gravity * sp.cos(angle) / stiffness
        position[f"up_{i}"] = radius - resting + hd.Parameter("height", "mm", 0)
    rubs = [hd.Friction(f"rub_{i}", f"floor_{i}", law) for i, law in enumerate(friction)]
    drive = [hd.ConstantSpeed("belt", "along_0", hd.Parameter("pull", "m/s", pull))] if pull else []
    if turn:
        drive.append(hd.ConstantSpeed("crane", "tilt", hd.Parameter("turn", "rad/s", turn)))
        del position["tilt"]
    speed = hd.Parameter("slide", "m/s", 0)
    return hd.Scene(
        hd.Mechanism("block", tuple(joints), tuple(pairs)),
        (*rubs[::-1], hd.Gravity("gravity", gravity, direction=-hd.Y), *effects, *drive, hd.EnergyLedger()),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=radius),
        hd.Start(position=position, speed={} if pull else {f"along_{i}": speed for i in range(len(friction))}),
    )
