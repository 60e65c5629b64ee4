"""The benchmark of honest estimates, on two cheap scenes and a few random mechanisms."""

import numpy as np
import pytest
from benchmarks.honesty import METHODS, Case, honesty, random_motions, scene

from hertzwerk.runtime.engine.accuracy import error_estimate as accuracy

pytestmark = pytest.mark.exhaustive


def within(cases):
    return np.mean([0.1 <= case.ratio <= 10 for case in cases if case.what == "finished"])


def cases(methods=METHODS):
    motions, asked = [scene("soft_ball"), scene("pendulum")], (1e-3, 1e-5, 1e-7)
    return [motion.measured(method, a) for motion in motions for method in methods for a in asked]


def test_every_method_is_honest(monkeypatch):
    found = cases()
    assert np.mean([case.what == "finished" for case in found]) >= 0.8
    assert within(found) >= 0.95
    assert np.mean([case.true <= case.asked for case in found]) >= 0.9
    blind = property(lambda checked: np.full(len(checked.differences), checked.run.tolerance))
    monkeypatch.setattr(accuracy._Checked, "values", blind)
    assert within(cases(METHODS[:2])) < 0.95


def test_requests_of_random_mechanisms_hold_for_the_whole_run():
    asked = (1e-3, 1e-5, 1e-7, 1e-9)
    found = [motion.measured(method, a) for motion in random_motions(60) for method in METHODS[:2] for a in asked]
    judged = [case for case in found if case.what == "finished"]
    assert len(judged) > 300
    assert [case for case in judged if case.true > case.asked] == []
    assert within(found) >= 0.99


def test_the_report_shows_the_difference():
    asked = 1e-6
    lines = list(honesty(scenes=("pendulum",), methods=("dop853",), accuracies=(1e-4, asked), at_random=0))
    assert "2 runs: 100.0% within 10" in lines[0]
    assert lines[-1] == "  2 finished"
    assert Case("a", "b", asked, "finished", 1e-8, 2e-7).ratio == pytest.approx(0.05)
