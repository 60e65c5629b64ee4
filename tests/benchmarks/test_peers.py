"""The peers give the reference's answer, or comparing their times would say nothing; and equal error is found where it is."""

import numpy as np
import pytest
from benchmarks import exudyn_crank, programs
from benchmarks.equal_error import ERROR_AT, crossing

from reference.slider_crank import reference

pytestmark = pytest.mark.by_turns(2)  # methods and sizes that run the same code


@pytest.mark.skipif(programs.sundials() is None, reason="needs g++ and CasADi's SUNDIALS")
@pytest.mark.parametrize("friction", [False, True])
@pytest.mark.parametrize(
    ("formula", "solver", "error"),
    [("adams", "functional", 2e-6), ("adams", "newton", 2e-6), ("bdf", "functional", 4e-6), ("bdf", "newton", 4e-6)],
)
def test_cvode_meets_the_reference(friction, formula, solver, error):
    truth = reference(friction)
    run = programs.cvode(formula, solver, 1e-12, friction=friction, time=ERROR_AT)
    assert truth.error(ERROR_AT, tuple(run["state"])) < error
    assert run["impacts"] == sum(hit.onset < ERROR_AT for hit in truth.impacts)
    assert run["evaluations"] > 10_000


@pytest.mark.slow
@pytest.mark.parametrize("friction", [False, True])
@pytest.mark.parametrize(("method", "error"), [("LSODA", 2e-4), ("DOP853", 1e-5), ("Radau", 1e-5)])
def test_solve_ivp_meets_the_reference(friction, method, error):
    from benchmarks.contenders import scipy

    state = scipy(method, friction, compiled=False).state(ERROR_AT, 1e-9)
    assert reference(friction).error(ERROR_AT, tuple(state)) < error


@pytest.mark.slow
@pytest.mark.skipif(not exudyn_crank.INSTALLED, reason="needs exudyn")
def test_exudyn_meets_the_reference():
    """Before impacts amplify what is left, and after."""
    truth = reference(False)
    assert truth.error(0.001, tuple(exudyn_crank.state(0.001, 1e-7))) < 1e-4
    assert truth.error(ERROR_AT, tuple(exudyn_crank.state(ERROR_AT, 1e-7))) < 2e-2


# ---- equal error -----------------------------------------------------------------------------------------------------

TOLERANCES = 10.0 ** -np.arange(2, 10, 0.25)


def test_the_crossing_of_a_line_is_where_the_line_crosses():
    assert crossing(TOLERANCES, 300 * TOLERANCES, 5e-5, reach=2) == pytest.approx(5e-5 / 300, rel=1e-12)


def test_one_tolerance_is_neither_lucky_nor_unlucky():
    """The tolerance just before the crossing comes out far too well, a tight one far too badly."""
    errors = 300 * TOLERANCES
    last = np.flatnonzero(errors > 5e-5)[-1]
    errors[last], errors[last + 6] = 1e-9, 1.0
    assert crossing(TOLERANCES, errors, 5e-5, reach=2) == pytest.approx(5e-5 / 300, rel=0.4)


def test_a_loose_tolerance_counts_only_with_all_tighter_ones():
    errors = 300 * TOLERANCES
    errors[:8] = 1e-9  # where the error is no longer that of the run asked for
    assert crossing(TOLERANCES, errors, 5e-5, reach=2) == pytest.approx(5e-5 / 300, rel=1e-12)


def test_an_accuracy_never_reached_has_no_tolerance():
    assert crossing(TOLERANCES, 300 * TOLERANCES, 1e-9, reach=2) is None
    assert crossing(TOLERANCES, np.where(TOLERANCES > 1e-5, np.inf, 300 * TOLERANCES), 1.0, reach=2) <= 1e-5
