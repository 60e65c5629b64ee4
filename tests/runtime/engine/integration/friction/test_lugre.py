"""LuGre friction in the engine: presliding, the Stribeck curve, sticking, bristles that end with their contact; against SciPy and closed forms."""

import math

import numpy as np
import pytest
from blocks import CARRIAGE, MASS, WEIGHT, block
from jacobians import check_jacobian, start_of
from scipy.integrate import solve_ivp

from hertzwerk.derive import Parameter
from hertzwerk.derive.laws import lugre
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(7)  # methods and sizes that run the same code

MU_K, MU_S, V_S, S_0, S_1 = 0.2, 0.3, 0.05, 1e5, 20.0
METHODS = ("dop853", "dopri5", "rodas", "esdirk", "auto")
IMPLICIT = ("rodas", "esdirk", "auto")


def bristles(name="", s_0=S_0):
    return lugre(
        Parameter("mu_k", "1", MU_K), Parameter("mu_s", "1", MU_S), Parameter("v_S", "m/s", V_S),
        Parameter(f"s_0{name}", "1/m", s_0), Parameter("s_1", "s/m", S_1), Parameter("c_v", "N s/m", 0),
    )  # fmt: skip


@pytest.fixture(scope="module")
def model():
    return engine_model(block(bristles()))


@pytest.fixture(scope="module")
def slid():
    """The block on the level, 0.5 m/s at the start, by SciPy's Radau: travel and speed at some times, before and after it stops at 0.3 s."""

    def rates(_, y):
        _, v, z = y
        bend = v - S_0 * abs(v) * z / (MU_K + (MU_S - MU_K) * math.exp(-((v / V_S) ** 2)))
        return [v, -WEIGHT * (S_0 * z + S_1 * bend) / (MASS + CARRIAGE), bend]

    times = np.array([0.1, 0.28, 0.3, 0.31, 0.32, 0.33, 0.4])
    run = solve_ivp(rates, (0, 0.4), [0, 0.5, 0], "Radau", t_eval=times, rtol=1e-10, atol=1e-14, max_step=1e-3)
    return times, run.y


@pytest.mark.parametrize("method", METHODS)
def test_sliding_to_rest_is_what_scipy_finds(model, slid, method):
    run = simulate(model, duration="0.4 s", tolerance=1e-8, method=method, parameters={"slide": "0.5 m/s"})
    times, (travel, speed, bristle) = slid
    rows = run.at(times)
    assert run.outcome.finished
    assert rows["along_0.travel"] == pytest.approx(travel, rel=1e-6)
    assert rows["along_0.speed"] == pytest.approx(speed, abs=1e-6)
    assert -rows["rub_0.bristle"] == pytest.approx(bristle, abs=1e-5 * MU_S / S_0)  # the tangent is -x
    assert abs(speed[2]) > 1e-3 > abs(speed[-1])  # the comparison covers the stop
    assert run.energy_residual < 1e-7


@pytest.mark.parametrize("method", METHODS)
def test_at_rest_on_a_slope_the_bristle_holds_the_block(model, method):
    """Below the Stribeck speed dz/dx = 1 - s_0 z/mu, so the way to rest is -(mu/s_0) ln(1 - s_0 z/mu): the load gives z, z gives the way."""
    angle = 0.1
    run = simulate(
        model, duration="1 s", method=method, tolerance=1e-9,
        parameters={"slope": angle, "mu_k": MU_S, "s_1": "2000 s/m"},
    )  # fmt: skip
    z = (MASS + CARRIAGE) / MASS * math.tan(angle) / S_0
    assert -run.engine.final["rub_0.bristle"] == pytest.approx(z, rel=1e-5)
    assert run.engine.final["along_0.travel"] == pytest.approx(-(MU_S / S_0) * math.log(1 - S_0 * z / MU_S), rel=1e-3)
    assert abs(run.engine.final["along_0.speed"]) < 1e-8


@pytest.mark.parametrize("method", [*METHODS, "cvodes", "idas"])
def test_bristles_end_with_their_contact(model, method):
    """Dropped while sliding, the block bounces; each contact begins with a bristle at rest."""
    run = simulate(
        model, duration="0.12 s", method=method, tolerance=1e-7,
        parameters={"slide": "0.5 m/s", "height": "10 mm", "restitution": 0.6},
    )  # fmt: skip
    touching, bristle = run["floor_0.mode"] == 1, run["rub_0.bristle"]
    assert len(run.impacts) >= 2
    onsets = np.flatnonzero(touching[1:] & ~touching[:-1]) + 1
    noise = 1e-30 if method == "idas" else 0  # what does not move is not at rest for IDAS, to the last digit
    assert np.max(np.abs(bristle[~touching])) <= noise
    assert np.max(np.abs(bristle[onsets])) <= noise
    assert np.max(np.abs(bristle)) > 0.5 * MU_K / S_0  # and bends in between
    assert run.energy_residual < 3e-6  # 30 local errors; CVODES makes 13


@pytest.mark.parametrize("method", IMPLICIT)
def test_very_stiff_bristles_take_few_implicit_steps(model, method):
    """s_0 = 1e7 1/m: explicit steps would be some millions."""
    run = simulate(
        model, duration="1 s", method=method, parameters={"slide": "1 m/s", "s_0": "1e7 1/m"}, tolerance=1e-6
    )
    assert run.outcome.finished
    assert run.statistics.steps < 2000
    stop = (MASS + CARRIAGE) / (MU_K * WEIGHT)
    assert run.engine.final["along_0.travel"] == pytest.approx(
        stop / 2, rel=2e-3
    )  # the Stribeck peak near rest takes a little off
    assert abs(run.engine.final["along_0.speed"]) < 1e-9
    assert run.energy_residual < 1e-5


def test_jacobian_against_differences(model):
    bound = model.bind()
    q, u = start_of(model, bound)
    y = np.concatenate([q, u + np.array([0, 0.03, -0.01]), [-0.6 * MU_S / S_0, 0, 0]])
    J = check_jacobian(model, y, np.ones(1), np.zeros(0), bound, steps=[1e-7] * 3 + [1e-6] * 3 + [1e-9, 1, 1])
    assert J[6, 6] == pytest.approx(-S_0 * 0.03 / (MU_K + (MU_S - MU_K) * math.exp(-((0.03 / V_S) ** 2))))
