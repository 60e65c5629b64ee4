"""Random slider-cranks over wide ranges: each ends well, or says what does; none stalls, none loses its energy."""

from collections import Counter

import numpy as np
import pytest
from random_cranks import WALL_TIME, Crank, cranks, model

from hertzwerk.runtime import Solution, simulate

SAMPLE = 5  # of those the normal tests run, one of each method
STUCK = ("step_too_small", "too_many_steps", "event_limit", "not_finite", "constraint_lost", "outside_law_range")


def run_of(crank: Crank, **limits: float) -> Solution:
    made = model(crank.damping, crank.friction)
    return simulate(made, duration="24 ms", method=crank.method, parameters=crank.parameters, **crank.asked, **limits)


def check(run: Solution) -> None:
    """What holds of every run, however it ended: all is finite, and the ledger closes."""
    assert np.all(np.isfinite(run.history.part("y")))
    assert run.energy_residual is None or run.energy_residual < 1e-4


@pytest.mark.parametrize("crank", list(cranks(SAMPLE)), ids=lambda crank: f"{crank.method}-{crank.friction}")
def test_a_random_crank_ends(crank):
    run = run_of(crank, compiled=False, max_steps=100_000)
    assert run.outcome.finished or run.outcome.name == "accuracy_unreachable", (crank, run.outcome)
    check(run)


@pytest.mark.exhaustive
def test_of_620_random_cranks_few_do_not_end():
    """Fewer than one in a hundred ends for its steps; of the time on the clock a loaded machine says nothing, so it is printed."""
    ended = Counter()
    for crank in cranks():
        run = run_of(crank, wall_time=WALL_TIME)
        check(run)
        ended[run.outcome.name] += 1
    print(dict(ended))
    assert sum(ended[name] for name in STUCK) < 0.01 * sum(ended.values()), ended
    assert ended["wall_time_limit"] < 0.05 * sum(ended.values()), ended
