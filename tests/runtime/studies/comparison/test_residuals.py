"""A residual is judged by the stated noise, coloured noise included; spectra and statistics see what trajectories do not."""

import math

import numpy as np
import pytest
from scipy.signal import lfilter
from scipy.stats import chi2

from hertzwerk.runtime.studies.comparison.residuals import residual_of
from hertzwerk.runtime.studies.comparison.signal_statistics import Estimated, Statistic, by_chance, statistics_of
from hertzwerk.runtime.studies.comparison.spectra import series_of, spectrum_of

T = np.arange(4000) * 1e-3


def noise(seed, smooth=1):
    """Noise of standard deviation 1, over so many samples correlated."""
    white = np.random.default_rng(seed).normal(size=len(T) + smooth - 1)
    return np.convolve(white, np.ones(smooth), "valid") / math.sqrt(smooth)


@pytest.mark.parametrize("smooth", [1, 20])
def test_noise_of_the_stated_size_is_explained_and_a_larger_one_is_not(smooth):
    """Of 200 draws about one in a hundred is taken for a difference, correlated or not; three times as large all are."""
    zero = np.zeros(len(T))
    refused = sum(not residual_of(T, noise(seed, smooth), zero, 1.0).explained for seed in range(200))
    assert refused <= 8
    assert not any(residual_of(T, 3 * noise(seed, smooth), zero, 1.0).explained for seed in range(20))


def test_limits_of_the_noise_are_those_of_chi_squared():
    """1 % of all draws of n independent samples lie above sqrt(chi2/n) deviations, and 1 % below; n by Bartlett's formula."""
    residual = residual_of(T, noise(1), np.zeros(len(T)), 0.5)
    n = residual.independent
    assert n == pytest.approx(len(T), rel=0.05)
    assert residual.largest == pytest.approx(0.5 * math.sqrt(chi2.isf(0.01, n) / n), rel=1e-9)
    assert residual.least == pytest.approx(0.5 * math.sqrt(chi2.isf(0.99, n) / n), rel=1e-9)
    series = (
        lfilter([1.0], [1.0, -0.8], noise(seed)) for seed in range(20)
    )  # n (1 - phi^2)/(1 + phi^2) tell the variance
    worth = [residual_of(T, x, np.zeros(len(T)), None).independent for x in series]
    assert np.mean(worth) == pytest.approx(len(T) * 0.36 / 1.64, rel=0.05)
    # Oracle: sums of 20 have sum of squared autocorrelations (20/3), so 4000 are worth about 300.
    white, smooth = (residual_of(T, noise(1, n), np.zeros(len(T)), 1.0).independent for n in (1, 20))
    assert white > 3500
    assert smooth == pytest.approx(4000 / (1 + 2 * sum((k / 20) ** 2 for k in range(1, 20))), rel=0.35)
    wave = np.sin(2 * np.pi * T)
    residual = residual_of(T, wave + 0.5, wave, None)
    assert (residual.rms, residual.mean, residual.peak) == pytest.approx((0.5, 0.5, 0.5))
    assert residual.correlation == pytest.approx(1) and residual.explained is None
    assert residual_of(T, wave, -wave, None).correlation == pytest.approx(-1)
    assert math.isnan(residual_of(T, wave, np.zeros(len(T)), None).correlation)


def test_noise_that_is_overstated_is_reported():
    """It would explain any difference of its size; noise of the stated size is hardly ever called overstated."""
    zero = np.zeros(len(T))
    assert all(residual_of(T, noise(seed), zero, 1.3).overstated for seed in range(20))
    assert (
        sum(residual_of(T, noise(seed, smooth), zero, 1.0).overstated for seed in range(100) for smooth in (1, 20)) <= 8
    )


def test_spectra_see_gains_and_noise_or_say_why_not():
    """Oracle: ten times the amplitude is 20 dB at every frequency. The same signal late in time has the same spectrum."""
    x = noise(5)
    actual = spectrum_of(series_of(T, 10 * x, x), 400.0, coherent=True, noise=None)
    assert actual.distance == pytest.approx(20, abs=1e-6) and actual.coherence == pytest.approx(1)
    late = spectrum_of(series_of(T, np.roll(x, 2000), x), 400.0, coherent=True, noise=None)
    assert late.distance < 2.5 and late.coherence < 0.3
    x, added = noise(5, 20), 0.5 * noise(6)
    series = series_of(T, x + added, x)
    with_noise, without = (spectrum_of(series, 400.0, coherent=False, noise=size) for size in (0.5, None))
    assert with_noise.distance < 1.5 < 5 < without.distance
    assert "missing" in series_of(T[np.r_[0:1000, 3000:4000]], T[:2000], T[:2000])
    short = series_of(T[:100], T[:100], T[:100])
    assert "too few" in spectrum_of(short, 400.0, coherent=False, noise=None)
    assert "fewer than 3" in spectrum_of(series_of(T, T, T), 2.0, coherent=False, noise=None)


def test_statistics_of_the_same_process_rarely_differ_and_of_another_do():
    """The same process, drawn anew: trajectories have nothing in common, statistics do."""
    same = [statistics_of(T, noise(k, 5), noise(1000 + k, 5), "m", 0.02) for k in range(40)]
    verdicts = [each.differs for found in same for each in found]
    assert len(verdicts) == 40 * 6 and None not in verdicts
    assert sum(verdicts) < 0.1 * len(verdicts)
    louder = {each.name: each.differs for each in statistics_of(T, 1.3 * noise(1, 5), noise(2, 5), "m", 0.02)}
    assert louder == {
        "mean": False, "rms": True, "5% quantile": True, "50% quantile": False, "95% quantile": True, "excursions": True,
    }  # fmt: skip


@pytest.mark.parametrize(("apart", "differs"), [(1.40, False), (1.43, True)])
def test_independent_intervals_of_the_same_width_differ_beyond_root_two_of_it(apart, differs):
    one, other = Estimated(3.0, 2.0, 4.0), Estimated(3.0 + apart, 2.0 + apart, 4.0 + apart)
    assert Statistic("mean", "m", one, other).differs is differs
    assert Statistic("mean", "m", other, one).differs is differs


def test_excursions_are_counted_once_each():
    """Oracle: 8 pulses in a second, each with ripples that cross the level several times."""
    t = np.arange(8000) * 1e-3
    x = np.where(np.modf(8 * t)[0] < 0.2, 1 + 0.3 * np.sign(np.sin(2 * np.pi * 200 * t)), 0.01 * np.sin(50 * t))
    (rate,) = (each for each in statistics_of(t, x, x, "m", 0.25) if each.name == "excursions")
    assert rate.measured.value == pytest.approx(8, rel=0.02) and rate.unit == "1/s"
    statistics = statistics_of(T[:100], noise(1)[:100], noise(2)[:100], "m", 0.02)
    assert all(each.differs is None and "at least 8 intervals" in each.run.reason for each in statistics)
    assert by_chance(6, 0) == 1 and by_chance(6, 1) == pytest.approx(1 - 0.95**6)
    assert by_chance(6, 3) < 0.01 < by_chance(6, 2)
