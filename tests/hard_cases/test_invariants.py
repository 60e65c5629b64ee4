"""Each invariant can fail: a fault is put into a model, a run or a case, and exactly that invariant says so."""

from dataclasses import replace
from types import ModuleType

import numpy as np
import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.analysis.hard_cases import invariants, runner
from hertzwerk.runtime.analysis.hard_cases.case import HardCase, Source, final
from hertzwerk.runtime.analysis.hard_cases.tried_steps import TRIES
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.history import History

BALL = Source("bouncing_ball")
CASE = HardCase("a_case", "none", "nothing", BALL, 1.2, 1e-8, known=(final("vertical.speed", 0.0, 100.0, "anything"),))


@pytest.fixture(autouse=True)
def counted(monkeypatch):
    monkeypatch.setitem(TRIES, CASE.name, {"dop853": 500})


def broken(run, case=CASE):
    return runner.broken(case, run.outcome.name, invariants.measure(case, "dop853", run))


def run_of(model, **options):
    return simulate(model, duration=CASE.duration, tolerance=CASE.tolerance, compiled=False, **options)


def changed(**functions):
    """The ball's model with some of the module's functions exchanged, each given the original."""
    original = runner.model_of(BALL).module
    module = ModuleType("changed")
    module.__dict__.update(vars(original))
    for name, change in functions.items():
        module.__dict__[name] = change(getattr(original, name))
    return EngineModel(module)


def with_rows(run, change):
    rows = run.engine.history.rows.copy()
    change(rows, run.engine.history.integrator.layouts.state)
    return of_rows(run, rows)


def of_rows(run, rows):
    history = run.engine.history
    return replace(
        run, engine=replace(run.engine, history=History(history.model, rows, history.controls, history.integrator))
    )


def test_without_a_fault_all_hold():
    run = run_of(runner.model_of(BALL))
    assert broken(run) == ()
    names = [row.name for row in invariants.measure(CASE, "dop853", run)]
    assert names == ["not finite", "energy", "energy rising", "depth/bound", "final vertical.speed", "steps tried"]


def test_a_state_that_is_not_a_number():
    """In a rate, which nothing else is computed from."""

    def spoil(rows, layout):
        rows[5, layout["dy"].start] = np.nan

    assert broken(with_rows(run_of(runner.model_of(BALL)), spoil)) == (invariants.FINITE,)


def test_a_ledger_that_is_wrong_by_a_thousandth():
    def wrong(contact):
        def function(*arguments):
            f, dz, *rest = contact(*arguments)
            return (f, 1.001 * dz, *rest)

        return function

    run = run_of(changed(contact_floor=wrong))
    assert run.outcome.name == "energy_not_closed"
    assert broken(run) == ("outcome", invariants.ENERGY)


def test_damping_of_the_wrong_sign():
    """It feeds the ball on its way out; its ledger, honest, still closes."""

    def wrong(contact):
        def function(t, q, u, z, m, c):
            elastic, *_ = contact(t, q, 0 * u, z, m, c)
            force, dz, _, *rest = contact(t, q, u, z, m, c)
            fed = 2 * elastic - force
            return (fed, -dz, fed, *rest)

        return function

    run = run_of(changed(contact_floor=wrong), parameters={"restitution": 0.99})
    assert broken(run) == (invariants.RISING,)


def test_energy_that_rises_and_falls_again():
    """Booked, so that the ledger closes."""
    model = changed()
    run = run_of(model)

    def feed(rows, layout):
        speed, booked = layout["y"].start + 1, layout["y"].start + 2
        before = rows[3, speed] ** 2 / 2
        rows[3, speed] *= 1.001
        rows[3, booked] -= rows[3, speed] ** 2 / 2 - before

    assert broken(with_rows(run, feed)) == (invariants.RISING,)


def test_a_ball_that_goes_through_the_floor():
    """Its energy is what it was; only nobody noticed the floor, which the event function has too low."""

    def lower(gaps):
        def function(*arguments):
            gap, rate = gaps(*arguments)
            return gap + 100, rate

        return function

    assert broken(run_of(changed(gaps=lower))) == (invariants.DEPTH,)


def test_another_final_state_outcome_or_number_of_steps(monkeypatch):
    other = replace(CASE, known=(final("vertical.speed", 200.0, 100.0, "wrong"),))
    assert broken(run_of(runner.model_of(BALL)), other) == ("final vertical.speed",)
    assert broken(run_of(runner.model_of(BALL)), replace(CASE, outcome="outside_law_range")) == (runner.OUTCOME,)
    monkeypatch.setitem(TRIES, CASE.name, {"dop853": 1})
    assert broken(run_of(runner.model_of(BALL))) == (invariants.STEPS,)


def test_a_bound_of_theory_counts_instead():
    run = run_of(runner.model_of(BALL))
    tries = run.statistics.steps + run.statistics.rejected + run.statistics.retaken
    assert broken(run, replace(CASE, theory={"dop853": tries})) == ()
    assert broken(run, replace(CASE, theory={"dop853": tries - 1})) == (invariants.STEPS,)


def test_one_bit_between_the_two_paths():
    run = run_of(runner.model_of(BALL))

    def bit(rows, layout):
        del layout
        rows[2:3, 1].view(np.uint64)[0] ^= 1

    assert runner.same(run, run).holds
    assert runner.same(run, with_rows(run, bit)).value == 1
    shorter = of_rows(run, run.engine.history.rows[:-1])
    assert not runner.same(run, shorter).holds


def test_the_depth_that_stores_the_energy_is_the_closed_form():
    """A soft elastic ball: K d^2.5/2.5 = m v0^2/2 + m g d at the bottom; the measured penetration comes that near."""
    run = run_of(runner.model_of(BALL), parameters={"restitution": 1.0, "stiffness": "1e5 N/m^1.5"})
    (row,) = [row for row in invariants.measure(CASE, "dop853", run) if row.name == invariants.DEPTH]
    assert 0.9 < row.value <= 1
    bound = float(row.note.split(" of ")[1].split()[0])
    from reference import closed_forms

    exact = closed_forms.depth_with_gravity("1e5", "1.5", 1, closed_forms.drop_speed(1, "9.81"), "9.81")
    assert bound == pytest.approx(exact, rel=1e-3)


def test_a_known_failure_must_fail_as_it_says():
    known = replace(CASE, theory={"dop853": 5}, failures={("dop853", invariants.STEPS): "a low bound"})
    assert runner.result(known, "dop853", native=False).verdict == runner.KNOWN
    assert runner.result(replace(known, theory={}), "dop853", native=False).verdict == runner.FAILED
    assert runner.result(replace(CASE, theory={"dop853": 5}), "dop853", native=False).verdict == runner.FAILED
