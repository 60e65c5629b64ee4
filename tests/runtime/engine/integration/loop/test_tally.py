"""The tally of a run, kept in the loop, against its histories: energy balance, and how fast contacts begin."""

import math
from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.runtime import load
from hertzwerk.runtime.engine.integration.loop.tally import tally
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.model.caller import Callers
from hertzwerk.runtime.engine.run.run_request import Settings, read
from hertzwerk.runtime.engine.run.single_run import set_up

SETTINGS = Settings("12 ms", None, 1e-6, compiled=False)
RELEASED_AND_BACK = [0, 1, 2, 1, 0, 2, 1]  # modes of a pair: two contacts, at the second state and at the last


@pytest.fixture(scope="module")
def model():
    return load("slider_crank")


@pytest.fixture(scope="module")
def traced(model):
    run = set_up(model, SETTINGS, read(model, SETTINGS, {}, {})[0])
    return run.trace(1e-6, run.scales(1e-6), None)


def test_the_balance_is_that_of_the_kept_steps(traced):
    run = traced.kept.history
    kinetic, potential = (part - part[0] for part in run.energies)
    lost, given = (
        sum(run[name] for name in run.model.memory if name.endswith(end)) for end in (".dissipated", ".input")
    )
    balance = traced.balance
    assert balance.error == pytest.approx(np.max(np.abs(kinetic + potential + lost - given)), rel=1e-6)
    assert balance.moved == max(run.energies[0].max(), *(np.abs(part).max() for part in (potential, lost, given)))
    assert balance.size == max(np.abs(part).max() for part in (*run.energies, lost, given))
    assert balance.states == len(run.t)
    assert replace(balance, size=math.inf).residual is None


def test_contacts_begun_are_the_impacts(model, traced):
    impacts = traced.findings.impacts
    (limit,) = read(model, SETTINGS, {}, {})[0].speed_limits
    speeds = [impact.speed for impact in impacts]
    found = {name: traced.tally[name].tolist() for name in ("begun", "over", "fastest")}
    assert found == {"begun": [len(speeds)], "over": [sum(speed > limit for speed in speeds)], "fastest": [max(speeds)]}
    assert found["over"][0] > 0
    assert len(speeds) > 5


def followed(model, parts):
    """Tally after states of which these parts (n,) are given, each counted twice as an attempt in vain would be."""
    vectors, counting = layouts(model), tally(model)
    add, controls, tallied = Callers(counting.add), np.zeros(vectors.controls.size), None
    for values in zip(*parts.values(), strict=True):
        state = np.zeros(vectors.state.size)
        for name, value in zip(parts, values, strict=True):
            state[vectors.state[name]] = value
        if tallied is None:
            (tallied,) = counting.first(state, controls)
        for _ in range(2):
            (tallied,) = add(tallied, state, controls)
    return {name: part.tolist() for name, part in counting.layout.split(tallied).items()}


def test_a_contact_that_is_released_and_touches_again_begins_once(model):
    found = followed(model, {"mode": RELEASED_AND_BACK, "gap_rate": -np.arange(7.0)})
    assert (found["begun"], found["fastest"]) == ([2.0], [6.0])


def test_energies_are_measured_from_the_first_state_and_one_that_is_not_finite_is_remembered(model):
    found = followed(model, {"kinetic": [5.0, 7.0, 6.0], "potential": [-3.0, -4.0, -4.0]})
    assert (found["start"][:2], found["moved"], found["error"], found["size"]) == ([5.0, -3.0], [7.0], [1.0], [7.0])
    assert followed(model, {"kinetic": [5.0, math.inf, 5.0]})["size"] == [math.inf]
    assert followed(model, {"potential": [5.0, math.nan, 5.0]})["size"] == [math.inf]


def test_a_model_without_ledger_or_limit_has_nothing_to_count():
    ball = load("bouncing_ball", without=("energy_ledger",))
    assert tally(ball).layout.size == 0
    assert {"kinetic", "potential"}.isdisjoint(name for name, size in layouts(ball).state.sizes.items() if size)
