"""The benchmark's own parts: references against second derivations, events, choices of the cheapest setting, and a run of two peers."""

import dataclasses
import importlib
from functools import cache

import numpy as np
import pytest
from benchmarks import programs
from benchmarks.contact import measuring, problem, report
from benchmarks.contact.problems import PROBLEMS
from benchmarks.contact.problems.balls import Balls
from benchmarks.contact.problems.balls import problem as balls
from benchmarks.contact.problems.chains import chain
from benchmarks.contact.problems.loops import END, four_bars, relative
from benchmarks.contact.problems.sweeps import sweep

pytestmark = pytest.mark.exhaustive
ROW = {"peer": "A", "outcome": "finished", "integrator": "one"}


@cache
def bouncing(**numbers):
    """One ball, short enough for CI: two impacts."""
    physics = Balls(radius=0.1, places=((0.0, 0.0, 0.5),), **numbers)
    return balls("ball", "a ball", physics, np.linspace(0.1, 0.9, 9))


def short_cradle():
    """The cradle up to .1 s, before its first impact."""
    cradle = PROBLEMS["cradle"]()
    return dataclasses.replace(cradle, grid=cradle.grid[:2])


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


SMALL = {
    "balls": bouncing,
    "cradle": lambda: short_cradle(),
    "crank": PROBLEMS["crank"],
    "belt": PROBLEMS["belt_set"],
    "chain": lambda: chain(2),
    "loops": lambda: four_bars(1),
}


def test_every_kind_of_problem_has_a_small_one():
    assert {problem().kind for problem in PROBLEMS.values()} == set(SMALL)


@pytest.mark.parametrize("kind", SMALL)
def test_the_runner_measures_every_kind_of_problem(kind, tmp_path, monkeypatch):
    """With the peers that are always installed, one setting each."""
    some = measuring.peers(("scipy_ivp", "hertzwerk_run"))
    for peer, integrator in zip(some, ("DOP853", "dop853"), strict=True):
        monkeypatch.setattr(peer, "settings", lambda problem, name=integrator: {name: (1e-9,)})
    small = SMALL[kind]()
    path = tmp_path / "rows.csv"
    measuring.write(measuring.measure(small, some, 10, rounds=1), path)
    rows = measuring.read(path)
    assert [row["outcome"] for row in rows] == ["finished"] * 2
    assert all(float(row["error"]) < 2e-6 and float(row["seconds"]) > 0 for row in rows)
    assert all(float(row["impact_error"]) < 2e-6 for row in rows) == bool(small.contacts)
    assert len(report.table(rows, (1e-5,))) == 5


@pytest.mark.parametrize("name", ["crank", "crank_friction"])
def test_the_equations_of_the_crank_are_those_of_the_digits(name):
    """In flight and in contact, at states of the digits whose rod is moved onto the surface."""
    crank = PROBLEMS[name]()
    m = crank.physics
    for t, state in zip(crank.grid, crank.digits().states, strict=True):
        (gap,) = crank.gaps(t, state, np)
        touching = gap < 0
        v0 = 2.0 if touching else None
        found = crank.rates(t, state, np.array([float(touching), 0.5]), np)
        expected = m.accelerations(t, tuple(state), v0=v0, friction=m.friction)
        assert found == pytest.approx([*state[2:], *expected], rel=1e-9, abs=1e-6)
    assert any(crank.gaps(t, y, np)[0] < 0 for t, y in zip(crank.grid, crank.digits().states, strict=True))


@pytest.mark.skipif(programs.COMPILER is None, reason="needs g++")
@pytest.mark.parametrize(
    ("name", "integrator", "limit"),
    [
        ("cpp_by_hand", "dop853", 1e-10),
        ("cvode_from_c", "adams newton", 1e-8),
        ("cvode_from_c", "bdf newton", 1e-8),
    ],
)
def test_programs_by_hand_meet_the_digits(name, integrator, limit):
    (peer,) = measuring.peers((name,))
    if not measuring.version(peer):
        pytest.skip("needs the SUNDIALS of CasADi's wheel")
    crank = PROBLEMS["crank_friction"]()
    (one,) = measuring.attempts(crank, peer, integrator, (1e-12,), 10)
    assert one.error < limit and one.impact_error < limit and one.times[0] > 0


def test_the_equations_of_the_squeezer_give_the_published_digits():
    """Those are themselves 1.1e-9 from the extrapolation, by `extrapolation.integrate` at two tolerances."""
    squeezer = PROBLEMS["squeezer"]()
    jacobian, _ = squeezer.physics.constraints(squeezer.start[:21], squeezer.start[21:])
    assert np.linalg.matrix_rank(jacobian) == 20
    (peer,) = measuring.peers(("scipy_ivp",))
    (found,) = peer.prepare(squeezer, "DOP853", 1e-7)().states
    assert found == pytest.approx(relative(END), abs=1e-6)


def test_rows_of_a_sweep_are_runs_of_their_own():
    """hertzwerk's sweep yields what each row does alone, and a loop yields rows in order."""
    (peer,) = measuring.peers(("hertzwerk_run",))
    small = sweep(bouncing())
    alone = [peer.prepare(row, "dop853", 1e-9)().states[-1] for row in small.rows[:2]]
    own = measuring.prepared(small, peer, "dop853", 1e-9)().states
    assert len(own) == len(small.rows) and np.array_equal(own[:2], alone) and own[0] != own[1]
    (other,) = measuring.peers(("scipy_ivp",))
    looped = measuring.prepared(small, other, "DOP853", 1e-9)()
    assert looped.states == pytest.approx(own, abs=1e-6) and looped.seconds > 0


def test_peers_keep_the_protocol():
    """Each has a name and a package, and settings from loose to tight of every problem that it states."""
    for peer in measuring.peers():
        assert peer.NAME and (hasattr(peer, "version") or peer.PACKAGE) and peer.__doc__
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


def test_a_peer_that_reports_no_impacts_meets_no_error_of_them():
    rows = [{**ROW, "setting": "1e-6", "error": 0.0, "impact_error": "nan", "seconds": 1}]
    assert report.best(rows, 1e-3) and report.best(rows, 1e-3, column="impact_error") is None
