"""The ideal mechanism, against the closed form of the slider-crank, which knows nothing of eccentricities."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import power
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.start.ideal_mechanism import ideal_motion, unknown_because
from hertzwerk.runtime.loading import engine_model
from reference import ideal_slider_crank as closed_form

R, L, W = 0.05, 0.12, 5000 * np.pi / 30


def followed(times, parameters=None, scene="slider_crank"):
    model = engine_model(scene) if isinstance(scene, str) else scene
    bound = model.bind(parameters or {})
    q, _ = model.function("start")(bound.p)
    return ideal_motion(model, times, np.array(q).ravel(), bound.c)


@pytest.mark.parametrize("count", [4, 40, 400])
def test_slider_crank_is_the_closed_form_however_coarse_the_times(count):
    t = np.linspace(0, 0.024, count)
    ideal = followed(t)
    assert ideal["guide.travel"] == pytest.approx(closed_form.position(W * t, R, L), rel=1e-14)
    assert np.max(np.abs(ideal["guide.speed"] - closed_form.velocity(W * t, W, R, L))) < 1e-12 * R * W
    assert (
        np.max(np.abs(ideal.acceleration_of("guide.speed") - closed_form.acceleration(W * t, W, R, L)))
        < 1e-12 * R * W**2
    )


def test_dead_centres_and_a_tabulated_crank():
    ideal = followed([0.0, 0.006])
    assert ideal.acceleration_of("guide.speed") == pytest.approx([-19419.3605, 7996.2073], rel=1e-8)
    model = engine_model(slider_crank.replace(crank_drive=hd.Drive("crank_drive", "main_bearing", position=WAVE(hd.T))))
    t = np.linspace(0, 0.03, 31)
    ideal = followed(t, scene=model)
    assert ideal["guide.travel"] == pytest.approx(closed_form.position(0.5 * np.sin(300 * t), R, L), abs=1e-9)


# -- cranks that are accelerated ---------------------------------------------------------------------------------------

SPEED, RISE = hd.Parameter("crank_speed", "rpm", 5000, "constant speed of the crank"), hd.Parameter("rise", "ms", 10)
SHARE, RATE = hd.Parameter("share", "1", 0.2), hd.Parameter("rate", "rad/s", 300)
TIMES = np.linspace(0, 0.03, 61)
WAVE = hd.Table("wave", TIMES.tolist(), (0.5 * np.sin(300 * TIMES)).tolist(), ("s", "rad"))


def ramp(t):
    """Crank angle, speed and acceleration of the quintic rise, by hand."""
    s = np.minimum(t / 0.01, 1)
    way = 0.01 * (2.5 * s**4 - 3 * s**5 + s**6) + np.maximum(t - 0.01, 0)
    return W * way, W * s**3 * (10 - 15 * s + 6 * s**2), W / 0.01 * 30 * s**2 * (1 - s) ** 2


def swaying(t):
    """Of the speed w (1 + e sin(r t))."""
    r = 300
    return W * (t + 0.2 / r * (1 - np.cos(r * t))), W * (1 + 0.2 * np.sin(r * t)), W * 0.2 * r * np.cos(r * t)


CRANKS = {
    "harmonic": (
        hd.Harmonic("crank_drive", "main_bearing", SHARE, RATE),
        lambda t: (0.2 * np.sin(300 * t), 60 * np.cos(300 * t), -18000 * np.sin(300 * t)),
    ),
    "ramp": (hd.Ramp("crank_drive", "main_bearing", SPEED, RISE), ramp),
    "position": (
        hd.Drive("crank_drive", "main_bearing", position=SPEED * (hd.T + SHARE / RATE * (1 - sp.cos(RATE * hd.T)))), swaying,
    ),
    "speed": (hd.Drive("crank_drive", "main_bearing", speed=SPEED * (1 + SHARE * sp.sin(RATE * hd.T))), swaying),
    "acceleration": (
        hd.Drive("crank_drive", "main_bearing", acceleration=SPEED * SHARE * RATE * sp.cos(RATE * hd.T), start_speed=SPEED), swaying,
    ),
}  # fmt: skip


@cache
def cranked(label):
    return engine_model(slider_crank.replace(crank_drive=CRANKS[label][0]))


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("count", [4, 60])
@pytest.mark.parametrize("label", CRANKS)
def test_an_accelerated_crank_is_the_closed_form(label, count):
    """x' = x_phi phi', x'' = x_phiphi phi'^2 + x_phi phi''; also where the crank's angle is integrated from its speed or acceleration."""
    t = np.linspace(0, 0.024, count)
    ideal = followed(t, scene=cranked(label))
    phi, w, alpha = CRANKS[label][1](t)
    assert np.max(np.abs(ideal["guide.travel"] - closed_form.position(phi, R, L))) < 1e-12 * L
    assert np.max(np.abs(ideal["guide.speed"] - closed_form.velocity(phi, w, R, L))) < 1e-11 * R * W
    expected = closed_form.acceleration(phi, w, R, L) + closed_form.velocity(phi, alpha, R, L)
    assert np.max(np.abs(ideal.acceleration_of("guide.speed") - expected)) < 1e-11 * R * W**2
    without = closed_form.acceleration(phi, w, R, L)
    assert np.max(np.abs(expected - without)) > 1e-3 * R * W**2  # the term under test is there


def test_a_clearance_run_with_an_accelerated_crank_stays_near_the_ideal_one():
    """What the slider may deviate by is the gain of the linkage times the reach of the pin in its bush."""
    run = simulate(cranked("speed"), duration="24 ms", tolerance=1e-7)
    assert run.outcome.finished
    assert run.energy_residual < 1e-6
    ideal = followed(run.t, scene=cranked("speed"))
    reach = 0.5e-3 + np.max(run["slider_pin.penetration"])
    assert np.max(np.abs(run["guide.travel"] - ideal["guide.travel"])) < closed_form.gain(R, L, reach) * reach
    assert run["main_bearing.angle"] == pytest.approx(swaying(run.t)[0], rel=1e-7)


def held_body(speed):
    """A free body whose three pins sit in bushes of a driven wheel: their axes X, Y, Z leave it no freedom, so it turns with the wheel."""
    p = hd.Parameter
    mass, clearance, radius = p("mass", "kg", 1.0), p("clearance", "mm", 1.0), p("radius", "mm", 10.0)
    inertia = tuple(hd.Parameter(f"J_{k}", "kg m^2", 0.01) for k in "xyz")
    wheel, body = hd.Body("wheel", mass, inertia), hd.Body("body", mass, inertia)
    places = {"first": ((0, 1, 0), hd.X), "second": ((0, 0, 1), hd.Y), "third": ((1, 0, 0), hd.Z)}
    off = hd.Parameter("off", "m", 0.3)
    pairs = tuple(
        hd.PinInBush(name, body.at(*(k * off for k in at)), wheel.at(*(k * off for k in at)), axis, radius, clearance)
        for name, (at, axis) in places.items()
    )
    contacts = tuple(hd.Contact(name, power(hd.Parameter("stiffness", "N/m^1.5", 1e8), 1.5)) for name in places)
    drive = hd.ConstantSpeed("drive", "axle", hd.Parameter("wheel_speed", "rad/s", speed))
    joints = (hd.Revolute("axle", hd.GROUND, wheel, hd.Z), hd.Free("float", hd.GROUND, body))
    scales = hd.Scales(length=clearance, speed=hd.Parameter("pace", "m/s", 1.0), arm=off)
    return engine_model(hd.Scene(hd.Mechanism("held", joints, pairs), (drive, *contacts), scales))


def test_a_free_body_is_assembled_and_followed_on_its_quaternion():
    """Six eccentricities, six speeds, seven coordinates."""
    model, speed = held_body(2.0), 2.0
    t = np.linspace(0, 3, 13)
    near = np.array([0.01, -0.02, 0.01, 0.99, 0.05, -0.03, 0.08])
    near[3:] /= np.linalg.norm(near[3:])
    ideal = ideal_motion(model, t, near, model.bind().c)
    zero = np.zeros_like(t)
    expected = np.column_stack([zero, zero, zero, np.cos(speed * t / 2), zero, zero, np.sin(speed * t / 2)])
    assert np.max(np.abs(ideal.q - expected)) < 1e-13
    assert np.max(np.abs(ideal.u - [0, 0, 0, 0, 0, speed])) < 1e-12
    assert np.max(np.abs(ideal.acceleration)) < 1e-11


def test_a_closed_loop_counts_beside_the_clearances():
    """A second crank, hung to the first by a coupler as long as the base: it turns along, and the slider does what it did."""
    base, mass = hd.Parameter("base", "m", 0.2), hd.Parameter("second_mass", "kg", 0.1)
    inertia = hd.Parameter("second_inertia", "kg m^2", 1e-4)
    second, coupler = hd.Body("second", mass, inertia), hd.Body("coupler", mass, inertia, (base / 2, 0, 0))
    crank, radius = slider_crank.mechanism.joints[1].parent.body, slider_crank.mechanism.joints[1].parent.position[0]
    joints = (
        *slider_crank.mechanism.joints, hd.Revolute("second_bearing", hd.GROUND.at(base, 0, 0), second, hd.Z),
        hd.Revolute("near", crank.at(radius, 0, 0), coupler, hd.Z), hd.Revolute("far", second.at(radius, 0, 0), coupler.at(base, 0, 0), hd.Z),
    )  # fmt: skip
    model = engine_model(replace(slider_crank, mechanism=replace(slider_crank.mechanism, joints=joints)))
    assert (model.nu, model.nl) == (4, 2)
    t = np.linspace(0, 0.009, 13)  # on both sides of the change points, where crank and base are in one line
    t = t[np.abs(np.sin(W * t)) > 0.1]
    q = np.array(model.function("start")(model.bind().p)[0]).ravel()
    q[[model.coordinates.index("second_bearing.angle"), model.coordinates.index("near.angle")]] = W * t[0], -W * t[0]
    ideal = ideal_motion(model, t[t < 0.006], q, model.bind().c)
    wanted = t[t < 0.006]
    assert ideal["guide.travel"] == pytest.approx(closed_form.position(W * wanted, R, L), rel=1e-13)
    assert ideal["second_bearing.angle"] == pytest.approx(W * wanted, rel=1e-12)
    assert ideal["near.speed"] == pytest.approx(np.full_like(wanted, -W), rel=1e-11)


def test_a_model_without_ideal_mechanism_says_why():
    """A slider in its guide is four corners on two faces; a ball in a socket by itself keeps all its turns."""
    assert "3 equations for 6 degrees of freedom" in unknown_because(engine_model("ball_in_socket"))
    assert "no joint with clearance" in unknown_because(engine_model("soft_ball"))
    assert "front_upper guide with a clearance" in unknown_because(engine_model("translational_clearance"))
    assert unknown_because(engine_model("spatial_slider_crank")) == ""
    assert followed([0.0, 0.1], scene="soft_ball") is None
    # A crank longer than the rod: at 90 degrees the rod does not reach the guide.
    t = np.linspace(0, 0.006, 7)
    assert followed(t, {"crank_radius": "0.13 m"}) is None
