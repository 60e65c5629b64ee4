"""Counts, not seconds: what a row computes beside its loop does not grow with the run, unless its outputs ask for it."""

from collections import Counter

import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.model.caller import Caller
from hertzwerk.runtime.engine.run import recorder
from hertzwerk.runtime.engine.run.run_request import Settings
from hertzwerk.runtime.engine.solution.hertz_validity import beyond_theory
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps.rows.row_job import Job
from hertzwerk.runtime.studies.sweeps.rows.row_outputs import chosen, finals

BESIDE = 12  # calls of a function beside the loop's: constants, start, scales, limits, first state and its tally


@pytest.fixture(scope="module")
def model():
    return engine_model("slider_crank")


def calls(model, monkeypatch, duration, outputs=()):
    """Calls of compiled functions by a row, by name without the size of a block, once everything is built."""
    wanted = chosen(model, outputs, []) if outputs else finals(model)
    job = Job(model, Settings(duration, None, 1e-6, compiled=False), wanted)
    assert job.do((0, {"clearance": "0.3 mm"}))[0].outcome == "finished"
    counted, evaluate = Counter(), Caller.__call__

    def call(self):
        counted[self.name.rstrip("_0123456789")] += 1
        return evaluate(self)

    with monkeypatch.context() as patch:
        patch.setattr(Caller, "__call__", call)
        assert job.do((1, {"clearance": "0.31 mm"}))[0].outcome == "finished"
    return counted


def test_a_row_of_final_states_calls_little_beside_its_loop_however_long_it_is(model, monkeypatch):
    short, long = (calls(model, monkeypatch, duration) for duration in ("6 ms", "24 ms"))
    beside = [sum(n for name, n in counted.items() if not name.startswith("chunk")) for counted in (short, long)]
    assert beside[0] == beside[1] <= BESIDE
    assert not {"crest", "inner"} & long.keys()
    assert 0 < long["chunk_auto"] <= len(range(0, 2000, 256))


def test_the_count_sees_what_is_found_where_outputs_ask_for_it(model, monkeypatch):
    """The fault that the test above has to notice: a row that follows its contacts."""
    actual = calls(model, monkeypatch, "24 ms", ("impacts", "peak_force"))
    assert actual["crest"] > 0


def test_no_attempt_is_passed_on_for_final_states(model, monkeypatch):
    passed, keep = [], recorder.Recorder.keep

    def keeping(self, rows):
        passed.append(len(rows))
        keep(self, rows)

    monkeypatch.setattr(recorder.Recorder, "keep", keeping)
    (row,) = Job(model, Settings("24 ms", None, 1e-6, compiled=False), finals(model)).do((0, {"clearance": "0.3 mm"}))
    assert row.outcome == "finished"
    assert passed == [2]  # the first and the last state


def test_findings_of_the_loop_are_bitwise_those_of_a_run_with_steps(model):
    given = {"clearance": "0.3 mm"}
    states = ("guide.travel", "slider_pin_friction.dissipated")
    wanted = chosen(model, ["energy_residual", *(f"final.{name}" for name in states)], [])
    (row,) = Job(model, Settings("24 ms", None, 1e-6, compiled=False), wanted).do((0, given))
    run = simulate(model, duration="24 ms", tolerance=1e-6, parameters=given, compiled=False)
    assert list(row.outputs.values()) == [run.energy_residual, *(run.engine.final[name] for name in states)]
    of_steps = [*beyond_theory(run.engine.validity)]  # found where steps are looked at, as these are
    of_steps += [text for text in run.warnings if "exceed the damping law" in text]
    assert [*of_steps, *row.warnings] == list(run.warnings)
    assert any("exceed the law's limit" in text for text in row.warnings)


def test_a_long_row_followed_in_blocks_has_the_outputs_of_one_block(model, monkeypatch):
    """Its time is counted from its start, not from that of its last block."""
    outputs = ["slider_pin.impact_rate", "slider_pin.mean_peak_force", "slider_pin.mean_largest_force"]
    job = Job(model, Settings("48 ms", None, 1e-4, compiled=False), chosen(model, outputs, []))
    (whole,) = job.do((0, {}))
    monkeypatch.setattr("hertzwerk.runtime.engine.run.single_run.BLOCK", 50_000)
    (row,) = job.do((0, {}))
    assert (row.outcome, row.message) == ("finished", "")
    assert row.outputs == pytest.approx(whole.outputs, rel=1e-12, nan_ok=True)
    assert row.outputs["slider_pin.impact_rate"] > 0
