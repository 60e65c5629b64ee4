"""The study of the slider-crank: numbers with their intervals, energy in the mean, faults seen."""

from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.runtime.studies.paper import study_slider_crank as study
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps

PLAN = study.Plan(("hertz_point",), (0.5,), (5000.0,), 10, 10)


@pytest.fixture(scope="module")
def cases():
    return list(study._cases(PLAN, Sweeps(), lambda done: None))


@pytest.fixture(scope="module")
def trajectory():
    return study._trajectory("hertz_point", 10, friction=True)


def holds(verdicts):
    return [verdict.holds for verdict in verdicts if verdict.holds is not None]


@pytest.mark.slow
def test_long_runs_finish_and_their_energy_is_balanced(cases):
    assert [(case.friction, case.outcome) for case in cases] == [(True, "finished"), (False, "finished")]
    assert holds(study._case_verdicts(cases, PLAN)) == [True, True]
    for case in cases:
        mean, half = case.numbers[study.SEVERITY]
        assert 0 < half < mean


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fault", "seen"),
    [({"outcome": "step_too_small"}, [False, True]), ({"residual": 1e-4}, [True, False]), ({"residual": float("nan")}, [True, False])],
)  # fmt: skip
def test_a_fault_in_one_case_fails_its_verdict(cases, fault, seen):
    assert holds(study._case_verdicts([replace(cases[0], **fault), *cases[1:]], PLAN)) == seen


@pytest.mark.slow
def test_a_trajectory_knows_its_error_and_returns_of_the_crank(trajectory):
    assert trajectory.run.error.end < study.ACCURACY
    assert trajectory.returns.shape == (11, 4)
    start = trajectory.returns[0]
    assert start == pytest.approx([0, 0, study.CRANK + study.ROD, 0], abs=1e-12)
    assert np.max(np.abs(trajectory.returns[:, 2] - start[2])) < 1.5e-3 * study.DRAWN_CLEARANCE
    assert holds(study._trajectory_verdicts([trajectory])) == [True]


@pytest.mark.slow
def test_another_crank_would_be_seen(trajectory, monkeypatch):
    monkeypatch.setattr(study, "CRANK", study.CRANK * (1 + 1e-6))
    assert holds(study._trajectory_verdicts([trajectory])) == [False]


def test_differences_count_beyond_their_intervals_alone():
    def case(law, mean, half):
        return study.Case(law, True, 0.5, 5000.0, "finished", 0.0, {study.SEVERITY: (mean, half)})

    def said(*cases):
        return [verdict.text for verdict in study._apart(cases, "laws", lambda c: (c.speed,))]

    assert "in 1 of 1 comparisons, by up to 2 times" in said(case("a", 1.0, 0.4), case("b", 2.0, 0.4))[0]
    assert "in 0 of 1 comparisons" in said(case("a", 1.0, 0.6), case("b", 2.0, 0.6))[0]
    assert said(case("a", 1.0, 0.1), case("b", float("nan"), float("nan"))) == []
