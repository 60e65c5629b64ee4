"""compiled="auto": short runs stay in the virtual machine, long ones go on as C, and no digit changes."""

import copy
import itertools
from types import SimpleNamespace

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Solution, load, simulate, simulation
from hertzwerk.runtime.engine.integration.loop import automatic_compilation, c_compilation, chunk
from hertzwerk.runtime.engine.integration.loop.c_files import CFile
from hertzwerk.runtime.loading import engine_model


@pytest.fixture
def crank(tmp_path, monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))
    return load(copy.copy(engine_model("slider_crank_frictionless")))


@pytest.fixture
def eager(monkeypatch):
    """Any time ahead is worth a compilation."""
    monkeypatch.setattr(automatic_compilation, "LOOK", 0.0)
    monkeypatch.setattr(automatic_compilation, "GAIN", 1e9)
    monkeypatch.setattr(automatic_compilation, "SURE", 0.0)


@pytest.fixture
def clock(monkeypatch):
    """Every chunk takes 10 ms, whatever the machine does."""

    def ticking():
        return itertools.count(step=0.01).__next__

    faked = SimpleNamespace(perf_counter=ticking(), thread_time=ticking())
    for module in (chunk, simulation):
        monkeypatch.setattr(module, "time", faked)


def test_a_short_run_is_not_compiled_and_other_values_of_compiled_are_refused(crank, clock, tmp_path):
    run = simulate(crank, duration="24 ms", tolerance=1e-8)
    assert not run.settings.compiled
    assert run.statistics.compile_s == 0
    assert not (tmp_path / "cache").exists()
    with pytest.raises(InputError, match="auto"):
        simulate(crank, duration="1 ms", compiled="always", tolerance=1e-6)


def test_a_run_changes_to_c_on_the_way_and_no_bit_changes(crank, eager, tmp_path):
    options = {"duration": "24 ms", "tolerance": 1e-8}
    machine = simulate(crank, compiled=False, **options)
    run = simulate(crank, **options)
    assert run.settings.compiled
    assert run.statistics.compile_s > 0.05
    assert run.statistics.wall_s < run.statistics.compile_s
    assert np.array_equal(machine.engine.history.rows, run.engine.history.rows)
    assert Solution.load(run.save(tmp_path / "run.npz")).statistics == run.statistics
    again = simulate(crank, **options)  # from the start on
    assert again.settings.compiled
    assert again.statistics.compile_s == 0
    assert np.array_equal(machine.engine.history.rows, again.engine.history.rows)
    assert not simulate(crank, compiled=False, **options).settings.compiled


def test_a_cached_library_is_used_at_once(crank, monkeypatch):
    simulate(crank, duration="1 ms", compiled=True, tolerance=1e-6)
    monkeypatch.setattr(automatic_compilation, "LOOK", 0.0)
    monkeypatch.setattr(c_compilation, "compile_files", None)  # a call of it fails
    assert simulate(copy.copy(crank.engine), duration="24 ms", tolerance=1e-8).settings.compiled


def test_without_a_compiler_it_goes_on(crank, eager, monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    c_compilation._compiler.cache_clear()
    run = simulate(crank, duration="24 ms", tolerance=1e-8)
    c_compilation._compiler.cache_clear()
    assert run.outcome.finished
    assert not run.settings.compiled


def test_clang_gets_no_option_that_it_refuses(crank, tmp_path, monkeypatch):
    """A compiler that says it is clang and, as clang 22 does, refuses -fno-tree-pre."""
    script = tmp_path / "clang"
    refuses = 'case "$*" in *-fno-tree-pre*) exit 1;; esac'
    script.write_text(f'#!/bin/sh\n[ "$1" = --version ] && echo clang version 22 && exit\n{refuses}\nexec cc "$@"\n')
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path))
    c_compilation._compiler.cache_clear()
    try:
        assert simulate(copy.copy(crank.engine), duration="1 ms", tolerance=1e-6, compiled=True).settings.compiled
    finally:
        c_compilation._compiler.cache_clear()


@pytest.fixture
def wanted(clock, monkeypatch):
    """How long a run had to go whenever it asked whether to compile."""
    requested: list[float] = []
    monkeypatch.setattr(
        automatic_compilation.Code, "compiled_if_faster", lambda self, elapsed, ahead, poll: requested.append(ahead)
    )
    return requested


@pytest.mark.parametrize("limit", [{"max_steps": 2000}, {"wall_time": 0.1}])
def test_a_limited_run_is_not_compiled_for_time_it_will_not_take(crank, wanted, limit):
    run = simulate(crank, duration="100 s", tolerance=1e-8, **limit)
    assert not run.outcome.finished
    assert wanted == []
    simulate(crank, duration="100 s", tolerance=1e-8, max_events=100)  # which nobody can foresee
    assert min(wanted) > 10


@pytest.mark.parametrize(("needed", "begun"), [(1.0, True), (3.0, False), (50.0, False)])
def test_a_compiler_is_not_started_that_cannot_pay_within_the_limit(crank, clock, monkeypatch, needed, begun):
    """Of 10 s: a quarter of what is left may go into it, and only where it saves more."""
    started = []

    def compile_files(*_):
        started.append(chunk.time.perf_counter())
        raise c_compilation.NoCompilerError

    monkeypatch.setattr(c_compilation, "compile_seconds", lambda _: needed)
    monkeypatch.setattr(c_compilation, "compile_files", compile_files)
    run = simulate(crank, duration="100 s", tolerance=1e-8, wall_time=10.0)
    assert run.outcome.name == "wall_time_limit"
    assert bool(started) is begun


# Files of the C of built-in scenes, each its level and length [MB], and the processor's time that GCC 12 took of them all [s].
MEASURED = {
    "bouncing_ball": ((("-O3", 0.082), ("-O1", 0.014)), 1.15), "slider_crank by both methods": ((("-O3", 0.241), ("-O1", 0.024)), 3.5),
    "newtons_cradle": ((("-O3", 0.264), ("-O1", 0.057)), 4.7), "bicycle": ((("-O3", 0.173), ("-O1", 0.012)), 4.0),
    "bicycle by both methods": ((("-O3", 0.386), ("-O3", 0.273), ("-O1", 0.024)), 18.0),
    "translational_clearance": ((("-O3", 0.326), ("-O1", 0.059)), 6.1), "ball_bearing": ((("-O3", 0.241), ("-O1", 0.033)), 5.9),
}  # fmt: skip


@pytest.mark.parametrize("name", MEASURED)
def test_the_time_to_compile_is_known_beforehand(name, monkeypatch):
    """By files one after the other; side by side it is that of the longest, or of all shared among the cores."""
    sizes, took = MEASURED[name]
    files = [CFile("x" * round(1e6 * length), level) for level, length in sizes]
    monkeypatch.setattr(c_compilation, "cores", lambda: 1)
    alone = c_compilation.compile_seconds(files)
    assert 1 / 1.6 < alone / took < 1.6
    loops = [CFile(file.text + "for (" * 1000, file.level) for file in files]
    assert c_compilation.compile_seconds(loops) > alone + 0.5  # of 300 pairs they take most of the time
    monkeypatch.setattr(c_compilation, "cores", lambda: 2)
    longest = max(c_compilation.compile_seconds([file]) for file in files)
    assert c_compilation.compile_seconds(files) == pytest.approx(max(longest, alone / 2))


def test_a_run_is_not_compiled_for_the_time_it_took_to_build_what_chooses(wanted, monkeypatch):
    """Two minutes to build what takes 0.1 s to run, on a loaded machine: as if an hour were ahead."""
    building = automatic_compilation.AutomaticCallers.use_choice
    late = []

    def slowly(callers, poll):
        building(callers, poll)
        late.append(120.0)

    elapsed, worked = chunk.time.perf_counter, chunk.time.thread_time
    shifted = SimpleNamespace(perf_counter=lambda: elapsed() + sum(late), thread_time=lambda: worked() + sum(late))
    monkeypatch.setattr(chunk, "time", shifted)
    monkeypatch.setattr(automatic_compilation.AutomaticCallers, "use_choice", slowly)
    simulate(load("journal_lubricated"), duration="0.3 s", tolerance=1e-6)
    assert late
    assert max(wanted, default=0) < 60
