"""Belts on drums: Euler and Eytelwein's ratio, a capstan that lowers a load, band brakes; and friction of a ball joint."""

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate

p = hd.Parameter
G, M, J, R, MU, V_S, WRAP, HOLD = 9.81, 40.0, 0.5, 0.1, 0.25, 1e-3, 1.5 * np.pi, 60.0
SIZE = p("size", "m", 0.2)
SCALES = hd.Scales(SIZE, p("pace", "m/s", 1), arm=SIZE)
DRY = hd.laws.smooth_coulomb(p("mu", "1", MU), p("v_s", "m/s", V_S))
DOWN = hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Y)
weight, wheel = (
    hd.Body("weight", p("mass", "kg", M)),
    hd.Body("wheel", p("wheel_mass", "kg", 5), inertia=p("J", "kg m^2", J)),
)
HANGS, TURNS = hd.Prismatic("fall", hd.GROUND, weight, axis=-hd.Y), hd.Revolute("axle", hd.GROUND, wheel, axis=hd.Z)
GIVEN = p("hold", "N", HOLD), p("radius", "m", R), p("wrap", "rad", WRAP)


def capstan(drum="", load_at="fall", *, joints=(HANGS,), effects=(DOWN,), coordinates="tree", **start):
    effects = *effects, hd.BeltOnDrum("rope", drum, load_at, DRY, *GIVEN), hd.EnergyLedger()
    return hd.Scene(hd.Mechanism("capstan", joints), effects, SCALES, hd.Start(**start), coordinates=coordinates)


RATIO = np.exp(MU * WRAP)


@pytest.mark.parametrize(("coordinates", "method"), [("tree", "dop853"), ("absolute", "esdirk")])
def test_a_load_is_lowered_around_a_bollard(coordinates, method):
    """Sixty newtons lower a load: it falls by g - T exp(mu wrap)/m; heat is all that the rope takes but for the hold's."""
    run = simulate(load(capstan(coordinates=coordinates)), duration=0.5, tolerance=1e-10, method=method)
    a = G - HOLD * RATIO / M
    assert run["rope.load"][-1] == pytest.approx(HOLD * RATIO, rel=1e-12)
    early = run.at(np.array([0.1]))
    assert run["fall.speed"][-1] - early["fall.speed"][0] == pytest.approx(a * 0.4, rel=1e-9)
    fallen, heat = (run[name][-1] for name in ("fall.travel", "rope.dissipated"))
    slid = fallen - early["fall.travel"][0]
    assert heat - early["rope.dissipated"][0] == pytest.approx(HOLD * (RATIO - 1) * slid, rel=1e-8)
    assert run["rope.input"][-1] == pytest.approx(-HOLD * fallen, rel=1e-9)
    assert run.energy_residual < 1e-9


def test_a_hold_that_suffices_creeps():
    """Where m g < T exp(mu wrap) the rope creeps with mu wrap tanh(v/v_s) = ln(m g/T)."""
    hold = 1.2 * M * G / RATIO
    run = simulate(load(capstan()), duration=2.0, tolerance=1e-9, parameters={"hold": (hold, "N")})
    assert run["fall.speed"][-1] == pytest.approx(V_S * np.arctanh(np.log(M * G / hold) / (MU * WRAP)), rel=1e-7)


def test_a_turning_capstan_hauls():
    """The drum's slip over the rope reverses the friction: a hold T lifts up to T exp(mu wrap)."""
    run = simulate(
        load(capstan("axle", joints=(HANGS, TURNS), speed={"axle": p("w", "rad/s", -100)})),
        duration=0.05, tolerance=1e-10, parameters={"mass": (HOLD * RATIO / G / 2, "kg")},
    )  # fmt: skip
    late, early = run.at(np.array([0.05, 0.01]))["fall.speed"]
    assert (late - early) / 0.04 == pytest.approx(-G, rel=1e-9)  # pulled with twice its weight
    turned = np.diff(run.at(np.array([0.01, 0.05]))["axle.speed"])[0]
    assert turned == pytest.approx(R * HOLD * (RATIO - 1) / J * 0.04, rel=1e-9)
    assert run.energy_residual < 1e-9


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_band_brake(sense, coordinates):
    """Torque T r (exp(mu wrap) - 1) where the drum runs against the anchor, else T r (1 - exp(-mu wrap))."""
    speed = {"axle": p("w", "rad/s", sense * 50)}
    scene = capstan("axle", "", joints=(TURNS,), effects=(), coordinates=coordinates, speed=speed)
    run = simulate(load(scene), duration=0.2, tolerance=1e-10)
    torque = HOLD * R * ((1 - 1 / RATIO) if sense > 0 else (RATIO - 1))
    assert run["axle.speed"][-1] == pytest.approx(sense * (50 - torque / J * 0.2), rel=1e-9)
    assert run["rope.torque"][-1] == pytest.approx(-sense * torque, rel=1e-9)
    assert run.energy_residual < 1e-9


def test_joints_that_make_no_belt_are_refused():
    with pytest.raises(hd.InputError) as caught:
        hd.Scene(
            hd.Mechanism("m", (HANGS, TURNS)),
            (
                DOWN, hd.BeltOnDrum("a", "", "", DRY, *GIVEN), hd.BeltOnDrum("b", "fall", "axle", DRY, *GIVEN),
                hd.BeltOnDrum("c", "nowhere", "", DRY, *GIVEN),
                hd.BeltOnDrum("d", "axle", "", hd.laws.coulomb(p("mu", "1", MU), p("mu_2", "1", MU)), *GIVEN),
                hd.BeltOnDrum("e", "axle", "", DRY, p("mu", "1", MU), *GIVEN[1:]), hd.BallFriction("f", "axle", DRY, GIVEN[1]),
            ),
            SCALES,
        )  # fmt: skip
    assert {fault.where.split(",")[0] for fault in caught.value.faults} >= {f"effect {name}" for name in "abcdef"}


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_friction_of_a_ball_joint(coordinates):
    """A ball that spins about the vertical under a weight slows down by mu r (m g)/J: the reaction is the weight."""
    j = p("J", "kg m^2", 0.1)
    top = hd.Body("top", p("mass", "kg", M), inertia=(j, j, j), centre=(0, 0, -SIZE))
    friction = hd.BallFriction("socket", "pivot", DRY, p("radius", "m", R))
    speed = {"pivot.angular_speed_z": p("w", "rad/s", 800), "pivot.angular_speed_x": p("w_x", "rad/s", 0)}
    effects = hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Z), friction, hd.EnergyLedger()
    ball = hd.Mechanism("ball", (hd.Spherical("pivot", hd.GROUND, top),))
    model = load(hd.Scene(ball, effects, SCALES, hd.Start(speed=speed), coordinates=coordinates))
    run = simulate(model, duration=0.5, tolerance=1e-9)
    speed = "pivot.angular_speed_z" if coordinates == "tree" else "top.angular_speed_z"
    assert run[speed][-1] == pytest.approx(800 - MU * R * M * G / 0.1 * 0.5, rel=1e-9)
    assert run.energy_residual < 1e-9
    slow = {"w_x": (5, "rad/s"), "w": (3, "rad/s"), "v_s": (0.5, "m/s")}
    swings = simulate(model, duration=0.2, tolerance=1e-9, parameters=slow)
    pressed = np.sqrt(sum(swings[f"pivot.reaction_{k}"] ** 2 for k in "xyz"))
    w = np.sqrt(sum(swings[speed[:-1] + k] ** 2 for k in "xyz"))
    assert swings["socket.power"] == pytest.approx(MU * R * pressed * w * np.tanh(R * w / 0.5), rel=1e-7)
    assert swings.energy_residual < 1e-7


def test_a_belt_may_be_held_by_a_spring():
    """Its tension is any expression: of the drum's own angle, which an anchor's spring stretches."""
    held = GIVEN[0] + p("k", "N/rad", 10) * hd.coordinate_of("axle")
    belt = hd.BeltOnDrum("rope", "axle", "", DRY, held, *GIVEN[1:])
    effects = belt, hd.JointForce("drive", "axle", p("drive", "N m", 1)), hd.EnergyLedger()
    start = hd.Start(speed={"axle": p("w", "rad/s", 20)})
    run = simulate(load(hd.Scene(hd.Mechanism("band", (TURNS,)), effects, SCALES, start)), duration=0.3, tolerance=1e-9)
    assert run["rope.tension"] == pytest.approx(HOLD + 10 * run["axle.angle"], rel=1e-12)
    assert run.energy_residual < 1e-8
