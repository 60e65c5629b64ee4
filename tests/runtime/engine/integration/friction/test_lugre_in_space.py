"""LuGre friction with two directions of sliding: bristles that bend, tilt and twirl, against equations of their own and closed forms."""

import math
from functools import cache

import numpy as np
import pytest
import sympy as sp
from balls import GRAVITY, MASS, RADIUS, STIFFNESS, ball
from jacobians import check_jacobian, start_of
from scipy.integrate import solve_ivp

import hertzwerk.derive as hd
from hertzwerk.derive.laws import LAWS, kelvin_voigt, lugre, power
from hertzwerk.derive.laws.law import FrictionLaw, N, Quantity, s, z
from hertzwerk.runtime import equilibrium, modes, simulate
from hertzwerk.runtime.engine.integration.step.implicit_step import linearised
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(6)  # methods and coordinates that run the same code

MU_K, MU_S, V_S, S_0, S_1 = 0.2, 0.3, 0.05, 1e4, 20.0
METHODS = ("dop853", "dopri5", "rodas", "esdirk", "auto")


def bristles():
    return lugre(
        hd.Parameter("mu_k", "1", MU_K), hd.Parameter("mu_s", "1", MU_S), hd.Parameter("v_S", "m/s", V_S),
        hd.Parameter("s_0", "1/m", S_0), hd.Parameter("s_1", "s/m", S_1), hd.Parameter("c_v", "N s/m", 0),
    )  # fmt: skip


@cache
def built(**options):
    """The model of a ball, derived once."""
    return engine_model(ball(bristles(), **options))


def level(speed):
    """Coefficient of steady sliding."""
    return MU_K + (MU_S - MU_K) * math.exp(-((speed / V_S) ** 2))


# ---- a ball that slides, rolls and spins -----------------------------------------------------------------------------

SHOT = {"v_x": 0.5, "v_z": 0.2, "w_x": 20.0, "w_y": 60.0, "w_z": 5.0}


def rates(_, state):
    """Rates of place, velocity, spins and bristle (x, z each) of a ball on a level floor, pressed by its weight."""
    v, w, bent, twirl = state[2:4], state[4:7], state[7:9], state[5] / 2
    slip = np.array([v[0] + RADIUS * w[2], v[1] - RADIUS * w[0]])  # v + w x (-r e_y)
    own = slip - S_0 * np.linalg.norm(slip) * bent / level(np.linalg.norm(slip))
    own += twirl * np.array([bent[1], -bent[0]])  # it turns about the normal with half the ball's spin
    pull = -MASS * GRAVITY * (S_0 * bent + S_1 * (own - twirl * np.array([bent[1], -bent[0]])))
    moment = np.array([-RADIUS * pull[1], 0, RADIUS * pull[0]]) / (0.4 * MASS * RADIUS**2)
    return [*v, *(pull / MASS), *moment, *own]


@cache
def shot():
    start = [0, 0, SHOT["v_x"], SHOT["v_z"], SHOT["w_x"], SHOT["w_y"], SHOT["w_z"], 0, 0]
    times = np.array([2e-3, 0.02, 0.06, 0.2])
    return times, solve_ivp(rates, (0, 0.2), start, "Radau", t_eval=times, rtol=1e-10, atol=1e-13).y


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("method", METHODS)
def test_a_ball_that_spins_is_what_scipy_finds(method, coordinates):
    times, known = shot()
    units = {name: (value, "m/s" if name[0] == "v" else "rad/s") for name, value in SHOT.items()}
    run = simulate(built(coordinates=coordinates), duration="0.2 s", method=method, tolerance=1e-8, parameters=units)
    rows = run.at(times)
    for row, name in enumerate(["x", "z", "x_speed", "z_speed"]):
        assert rows[f"flight.{name}"] == pytest.approx(known[row], abs=1e-7)
    for row, axis in enumerate("xz", 7):
        assert rows[f"rub.bristle_{axis}"] == pytest.approx(known[row], abs=1e-5 * MU_S / S_0)
    assert np.max(np.abs(known[8, :2])) > 0.1 * MU_S / S_0
    assert run.energy_residual < 1e-7
    assert run.outcome.finished


# ---- presliding ------------------------------------------------------------------------------------------------------


def test_bristles_are_springs_of_load_times_stiffness_and_hold_on_a_slope():
    """A particle at rest: two vibrations of sqrt(s_0 g), damped by s_1 g; they may stick anywhere."""
    found = modes(built(turns=False))
    sideways = [mode for mode in found.modes if mode.eigenvalue and abs(mode.shape["y.travel"]) < 1e-6]
    assert len(sideways) == 2
    for mode in sideways:
        assert abs(mode.eigenvalue) == pytest.approx(math.sqrt(S_0 * GRAVITY), rel=1e-9)
        assert -2 * mode.eigenvalue.real == pytest.approx(S_1 * GRAVITY, rel=1e-6)
    # Within mu_s, whatever the direction; the deflection is tan(slope)/s_0.
    held = equilibrium(built(turns=False), parameters={"slope": 0.1})
    assert held.converged
    assert held.sticking["rub"] == pytest.approx(math.tan(0.1) / S_0, rel=1e-9)
    assert (
        equilibrium(built(turns=False), parameters={"slope": math.atan(MU_S) * 1.01}).outcome.name == "no_equilibrium"
    )
    run = simulate(
        built(turns=False), duration="0.3 s", method="esdirk", tolerance=1e-8, parameters={"slope": 0.1}, initial=held
    )
    assert abs(run.engine.final["x.speed"]) < 1e-8


# ---- driven: sliding that goes on, and what an observer who turns sees -----------------------------------------------


@cache
def driven():
    """A ball carried along X and Z of a plate at given speeds, that only presses; the plate turns about Y."""
    mass, radius = hd.Parameter("mass", "kg", MASS), hd.Parameter("radius", "m", RADIUS)
    plate, cart, sledge = (
        hd.Body(name, mass, (hd.Parameter("inertia", "kg m^2", 1),) * 3) for name in ("plate", "cart", "sledge")
    )
    body = hd.Body("body", mass, (0.4 * mass * radius**2,) * 3)
    turn, wave = hd.Parameter("turn", "rad/s", 0), hd.Parameter("wave", "mm", 0)
    joints = (
        hd.Revolute("table", hd.GROUND, plate, axis=hd.Y), hd.Prismatic("x", plate, cart, axis=hd.X),
        hd.Prismatic("z", cart, sledge, axis=hd.Z), hd.Prismatic("y", sledge, body, axis=hd.Y),
    )  # fmt: skip
    pair = hd.SphereOnPlane("floor", body.at(0, 0, 0), radius, plate.at(0, 0, 0), hd.Y)
    stiffness, gravity = hd.Parameter("stiffness", "N/m", STIFFNESS), hd.Parameter("gravity", "m/s^2", GRAVITY)
    rate = hd.Parameter("rate", "rad/s", 20)
    effects = (
        hd.Drive("turning", "table", position=turn * hd.T),
        hd.Drive("along", "x", position=hd.Parameter("v_x", "m/s", 0) * hd.T + wave * sp.sin(rate * hd.T)),
        hd.Drive("across", "z", position=hd.Parameter("v_z", "m/s", 0) * hd.T + wave * sp.sin(2 * rate * hd.T)),
        hd.Gravity("gravity", gravity, direction=-hd.Y), hd.Contact("floor", power(stiffness, 1), kelvin_voigt(hd.Parameter("e", "1", 0.2))),
        hd.Friction("rub", "floor", bristles()),
    )  # fmt: skip
    scales = hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=radius)
    return engine_model(
        hd.Scene(
            hd.Mechanism("driven", joints, (pair,)), effects, scales, hd.Start(position={"y": radius - mass * gravity / stiffness}),
        )
    )  # fmt: skip


@pytest.mark.parametrize(("speed", "way"), [(0.01, 0.3), (0.05, 2.0), (0.3, -1.1)])
def test_steady_sliding_is_on_the_stribeck_curve_in_every_direction(speed, way):
    given = {"v_x": (speed * math.cos(way), "m/s"), "v_z": (speed * math.sin(way), "m/s")}
    run = simulate(driven(), duration="0.5 s", method="esdirk", tolerance=1e-8, parameters=given)
    bent = np.array([run.engine.final["rub.bristle_x"], run.engine.final["rub.bristle_z"]])
    ahead = np.array([math.cos(way), math.sin(way)])
    assert bent == pytest.approx(level(speed) / S_0 * ahead, abs=1e-6 * MU_S / S_0)
    force = np.array([run[f"floor.friction_force_{axis}"][-1] for axis in "xyz"])
    assert force[[0, 2]] == pytest.approx(-level(speed) * MASS * GRAVITY * ahead, rel=1e-5)
    assert force[1] == 0
    assert run["floor.friction_force"][-1] == pytest.approx(-np.linalg.norm(force), rel=1e-12)


def test_bristles_are_the_same_to_an_observer_who_turns():
    """Plate and ball turned together, at any rate: in the plate's axes the bristle does what it does at rest."""
    times, turn = np.linspace(0.05, 0.5, 10), 7.0
    given = {"wave": "0.2 mm"}
    still, moved = (
        simulate(
            driven(), duration="0.5 s", method="esdirk", tolerance=1e-9, parameters=given | {"turn": (rate, "rad/s")}
        ).at(times)
        for rate in (0.0, turn)
    )
    bent, seen = (np.array([run[f"rub.bristle_{axis}"] for axis in "xz"]) for run in (still, moved))
    cos, sin = np.cos(turn * times), np.sin(turn * times)
    back = np.array([cos * seen[0] - sin * seen[1], sin * seen[0] + cos * seen[1]])  # a turn about Y takes X to -Z
    assert np.max(np.abs(bent)) > 0.5 * MU_K / S_0
    assert np.max(np.abs(back - bent)) < 1e-6 * MU_S / S_0
    assert np.max(np.abs(seen - bent)) > 0.1 * MU_S / S_0


# ---- normals that turn -----------------------------------------------------------------------------------------------


def two_balls(**coordinates):
    """A ball that falls on another, aside and spinning: the normal turns while they touch."""
    mass, radius = hd.Parameter("mass", "kg", MASS), hd.Parameter("radius", "m", RADIUS)
    upper = hd.Body("upper", mass, (0.4 * mass * radius**2,) * 3)
    pair = hd.SphereOnSphere("touch", upper.at(0, 0, 0), hd.GROUND.at(0, 0, 0), radius, radius)
    effects = (
        hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", GRAVITY), direction=-hd.Y),
        hd.Contact("touch", power(hd.Parameter("stiffness", "N/m", 1e4), 1)), hd.Friction("rub", "touch", bristles()),
    )  # fmt: skip
    start = hd.Start(
        position={"flight.x": 0.2 * radius, "flight.z": 0.1 * radius, "flight.y": 1.94 * radius},
        speed={
            "flight.x_speed": hd.Parameter("v", "m/s", 0.3),
            "flight.angular_speed_y": hd.Parameter("w_y", "rad/s", 50),
            "flight.angular_speed_x": hd.Parameter("w_x", "rad/s", 9),
        },
    )
    scales = hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=radius)
    return engine_model(
        hd.Scene(
            hd.Mechanism("two_balls", (hd.Free("flight", hd.GROUND, upper),), (pair,)), effects, scales, start, **coordinates,
        )
    )  # fmt: skip


def test_bristles_stay_in_the_tangent_plane_that_tilts():
    runs = [
        simulate(two_balls(coordinates=c), duration="20 ms", method="dop853", tolerance=1e-9)
        for c in ("tree", "absolute")
    ]
    run = runs[0]
    bent = np.array([run[f"rub.bristle_{axis}"] for axis in "xyz"])
    normal = np.array([run[f"flight.{axis}"] for axis in "xyz"])
    normal /= np.linalg.norm(normal, axis=0)
    touches = run["touch.mode"] == 1
    assert np.ptp(normal[0][touches]) > 0.02
    assert np.max(np.abs(bent)) > 0.5 * MU_K / S_0
    assert np.max(np.abs(np.sum(bent * normal, axis=0))) < 1e-6 * MU_S / S_0
    for name in ("flight.x", "flight.z", "flight.x_speed", "rub.bristle_y"):
        assert runs[1].engine.final[name] == pytest.approx(run.engine.final[name], rel=1e-6, abs=1e-12)


def test_jacobian_against_differences():
    model = two_balls()
    bound = model.bind()
    y = np.concatenate([*start_of(model, bound), [2e-5, -1e-5, 1e-5]])
    y[3:7] = np.array([0.7, 0.1, -0.5, 0.5]) / np.linalg.norm([0.7, 0.1, -0.5, 0.5])
    check_jacobian(model, y, np.ones(model.k), np.zeros(0), bound, steps=1e-7, within=1e-5)
    y[7:13] = 0  # at rest the decay |s| z has a corner
    assert np.all(np.isfinite(np.array(linearised(model)(0.0, y, np.ones(model.k), np.zeros(0), bound.c)[0])))


# ---- other laws ------------------------------------------------------------------------------------------------------


def test_a_law_that_is_not_linear_in_its_deflection_is_refused():
    mu, k = (Quantity(name, unit, name) for name, unit in (("mu", "1"), ("k", "1/m")))
    cubic = FrictionLaw(
        name="cubic", title="bristles that harden", parameters=(mu, k), force=mu * N * (k * z + (k * z) ** 3),
        memory=((z, s - k * sp.Abs(s) * z, 1 / k),), source="test", grade="D",
    )  # fmt: skip
    assert cubic.in_two_directions is None
    assert all(law.in_two_directions for law in LAWS.values() if isinstance(law, FrictionLaw) and law.memory)
    with pytest.raises(
        hd.InputError, match=r"(?s)effect rub: found law cubic at floor.*linear in its deflection.*lugre"
    ):
        hd.derive(ball(cubic(hd.Parameter("mu", "1", 0.3), hd.Parameter("k", "1/m", 1e4))))
