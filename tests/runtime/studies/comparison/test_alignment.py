"""Offset and drift of measured data are found where they were put, and doubts are told where there are."""

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.studies.comparison import alignment
from hertzwerk.runtime.studies.comparison.alignment import align

SPACING = 1e-4


class Known:
    """A run that is a known function of time."""

    def __init__(self, function, end=1.0):
        self.function, self.spacing, self.start, self.end = function, SPACING, 0.0, end
        self.t = SPACING * (np.arange(round(end / SPACING)) + 0.5)
        self.values = self.at(self.t)

    def at(self, times):
        return np.column_stack([self.function(times)])


def pulses(t):
    """Pulses at times that do not repeat."""
    return sum(np.exp(-(((t - at) / 2e-3) ** 2)) for at in 0.1 + 0.8 * np.modf(np.arange(1, 30) * 0.618034)[0])


def measured(function, offset, drift, *, noise=0.0, missing=0.0, seed=3):
    """Samples at an irregular clock of which run time is offset + t + drift (t - begin)."""
    rng = np.random.default_rng(seed)
    t = np.sort(0.05 + 0.85 * rng.random(2000))
    values = function(offset + t + drift * (t - t[0])) + rng.normal(0, noise, len(t))
    values[rng.random(len(t)) < missing] = np.nan
    return t, values[:, None]


@pytest.mark.parametrize(("noise", "missing", "within"), [(0, 0, 2e-7), (0.3, 0.3, 1e-4)])
def test_offset_and_drift_are_found(noise, missing, within):
    t, values = measured(pulses, 0.0123456, 2.5e-3, noise=noise, missing=missing)
    actual = align(Known(pulses), t, values, (-0.04, 0.04), (-5e-3, 5e-3))
    assert actual.offset == pytest.approx(0.0123456, abs=within)
    assert actual.drift == pytest.approx(2.5e-3, abs=2 * within)
    assert actual.doubts == () and actual.correlation > (0.999999 if not noise else 0.5)


def test_a_drift_that_is_not_searched_leaves_less_correlation():
    t, values = measured(pulses, 0.0, 1e-2)
    actual = [align(Known(pulses), t, values, (-0.02, 0.02), drifts) for drifts in ((0.0, 0.0), (-2e-2, 2e-2))]
    assert actual[0].correlation < 0.9 < 0.9999 < actual[1].correlation


def test_values_given_gains_ends_of_ranges_and_horizons():
    t, values = measured(pulses, 0.0, 0.0)
    actual = align(Known(pulses), t, values, (0.01, 0.01), (0.0, 0.0))
    assert (actual.offset, actual.drift, actual.searched) == (0.01, 0.0, False)
    with pytest.raises(InputError, match="lie within the run"):
        align(Known(pulses), t, values, (-1.0, 1.0), (0.0, 0.0))
    with pytest.raises(InputError, match="narrower range"):
        align(Known(pulses, 3.0), t, values, (0.0, 0.0), (-0.5, 0.9))
    t, values = measured(pulses, 0.0123456, 0.0)
    actual = align(Known(pulses), t, 7 + 3 * values, (-0.04, 0.04), (0.0, 0.0))
    assert actual.offset == pytest.approx(0.0123456, abs=2e-7)
    assert "lies at an end" in align(Known(pulses), t, values, (-0.01, 0.012), (0.0, 0.0)).doubts[0]
    # Seeded fault: later the data are those of another motion, of the same size, 5 ms late.
    t, values = measured(pulses, 0.0, 0.0)
    late = t > 0.3
    values[late, 0] = pulses(t[late] - 0.005)
    actual = [align(Known(pulses), t, values, (-0.02, 0.02), (0.0, 0.0), horizon=h) for h in (0.3, np.inf)]
    assert actual[0].offset == pytest.approx(0, abs=1e-6) and abs(actual[1].offset) > 4e-3
    assert "beyond the horizon" in align(Known(pulses), t, values, (-0.02, 0.02), (0.0, 0.0), horizon=0.01).doubts[0]


def test_a_second_offset_that_is_as_good_is_doubted_and_one_outside_the_search_has_no_error():
    def wave(t):
        return np.sin(2 * np.pi * 50 * t)

    t, values = measured(wave, 0.001, 0.0, noise=0.1)
    assert any(
        "correlates nearly as well" in text for text in align(Known(wave), t, values, (-0.03, 0.03), (0, 0)).doubts
    )
    assert align(Known(wave), t, values, (-0.009, 0.009), (0, 0)).doubts == ()
    t, values = measured(pulses, 0.001, 0.0, noise=0.1)
    actual = align(Known(pulses), t, values, (0.0, 2e-3), (0.0, 0.0))
    assert actual.offset_error > 0 and np.isnan(actual.drift_error)
    assert np.isnan(align(Known(pulses), t, values, (0.001, 0.001), (0.0, 0.0)).offset_error)


def coloured(seed, size, memory):
    """Noise of unit variance whose neighbours correlate by `memory`."""
    found = np.random.default_rng(seed).normal(size=size)
    for i in range(1, size):
        found[i] = memory * found[i - 1] + np.sqrt(1 - memory**2) * found[i]
    return found


SEEDS = 100
OFFSET, DRIFT = 0.0023456, 1.5e-3


class Tabled(Known):
    """Signals of different size, by interpolation, which is fast."""

    def __init__(self, signals):
        self.signals, self.fine = signals, np.linspace(0, 1, 100_001)
        self.table = pulses(self.fine)
        super().__init__(pulses)

    def at(self, times):
        return np.outer(np.interp(times, self.fine, self.table), 1 + np.arange(self.signals))


def scores(memory, drifts, signals=1, samples=500):
    """Errors of offset and drift over their standard errors, for many seeds; of unit variance where those are right."""
    found, run = [], Tabled(signals)
    for seed in range(SEEDS):
        rng = np.random.default_rng(seed)
        t = np.sort(0.05 + 0.85 * rng.random(samples))
        drift = DRIFT if drifts[0] < drifts[1] else 0.0
        noise = [0.2 * coloured(1000 * j + seed, samples, memory) for j in range(signals)]
        values = run.at(OFFSET + t + drift * (t - t[0])) + np.column_stack(noise)
        best = align(run, t, values, (0.0, 5e-3), drifts)
        row = [(best.offset - OFFSET) / best.offset_error]
        found.append([*row, (best.drift - DRIFT) / best.drift_error] if drift else row)
    return np.array(found)


@pytest.mark.by_turns(3)
@pytest.mark.parametrize(
    ("memory", "drifts", "signals", "samples"),
    [(0, (0, 0), 1, 500), (0.8, (0, 0), 1, 2000), (0, (0, 0), 3, 500), (0.5, (0, 3e-3), 1, 500)],
)
def test_standard_errors_cover_what_was_put_in(memory, drifts, signals, samples):
    """Of 100 seeds 95 % lie within 1.96 standard errors, up to the chance of so many seeds; their spread is one."""
    z = scores(memory, drifts, signals, samples)
    assert np.all(np.std(z, axis=0) > 0.8) and np.all(np.std(z, axis=0) < 1.25)
    assert np.all(np.mean(np.abs(z) < 1.96, axis=0) > 0.88)


def test_errors_that_take_correlated_noise_for_white_would_be_seen(monkeypatch):
    """Seeded fault."""
    monkeypatch.setattr(alignment, "autocorrelations", lambda residual: np.zeros(0))
    z = scores(0.8, (0, 0), samples=2000)
    assert np.std(z) > 1.25
    assert np.mean(np.abs(z) < 1.96) < 0.88
