"""Contacts that begin smoothly: two derivatives at onset and join, energy, units, the sheet; laws too steep for it."""

import casadi as ca
import numpy as np
import pytest
import sympy as sp

from hertzwerk.derive import LAWS, Contact, InputError, Parameter, audit_scene, generate, laws
from hertzwerk.derive.exchange.law_sheets.law_sheet import sheet
from hertzwerk.derive.laws.smoothing import begun, energy_begun, growths
from hertzwerk.derive.scenes.bouncing_ball import scene
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

EPSILON = 1e-4
K, CHI = Parameter("K", "N/m^1.5", 1e7), Parameter("chi", "N s/m^2.5", 1e6)
DAMPED = laws.power(K, n=1.5), laws.power_damping(CHI, m=1.5)


def smooth_ball(*law, smooth="0.1 mm"):
    return scene.replace(floor=Contact("floor", *law, smooth=smooth))


@pytest.fixture(scope="module")
def ball():
    return engine_model(smooth_ball(*DAMPED))


def force_of(model, depths, speed=0.0):
    """Force, and its first two derivatives with the penetration, at penetrations [m]."""
    bound, x = model.bind(), ca.SX.sym("x")
    found = model.function("contact_floor").call(
        [0, bound["radius"] - x, speed, ca.SX.zeros(model.nz), ca.SX(0, 1), bound.c]
    )[2]
    first = ca.jacobian(found, x)
    function = ca.Function("force", [x], [found, first, ca.jacobian(first, x)])
    return np.array([[float(part) for part in function(depth)] for depth in depths]).T


def test_the_smoothed_penetration_joins_with_two_derivatives():
    x, length = sp.symbols("x length", positive=True)
    begin, straight = begun(x, length), 2 * length * x - length
    for order in range(3):
        assert sp.diff(begin, x, order).subs(x, 0) == 0
        assert sp.expand((sp.diff(begin, x, order) - sp.diff(straight, x, order)).subs(x, 1)) == 0
    assert sp.diff(begin, x, 3).subs(x, 1) != 0  # and no more


def test_the_force_is_smooth_at_onset_and_join_and_deeper_by_the_length(ball):
    for speed in (0.0, -0.5):
        for at in (0.0, 2 * EPSILON):
            below, above = force_of(ball, [at - 1e-13, at + 1e-13], speed).T
            size = np.abs(force_of(ball, [EPSILON], speed)).ravel() + 1
            assert np.all(np.abs(below - above) < 1e-5 * size)
    hard = engine_model(scene.replace(floor=Contact("floor", *DAMPED)))
    _, _, curvature = force_of(hard, [1e-12])
    assert curvature > 1e12  # what the exact law has there
    depths = np.array([2.5, 10, 100]) * EPSILON
    force = force_of(ball, depths)[0]
    np.testing.assert_allclose(force, 1e7 * (depths - EPSILON) ** 1.5, rtol=1e-12)
    x = 0.3
    assert force_of(ball, [2 * EPSILON * x])[0] == pytest.approx(
        1e7 * (2 * EPSILON * (x**3 - x**4 / 2)) ** 1.5, rel=1e-12
    )
    assert force_of(ball, [-EPSILON, -1e-9]).tolist() == [[0, 0]] * 3


def test_smooth_forces_store_their_work_and_keep_energy():
    power = LAWS["power"]
    (k, n) = power.parameters
    for exponent in (1, sp.Rational(3, 2), sp.Rational(27, 10)):
        values = {k: sp.Integer(1), n: exponent}
        for share in (0.2, 1.0):
            actual = float(energy_begun(power, values, share, 1.0))
            y = sp.Symbol("y")
            exact = 2 * sp.Integral((2 * (y**3 - y**4 / 2)) ** exponent, (y, 0, share)).evalf(20)
            assert actual == pytest.approx(float(exact), rel=1e-12)
    model = engine_model(smooth_ball(laws.power(K, n=1.5)))
    run = simulate(model, duration="1.5 s", tolerance=1e-11, compiled=False)
    assert len(run.impacts) >= 2
    assert run.energy_residual < 1e-9
    assert run["energy"].max() - run["energy"].min() < 1e-9 * run["energy"].max()
    first, second = run.impacts[:2]
    assert second.speed == pytest.approx(first.speed, rel=1e-9)


def test_units_are_proven_and_the_module_says_smooth():
    assert all(finding.verdict == "consistent" for finding in audit_scene(smooth_ball(*DAMPED)))
    text = generate(smooth_ball(*DAMPED))
    assert "power x power_damping, smooth" in text
    assert "floor_smooth" in text
    assert generate(scene.replace(floor=Contact("floor", *DAMPED, smooth=None))) == generate(
        scene.replace(floor=Contact("floor", *DAMPED))
    )
    assert generate(smooth_ball(*DAMPED, smooth=Parameter("soft", "um", 3))).count("soft") > 1


@pytest.mark.parametrize("smooth", ["1 s", "much", "1", "0 mm", 3, "-1 um"])
def test_bad_lengths_are_refused(smooth):
    with pytest.raises(InputError, match="smooth"):
        smooth_ball(*DAMPED, smooth=smooth)


def test_too_steep_laws_are_refused_and_the_sheet_states_the_deviation():
    dashpot = laws.power_damping(Parameter("c", "N s/m", 100), m=0)
    with pytest.raises(InputError, match=r"begins like d\^0"):
        smooth_ball(laws.power(K, n=1.5), dashpot)
    (_, elastic), (_, damping) = growths(*DAMPED)
    assert (elastic, damping) == pytest.approx((1.5, 1.5))
    (_, of_factor) = [*growths(scene.effects[1].stiffness, laws.hunt_crossley(0.9))][1]
    assert of_factor == pytest.approx(1.5)
    actual = {point.penetration: point.smoothed for point in sheet(LAWS["johnson"]).points}
    law = {point.penetration: point for point in sheet(LAWS["johnson"]).points}
    assert actual[1e-8] < -0.999
    assert actual[1e-4] == pytest.approx(-law[1e-4].exponent * 1e-2, rel=0.02)  # dF/F = -n epsilon/d
    assert sheet(LAWS["power"]).points == ()
