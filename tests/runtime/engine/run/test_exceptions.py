"""What is raised while a run is under way ends it, and loses nothing that was computed; tries in vain end it, too."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from commands import called

from hertzwerk.runtime import Solution, simulate
from hertzwerk.runtime.engine.model import caller
from hertzwerk.runtime.engine.run import recorder
from hertzwerk.runtime.engine.run.built_engine import engine_for
from hertzwerk.runtime.engine.run.recorder import Recorder
from hertzwerk.runtime.engine.solution import step_observers
from hertzwerk.runtime.loading import engine_model

ASKED = {"duration": "5 s", "tolerance": 1e-12, "compiled": False}


@pytest.fixture(scope="module")
def whole(ball):
    return simulate(ball, **ASKED)


def failing(monkeypatch, after, error):
    """The engine's chunks raise an error from the call after so many on."""
    evaluate, calls = caller.Caller.__call__, []

    def call(self):
        if self.results[0].shape[0] == 256 and len(self.results) > 1:  # of a chunk
            calls.append(self)
            if len(calls) > after:
                raise error
        return evaluate(self)

    monkeypatch.setattr(caller.Caller, "__call__", call)


@pytest.mark.parametrize("error", [MemoryError(), RuntimeError("Error in Function::call")])
def test_an_exception_keeps_the_steps_before_it_and_goes_on_from_there(error, ball, whole, monkeypatch):
    with monkeypatch.context() as patched:
        failing(patched, 2, error)
        run = simulate(ball, **ASKED)
    assert run.outcome.name == "exception"
    assert f"{type(error).__name__} in call (test_exceptions.py, line " in run.outcome.message
    count = len(run.t)
    assert 100 < count <= 513
    assert np.array_equal(run.engine.history.rows[:-1], whole.engine.history.rows[: count - 1])
    rest = run.continued(compiled=False)
    assert np.array_equal(rest.engine.history.rows[-1], whole.engine.history.rows[-1])


def test_an_exception_ends_a_run_of_the_reference_methods(ball):
    def broken(fraction):
        if fraction > 0.1:
            raise ValueError("no such bar")

    run = simulate(ball, **ASKED, method="cvodes", progress=broken)
    assert run.outcome.name == "exception"
    assert "ValueError in broken" in run.outcome.message
    assert 0.5 <= run.engine.t_end < 1


def test_exceptions_before_the_first_step_are_raised(ball, monkeypatch):
    failing(monkeypatch, 0, MemoryError())
    with pytest.raises(MemoryError):
        simulate(ball, **ASKED)


def test_an_exception_of_a_run_that_checks_leaves_the_run_it_checks(ball, monkeypatch):
    options = {"duration": "5 s", "accuracy": 1e-6, "compiled": False}
    calls = len(simulate(ball, **options).t) // 128
    failing(monkeypatch, calls, MemoryError())
    run = simulate(ball, **options)
    assert run.outcome.name == "exception"
    assert run.engine.t_end == 5
    assert run.outcome.message.startswith("the run is complete")


def test_an_observer_that_fails_takes_no_row_from_the_others(ball, whole, monkeypatch):
    """Of a grid what is found fails at its third block: the states of all steps until then are kept."""
    monkeypatch.setattr("hertzwerk.runtime.engine.run.single_run.BLOCK", 1)
    take, seen = step_observers.Findings.take, []

    def fails(self, block, fresh):
        seen.append(block.t[-1])
        if len(seen) == 3:
            raise MemoryError
        take(self, block, fresh)

    monkeypatch.setattr(step_observers.Findings, "take", fails)
    run = simulate(ball, **ASKED, grid=1000)
    assert run.outcome.name == "exception"
    assert run.engine.t_end == seen[2]
    assert np.array_equal(run.t, np.linspace(0, 5, 1000)[np.linspace(0, 5, 1000) <= run.engine.t_end])
    assert len(seen) == 3
    assert run.engine.checkpoint is None


def test_a_recorder_short_of_memory_keeps_the_first_rows(monkeypatch):
    concatenate, taken = np.concatenate, []

    def most(parts):
        if len(parts) > 3:
            raise MemoryError
        return concatenate(parts)

    class Keeps:
        def take(self, block, known):
            taken.append(block)

    kept = Recorder(lambda rows: rows, [Keeps()], None)
    for i in range(10):
        kept.keep(np.full((1, 2), float(i)))
    monkeypatch.setattr(np, "concatenate", most)
    with pytest.raises(MemoryError):
        kept.flush()
    assert [row[0] for row in taken[0]] == [0, 1]
    kept.flush()
    assert len(taken) == 1


def test_a_run_ends_before_its_steps_fill_the_memory(monkeypatch):
    """Half a megabyte is left: where the system hands out more than it has, no allocation fails."""
    options = {"duration": "50 ms", "tolerance": 1e-9, "compiled": False}
    crank = engine_model("slider_crank")
    whole = simulate(crank, **options)
    monkeypatch.setattr(recorder, "MANY", 2**18)
    monkeypatch.setattr(recorder, "available", lambda: 2.0**19)
    run = simulate(crank, **options)
    assert run.outcome.name == "exception"
    assert "MemoryError" in run.outcome.message
    assert "keep a grid" in run.outcome.remedy
    assert 2**19 < run.engine.history.rows.nbytes < 2**20
    assert np.array_equal(run.engine.history.rows, whole.engine.history.rows[: len(run.t)])
    assert simulate(crank, **options, grid=100).outcome.finished


@pytest.mark.exhaustive
@pytest.mark.skipif(sys.platform != "linux", reason="the limit of memory is Linux's")
def test_a_run_that_takes_all_memory_is_kept_and_saved(tmp_path):
    code = (
        "import resource, sys\n"
        "from hertzwerk.runtime import load, simulate\n"
        "ball = load('bouncing_ball')\n"
        "simulate(ball, duration='1 s', tolerance=1e-6, compiled=False)\n"
        "size = int(open('/proc/self/statm').read().split()[0]) * resource.getpagesize()\n"
        "resource.setrlimit(resource.RLIMIT_AS, (size + 60_000_000,) * 2)\n"
        "run = simulate(ball, duration=1e9, tolerance=1e-12, compiled=False, max_steps=10**9)\n"
        "run.save(sys.argv[1])\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, tmp_path / "run.npz"], capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    run = Solution.load(tmp_path / "run.npz")
    assert (run.outcome.name, "MemoryError" in run.outcome.message) == ("exception", True)
    assert len(run.t) > 10_000


def test_the_command_line_writes_what_there_is(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    failing(monkeypatch, 1, MemoryError("no room"))
    assert "no room" in called("run", "slider_crank", "--no-plots", "--out", "out", code=1).output
    assert json.loads(Path("out/run.json").read_text())["outcome"] == "exception"
    assert len(np.load("out/states.npz")["rows" if "rows" in np.load("out/states.npz") else "t"])


@pytest.mark.timeout(60)
def test_a_run_that_rejects_for_ever_ends(ball, monkeypatch):
    evaluate = caller.Caller.__call__

    def rejects(self):
        results = evaluate(self)
        states = results[0]
        if states.shape[0] == 256:
            before, layout = self.inputs[0], engine_for(ball, "dop853", False).integrator.layouts.state
            states[:] = before
            states[:, layout["accepted"]] = 0
            states[:, layout["rejected"]] += np.arange(1, 257)[:, None]
        return results

    simulate(ball, method="dop853", **ASKED)
    monkeypatch.setattr(caller.Caller, "__call__", rejects)
    run = simulate(ball, **ASKED, method="dop853", max_steps=5000)
    assert run.outcome.name == "too_many_steps"
    assert run.statistics.steps == 0
    assert 5000 < run.statistics.rejected <= 5256
    assert f": 0 steps accepted, {run.statistics.rejected:,} rejected, max_steps = 5,000" in run.outcome.message
