"""Rolling without slip and knife edges against closed forms: wheel, ball on a turntable, disc upright, Chaplygin's sleigh."""

import numpy as np
import pytest
import sympy as sp
from scipy.special import ellipeinc, ellipk

import hertzwerk.derive as hd
from hertzwerk.derive.laws import power
from hertzwerk.runtime import equilibrium, modes, simulate, sweep
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(2)  # methods and coordinates that run the same code

BOTH = ("tree", "absolute")
EXACT = 1e-9
m, r, g = hd.Parameter("m", "kg", 2.0), hd.Parameter("r", "m", 0.3), hd.Parameter("g", "m/s^2", 9.81)
turn, still, pull = (
    hd.Parameter("turn", "rad/s", 2.0), hd.Parameter("still", "m/s", 0.0), hd.Parameter("unturned", "rad/s", 0.0),
)  # fmt: skip
slope, pace, mu = hd.Parameter("slope", "rad", 0.4), hd.Parameter("pace", "m/s", 1.0), hd.Parameter("mu", "1", 0.2)
DOWNHILL = hd.Gravity("gravity", g, direction=hd.Direction((sp.sin(slope), -sp.cos(slope), 0)))


def scene(joints, pairs, *effects, **start) -> hd.Scene:
    scales = hd.Scales(r, pace, arm=r)
    return hd.Scene(hd.Mechanism("rolling", joints, pairs), (*effects, hd.EnergyLedger()), scales, hd.Start(**start))


def run(declared: hd.Scene, coordinates: str = "tree", duration: float = 1.0, **options):
    found = simulate(
        engine_model(declared.with_coordinates(coordinates)), duration=duration, **{"tolerance": 1e-11, **options}
    )
    assert found.outcome.finished
    assert found.energy_residual < EXACT
    assert max(np.max(np.abs(found[name])) for name in found.engine.model.constraints) < EXACT
    return found


def wheel(coefficient=None, *more) -> hd.Scene:
    body = hd.Body("wheel", m, m * r**2 / 2)
    track = hd.SphereOnPlane("track", body.at(0, 0, 0), r, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    joints = (hd.Planar("ride", hd.GROUND, body, normal=hd.Z),)
    rolling = hd.RollingWithoutSlip("tyre", "track", coefficient)
    return scene(joints, (track,), DOWNHILL, rolling, *more, position={"ride.y": r})


@pytest.mark.parametrize("coordinates", BOTH)
@pytest.mark.parametrize("method", ["dop853", "esdirk"])
def test_a_wheel_rolls_downhill_at_two_thirds_of_g_sin(coordinates, method):
    actual, down = run(wheel(), coordinates, method=method), 9.81 * np.sin(0.4)
    assert actual["ride.x_speed"] == pytest.approx(2 / 3 * down * actual.t, abs=EXACT)
    assert actual["ride.angle_speed"] == pytest.approx(-2 / 3 * down * actual.t / 0.3, abs=EXACT)
    assert actual["tyre.normal_force"] == pytest.approx(2 * 9.81 * np.cos(0.4), rel=EXACT)
    assert actual["tyre.friction_force"] == pytest.approx(2 * down / 3, rel=EXACT)  # along z x normal: uphill
    assert not actual.warnings


def test_a_run_warns_where_friction_could_not_hold_it():
    """The wheel needs tan(slope)/3 = 0.141."""
    assert not run(wheel(0.15)).warnings
    model = engine_model(wheel(mu))
    for slope in (0.4, -0.4):
        found = simulate(model, duration=1.0, parameters={"mu": 0.13, "slope": f"{slope} rad"}, tolerance=1e-9)
        (warning,) = found.warnings
        assert warning.startswith("tyre needs a coefficient of friction of 0.141 at ")
        assert warning.endswith("more than 0.13: it would slip")
    assert (
        sweep(model, {"mu": [0.13, 0.2]}, outputs=["final.ride.x"], duration=0.1)["outcome"].tolist()
        == ["finished"] * 2
    )


def test_a_run_warns_where_the_surfaces_would_part():
    """A ball on another leaves it at cos = 10/17 of the way, where its normal force vanishes."""
    big, ball = hd.Parameter("big", "m", 1.0), hd.Body("ball", m, 2 * m * r**2 / 5)
    pair = hd.SphereOnSphere("hill", ball.at(0, 0, 0), hd.GROUND.at(0, 0, 0), r, big)
    start = {
        "position": {"ride.x": (big + r) * sp.sin(sp.Rational(1, 10)), "ride.y": (big + r) * sp.cos(sp.Rational(1, 10))}
    }
    declared = scene(
        (hd.Planar("ride", hd.GROUND, ball, normal=hd.Z),), (pair,), hd.Gravity("gravity", g, direction=-hd.Y),
        hd.RollingWithoutSlip("rolls", "hill"), **start
    )  # fmt: skip
    actual = run(declared, duration=2.0)
    cosine = actual["ride.y"] / 1.3
    leaves = np.interp(0, -actual["rolls.normal_force"], cosine)
    assert leaves == pytest.approx(10 / 17 * np.cos(0.1), rel=1e-2)  # between two steps
    force = 2 * 9.81 * (17 * cosine - 10 * np.cos(0.1)) / 7
    assert actual["rolls.normal_force"] == pytest.approx(force, abs=1e-7)
    (warning,) = actual.warnings
    assert warning.startswith("rolls holds its surfaces together with ")


WIDE, LIFT = hd.Parameter("wide", "m", 1.0), hd.Parameter("lift", "rad", 1.2)
TROUGHS = {
    "curve": hd.Curve("trough", WIDE * sp.cos(hd.S), WIDE * sp.sin(hd.S), hole=True),
    "outline": hd.Outline("trough", (WIDE, 0), [hd.Arc((-WIDE, 0), (0, 0), clockwise=True)], closed=False),
}


@pytest.mark.parametrize("trough", TROUGHS.values(), ids=TROUGHS)
def test_a_cylinder_rolls_in_a_trough_as_a_pendulum(trough):
    """Of length 3 (R - r)/2: its period by an elliptic integral and, of small vibrations, 2 pi sqrt(3 (R - r)/(2 g)); its forces."""
    body = hd.Body("cylinder", m, m * r**2 / 2)
    pair = hd.CircleOnCurve("bed", body.at(0, 0, 0), r, trough, hd.GROUND.at(0, 0, 0))
    joints, effects = (
        (hd.Planar("ride", hd.GROUND, body, normal=hd.Z),),
        (hd.Gravity("gravity", g, direction=-hd.Y), hd.RollingWithoutSlip("rolls", "bed")),
    )
    start = {"ride.x": (WIDE - r) * sp.sin(LIFT), "ride.y": (r - WIDE) * sp.cos(LIFT)}  # fmt: skip
    declared = scene(joints, (pair,), *effects, position=start)
    slow = np.sqrt(3 * 0.7 / (2 * 9.81))
    actual = run(declared, duration=4 * slow * ellipk(np.sin(0.6) ** 2))
    assert actual["ride.x"][-1] == pytest.approx(0.7 * np.sin(1.2), abs=EXACT)
    cosine, sine = -actual["ride.y"] / 0.7, actual["ride.x"] / 0.7
    assert actual["rolls.normal_force"] == pytest.approx(2 * 9.81 * (7 * cosine - 4 * np.cos(1.2)) / 3, abs=1e-7)
    assert np.abs(actual["rolls.friction_force"]) == pytest.approx(np.abs(2 * 9.81 * sine / 3), abs=1e-7)
    assert modes(engine_model(declared), parameters={"lift": "0 rad"}).frequencies[0] == pytest.approx(
        1 / (2 * np.pi * slow)
    )


@pytest.mark.parametrize("coordinates", BOTH)
def test_an_ellipse_rolls_on_a_line_by_its_length(coordinates):
    """Its middle is sqrt(a^2 sin^2 + b^2 cos^2) high, and gets as far as the arc that it has unrolled and its foot's lead."""
    (a, b), egg = (0.4, 0.25), hd.Body("egg", m, m * r**2 / 2)
    floor = hd.Curve("floor", -4 * r * hd.S, 0 * r, -1, 1, closed=False)
    oval = hd.Curve("oval", hd.Parameter("a", "m", a) * sp.cos(hd.S), hd.Parameter("b", "m", b) * sp.sin(hd.S))
    pair = hd.CurveOnCurve("bed", oval, egg.at(0, 0, 0), floor, hd.GROUND.at(0, 0, 0))
    joints, effects = (
        (hd.Planar("ride", hd.GROUND, egg, normal=hd.Z),),
        (hd.Gravity("gravity", g, direction=-hd.Y), hd.RollingWithoutSlip("rolls", "bed")),
    )
    start = {"position": {"ride.x": 0 * r, "ride.y": hd.Parameter("low", "m", b)}, "speed": {"ride.x": -pace}}  # fmt: skip
    actual = run(scene(joints, (pair,), *effects, **start), coordinates, duration=0.35)
    angle = actual["ride.angle"]
    high = np.hypot(a * np.sin(angle), b * np.cos(angle))
    assert actual["ride.y"] == pytest.approx(high, abs=EXACT)
    lead = (a**2 - b**2) * np.sin(angle) * np.cos(angle) / high
    unrolled = a * ellipeinc(np.arctan2(a * np.sin(angle), b * np.cos(angle)), 1 - (b / a) ** 2)
    assert angle[-1] > 0.7
    assert actual["ride.x"] == pytest.approx(lead - unrolled, abs=EXACT)


def turntable(**start) -> hd.Scene:
    table, ball = hd.Body("table", m, m * r**2), hd.Body("ball", m, 2 * m * r**2 / 5)
    joints = (hd.Revolute("table", hd.GROUND, table, axis=hd.Z), hd.Free("ball", hd.GROUND, ball))
    pair = hd.SphereOnPlane("deck", ball.at(0, 0, 0), r, table.at(0, 0, 0), normal=hd.Z)
    drive = hd.ConstantSpeed("motor", "table", hd.Parameter("turning", "rad/s", 3.0))
    rolling, weight = hd.RollingWithoutSlip("rolls", "deck"), hd.Gravity("gravity", g, direction=-hd.Z)
    return scene(joints, (pair,), drive, weight, rolling, **start)


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_ball_on_a_turntable_circles_at_two_sevenths_of_its_speed(coordinates):
    """Routh, Advanced Rigid Dynamics (1884): p'' = 2/7 W x p', wherever the axis is."""
    away, vx, vy = hd.Parameter("away", "m", 0.7), hd.Parameter("vx", "m/s", 0.2), hd.Parameter("vy", "m/s", 0.5)
    position = {"ball.x": away, "ball.z": r}
    declared = turntable(position=position, speed={"ball.x": vx, "ball.y": vy, "ball.angular_speed_z": pull})
    actual = run(declared, coordinates, duration=4.0)
    rate = 2 / 7 * 3.0
    path = actual["ball.x"] + 1j * actual["ball.y"]
    speed = 0.2 + 0.5j
    assert path == pytest.approx(0.7 + speed * (np.exp(1j * rate * actual.t) - 1) / (1j * rate), abs=1e-8)


def sleigh() -> hd.Scene:
    a, inertia = hd.Parameter("a", "m", 0.25), hd.Parameter("J", "kg m^2", 0.1)
    body = hd.Body("sleigh", m, inertia, centre=(a, 0, 0))
    edge = hd.KnifeEdge("skate", body.at(0, 0, 0), hd.Y)
    return scene(
        (hd.Planar("ride", hd.GROUND, body, normal=hd.Z),), (), edge, speed={"ride.angle": turn, "ride.x": still}
    )


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_sleigh_with_a_knife_edge_runs_straight_in_the_end(coordinates):
    """Chaplygin's sleigh: v = k w0 tanh(a w0 t/k) and w = w0 sech(a w0 t/k), k^2 = (J + m a^2)/m."""
    actual, k = run(sleigh(), coordinates, duration=3.0), np.sqrt(0.1 / 2 + 0.25**2)
    grown = 0.25 * 2 * actual.t / k
    assert actual["sleigh.angle_speed"] == pytest.approx(2 / np.cosh(grown), abs=1e-8)
    assert actual["sleigh.angle"] == pytest.approx(4 * k / 0.5 * np.arctan(np.tanh(grown / 2)), abs=1e-8)
    assert actual["skate.side_force"] == pytest.approx(side_force(actual.t, k), abs=1e-6)


def side_force(t, k):
    """m (v w + a w'), the acceleration of the mass centre across."""
    s = 0.25 * 2 * t / k
    v, w, dw = 2 * k * np.tanh(s), 2 / np.cosh(s), -2 * 0.25 * 2 / k * np.tanh(s) / np.cosh(s)
    return 2 * (v * w + 0.25 * dw)


@pytest.mark.parametrize("coordinates", BOTH)
def test_an_upright_disc_sways_as_fast_as_published(coordinates):
    """A thin rolling disc: sway^2 = 4/5 (3 w^2 - g/r), Neimark, Fufaev (1972), III.2; below 3 w^2 = g/r it falls."""
    tilt, spin = hd.Parameter("tilt", "rad", 1e-4), hd.Parameter("spin", "rad/s", 12.0)
    disc = hd.Body("disc", m, (m * r**2 / 4, m * r**2 / 2, m * r**2 / 4))
    pair = hd.RimOnPlane("ground", disc.at(0, 0, 0), hd.Y, r, hd.GROUND.at(0, 0, 0), normal=hd.Z)
    position = {"disc.q0": sp.cos(tilt / 2), "disc.q1": sp.sin(tilt / 2), "disc.z": r * sp.cos(tilt)}
    speed = {"disc.angular_speed_x": pull, "disc.angular_speed_y": spin, "disc.angular_speed_z": pull}
    joints, rolling = (hd.Free("disc", hd.GROUND, disc),), hd.RollingWithoutSlip("rolls", "ground")
    declared = scene(
        joints, (pair,), hd.Gravity("gravity", g, direction=-hd.Z), rolling, position=position, speed=speed
    )
    for rate in (12.0, 2.0):
        actual = run(declared, coordinates, duration=0.5, parameters={"spin": f"{rate} rad/s"})
        q = [actual[f"disc.q{k}"] for k in range(4)]
        sway = np.emath.sqrt(0.8 * (3 * rate**2 - 9.81 / 0.3))
        middle = 1e-4 * 0.8 * 3 * rate**2 / sway**2  # its path bends with the lean
        lean = middle + (1e-4 - middle) * np.cos(sway * actual.t)
        assert 2 * (q[2] * q[3] + q[0] * q[1]) == pytest.approx(lean.real, rel=1e-5)
        assert actual["rolls.normal_force"] == pytest.approx(2 * 9.81, rel=1e-5)


def test_a_rolling_wheel_on_a_spring_vibrates_and_has_derivatives_in_closed_form():
    rest = equilibrium(engine_model(wheel(None, hd.JointSpring("tie", "ride.x", hd.Parameter("k", "N/m", 300)))))
    assert rest.q[0] == pytest.approx(2 * 9.81 * np.sin(0.4) / 300, rel=1e-9)
    assert modes(rest).frequencies == pytest.approx([np.sqrt(300 / 3) / (2 * np.pi)], rel=1e-9)
    # x = g sin(slope) t^2/3, whatever its mass and radius.
    actual = run(wheel(mu))
    by = actual.sensitivities("slope", "r", "m")
    assert by["ride.x", "slope"] == pytest.approx(9.81 * np.cos(0.4) * actual.t**2 / 3, abs=EXACT)
    assert by["ride.x", "r"] == pytest.approx(0 * actual.t, abs=EXACT)
    assert by["tyre.normal_force", "m"] == pytest.approx(9.81 * np.cos(0.4), rel=EXACT)
    assert by["tyre.sliding_velocity", "slope"] == pytest.approx(0 * actual.t, abs=EXACT)


def test_every_fault_of_rolling_and_edges_is_reported_at_once():
    body = hd.Body("wheel", m, m * r**2)
    track = hd.SphereOnPlane("track", body.at(0, 0, 0), r, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    contact = hd.Contact("track", power(hd.Parameter("K", "N/m^1.5", 1e8), 1.5))
    with pytest.raises(hd.InputError) as error:
        scene(
            (hd.Planar("ride", hd.GROUND, body, normal=hd.Z),), (track,), contact, hd.RollingWithoutSlip("tyre", "track", -1),
            hd.RollingWithoutSlip("other", "nothing"), hd.KnifeEdge("skate", body.at(0, 0, 0), hd.X, on=body),
        )  # fmt: skip
    assert [(fault.where, fault.found) for fault in error.value.faults] == [
        ("effect tyre", "track at the same pair"), ("effect other", "pair 'nothing'"), ("effect skate", "an edge of wheel on wheel"),
        ("effect tyre, coefficient", "-1"),
    ]  # fmt: skip
    body = hd.Body("sleigh", m, m * r**2)
    edge = hd.KnifeEdge("skate", body.at(0, 0, 0), hd.X, on="ice")
    with pytest.raises(hd.InputError, match="effect skate, on: found 'ice'; expected a Body or GROUND"):
        scene((hd.Planar("ride", hd.GROUND, body, normal=hd.Z),), (), edge)
