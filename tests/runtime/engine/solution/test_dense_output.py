"""Extremes of histories between the steps of a run."""

from types import SimpleNamespace

import numpy as np
import pytest

from hertzwerk.runtime.engine.solution import dense_output
from hertzwerk.runtime.engine.solution.dense_output import Samples

TIMES = np.linspace(0.0, 1.0, 4001)  # of steps, each of two parts
STEP = TIMES[1]


def crests(t):
    """One crest of 1 at a sample, and between two samples one of 1.001, which is .57 at both."""
    low, high = (np.exp(-(((t - at) / (STEP / 3)) ** 2)) for at in (TIMES[1000], TIMES[3000] + STEP / 4))
    return low + 1.001 * high


def run(of=crests):
    at = lambda t: {"t": t, "force": of(t)}  # noqa: E731
    return SimpleNamespace(t=TIMES, at=at)


def test_the_higher_of_two_crests_is_found_though_the_other_has_the_largest_sample():
    samples = Samples(run())
    assert samples["force"].max() == pytest.approx(1.0, abs=1e-9)
    actual = samples.extremes("force")
    assert actual.highest == pytest.approx(1.001, abs=1e-9)
    assert actual.highest_t == pytest.approx(TIMES[3000] + STEP / 4, abs=1e-3 * STEP)


def test_extremes_of_equal_crests_and_of_numbers_that_are_none():
    """A thousand equal crests cost no more than PLACES of them; where a value is no number there is no extreme."""
    calls = []
    wave = Samples(run(lambda t: calls.append(len(t)) or np.sin(2000 * np.pi * t + 0.3)))
    calls.clear()
    assert wave.extremes("force").magnitude == pytest.approx(1.0, abs=1e-8)
    assert sum(calls) <= 2 * dense_output.PLACES * dense_output.POINTS * dense_output.ZOOMS
    assert np.isnan(Samples(run(lambda t: np.where(t > 0.5, np.nan, t))).extremes("force").highest)
