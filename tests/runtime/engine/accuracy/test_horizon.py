"""Growth of errors and the time a trajectory is the true one: on curves of known growth."""

import math

import numpy as np
import pytest
from scipy.stats import linregress

from hertzwerk.runtime.engine.accuracy.error_estimate import VALID
from hertzwerk.runtime.engine.accuracy.horizon import SATURATED, _line, crossing, growth

T = np.linspace(0.0, 6.0, 601)
NO_FLOOR = np.zeros(len(T))


def of(*errors, floor=NO_FLOOR):
    return growth(T, errors, [floor] * len(errors))


@pytest.mark.parametrize("rate", [0.7, 2.0])
def test_an_exponential_has_its_rate_and_ten_times_more_accuracy_buys_ln_10_of_it(rate):
    actual = of(1e-9 * np.exp(rate * T), 3e-8 * np.exp(rate * T))
    assert actual.kind == "exponential"
    assert actual.rate == pytest.approx(rate, rel=5e-3)
    assert actual.gained == pytest.approx(math.log(10) / rate, rel=5e-3)
    assert actual.factors == pytest.approx([math.exp(rate / 2)] * 11, rel=2e-2)  # intervals of half a second
    assert actual.reaches(1e-5) == pytest.approx(6 + math.log(VALID / 1e-5) / rate, rel=5e-3)


def test_an_exponential_under_ripples_and_scatter_keeps_its_rate():
    noise = np.random.default_rng(1)
    curves = [1e-9 * 10**k * np.exp(2 * T + 0.5 * np.sin(30 * T) + 0.3 * noise.normal(size=len(T))) for k in range(3)]
    actual = of(*curves)
    assert actual.kind == "exponential"
    assert abs(actual.rate - 2.0) < 3 * actual.deviation < 0.3


@pytest.mark.parametrize("exponent", [1.0, 2.0])
def test_a_power_of_time_is_distinguished_from_an_exponential(exponent):
    actual = of(1e-7 * T**exponent)
    assert actual.kind == "power"
    assert actual.exponent == pytest.approx(exponent, rel=0.02)
    assert actual.reaches(VALID / 10) == pytest.approx(6 * 10 ** (1 / exponent), rel=0.05)


@pytest.mark.parametrize("curve", [np.exp(-0.8 * T), np.ones(len(T)), 1 + 0.5 * np.sin(20 * T)])
def test_where_errors_shrink_or_stay_nothing_bounds_the_horizon(curve):
    actual = of(1e-6 * curve)
    assert actual.kind == "none"
    assert actual.gained == actual.reaches(1e-3) == math.inf


def test_growth_in_a_few_intervals_that_others_take_back_is_intermittent():
    jumps = np.where(T < 2.75, 0.0, np.where(T < 4.75, 5.0, 10.0)) - 1.2 * T
    actual = of(1e-8 * np.exp(jumps))
    assert actual.intermittent
    assert max(actual.factors) > 10
    assert not of(1e-8 * np.exp(T)).intermittent


def test_neither_saturation_nor_the_floor_is_taken_for_growth():
    actual = of(np.minimum(1e-5 * np.exp(4 * T), 1.0))
    assert actual.rate == pytest.approx(4.0, rel=1e-3)
    assert of(np.full(len(T), 2 * SATURATED)).kind == "unknown"
    floor = np.full(len(T), 1e-10)
    assert of(np.full(len(T), 2e-10), floor=floor).kind == "unknown"
    risen = 1e-13 * np.exp(4 * T)
    assert of(np.maximum(risen, 1e-10), floor=floor).rate == pytest.approx(4.0, rel=1e-3)
    actual = of(np.maximum(1e-6 * np.exp(-4 * T), 1e-11), floor=floor)
    assert actual.kind == "none"
    assert actual.rate < -1


def test_the_limit_is_crossed_between_two_samples_by_the_logarithm():
    coarse = T[::50]
    assert crossing(coarse, 1e-6 * np.exp(3 * coarse)) == pytest.approx(math.log(1e4) / 3, rel=1e-9)
    assert crossing(T, np.full(len(T), VALID)) == math.inf
    assert crossing(T, np.full(len(T), 1.0)) == 0.0
    assert crossing(T, np.where(T > 3.005, np.nan, 1e-9)) == pytest.approx(3.0)


def test_the_error_of_a_rate_is_that_of_a_regression():
    x, y = np.array([0.0, 1.0, 2.0, 3.0, 4.0]), np.array([0.1, 0.9, 2.2, 2.8, 4.1])
    expected = linregress(x, y)
    slope, error, miss = _line(x, y)
    assert (slope, error) == pytest.approx((expected.slope, expected.stderr), rel=1e-12)
    assert miss == pytest.approx((1 - expected.rvalue**2) * np.sum((y - y.mean()) ** 2), rel=1e-9)
