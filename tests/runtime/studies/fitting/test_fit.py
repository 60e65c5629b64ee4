"""Fits of balls: published rebounds, a regression in closed form, what data cannot tell, and bad input."""

from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime import Experiment, MeasuredImpacts, Measurement, fit, read_impacts, simulate
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.fitting.experiment import of_impacts
from hertzwerk.runtime.studies.fitting.fitting import read_fit

TRAVEL = "vertical.travel"
# 1.6 kg, 1e6 N/m, 10 m/s, Hunt and Crossley: published rebound speeds [m/s], whose integration is right to 1.2e-4 of the third
PUBLISHED = {0.9: (9.090298887, 8.263743089, 7.512142692), 0.5: (6.629838391, 4.395155252, 2.913688144)}


@pytest.fixture(scope="module")
def walls():
    return engine_model("ball_between_walls")


def heights(run, *, noise=1e-3, seed=0, end=None, count=60):
    """Measured heights of a ball with normal noise [m]."""
    t = np.linspace(0.02, 0.98 * run.engine.t_end if end is None else end, count)
    y = run.at(t)[TRAVEL] + np.random.default_rng(seed).normal(0, noise, count)
    return Measurement(t, {"height": 1e3 * y}, {"height": "mm"}, "heights.csv")


HEIGHT = {"map": {"height": TRAVEL}, "noise": {"height": "1 mm"}, "starts": 4}


@pytest.mark.parametrize("e", PUBLISHED)
def test_public_rebounds_give_their_restitution(walls, e):
    speeds = PUBLISHED[e]
    data = MeasuredImpacts([2, 3, 4], {"speed": speeds}, {"speed": "m/s"})
    fitted = fit(
        walls, data, free={"restitution": (0.3, 1)}, noise={"speed": (1.2e-4 * speeds[2], "m/s")}, duration="2 s"
    )
    value = fitted["restitution"]
    assert value.interval.low < e < value.interval.high and "linear" in value.interval.how
    assert abs(value.value - e) < 1.2e-4 and fitted.explained
    assert fitted.known.singular_values[0] > 5e3 and fitted.solutions[0].impacts[2].speed == pytest.approx(
        speeds[1], rel=1e-3
    )


def test_a_stiffness_has_the_exponent_of_its_law_in_its_unit(ball):
    data = MeasuredImpacts([1], {"peak_force": [9e4]}, {"peak_force": "N"})
    noise, free = {"peak_force": "100 N"}, {"stiffness": "2e10..3e10 N/m^1.5 log"}
    actual = fit(ball, data, free=free, noise=noise, duration="0.5 s", starts=1, profile=False)["stiffness"]
    assert actual.unit == "N/m^1.5"
    assert "N/m^1.5 (" in str(actual)
    assert str(replace(actual, unit="N/m^exponent")).endswith("its unit depends on exponent")


def test_a_rebound_is_as_high_as_the_next_impact_is_fast(ball):
    """v^2/(2 g) above the height at which it touches the floor."""
    run = simulate(ball, duration="2.5 s", tolerance=1e-10)
    rises, speeds = of_impacts(run, f"impacts.rebound.{TRAVEL}"), [impact.speed for impact in run.impacts[1:]]
    floor = run.at([run.impacts[0].t])[TRAVEL][0]
    assert len(speeds) > 1 and rises[:-1] == pytest.approx(floor + np.square(speeds) / (2 * 9.81), rel=1e-7)


def test_free_fall_is_a_regression(ball):
    """h = s - g t^2/2 before the floor: interval of ordinary least squares, with Student's t."""
    data = heights(simulate(ball, duration="0.45 s", tolerance=1e-11))
    free = {"gravity": "9..11 m/s^2", TRAVEL: "0.9..1.3 m"}
    fitted = fit(ball, data, free=free, map=HEIGHT["map"], starts=2)
    design = np.column_stack([-(data.times**2) / 2, np.ones(60)])
    y = data.si("height")
    expected, square, *_ = np.linalg.lstsq(design, y, rcond=None)
    errors = np.sqrt(np.diag(np.linalg.inv(design.T @ design)) * square / 58) * 2.0017175  # t of 58 degrees at 97.5 %
    for name, value, error in zip(free, expected, errors, strict=True):
        one = fitted[name]
        assert one.value == pytest.approx(value, rel=1e-7)
        assert one.interval.high - one.value == pytest.approx(error, rel=1e-3)
    assert fitted.goodness is None and "is not stated" in str(fitted)
    slope = design.T @ design
    assert fitted.known.correlation[0, 1] == pytest.approx(-slope[0, 1] / np.sqrt(slope[0, 0] * slope[1, 1]), rel=1e-4)
    # Of a regression: half-width over standard deviation is 1.95996; AICc is chi^2 + 2 sum ln sigma + 2 k + 2 k (k + 1)/(n - k - 1).
    fitted = fit(ball, data, free=free, map=HEIGHT["map"], noise={"height": "2 mm"}, starts=2)
    deviations = 2e-3 * np.sqrt(np.diag(np.linalg.inv(design.T @ design)))
    for name, value, deviation in zip(free, expected, deviations, strict=True):
        interval = fitted[name].interval
        assert (interval.high - value) / deviation == pytest.approx(1.95996, abs=1e-3)
        assert (value - interval.low) / deviation == pytest.approx(1.95996, abs=1e-3)
    assert fitted.criterion == pytest.approx(square[0] / 2e-3**2 + 120 * np.log(2e-3) + 4 + 12 / 57, abs=1e-6)


def test_derivatives_are_those_of_the_predictions(ball):
    """Against differences: quantities, offset and gain, samples and impacts, of two runs."""
    runs = [simulate(ball, duration="1.6 s", tolerance=1e-11, parameters={"drop_height": f"{h} m"}) for h in (0.8, 1)]
    impacts = MeasuredImpacts(
        [1, 2], {"t": [0.45, 1.3], "speed": [4, 3.6], "rise": [0.9, np.nan]}, {"t": "s", "speed": "m/s", "rise": "m"}
    )
    names = {"t": "impacts.t", "speed": "floor.impacts.speed", "rise": f"impacts.rebound.{TRAVEL}"}
    requested = read_fit(
        ball, [Experiment(heights(runs[0]), {"drop_height": "0.8 m"}), Experiment(impacts, {"drop_height": "1 m"}, duration="1.6 s")],
        {"restitution": (0.3, 1), "gravity": "9..11 m/s^2"}, map={"height": TRAVEL, **names}, noise=None, parameters=None,
        initial=None, inputs=None, duration=None, offset="-10..10 ms", gain={"height": "0.9..1.1"}, tolerance=1e-12,
        method="dop853", starts=1, seed=0, compiled=False, profile=False,
    )  # fmt: skip
    forward = requested.forward()
    x = np.array([free.inner(v) for free, v in zip(forward.searched, (0.88, 9.7, 3.1e-3, -2.3e-3, 1.04), strict=True)])
    actual = forward.slopes(x)
    assert actual.shape == (60 + 5, 5) and np.all(np.isfinite(forward.at(x).predicted))
    for j in range(5):
        step = np.zeros(5)
        step[j] = 1e-4
        difference = (forward.at(x + step).predicted - forward.at(x - step).predicted) / 2e-4
        size = max(np.max(np.abs(difference)), 1e-3)
        close = np.abs(actual[:, j] - difference) < 2e-6 * size
        assert np.sum(~close) <= 1  # a sample that the difference carries over an impact


def test_unidentifiable_combinations_are_named(walls):
    """Of mass and stiffness flights and speeds tell the ratio alone, and that only by the time of contact."""
    run = simulate(walls, duration="0.3 s", tolerance=1e-11)
    times = [impact.t for impact in run.impacts]
    data = MeasuredImpacts(range(1, 4), {"t": times}, {"t": "s"})
    free = {"mass": "1..2 kg log", "stiffness": "5e5..2e6 N/m log", "restitution": (0.5, 1)}
    fitted = fit(walls, data, free=free, noise={"t": "0.01 ms"}, duration="0.4 s", starts=2, profile=False)
    (text,) = fitted.unidentified
    assert (
        "mass times 2 with stiffness times 2 changes" in text
        or "stiffness times 2 with mass times 2" in text.replace("mass times 2 with", "")
    )
    assert "none" in fitted["mass"].interval.how and "linear" in fitted["restitution"].interval.how
    assert "cannot be identified" in fitted.verdict and np.isnan(fitted.known.correlation[0, 2])


def test_noise_offset_and_gain_are_found(ball):
    run = simulate(ball, duration="1.2 s", tolerance=1e-11)
    good = fit(ball, heights(run), free={"restitution": (0.3, 1)}, **HEIGHT)
    bad = fit(ball, heights(run, noise=2e-3), free={"restitution": (0.3, 1)}, **HEIGHT)
    assert good.explained is True and good.goodness.p_value > 0.01
    assert bad.explained is False and "rejected at 5 %" in str(bad)
    assert good["restitution"].interval.low < 0.9 < good["restitution"].interval.high
    data = heights(run, end=1.1)
    moved = Measurement(data.times - 4e-3, {"height": 1.02 * data.columns["height"]}, data.units)
    how = HEIGHT | {"offset": "-10..10 ms", "gain": {"height": "0.9..1.1"}}
    fitted = fit(ball, moved, free={"restitution": (0.3, 1)}, **how)
    for name, true in (("restitution", 0.9), ("offset", 4e-3), ("gain of height", 1.02)):
        assert fitted[name].interval.low < true < fitted[name].interval.high
    assert list(fitted.nuisance) == ["offset", "gain of height"] and fitted.explained


def test_bad_input_is_one_error_with_all_faults(ball, tmp_path, walls):
    file = tmp_path / "heights.csv"
    file.write_text("t [s],height [kg]\n0.1,1\n0.3,2\n0.2,3\n", encoding="utf-8")
    with pytest.raises(InputError) as raised:
        free = {"restitutoin": (0.3, 1), "mass": "2..1 kg", "stiffness": "1..2 mm"}
        fit(ball, file, free=free, map={"height": TRAVEL}, offset="1..2 mm")
    text = str(raised.value)
    for part in ("did you mean restitution", "after 0.3", "smaller end first", "offset", "stiffness"):
        assert part in text
    file.write_text("t [s],height [kg]\n0.1,1\n0.2,2\n0.3,3\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"a unit of m, as vertical.travel has"):
        fit(ball, file, free=["restitution"], map={"height": TRAVEL})
    data = MeasuredImpacts([2, 3], {"speed": [9, 8]}, {"speed": "m/s"})
    with pytest.raises(InputError, match=r"gap: found a quantity that changes nothing of speed") as raised:
        fit(walls, data, free={"restitution": (0.3, 1), "gap": "0.2..0.6 m"}, duration="1 s")
    assert len(raised.value.faults) == 1


@pytest.mark.parametrize(
    ("rows", "fault"),
    [
        ("1,0.1\n3,0.4\n", None), ("1,0.1\n1,0.4\n", "the number 1, again"), ("1.5,0.1\n", "a whole number of an impact"),
        ("2,0.1\n1,0.4\n", "numbers that increase"), (",0.1\n", "no number"),
    ],
)  # fmt: skip
def test_tables_of_impacts(tmp_path, rows, fault):
    file = tmp_path / "impacts.csv"
    file.write_text(f"impact [1],t [s]\n{rows}", encoding="utf-8")
    if fault is None:
        actual = read_impacts(file)
        assert list(actual.numbers) == [1, 3] and list(actual.si("t")) == [0.1, 0.4]
    else:
        with pytest.raises(InputError, match=fault):
            read_impacts(file)


def test_a_profile_of_a_linear_model_is_its_curvature(ball):
    data = heights(simulate(ball, duration="0.45 s", tolerance=1e-11))
    how = HEIGHT | {"free": {"gravity": "9..11 m/s^2", TRAVEL: "0.9..1.3 m"}, "starts": 0}
    linear, profile = (fit(ball, data, profile=requested, **how) for requested in (False, True))
    for name in how["free"]:
        one, other = linear[name].interval, profile[name].interval
        width = one.high - one.low
        assert "profile" in other.how and "linear" in one.how
        assert abs(one.low - other.low) < 2e-3 * width and abs(one.high - other.high) < 2e-3 * width
    capped = fit(
        ball, data, profile="auto", **{**how, "free": {"gravity": (("9 m/s^2"), ("9.8 m/s^2")), TRAVEL: "0.9..1.3 m"}}
    )
    assert capped["gravity"].interval.open_high and "profile" in capped["gravity"].interval.how
    assert any("gravity lies at an end of its range" in text for text in capped.warnings)


def test_data_past_the_horizon_of_rough_runs_are_left_out(ball):
    data = heights(simulate(ball, duration="3.5 s", tolerance=1e-11), noise=1e-6, count=80)
    how = HEIGHT | {"noise": {"height": "0.001 mm"}, "starts": 0}
    fitted = fit(ball, data, free={"restitution": (0.85, 0.95)}, tolerance=1e-4, **how)
    used = fitted.signals[0].used
    assert 0.05 < fitted.share < 0.9 and used[0] and not used[-1]
    assert any("beyond the horizon" in text for text in fitted.warnings)
    assert not np.any(np.diff(used.astype(int)) > 0)  # from one time on


def test_where_there_are_no_exact_derivatives_differences_serve(ball, monkeypatch):
    run = simulate(ball, duration="1.2 s", tolerance=1e-11)
    how = {"free": {"restitution": (0.3, 1)}, **HEIGHT, "starts": 0}
    exact = fit(ball, heights(run), **how)

    def refuse(*_):
        raise InputError("sensitivities", [Fault("friction", "set-valued in two directions", "one")])

    monkeypatch.setattr(type(run), "sensitivities", refuse)
    fitted = fit(ball, heights(run), **how)
    assert "in part by differences: friction: set-valued" in fitted.derivatives and exact.derivatives.endswith(
        "every impact"
    )
    assert fitted["restitution"].value == pytest.approx(exact["restitution"].value, abs=1e-6)
    assert fitted["restitution"].interval.high == pytest.approx(exact["restitution"].interval.high, abs=1e-6)


def test_several_runs_share_what_is_free_and_keep_their_own(ball):
    """Two drops from known heights tell the restitution better than one: intervals shrink as the information adds."""
    runs = {
        h: simulate(ball, duration="1.2 s", tolerance=1e-11, parameters={"drop_height": (h, "m")}) for h in (0.7, 1.0)
    }
    experiments = [
        Experiment(heights(run, seed=k), {"drop_height": (h, "m")}) for k, (h, run) in enumerate(runs.items())
    ]
    widths = []
    for data in ([experiments[0]], [experiments[1]], experiments):
        interval = fit(ball, data, free={"restitution": (0.3, 1)}, **HEIGHT)["restitution"].interval
        widths.append(interval.high - interval.low)
    assert widths[2] == pytest.approx((widths[0] ** -2 + widths[1] ** -2) ** -0.5, rel=5e-3)
