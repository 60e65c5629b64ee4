"""Fits of statistics by simulated moments: against power laws of a drop, a scene in chaos, and bad input."""

import math

import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import fit_moments, load, simulate

RANGES = {"drop_height": "0.7..1.5 m log", "stiffness": "1e10..4e10 N/m^1.5 log"}
HOW = {"duration": "0.7 s", "parameters": {"restitution": 1}, "tolerance": 1e-9, "workers": 1}


@pytest.fixture(scope="module")
def ball():
    return load("bouncing_ball")


def test_a_drop_follows_its_power_laws(ball):
    """Impulse 2 m sqrt(2 g h), peak force K^(2/5) (5/4 m v^2)^(3/5): h and K, and their intervals, in closed form."""
    h, stiffness = 1.0, 2.2e10
    v = math.sqrt(2 * 9.81 * h)
    impulse, force = 2 * v, stiffness**0.4 * (1.25 * v**2) ** 0.6
    part = 0.01
    moments = {
        "floor.impulse": ((impulse, "N s"), (part * impulse, "N s")),
        "floor.peak_force": f"{force} +- {part * force} N",
    }
    fitted = fit_moments(ball, moments, free=RANGES, **HOW)
    of_height = 2 * part
    of_stiffness = math.hypot(part, 0.6 * of_height) / 0.4
    for name, value, deviation in (("drop_height", h, of_height), ("stiffness", stiffness, of_stiffness)):
        one = fitted[name]
        assert one.value == pytest.approx(value, rel=2e-3)
        assert math.log(one.interval.high / one.interval.low) == pytest.approx(2 * 1.96 * deviation, rel=0.05)
        assert "simulated moments" in one.interval.how
    assert fitted.goodness is None and fitted.unidentified == () and fitted.explained is None
    for moment in fitted.moments:
        assert moment.fitted == pytest.approx(moment.value, rel=1e-3)


def test_statistics_that_do_not_tell_are_said_by_name(ball):
    """The force alone tells a product of powers of height and stiffness, and a third that contradicts is rejected."""
    h = 1.0
    impulse = 2 * math.sqrt(2 * 9.81 * h)
    moments = {"floor.impulse": f"{impulse} +- {impulse / 100} N s", "floor.impacts": "1 +- 0.1"}
    fitted = fit_moments(ball, moments, free=RANGES, **HOW)
    assert (
        len(fitted.unidentified) == 1
        and "stiffness times 2" in fitted.unidentified[0]
        and "none" in fitted["stiffness"].interval.how
    )
    wrong = {**moments, "floor.peak_force": "1000 +- 100 N"}
    assert fit_moments(ball, wrong, free=RANGES, **HOW).explained is False


def test_bad_moments_are_one_error(ball):
    moments = {"floor.impulse": "3 N s", "floor.peak_force": ("5 kN", "0.1 mm"), "floor.impacts": "1 +- 0"}
    with pytest.raises(InputError) as raised:
        fit_moments(ball, moments, free={"drop_heigth": None}, **HOW)
    text = str(raised.value)
    for part in ("did you mean drop_height", "412 +- 5 1/s", "0.1 mm", "a positive standard deviation"):
        assert part in text
    with pytest.raises(InputError, match="no_such"):
        fit_moments(ball, {"floor.no_such": "1 +- 1 N"}, free=RANGES, **HOW)


def test_runs_that_do_not_finish_say_why(ball):
    with pytest.raises(InputError, match=r"runs that finish(.|\n)*too_many_steps: .* 3 steps accepted"):
        fit_moments(ball, {"floor.impulse": "8.9 +- 0.1 N s"}, free=["drop_height"], **HOW, max_steps=3)


@pytest.mark.exhaustive
def test_a_rattling_pin_returns_its_clearance():
    """Statistics of one run of 400 revolutions, far beyond its horizon, against runs of 200."""
    model = load("slider_crank_frictionless")
    run = simulate(model, duration="400 rev", tolerance=1e-6, parameters={"clearance": "0.5 mm"}, grid=100)
    names = {
        "slider_pin.impact_rate": "slider_pin.impact_rate",
        "slider_pin.peak_force": "slider_pin.mean_peak_force",
        "slider_pin.dissipated_power": "slider_pin.dissipated_power",
        "slider_pin.normal_force": "slider_pin.mean_force",
    }
    averages = {names[a.name]: a for a in run.averages() if a.name in names}
    moments = {name: ((a.mean, a.unit), (a.half_width / 2, a.unit)) for name, a in averages.items()}
    fitted = fit_moments(model, moments, free={"clearance": "0.3..0.7 mm"}, duration="200 rev")
    print(fitted)
    assert fitted["clearance"].interval.low < 0.5e-3 < fitted["clearance"].interval.high
    assert fitted.explained and fitted["clearance"].interval.high - fitted["clearance"].interval.low < 0.2e-3
