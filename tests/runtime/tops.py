"""A disc on several feet that slides and spins on a floor, and a tippe-top."""

import math

import hertzwerk.derive as hd
from hertzwerk.derive.laws import kelvin_voigt, power

p = hd.Parameter
DISC, RING, GRAVITY = 2.0, 0.1, 9.81  # kg, m, m/s^2


def curling(law, feet):
    """A disc, m R^2/2, on feet at its rim, level: each carries its part of the weight."""
    mass, rim, radius = p("mass", "kg", DISC), p("rim", "m", RING), p("radius", "m", 0.01)
    gravity, stiffness = p("gravity", "m/s^2", GRAVITY), p("stiffness", "N/m", 1e5)
    tray, disc = hd.Body("tray", 0), hd.Body("disc", mass=mass, inertia=mass * rim**2 / 2)
    joints = (hd.Planar("floor", hd.GROUND, tray, normal=hd.Y), hd.Prismatic("up", tray, disc, axis=hd.Y))
    effects = [hd.Gravity("gravity", gravity, direction=-hd.Y), hd.EnergyLedger()]
    pairs = []
    for i in range(feet):
        x, z = (sum_ * rim for sum_ in (math.cos(2 * math.pi * i / feet), math.sin(2 * math.pi * i / feet)))
        pairs.append(hd.SphereOnPlane(f"foot_{i}", disc.at(x, 0, z), radius, hd.GROUND.at(0, 0, 0), hd.Y))
        effects += [hd.Contact(f"foot_{i}", power(stiffness, 1), kelvin_voigt(hd.Parameter("restitution", "1", 0.2)))]
        effects += [hd.Friction(f"rub_{i}", f"foot_{i}", law)]
    return hd.Scene(
        hd.Mechanism("curling", joints, tuple(pairs)),
        tuple(effects),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=rim),
        hd.Start(
            position={"up": radius - mass * gravity / (feet * stiffness)},
            speed={"floor.x": hd.Parameter("slide", "m/s", 1), "floor.angle": hd.Parameter("spin", "rad/s", 10)},
        ),
    )


TOP, OFFSET, BALL = 0.006, 0.003, 0.015  # kg, m, m


def tippe_top(law):
    """A ball whose mass centre lies OFFSET below its middle, spun about its axis, which is tilted a little."""
    mass, radius, offset = p("mass", "kg", TOP), p("radius", "m", BALL), p("offset", "m", OFFSET)
    gravity, stiffness = p("gravity", "m/s^2", GRAVITY), p("stiffness", "N/m", 2e3)
    axial = hd.Parameter("axial", "1", 0.4) * mass * radius**2
    across = hd.Parameter("across", "1", 131 / 132 * 0.4) * mass * radius**2
    top = hd.Body("top", mass=mass, inertia=(across, axial, across))
    floor = hd.SphereOnPlane("floor", top.at(0, offset, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y)
    height = radius - offset * math.cos(0.1) - mass * gravity / stiffness
    return hd.Scene(
        hd.Mechanism("tippe_top", (hd.Free("flight", hd.GROUND, top),), (floor,)),
        (
            hd.Gravity("gravity", gravity, direction=-hd.Y),
            hd.Contact("floor", power(stiffness, 1), kelvin_voigt(hd.Parameter("restitution", "1", 0.1))),
            hd.Friction("rub", "floor", law),
            hd.EnergyLedger(),
        ),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 0.5), arm=radius),
        hd.Start(
            position={"flight.y": height, "flight.q0": math.cos(0.05), "flight.q3": math.sin(0.05)},
            speed={"flight.angular_speed_y": hd.Parameter("spin", "rad/s", 155)},
        ),
    )
