"""Set-valued friction in space over several contacts, and of a spinning top: coupled stops, an invariant, a limit."""

import math
from functools import cache

import numpy as np
import pytest
from balls import dry
from scipy.integrate import solve_ivp
from tops import BALL, DISC, GRAVITY, OFFSET, RING, TOP, curling, tippe_top

from hertzwerk.derive import Parameter
from hertzwerk.derive.laws import smooth_coulomb
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.integration.events import slip_directions, stick_and_slip

pytestmark = pytest.mark.by_turns(7)  # methods that run the same code

METHODS = ("dop853", "dopri5", "rodas", "esdirk", "auto")
MU = 0.2


@cache
def built(scene, *given):
    """The model of a scene, derived once."""
    return load(scene(*given))


# ---- a disc on three feet --------------------------------------------------------------------------------------------


def decelerated(_, state):
    """Rates of the places along Z and X and of the angle of a disc whose three feet all slide, and of their speeds."""
    *_, angle, v, across, w = state
    force, torque = np.zeros(2), 0.0
    for i in range(3):
        at = math.pi / 2 - 2 * math.pi * i / 3 + angle
        arm = RING * np.array([math.cos(at), math.sin(at)])
        slip = np.array([v - w * arm[1], across + w * arm[0]])
        pull = -MU * DISC * GRAVITY / 3 * slip / np.linalg.norm(slip)
        force, torque = force + pull, torque + arm[0] * pull[1] - arm[1] * pull[0]
    return [v, across, w, *force / DISC, torque / (DISC * RING**2 / 2)]


@pytest.mark.parametrize("method", METHODS)
def test_a_disc_on_three_feet_stops_sliding_and_spinning_at_once(method):
    """In the end one foot sticks, and the disc turns about it: 3/2 m R^2 against 2 mu (m g/3) sqrt(3) R."""
    run = simulate(built(curling, dry(MU), 3), duration="1 s", method=method, tolerance=1e-8)
    slip = np.array([run[f"foot_{i}.slip"] for i in range(3)])
    speed, spin = np.hypot(run["floor.x_speed"], run["floor.y_speed"]), np.abs(run["floor.angle_speed"])
    slides, rests = np.flatnonzero(slip.sum(axis=0) == 3), np.flatnonzero(slip.sum(axis=0) == 0)
    turns = np.flatnonzero(slip.sum(axis=0) == 2)
    assert np.array_equal(np.concatenate([slides, turns, rests]), np.arange(len(run.t)))
    assert run.energy_residual < 1e-8
    # all sliding: as integrated from equations of its own
    early = run.at(np.array([0.55]))
    known = solve_ivp(decelerated, (0, 0.55), [0, 0, 0, 1, 0, 10], method="DOP853", rtol=1e-10, atol=1e-11)
    assert np.hypot(early["floor.x_speed"], early["floor.y_speed"])[0] == pytest.approx(
        math.hypot(*known.y[3:5, -1]), abs=2e-7
    )
    assert abs(early["floor.angle_speed"][0]) * RING == pytest.approx(known.y[5, -1] * RING, abs=2e-7)
    # turning about a foot: the centre's speed is that of the rim, and both end together
    moving = turns[spin[turns] > 1e-3]
    assert speed[moving] == pytest.approx(spin[moving] * RING, rel=1e-6)
    rate = 4 * math.sqrt(3) / 9 * MU * GRAVITY / RING
    assert run.t[rests[0]] - run.t[turns[0]] == pytest.approx(spin[turns[0]] / rate, rel=1e-4)
    assert np.max(speed[rests]) + np.max(spin[rests]) < 1e-14
    booked = sum(run.engine.final[f"rub_{i}.dissipated"] for i in range(3))
    assert booked == pytest.approx(DISC / 2 + DISC * RING**2 / 4 * 100, rel=1e-7)


def test_an_unsettled_start_is_reported(monkeypatch):
    """The same disc, but for iterations that end too early."""
    monkeypatch.setattr(slip_directions, "ITERATIONS", 2)
    monkeypatch.setattr(stick_and_slip, "settling", slip_directions.settling.__wrapped__)
    options = {"duration": "1 s", "method": "dop853", "tolerance": 1e-8, "compiled": False}
    short = simulate(load(curling(dry(MU), 3)), max_steps=2000, **options)
    monkeypatch.undo()
    assert sum("sticking and slipping contacts did not converge" in warning for warning in short.warnings) == 1
    assert not simulate(built(curling, dry(MU), 3), **options).warnings


# ---- a top -----------------------------------------------------------------------------------------------------------


def jellett(run):
    """Angular momentum along the line from the mass centre to the point of contact, times its length [kg m^3/s]."""
    q0, q1, q2, q3 = (run[f"flight.q{i}"] for i in range(4))
    axis = np.array([2 * (q1 * q2 - q0 * q3), 1 - 2 * (q1**2 + q3**2), 2 * (q2 * q3 + q0 * q1)])
    moments = 0.4 * TOP * BALL**2 * np.array([131 / 132, 1, 131 / 132])
    spins = np.array([run[f"flight.angular_speed_{x}"] for x in "xyz"])
    axial = moments[1] * spins[1]
    # L = R J w; its part along the vertical by the second row of R
    vertical = np.array([2 * (q1 * q2 + q0 * q3), axis[1], 2 * (q2 * q3 - q0 * q1)])
    return BALL * np.sum(vertical * moments[:, None] * spins, axis=0) - OFFSET * axial


@pytest.mark.parametrize("method", METHODS)
def test_a_tippe_top_keeps_jelletts_invariant(method):
    """Whatever acts at the point of contact, sliding or rolling; Jellett, A treatise on the theory of friction (1872)."""
    run = simulate(built(tippe_top, dry(0.3)), duration="0.3 s", method=method, tolerance=1e-8)
    assert {0.0, 1.0} == set(run["floor.slip"])
    assert np.ptp(jellett(run)) < 1e-7 * np.abs(jellett(run)[0])
    assert run.energy_residual < 1e-8


def test_a_tippe_top_is_the_limit_of_smooth_friction():
    """While it slides the smooth law differs by v_s alone; the set-valued one is where the differences go to 0."""
    options = {"duration": "40 ms", "tolerance": 1e-8}
    limit = simulate(built(tippe_top, dry(0.3)), method="dop853", **options)
    smooth = built(tippe_top, smooth_coulomb(Parameter("mu", "1", 0.3), Parameter("v_s", "m/s", 1e-3)))
    names = ("flight.x", "flight.z", "flight.q1", "flight.q3")
    errors = []
    for layer in (4e-3, 1e-3, 2.5e-4):
        run = simulate(smooth, parameters={"v_s": (layer, "m/s")}, **options)
        errors.append(max(abs(run.engine.final[name] - limit.engine.final[name]) for name in names))
    assert errors[0] > 3.5 * errors[1] > 3.5**2 * errors[2] > 0  # in proportion to v_s
    assert errors[2] < 3e-5
