"""What the table takes for known, against oracles of its own: 60 digits, quadruple precision, an integrator of another make."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from hertzwerk.runtime.analysis.hard_cases import closed_forms as closed
from hertzwerk.runtime.analysis.hard_cases.case_table import BY_NAME
from hertzwerk.runtime.analysis.hard_cases.cases import sliding
from reference import closed_forms
from reference.slider_crank import reference


@pytest.mark.parametrize("e", ["0.01", "0.5", "0.7", "1"])
def test_restitution_and_depth_of_floress_law(e):
    h = closed_forms.factor("flores", e)
    exact = closed_forms.collision("1e8", "1.5", 1, 1, h)
    assert closed.flores(float(e)) == pytest.approx(h, rel=1e-14)
    assert closed.restitution_out(h) == pytest.approx(exact.restitution, rel=1e-12)
    assert closed.depth(1e8, 1.5, 1, 1, h) == pytest.approx(exact.depth, rel=1e-12)


def test_depths_under_gravity():
    v0 = closed_forms.drop_speed(1, "9.81")
    for K in (1e4, 2.4e10, 1e14):
        exact = closed_forms.depth_with_gravity(K, "1.5", 1, v0, "9.81")
        assert closed.depth_under_gravity(K, 1.5, 1, v0, 9.81) == pytest.approx(exact, rel=1e-12)
    assert closed.static_penetration(2.4e10, 1.5, 1, 9.81) == pytest.approx(
        closed_forms.static_penetration("2.4e10", "1.5", 1, "9.81"), rel=1e-14
    )


@pytest.mark.parametrize("pulls", [True, False])
def test_the_oscillator_ends_where_it_says(pulls):
    """x'' = -K x - 2 xi sqrt(K) x', from the exponential of its matrix."""
    K, xi = 1e6, closed.damping_ratio(0.5)
    e, duration = closed.oscillator(K, 1.0, xi, pulls=pulls)
    A = np.array([[0, 1], [-K, -2 * xi * math.sqrt(K)]])
    values, vectors = np.linalg.eig(A)
    x, v = np.real(vectors @ (np.exp(values * duration) * np.linalg.solve(vectors, [0, 1])))
    assert v == pytest.approx(-e, rel=1e-12)
    ends = x if pulls else (K * x + 2 * xi * math.sqrt(K) * v) / K
    assert ends == pytest.approx(0, abs=1e-15)
    assert (e == pytest.approx(0.5, rel=1e-14)) is pulls


@pytest.mark.parametrize("push", [0.0, 20.0])
def test_the_peak_of_an_oscillator_under_a_load(push):
    K, m, c, v0 = 1.2e7, 2.6, 530.0, 0.012
    times = np.linspace(0, 1.7e-3, 20001)
    found = solve_ivp(
        lambda _, x: [x[1], (push - K * x[0] - c * x[1]) / m], (0, times[-1]), [0, v0], "DOP853", times, rtol=1e-12, atol=1e-18,
    )  # fmt: skip
    assert closed.peak_of_oscillator(K, m, c, v0, push) == pytest.approx(
        np.max(K * found.y[0] + c * found.y[1]), rel=1e-7
    )


@pytest.mark.parametrize(("name", "friction", "time"), [("centred_start", False, 0.002), ("dead_centre", True, 0.006)])
def test_slider_crank_states_are_those_of_the_quadruple_precision_program(name, friction, time):
    case, state = BY_NAME[name], reference(friction).states[time]
    assert case.duration == time
    assert [known.expected for known in case.known] == pytest.approx([state.x, state.dx], rel=1e-15)


def test_the_touching_row_against_scipy():
    """Five spheres of 1 kg, K = 1e8 N/m^1.5, by SciPy's DOP853 at 1e-13 without any events."""

    def rates(_, y):
        x, v = y[:5], y[5:]
        force = 1e8 * np.maximum(x[:-1] - x[1:], 0) ** 1.5
        return np.concatenate([v, np.append(-force, 0) + np.insert(force, 0, 0)])

    start = np.zeros(10)
    start[5] = 1.0
    actual = solve_ivp(rates, (0, 0.02), start, method="DOP853", rtol=1e-12, atol=1e-15, max_step=2e-5)
    known = [k for k in BY_NAME["touching_row_of_5"].known if k.quantity.endswith(".speed")]
    assert [k.expected for k in known] == pytest.approx(actual.y[5:, -1], abs=1e-9)


def test_sliding_on_bristles_against_scipy():
    """m v' = drive - N (s0 z + s1 z'), z' = v - s0 |v| z/mu, with the load constant."""
    mu, damping = 0.99 * sliding.CRITICAL, 1000.0

    def rates(_, y):
        v, z = y
        bend = v - sliding.BRISTLE * abs(v) * z / mu
        return [(sliding.DRIVE - sliding.LOAD * (sliding.BRISTLE * z + damping * bend)) / sliding.MASS, bend]

    result = solve_ivp(rates, (0, 0.5), [sliding.START, 0], method="Radau", rtol=1e-11, atol=[1e-13, 1e-20])
    assert result.y[0, -1] == pytest.approx(sliding.LUGRE_SPEED, abs=1e-9)
    assert result.y[1, -1] == pytest.approx(mu / sliding.BRISTLE, rel=1e-9)
