"""Derivatives through set-valued friction in two directions: slip, its end in the plane, and its onset, against closed forms."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from balls import GRAVITY, MASS, RADIUS, ball, dry
from tops import curling

from hertzwerk.derive import Parameter, PointForce, T
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.sensitivity import saltation
from hertzwerk.runtime.engine.sensitivity.output_derivatives import NoDerivativeError, OutputDerivatives
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(4)  # methods that run the same code

MU = 0.2
METHODS = ("dop853", "dopri5", "rodas", "esdirk")
SHOT = {"v_x": 2.0, "w_x": 40.0}
CLOSE = 2e-6  # of the largest derivative
PLACES = ("flight.x", "flight.z", "flight.x_speed", "flight.z_speed")


@cache
def billiard():
    return engine_model(ball(dry(MU)))


def after(mu, v, w, t=0.5):
    """Place and velocity of a ball that slid on a parabola and rolls; see test_coulomb_in_space."""
    slip = np.array([v + 5 * RADIUS, -w * RADIUS])
    size = np.linalg.norm(slip)
    end, pull = 2 * size / (7 * mu * GRAVITY), -mu * GRAVITY * slip / size
    return np.concatenate([np.array([v * t, 0]) + pull * end * (t - end / 2), np.array([v, 0]) + pull * end])


def slope(function, at, k, step=1e-6):
    """Central difference of a closed form in its k-th argument."""
    there, back = ([x * (1 + sign * step * (i == k)) for i, x in enumerate(at)] for sign in (1, -1))
    return (function(*there) - function(*back)) / (2 * step * at[k])


@cache
def shot(method):
    given = {"v_x": (2.0, "m/s"), "w_x": (40.0, "rad/s"), "w_y": (30.0, "rad/s"), "w_z": (5.0, "rad/s")}
    return simulate(billiard(), duration="0.5 s", method=method, tolerance=1e-9, parameters=given, compiled=False)


@pytest.mark.parametrize("method", METHODS)
def test_a_ball_that_slid_rolls_as_its_shot_and_friction_say(method):
    derivatives = shot(method).sensitivities("mu_k", "v_x", "w_x")
    assert derivatives.reason == ""
    for k, name in enumerate(("mu_k", "v_x", "w_x")):
        expected = slope(after, (MU, SHOT["v_x"], SHOT["w_x"]), k)
        values = np.array([derivatives[place, name][-1] for place in PLACES])
        assert values == pytest.approx(expected, abs=CLOSE * np.max(np.abs(expected)))


def test_the_instant_of_a_stop_has_no_derivative_and_says_so():
    """Its direction is rounding: the numbers were off by 5 % at a tolerance of 1e-11. What does not jump there has one."""
    run = shot("dop853")
    derivatives = run.sensitivities("mu_k", "v_x")
    assert np.isnan(derivatives.events[1]).all() and len(derivatives.events[0]) == 1
    outputs = OutputDerivatives(run, derivatives)
    with pytest.raises(NoDerivativeError, match="sliding in two directions ends"):
        outputs["floor.friction_force.mean"]

    def mean(mu, v, T=0.5):
        slip = np.array([v + 5 * RADIUS, -SHOT["w_x"] * RADIUS])
        size = np.linalg.norm(slip)
        end, pull = 2 * size / (7 * mu * GRAVITY), -mu * GRAVITY * slip[0] / size
        rolled = end * ((T**2 - end**2) / 2 - end * (T - end) / 2)
        return (v * T**2 / 2 + pull * (end**3 / 6 + rolled)) / T

    expected = [slope(mean, (MU, SHOT["v_x"]), k) for k in range(2)]
    assert outputs["flight.x.mean"] == pytest.approx(expected, rel=1e-5)


def test_a_stop_along_the_slip_alone_would_leave_the_ball_sliding_across(monkeypatch):
    """The fault that this guards against: across the slip the change of the speed has no limit of its own before rest."""
    monkeypatch.setattr(saltation, "_stopping", lambda _, index: np.zeros(len(index), dtype=bool))
    expected = slope(after, (MU, SHOT["v_x"], SHOT["w_x"]), 0)
    derivatives = shot("dop853").sensitivities("mu_k")
    values = np.array([derivatives[place, "mu_k"][-1] for place in PLACES])
    assert np.max(np.abs(values - expected)) > 10 * CLOSE * np.max(np.abs(expected))


# ---- onset -----------------------------------------------------------------------------------------------------------


@cache
def pulled():
    """A particle at rest, pulled aslant ever more: it slides where the pull exceeds what friction holds."""
    found, rate = ball(dry(MU, 0.3), turns=False), Parameter("rate", "N/s", 2)
    (body,) = (body for body in found.mechanism.bodies if body.name == "ball")
    ahead = Parameter("ahead", "1", 0.8), Parameter("aside", "1", 0.6)
    pull = PointForce("pull", body.at(0, 0, 0), (rate * ahead[0] * T, 0, rate * ahead[1] * T))
    return engine_model(replace(found, effects=(*found.effects, pull)))


def dragged(mu_k, mu_s, rate, ahead, aside, t=0.5):
    """Place and velocity: m v' = rate t - mu_k m g from the time of mu_s m g on, along the pull."""
    size = math.hypot(ahead, aside)
    onset = mu_s * MASS * GRAVITY / (rate * size)
    left, k = t - onset, rate * size / MASS
    speed = k * (t**2 - onset**2) / 2 - mu_k * GRAVITY * left
    way = k * (t**3 / 6 - onset**3 / 6 - onset**2 * left / 2) - mu_k * GRAVITY * left**2 / 2
    return np.array([way * ahead, way * aside, speed * ahead, speed * aside]) / size


@pytest.mark.parametrize("method", METHODS)
def test_onset_of_slip_follows_pull_and_friction(method):
    names = ("mu_k", "mu_s", "rate", "ahead", "aside")
    run = simulate(pulled(), duration="0.5 s", method=method, tolerance=1e-9, compiled=False)
    derivatives = run.sensitivities(*names)
    assert derivatives.reason == ""
    at = (MU, 0.3, 2.0, 0.8, 0.6)
    for k, name in enumerate(names):
        expected = slope(dragged, at, k)
        values = np.array([derivatives[place, name][-1] for place in ("x.travel", "z.travel", "x.speed", "z.speed")])
        assert values == pytest.approx(expected, abs=5e-5 * np.max(np.abs(expected)))


# ---- several feet ----------------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_a_disc_on_three_feet_comes_to_rest_as_differences_say():
    """Through one foot that sticks while the others turn about it."""
    model, names = engine_model(curling(dry(MU), 3)), ("slide", "mu_k")
    places = ("floor.x", "floor.y", "floor.angle")

    def rests(**changed):
        units = {"slide": "m/s", "spin": "rad/s", "mu_k": "1", "mu_s": "1"}
        given = {name: (value, units[name]) for name, value in changed.items()}
        return simulate(model, duration="0.6 s", method="dop853", tolerance=1e-10, parameters=given, compiled=False)

    at = {"slide": 1.0, "spin": 7.0, "mu_k": MU}
    run = rests(**at)
    derivatives = run.sensitivities(*names)
    assert derivatives.reason == ""
    for name in names:
        step = 1e-4 * at[name]
        there, back = (rests(**{**at, name: at[name] + sign * step}) for sign in (1, -1))
        for place in places:
            expected = (there.engine.final[place] - back.engine.final[place]) / (2 * step)
            size = max(np.max(np.abs(derivatives[place, name])), 1e-12)
            assert derivatives[place, name][-1] == pytest.approx(expected, abs=1e-6 * size)
