"""The other pairs in motion, against closed forms; their built-in scenes are scenarios."""

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, power, smooth_coulomb
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.output.plots.curves import Curves

M, G, K = 0.5, 9.81, 1e7
REST = (M * G / K) ** (2 / 3)


# -- pairs in motion ---------------------------------------------------------------------------------------------------

SIZE, PACE, MASS = hd.Parameter("size", "m", 0.1), hd.Parameter("pace", "m/s", 1), hd.Parameter("mass", "kg", 0.5)
STIFF = power(hd.Parameter("K", "N/m^1.5", 1e7), sp.Rational(3, 2))
BLOCK = hd.Body("block", MASS, hd.Parameter("inertia", "kg m^2", 0.01))
FALL = hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", G), -hd.Y)
HERE, THERE = BLOCK.at(0, 0, 0), hd.GROUND.at(0, 0, 0)


def moving(pair, *effects, joint=None, **start):
    """A body and one pair; its start as x=0.1, x_speed=2.0 in SI."""
    joint = joint or hd.Planar("float", hd.GROUND, BLOCK)
    scales = hd.Scales(length=hd.Parameter("deep", "m", 1e-5), speed=PACE, arm=SIZE)
    effects = effects or (FALL, hd.Contact("touch", STIFF))
    units = {"speed": "m/s", "angle_speed": "rad/s"}
    model = load(hd.Scene(hd.Mechanism("moving", (joint,), (pair,)), (*effects, hd.EnergyLedger()), scales))
    initial = {
        f"float.{name}": (value, units.get(name, "m/s" if name.endswith("speed") else "m"))
        for name, value in start.items()
    }
    return lambda duration, tolerance=1e-9: simulate(model, duration=duration, tolerance=tolerance, initial=initial)


FACE = hd.CornerOnFace("touch", HERE, THERE, hd.Y, hd.X, hd.Parameter("length", "m", 0.2))


def test_a_corner_that_slides_off_its_face_falls_past_the_solid():
    run = moving(FACE, x=0.0, y=-REST, x_speed=1.0)(0.3)
    assert run.outcome.finished
    assert run.energy_residual < 1e-7  # the edge is a kink of the force, which is no event
    off = 0.1  # s, and 0.1 m
    assert np.max(np.abs(run["touch.normal_force"][run.t < 0.99 * off] - M * G)) < 1e-6 * M * G
    assert not np.any(run["touch.normal_force"][run.t > 1.01 * off])
    assert run["float.x"][-1] == pytest.approx(0.3, rel=1e-3)
    assert run["float.y"][-1] == pytest.approx(-G * (0.3 - off) ** 2 / 2, rel=2e-3)


def test_a_corner_from_beyond_the_end_meets_the_end_of_the_solid_and_none_passes_over_it():
    effects = (hd.Contact("touch", STIFF),)
    run = moving(FACE, *effects, x=0.2, y=-0.05, x_speed=-1.0)(0.2)
    assert [impact.contact for impact in run.impacts] == ["touch"]
    assert run.impacts[0].t == pytest.approx(0.1, rel=1e-9)
    assert run["float.x_speed"][-1] == pytest.approx(1.0, rel=1e-7)
    assert run["float.y"][-1] == pytest.approx(-0.05, rel=1e-12)
    above = moving(FACE, *effects, x=0.2, y=1e-6, x_speed=-1.0)(0.4)
    assert not above.impacts


def test_a_cylinder_set_down_sliding_ends_rolling_at_two_thirds_of_its_speed():
    """Angular momentum about the line of contact is conserved, whatever the friction: R m v = (1/2 + 1) m R v'."""
    radius = hd.Parameter("radius", "m", 0.1)
    roller = hd.Body("roller", MASS, MASS * radius**2 / 2)
    pair = hd.CylinderOnPlane("touch", roller.at(0, 0, 0), hd.Z, radius, hd.Parameter("length", "m", 0.3), THERE, hd.Y)
    rub = hd.Friction("rub", "touch", smooth_coulomb(hd.Parameter("mu", "1", 0.2), hd.Parameter("v_s", "m/s", 1e-3)))
    run = moving(
        pair,
        FALL,
        hd.Contact("touch", STIFF),
        rub,
        joint=hd.Planar("float", hd.GROUND, roller),
        y=0.1 - REST,
        x_speed=1.5,
    )(0.6)
    assert run["float.x_speed"][-1] == pytest.approx(1.0, rel=1e-4)
    assert run["float.angle_speed"][-1] == pytest.approx(-10.0, rel=1e-3)
    sliding = np.interp(0.1, run.t, run["float.x_speed"])
    assert sliding == pytest.approx(1.5 - 0.2 * G * 0.1, rel=1e-6)  # until v0/(3 mu g) = 0.255 s
    assert run.energy_residual < 1e-8


def test_a_cylinder_free_to_tilt_lies_on_its_two_rims_and_falls_over_onto_one():
    half, radius = hd.Parameter("half_length", "m", 0.15), hd.Parameter("radius", "m", 0.1)
    roller = hd.Body("roller", MASS, tuple(hd.Parameter(f"J_{k}", "kg m^2", 0.005) for k in "xyz"))
    rims = tuple(
        hd.RimOnPlane(name, roller.at(0, 0, side * half), hd.Z, radius, THERE, hd.Y)
        for name, side in (("near", -1), ("far", 1))
    )
    contacts = [hd.Contact(rim.name, STIFF) for rim in rims]
    scales = hd.Scales(length=hd.Parameter("deep", "m", 1e-5), speed=PACE, arm=SIZE)
    model = load(
        hd.Scene(
            hd.Mechanism("lying", (hd.Free("float", hd.GROUND, roller),), rims),
            (FALL, *contacts, hd.EnergyLedger()),
            scales,
        )
    )
    deep = (M * G / 2 / K) ** (2 / 3)
    still = simulate(model, duration=0.05, initial={"float.y": (0.1 - deep, "m")}, tolerance=1e-6)
    for rim in rims:
        assert still[f"{rim.name}.normal_force"] == pytest.approx(M * G / 2, rel=1e-6)
    tilt = 0.2  # about X: the far end is lower, its rim's lowest point at 0.1 cos + 0.15 sin below the centre
    height = 0.1 * np.cos(tilt) + 0.15 * np.sin(tilt)
    turned = {"float.q0": (np.cos(tilt / 2), "1"), "float.q1": (np.sin(tilt / 2), "1")}
    drop = simulate(model, duration=0.1, initial={"float.y": (height + 0.01, "m"), **turned}, tolerance=1e-6)
    assert drop.impacts[0].contact == "far"
    assert drop.impacts[0].t == pytest.approx(np.sqrt(2 * 0.01 / G), rel=1e-9)
    assert drop.energy_residual < 1e-7


# -- several clearances in one mechanism -------------------------------------------------------------------------------


def clearances(count):
    """A driven slider-crank: crank pin and slider pin with clearance, and for three the slider in a guide of two faces and four corners."""
    r, l, c = (
        hd.Parameter("crank_length", "m", 0.05),
        hd.Parameter("rod_length", "m", 0.12),
        hd.Parameter("clearance", "mm", 0.2),
    )
    w, bush = hd.Parameter("crank_speed", "rad/s", 100), hd.Parameter("bush", "mm", 10)
    a, b = hd.Parameter("half_length", "m", 0.03), hd.Parameter("half_width", "m", 0.02)
    crank = hd.Body("crank", hd.Parameter("crank_mass", "kg", 0.3), hd.Parameter("crank_inertia", "kg m^2", 1e-4))
    rod = hd.Body(
        "rod", hd.Parameter("rod_mass", "kg", 0.21), hd.Parameter("rod_inertia", "kg m^2", 2.5e-4), centre=(l / 2, 0, 0)
    )
    slider = hd.Body("slider", hd.Parameter("slider_mass", "kg", 0.14), hd.Parameter("slider_inertia", "kg m^2", 5e-5))
    pins = (
        hd.PinInBush("crank_pin", rod.at(0, 0, 0), crank.at(r, 0, 0), hd.Z, bush, c),
        hd.PinInBush("slider_pin", rod.at(l, 0, 0), slider.at(0, 0, 0), hd.Z, bush, c),
    )
    corners = tuple(
        hd.CornerOnFace(
            f"corner_{end}_{side}", slider.at(i * a, j * b, 0), hd.GROUND.at(l, j * (b + c), 0), -hd.Y if j > 0 else hd.Y, hd.X,
            hd.Parameter("guide", "m", 0.4)
        )
        for i, end in ((-1, "rear"), (1, "front")) for j, side in ((-1, "lower"), (1, "upper"))
    )  # fmt: skip
    pairs = pins if count == 2 else (*pins, *corners)
    guide = hd.Prismatic("guide", hd.GROUND, slider, axis=hd.X) if count == 2 else hd.Planar("guide", hd.GROUND, slider)
    along = "guide" if count == 2 else "guide.x"
    law = flores(hd.Parameter("restitution", "1", 0.8))
    contacts = [
        hd.Contact(pair.name, power(hd.Parameter("K", "N/m^1.5", 1e9), sp.Rational(3, 2)), law) for pair in pairs
    ]
    return hd.Scene(
        hd.Mechanism("several", (hd.Revolute("main_bearing", hd.GROUND, crank, axis=hd.Z), hd.Planar("rod", hd.GROUND, rod), guide), pairs),
        (hd.ConstantSpeed("crank_drive", "main_bearing", w), FALL, *contacts, hd.EnergyLedger()),
        hd.Scales(length=c, speed=r * w, arm=l),
        hd.Start(position={"rod.x": r, along: r + l}, speed={"rod.y_speed": r * w, "rod.angle_speed": -r * w / l}),
    )  # fmt: skip


@pytest.mark.parametrize("count", [2, 3])
def test_several_clearances_in_one_mechanism(count):
    run = simulate(load(clearances(count)), duration=2 * np.pi / 100, tolerance=1e-9)
    assert run.outcome.finished
    assert run.energy_residual < 1e-7
    struck = {impact.contact for impact in run.impacts}
    assert {"crank_pin", "slider_pin"} <= struck
    assert any(name.startswith("corner") for name in struck) == (count == 3)
    for pair in run.engine.model.pairs:
        assert -2e-4 < np.min(run[f"{pair}.gap"]) < 2e-4
        assert np.all(run[f"{pair}.gap"] < 1e-3)  # nothing has come apart
    curves = Curves.of(run)
    name = "guide.travel" if count == 2 else "guide.x"
    angle = 100.0 * run.t
    ideal = 0.05 * np.cos(angle) + np.sqrt(0.12**2 - (0.05 * np.sin(angle)) ** 2)
    assert np.max(np.abs(run[name] - ideal)) < 3 * 2e-4  # both clearances, and what the rod's angle adds
    assert (curves.ideal is not None) == (count == 2)
    if count == 2:
        turned = 100.0 * curves.t
        closed = 0.05 * np.cos(turned) + np.sqrt(0.12**2 - (0.05 * np.sin(turned)) ** 2)
        assert curves.ideal["guide.travel"] == pytest.approx(closed, rel=1e-10)


def test_a_pin_sinks_into_its_bush_by_the_energy_of_its_speed():
    """m v^2/2 = K d^2.5/2.5, so deep beside the clearance that the event function of a journal is no distance."""
    mass, speed, stiffness, clearance = 0.3, 2.0, 3.3e10, 1e-4
    pin = hd.Body("pin", hd.Parameter("mass", "kg", mass))
    room, bush = hd.Parameter("clearance", "m", clearance), hd.Parameter("bush_radius", "m", 0.01)
    pace = hd.Parameter("pace", "m/s", speed)
    scene = hd.Scene(
        hd.Mechanism(
            "shot",
            (hd.Prismatic("across", hd.GROUND, pin, axis=hd.X),),
            (hd.PinInBush("joint", pin.at(0, 0, 0), hd.GROUND.at(0, 0, 0), hd.Z, bush, room),),
        ),
        (hd.Contact("joint", power(hd.Parameter("stiffness", "N/m^1.5", stiffness), 1.5)), hd.EnergyLedger()),
        hd.Scales(room, pace),
        hd.Start(speed={"across": pace}),
    )
    run = simulate(load(scene), duration="0.3 ms", tolerance=1e-9, compiled=False)
    depth = (1.25 * mass * speed**2 / stiffness) ** 0.4
    assert 0.5 < depth / clearance < 1
    assert run.impacts[0].peak_penetration == pytest.approx(depth, rel=1e-7)
    assert run.impacts[0].peak_force == pytest.approx(stiffness * depth**1.5, rel=1e-7)
    assert run["joint.penetration"].max() == pytest.approx(run["across.travel"].max() - clearance, rel=1e-9)
