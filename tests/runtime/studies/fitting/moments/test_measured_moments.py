"""Fits of statistics of measured series: a block that another random force pushes, its command, and bad input."""

import numpy as np
import pytest
from shaken import shaken

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import MeasuredImpacts, MeasuredSeries, Measurement, fit_moments, load, simulate
from hertzwerk.runtime.engine.inputs.time_series import Samples

STEP, DAMPING = 0.2, 6.0
FREE = {"damping": "3..12 N s/m log"}
MOMENTS = {"x.rms": None, "v.rms": None}


def push(seed, duration):
    """Random force [N]."""
    times = np.arange(0, duration + STEP, STEP)
    return Samples(times, np.random.default_rng(seed).normal(0, 20, len(times)), ("s", "N"))


def series(seed, duration):
    """What was measured, with noise, of a block with the true damping."""
    run = simulate(
        shaken(), duration=duration, parameters={"damping": (DAMPING, "N s/m")}, inputs={"push": push(seed, duration)}
    )
    times = np.arange(0, duration, 0.05)
    seen, rng = run.at(times), np.random.default_rng(seed)
    made = {"x": seen["slide.travel"], "v": seen["slide.speed"] + rng.normal(0, 0.1, len(times))}
    data = Measurement(times, made, {"x": "m", "v": "m/s"})
    return MeasuredSeries(data, map={"x": "slide.travel", "v": "slide.speed"}, noise={"v": "0.1 m/s"})


def fitted(seed, duration, **how):
    inputs = {"push": push(1000 + seed, 2 * duration)}
    options = {"duration": 2 * duration, "inputs": inputs, "workers": 1, **how}
    return fit_moments(shaken(), MOMENTS, free=FREE, series=series(seed, duration), **options)


def test_the_truth_is_within_the_interval():
    actual = fitted(0, 80)
    assert actual["damping"].interval.low < DAMPING < actual["damping"].interval.high
    assert actual.explained and actual.unidentified == ()
    assert actual["damping"].interval.high - actual["damping"].interval.low < 7
    assert all(moment.deviation > 0.02 * moment.value for moment in actual.moments)  # independent samples: 0.01


@pytest.mark.exhaustive
def test_intervals_hold_the_truth_over_seeds():
    """Of 60 intervals of 95 %: binomial, 0.3 % of right ones hold fewer than 52."""
    held = 0
    for seed in range(60):
        one = fitted(seed, 80)["damping"].interval
        held += one.low <= DAMPING <= one.high
    print("held", held, "of 60")
    assert held >= 52


WALLS = {"restitution": 1}  # of the ball: linear springs of 1e6 N/m, 1.6 kg, 0.8 m of flight


def impacts(v, count=120, seed=4):
    """Return a list of impacts of a ball that flies at v [m/s], each interval with a scatter of 20 %, speeds of 2 %."""
    rng = np.random.default_rng(seed)
    between = (0.8 / v + np.pi * np.sqrt(1.6 / 1e6)) * (1 + 0.2 * rng.normal(size=count))
    found = {"t": np.cumsum(between), "speed": v + 0.02 * v * rng.normal(size=count)}
    return MeasuredImpacts(np.arange(1, count + 1), found, {"t": "s", "speed": "m/s"})


def test_impacts_tell_by_their_rate_and_their_speeds():
    """Rate of an elastic ball: 1 / (2 gap / v + pi sqrt(m / K)); each list at a start of its own, independent of the other."""
    walls = load("ball_between_walls")
    lists = [
        MeasuredSeries(impacts(9.0), map={"t": "impacts.t", "speed": "impacts.speed"}, parameters={"gap": "0.4 m"}),
        MeasuredSeries(impacts(9.0 * 0.5, seed=5), map={"t": "impacts.t"}, parameters={"gap": "0.8 m"}),
    ]
    how = {"parameters": WALLS, "workers": 1, "duration": "3 s", "tolerance": 1e-7}
    actual = fit_moments(walls, {"t.rate": None, "speed.mean": None}, free={"speed": "8..10 m/s"}, series=lists, **how)
    names = [moment.name for moment in actual.moments]
    assert names == ["t.rate of series 1", "speed.mean", "t.rate of series 2"]
    v = actual["speed"].value
    for moment, gap in ((actual.moments[0], 0.4), (actual.moments[2], 0.8)):
        assert moment.unit == "1/s"
        true = 1 / (2 * gap / v + np.pi * np.sqrt(1.6 / 1e6))
        assert moment.fitted == pytest.approx(true, abs=1 / 2.7)  # runs of 2.7 s tell it to an impact more or less,
        assert moment.fitted_deviation > 0.1  # and that is said, though all their blocks count alike
    assert actual.moments[1].fitted == pytest.approx(v, rel=1e-3)
    assert actual.explained  # half the speed over half the gap: of the second only the rate is measured, as of 9 m/s
    assert len(actual.plot().axes) == 2
    assert actual._repr_html_().startswith("<pre>fit: ball_between_walls")


def test_bad_series_and_impacts_without_onsets_are_one_error(tmp_path):
    path = tmp_path / "long.csv"
    path.write_text("t [s],x [m/s]\n" + "".join(f"{0.1 * k},{k % 3}\n" for k in range(100)))
    requested = MeasuredSeries(path, map={"x": "slide.travle"}, bandwidth="5 m", skip="2 m", noise={"y": 1})
    with pytest.raises(InputError) as raised:
        fit_moments(shaken(), {"x.rms": None}, free={"dampin": None}, series=requested)
    text = str(raised.value)
    for part in ("slide.travel", "damping", "frequency", "12 ms", "noise" if "noise" in text else "y"):
        assert part in text
    plain = Measurement(np.arange(100) * 0.1, {"x": np.arange(100) % 3}, {"x": "m"})
    requested = MeasuredSeries(plain, map={"x": "slide.travel"})
    with pytest.raises(InputError) as raised:
        fit_moments(shaken(), {"x.max": None, "z.rms": None, "x.largest": None}, free=FREE, series=requested)
    for part in ("grows with the length", "z.rms, column", "without a period"):
        assert part in str(raised.value)
    with pytest.raises(InputError, match="no measured series"):
        fit_moments(shaken(), {"x.rms": None}, free=FREE)
    constant = Measurement(np.arange(1000) * 0.1, {"x": np.ones(1000)}, {"x": "m"})
    with pytest.raises(InputError, match="repeats exactly"):
        fit_moments(shaken(), {"x.rms": None}, free=FREE, series=MeasuredSeries(constant, map={"x": "slide.travel"}))
    walls, free = load("ball_between_walls"), {"speed": "8..10 m/s"}
    data = impacts(9.0)
    requested = MeasuredSeries(data, map={"speed": "impacts.speed"}, bandwidth="5 kHz")
    with pytest.raises(InputError) as raised:
        fit_moments(walls, {"speed.mean": None}, free=free, series=requested)
    for part in ("0 columns of onsets", "are not filtered"):
        assert part in str(raised.value)
    both = MeasuredSeries(data, map={"t": "impacts.t", "speed": "impacts.speed"})
    with pytest.raises(InputError, match="one of mean, rms, norm8, norm32, largest, rate"):
        fit_moments(walls, {"speed.excursions": None}, free=free, series=both)
