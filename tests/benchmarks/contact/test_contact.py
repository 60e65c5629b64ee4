"""The benchmark's own parts: references against second derivations, events, choices of the cheapest setting, and a run of two peers."""

import importlib
from functools import cache

import numpy as np
import pytest
from benchmarks.contact import measuring, problem, report
from benchmarks.contact.problems import PROBLEMS
from benchmarks.contact.problems.balls import Balls
from benchmarks.contact.problems.balls import problem as balls

ROW = {"peer": "A", "outcome": "finished", "integrator": "one"}


@cache
def bouncing(**numbers):
    """One ball, short enough for CI: two impacts."""
    physics = Balls(radius=0.1, places=((0.0, 0.0, 0.5),), **numbers)
    return balls("ball", "a ball", physics, np.linspace(0.1, 0.9, 9))


def elastic(problem):
    """Heights of a ball without loss in closed form: parabolas, and arcs of a spring that also weighs."""
    p = problem.physics
    height = p.places[0][2] - p.radius
    speed, w = np.sqrt(2 * p.gravity * height), np.sqrt(p.stiffness / p.mass)
    sag = p.mass * p.gravity / p.stiffness
    fall = speed / p.gravity
    # d = sag + a sin(w t - b) from d = 0 at the speed of the fall
    a, b = np.hypot(sag, speed / w), np.arctan2(sag, speed / w)
    touch = (np.pi + 2 * b) / w
    onsets = [fall + k * (touch + 2 * fall) for k in range(9)]

    def z(t):
        k = sum(t >= onset for onset in onsets) - 1
        if k < 0:
            return p.radius + height - p.gravity * t**2 / 2
        s = t - onsets[k]
        if s < touch:
            return p.radius - sag - a * np.sin(w * s - b)
        s -= touch
        return p.radius + speed * s - p.gravity * s**2 / 2

    return np.array([[z(t)] for t in problem.times]), [t for t in onsets if t < problem.times[-1]]


def test_the_reference_is_the_closed_form_without_loss():
    lossless = bouncing(loss=0.0)
    states, onsets = elastic(lossless)
    exact = problem.Result(states, lambda: np.array(onsets))
    assert len(onsets) == 2
    assert max(lossless.errors(exact)) < 1e-13


def test_a_reference_of_other_stiffness_is_found():
    """The seeded fault: a part in a million of the stiffness."""
    states, onsets = elastic(bouncing(loss=0.0))
    other = bouncing(loss=0.0, stiffness=1e5 * (1 + 1e-6))
    assert min(other.errors(problem.Result(states, lambda: np.array(onsets)))) > 1e-9


def test_two_peers_meet_the_reference_and_are_measured(tmp_path):
    some = measuring.peers(("scipy_ivp", "hertzwerk_run"))
    rows, short = [], bouncing()
    for peer, integrator in zip(some, ("DOP853", "dop853"), strict=True):
        rows += measuring.attempts(short, peer, integrator, (1e-5, 1e-8), 10)
    assert [
        one.error < limit and one.impact_error < limit for one, limit in zip(rows, (1e-3, 1e-6) * 2, strict=True)
    ] == [True] * 4
    assert all(one.times[0] > 0 for one in rows)


def test_peers_keep_the_protocol():
    """Each has a name and a package, and settings from loose to tight of every problem that it states."""
    for peer in measuring.peers():
        assert peer.NAME and peer.PACKAGE and peer.__doc__
        for name in PROBLEMS:
            for values in peer.settings(PROBLEMS[name]()).values():
                assert list(values) == sorted(values, reverse=True)


def test_a_peer_that_is_missing_is_reported(monkeypatch):
    peer = importlib.import_module("benchmarks.contact.peers.drake_multibody")
    monkeypatch.setattr(peer, "PACKAGE", "no_such_package")
    monkeypatch.setattr(peer, "MODULE", "no_such_package", raising=False)
    (row,) = measuring.measure(bouncing(), [peer], 1)
    assert row["outcome"] == "missing: not installed" and row["seconds"] == ""


def test_another_number_of_impacts_is_no_error_of_their_times():
    one = bouncing()
    assert one.errors(problem.Result(one.reference.states, lambda: np.array([0.28])))[1] == np.inf
    assert np.isnan(one.errors(problem.Result(one.reference.states))[1])


@pytest.mark.parametrize(
    ("errors", "expected"),
    [((1e-2, 1e-4, 1e-6), 2.0), ((1e-5, 1e-2, 1e-6), 3.0), ((1e-2, 1e-2, 1e-2), None)],
    ids=["the loosest that meets it", "a lucky one does not count", "none"],
)
def test_the_cheapest_setting_meets_the_error_with_all_tighter_ones(errors, expected):
    rows = [{**ROW, "setting": f"1e-{k}", "error": error, "seconds": k} for k, error in enumerate(errors, start=1)]
    found = report.best(rows, 1e-3)
    assert (found and found.seconds) == expected


def test_the_page_is_that_of_the_results():
    assert report.PAGE.read_text("utf-8") == report.page()
