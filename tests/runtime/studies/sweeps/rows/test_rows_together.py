"""Rows that are done together, stage by stage, are those that are done one by one, bitwise; what ends one spares the others."""

import math
from dataclasses import replace

import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.run.run_request import Settings
from hertzwerk.runtime.engine.solution.impacts import peaks
from hertzwerk.runtime.engine.solution.step_observers import Findings
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.simulation import solving
from hertzwerk.runtime.studies.sweeps.rows.row_job import Job
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import chosen, own

ASKED = ["impacts", "peak_force", "slider_pin.max_penetration", "slider_pin.impact_rate", "energy_residual"]
SETTINGS = Settings("6 ms", None, 1e-6, compiled=False, max_steps=320)
TASKS = (
    (0, {"clearance": "0.3 mm"}),
    (1, {"clearance": "-1 mm"}),  # bad input
    (2, {"clearance": "0.2 mm"}),
    (3, {"clearance": "0.02 mm"}),  # too many steps
    (4, {"clearance": "0.5 mm"}),  # its output raises
    (5, {"clearance": "0.45 mm"}),
)


@pytest.fixture(scope="module")
def job():
    model = engine_model("slider_crank")

    def only_small(run):
        if run.settings.parameters["clearance"][0] > 0.48:
            raise ArithmeticError("large")
        return run.impacts[0].t

    return Job(model, SETTINGS, [*chosen(model, ASKED, []), own("first", only_small)])


def timeless(row):
    """A row without its time."""
    texts = {name: None if math.isnan(x) else x for name, x in row.outputs.items()}
    return replace(row, wall_s=0.0, outputs=texts)


def plain(job):
    return [timeless(row) for row in job.do(*TASKS)]


@pytest.fixture(scope="module")
def alike(job):
    """The same job without a function of the user, and its rows."""
    made = replace(job, outputs=job.outputs[: len(ASKED)])
    return made, plain(made)


def test_rows_done_together_are_those_done_alone_and_the_runs_themselves(job):
    together, alone = job.do(*TASKS), [row for task in TASKS for row in job.do(task)]
    assert list(map(timeless, together)) == list(map(timeless, alone))
    outcomes = [row.outcome for row in together]
    assert (outcomes[0], outcomes[1], outcomes[2], outcomes[5]) == ("finished", "bad_input", "finished", "finished")
    assert outcomes[3:5] == ["too_many_steps", "bad_output"]
    for row in (together[0], together[2], together[5]):
        run = simulate(job.model, duration="6 ms", tolerance=1e-6, parameters=dict(row.stated), compiled=False)
        result = (len(run.impacts), max(impact.peak_force for impact in run.impacts), run.energy_residual)
        assert tuple(row.outputs[name] for name in ("impacts", "peak_force", "energy_residual")) == result


def test_peaks_are_the_same_in_pieces_of_any_size_for_all_rows_at_once(alike, monkeypatch):
    many, expected = alike
    monkeypatch.setattr("hertzwerk.runtime.engine.solution.contact_watch.PIECE", 7)
    monkeypatch.setattr("hertzwerk.runtime.engine.solution.contact_watch.TOGETHER", 2)
    assert plain(many) == expected


def test_peaks_of_all_rows_are_one_call_with_the_numbers_of_each(alike, monkeypatch):
    (job, expected), calls = alike, []

    def counted(history, controls, *tables):
        calls.append(len(controls))
        return peaks(history, controls, *tables)

    monkeypatch.setattr("hertzwerk.runtime.engine.solution.contact_watch.peaks", counted)
    assert plain(job) == expected
    assert len(calls) == 1 < calls[0]

    def seeded(history, controls, *tables):
        return peaks(history, 0 * controls + controls[0], *tables)  # of the first row for all

    monkeypatch.setattr("hertzwerk.runtime.engine.solution.contact_watch.peaks", seeded)
    assert plain(job) != expected


def test_long_runs_are_followed_as_they_proceed_and_hold_no_block(alike, monkeypatch):
    (job, expected), find, waiting = alike, Findings.find_impacts, []

    def seen(runs):
        waiting.append([len(run._watch.waiting) for run in runs])
        find(runs)

    monkeypatch.setattr(Findings, "find_impacts", staticmethod(seen))
    job.do(*TASKS)
    monkeypatch.setattr("hertzwerk.runtime.engine.solution.contact_watch.FEW", 100)
    assert plain(job) == expected
    assert all(waiting[0])
    assert not any(waiting[1])


def test_rows_that_fail_together_are_computed_one_by_one(alike, monkeypatch):
    (job, expected), find = alike, Findings.find_impacts

    def fails(runs):
        if len(runs) > 1:
            runs[0]._watch.waiting.clear()  # it was under way
            raise MemoryError
        find(runs)

    monkeypatch.setattr(Findings, "find_impacts", staticmethod(fails))
    assert plain(job) == expected


@pytest.mark.parametrize("stage", [0, 1, 2])
def test_an_error_in_any_stage_is_that_of_its_row_alone(job, stage, monkeypatch):
    def fails(model, settings, parameters, initial, **options):
        stages = solving(model, settings, parameters, initial, **options)
        for _ in range(stage):
            yield next(stages)
        if parameters["clearance"] == "0.2 mm":
            raise ArithmeticError("seeded")
        return (yield from stages)

    expected = plain(job)
    monkeypatch.setattr("hertzwerk.runtime.studies.sweeps.rows.row_job.solving", fails)
    actual = plain(job)
    assert (actual[2].outcome, actual[2].message) == ("failed", "ArithmeticError: seeded")
    assert actual[:2] + actual[3:] == expected[:2] + expected[3:]


def test_stopping_the_sweep_stops_all_rows_done_together(job):
    job.stop.value = 1
    try:
        with pytest.raises(KeyboardInterrupt):
            job.do(*TASKS)
    finally:
        job.stop.value = 0


def test_a_limit_of_time_is_that_of_each_row(job):
    """What needs one call of the loop alone has ended before anybody looks at the time."""
    limited = replace(job, settings=replace(SETTINGS, wall_time=1e-9))
    together, alone = limited.do(*TASKS), [row for task in TASKS for row in limited.do(task)]
    assert [row.outcome for row in together] == [row.outcome for row in alone]
    assert {"finished", "wall_time_limit"} < {row.outcome for row in together}
