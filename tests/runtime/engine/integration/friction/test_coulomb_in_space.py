"""Set-valued Coulomb friction in two directions: balls and particles on planes, against closed forms."""

import math
from functools import cache

import casadi as ca
import numpy as np
import pytest
from balls import GRAVITY, MASS, RADIUS, ball, dry
from each import each
from jacobians import check_jacobian, start_of

from hertzwerk.runtime import equilibrium, simulate
from hertzwerk.runtime.engine.integration.events.slip_directions import settling
from hertzwerk.runtime.engine.integration.step import implicit_step
from hertzwerk.runtime.engine.integration.step.set_valued_friction import solve_sticking
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(7)  # methods that run the same code

REFERENCES = tuple(pytest.param(name, marks=pytest.mark.exhaustive) for name in ("cvodes", "idas"))
METHODS = ("dop853", "dopri5", "rodas", "esdirk", "auto", *REFERENCES)
MU = 0.2


@cache
def built(**options):
    """The model of a ball, derived once."""
    return engine_model(ball(dry(MU), **options))


# ---- a billiard ball -------------------------------------------------------------------------------------------------

SHOT = {"v_x": "2 m/s", "w_x": "40 rad/s", "w_y": "30 rad/s", "w_z": "5 rad/s"}


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("method", METHODS)
def test_a_ball_with_side_spin_runs_on_a_parabola_until_it_rolls(method, coordinates):
    """Its slip keeps its direction and ends after 2 v/(7 mu g); Coriolis, Theorie mathematique des effets du jeu de billard (1835)."""
    slip = np.array([2 + 5 * RADIUS, -40 * RADIUS])  # of the contact point, along X and Z
    speed = float(np.linalg.norm(slip))
    end = 2 * speed / (7 * MU * GRAVITY)
    pull = -MU * GRAVITY * slip / speed
    model = built(coordinates=coordinates)
    run = simulate(model, duration="0.5 s", method=method, tolerance=1e-8, parameters=SHOT)
    rolls = np.flatnonzero(run["floor.slip"] == 0)
    assert np.array_equal(rolls, np.arange(rolls[0], len(run.t)))
    assert run.t[rolls[0]] == pytest.approx(end, rel=1e-7)
    rows = run.at(np.array([0.5 * end, 0.9 * end]))
    for i, t in enumerate((0.5 * end, 0.9 * end)):
        result = [rows[f"flight.{axis}"][i] for axis in "xz"]
        assert result == pytest.approx(np.array([2 * t, 0]) + pull * t * t / 2, rel=1e-7)
    final = [run.engine.final[f"flight.{axis}_speed"] for axis in "xz"]
    assert final == pytest.approx(np.array([2, 0]) + pull * end, rel=1e-7)
    assert run.engine.final["rub.dissipated"] == pytest.approx(MASS * speed**2 / 7, rel=1e-7)
    assert run.energy_residual < 1e-8


def test_friction_is_a_vector():
    """Its components in space, against the slip: among the readings, and by its two tangents."""
    run = simulate(built(), duration="0.1 s", method="dop853", tolerance=1e-8, parameters=SHOT)
    slip = np.array([2 + 5 * RADIUS, -40 * RADIUS])
    actual = np.array([run[f"floor.friction_force_{axis}"][-1] for axis in "xyz"])
    expected = -MU * run["floor.normal_force"][-1] * slip / np.linalg.norm(slip)
    assert actual == pytest.approx([expected[0], 0, expected[1]], rel=1e-8, abs=1e-15)
    both = [run[f"floor.friction_force_{i}"][-1] for i in (1, 2)]
    assert -np.hypot(*both) == pytest.approx(run["floor.friction_force"][-1], rel=1e-15)
    total = [run[f"floor.force_{axis}"][-1] for axis in "xyz"]
    assert total == pytest.approx([actual[0], run["floor.normal_force"][-1], actual[2]], rel=1e-12)
    assert run["rub.power"][-1] == pytest.approx(np.linalg.norm(actual) * run["floor.sliding_velocity"][-1], rel=1e-12)
    assert {"floor.slip", "floor.friction_force", "floor.friction_force_1"} <= set(run)


# ---- a particle that turns downhill ----------------------------------------------------------------------------------


@pytest.mark.parametrize("method", METHODS)
def test_launched_across_the_critical_incline_half_the_speed_is_left(method):
    """tan(slope) = mu: v (1 + cos phi) stays v0, phi from downhill; with tau = tan(phi/2), g sin(slope) t/v0 = (1 - tau^2)/4 - ln(tau)/2."""
    slope, v0, tau = math.atan(MU), 0.5, 0.02
    t = ((1 - tau**2) / 4 - math.log(tau) / 2) * v0 / (GRAVITY * math.sin(slope))
    run = simulate(
        built(turns=False), duration=f"{t} s", method=method, tolerance=1e-8,
        parameters={"slope": slope, "v_z": f"{v0} m/s", "mu_s": 0.3},
    )  # fmt: skip
    v, phi = v0 * (1 + tau**2) / 2, 2 * math.atan(tau)
    assert run.engine.final["x.speed"] == pytest.approx(v * math.cos(phi), rel=1e-6)
    assert run.engine.final["z.speed"] == pytest.approx(v * math.sin(phi), rel=1e-5)
    assert v == pytest.approx(v0 / 2, rel=1e-3)
    assert run.energy_residual < 1e-8


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("ratio", [1.25, 3.0])
def test_launched_across_a_gentler_incline_it_stops_while_it_turns(method, ratio):
    """mu = ratio tan(slope): at rest after v0/(g sin) ratio/(ratio^2 - 1); for ratio > 2 it turns ever faster until then."""
    slope, v0 = math.atan(MU / ratio), 0.5
    stop = v0 / (GRAVITY * math.sin(slope)) * ratio / (ratio**2 - 1)
    run = simulate(
        built(turns=False), duration=f"{1.2 * stop} s", method=method, tolerance=1e-8,
        parameters={"slope": slope, "v_z": f"{v0} m/s"},
    )  # fmt: skip
    rests = np.flatnonzero(run["floor.slip"] == 0)
    assert run.t[rests[0]] == pytest.approx(stop, rel=5e-6)
    assert np.array_equal(rests, np.arange(rests[0], len(run.t)))
    assert abs(run.engine.final["x.speed"]) + abs(run.engine.final["z.speed"]) < 1e-14
    assert run.energy_residual < 1e-8
    assert len(run.t) < 3000


def test_held_at_rest_within_the_disc():
    """A particle on an incline, pulled aside: held up to mu N in any direction."""
    held = equilibrium(built(turns=False), parameters={"slope": 0.1})
    assert held.sticking["floor"] == pytest.approx(MASS * GRAVITY * math.sin(0.1), rel=1e-9)
    assert equilibrium(built(turns=False), parameters={"slope": math.atan(MU) * 1.01}).outcome.name == "no_equilibrium"


# ---- the equations ---------------------------------------------------------------------------------------------------


@each("slip", [(0.0, 0.0), (3e-4, -4e-4), (1e-2, 0.0)])
@pytest.mark.parametrize("large", [False, True])
def test_jacobian_against_differences(monkeypatch, slip, large):
    monkeypatch.setattr(implicit_step, "LARGE", 0 if large else math.inf)
    model = built.__wrapped__()
    bound = model.bind({"slope": 0.2})
    q, u = start_of(model, bound)
    u = u + np.array([4e-3, -1e-3, 5e-3, 0.1, 0.2, -0.3]) * (1 if any(slip) else 0)
    y = np.concatenate([q, u, np.zeros(model.nz)])
    y[3:7] = np.array([0.7, 0.1, -0.5, 0.5]) / np.linalg.norm([0.7, 0.1, -0.5, 0.5])
    check_jacobian(model, y, np.ones(model.k), np.array([*np.ones(model.nm - model.ns), *slip]), bound)


# ---- who sticks and who slips ----------------------------------------------------------------------------------------

PAIRS = ((0, 1), (2, 3), (4,), (5, 6))


def problems(number, *, singular):
    """Random W, b and sliding forces of three pairs in space and one in a plane; W of rank 3 but for a part of it."""
    random, n = np.random.default_rng(5), sum(map(len, PAIRS))
    for _ in range(number):
        few, all_ = random.normal(size=(n, 3)), random.normal(size=(n, n))
        limits = random.uniform(0.1, 2, len(PAIRS))
        sliding = np.concatenate([np.full(len(pair), x) for pair, x in zip(PAIRS, limits, strict=True)])
        yield few @ few.T + singular * all_ @ all_.T, 3 * random.normal(size=n), sliding


def feet(number, many):
    """Rigid bodies on feet: W of rank 6 at most, b, sliding forces, some of them small or none, and holding forces."""
    random = np.random.default_rng(many)
    for _ in range(number):
        rows, flat = [], random.random() < 0.5
        for _ in range(many):
            place, normal = random.normal(size=3), np.array([0, 0, 1.0]) if flat else random.normal(size=3)
            tangent = np.cross(normal, random.normal(size=3))
            both = (
                tangent / np.linalg.norm(tangent),
                np.cross(normal, tangent) / np.linalg.norm(np.cross(normal, tangent)),
            )
            rows += [np.concatenate([t, np.cross(place, t)]) for t in both]
        along, moments = np.array(rows), np.diag([1, 1, 1, *1 / random.uniform(0.2, 2, 3)])
        small = random.choice([1, 1, 1e-5, 0], many) if random.random() < 0.5 else np.ones(many)
        sliding = np.repeat(6 / many * small * random.uniform(0.02, 0.6, many), 2)
        yield along @ moments @ along.T, along @ random.normal(size=6), sliding, random.choice([1, 1.3]) * sliding


@cache
def held(n):
    """The function (W, sticks, right) -> forces of what sticks, as a step has them."""
    given = ca.SX.sym("W", n, n), ca.SX.sym("sticks", n), ca.SX.sym("right", n)
    return ca.Function("held", given, [ca.densify(solve_sticking(*given))])


def agrees(pairs, W, b, sliding, holding, slip):
    """Whether what slides does so against its friction, and the forces hold what sticks; and the number that slide."""
    alike = np.array([not np.any(slip[list(pair)]) for pair in pairs])
    sticks = np.concatenate([np.full(len(pair), still) for pair, still in zip(pairs, alike, strict=True)])
    force = -slip * sliding
    force += np.array(held(len(b))(W, sticks, -(b + W @ force))).ravel()
    a, size = b + W @ force, np.max(np.abs(b) + np.abs(W) @ np.abs(force))
    for pair in map(list, pairs):
        limit = (holding if sticks[pair[0]] else sliding)[pair[0]]
        assert np.linalg.norm(force[pair]) <= limit * (1 + 1e-5)
        assert np.linalg.norm(slip[pair]) == pytest.approx(float(not sticks[pair[0]]), rel=1e-12)
        assert a[pair] == pytest.approx(np.linalg.norm(a[pair]) * slip[pair], abs=2e-6 * size)
    return np.sum(~alike)


@pytest.mark.parametrize("singular", [1.0, 1e-2])
def test_sticking_pairs_are_held_and_sliding_ones_oppose_friction(singular):
    settle, n, slid = settling(PAIRS), sum(map(len, PAIRS)), 0
    for W, b, sliding in problems(200, singular=singular):
        slip, busy = (np.array(x).ravel() for x in settle(W, b, np.ones(n), sliding, np.zeros(n), sliding))
        assert not busy[0]
        slid += agrees(PAIRS, W, b, sliding, sliding, slip)
    assert 100 < slid < 800


@pytest.mark.parametrize("many", [4, 8])
def test_bodies_on_many_feet_settle_every_one(many):
    """Feet share their forces in many ways; sweeps over them one by one left 2 % unsettled, and 6 % held beyond their limits."""
    pairs = tuple((2 * i, 2 * i + 1) for i in range(many))
    settle, slid = settling(pairs), 0
    for W, b, sliding, holding in feet(100, many):
        first = np.zeros(2 * many)
        slip, busy = (np.array(x).ravel() for x in settle(W, b, np.ones(2 * many), sliding, first, holding))
        assert not busy[0]
        slid += agrees(pairs, W, b, sliding, holding, slip)
    assert 0.2 < slid / (100 * many) < 0.95
