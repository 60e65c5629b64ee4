"""Rows of touching spheres, whose gaps are as small as their rounding: against an independent integration, and what the rounding of a gap is."""

import math
from functools import cache

import casadi as ca
import mpmath
import numpy as np
import pytest
from balls_in_a_row import row

from hertzwerk.derive.scenes.hard.hard_scenes import row_of_spheres, touching_row
from hertzwerk.runtime import simulate
from hertzwerk.runtime.analysis.hard_cases.cases import many
from hertzwerk.runtime.engine.integration.events import event_location
from hertzwerk.runtime.engine.integration.step.rounding_errors import bounds, gap_rounding
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(4)  # methods and sizes that run the same code

EPS = 2.0**-52


@cache
def model_of(count):
    return engine_model(touching_row(count))


def solve(model, tolerance, duration, *, method="dop853", exponent=1.5, preload=0.0, last_speed=0.0):
    parameters = {
        "exponent": exponent, "stiffness": (1e8, f"N/m^{exponent:g}"), "preload": (preload, "N"), "last_speed": (last_speed, "m/s"),
    }  # fmt: skip
    options = {"tolerance": tolerance, "method": method, "parameters": parameters, "compiled": False}
    return simulate(model, duration=duration, max_steps=100_000, **options)


def speeds(run, count):
    return np.array([run[f"path_{i}.speed"][-1] for i in range(1, count + 1)])


# ---- how well a gap is known -----------------------------------------------------------------------------------------


def test_bounds_hold_and_are_not_far_from_what_happens():
    """A distance less radii, with a turn, at places where it all but vanishes; the truth in 50 digits."""
    q, c = ca.SX.sym("q", 3), ca.SX.sym("c", 2)
    x, y = c[0] * ca.cos(q[0]) + q[1], c[0] * ca.sin(q[0]) + q[2]
    function = ca.Function("distance", [q, c], [ca.sqrt(x**2 + y**2) - c[1]])
    bound = bounds(function, (0,))
    random, parts = np.random.default_rng(11), []
    with mpmath.workdps(50):
        for _ in range(300):
            exact = [mpmath.mpf(random.uniform(-3, 3)) + mpmath.mpf(random.uniform()) / 10**17 for _ in range(3)]
            arm = random.uniform(0.1, 2)
            x = arm * mpmath.cos(exact[0]) + exact[1]
            y = arm * mpmath.sin(exact[0]) + exact[2]
            radii = float(mpmath.hypot(x, y))
            rounded = [float(value) for value in exact]
            error = abs(mpmath.mpf(float(function(rounded, [arm, radii]))) - (mpmath.hypot(x, y) - radii))
            parts.append(float(error / mpmath.mpf(float(bound(rounded, [arm, radii])))))
    assert max(parts) < 1
    assert max(parts) > 0.1


def test_a_gap_is_rounded_with_the_lengths_it_is_a_difference_of():
    """The tenth pair is 0.4 m from the origin, whatever the coordinates are; moved off by 1 m by them, as much further."""
    model = model_of(10)
    bound, q = model.bind(), np.zeros(10)
    (at_zero, _), (moved, _) = (gap_rounding(model)(0.0, place, np.zeros(10), bound.c) for place in (q, q + 1))
    last, first = float(at_zero[-1]), float(at_zero[0])
    assert 0.36 * EPS < last < 6 * 0.36 * EPS
    assert first < last / 4
    assert float(moved[-1]) > last + EPS


@pytest.mark.parametrize("tolerance", [1e-12, 1e-13])
@pytest.mark.parametrize("method", ["dop853", "dopri5"])
def test_without_the_rounding_of_gaps_rows_end_nowhere(monkeypatch, method, tolerance):
    """The fault that this guards against: a landing that asks for less than the last digit of a gap is tried to the last digit of the time."""
    monkeypatch.setattr(
        event_location, "gap_rounding", lambda model: lambda *_: (ca.DM.zeros(model.k), ca.DM.zeros(model.k))
    )
    blind = engine_model(touching_row(5))
    assert solve(blind, tolerance, 0.004, method=method).statistics.retaken > 100
    monkeypatch.undo()
    run = solve(model_of(5), tolerance, 0.004, method=method)
    assert run.outcome.finished and run.statistics.retaken == 0


# ---- rows ------------------------------------------------------------------------------------------------------------

CASES = {
    "struck": ((0.004, many.STRUCK[1.5]), {}), "linear": ((0.002, many.STRUCK[1.0]), {"exponent": 1.0}),
    "cubic": ((0.1, many.STRUCK[3.0]), {"exponent": 3.0}), "pressed": ((0.004, many.PRESSED), {"preload": 100.0}),
    "two waves": ((0.004, many.WAVES), {"last_speed": -1.0}),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_digits_of_the_hard_cases(name):
    (duration, expected), options = CASES[name]
    _, actual = row(5, duration, **options)
    assert np.max(np.abs(actual - np.array(expected))) < 1e-13


@pytest.mark.parametrize("tolerance", [1e-9, 1e-11, 1e-13])
@pytest.mark.parametrize("count", [2, 4, 10])
def test_rows_of_any_length(count, tolerance):
    _, expected = reference(count)
    run = solve(model_of(count), tolerance, 0.004)
    statistics = run.statistics
    assert run.outcome.finished
    assert np.max(np.abs(speeds(run, count) - expected)) < 30 * tolerance + 1e-11
    assert statistics.rejected + statistics.retaken < statistics.steps / 2
    assert run.energy_residual < 10 * tolerance


@cache
def reference(count):
    return row(count, 0.004)


def test_an_accuracy_is_reached_and_coordinates_may_begin_at_the_spheres_or_at_one_origin():
    run = simulate(model_of(5), duration=0.004, accuracy=1e-9, compiled=False)
    assert run.outcome.finished
    assert np.max(np.abs(speeds(run, 5) - np.array(many.STRUCK[1.5]))) < 1e-9
    # Gaps between coordinates of their own size, as the other rows of the hard cases have them.
    run = simulate(
        engine_model(row_of_spheres(4)), duration=0.004, tolerance=1e-12, parameters={"gap": "0 m"}, compiled=False
    )
    assert run.outcome.finished
    assert math.isclose(run["path_4.speed"][-1], float(reference(4)[1][-1]), abs_tol=1e-10)
