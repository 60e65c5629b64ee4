"""The derived block on an incline against the textbook: it brakes evenly, then creeps at the speed at which smoothed friction holds it."""

import pytest
from benchmarks.stiff_scenes import BRAKING, CREEP, START, incline

from hertzwerk.runtime import simulate


@pytest.mark.parametrize("method", ["esdirk", "rodas", "auto"])
def test_the_block_slides_brakes_and_creeps(method):
    stop, duration = START / BRAKING, 2.0
    run = simulate(incline(), duration=duration, tolerance=1e-7, method=method)
    sliding = run.at([stop / 2])
    assert sliding["along.speed"][0] == pytest.approx(START - BRAKING * stop / 2, rel=1e-6)
    assert run.engine.final["along.speed"] == pytest.approx(CREEP, rel=1e-6)
    assert run.engine.final["along.travel"] == pytest.approx(
        START**2 / (2 * BRAKING) + CREEP * (duration - stop), rel=1e-6
    )
