"""The benchmark of what a request costs, on a cheap scene."""

import pytest
from benchmarks.honesty import scene
from benchmarks.overpaid import Request, overpaid, requests

from hertzwerk.runtime.engine.run import accurate_run

pytestmark = pytest.mark.exhaustive


def test_a_first_tolerance_far_too_small_is_overpaid(monkeypatch):
    motion, requested = scene("pendulum"), 1e-5
    (usual,) = requests(motion, (requested,))
    first = accurate_run.first_tolerance
    monkeypatch.setattr(accurate_run, "first_tolerance", lambda *known: first(*known) / 1e4)
    (dear,) = requests(motion, (requested,))
    assert usual.cheapest == dear.cheapest <= min(usual.evaluations, dear.evaluations) / 2
    assert dear.cost > 1.5 * usual.cost
    assert usual.true <= requested
    assert dear.true < usual.true / 100


def test_the_report_shows_what_is_over_its_request_and_the_dearest():
    lines = list(overpaid(scenes=("pendulum",), accuracies=(1e-5,)))
    assert [line.split()[:2] for line in lines[:2]] == [["1e-05", "1"], ["all", "1"]]
    assert lines[2].startswith("    dearest: pendulum, 1e-05")
    over = Request("a", 1e-6, 2e-6, 1e-6, evaluations=300, cheapest=100, runs=2)
    assert str(over) == "a, 1e-06: true 2e-06, estimated 1e-06, 2 runs, cost 3.00, time nan"
