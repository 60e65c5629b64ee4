"""Errors against independent references: with tolerance, with the number of steps, with the step itself; energy; and the same as C.

Oracles: quadruple-precision digits and hand-derived equations of tests/reference/slider_crank.py, conservation of energy.
"""

import copy
from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.tableaux import methods
from hertzwerk.runtime.loading import engine_model
from reference.slider_crank import SliderCrank, reference

pytestmark = pytest.mark.by_turns(3)  # methods and sizes that run the same code

ORDERS = {"dopri5": 5, "dop853": 8}
CRANKS = {"slider_crank_frictionless": False, "slider_crank": True}  # friction
MECHANISM = SliderCrank()
TOLERANCES = tuple(10.0**-k for k in range(6, 13))
NEAR, FAR = (0.001, 0.002, 0.003, 0.004), 0.010  # s; errors grow about a hundredfold from 4 to 10 ms


@cache
def model(scene):
    return engine_model(scene)


def states(history):
    """theta (absolute), x and their rates, shape (4, rows): the coordinates of the references."""
    angle, turning = MECHANISM.w * history.t, MECHANISM.w
    return np.array(
        [
            history["crank_pin.angle"] + angle, history["guide.travel"], history["crank_pin.speed"] + turning, history["guide.speed"],
        ]
    )  # fmt: skip


def measure(crank, method, friction, tolerances=TOLERANCES):
    """Errors and steps taken by the times NEAR and FAR, shape (tolerances, times)."""
    truth, times = reference(friction), (*NEAR, FAR)
    errors, steps = [], []
    for tolerance in tolerances:
        run = simulate(crank, duration=FAR, tolerance=tolerance, method=method)
        errors.append([truth.error(t, state) for t, state in zip(times, states(run.at(times)).T, strict=True)])
        steps.append(np.searchsorted(run.t, times))
    return np.array(errors), np.array(steps)


def slope(x, y):
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])


def check_convergence(errors, steps, order):
    """Error proportional to tolerance, and falling with the number of steps at least as the order says, down to rounding.

    Of many impacts one may by chance come out too well, so the first four times are averaged.
    """
    near = np.exp(np.mean(np.log(errors[:, :-1]), axis=1))
    assert slope(TOLERANCES, near) == pytest.approx(1, abs=0.25)
    assert slope(TOLERANCES, errors[:, -1]) == pytest.approx(1, abs=0.25)
    assert np.all(near[2:] < near[:-2])
    # a contact costs some steps at any tolerance, which makes the measured order larger, never smaller
    assert -slope(np.mean(steps[:, :-1], axis=1), near) > order - 0.5
    assert np.max(errors[-1, :-1]) < 2e-9
    assert errors[-1, -1] < 2e-7


@pytest.mark.parametrize("method", ORDERS)
@pytest.mark.parametrize("scene", CRANKS)
def test_the_error_falls_with_accuracy_at_the_method_s_order(scene, method):
    errors, steps = measure(model(scene), method, CRANKS[scene])
    check_convergence(errors, steps, ORDERS[method])


# ---- the step itself -------------------------------------------------------------------------------------------------


def in_contact(scene, method):
    """A phase of the first contact in which the force is smooth: the state at its start, its length [s], and its end by SciPy on other equations."""
    hit = reference(CRANKS[scene]).impacts[0]
    begin, length = hit.onset + 0.3 * (hit.end - hit.onset), 0.4 * (hit.end - hit.onset)
    run = simulate(engine_model(scene), duration="0.3 ms", tolerance=1e-11, method=method)
    start = run.at([begin])
    assert start["slider_pin.mode"] == [1]

    def rates(t, y):
        v0 = start["slider_pin.approach_speed"][0]
        return (*y[2:], *MECHANISM.accelerations(t, y, v0=v0, friction=CRANKS[scene]))

    span = (begin, begin + length)
    exact = solve_ivp(rates, span, states(start)[:, 0], method="DOP853", rtol=3e-14, atol=1e-18, max_step=length / 60)
    return start, length, exact.y[:, -1]


def fixed_steps(start, length, count):
    """The state after so many equal steps of the engine's step function."""
    here = start
    for _ in range(count):
        here = here.between(np.array([0]), np.array([length / count]))
    return states(here)[:, 0]


def step_errors(scene, method, counts):
    start, length, exact = in_contact(scene, method)
    scale = np.array([MECHANISM.l / MECHANISM.c, 1 / MECHANISM.c, MECHANISM.l, 1.0])
    scale[2:] /= MECHANISM.r * MECHANISM.w
    return np.array([np.max(scale * np.abs(fixed_steps(start, length, count) - exact)) for count in counts])


COUNTS = {"dopri5": (8, 16, 32), "dop853": (2, 3, 4, 6)}


def check_order(counts, errors, order):
    assert -slope(counts, errors) == pytest.approx(order, abs=0.3)


@pytest.mark.parametrize("method", ORDERS)
@pytest.mark.parametrize("scene", CRANKS)
def test_fixed_steps_in_a_smooth_contact_converge_at_the_order(scene, method):
    errors = step_errors(scene, method, (*COUNTS[method], 200))
    check_order(COUNTS[method], errors[:-1], ORDERS[method])
    assert errors[-1] < 2e-12  # rounding


# ---- the checks can fail ---------------------------------------------------------------------------------------------


def seeded(method, monkeypatch, *, in_b):
    """Let METHODS give a table with one coefficient off by 1e-6, sums kept, past the record's own verification."""
    table = copy.copy(methods.METHODS[method][0]())
    if in_b:
        b = list(table.b)
        b[0], b[-1] = b[0] + 1e-6, b[-1] - 1e-6
        object.__setattr__(table, "b", tuple(b))
    else:
        A = [list(row) for row in table.A]
        A[-1][0], A[-1][-1] = A[-1][0] + 1e-6, A[-1][-1] - 1e-6
        object.__setattr__(table, "A", tuple(map(tuple, A)))
    monkeypatch.setitem(methods.METHODS, method, (lambda: table,))


@pytest.mark.parametrize("in_b", [True, False])
@pytest.mark.parametrize("method", ORDERS)
def test_a_wrong_coefficient_is_noticed(method, in_b, monkeypatch):
    seeded(method, monkeypatch, in_b=in_b)
    errors = step_errors("slider_crank", method, COUNTS[method])
    with pytest.raises(AssertionError):
        check_order(COUNTS[method], errors, ORDERS[method])
    with pytest.raises(AssertionError):
        check_convergence(*measure(engine_model("slider_crank"), method, friction=True), ORDERS[method])
