"""Statistics of series and their covariance: against closed forms of an autoregressive series, and many seeds."""

import math

import numpy as np
import pytest
from scipy.signal import lfilter
from scipy.special import gammaln
from scipy.stats import binom, norm
from scipy.stats import t as student

from hertzwerk.runtime.engine.solution.averages import Estimate
from hertzwerk.runtime.studies.comparison import series_moments
from hertzwerk.runtime.studies.comparison.series_moments import SeriesMoment, impact_statistics, series_statistics

MEMORY, STEP, COUNT = 0.95, 1e-3, 24_000  # of x[k] = MEMORY x[k-1] + noise of variance 1


def series(seed):
    """Return times, and two signals: an autoregressive one about 2, and the same with noise of its own."""
    rng = np.random.default_rng(seed)
    x = 2 + lfilter([1], [1, -MEMORY], rng.normal(size=COUNT + 1000))[1000:]
    return STEP * np.arange(COUNT), np.column_stack([x, x + rng.normal(size=COUNT)])


def covered(kind, true):
    """Return how many of 100 intervals of 95 % hold the truth."""
    held = 0
    for seed in range(100):
        times, samples = series(seed)
        found = series_statistics(times, samples, [SeriesMoment.of(kind, 0, samples[:, 0])], 0.01)
        held += abs(found.values[0] - true) <= 1.96 * found.deviations[0]
    return held


@pytest.mark.parametrize(("kind", "true"), [("mean", 2.0), ("rms", math.sqrt(4 + 1 / (1 - MEMORY**2)))])
def test_intervals_hold_the_truth_and_without_autocorrelation_they_do_not(kind, true, monkeypatch):
    assert 88 <= covered(kind, true) <= 100

    def independent(values, weights):
        mean, n = values.sum() / weights.sum(), len(values)
        left = (values - mean * weights) / weights.mean()
        return Estimate(float(mean), 1.96 * float(np.std(left)) / math.sqrt(n), n, 1)

    monkeypatch.setattr(series_moments, "estimate", independent)
    assert covered(kind, true) < 80


def test_covariance_is_that_of_means_over_blocks():
    """Deviation of the mean: 1 / ((1 - phi) sqrt n); of the second signal's, with its own noise; their covariance the first's."""
    actual = [
        series_statistics(t, x, [SeriesMoment.of("mean", 0, x[:, 0]), SeriesMoment.of("mean", 1, x[:, 1])], 0.01)
        for t, x in map(series, range(40))
    ]
    covariance = np.mean([each.covariance for each in actual], axis=0)
    of_first = 1 / ((1 - MEMORY) ** 2 * COUNT)
    expected = np.array([[of_first, of_first], [of_first, of_first + 1 / COUNT]])
    assert np.all((covariance / expected > 0.9) & (covariance / expected < 1.45))  # Student's t of 8 blocks: 1.45
    assert np.cov(np.array([each.values for each in actual]).T) == pytest.approx(expected, rel=0.6)
    correlations = [each.covariance[0, 1] / np.prod(each.deviations) for each in actual]
    assert np.mean(correlations) == pytest.approx(1 / math.sqrt(1 + (1 - MEMORY) ** 2), abs=0.01)


def test_statistics_of_a_wave_are_its_closed_forms():
    """Of a sine of amplitude 3: rms, norm8, largest in a period; missing samples change nothing; a rate is of what exceeds a level."""
    times = 1e-3 * np.arange(20_000)
    x = 3 * np.sin(2 * np.pi * times)
    x[::7] = np.nan
    kinds = ["mean", "rms", "norm8", "largest", "excursions"]
    result = series_statistics(times, x[:, None], [SeriesMoment.of(kind, 0, x) for kind in kinds], 1.0)
    assert result.values == pytest.approx([0, 3 / math.sqrt(2), 3 * (35 / 128) ** 0.125, 3, 2], abs=0.12)
    assert result.values[:4] == pytest.approx([0, 3 / math.sqrt(2), 3 * (35 / 128) ** 0.125, 3], abs=2e-3)


BLOCKS, LONG, INTERVALS = 29, 134, 4000  # ceil(4000 / 30) intervals to a block


def widened():
    """Return how much larger a deviation from 29 independent blocks is on average, and which part of series has that many.

    Student's t over 1.96; the mean of a standard deviation of n over the true one (c4); intervals before the first
    block, that are left out; and the widening by the correlation r of neighbours that chance leaves, normal about 0 with
    the variance (n - 2)^2 / (n^2 (n - 1)) (Moran, Biometrika 35 (1948) 255), where it is accepted.
    """
    n = BLOCKS
    small = student.ppf(0.975, n - 1) / 1.96 * math.sqrt(2 / (n - 1)) * math.exp(gammaln(n / 2) - gammaln((n - 1) / 2))
    r = np.linspace(-1, 1.645 / math.sqrt(n), 20_001)
    likely = norm.pdf(r, scale=(n - 2) / (n * math.sqrt(n - 1)))
    positive = np.maximum(r, 0)
    correlated = np.average(np.sqrt((1 + positive) / (1 - positive)), weights=likely)
    return small * math.sqrt(INTERVALS / (n * LONG)) * correlated, np.sum(likely) * (r[1] - r[0])


def test_statistics_of_impacts_are_those_of_a_poisson_process():
    """Rate r over T: deviation sqrt(r / T); speeds exponential about s: mean s +- s / sqrt(n), mean square 2 s^2; independent."""
    rate, speed, span = 30.0, 0.5, 200.0
    kinds = ["rate", "mean", "rms"]
    actual = []
    for seed in range(120):
        rng = np.random.default_rng(seed)
        times = np.sort(rng.uniform(0, span, rng.poisson(rate * span)))
        speeds = rng.exponential(speed, len(times))
        speeds[::50] = np.nan  # not measured: the impact counts
        moments = [SeriesMoment.of(kind, k > 0, speeds) for k, kind in enumerate(kinds)]
        one = impact_statistics([times, times], [times, speeds], moments, (0.0, span), span / INTERVALS)
        if one.blocks == BLOCKS:  # of every statistic
            actual.append(one)
    values, deviations = (np.array([getattr(each, what) for each in actual]) for what in ("values", "deviations"))
    n = 0.98 * rate * span
    expected = np.array([math.sqrt(rate / span), speed / math.sqrt(n), speed * math.sqrt(20 / 8 / n)])
    truth = np.array([rate, speed, math.sqrt(2) * speed])
    assert np.mean(values, axis=0) == pytest.approx(truth, rel=0.01)
    factor, accepted = widened()
    assert len(actual) > 0.9 * 120 * accepted**2  # the mean and the rms are nearly one
    assert np.mean(deviations, axis=0) == pytest.approx(factor * expected, rel=0.05)  # three deviations of that mean
    held = np.sum(np.abs(values - truth) <= 1.96 * deviations, axis=0)
    assert np.all(held >= binom.ppf(0.003, len(actual), 0.95))
    correlation = np.mean([each.covariance[0, 1] / np.prod(each.deviations[:2]) for each in actual])
    assert abs(correlation) < 0.15
