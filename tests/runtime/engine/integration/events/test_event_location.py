"""Locating events: the first root against NumPy's, and motions with closed forms whose event is easily missed."""

import math

import casadi as ca
import numpy as np
import pytest
from each import each
from handmade import point
from numpy.polynomial import Polynomial
from scipy.integrate import solve_ivp

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.events.event_location import LANDING, NO_EVENT, endings, locate, tolerances
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.integration.tableaux.methods import IN_GRAPH
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(6)  # methods and sizes that run the same code

METHODS = ("dopri5", "dop853")
SEARCH = locate()


def bernstein(p: Polynomial) -> np.ndarray:
    """Bernstein coefficients on 0..1, degree 5: b_i = sum_j C(i, j)/C(5, j) a_j."""
    a = np.zeros(6)
    a[: len(p.coef)] = p.coef
    return np.array([sum(math.comb(i, j) / math.comb(5, j) * a[j] for j in range(i + 1)) for i in range(6)])


def first_root(p: Polynomial) -> float:
    roots = p.roots()
    real = sorted(x.real for x in roots if abs(x.imag) < 1e-12 and 0 < x.real <= 1)
    return real[0] if real else NO_EVENT


@each("seed", range(40))
def test_first_root_of_random_polynomials(seed):
    random = np.random.default_rng(seed)
    checked = 0
    for _ in range(25):
        p = Polynomial.fromroots(random.uniform(-1, 2, 5)) * random.uniform(0.5, 2)
        p = p if p(0) > 0 else -p
        roots = np.sort([r.real for r in p.roots() if 0 <= r.real <= 1])
        if len(roots) > 1 and np.min(np.diff(roots)) < 0.13:  # two in one part of the step: a graze, tested below
            continue
        actual = float(SEARCH(bernstein(p), 1e-14, 0))
        assert actual == pytest.approx(first_root(p), rel=1e-9, abs=1e-11)
        checked += 1
    assert checked > 3


@each("place", [0.03, 0.21, 0.5, 0.77, 0.98])
def test_a_dip_between_samples_is_found_at_its_first_root_and_a_near_miss_is_not(place):
    dip = Polynomial([place**2, -2 * place, 1])  # (x - place)^2
    below, above = dip - 1e-8, dip + 1e-8
    assert float(SEARCH(bernstein(below), 1e-12, 0)) == pytest.approx(place - 1e-4, rel=1e-6)
    assert float(SEARCH(bernstein(above), 1e-12, 0)) == NO_EVENT
    assert float(SEARCH(bernstein(above), 1e-12, 1e-6)) == 0.5  # in doubt: half the step


@pytest.mark.parametrize("method", METHODS)
def test_a_force_that_jumps_below_zero_ends_its_contact_at_the_jump(method):
    """As a corner past a corner: from 1 mm on it would pull what moves away, and there is no root to land on; v^2 = 1 - K d^2."""
    model = point(lambda d, v, v0: ca.if_else((d < 1e-3) * (v < 0), -100.0, 1e4 * d))
    start = {"path.travel": "1 mm", "path.speed": "-1 m/s"}
    run = simulate(model, duration=0.1, tolerance=1e-9, method=method, initial=start, max_steps=1000)
    assert run.outcome.finished
    assert run.engine.final["path.speed"] == pytest.approx(math.sqrt(0.99), abs=1e-8)


def quadratic(curvature: float, height: float):
    """Free motion x = height + curvature (t - 1/2)^2, touching x = height at t = 1/2."""
    initial = {"path.travel": f"{height + curvature / 4!r} m", "path.speed": f"{-curvature!r} m/s"}
    return point(lambda d, v, v0: 1e6 * d, push=lambda t, x, v: 2 * curvature + 0 * t), initial


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("height", [1e-3, 1e-6, 1e-9])
def test_a_graze_is_a_contact_on_one_side_and_none_on_the_other(method, height):
    for sign, contacts in ((-1, 1), (+1, 0)):
        model, initial = quadratic(9.81, sign * height)
        run = simulate(model, duration=1.0, tolerance=1e-9, method=method, initial=initial)
        assert run.outcome.finished
        assert len(run.impacts) == contacts
        if contacts:
            onset = 0.5 - math.sqrt(height / 9.81)
            assert run.impacts[0].t == pytest.approx(onset, abs=2e-11 / (2 * 9.81 * (0.5 - onset)) + 1e-12)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("depth", [1e-4, 1e-8])
def test_no_trough_of_an_oscillation_is_stepped_over(method, depth):
    """x = 1 - depth + cos(7 t) but for the contacts, whose force is negligible: it dips below the surface once per period."""
    model = point(lambda d, v, v0: 1e-12 * d, push=lambda t, x, v: -49 * ca.cos(7 * t))
    run = simulate(
        model, duration=20.0, tolerance=1e-11, method=method, initial={"path.travel": f"{2 - depth!r} m", "path.speed": "0 m/s"},
    )  # fmt: skip
    half = math.acos(1 - depth)
    expected = [(math.pi * (2 * i + 1) - half) / 7 for i in range(22)]
    assert [impact.t for impact in run.impacts] == pytest.approx(expected, abs=1e-9 / half)


@pytest.mark.parametrize("method", METHODS)
def test_a_ball_that_leaves_the_surface_returns_to_it_within_one_long_step(method):
    """After separation at 1e-3 m/s the flight of 2 v/g is far shorter than the step remembered from the fall."""
    model = point(
        lambda d, v, v0: 1e8 * d * (1 + 0 * v), push=lambda t, x, v: -9.81 + 0 * t, scales=(1e-3, 1.0, 1e3, 1.0)
    )
    run = simulate(
        model, duration=0.0105, tolerance=1e-9, method=method, initial={"path.travel": "0 m", "path.speed": "1e-3 m/s"},
    )  # fmt: skip
    assert run.outcome.finished
    onsets = [impact.t for impact in run.impacts]
    assert len(onsets) > 10
    assert onsets[0] == pytest.approx(2e-3 / 9.81, rel=1e-7)
    assert np.min(run["path.travel"]) > -1e-6  # never through the surface
    assert all(impact.speed == pytest.approx(1e-3, rel=1e-4) for impact in run.impacts)


@pytest.mark.parametrize("method", METHODS)
def test_released_and_pressed_in_again_is_in_contact_again(method):
    """A force that pulls the point out of the law's reach, then a constant push back before the gap has opened."""
    model = point(
        lambda d, v, v0: 1e4 * d * (1 + v), push=lambda t, x, v: ca.if_else(t < 0.0305, 2000 * t, -400.0), scales=(1e-2, 1.0, 100.0, 1.0),
    )  # fmt: skip
    run = simulate(
        model, duration=0.3, tolerance=1e-8, method=method, initial={"path.travel": "-0.05 m", "path.speed": "0.99 m/s"}
    )
    assert run.outcome.finished
    modes = run["surface.mode"]
    again = int(np.flatnonzero((modes[:-1] == 2) & (modes[1:] == 1))[0]) + 1
    assert np.all(run["path.travel"][: again + 1] < 0)  # the gap never opened
    assert abs(run["path.speed"][again]) < 1e-8  # it is where the opening speed runs out
    assert np.all(run["surface.normal_force"][modes == 2] == 0)
    assert run.engine.final["path.travel"] == pytest.approx(-0.04, rel=1e-3)  # 400 N on 1e4 N/m: held again


@pytest.mark.parametrize("method", METHODS)
def test_a_contact_that_hardly_reaches_its_surface_goes_on_in_time(method):
    """Thrown up from -2 um to 0.5 um, half of what counts as the surface: it stays in contact, and the surface is behind it."""
    tolerance, push = 1e-4, 10.0
    start, peak = -2e-2 * tolerance, 0.5e-2 * tolerance
    speed = math.sqrt(2 * push * (peak - start))
    model = point(lambda d, v, v0: 1e-3 * d, push=lambda t, x, v: -push + 0 * t)
    run = simulate(
        model,
        duration=3e-3,  # and so steps of at most 0.3 ms: 0.39 ms to the surface
        tolerance=tolerance,
        method=method,
        initial={"path.travel": f"{start!r} m", "path.speed": f"{speed!r} m/s"},
        max_steps=100,
    )
    assert run.outcome.finished
    assert np.all(np.diff(run.t) > 0)
    assert abs(run["path.travel"]).min() < 1e-2 * tolerance  # a step ended there
    assert np.all(run["surface.mode"] == 1)
    assert run.engine.final["path.travel"] == pytest.approx(start + 3e-3 * speed - 4.5e-6 * push, abs=1e-12)


def test_a_force_whose_rate_misleads_is_landed_on_all_the_same():
    """60 N falling to -11 N in 59 us, with rates of stiff damping that no cubic fits: as found where a landing took more than 60 retakes."""
    model = engine_model("bouncing_ball")
    vectors = layouts(model)
    force = endings(model, vectors)
    h = 5.9e-5
    start = dict.fromkeys(vectors.state.sizes, 0.0) | {
        "h": h, "mode": 1.0, "force": 60.2, "force_rate": -4.57e6, "gap": -1e-5,
    }  # fmt: skip
    end = start | {"force": -10.7, "force_rate": -4.65e7}
    controls = np.zeros(vectors.controls.size)
    controls[vectors.controls["scales"]] = [1e-4, 1.0, 1e4, 1.0]
    controls[vectors.controls["scale"]] = 1.0
    controls[vectors.controls["tolerance"]] = 1e-4

    def theta(retakes):
        rows = []
        for parts in (start | {"retakes": retakes}, end):
            row = np.zeros(vectors.state.size)
            for name, value in parts.items():
                row[vectors.state[name]] = value
            rows.append(row)
        return float(locate()(*force(rows[0], controls, rows[1], np.zeros(2))))

    assert theta(0) > 0.98  # 60 of them leave a third of the step
    assert theta(4) == pytest.approx(60.2 / 70.9, rel=1e-3)


def test_a_force_that_flattens_as_it_runs_out_is_landed_on():
    """F = K d^1.5 (1 + c d'/v0), both factors near zero at once: chords from its start took more than 60 retakes (from these three starts)."""
    K, c, v0, push, pull = 1e9, 0.1425, 0.02, 500, 75.84

    def outer(t):
        return ca.if_else(t < 3e-4, -1, ca.if_else(t < 8e-4, -push, pull))

    pulled = point(
        lambda d, v, speed: K * d**1.5 * (1 + c * v / speed), push=lambda t, x, v: outer(t), scales=(1e-5, 0.1, 100, 1e-3),
    )  # fmt: skip
    for start in (1.7185929648241205e-06, 1.7587939698492463e-06, 1.919597989949749e-06):
        parameters = {"x0": f"{start!r} m", "v0": f"{-v0} m/s"}
        run = simulate(pulled, duration="1.8 ms", tolerance=1e-6, parameters=parameters, method="dopri5")
        assert run.outcome.finished and run.statistics.retaken <= 20
        approach = math.sqrt(v0**2 + 2 * start)
        t, y = approach - v0, (0.0, -approach)

        def rates(t, y, approach=approach):
            force = K * max(-y[0], 0) ** 1.5 * (1 - c * y[1] / approach)
            return y[1], max(force, 0) + float(outer(t))

        for until in (3e-4, 8e-4, 1.8e-3):
            y, t = solve_ivp(rates, (t, until), y, rtol=1e-11, atol=1e-14, max_step=1e-5).y[:, -1], until
        assert run["path.speed"][-1] == pytest.approx(y[1], rel=1e-4)


def test_grazes_and_forces_within_rounding_are_not_located():
    """Lower than zero, but within the margin: bodies that touch, with gaps of rounding, would halve it for ever."""
    touching = np.array([0.0, -1e-19, 2e-19, -1e-19, 1e-19, 0.0])
    assert float(SEARCH(touching, 1e-13, 0)) == NO_EVENT
    assert float(SEARCH(touching, 1e-13, 1e-12)) == 0.5
    # Of a coordinate of 1 m by the contact's stiffness, however stiff, and of the time; else within the tolerance.
    model = engine_model("bouncing_ball")
    history = simulate(model, duration="1 ms", tolerance=1e-9, initial={"vertical.travel": "1 m"}).engine.history
    vectors = layouts(model)
    at, run = vectors.state.split(ca.DM(history.rows[0])), vectors.controls.split(ca.DM(history.controls))
    small = LANDING * 1e-9 * float(run["scales"][2])
    for gap, force_rate, least in (
        (-1e-9, 0.0, 60 / 1e-9 * np.spacing(1.0)), (-1e-3, 1e12, 1e12 * np.spacing(0.5)), (-1e-3, 0.0, small),
    ):  # fmt: skip
        at |= {"t": ca.DM(0.5), "gap": ca.DM(gap), "force": ca.DM(60), "force_rate": ca.DM(force_rate)}
        assert small <= least <= float(tolerances(model, run, at)[2]) < 20 * least


@pytest.mark.parametrize("method", IN_GRAPH)
def test_a_force_that_falls_through_zero_and_returns_to_it_with_the_gap_ends_its_contact(method):
    """K d^1.5 + c d d' pulls where it opens, in the last step alone. Ended 3.4 us late where a step of its own had landed short of that too."""
    stiffness, damping, speed = 2e8, 2.3e5, 2.8
    spent = lambda t, s: stiffness * math.sqrt(s[0]) + damping * s[1]  # noqa: E731
    spent.terminal, spent.direction = True, -1
    rates = lambda t, s: [s[1], -stiffness * s[0] ** 1.5 - damping * s[0] * s[1]]  # noqa: E731
    true = solve_ivp(rates, (0, 1), [1e-12, speed], "DOP853", rtol=1e-12, atol=1e-16, events=spent, max_step=1e-5)
    model = point(lambda d, v, v0: stiffness * d**1.5 + damping * d * v, scales=(1e-3, 3, 1e3, 1))
    start = {"x0": "1 mm", "v0": f"{-speed} m/s"}
    for tolerance in (1e-2, 1e-4, 10**-4.5, 1e-6):
        run = simulate(model, duration="4 ms", parameters=start, tolerance=tolerance, method=method, compiled=False)
        (impact,) = run.impacts
        assert impact.duration == pytest.approx(true.t[-1], abs=3e-8 + 3e-5 * tolerance)
        assert run["path.speed"][-1] == pytest.approx(-true.y[1][-1], abs=10 * tolerance)


@pytest.mark.parametrize("method", IN_GRAPH)
@pytest.mark.parametrize(
    ("stiffness", "most", "within"),
    [(1e-2, 0.009, {1e-5: 0.1 * 1e-5**0.5, 1e-9: 0.1 * 1e-9**0.5}), (1e-4, 0.00998, {1e-7: 1e-6, 1e-9: 1e-8})],
    ids=["a long step", "a step"],
)
def test_a_force_that_falls_through_zero_and_returns_within_a_step_ends_its_contact(stiffness, most, within, method):
    """K d (1 + c d'), while a push opens the overlap fast for a moment. On the old code no step saw it, at 1e-9 too."""
    law, push = (lambda d, v, v0=0: stiffness * d * (1 + v / most)), (lambda t, x=0, v=0: 0.04 * (1 - 2 * t))
    spent = lambda t, s: most - s[1]  # noqa: E731
    spent.terminal, spent.direction = True, -1
    rates = lambda t, s: [s[1], push(t) + law(-s[0], -s[1])]  # noqa: E731  of the place, below the surface
    true = solve_ivp(rates, (0, 1), [-0.1, 0.0], "DOP853", rtol=1e-12, atol=1e-16, events=spent, max_step=1e-3)
    model, start = point(law, push=push, scales=(0.1, 0.1, 1e-3, 1e-3)), {"x0": "-0.1 m", "v0": "0 m/s"}
    for tolerance, off in within.items():
        run = simulate(model, duration="1 s", parameters=start, tolerance=tolerance, method=method, compiled=False)
        released = np.flatnonzero(run["surface.mode"] == 2)
        assert len(released), tolerance
        assert run.t[released[0]] == pytest.approx(true.t[-1], abs=off)


@pytest.mark.parametrize("method", IN_GRAPH)
def test_a_released_contact_that_closes_for_a_moment_within_a_step_is_a_contact_again(method):
    """Opening speed .04 (t - .5)^2 - 4e-7, in closed form until it is zero. On the old code no step saw it."""
    model = point(
        lambda d, v, v0: 1e-4 * d * (1 + v / 0.005), push=lambda t, x, v: 0.08 * (t - 0.5), scales=(0.1, 0.1, 1e-3, 1e-3),
    )  # fmt: skip
    start = {"x0": "-0.1 m", "v0": f"{0.01 - 4e-7} m/s"}
    run = simulate(model, duration="1 s", parameters=start, tolerance=1e-9, method=method, compiled=False)
    assert run["surface.mode"][0] == 2
    again = np.flatnonzero(run["surface.mode"] == 1)
    assert len(again)
    assert run.t[again[0]] == pytest.approx(0.5 - 1e-5**0.5, abs=1e-7)


@pytest.mark.parametrize("method", IN_GRAPH)
def test_a_force_that_jumps_at_its_onset_needs_no_landing_beyond_the_surface(method):
    """Kelvin-Voigt begins at 2 z w v, but where rounding ends a landing on the surface or above it there is none yet."""
    w, z, v = 3e3, 0.3, 0.1
    model = point(lambda d, s, v0: w * w * d + 2 * z * w * s, scales=(v / w, v, v * w, 1.0))
    root = math.sqrt(1 - z * z)
    duration = (math.pi - math.atan2(2 * z * root, 1 - 2 * z * z)) / (w * root)
    for height in (10, 14, 15):  # mm, at which one of the methods lands so
        start = {"x0": f"{height} mm", "v0": f"{-v} m/s"}
        run = simulate(model, duration=0.2, tolerance=1e-13, method=method, compiled=False, parameters=start)
        assert run.outcome.finished
        (impact,) = run.impacts
        assert impact.duration == pytest.approx(duration, rel=1e-9)
