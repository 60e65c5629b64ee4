"""A grid in place of every step: the states that dense output gives, everything else as it was, and memory that does not grow."""

import json
import math
import os
import signal
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from commands import called
from handmade import point

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Solution, load, simulate
from hertzwerk.runtime.cli import run_folder
from hertzwerk.runtime.engine.run import continuation, recorder
from hertzwerk.runtime.engine.solution import step_observers
from hertzwerk.runtime.engine.solution.history import History

built = cache(load)  # with its functions, for all tests here
CASES = {
    "bouncing_ball": {"duration": "2 s", "tolerance": 1e-8}, "slider_crank": {"duration": "12 ms", "tolerance": 1e-6},
    "squeezed": {"duration": "0.1 s", "tolerance": 1e-9},
    "resting": {"duration": "5 s", "tolerance": 1e-6, "method": "auto", "parameters": {"restitution": 0.3}},
    "rodas": {"duration": "0.5 s", "method": "rodas"}, "cvodes": {"duration": "0.452 s", "method": "cvodes", "tolerance": 1e-4},
}  # fmt: skip


def run(case, **options):
    """Two walls at once, a ball that comes to rest while the method changes, and plain ones."""
    settings = dict(CASES[case])
    name = case if case in ("bouncing_ball", "slider_crank") else "bouncing_ball"
    if case == "squeezed":
        name, settings["parameters"] = "ball_between_walls", {"gap": "-1 mm", "restitution": 1.0, "speed": "10 m/s"}
    return simulate(built(name), **settings, **options)


@pytest.fixture
def small_blocks(monkeypatch):
    """Blocks of a few rows, so that contacts and their peaks lie across them."""
    monkeypatch.setattr("hertzwerk.runtime.engine.run.single_run.BLOCK", 1)
    keep = recorder.Recorder.keep

    def one_by_one(self, rows):
        for i in range(len(rows)):
            keep(self, rows[i : i + 1])

    monkeypatch.setattr(recorder.Recorder, "keep", one_by_one)


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("case", CASES)
def test_a_grid_holds_what_lies_between_the_steps_bitwise_and_changes_nothing_else(case, small_blocks):
    steps = run(case)
    grid = run(case, grid=101)
    times = np.linspace(0, steps.settings.duration, 101)
    assert np.array_equal(grid.t, times)
    between = steps.at(times)
    assert list(grid) == list(steps)
    for name in grid:
        assert np.array_equal(grid[name], between[name]), name
    # Impacts, peaks, balance, choices found row by row are those found in all rows at once.
    grid = run(case, grid=2)
    assert len(grid.t) == 2
    assert grid.impacts == steps.impacts
    assert len(grid.impacts) > 0
    for name in ("energy_residual", "warnings", "outcome", "settings"):
        assert getattr(grid, name) == getattr(steps, name), name
    for name in ("final", "initial", "t_end"):
        assert getattr(grid.engine, name) == getattr(steps.engine, name), name
    assert grid.engine.choices == steps.engine.choices
    assert grid.statistics.steps == steps.statistics.steps == len(steps.t) - 1 or case == "cvodes"


def test_blocks_of_every_size_find_the_same(monkeypatch):
    steps = run("squeezed")
    size = steps.engine.history.rows[0].nbytes
    for rows in (2, 3, 7, 50, 1000):
        monkeypatch.setattr("hertzwerk.runtime.engine.run.single_run.BLOCK", rows * size)
        monkeypatch.setattr("hertzwerk.runtime.engine.integration.loop.chunk.SIZE", (3,))
        model = load("ball_between_walls")  # a chunk of its own
        grid = simulate(
            model, **CASES["squeezed"], parameters={"gap": "-1 mm", "restitution": 1.0, "speed": "10 m/s"}, grid=33
        )
        assert grid.impacts == steps.impacts
        assert np.array_equal(grid["track.travel"], steps.at(grid.t)["track.travel"])


@pytest.mark.parametrize(
    ("method", "order", "h"), [("dopri5", 5, 0.05), ("dop853", 8, 0.2), ("rodas", 5, 0.05), ("esdirk", 5, 0.05)]
)
def test_between_steps_the_error_falls_with_the_order_of_the_method(method, order, h):
    """x'' = 2 x^3 from x = x' = 1 is x = 1/(1 - t): a part of a step adds an error that falls with one power more, or faster."""
    start = {"path.travel": "1 m", "path.speed": "1 m/s"}
    model = point(push=lambda t, x, v: 2 * x**3)
    history = simulate(model, duration=0.5, tolerance=1e-2, method=method, initial=start).engine.history
    errors = []
    for part in (h, h / 2):
        between, x = history.between(np.array([0]), np.array([part])), 1 / (1 - part)
        errors.append(math.hypot(between["path.travel"][0] - x, between["path.speed"][0] - x * x))
    assert errors[0] < 1e-7
    assert math.log2(errors[0] / errors[1]) > order + 0.5


def test_at_the_time_of_an_event_a_grid_has_the_state_just_after_it_also_across_blocks():
    ball = built("bouncing_ball")
    steps = simulate(ball, duration="1 s", tolerance=1e-8)
    impact = steps.impacts[0]
    times = np.array([0.0, impact.t, impact.t + impact.duration, 1.0])
    grid = simulate(ball, duration="1 s", tolerance=1e-8, grid=times)
    assert list(grid["floor.mode"]) == [0, 1, 0, 0]
    assert np.array_equal(grid.engine.history.rows, steps.engine.history.rows[np.isin(steps.t, times)])
    # As SUNDIALS gives them where an event lies on a row.
    history = simulate(built("bouncing_ball"), duration="1 s", tolerance=1e-6).engine.history
    onset = int(np.argmax(history["floor.mode"] == 1))
    before = history.rows[onset].copy()
    before[history.columns("mode")] = 0
    kept = recorder.Grid(history.t[[onset]])
    record = recorder.Recorder(
        lambda rows: History(history.model, rows, history.controls, history.integrator), [kept], 1
    )
    for row in np.insert(history.rows, onset, before, axis=0):
        record.keep(row[None, :])
    record.flush()
    assert kept.history["floor.mode"] == [1]


@pytest.mark.by_turns(2)
@pytest.mark.parametrize(
    ("output", "times"),
    [
        (3, [0, 0.015, 0.03]), (np.int64(2), [0, 0.03]), ("10 ms", [0, 0.01, 0.02, 0.03]), ("20 ms", [0, 0.02, 0.03]), ("30 ms", [0, 0.03]),
        ([0.0, 1e-3, 0.03], [0, 1e-3, 0.03]), ((2e-3,), [2e-3]), (np.array([0.029, 0.03]), [0.029, 0.03]),
    ],
)  # fmt: skip
def test_the_forms_of_a_grid(output, times):
    grid = simulate(built("soft_ball"), duration="30 ms", grid=output, tolerance=1e-6)
    assert grid.t == pytest.approx(times, rel=1e-15)
    assert grid.t[-1] == times[-1]
    assert grid.engine.initial["vertical.speed"] == 0
    assert grid.engine.t_end == 0.03


@pytest.mark.parametrize(
    ("output", "found"),
    [
        (1, ["1 points"]),
        (0, ["0 points"]),
        (2_000_000, ["2000000 points"]),
        (True, ["True"]),
        (0.1, ["0.1"]),
        ("every", ["'every'"]),
        ("1 kg", ["'1 kg'"]),
        ("-1 ms", ["'-1 ms'"]),
        ("2 s", ["a spacing of 2 s"]),
        ("1 ns", ["1e+09 points"]),
        ([], ["numbers of shape (0,)"]),
        ([[0.0, 1.0]], ["numbers of shape (1, 2)"]),
        (["a"], ["['a']"]),
        ([0.0, 0.2, 0.2], ["0.2 s after 0.2 s at index 2"]),
        ([0.3, -0.1, math.nan, 2.0, 1.5], ["nan at index 2", "-0.1 s after 0.3 s", "-0.1 s at index 1, and 2 more"]),
        (np.linspace(0, 1, 1_000_001), ["1,000,001 times"]),
    ],
)  # fmt: skip
def test_every_fault_of_a_grid_in_one_error(output, found):
    with pytest.raises(InputError) as error:
        simulate(built("soft_ball"), duration="1 s", tolerance=7, grid=output)
    faults = [fault for fault in error.value.faults if fault.where == "grid"]
    assert len(faults) == len(found)
    assert len(error.value.faults) == len(found) + 1  # the tolerance
    for fault, text in zip(faults, found, strict=True):
        assert text in fault.found


def test_a_run_that_stops_early_returns_the_points_it_reached_and_nothing_between_them():
    ball = built("bouncing_ball")
    steps, grid = (simulate(ball, duration="5 s", max_events=2, grid=output, tolerance=1e-6) for output in (None, 501))
    assert grid.outcome == steps.outcome
    assert grid.outcome.name == "event_limit"
    assert grid.engine.t_end == steps.t[-1] < 5
    assert np.array_equal(grid.t, np.linspace(0, 5, 501)[np.linspace(0, 5, 501) <= grid.engine.t_end])
    assert grid.engine.final == steps.engine.final
    none = simulate(ball, duration="5 s", max_steps=1, grid=[4.0], tolerance=1e-6)
    assert len(none.t) == len(none["vertical.travel"]) == len(none["energy"]) == 0
    assert "too_many_steps" in str(none)
    grid = simulate(built("soft_ball"), duration="1 s", grid=11, tolerance=1e-6)
    assert np.array_equal(grid.at(grid.t[[2, 5]])["vertical.travel"], grid["vertical.travel"][[2, 5]])
    for times in ([0.05], [2.0], [math.nan], [[0.1]]):
        with pytest.raises(ValueError, match=r"grid=times.*grid=None"):
            grid.at(times)
    for output in (None, 11):
        run = simulate(
            built("bouncing_ball"), duration="1 s", grid=output, initial={"vertical.travel": "-1e300 m"}, tolerance=1e-6,
        )  # fmt: skip
        assert run.outcome.name == "not_finite"
        assert run.energy_residual is None
        assert len(run.impacts) == len(run.t) == 1


def test_ctrl_c_in_a_block_loses_no_observer_a_row(monkeypatch):
    """It comes while some of the observers have seen a block, with impacts in it, and others have not."""
    monkeypatch.setattr("hertzwerk.runtime.engine.run.single_run.BLOCK", 1)
    take, sent = step_observers.Findings.take, []

    def interrupted(self, block, fresh):
        take(self, block, fresh)
        if sum(map(len, self._watch.ended)) > 2 and not sent:
            sent.append(True)
            os.kill(os.getpid(), signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    monkeypatch.setattr(step_observers.Findings, "take", interrupted)
    try:
        grid = simulate(built("bouncing_ball"), duration="500 s", tolerance=1e-12, compiled=False, grid=1000)
    finally:
        signal.signal(signal.SIGINT, before)
    assert grid.outcome.name == "interrupted"
    monkeypatch.undo()
    again = simulate(
        built("bouncing_ball"), duration="500 s", tolerance=1e-12, max_steps=grid.statistics.steps, compiled=False
    )
    assert grid.engine.t_end == again.engine.t_end
    assert grid.impacts == again.impacts
    assert grid.energy_residual == again.energy_residual


def test_saved_drawn_and_loaded(tmp_path):
    grid = simulate(built("slider_crank"), duration="24 ms", grid=[1e-3, 2e-3, 9e-3], method="auto", tolerance=1e-6)
    again = Solution.load(grid.save(tmp_path / "run.npz"))
    assert (again.impacts, again.energy_residual) == (grid.impacts, grid.energy_residual)
    for name in ("final", "initial", "t_end"):
        assert getattr(again.engine, name) == getattr(grid.engine, name), name
    assert again.engine.choices == grid.engine.choices != ()
    assert np.array_equal(again["guide.travel"], grid["guide.travel"])
    for figure in (grid.plot(), grid.plot("slider_pin"), again.plot(), again.plot("slider_pin")):
        figure.draw_without_rendering()
    assert "do not resolve" in str([text.get_text() for axis in again.plot("slider_pin").axes for text in axis.texts])
    empty = simulate(built("soft_ball"), duration="1 s", grid=[0.5], max_steps=1, tolerance=1e-6)
    empty.plot().draw_without_rendering()  # of the step that was made
    with pytest.raises(ValueError, match="no rows"):
        Solution.load(empty.save(tmp_path / "empty.npz")).plot()


def test_pictures_of_a_grid_share_one_run_made_again_for_them(tmp_path, monkeypatch):
    run, made = simulate(built("bouncing_ball"), duration="1 s", tolerance=1e-6, grid=50), []
    set_up = continuation.set_up
    monkeypatch.setattr(continuation, "set_up", lambda *given, **how: made.append(given) or set_up(*given, **how))
    files = run_folder.write(run, tmp_path / "run", plots=True).files
    assert {"mechanism.png", "overview.png", "floor.png"} <= set(files)
    assert len(made) == 1


def test_the_command_line(own_folder):
    for grid, rows in (("101", 101), ("1 ms", 25), ("", None)):
        wanted = ("--grid", grid) if grid else ()
        called("run", "slider_crank", *wanted, "--no-plots", "--out", grid or "steps")
        lines = Path(grid or "steps", "states.csv").read_text().splitlines()
        record = json.loads(Path(grid or "steps", "run.json").read_text())
        assert len(lines) - 1 == record["rows"] == (rows or record["steps"] + 1)
        assert record["t_end"] == 0.024
    called("run", "slider_crank", "--grid", "9" * 5000, code=2)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "compilers"),
    [("slider_crank_frictionless", ""), pytest.param("slider_crank", os.environ["PATH"], marks=pytest.mark.exhaustive)],
)
def test_memory_does_not_grow_with_the_run(name, compilers, monkeypatch):
    """Lasting contact (with friction the pin stays in contact) and repeated impacts; these are kept, some hundred bytes each.

    Without a compiler, for whose work two thirds of the time would go.
    """
    monkeypatch.setenv("PATH", compilers)
    monkeypatch.delenv("CC", raising=False)
    program = Path(__file__).parents[3] / "benchmarks" / "memory.py"

    def measured(steps):
        command = [sys.executable, str(program), name, str(steps), "10 ms", "100 s"]
        return json.loads(subprocess.run(command, capture_output=True, text=True, check=True, timeout=600).stdout)

    short, long = measured(10_000), measured(100_000)
    assert (short["steps"], long["steps"]) == (10_000, 100_000)
    impacts, rows = long["impacts"] - short["impacts"], long["rows"] - short["rows"]
    assert long["peak_mb"] - short["peak_mb"] < 20 + (500 * impacts + 8 * 50 * rows) / 1e6
    assert long["peak_mb"] < 300
