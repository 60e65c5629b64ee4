"""The ball bearing against the kinematics of rolling, and against its statics at every angle of the cage."""

import numpy as np
import pytest
from scipy.optimize import fsolve

from hertzwerk.derive.scenes.ball_bearing import bearing
from hertzwerk.runtime import load, simulate

N, D, SMALL = 6, 39.04, 7.94
PASSING = N / 2 * 50 * (1 - SMALL / D)  # Hz, of balls at a place of the outer ring


@pytest.fixture(scope="module")
def passes():
    """Three whole passes of balls, at 600 times."""
    run = simulate(load("ball_bearing"), duration="40 ms", tolerance=1e-5, compiled=False)
    return run.at(0.04 - 3 / PASSING * (1 - np.arange(600) / 600))


def strange(values):
    """Share of a variation over three periods that is no harmonic of one."""
    power = np.abs(np.fft.rfft(values - np.mean(values))) ** 2
    return 1 - power[3::3].sum() / power.sum()


def resting(angles, load=500.0, stiffness=1e10, clearance=10e-6, n=N):
    """Places of the ring, in m, where balls at these angles of the cage bear the load: two contacts in a row to a ball."""

    def forces(place, angle):
        out = angle + 2 * np.pi / n * np.arange(n)
        towards = np.array([np.cos(out), np.sin(out)])
        return towards @ (stiffness * (np.maximum(towards.T @ place - clearance, 0) / 2) ** 1.5) + [0, load]

    return np.array([fsolve(forces, (0, -34e-6), args=(angle,)) for angle in angles]).T


def test_the_ring_moves_at_the_frequency_of_balls_that_pass_the_load(passes):
    """n f/2 (1 - d/D), and nothing beside its harmonics; n f/2 (1 + d/D), of a place of the inner ring, is not seen."""
    times, wrong = passes["t"], N / 2 * 50 * (1 + SMALL / D)
    for name in ("shaft.x", "shaft.y"):
        assert strange(passes[name]) < 0.01
        other = np.interp(times[-1] - 3 / wrong * (1 - np.arange(600) / 600), times, passes[name])
        assert strange(other) > 0.1


def test_the_ring_is_where_the_balls_bear_the_load(passes):
    """Height to 0.06 um of 34 um, across, where what contacts lose shows, to 0.4 um of 5 um; a load off by a hundredth is seen."""
    seen = np.array([passes["shaft.x"], passes["shaft.y"]])[:, ::10]

    def off(**given):
        return np.sqrt(np.mean((seen - resting(passes["cage_turn.angle"][::10], **given)) ** 2, axis=1))

    assert np.ptp(seen[0]) > 4.5e-6
    np.testing.assert_array_less(off(), [0.4e-6, 0.06e-6])
    assert off(load=505.0)[1] > 0.1e-6
    assert off(clearance=10.2e-6)[1] > 0.1e-6


@pytest.mark.exhaustive
def test_twenty_four_balls_roll_and_bear_the_load():
    """Two turns of the ring: the cage as fast as rolling has it, less what friction creeps; the ring where statics puts it."""
    n, small = 24, 4.5
    model = load(bearing(n, "bearing_24"))
    run = simulate(model, duration="40 ms", tolerance=1e-6, parameters={"ball_diameter": f"{small} mm"})
    assert run.outcome.finished, run
    assert run["cage_turn.angle"][-1] == pytest.approx(np.pi * 2 * (1 - small / D), rel=3e-3)
    late = run.at(np.linspace(0.03, 0.04, 60))
    seen = np.array([late["shaft.x"], late["shaft.y"]])
    off = np.sqrt(np.mean((seen - resting(late["cage_turn.angle"], n=n)) ** 2, axis=1))
    np.testing.assert_array_less(off, [0.4e-6, 0.06e-6])
    assert run.energy_residual < 1e-8
