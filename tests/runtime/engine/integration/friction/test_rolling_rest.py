"""Set-valued resistance to rolling and drilling: balls and wheels that come to rest, and stay, against closed forms."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import sympy as sp
from balls import GRAVITY, MASS, RADIUS, ball, brake, dry

import hertzwerk.derive as hd
from hertzwerk.derive.laws import smooth_coulomb
from hertzwerk.runtime import equilibrium, simulate
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(7)  # methods that run the same code

REFERENCES = tuple(pytest.param(name, marks=pytest.mark.exhaustive) for name in ("cvodes", "idas"))
OWN = ("dop853", "dopri5", "rodas", "esdirk", "auto")
METHODS = (*OWN, *REFERENCES)
ARM, PATCH, MU = 3e-4, 1e-4, 0.2  # m, m, 1
DRILL = 3 * math.pi / 16 * MU * PATCH  # m, of Hertz's pressure
SLOWS = ARM * GRAVITY / (1.4 * RADIUS)  # m/s^2, of a ball that rolls
SPIN_SLOWS = DRILL * GRAVITY / (0.4 * RADIUS**2)  # rad/s^2


def rolling():
    return hd.RollingResistance("rolling", "floor", hd.Parameter("arm", "m", ARM))


def drilling():
    return hd.DrillingResistance(
        "drilling", "floor", 3 * sp.pi / 16 * hd.Parameter("mu_k", "1", MU) * hd.Parameter("patch", "m", PATCH)
    )


def scene(*more, law=None, **coordinates):
    found = ball(law or dry(MU), **coordinates)
    return replace(found, effects=(*found.effects, rolling(), drilling(), *more))


@cache
def model(coordinates="tree"):
    return engine_model(scene(coordinates=coordinates))


@cache
def pushed():
    """The ball under a torque about the normal that grows with time."""
    body = ball(dry(MU)).mechanism.joints[0].child.body
    return engine_model(scene(hd.BodyTorque("twist", body, (0, hd.Parameter("rise", "N m/s", 1e-5) * hd.T, 0))))


def shot(speed, heading, spin):
    """A ball that rolls, and spins about the normal."""
    x, z = speed * math.cos(heading), speed * math.sin(heading)
    start = {"v_x": x, "v_z": z, "w_z": -x / RADIUS, "w_x": z / RADIUS, "w_y": spin}
    return {name: (value, "m/s" if name[0] == "v" else "rad/s") for name, value in start.items()}


def rests(run, mode):
    """First row from which a mode is rest, and stays so."""
    moves = np.flatnonzero(run[mode] != 0)
    return 0 if not len(moves) else moves[-1] + 1


# ---- rest ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize(
    "method", [*OWN, *(pytest.param(name, marks=pytest.mark.exhaustive) for name in ("cvodes", "idas"))]
)
def test_a_ball_rolls_and_spins_to_rest_and_stays(method, coordinates):
    """It slows by c g/(r (1 + 2/5)), its spin by c' N/I, each as if there were no other; then it does not even creep."""
    speed, heading, spin = 0.2, math.radians(30), 0.5
    run = simulate(
        model(coordinates), duration="3.2 s", method=method, tolerance=1e-8, parameters=shot(speed, heading, spin)
    )
    assert run.t[rests(run, "rolling.turning")] == pytest.approx(speed / SLOWS, rel=1e-8)
    assert run.t[rests(run, "drilling.turning")] == pytest.approx(spin / SPIN_SLOWS, rel=1e-7)
    way = speed**2 / (2 * SLOWS) * np.array([math.cos(heading), math.sin(heading)])
    assert [run.engine.final["flight.x"], run.engine.final["flight.z"]] == pytest.approx(way, rel=1e-8)
    left = [
        run.engine.final[f"flight.{name}speed{axis}"]
        for name, axis in (("x_", ""), ("z_", ""), *(("angular_", f"_{i}") for i in "xyz"))
    ]
    assert np.max(np.abs(left)) < 1e-14
    assert run["rolling.moment"][1] == pytest.approx(-ARM * MASS * GRAVITY, rel=1e-6)
    assert abs(run["rolling.moment"][-1]) < 1e-12
    assert run.engine.final["rolling.dissipated"] == pytest.approx(0.7 * MASS * speed**2, rel=1e-7)
    assert run.engine.final["drilling.dissipated"] == pytest.approx(0.2 * MASS * (RADIUS * spin) ** 2, rel=1e-7)
    assert run.energy_residual < 1e-8


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("share", [1 - 1e-3, 1 + 1e-3])
def test_the_angle_of_repose(method, share):
    """tan(slope) = c/r: below it stays, held by 1 - 1e-3 of the limit; above it rolls off with g (sin - c/r cos)/(1 + 2/5)."""
    slope = math.atan(share * ARM / RADIUS)
    run = simulate(model(), duration="1 s", method=method, tolerance=1e-8, parameters={"slope": slope})
    rate = GRAVITY * (math.sin(slope) - ARM / RADIUS * math.cos(slope)) / 1.4
    if share < 1:
        assert np.all(run["rolling.turning"] == 0)
        assert abs(run.engine.final["flight.x"]) < 1e-15
        assert -run["rolling.moment"][-1] == pytest.approx(MASS * GRAVITY * RADIUS * math.sin(slope), rel=1e-6)
    else:
        assert np.all(run["rolling.turning"][1:] == 1)
        assert run.engine.final["flight.x_speed"] == pytest.approx(rate, rel=1e-6)
    assert np.all(run["floor.slip"] == 0)


@pytest.mark.parametrize("method", METHODS)
def test_a_ball_thrown_without_spin_slides_rolls_and_rests(method):
    """Three phases in closed form: friction turns it against the resistance, (mu r - c) N, until it rolls."""
    speed = 0.5
    slides = speed / (MU * GRAVITY * (1 + 2.5 * (1 - ARM / (MU * RADIUS))))
    rolls = speed - MU * GRAVITY * slides
    run = simulate(model(), duration="5.3 s", method=method, tolerance=1e-8, parameters={"v_x": (speed, "m/s")})
    assert run.t[rests(run, "floor.slip")] == pytest.approx(slides, rel=1e-7)
    assert run.t[rests(run, "rolling.turning")] == pytest.approx(slides + rolls / SLOWS, rel=1e-8)
    way = (speed + rolls) / 2 * slides + rolls**2 / (2 * SLOWS)
    assert run.engine.final["flight.x"] == pytest.approx(way, rel=1e-8)
    assert run.engine.final["flight.x_speed"] == pytest.approx(0, abs=1e-14)


def test_resistance_beyond_friction_lets_it_slide_without_rolling():
    """c > mu r: rolling sticks while it slides, held with mu N r, to where a block comes to rest."""
    given = {"v_x": (1, "m/s"), "arm": (1.1 * MU * RADIUS, "m")}
    run = simulate(model(), duration="1 s", method="esdirk", tolerance=1e-8, parameters=given)
    assert np.all(run["rolling.turning"] == 0)
    slides = run["floor.slip"] != 0
    assert np.abs(run["rolling.moment"][slides]) == pytest.approx(MU * MASS * GRAVITY * RADIUS, rel=1e-6)
    assert run.engine.final["flight.x"] == pytest.approx(1 / (2 * MU * GRAVITY), rel=1e-8)
    assert run.engine.final["flight.angular_speed_z"] == pytest.approx(0, abs=1e-14)


def test_a_growing_torque_drills_once_it_is_beyond_the_limit():
    """At c N/rise, to the tolerance of a moment at the scene's arm; then with the integral of what exceeds it."""
    limit, rise = DRILL * MASS * GRAVITY, 1e-5
    begins = limit / rise
    run = simulate(pushed(), duration=f"{begins + 1!r} s", method="dop853", tolerance=1e-8)
    first = np.flatnonzero(run["drilling.turning"])[0]
    assert run.t[first] == pytest.approx(begins, rel=2e-4)
    assert np.all(run["rolling.turning"] == 0)
    assert run.engine.final["flight.angular_speed_y"] == pytest.approx(rise / 2 / (0.4 * MASS * RADIUS**2), rel=1e-5)


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_wheel_under_a_block_stops_and_holds_its_guide(coordinates):
    """In plane motion: after spin I/(c N), and then stays against a torque below c N, which the guide takes up."""
    spin, inertia, normal = 20, 1e-3, 2 * GRAVITY
    drag = hd.RollingResistance("drag", "rub", hd.Parameter("arm", "m", ARM))
    push = hd.JointForce("push", "axle", hd.Parameter("push", "N m", 0))
    built = engine_model(brake(drag, push).with_coordinates(coordinates))
    given = {"spin": (spin, "rad/s"), "push": (-0.5 * ARM * normal, "N m")}
    run = simulate(built, duration="3 s", method="dop853", tolerance=1e-8, parameters=given)
    stops = spin * inertia / (1.5 * ARM * normal)
    assert run.t[rests(run, "drag.turning")] == pytest.approx(stops, rel=1e-8)
    run = run.with_histories("guide.reaction_moment_z", "drag.moment_z", "axle.speed", "axle.angle")
    assert run["axle.angle"][-1] == pytest.approx(spin * stops / 2, rel=1e-8)
    assert abs(run["axle.speed"][-1]) < 1e-13
    assert run["drag.moment_z"][[1, -1]] == pytest.approx([-ARM * normal, 0.5 * ARM * normal], rel=1e-6)
    assert run["guide.reaction_moment_z"] == pytest.approx(run["drag.moment_z"], rel=1e-6)


def test_resistance_alone_has_modes_beside_smoothed_friction():
    """Sliding is then no mode, and its velocity no slip: the spin stops as before."""
    smooth = smooth_coulomb(hd.Parameter("mu_k", "1", MU), hd.Parameter("v_s", "m/s", 1e-3))
    built = engine_model(scene(law=smooth))
    assert [name for name, *_ in built.slips] == ["rolling.turning_1", "rolling.turning_2", "drilling.turning"]
    spin = 0.2
    run = simulate(built, duration="0.8 s", method="rodas", tolerance=1e-7, parameters={"w_y": (spin, "rad/s")})
    assert run.t[rests(run, "drilling.turning")] == pytest.approx(spin / SPIN_SLOWS, rel=1e-6)
    assert run["floor.sliding_velocity"][-1] == pytest.approx(0, abs=1e-12)


# ---- rest as a result ------------------------------------------------------------------------------------------------


def test_statics_hold_it_up_to_the_angle_of_repose_and_where_it_rests_has_derivatives():
    below, above = (math.atan(share * ARM / RADIUS) for share in (1 - 1e-6, 1 + 1e-6))
    held = equilibrium(model(), parameters={"slope": below})
    assert held.outcome.name == "found"
    assert held.sticking["rolling"] == pytest.approx(MASS * GRAVITY * RADIUS * math.sin(below), rel=1e-9)
    assert held.sticking["floor"] == pytest.approx(MASS * GRAVITY * math.sin(below), rel=1e-9)
    assert ("sticks", "rolling", held.sticking["rolling"], "N m") in held.rows
    assert equilibrium(model(), parameters={"slope": above}).outcome.name == "no_equilibrium"
    # v^2/(2 a): by the arm -x/c, by the speed 2 x/v; the spin's heat by the patch none, all of it is spent.
    run = simulate(model(), duration="3.2 s", method="dop853", tolerance=1e-9, parameters=shot(0.2, 0, 0.5))
    derivatives = run.sensitivities("arm", "patch", "gravity")
    assert derivatives.reason == ""
    way = run.engine.final["flight.x"]
    assert derivatives["flight.x", "arm"][-1] == pytest.approx(-way / ARM, rel=1e-7)
    assert derivatives["flight.x", "gravity"][-1] == pytest.approx(-way / GRAVITY, rel=1e-7)
    assert derivatives["flight.x", "patch"][-1] == pytest.approx(0, abs=1e-9)
    assert derivatives["drilling.dissipated", "patch"][-1] == pytest.approx(0, abs=1e-9)


# ---- declared and shown ----------------------------------------------------------------------------------------------


def test_a_load_by_the_normal_force_is_one_by_the_weight_and_those_by_reactions_that_it_changes_are_refused():
    """Friction changes no normal force: what rolls and rests beside a load by it moves as beside a known one."""
    body, lever = ball(dry(MU)).mechanism.joints[0].child.body, hd.Parameter("lever", "m", 1e-4)
    runs = [
        simulate(scene(hd.BodyTorque("fed", body, (0, lever * force, 0))), duration="50 ms", tolerance=1e-9, parameters={"v_x": (0.1, "m/s")})
        for force in (hd.normal_force_of("floor"), hd.Parameter("weight", "N", MASS * GRAVITY))
    ]  # fmt: skip
    one, other = (run.engine.final["flight.x_speed"] for run in runs)
    assert one == pytest.approx(other, rel=1e-9)
    assert abs(one - 0.1) > 1e-3  # it is slowed
    body, bob = (
        ball(dry(MU)).mechanism.joints[0].child.body,
        hd.Body("bob", hd.Parameter("m_bob", "kg", 1.0), hd.Parameter("J_bob", "kg m^2", 1e-3)),
    )
    more = (hd.BodyTorque("fed", body, (0, hd.Parameter("lever", "m", 1e-6) * hd.reaction_of("hinge"), 0)),)
    found = scene()
    joints = (*found.mechanism.joints, hd.Revolute("hinge", hd.GROUND, bob, axis=hd.Z))
    with pytest.raises(hd.InputError) as caught:
        hd.generate(replace(found, mechanism=replace(found.mechanism, joints=joints), effects=(*found.effects, *more)))
    for word in ("effect rolling", "effect rub", "in several directions beside loads by reactions", "Give it a speed"):
        assert word in str(caught.value)
    assert "effect drilling" not in str(caught.value)  # about one axis
