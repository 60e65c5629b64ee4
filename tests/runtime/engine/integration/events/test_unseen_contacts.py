"""First contacts of bodies whose states move along lines while their surfaces come and go: none is stepped over."""

import math
from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.optimize import brentq

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, power
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.integration.loop import plain_attempt

pytestmark = pytest.mark.by_turns(3)  # methods and coordinates that run the same code

REACH = 0.05  # m: of the bar, and of the plate that is driven


def scene(name, joints, pair, start, *effects):
    law = power(hd.Parameter("stiffness", "N/m^1.5", 1e8), n=1.5), flores(hd.Parameter("restitution", "1", 0.8))
    scales = hd.Scales(
        length=hd.Parameter("size", "mm", 1), speed=hd.Parameter("pace", "m/s", 1), arm=hd.Parameter("arm", "mm", 50)
    )
    return hd.Scene(hd.Mechanism(name, joints, (pair,)), (*effects, hd.Contact("floor", *law)), scales, start)


MASS, BALL = hd.Parameter("mass", "kg", 0.1), hd.Parameter("radius", "mm", 1)
HEIGHT, FALL = hd.Parameter("height", "mm", 60), hd.Parameter("fall", "m/s", 0.1)
RATE = hd.Parameter("rate", "rad/s", 100)


@cache
def bar():
    """A bar that spins and drifts towards a floor, free of forces: its states are straight lines."""
    body, reach = hd.Body("bar", MASS, hd.Parameter("inertia", "kg m^2", 1e-4)), hd.Parameter("reach", "m", REACH)
    floor = hd.SphereOnPlane("floor", body.at(reach, 0, 0), BALL, hd.GROUND.at(0, 0, 0), hd.Y)
    start = hd.Start(position={"fly.y": BALL + HEIGHT}, speed={"fly.y": -FALL, "fly.angle": -RATE})
    return load(scene("spinning_bar", (hd.Planar("fly", hd.GROUND, body),), floor, start))


@cache
def plate():
    """A ball that drifts towards a plate that is shaken."""
    ball, floor = hd.Body("ball", mass=MASS), hd.Body("plate", mass=MASS)
    joints = hd.Prismatic("up", hd.GROUND, ball, axis=hd.Y), hd.Prismatic("shake", hd.GROUND, floor, axis=hd.Y)
    pair = hd.SphereOnPlane("floor", ball.at(0, 0, 0), BALL, floor.at(0, 0, 0), hd.Y)
    start = hd.Start(position={"up": BALL + HEIGHT}, speed={"up": -FALL})
    shake = hd.Drive("drive", "shake", position=hd.Parameter("reach", "m", REACH) * sp.sin(RATE * hd.T))
    return load(scene("shaken_plate", joints, pair, start, shake))


def first_contact(height, fall, rate):
    """Time [s] at which height - fall t = REACH sin(rate t)."""

    def gap(t):
        return height - fall * t - REACH * np.sin(rate * t)

    times = np.linspace(0, height / fall, 200_001)
    k = int(np.argmax(gap(times) < 0))
    return brentq(gap, times[k - 1], times[k], xtol=1e-15)


def missed(built, method, number):
    """The number of runs whose first contact is not where it is; random turns until then."""
    random, wrong, model = np.random.default_rng(4), 0, built()
    for _ in range(number):
        rate, height = 10 ** random.uniform(1, 3), random.uniform(1.02, 1.4) * REACH
        fall = (height - REACH) * rate / (2 * math.pi * random.uniform(3, 20))
        t = first_contact(height, fall, rate)
        given = {"height": (height, "m"), "fall": (fall, "m/s"), "rate": (rate, "rad/s")}
        run = simulate(model, duration=1.5 * t, method=method, tolerance=1e-6, parameters=given, compiled=False)
        assert run.outcome.finished
        wrong += not run.impacts or abs(run.impacts[0].t - t) > 1e-4 / rate
    return wrong


@pytest.mark.parametrize("method", ["dop853", "dopri5", "rodas", "esdirk"])
@pytest.mark.parametrize("built", [bar, plate])
def test_no_contact_is_stepped_over(built, method):
    assert missed(built, method, 8) == 0


def test_a_step_that_leaves_the_gap_open_steps_over_contacts(monkeypatch):
    """The fault that this guards against: 51 of 60 such contacts were missed."""
    monkeypatch.setattr(plain_attempt, "unresolved", lambda *_: 0)
    assert missed(bar.__wrapped__, "dop853", 2) > 0
