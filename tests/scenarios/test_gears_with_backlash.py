"""Rattling gears beside one length in a dead zone, integrated by SciPy; its onset in closed form from both sides."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from hertzwerk.runtime import load, simulate

J, DRAG, K, CHI, SWING, FIRING, SPEED = 2e-3, 0.8, 1.4e8, 4e8, 1500.0, 240.0, 30 * np.pi
ONE, TWO = np.array([0.03, 0.0465]) * np.cos(np.radians(20))
BACKLASH = 1e-4 * np.cos(np.radians(20))


@pytest.fixture(scope="module")
def model():
    return load("gears_with_backlash")


def dead_zone(t, y):
    """The wheel alone: its flanks as springs with damping at half the backlash to either side of the pinion's."""
    x = ONE * (SPEED * t + SWING / FIRING**2 * (1 - np.cos(FIRING * t))) + TWO * y[0]
    v = ONE * (SPEED + SWING / FIRING * np.sin(FIRING * t)) + TWO * y[1]
    deep = abs(x) - BACKLASH / 2
    force = np.sign(x) * deep * (K + CHI * np.sign(x) * v) if deep > 0 else 0.0
    return [y[1], (DRAG - TWO * force) / J]


def test_it_rattles_as_one_length_in_a_dead_zone_does(model):
    """Both sides, six impacts."""
    start = BACKLASH / 2 / TWO + (DRAG + J * SWING * 20 / 31) / TWO**2 / K
    reference = solve_ivp(
        dead_zone, (0, 0.026), (start, -SPEED * 20 / 31), "DOP853", rtol=1e-11, atol=1e-13, max_step=4e-5
    )
    run = simulate(model, duration="26 ms", accuracy=1e-8)
    assert {impact.contact for impact in run.impacts} == {"mesh_1", "mesh_2"}
    assert run["idler.angle"][-1] == pytest.approx(reference.y[0, -1], abs=1e-9)
    assert run["idler.speed"][-1] == pytest.approx(reference.y[1, -1], abs=1e-5)
    assert run["mesh_1.gap"] + run["mesh_2.gap"] == pytest.approx(BACKLASH, abs=1e-12)


@pytest.mark.parametrize("share", [0.98, 1.02])
def test_it_begins_to_rattle_where_the_drag_cannot_brake_the_wheel(model, share):
    """Acceleration drag/inertia 31/20 of the pinion as it slows down; vibrations of the start have died away by then."""
    swing = share * DRAG / J * 31 / 20
    run = simulate(
        model, duration="30 ms", accuracy=1e-6, parameters={"swing": f"{swing} rad/s^2", "firing": "120 rad/s"}
    )
    assert run.outcome.name == "finished"
    assert (run["mesh_1.gap"].max() > 0) == (share > 1)
