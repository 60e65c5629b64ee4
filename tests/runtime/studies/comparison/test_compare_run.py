"""A run beside data made from it, and from the same scene with another contact law."""

import json
from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Measurement, compare, load, simulate
from hertzwerk.runtime.studies.comparison.filtered_run import FilteredRun, Instrument

NAMES = ("guide.acceleration", "guide.travel")
NOISE = {"acceleration": "150 m/s^2", "travel": "0.02 mm"}
HOW = {"bandwidth": "5 kHz", "offset": "-1..1 ms", "drift": "-1e-3..1e-3", "noise": NOISE}
MAP = {"acceleration": NAMES[0], "travel": NAMES[1]}
OFFSET, DRIFT = 3.3e-4, 4e-4


@pytest.fixture(scope="module")
def run():
    return simulate(load("slider_crank"), duration="12 ms")


def data_of(run, *, seed=1, missing=0.03, spacing=2e-5):
    """Samples of a run behind an instrument, with noise, an offset, a drift of the clock, and holes."""
    rng = np.random.default_rng(seed)
    t = np.arange(0.0015, 0.0108, spacing)
    rows = FilteredRun(run, NAMES, Instrument(5e3), 1.0).at(OFFSET + t + DRIFT * (t - t[0]))
    columns = {
        "acceleration": rows[:, 0] + rng.normal(0, 150, len(t)),
        "travel": 1e3 * rows[:, 1] + rng.normal(0, 0.02, len(t)),
    }
    for values in columns.values():
        values[rng.random(len(t)) < missing] = np.nan
    return Measurement(t, columns, {"acceleration": "m/s^2", "travel": "mm"})


def test_noise_drift_and_holes_leave_the_noise_alone(run):
    comparison = compare(run, data_of(run), map=MAP, **HOW)
    assert comparison.alignment.offset == pytest.approx(OFFSET, abs=2e-6)
    assert comparison.alignment.drift == pytest.approx(DRIFT, abs=2e-4)
    assert comparison.differs is False and comparison.alignment.doubts == ()
    for signal in comparison.signals:
        assert 0.85 < signal.residual.rms / signal.residual.noise < 1.15
        assert signal.missing and signal.spectrum.distance < 1.5
    assert "explains every residual" in str(comparison)
    figure = comparison.plot()
    titles = [axis.get_title("left") for axis in figure.axes]
    assert len(titles) == 8 and sum("residual" in title for title in titles) == 2
    assert [len(axis.lines) > 0 for axis in figure.axes] == [True] * 8
    comparison = compare(run, data_of(run), map=MAP, **(HOW | {"noise": None}))
    assert comparison.differs is None and "is not stated" in str(comparison)


@pytest.mark.parametrize("seed", [2, 3, 4])
def test_the_same_law_is_no_difference_whatever_the_noise(run, seed):
    assert compare(run, data_of(run, seed=seed), map=MAP, **HOW).differs is False


@pytest.mark.slow  # derives another law
def test_another_law_leaves_a_larger_residual_at_the_same_noise(run):
    other = simulate(load("slider_crank", laws={"slider_pin": "hunt_crossley"}), duration="12 ms")
    same, changed = (compare(each, data_of(run), map=MAP, **HOW) for each in (run, other))
    assert changed.differs is True and "more than" in str(changed)
    assert changed.signals[0].residual.rms > 5 * same.signals[0].residual.rms


@pytest.mark.parametrize(
    "change", [{"bandwidth": "2.5 kHz"}, {"bandwidth": None}, {"zero_phase": True, "offset": 3.3e-4}]
)
def test_another_instrument_than_that_of_the_data_shows(run, change):
    assert compare(run, data_of(run), map=MAP, **(HOW | change)).differs is True


def test_other_friction_leaves_a_larger_residual_at_the_same_noise(run):
    other = simulate(load("slider_crank_frictionless"), duration="12 ms")
    comparison = compare(other, data_of(run), map=MAP, **HOW)
    assert comparison.differs is True and "more than" in str(comparison)


def test_the_trajectory_is_compared_within_the_horizon_and_statistics_beyond(run):
    """Seeded fault: past the horizon the data are those of another motion, which must not count as a residual."""
    data = data_of(run)
    late = data.times > 0.006
    columns = {name: np.where(late, values[::-1], values) for name, values in data.columns.items()}
    parted = Measurement(data.times, columns, data.units)
    short = replace(run, error=replace(run.error, horizon=0.006))
    comparison = compare(short, parted, map=MAP, **HOW)
    assert all(signal.residual.explained and signal.residual.end <= 0.006 for signal in comparison.signals)
    assert all(signal.statistics and signal.statistics[0].run.reason for signal in comparison.signals)
    assert "until the horizon, t = 6 ms" in str(comparison) and comparison.differs is False
    assert compare(run, parted, map=MAP, **HOW).differs is True
    grown = np.where(run.error.times > 0.003, 2e-3, 0.0)  # within the horizon, but no longer small beside a noise
    early = compare(replace(run, error=replace(run.error, values=grown)), parted, map=MAP, **HOW)
    assert early.differs is False and all(signal.residual.end <= 0.0035 for signal in early.signals)
    lost = compare(replace(run, error=replace(run.error, horizon=0.0)), data, map=MAP, **HOW)
    assert all(signal.residual is None for signal in lost.signals) and lost.differs is None
    assert "nothing could be judged" in str(lost) and any("beyond the horizon" in text for text in lost.warnings)


def test_a_file_is_compared_and_the_record_is_json(run, tmp_path):
    data = data_of(run)
    file = tmp_path / "data.csv"
    rows = zip(data.times, *data.columns.values(), strict=True)
    file.write_text("t [s],acceleration [m/s^2],travel [mm]\n" + "\n".join(",".join(map(str, row)) for row in rows))
    found = [compare(run, given, map=MAP, **HOW).record() for given in (file, data)]
    numbers = [json.loads(json.dumps({**each, "source": ""})) for each in found]
    assert numbers[0] == numbers[1] and numbers[0]["signals"][0]["residual"]["explained"]


def test_doubtful_comparisons_are_warned_of(run):
    def warnings(spacing=2e-5, **how):
        return " ".join(compare(run, data_of(run, spacing=spacing), map=MAP, **(HOW | {"drift": 0.0} | how)).warnings)

    assert "above half the sampling rate" in warnings(spacing=1.5e-4)
    assert "no bandwidth is stated" in warnings(bandwidth=None)
    assert "lie outside the run" in warnings(offset="1.5..2 ms")
    assert "above half" not in warnings() and "outside" not in warnings()
    rough = simulate(load("slider_crank"), duration="12 ms", tolerance=1e-8)
    assert "horizon is not known" in " ".join(compare(rough, data_of(run), map=MAP, **HOW).warnings)


def test_requests_with_faults_and_runs_without_steps_are_refused(run):
    with pytest.raises(InputError) as error:
        compare(
            run,
            Measurement([0, 1], {"a": [0, 1], "b": [0, 1], "c": [0, 1]}, {"a": "m/s", "b": "1/s^2", "c": "m"}),
            map={"a": "guide.acceleration", "b": "crank_pin.acceleration", "c": "guide.tavel", "d": "guide.speed"},
            bandwidth="5 rad/s", order=0, offset="2..-2 ms", drift="1 s", noise={"e": "1 m"},
        )  # fmt: skip
    text = str(error.value)
    for expected in (
        "found [m/s], which is m/s; expected a unit of m/s^2", "found [1/s^2]", "did you mean guide.travel",
        "no column of this name", 'such as "5 kHz"', "whole number in 1..12", "the lower end first", "a plain number",
    ):  # fmt: skip
        assert expected in text, (expected, text)
    assert "e: found no column" in text
    grid = simulate(load("slider_crank"), duration="12 ms", tolerance=1e-6, grid=100)
    with pytest.raises(InputError, match="kept its steps"):
        compare(grid, data_of(run), map=MAP)


@pytest.mark.parametrize(
    ("text", "ends"), [("-2..2 ms", (-2e-3, 2e-3)), ("0.1 s", (0.1, 0.1)), ("-1 us..1 ms", (-1e-6, 1e-3))]
)
def test_ranges_are_read_with_units(text, ends):
    from hertzwerk.runtime.studies.comparison.comparison_request import read_between

    faults = []
    assert read_between("offset", text, "s", faults) == pytest.approx(ends) and not faults


def test_the_picture_of_many_samples_keeps_gaps_and_extremes():
    from hertzwerk.runtime.studies.comparison.plot_comparison import PARTS, _broken

    t = np.delete(np.arange(300_000.0), slice(1000, 1500))
    values = np.sin(t / 1e4)
    values[[7, 200_001]] = 9, -9
    x, y = _broken(t, values)
    assert len(x) < 5 * PARTS and np.all(np.diff(x[np.isfinite(x)]) >= 0)
    assert np.nanmax(y) == 9 and np.nanmin(y) == -9 and np.isnan(y).any() and x[-1] == t[-1]
    assert len(_broken(t[:100], values[:100])[0]) == 100
