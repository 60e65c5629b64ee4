"""Set-valued friction of a circular patch: a disc that stops sliding and spinning at once, rests, and sets off at its limit surface."""

import math
from functools import cache

import casadi as ca
import numpy as np
import pytest
from patches import DISC, GRAVITY, MU, RIM, flat_disc, shares
from scipy.integrate import solve_ivp

from hertzwerk.derive import BodyTorque, Parameter, PatchFriction, PointForce, T
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.integration.events.slip_directions import settling
from hertzwerk.runtime.engine.integration.friction import limit_sets
from hertzwerk.runtime.engine.integration.step.set_valued_friction import solve_sticking

pytestmark = pytest.mark.by_turns(7)  # methods that run the same code

REFERENCES = (
    pytest.param(method, 1.0, 10.5, "tree", marks=[pytest.mark.exhaustive] if method == "idas" else [pytest.mark.slow])
    for method in ("cvodes", "idas")
)
METHODS = ("dop853", "dopri5", "rodas", "esdirk", "auto")
WEIGHT = MU * DISC * GRAVITY  # N, the largest friction force


def dry():
    return PatchFriction("rub", "floor", Parameter("mu", "1", MU), Parameter("rim", "m", RIM))


@cache
def built(**coordinates):
    return load(flat_disc(dry(), **coordinates))


@cache
def pushed():
    """The disc under a force along X and a moment about the normal that grow with time, or do not."""
    disc = flat_disc(dry()).mechanism.joints[-1].child.body
    push = Parameter("push", "N", 0) + Parameter("push_rise", "N/s", 0) * T
    twist = Parameter("twist", "N m", 0) + Parameter("twist_rise", "N m/s", 0) * T
    return load(
        flat_disc(dry(), PointForce("pull", disc.at(0, 0, 0), (push, 0, 0)), BodyTorque("turn", disc, (0, twist, 0)))
    )


@cache
def stop(slide, spin):
    """Time and way to rest of dv/dt = -mu g F, R dw/dt = -2 mu g M: to a millionth of the start, then evenly."""

    def rates(_, y):
        force, moment = shares(y[0] / (RIM * y[1]))
        return [-MU * GRAVITY * force, -2 * MU * GRAVITY / RIM * moment, y[0]]

    def end(_, y):
        return y[0] - 1e-6

    end.terminal = True
    found = solve_ivp(rates, (0, 2), [slide, spin, 0], "DOP853", rtol=1e-12, atol=1e-13, events=end)
    v, _, x = found.y[:, -1]
    a = -rates(0, found.y[:, -1])[0]
    return found.t[-1] + v / a, x + v**2 / (2 * a)


# ---- rest ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("method", "slide", "spin", "coordinates"),
    [*((method, 1.0, 10.5, "tree") for method in METHODS), *REFERENCES, ("dop853", 0.6, 10.0, "absolute")],
)
def test_sliding_and_spin_stop_at_once_where_an_integration_of_its_own_ends(method, slide, spin, coordinates):
    """From above and from below the published ratio; then it does not even creep."""
    time, way = stop(slide, spin)
    given = {"slide": (slide, "m/s"), "spin": (spin, "rad/s")}
    run = simulate(built(coordinates=coordinates), duration=1.2 * time, method=method, tolerance=1e-8, parameters=given)
    rests = np.flatnonzero(run["rub.slip"])[-1] + 1
    assert run.t[rests] == pytest.approx(time, rel=1e-7)
    run = run.with_histories(
        "disc.x", "disc.z", "disc.x_speed", "disc.z_speed", "disc.angular_speed_y", "rub.moment_y", "rub.friction_force"
    )
    assert math.hypot(run["disc.x"][-1], run["disc.z"][-1]) == pytest.approx(way, rel=1e-8)
    for name in ("disc.x_speed", "disc.z_speed", "disc.angular_speed_y"):
        assert abs(run[name][-1]) < 1e-14
    force, moment = shares(slide / (RIM * spin))
    assert -run["rub.friction_force"][1] == pytest.approx(WEIGHT * force, rel=1e-3)
    assert np.abs(run["rub.moment_y"][1]) == pytest.approx(WEIGHT * RIM * moment, rel=1e-3)
    assert run.engine.final["rub.dissipated"] == pytest.approx(
        DISC / 2 * slide**2 + DISC / 4 * (RIM * spin) ** 2, rel=1e-8
    )
    assert run.energy_residual < 1e-8


@pytest.mark.parametrize(
    ("given", "time"),
    [({"spin": "0 rad/s"}, 1 / (MU * GRAVITY)), ({"slide": "0 m/s"}, 3 * RIM * 10 / (4 * MU * GRAVITY))],
)
def test_alone_each_ends_in_closed_form(given, time):
    run = simulate(built(), duration=1.1 * time, method="dop853", tolerance=1e-9, parameters=given)
    assert run.t[np.flatnonzero(run["rub.slip"])[-1] + 1] == pytest.approx(time, rel=1e-8)


@pytest.mark.parametrize("ratio", [0.2, 0.6, 1.5])
def test_it_sets_off_where_the_limit_surface_is_reached(ratio):
    """Under a force and a moment that grow in proportion: not where either alone would slide, and not where an ellipsoid ends."""
    force, moment = shares(ratio)
    given = {
        "slide": "0 m/s", "spin": "0 rad/s", "push_rise": (WEIGHT * force, "N/s"), "twist_rise": (WEIGHT * RIM * moment, "N m/s"),
    }  # fmt: skip
    run = simulate(pushed(), duration="1.05 s", method="dop853", tolerance=1e-9, parameters=given)
    moves = np.flatnonzero(run["rub.slip"])
    assert run.t[moves[0]] == pytest.approx(1, rel=1e-5)
    assert np.array_equal(moves, np.arange(moves[0], len(run.t)))
    assert abs(math.hypot(force, 1.5 * moment) - 1) > 1e-3


def test_where_it_stops_has_derivatives():
    """By the coefficient the way falls as 1/mu, whatever the spin; by speeds as integrations nearby say."""
    given = {"slide": (0.6, "m/s"), "spin": (10.0, "rad/s")}
    time, way = stop(0.6, 10.0)
    run = simulate(built(), duration=1.2 * time, method="dop853", tolerance=1e-9, parameters=given)
    derivatives = run.sensitivities("mu", "slide")
    assert derivatives.reason == ""
    side = math.copysign(1, run.engine.final["floor_plane.x"])
    assert side * derivatives["floor_plane.x", "mu"][-1] == pytest.approx(-way / MU, rel=1e-5)
    by_speed = (stop(0.6 + 1e-4, 10.0)[1] - stop(0.6 - 1e-4, 10.0)[1]) / 2e-4
    assert side * derivatives["floor_plane.x", "slide"][-1] == pytest.approx(by_speed, rel=1e-5)


# ---- the limit surface -----------------------------------------------------------------------------------------------


@cache
def surface():
    x = ca.SX.sym("x", 3)
    found = limit_sets.opposed(x), limit_sets.gauge(x), limit_sets.outward(x), *limit_sets.normal_and_curvature(x)
    return ca.Function("surface", [x], [*found, ca.jacobian(limit_sets.gauge(x), x)])


def test_the_limit_surface_is_that_of_the_published_integrals_with_normal_gradient_and_curvature():
    random = np.random.default_rng(3)
    for _ in range(200):
        velocity = random.normal(size=3) * np.array([1, 1, random.choice([0.1, 1, 10])])
        across = np.linalg.norm(velocity[:2])
        force = np.array(surface()(velocity)[0]).ravel()
        known = shares(across / abs(velocity[2]))  # they cancel where one is slow
        assert [np.linalg.norm(force[:2]), abs(force[2])] == pytest.approx(known, abs=1e-7)
        _, size, normal, *_ = (np.array(x).ravel() for x in surface()(force))
        assert size == pytest.approx(1, rel=1e-12)
        assert normal == pytest.approx(velocity / np.linalg.norm(velocity), abs=1e-12)
    x, step = np.array([0.3, -0.2, 0.4]), 1e-5
    _, _, _, gradient, curvature, slope = (np.array(part) for part in surface()(x))
    sizes, gradients = (
        [np.array(surface()(x + sign * step * way)[i]).ravel() for way in np.eye(3) for sign in (1, -1)] for i in (1, 3)
    )
    differences = [(sizes[2 * i] - sizes[2 * i + 1]).item() / (2 * step) for i in range(3)]
    assert slope.ravel() == pytest.approx(differences, rel=1e-8)
    assert gradient.ravel() == pytest.approx(slope.ravel() * float(surface()(x)[1]), rel=1e-12)
    assert curvature == pytest.approx(
        np.array([gradients[2 * i] - gradients[2 * i + 1] for i in range(3)]) / (2 * step), abs=1e-8
    )


def test_patches_and_pairs_settle_together():
    """Random bodies on two patches and a foot: what slides is opposed by the force of its velocity, what rests is held within."""
    groups, random, slid = ((0, 1, 2), (3, 4), (5, 6, 7)), np.random.default_rng(1), 0
    W_, sticks_, right_ = ca.SX.sym("W", 8, 8), ca.SX.sym("sticks", 8), ca.SX.sym("right", 8)
    held = ca.Function("held", [W_, sticks_, right_], [ca.densify(solve_sticking(W_, sticks_, right_))])
    settle = settling(groups)
    for _ in range(60):
        few, all_ = random.normal(size=(8, 3)), random.normal(size=(8, 8))
        W, b = few @ few.T + random.choice([1, 1e-2]) * all_ @ all_.T, 3 * random.normal(size=8)
        limit = np.repeat(random.uniform(0.1, 2, 3) * random.choice([1, 10]), [3, 2, 3])
        slip, busy = (np.array(x).ravel() for x in settle(W, b, np.ones(8), limit, np.zeros(8), limit))
        assert not busy[0]
        sticks, force = np.ones(8), np.zeros(8)
        for group in map(list, groups):
            if np.any(slip[group]):
                slid, sticks[group] = slid + 1, 0
                opposed = np.array(surface()(slip[group])[0]).ravel() if len(group) > 2 else slip[group]
                force[group] = -limit[group] * opposed
        force += np.array(held(W, sticks, -(b + W @ force))).ravel()
        a, size = b + W @ force, np.max(np.abs(b) + np.abs(W) @ np.abs(force))
        for group in map(list, groups):
            gauge = float(surface()(force[group])[1]) if len(group) > 2 else np.linalg.norm(force[group])
            assert gauge <= limit[group[0]] * (1 + 1e-5)
            assert a[group] == pytest.approx(np.linalg.norm(a[group]) * slip[group], abs=2e-6 * size)
    assert 60 < slid < 170
