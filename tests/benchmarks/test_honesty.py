"""The benchmark of honest estimates, on two cheap scenes with every method."""

import numpy as np
import pytest
from benchmarks.honesty import METHODS, Case, honesty, measured

from hertzwerk.runtime.accuracy import ladder as accuracy


def within(cases):
    return np.mean([0.1 <= case.ratio <= 10 for case in cases if case.what == "finished"])


def cases(methods=METHODS):
    scenes, asked = ("soft_ball", "pendulum"), (1e-3, 1e-5, 1e-7)
    return [measured(scene, method, a) for scene in scenes for method in methods for a in asked]


@pytest.mark.exhaustive
def test_every_method_is_honest(monkeypatch):
    found = cases()
    assert np.mean([case.what == "finished" for case in found]) >= 0.8
    assert within(found) >= 0.95
    assert np.mean([case.true <= case.asked for case in found]) >= 0.9
    monkeypatch.setattr(accuracy._Checked, "end", property(lambda checked: checked.run.tolerance))
    assert within(cases(METHODS[:2])) < 0.95


def test_the_report_tells_what_is_off():
    asked = 1e-6
    lines = list(honesty(scenes=("pendulum",), methods=("dop853",), accuracies=(1e-4, asked)))
    assert "2 runs: 100.0% within 10" in lines[0]
    assert lines[-1] == "  2 finished"
    assert Case("a", "b", asked, "finished", 1e-8, 2e-7).ratio == pytest.approx(0.05)
