"""Optimal control from the handbook: its optimum against closed forms, and tried with the exact law."""

import re
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[4]


@pytest.fixture(scope="module")
def thrown():
    """Names of the example of the handbook, which is run."""
    text = (ROOT / "runtime" / "handbook" / "explanation" / "optimal-control.md").read_text(encoding="utf-8")
    (block,) = [
        block for block in re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL) if "ca.Opti" in block
    ]
    names = {}
    exec(block, names)
    return names


@pytest.mark.slow
def test_the_exact_law_brings_the_ball_back(thrown):
    run = thrown["run"]
    (hit,) = run.impacts
    assert run.outcome.finished
    assert run.engine.final["ball_guide.travel"] == pytest.approx(0.43, abs=1e-3)
    assert run.engine.final["ball_guide.speed"] == pytest.approx(0, abs=5e-3)
    assert run.engine.final["hand.travel"] == pytest.approx(0, abs=1e-3)
    # the ball is to rise as fast as it fell: the hit turns its momentum, and what damping takes the paddle brings
    free = run.t[run["strike.mode"] == 0]
    for side in (free < hit.t, free > hit.t + hit.duration):
        t = free[side]
        height, speed = run.at(t[:1])["ball_guide.travel"][0], run.at(t[:1])["ball_guide.speed"][0]
        np.testing.assert_allclose(
            run.at(t)["ball_guide.travel"], height + speed * (t - t[0]) - 9.81 * (t - t[0]) ** 2 / 2, atol=1e-8
        )


@pytest.mark.slow
def test_the_least_force_is_a_straight_line_of_time_in_flight(thrown):
    """Pontryagin: the costate of a free mass is linear, and the force that minimises its square is its multiple."""
    best, h, (hit,) = thrown["best"], thrown["h"], thrown["run"].impacts
    before, after = int(hit.t / h) - 1, int((hit.t + hit.duration) / h) + 2
    for part in (best[:before], best[after:]):
        assert np.abs(np.diff(part, 2)).max() < 1e-9 * np.abs(part).max()
    assert np.ptp(np.diff(best)) > 0.1  # the hit bends it
