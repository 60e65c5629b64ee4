"""Pitch circles of couplings: radii from the distance of the shafts and the ratio, of racks and ropes from the ratio; and where there are none."""

import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.expressions.parameter import default_value

APART, RATIO = hd.Parameter("apart", "mm", 68), hd.Parameter("ratio", "1", 3)


def scene(coupling, axis=hd.Z, slide=hd.X):
    bodies = [
        hd.Body(name, hd.Parameter(f"m_{name}", "kg", 1), hd.Parameter(f"J_{name}", "kg m^2", 1))
        for name in ("wheel", "pinion", "rack")
    ]
    joints = (
        hd.Revolute("wheel", hd.GROUND, bodies[0], axis=hd.Z),
        hd.Revolute("pinion", hd.GROUND.at(0, APART, APART), bodies[1], axis=axis),
        hd.Prismatic("rack", hd.GROUND.at(APART, 0, 0), bodies[2], axis=slide),
    )
    scales = hd.Scales(length=APART, speed=hd.Parameter("pace", "m/s", 1), arm=APART)
    return hd.Scene(hd.Mechanism("gears", joints), (coupling, hd.EnergyLedger()), scales)


def circles(made):
    marks = [mark for effect in made.effects for mark in effect.landmarks(made) if mark[0] == "mesh"]
    return {place: default_value(beside["radius"]) for _, place, _, beside in marks if "radius" in beside}


@pytest.mark.parametrize(
    ("coupling", "axis", "expected"),
    [
        (hd.Coupling("mesh", "pinion", "wheel", ratio=-RATIO), hd.Z, {"first": 0.017, "second": 0.051}),
        (hd.Coupling("mesh", "wheel", "pinion", ratio=-1 / RATIO), hd.Z, {"first": 0.051, "second": 0.017}),
        (hd.Coupling("mesh", "pinion", "wheel", ratio=RATIO), -hd.Z, {"first": 0.017, "second": 0.051}),
        (hd.Coupling("belt", "pinion", "wheel", ratio=RATIO), hd.Z, {}),
        (hd.Coupling("bevel", "pinion", "wheel", ratio=-RATIO), hd.X, {}),
        (hd.Coupling("rack", "rack", "pinion", ratio=-APART / 2), hd.Z, {"second": 0.034}),
        (hd.Coupling("screw", "rack", "pinion", ratio=APART / 2), hd.X, {}),
    ],
)
def test_wheels_that_mesh_from_outside_have_pitch_circles(coupling, axis, expected):
    """Their radii add up to the distance of the shafts and have the ratio of the speeds, inversely."""
    assert circles(scene(coupling, axis)) == pytest.approx(expected)
