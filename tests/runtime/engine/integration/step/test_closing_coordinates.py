"""Coordinates of closing joints in effects, couplings and expressions: the same motion as where these joints carry their bodies."""

import re
from functools import cache

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

SIDES = {"crank": 0.3, "coupler": 0.9, "rocker": 0.7}
BASE = 0.8
SCALES = hd.Scales(hd.Parameter("size", "m", 1), hd.Parameter("pace", "m/s", 1), arm=hd.Parameter("arm", "m", 1))


def p(name, unit, value):
    return hd.Parameter(name, unit, value)


def bars():
    return {
        name: hd.Body(
            name, p(f"m_{name}", "kg", 1 + x), p(f"J_{name}", "kg m^2", x**2 / 12), (p(f"s_{name}", "m", x / 2), 0, 0)
        )
        for name, x in SIDES.items()
    }


def effects(name, rack):
    """Everything that asks for a coordinate or speed of a joint, on the one of this name."""
    angle, rate = hd.coordinate_of(name), hd.speed_of(name)
    found = (
        hd.Gravity("gravity", p("g", "m/s^2", 9.81), direction=-hd.Y),
        hd.JointSpring("spring", name, p("k", "N m/rad", 20), rest=p("rest", "rad", 0.3)), hd.JointDamper("damper", name, p("c", "N m s/rad", 0.4)),
        hd.JointForce("load", "main", p("a", "N m/rad", 2) * angle - p("b", "N m s/rad", 0.1) * rate),
        hd.Potential("well", p("w", "N m/rad^3", 3) * angle**4 / p("one", "rad", 1)), hd.EnergyLedger(),
    )  # fmt: skip
    return (*found, hd.Coupling("rack_mesh", rack, name, ratio=p("radius", "m", 0.05))) if rack else found


@cache
def four_bar(*, closing, rack=False):
    """Four-bar whose joint "pin" closes the loop, or carries the rocker; the other joint of the rocker does the other."""
    bar, ends = bars(), {name: p(f"l_{name}", "m", length) for name, length in SIDES.items()}
    main = hd.Revolute("main", hd.GROUND, bar["crank"], axis=hd.Z)
    knee = hd.Revolute("knee", bar["crank"].at(ends["crank"], 0, 0), bar["coupler"], axis=hd.Z)
    pin = hd.Revolute(
        "pin", bar["coupler"].at(ends["coupler"], 0, 0), bar["rocker"].at(ends["rocker"], 0, 0), axis=hd.Z
    )
    foot = hd.Revolute("foot", hd.GROUND.at(p("base", "m", BASE), 0, 0), bar["rocker"], axis=hd.Z)
    slide = (hd.Prismatic("rack", hd.GROUND, hd.Body("rack", p("m_rack", "kg", 2)), axis=hd.X),) if rack else ()
    joints = (main, knee, *((foot, pin) if closing else (pin, foot)), *slide)
    other = {"foot": 1.9} if closing else {"pin": 0.9}
    start = hd.Start(position={"main": p("start", "rad", 1.1)}, speed={"main": p("turning", "rad/s", 2)},
                  near={"knee": p("knee_start", "rad", -0.4), **{name: p(f"{name}_start", "rad", x) for name, x in other.items()}})  # fmt: skip
    return hd.Scene(hd.Mechanism("four_bar", joints), effects("pin", "rack" if rack else ""), SCALES, start)


HOW = {"duration": "0.8 s", "tolerance": 1e-10, "compiled": False}


@pytest.mark.parametrize("rack", [False, True])
def test_a_closing_angle_acts_as_that_of_a_joint_that_carries(rack):
    closing, carrying = (simulate(load(four_bar(closing=which, rack=rack)), **HOW) for which in (True, False))
    assert closing.outcome.finished and abs(closing.energy_residual) < 1e-8
    t = np.linspace(0, 0.8, 9)
    one, other = closing.at(t), carrying.at(t)
    for name in ("main.angle", "knee.angle", "pin.angle", "pin.speed", *(("rack.travel",) if rack else ())):
        assert one[name] - one[name][0] == pytest.approx(other[name] - other[name][0], abs=2e-7), name
    turned = round((one["pin.angle"][0] - other["pin.angle"][0]) / (2 * np.pi), 9)
    assert turned == 0 and np.ptp(one["pin.angle"]) > 0.3
    for name in ("spring.torque", "damper.power", "well.stored_energy"):
        assert one[name] == pytest.approx(other[name], abs=1e-5), name
    if rack:
        assert one["rack_mesh.force"] == pytest.approx(other["rack_mesh.force"], abs=1e-4)


def test_a_closing_angle_acts_alike_in_absolute_coordinates():
    tree, absolute = (
        simulate(load(four_bar(closing=True).with_coordinates(kind)), **HOW) for kind in ("tree", "absolute")
    )
    t = np.linspace(0, 0.8, 9)
    assert tree.at(t)["pin.angle"] == pytest.approx(absolute.at(t)["pin.angle"], abs=2e-7)


def test_a_closing_travel_acts_as_that_of_a_joint_that_carries():
    """Slider-crank whose slider hangs on the rod, and whose guide carries it."""
    found = []
    for closing in (True, False):
        bar, slider = bars(), hd.Body("slider", p("m_slider", "kg", 1), p("J_slider", "kg m^2", 0.1))
        main = hd.Revolute("main", hd.GROUND, bar["crank"], axis=hd.Z)
        knee = hd.Revolute("knee", bar["crank"].at(p("r", "m", 0.3), 0, 0), bar["coupler"], axis=hd.Z)
        wrist = hd.Revolute("wrist", bar["coupler"].at(p("l", "m", 0.9), 0, 0), slider, axis=hd.Z)
        guide = hd.Prismatic("guide", hd.GROUND.at(p("x", "m", 0.2), 0, 0), slider, axis=hd.X)
        spring = hd.JointSpring("spring", "guide", p("k", "N/m", 300), rest=p("rest", "m", 0.7))
        push = hd.JointForce(
            "push", "guide", -p("c", "N s/m", 3) * hd.speed_of("guide") - p("k2", "N/m^2", 9) * hd.coordinate_of("guide") ** 2,
        )  # fmt: skip
        start = hd.Start(position={"main": p("start", "rad", 1.1)}, near={"knee": p("knee_start", "rad", -1.4)})
        joints = (main, knee, *((wrist, guide) if closing else (guide, wrist)))
        found.append(
            simulate(
                load(hd.Scene(hd.Mechanism("crank", joints), (spring, push, hd.EnergyLedger()), SCALES, start)), **HOW
            )
        )
    t = np.linspace(0, 0.8, 9)
    one, other = (run.at(t) for run in found)
    for name in ("guide.travel", "guide.speed", "main.angle", "spring.force", "push.power"):
        assert one[name] == pytest.approx(other[name], abs=1e-6), name
    assert np.ptp(one["guide.travel"]) > 0.1


def spatial(*more):
    """Loop in space that a revolute closes: a plate on a ball, held by an arm on the ground."""
    arm, plate = (
        hd.Body(name, p(f"m_{name}", "kg", 1), (p(f"J_{name}", "kg m^2", 0.1),) * 3) for name in ("arm", "plate")
    )
    column, ball = (
        hd.Cylindrical("column", hd.GROUND, arm, axis=hd.Z),
        hd.Spherical("ball", arm.at(p("r", "m", 0.5), 0, 0), plate),
    )
    closing = hd.Revolute("hinge", hd.GROUND.at(p("x", "m", 1), 0, 0), plate.at(p("l", "m", 0.5), 0, 0), axis=hd.Y)
    return hd.Scene(hd.Mechanism("loop", (column, ball, closing)), (*more, hd.EnergyLedger()), SCALES)


def test_drives_of_closing_angles_in_space_and_joints_without_coordinates_are_refused_by_name():
    with pytest.raises(
        hd.InputError, match=re.compile("'hinge', which closes a loop.*declare this one before", re.DOTALL)
    ):
        spatial(hd.Drive("drive", "hinge", position=p("zero", "rad", 0)))
    with pytest.raises(hd.InputError, match="joint 'ball'"):
        spatial(hd.JointSpring("spring", "ball", p("k", "N m/rad", 1)))
    scene = spatial(hd.JointDamper("damper", "hinge", p("c", "N m s/rad", 1)))
    assert "hinge" in scene.scalars and scene.mechanism.wrapped == ("hinge",) and not scene.states
