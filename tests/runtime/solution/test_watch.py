"""Steps are followed by functions of blocks, as C too: against row after row, against the virtual machine, and against a plain loop."""

import numpy as np
import pytest

from hertzwerk.runtime import load
from hertzwerk.runtime.integrate.loop.compiled import available
from hertzwerk.runtime.run.engine import engine_for, prepare
from hertzwerk.runtime.run.request import Settings
from hertzwerk.runtime.simulation import solve
from hertzwerk.runtime.solution import findings, watch
from hertzwerk.runtime.solution.findings import Needs

SETTINGS = Settings("6 ms", None, 1e-6, compiled=False)
WANTED = Needs.IMPACTS | Needs.SUMS


@pytest.fixture(scope="module")
def run():
    return solve(load("slider_crank"), SETTINGS, {}, {})


def found(model):
    solution = solve(model, SETTINGS, {}, {}, needs=WANTED)
    sums = solution.findings.sums()
    return solution.impacts, solution.energy_residual, sums.impulse.tolist(), sums.largest.tolist(), solution.warnings


@pytest.mark.skipif(not available(), reason="no C compiler")
def test_what_is_found_as_c_is_bitwise_what_is_found_without(run):
    model = load("slider_crank")
    before = found(model)
    finders = findings.finders(model, engine_for(model, SETTINGS.method, False).integrator, WANTED)
    assert not any(finder.compiled for finder in finders)
    assert prepare(model, SETTINGS.method, True, needs=WANTED)
    assert all(finder.compiled for finder in finders)
    assert found(model) == before
    assert before[0] == run.impacts
    assert len(before[0]) > 5


@pytest.mark.parametrize("count", [1, 31, 32, 33, 256, 290])
def test_a_table_is_followed_as_its_rows_one_after_another(run, count):
    follow, rows = watch.following(run.model, run.history.engine), run.history.rows[-count:]
    carried = np.zeros(watch.carried(run.model).size)
    whole = follow(carried, rows)
    for row, expected in zip(rows, whole, strict=True):
        (carried,) = follow(carried, row[None])
        np.testing.assert_array_equal(carried, expected)


def test_contacts_are_those_of_a_plain_loop(run):
    """Onset, approach speed, and duration, from the histories; a peak is no less than any row's."""
    mode, t, rate = (run[name] for name in ("slider_pin.mode", "t", "slider_pin.gap_rate"))
    expected, begin = [], None
    for i in range(len(t)):
        if begin is None and mode[i] == 1:
            begin = i
        elif begin is not None and mode[i] == 0:
            within = slice(begin, i)
            expected.append((t[begin], -rate[begin], t[i] - t[begin], within))
            begin = None
    finished = [impact for impact in run.impacts if impact.duration is not None]
    assert [(impact.t, impact.speed, impact.duration) for impact in finished] == [each[:3] for each in expected]
    for impact, (*_, within) in zip(finished, expected, strict=True):
        for peak, name in ((impact.peak_force, "normal_force"), (impact.peak_penetration, "penetration")):
            largest = run[f"slider_pin.{name}"][within].max()
            assert largest <= peak <= 1.2 * largest
