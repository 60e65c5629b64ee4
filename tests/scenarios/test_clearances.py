"""Built-in scenes of the other pairs against closed forms and independent integrations of equations derived another way."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import power, smooth_coulomb
from hertzwerk.runtime import load, simulate

TIGHT = {"rtol": 1e-13, "atol": 1e-15, "method": "DOP853"}


def lagrange(kinetic, potential, coordinates):
    """Accelerations as a function of (q, u) by Lagrange's equations."""
    speeds = [sp.Symbol(f"{q}_rate") for q in coordinates]
    t_of_u = kinetic(coordinates, speeds)
    momenta = [sp.diff(t_of_u, u) for u in speeds]
    mass = sp.Matrix(momenta).jacobian(speeds)
    rest = [
        sp.diff(t_of_u - potential(coordinates), q) - sum(sp.diff(p, k) * u for k, u in zip(coordinates, speeds, strict=True))
        for q, p in zip(coordinates, momenta, strict=True)
    ]  # fmt: skip
    numbers = sp.lambdify([coordinates, speeds], (mass, sp.Matrix(rest)))

    def rates(_, y):
        n = len(coordinates)
        m, f = numbers(y[:n], y[n:])
        return np.concatenate([y[n:], np.linalg.solve(np.array(m, float), np.array(f, float).ravel())])

    return rates


def event(function):
    function.terminal = True
    return function


# -- a ball in a socket ------------------------------------------------------------------------------------------------

M, G, C, K = 0.5, 9.81, 5e-3, 1e7
REST = (M * G / K) ** (2 / 3)


def test_a_ball_swings_in_its_socket_as_an_elastic_pendulum():
    """In polar coordinates about the socket's centre: the length is the clearance plus the penetration."""

    def rates(_, y):
        length, angle, length_rate, angle_rate = y
        push = K * (length - C) ** 1.5
        return [
            length_rate, angle_rate, length * angle_rate**2 + G * np.cos(angle) - push / M,
            -(2 * length_rate * angle_rate + G * np.sin(angle)) / length,
        ]  # fmt: skip

    run = simulate(load("ball_in_socket"), duration=0.5, tolerance=1e-10)
    length, angle, _, _ = solve_ivp(rates, (0, 0.5), [C + REST, 0.05, 0, 0], **TIGHT).y[:, -1]
    assert run.outcome.finished
    assert run["float.x"][-1] == pytest.approx(length * np.sin(angle), abs=1e-9 * C)
    assert run["float.z"][-1] == pytest.approx(-length * np.cos(angle), rel=1e-9)
    assert run["ball_joint.eccentricity_x"][-1] == run["float.x"][-1]
    assert run.energy_residual < 1e-9


# -- the slider in its guide -------------------------------------------------------------------------------------------


def textbook(_, y):
    """A double pendulum of rods with a point mass at its end, which is the slider while it does not turn: angles against X."""
    r, l, m1, m2, m3, J1, J2 = 0.153, 0.306, 0.038, 0.038, 0.076, 7.4e-5, 5.9e-4
    a, b, da, db = y
    cross = r * l * (m2 / 2 + m3)
    mass = np.array([
        [J1 + m1 * r**2 / 4 + (m2 + m3) * r**2, cross * np.cos(a - b)],
        [cross * np.cos(a - b), J2 + m2 * l**2 / 4 + m3 * l**2],
    ])  # fmt: skip
    force = [
        -cross * np.sin(a - b) * db**2 - 9.81 * r * np.cos(a) * (m1 / 2 + m2 + m3),
        cross * np.sin(a - b) * da**2 - 9.81 * l * np.cos(b) * (m2 / 2 + m3),
    ]
    return [da, db, *np.linalg.solve(mass, force)]


def height(y):
    return 0.153 * np.sin(y[0]) + 0.306 * np.sin(y[1])


def test_the_first_contact_of_the_slider_is_where_an_independent_integration_finds_it():
    """The slider starts parallel and keeps so until a corner touches: both corners of one side do at once."""
    run = simulate(load("translational_clearance"), duration="10 ms", tolerance=1e-12)
    hit = solve_ivp(textbook, (0, 0.01), [0, 0, 150, -75], events=event(lambda _, y: abs(height(y)) - 1e-3), **TIGHT)
    (time,), (state,) = hit.t_events[0], hit.y_events[0]
    speed = 0.153 * np.cos(state[0]) * state[2] + 0.306 * np.cos(state[1]) * state[3]
    side = "upper" if height(state) > 0 else "lower"
    first, second = run.impacts[:2]
    assert {first.contact, second.contact} == {f"front_{side}", f"rear_{side}"}
    assert first.t == pytest.approx(time, rel=1e-10)
    assert second.t == pytest.approx(time, rel=1e-10)
    assert first.speed == pytest.approx(abs(speed), rel=1e-9)


# -- the spatial slider-crank ------------------------------------------------------------------------------------------


def test_the_first_contact_of_the_ball_is_where_an_independent_integration_finds_it():
    """Slider and rod fly freely until the ball has left the centre of the driven socket by the clearance."""
    r, l, w, beside, above = 0.08, 0.3, 60.0, 0.1, 0.12

    def kinetic(q, u):
        (_, yaw, pitch), (dx, dyaw, dpitch) = q, u
        half = [-l / 2 * sp.cos(pitch) * sp.cos(yaw), -l / 2 * sp.cos(pitch) * sp.sin(yaw), l / 2 * sp.sin(pitch)]
        v = [sum(sp.diff(k, a) * da for a, da in ((yaw, dyaw), (pitch, dpitch))) for k in half]
        v[0] += dx
        spin = 4e-4 * (dyaw * sp.sin(pitch)) ** 2 + 4e-3 * (dpitch**2 + (dyaw * sp.cos(pitch)) ** 2)
        return sp.Rational(1, 2) * (2.0 * dx**2 + 0.5 * sum(k**2 for k in v) + spin)

    rates = lagrange(kinetic, lambda q: 0.5 * 9.81 * l / 2 * sp.sin(q[2]), list(sp.symbols("x yaw pitch")))

    def apart(t, y):
        x, yaw, pitch = y[:3]
        ball = np.array([x - l * np.cos(pitch) * np.cos(yaw), -l * np.cos(pitch) * np.sin(yaw), l * np.sin(pitch)])
        return ball - [0, beside - r * np.sin(w * t), above + r * np.cos(w * t)]

    way = np.sqrt(l**2 - beside**2 - (above + r) ** 2)
    start = [way, -np.arctan(beside / way), np.arcsin((above + r) / l), beside * r * w / way, r * w / way, 0.0]
    assert np.linalg.norm(apart(0, start)) < 1e-15
    hit = solve_ivp(rates, (0, 0.01), start, events=event(lambda t, y: np.linalg.norm(apart(t, y)) - 2e-4), **TIGHT)
    ((time,),) = hit.t_events
    run = simulate(load("spatial_slider_crank"), duration="105 ms", tolerance=1e-11)
    assert run.impacts[0].t == pytest.approx(time, rel=1e-9)
    assert run.outcome.finished
    assert run.energy_residual < 1e-9
    assert len(run.impacts) > 10


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
        pair, FALL, hd.Contact("touch", STIFF), rub, joint=hd.Planar("float", hd.GROUND, roller), y=0.1 - REST, x_speed=1.5,
    )(0.6)  # fmt: skip
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
            hd.Mechanism("lying", (hd.Free("float", hd.GROUND, roller),), rims), (FALL, *contacts, hd.EnergyLedger()), scales,
        )
    )  # fmt: skip
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
