"""Pitch circles of couplings: radii from the distance of the shafts and the ratio, of racks and ropes from the ratio; and where there are none."""

import pytest

from hertzwerk.derive import (
    GROUND,
    Body,
    Coupling,
    EnergyLedger,
    Mechanism,
    Parameter,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    X,
    Z,
)
from hertzwerk.derive.expressions.parameter import default_value

APART, RATIO = Parameter("apart", "mm", 68), Parameter("ratio", "1", 3)


def scene(coupling, axis=Z, slide=X):
    bodies = [
        Body(name, Parameter(f"m_{name}", "kg", 1), Parameter(f"J_{name}", "kg m^2", 1))
        for name in ("wheel", "pinion", "rack")
    ]
    joints = (
        Revolute("wheel", GROUND, bodies[0], axis=Z),
        Revolute("pinion", GROUND.at(0, APART, APART), bodies[1], axis=axis),
        Prismatic("rack", GROUND.at(APART, 0, 0), bodies[2], axis=slide),
    )
    scales = Scales(length=APART, speed=Parameter("pace", "m/s", 1), arm=APART)
    return Scene(Mechanism("gears", joints), (coupling, EnergyLedger()), scales)


def circles(made):
    marks = [mark for effect in made.effects for mark in effect.landmarks(made) if mark[0] == "mesh"]
    return {place: default_value(beside["radius"]) for _, place, _, beside in marks if "radius" in beside}


@pytest.mark.parametrize(
    ("coupling", "axis", "expected"),
    [
        (Coupling("mesh", "pinion", "wheel", ratio=-RATIO), Z, {"first": 0.017, "second": 0.051}),
        (Coupling("mesh", "wheel", "pinion", ratio=-1 / RATIO), Z, {"first": 0.051, "second": 0.017}),
        (Coupling("mesh", "pinion", "wheel", ratio=RATIO), -Z, {"first": 0.017, "second": 0.051}),
        (Coupling("belt", "pinion", "wheel", ratio=RATIO), Z, {}),
        (Coupling("bevel", "pinion", "wheel", ratio=-RATIO), X, {}),
        (Coupling("rack", "rack", "pinion", ratio=-APART / 2), Z, {"second": 0.034}),
        (Coupling("screw", "rack", "pinion", ratio=APART / 2), X, {}),
    ],
)
def test_wheels_that_mesh_from_outside_have_pitch_circles(coupling, axis, expected):
    """Their radii add up to the distance of the shafts and have the ratio of the speeds, inversely."""
    assert circles(scene(coupling, axis)) == pytest.approx(expected)
