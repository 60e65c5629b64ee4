"""A ball that falls on a floor: a sound scene, of which tests replace a part to make it faulty; and the faults expected then."""

from dataclasses import replace

import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, power

BALL = hd.Body("ball", mass=hd.Parameter("mass", "kg", 1.0))
FALL = hd.Prismatic("fall", hd.GROUND, BALL, axis=hd.Y)
RADIUS = hd.Parameter("radius", "m", 0.1)
FLOOR = hd.SphereOnPlane("floor", BALL.at(0, 0, 0), RADIUS, hd.GROUND.at(0, 0, 0), normal=hd.Y)
GRAVITY = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), -hd.Y)
STIFFNESS = power(hd.Parameter("K", "N/m^1.5", 1e6), 1.5)
BOUNCE = hd.Contact("floor", STIFFNESS, flores(hd.Parameter("restitution", "1", 0.8)))
EFFECTS = (GRAVITY, BOUNCE, hd.EnergyLedger())
SCALES = hd.Scales(length=RADIUS, speed=hd.Parameter("pace", "m/s", 1), arm=RADIUS)


def drop(joints=(FALL,), pairs=(FLOOR,), effects=EFFECTS, scales=SCALES, start=None, name="drop"):
    """A sound scene unless something of it is replaced."""
    return hd.Scene(hd.Mechanism(name, joints, pairs), effects, scales, start or hd.Start())


def heavy(mass, **body):
    """The scene with another mass, or another body altogether."""
    ball = hd.Body("ball", mass=mass, **body)
    floor = replace(FLOOR, sphere=ball.at(0, 0, 0))
    return drop(joints=(replace(FALL, child=ball),), pairs=(floor,))


def refused(declare, where, found, expected):
    """One of the faults says where, what was found, and the way out; the text holds them all."""
    with pytest.raises(hd.InputError) as caught:
        declare()
    named = [fault for fault in caught.value.faults if where in fault.where]
    assert named, f"no fault at {where!r} in\n{caught.value}"
    ways = [(fault.found, f"{fault.expected} {fault.remedy}") for fault in named]
    assert any(found in what and expected in way for what, way in ways), str(caught.value)
    text = str(caught.value).replace("\n  ", "\n")
    for fault in caught.value.faults:  # what several places share is told once, with all of them
        assert fault.where in text
        assert str(fault).removeprefix(fault.where) in text
