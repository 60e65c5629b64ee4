"""What a run costs beyond its evaluations, counted: no clock tells it on a loaded machine, and it creeps in unnoticed."""

import sys

import numpy as np
import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.loop.attempt import integrator
from hertzwerk.runtime.engine.integration.loop.chunk import chunk
from hertzwerk.runtime.engine.integration.loop.method_choice import Choosing
from hertzwerk.runtime.engine.integration.loop.plain_attempt import advance
from hertzwerk.runtime.engine.integration.loop.tally import tally
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.integration.step.layout import FINISHED, layouts
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS
from hertzwerk.runtime.engine.model.caller import Caller
from hertzwerk.runtime.engine.run.recorder import Recorder
from hertzwerk.runtime.engine.run.single_run import SingleRun
from hertzwerk.runtime.loading import engine_model

FLIGHT, CONTACT = (), (0,)
BEYOND = {FLIGHT: 598, CONTACT: 769}  # operations of a dop853 step, most for sums of slopes and two error norms
PER_CHUNK = 28  # calls in Python
PER_RUN = 620
PER_RUN_CASADI = 12  # what reads the input, the start, the limits of approach speeds
ATTEMPTS = 256  # per chunk


def beyond_evaluations(model, contacts, choosing=Choosing.NONE):
    """Operations of a step that are not its right-hand side's; stages share some, so it may do with less than it calls."""
    (table,) = (table() for table in METHODS["dop853"])
    step, right = advance(model, layouts(model), table, contacts, choosing), flow(model, contacts)
    within = (table.stages - 1) * right.rates.n_instructions() + right.ends.n_instructions()
    return step.n_instructions() - within


@pytest.fixture(scope="module")
def crank():
    return engine_model("slider_crank_frictionless", without=("energy_ledger",))


@pytest.mark.parametrize("contacts", BEYOND)
def test_a_step_does_little_beyond_its_evaluations(crank, contacts):
    assert beyond_evaluations(crank, contacts) <= BEYOND[contacts]
    seeded = beyond_evaluations(crank, contacts, Choosing.ON_SUSPICION)  # what `auto` asks, paid by every method
    assert seeded > BEYOND[contacts]


def test_an_attempt_does_little_beyond_what_it_calls(crank):
    tables = tuple(table() for table in METHODS["dop853"])
    assert integrator(crank, tables).attempt.n_instructions() <= 9  # 23 where it chooses among the cases of two tables


def counted(model, duration):
    """Calls in Python and calls of CasADi functions in a run, and its chunks."""
    calls = {"python": 0, "casadi": 0}

    def count(frame, event, _):
        calls["python"] += event in ("call", "c_call")
        calls["casadi"] += event == "call" and frame.f_code is Caller.__call__.__code__

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        run = simulate(model, duration=duration, tolerance=1e-6, method="dop853", compiled=False)
    finally:
        sys.setprofile(before)
    made = run.statistics
    return calls, -(-(made.steps + made.rejected + made.retaken) // ATTEMPTS)


def cost(model):
    """Calls per chunk, and beside the chunks, in Python and of CasADi functions."""
    simulate(model, duration="1 ms", tolerance=1e-6, method="dop853", compiled=False)
    (few, first), (many, last) = counted(model, "12 ms"), counted(model, "120 ms")
    slope = {kind: (many[kind] - few[kind]) / (last - first) for kind in few}
    return slope, {kind: few[kind] - first * slope[kind] for kind in few}


def within_bounds(model):
    per_chunk, per_run = cost(model)
    return (
        per_chunk["casadi"] == 1
        and per_chunk["python"] <= PER_CHUNK
        and per_run["casadi"] <= PER_RUN_CASADI
        and per_run["python"] <= PER_RUN
    )


def row_by_row(recorder, rows):
    for row in rows:
        gather(recorder, row[None])


gather, outcome = Recorder.keep, SingleRun.outcome


def test_a_run_costs_few_calls_beyond_its_chunks(crank, monkeypatch):
    assert within_bounds(crank), cost(crank)
    with monkeypatch.context() as seeded:
        seeded.setattr(Recorder, "keep", row_by_row)
        assert not within_bounds(crank)
    with monkeypatch.context() as seeded:  # every step followed for impacts that nobody asked for
        seeded.setattr(SingleRun, "outcome", lambda run, trace: (trace.findings.impacts, outcome(run, trace))[1])
        assert not within_bounds(crank)


def test_attempts_after_the_end_are_passed_over_and_change_nothing(crank):
    """A nested chunk against one that calls every attempt, from a start that ends within its first calls."""
    run = simulate(crank, duration="20 us", tolerance=1e-3, method="dop853")
    made, history = run.engine.history.engine, run.engine.history
    given = history.rows[0], history.controls, tally(crank).first(history.rows[0], history.controls)[0]
    nested, flat = (chunk(made, sizes).call(given) for sizes in ((4, 4), (16,)))
    assert int(nested[0][made.layouts.state.places["status"], 3]) == FINISHED
    for passed, called in zip(nested, flat, strict=True):
        np.testing.assert_array_equal(passed.full(), called.full())
