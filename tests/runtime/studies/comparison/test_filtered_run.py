"""A run behind an instrument is what fine sampling and SciPy's filter make of it, however short its impacts are."""

import numpy as np
import pytest
from scipy import signal

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.comparison.filtered_run import FilteredRun, Instrument

NAME = "floor.normal_force"


@pytest.fixture(scope="module")
def ball():
    """A ball that falls for 0.45 s and touches for 0.17 ms."""
    return simulate(engine_model("bouncing_ball"), duration="0.47 s", tolerance=1e-9)


def filtered(run, times, instrument):
    """Trapezoids over dense times, and the analogue filter's response by quadrature: no digital filter anywhere."""
    _, poles, gain = signal.butter(instrument.order, 2 * np.pi * instrument.cut_off, analog=True, output="zpk")
    residues = [gain / np.prod([pole - other for other in poles if other != pole]) for pole in poles]
    impact = run.impacts[0]
    dense = np.linspace(impact.t, impact.t + impact.duration, 4001)
    force = run.at(dense)[NAME]
    lag = times[:, None] - dense
    response = sum((r * np.exp(p * np.maximum(lag, 0))).real for r, p in zip(residues, poles, strict=True))
    return np.trapezoid(np.where(lag >= 0, response, 0) * force, dense, axis=1)


def test_an_impact_much_shorter_than_the_filter_comes_through_whole(ball):
    """Oracle: the analogue filter's closed response. A run sampled at points as far apart is off by much more."""
    instrument = Instrument(100.0, 4)
    seen = FilteredRun(ball, [NAME], instrument, 1.0)
    times = np.linspace(ball.impacts[0].t, 0.465, 300)
    expected = filtered(ball, times, instrument)
    actual = seen.at(times)[:, 0]
    largest = np.max(np.abs(expected))
    assert np.max(np.abs(actual - expected)) < 5e-3 * largest
    points = instrument.filtered(ball.at(seen.t)[NAME][:, None], seen.spacing)[:, 0]
    assert np.max(np.abs(np.interp(times, seen.t, points) - expected)) > 0.1 * largest


def test_cells_hold_the_whole_impulse(ball):
    """Oracle: the momentum, of 1 kg. Samples at points as far apart as the cells miss the impact, or make too much of it."""
    seen = FilteredRun(ball, [NAME], None, 1e-3)
    momentum = ball.engine.final["vertical.speed"] + 9.81 * ball.engine.t_end
    assert np.sum(seen.values) * seen.spacing == pytest.approx(momentum, rel=1e-6)
    assert np.sum(ball.at(seen.t)[NAME]) * seen.spacing != pytest.approx(momentum, rel=0.5)
    with pytest.raises(InputError, match="shorter run"):
        FilteredRun(ball, [NAME], Instrument(1e6), 1.0)


def test_zero_phase_does_not_shift_and_causal_does(ball):
    middle = ball.impacts[0].t + ball.impacts[0].duration / 2
    times = np.linspace(middle - 2e-3, middle + 2e-3, 4001)
    peaks = [
        times[np.argmax(FilteredRun(ball, [NAME], Instrument(1e3, 4, zero_phase), 1.0).at(times)[:, 0])] - middle
        for zero_phase in (True, False)
    ]
    assert abs(peaks[0]) < 5e-6
    assert peaks[1] > 1e-4


@pytest.mark.parametrize("zero_phase", [False, True])
def test_the_cut_off_is_where_the_description_says(zero_phase):
    instrument = Instrument(100.0, 4, zero_phase)
    t = np.arange(0, 1, instrument.spacing)
    wave = instrument.filtered(np.sin(2 * np.pi * 100 * t)[:, None], instrument.spacing)[len(t) // 3 : -len(t) // 3]
    dim = 20 * np.log10(np.max(np.abs(wave)))
    assert dim == pytest.approx(-6.02 if zero_phase else -3.01, abs=0.02)
    assert ("6 dB" if zero_phase else "3 dB") in str(instrument)


def test_a_start_is_forgotten_after_the_settling_time():
    instrument = Instrument(100.0, 6)
    step = np.ones((2000, 1))
    step[0] = 0  # what was before
    left = np.abs(1 - instrument.filtered(step, instrument.spacing)[:, 0])
    after = int(instrument.settling / instrument.spacing)
    assert np.max(left[after:]) < 5e-3 < np.max(left[after // 3 :])
    # A constant passes it unchanged from the first sample on.
    constant = np.full((50, 1), 3.0)
    assert Instrument(20.0, order=3).filtered(constant, 1e-3) == pytest.approx(constant, rel=1e-12)


def test_many_times_within_steps_are_seen_by_a_few_points_of_each():
    """Without an instrument: counted are the states that the run evaluates. Seeded fault: coarse polynomials show."""
    run, rows = simulate("slider_crank", duration="4 ms"), []

    class Counted:
        t = run.t

        def at(self, times):
            rows.append(len(times))
            return run.at(times)

    names = ("guide.acceleration", "slider_pin.normal_force", "guide.travel")
    times = np.linspace(run.t[0], run.t[-1], 30_000)
    exact = np.column_stack([run.at(times)[name] for name in names])
    seen = FilteredRun(Counted(), names, None, 1e-6).at(times)
    assert sum(rows) < 25_000
    np.testing.assert_allclose(seen / np.max(np.abs(exact), axis=0), exact / np.max(np.abs(exact), axis=0), atol=1e-9)
    few = times[::300]
    assert np.array_equal(FilteredRun(Counted(), names, None, 1e-6).at(few), exact[::300])
