"""The woodpecker toy: stick, slip and impact in turn, which stability forbids explicit steps; and what is advised where a method does not suit."""

import numpy as np
import pytest

from hertzwerk.runtime import load, simulate
from reference.woodpecker import fallen


@pytest.fixture(scope="module")
def toy():
    return load("woodpecker")


def test_it_pecks_on_a_limit_cycle(toy):
    """Pecks follow each other in the same time and at the same depth; from a state of the cycle an independent integration comes back to it."""
    run = simulate(toy, duration="1.3 s", tolerance=1e-8, compiled=False)
    pecks = np.array([impact.t for impact in run.impacts if impact.contact == "beak"])
    *_, before, period = np.diff(pecks)
    assert period == pytest.approx(before, rel=2e-5)
    states = run.at(pecks[-2:] - 5e-3)
    ways = [states[name] for name in ("fall.travel", "tilt.angle", "spring_hinge.angle")]
    rates = [states[name] for name in ("fall.speed", "tilt.speed", "spring_hinge.speed")]
    y, tilt, bend = np.array([*ways[:2], ways[1] + ways[2]]), *rates[1:]
    here, there = np.vstack([y, rates[0], tilt, tilt + bend]).T
    later, hits = fallen(here, period, 1e-7)
    assert later == pytest.approx(there, rel=1e-4, abs=1e-4)
    assert later[0] - here[0] == pytest.approx(there[0] - here[0], rel=1e-5)  # 20 mm a peck
    assert len(hits) == 1
    assert hits[0] == pytest.approx(
        (5e-3, run.impacts[-1].speed if run.impacts[-1].contact == "beak" else 0.27643), rel=1e-4
    )


def test_the_default_method_runs_the_woodpecker(toy):
    """It comes down as by another method, though sticking and slipping all the way; dop853 takes 200,000 steps to half of it."""
    run = simulate(toy, duration="0.5 s", tolerance=1e-6, max_steps=20_000, compiled=False)
    assert run.outcome.finished
    assert run.settings.method == "auto"
    assert {choice.method for choice in run.engine.choices} == {"explicit", "implicit"}
    assert run.energy_residual < 1e-5
    other = simulate(toy, duration="0.5 s", tolerance=1e-8, method="rodas", compiled=False)
    assert run.engine.final["fall.travel"] == pytest.approx(other.engine.final["fall.travel"], rel=1e-3)


@pytest.mark.parametrize("method", ["dop853", "dopri5"])
def test_a_suitable_method_is_recommended_in_place_of_an_explicit_one(toy, method):
    run = simulate(toy, duration="0.5 s", tolerance=1e-6, method=method, max_steps=5_000)
    assert run.outcome.name == "too_many_steps"
    assert f"stability, not accuracy, limits the steps of {method}" in run.outcome.remedy
    assert 'method="auto"' in run.outcome.remedy


def test_an_implicit_method_where_nothing_is_stiff_gets_that_remark():
    model, options = load("double_pendulum"), {"duration": "1 s", "tolerance": 1e-11, "max_steps": 300}
    run = simulate(model, method="esdirk", **options)
    assert run.outcome.name == "too_many_steps"
    assert "nothing is stiff" in run.outcome.remedy
    assert simulate(model, **options).outcome.finished  # as it was told to


def test_another_method_is_recommended_where_one_rounds_too_often():
    model, options = load("double_pendulum"), {"duration": "8 s", "accuracy": 1e-12}
    for method in ("dopri5", "esdirk"):
        run = simulate(model, method=method, **options)
        assert run.outcome.name == "accuracy_unreachable"
        assert f"no tolerance of {method}" in run.outcome.message
        assert 'method="auto"' in run.outcome.remedy
    assert simulate(model, **options).outcome.finished


def test_where_the_method_is_not_the_cause_none_is_named():
    run = simulate(load("slider_crank"), duration="1 s", tolerance=1e-6, method="dop853", max_steps=500)
    assert run.outcome.name == "too_many_steps"
    assert "method" not in run.outcome.remedy
