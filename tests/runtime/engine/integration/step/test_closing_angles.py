"""Angles of joints that close loops in space, whole turns counted: closed forms, and the same motion where they carry their bodies."""

import re
from functools import cache

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.declare.effects.effect import Element
from hertzwerk.runtime import equilibrium, load, modes, simulate

pytestmark = pytest.mark.by_turns(2)  # methods and coordinates that run the same code

p = hd.Parameter
SCALES = hd.Scales(p("size", "m", 1), p("pace", "m/s", 1), arm=p("arm", "m", 1))
BETA, TURNED = 0.5, 8.0
CRANK, ROD, ROCKER, BASE = 0.3, 1.0, 0.6, (0.9, 0.2, 0.1)
four_ways = pytest.mark.parametrize(
    ("closing", "coordinates"),
    [
        (True, "tree"),
        pytest.param(False, "absolute", marks=pytest.mark.slow),
        *(pytest.param(*way, marks=pytest.mark.exhaustive) for way in ((True, "absolute"), (False, "tree"))),
    ],
)


def solid(name, mass, *inertia, centre=(0, 0, 0)):
    moments = tuple(p(f"J_{name}_{i}", "kg m^2", x) for i, x in enumerate(inertia))
    return hd.Body(name, p(f"m_{name}", "kg", mass), moments, centre)


def cardan(*effects, closing=True, coordinates="tree", near=None, driven=True):
    """Two shafts at an angle joined by a universal joint, the second of which closes a loop: turned forward and back."""
    one, two, wheel = (
        solid("one", 1, 0.02, 0.03, 0.025), solid("two", 1, 0.02, 0.03, 0.025), solid("wheel", 1, 0.1, 0.1, 0.1),
    )  # fmt: skip
    cross = hd.Universal("cross", one, two, first=hd.Y, second=hd.Z)
    out = hd.Revolute("out", hd.GROUND.at(0, 0, 0).turned(hd.Z, p("beta", "rad", BETA)), two, axis=hd.X)
    loop = (cross, out) if closing else (out, cross)
    joints = (
        hd.Revolute("inn", hd.GROUND, one, axis=hd.X), *loop, hd.Revolute("wheel", hd.GROUND.at(0, 0, p("aside", "m", 1)), wheel, axis=hd.X),
    )  # fmt: skip
    shake = (hd.Harmonic("shake", "inn", p("A", "rad", TURNED), frequency=p("w", "rad/s", 2)),) if driven else ()
    still = {} if driven else {"inn": p("still", "rad", 0)}
    start = hd.Start(position=still, near=near or {})
    return hd.Scene(
        hd.Mechanism("cardan", joints), (*shake, *effects, hd.EnergyLedger()), SCALES, start
    ).with_coordinates(coordinates)


SPRING = hd.JointSpring("spring", "out", p("k", "N m/rad", 2))
GEAR = hd.Coupling("gear", "wheel", "out", ratio=p("i", "1", -2))
COUNTS = tuple(
    hd.CountedAngle(f"count_{joint.replace('.', '_')}", joint)
    for joint in ("inn", "wheel", "cross.angle_1", "cross.angle_2")
)


def followed(turned):
    """Angle of the second shaft, tan(out) = tan(in)/cos(beta), on the turn of the first."""
    wrapped = np.arctan2(np.sin(turned), np.cos(turned) * np.cos(BETA))
    return wrapped + 2 * np.pi * np.round((turned - wrapped) / (2 * np.pi))


@four_ways
def test_a_cardan_shaft_turns_forward_and_back_as_the_textbook_says(closing, coordinates):
    scene = cardan(SPRING, GEAR, *COUNTS, closing=closing, coordinates=coordinates)
    run = simulate(load(scene), duration="2.4 s", tolerance=1e-9, compiled=False)
    assert run.outcome.finished and abs(run.energy_residual) < 1e-9
    exact = followed(TURNED * np.sin(2 * run.t))
    assert exact.max() > 7 and exact.min() < -7
    assert run["out.angle"] == pytest.approx(exact, abs=1e-9)
    assert run["wheel.angle"] == pytest.approx(-2 * exact, abs=1e-9)
    assert run["spring.torque"] == pytest.approx(-2 * exact, abs=1e-8)
    # the cross: angle_2 is that of the second axis against the first's plane, by the direction of the second shaft in the first
    turned = TURNED * np.sin(2 * run.t)
    assert run["cross.angle_2"] == pytest.approx(np.arcsin(np.sin(BETA) * np.cos(turned)), abs=1e-9)
    assert run["cross.angle_1"] == pytest.approx(np.arctan(np.tan(BETA) * np.sin(turned)), abs=1e-9)


def test_an_angle_whose_turns_are_not_followed_is_found(monkeypatch):
    monkeypatch.setattr(hd.CountedAngle, "element", lambda self, kin: Element(rates={"near": sp.S.Zero}))
    run = simulate(load(cardan(SPRING)), duration="1 s", tolerance=1e-6, compiled=False, max_steps=2000)
    assert not run.outcome.finished or np.abs(run["out.angle"] - followed(TURNED * np.sin(2 * run.t))).max() > 6


def test_a_start_says_on_which_turn():
    scene = cardan(SPRING, near={"out": p("turned", "rad", 2 * np.pi)}, driven=False)
    run = simulate(load(scene), duration="1 ms", tolerance=1e-9, compiled=False)
    assert run["out.angle"][0] == pytest.approx(2 * np.pi, abs=1e-12)
    assert run["spring.torque"][0] == pytest.approx(-4 * np.pi, abs=1e-9)
    run = simulate(
        load(cardan(SPRING, driven=False)), duration="1 ms", initial={"out_count.near": "-6 rad"}, compiled=False
    )
    assert run["out.angle"][0] == pytest.approx(-2 * np.pi, abs=1e-12)


# -- a loop with a crank, a rod on a ball and on a universal joint, and a rocker ----------------------------------------


@cache
def loop(closing=True, coordinates="tree"):
    """A spatial four-bar, R-S-U-R: its rocker is carried by the rod, or by the ground, where the universal joint closes the loop."""
    crank, rod = (
        solid("crank", 1, 0.11, 0.12, 0.15),
        solid("rod", 0.7, 0.02, 0.09, 0.1, centre=(p("s", "m", 0.5), 0, 0)),
    )
    rocker = solid("rocker", 0.9, 0.1, 0.13, 0.14)
    main, ball = (
        hd.Revolute("main", hd.GROUND, crank, axis=hd.Z),
        hd.Spherical("ball", crank.at(p("r", "m", CRANK), 0, 0), rod),
    )
    cross = hd.Universal(
        "cross", rod.at(p("l", "m", ROD), 0, 0), rocker.at(p("b", "m", ROCKER), 0, 0), first=hd.Y, second=hd.Z
    )
    hinge = hd.Revolute(
        "hinge", hd.GROUND.at(*(p(f"base_{i}", "m", x) for i, x in zip("xyz", BASE, strict=True))), rocker, axis=hd.Y
    )
    near = {"cross.angle_1": p("near", "rad", 0.6)} if closing else {"hinge": p("near", "rad", 1.1)}
    effects = (
        hd.Gravity("gravity", p("g", "m/s^2", 9.81), direction=-hd.Z),
        hd.JointSpring("spring", "hinge", p("k", "N m/rad", 5), rest=p("rest", "rad", 0.1)),
        hd.JointSpring("soft", "cross.angle_1", p("k2", "N m/rad", 3)), hd.JointDamper("damper", "cross.angle_2", p("c", "N m s/rad", 0.05)),
        hd.JointForce("feed", "main", p("fed", "N m/rad", 0.2) * hd.coordinate_of("cross.angle_2")), hd.CountedAngle("count", "main"),
        hd.EnergyLedger(),
    )  # fmt: skip
    start = hd.Start(position={"main": p("start", "rad", 0.4)}, speed={"main": p("turning", "rad/s", 9)}, near=near)
    return hd.Scene(
        hd.Mechanism("loop", (main, ball, *((cross, hinge) if closing else (hinge, cross)))), effects, SCALES, start
    ).with_coordinates(coordinates)


HOW = {"duration": "0.6 s", "tolerance": 1e-11, "compiled": False}


@cache
def carried():
    return simulate(load(loop(closing=False)), **HOW)


@pytest.mark.parametrize(
    ("closing", "coordinates"),
    [
        pytest.param(True, "tree", marks=pytest.mark.slow),
        *(pytest.param(closing, "absolute", marks=pytest.mark.exhaustive) for closing in (True, False)),
    ],
)
def test_a_loop_moves_alike_whichever_joint_closes_it(closing, coordinates):
    run, t = simulate(load(loop(closing=closing, coordinates=coordinates)), **HOW), np.linspace(0, 0.6, 9)
    one, other = run.at(t), carried().at(t)
    assert run.outcome.finished and abs(run.energy_residual) < 1e-9
    assert np.ptp(one["hinge.angle"]) > 0.5
    for name in (
        "main.angle", "hinge.angle", "cross.angle_1", "cross.angle_2", "hinge.speed", "cross.angle_1_speed",
        "cross.angle_2_speed",
    ):  # fmt: skip
        assert one[name] == pytest.approx(other[name], abs=1e-9), name
    for name in ("spring.torque", "soft.torque", "damper.power", "feed.torque"):
        assert one[name] == pytest.approx(other[name], abs=1e-8), name
    # input-output equation of a spatial four-bar with a rod on two spherical joints (Denavit, Hartenberg 1964): its length
    theta, phi, (x, y, z) = one["main.angle"], one["hinge.angle"], BASE
    ends = x + ROCKER * np.cos(phi) - CRANK * np.cos(theta), y - CRANK * np.sin(theta), z - ROCKER * np.sin(phi)
    assert sum(end**2 for end in ends) == pytest.approx(np.full(9, ROD**2), abs=1e-9)


@pytest.mark.slow
def test_its_derivatives_are_those_of_differences():
    model, h = load(loop()), 1e-4
    how = {**HOW, "duration": "0.3 s"}
    run = simulate(model, **how, sensitivities=("k", "rest"))
    for name, unit, value in (("k", "N m/rad", 5), ("rest", "rad", 0.1)):
        up, down = (simulate(model, **how, parameters={name: f"{value * (1 + sign * h)!r} {unit}"}) for sign in (1, -1))
        for history in ("hinge.angle", "cross.angle_1", "cross.angle_2"):
            slope = (up[history][-1] - down[history][-1]) / (2 * h * value)
            assert run.sensitivities()[history, name][-1] == pytest.approx(slope, rel=1e-6), (history, name)


@pytest.mark.slow
def test_it_rests_and_vibrates_alike():
    found = [equilibrium(load(loop(closing=closing))) for closing in (True, False)]
    one, other = (modes(rest).modes for rest in found)
    assert len(one) == len(other) == 1  # what counts turns is no freedom
    assert one[0].frequency == pytest.approx(other[0].frequency, rel=1e-8)


def test_axes_of_a_universal_joint_may_be_oblique():
    """In absolute coordinates, where its angles are those of a joint that closes a loop, against its own coordinates."""
    bob = solid("bob", 1, 0.02, 0.03, 0.04, centre=(p("d", "m", 0.3), 0, p("e", "m", -0.2)))
    hung = hd.Universal("hung", hd.GROUND, bob, first=hd.Y, second=hd.Direction((1, 1, 2)))
    effects = (
        hd.Gravity("gravity", p("g", "m/s^2", 9.81), direction=-hd.Z),
        *(hd.JointSpring(f"spring_{i}", f"hung.angle_{i}", p("k", "N m/rad", 2)) for i in (1, 2)),
        hd.EnergyLedger(),
    )
    start = hd.Start(
        position={"hung.angle_1": p("a", "rad", 4.5)},
        speed={"hung.angle_1": p("wa", "rad/s", 9), "hung.angle_2": p("wb", "rad/s", -8)},
    )
    scene, t = hd.Scene(hd.Mechanism("hung", (hung,)), effects, SCALES, start), np.linspace(0, 1, 6)
    one, other = (
        simulate(load(scene.with_coordinates(kind)), duration="1 s", tolerance=1e-11, compiled=False).at(t)
        for kind in ("absolute", "tree")
    )
    assert np.ptp(other["hung.angle_2"]) > 1 and other["hung.angle_1"].max() > 4
    for name in ("hung.angle_1", "hung.angle_2", "hung.angle_1_speed", "hung.angle_2_speed"):
        assert one[name] == pytest.approx(other[name], abs=1e-8), name


# -- what is refused ---------------------------------------------------------------------------------------------------


def test_an_angle_that_is_a_coordinate_is_not_counted_nor_one_that_nothing_requests():
    slide = hd.Prismatic("slide", hd.GROUND, solid("block", 1, 0.1, 0.1, 0.1), axis=hd.X)
    spatial = hd.Revolute("turn", slide.child, solid("arm", 1, 0.1, 0.1, 0.1), axis=hd.X)
    flat = hd.Revolute("turn", slide.child, solid("arm", 1, 0.1, 0.1, 0.1), axis=hd.Z)
    for joint, key, found in (
        (spatial, "slide", "slide, a travel"), (flat, "turn", "turn, a plane angle"), (spatial, "none", "joint 'none'"),
    ):  # fmt: skip
        with pytest.raises(hd.InputError, match=found):
            hd.Scene(hd.Mechanism("arm", (slide, joint)), (hd.CountedAngle("count", key), hd.EnergyLedger()), SCALES)
    hd.Scene(
        hd.Mechanism("arm", (slide, spatial)), (hd.CountedAngle("count", "turn"), hd.EnergyLedger()), SCALES
    )  # for absolute coordinates
    with pytest.raises(hd.InputError, match=re.compile("out_count.*unique", re.DOTALL)):
        cardan(SPRING, hd.JointDamper("out_count", "inn", p("c", "N m s/rad", 1)))
    assert not cardan(
        hd.JointDamper("damper", "out", p("c", "N m s/rad", 1)), GEAR.__class__("gear", "wheel", "inn", ratio=-2)
    ).states
    assert list(cardan(SPRING).states) == ["out_count.near"]
    assert list(cardan(near={"out": p("turned", "rad", 1)}).states) == ["out_count.near"]  # asked for by the start
    assert not cardan(SPRING).without("spring").states  # what nothing asks for any more
    assert list(cardan(SPRING).without("out_count").states) == ["out_count.near"]
