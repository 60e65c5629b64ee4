"""Batches: bitwise the single runs, in order, failures as rows; a running time measured, not asserted."""

import csv
import gc
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from handmade import point

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import simulate, simulate_many
from hertzwerk.runtime.loading import engine_model

HEIGHTS = [f"{1.5 - 0.1 * i:.1f} m" for i in range(7)]
SETTINGS = {"duration": "3 s", "tolerance": 1e-8}


@pytest.fixture(autouse=True)
def _own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / "cache"))


@pytest.mark.parametrize("workers", [1, 3])
@pytest.mark.parametrize("compiled", [False, "auto"])
def test_rows_are_the_single_runs_bitwise_in_order(ball, workers, compiled):
    sets = [{"drop_height": height} for height in HEIGHTS]
    recorded = []
    sweep = simulate_many(ball, sets, workers=workers, compiled=compiled, progress=recorded.append, **SETTINGS)
    assert [row.stated for row in sweep] == sets
    assert recorded[-1] == 1
    for row, values in zip(sweep, sets, strict=True):
        run = simulate(ball, parameters=values, **SETTINGS)
        assert row.final == run.engine.final
        assert row["impacts"] == len(run.impacts)
        assert row["peak_force"] == max(impact.peak_force for impact in run.impacts)
        assert (row["energy_residual"], row.warnings) == (run.energy_residual, run.warnings)
        assert row["steps"] == run.statistics.steps
    assert np.allclose(sweep["drop_height"], 1.5 - 0.1 * np.arange(7), rtol=1e-15, atol=0)
    assert np.all(np.diff(sweep["peak_force"]) < 0)


@pytest.mark.parametrize("workers", [1, 2])
def test_failures_are_rows(ball, workers):
    sets = [{"mass": "-1 kg", "mas": 1}, {}, {"mass": "1 m"}, {"vertical.speed": "-1 m/s"}, {"vertical.speed": 1.0}]
    sweep = simulate_many(ball, sets, workers=workers, duration="1 s", tolerance=1e-6)
    assert list(sweep["outcome"]) == ["bad_input", "finished", "bad_input", "finished", "bad_input"]
    assert "did you mean mass" in sweep.rows[0].message
    assert "mass" in sweep.rows[2].message
    assert np.array_equal(np.isnan(sweep["peak_force"]), [True, False, True, False, True])
    assert sweep["vertical.speed"][3] == -1
    stopped = simulate_many(ball, [{}, {}], workers=workers, duration="1 s", max_steps=5, tolerance=1e-6)
    assert list(stopped["outcome"]) == ["too_many_steps"] * 2
    assert all(row.message for row in stopped)


def test_faults_of_every_run_are_bad_input(ball):
    with pytest.raises(InputError) as error:
        simulate_many(ball, [{}], duration="-1 s", accuracy=2, method="rk4", compiled="yes")
    assert {fault.where for fault in error.value.faults} == {"duration", "accuracy", "rk4", "compiled"}
    with pytest.raises(InputError, match="workers"):
        simulate_many(ball, [{}], duration="1 s", workers=0, tolerance=1e-6)
    with pytest.raises(InputError, match="a name of its own"):
        simulate_many(ball, [{}], duration="1 s", functions={"impacts": lambda run: 0.0}, tolerance=1e-6)


@pytest.mark.parametrize("workers", [1, 2])
def test_outputs_are_columns_and_one_that_raises_is_a_row(ball, workers):
    outputs = {"top": lambda run: np.max(run["vertical.travel"]), "second": lambda run: run.impacts[1].speed}
    sets = [{"drop_height": "1 m"}, {"drop_height": "20 m"}]
    sweep = simulate_many(ball, sets, duration="1.5 s", functions=outputs, workers=workers, tolerance=1e-6)
    assert sweep["top"] == pytest.approx([1.1, 20.1])
    assert sweep["second"][0] > 0
    assert sweep.rows[1].outcome == "bad_output"
    assert "IndexError" in sweep.rows[1].message


@pytest.mark.parametrize("workers", [1, 2])
def test_a_typographic_minus_is_a_minus_and_a_key_that_is_no_text_a_row(ball, workers):
    sets = [{"vertical.speed": "\u22121 m/s"}, {7: "1 m"}, {None: 1.0}, {"drop_height": "1 m"}]
    sweep = simulate_many(ball, sets, duration="1 s", tolerance=1e-6, workers=workers)
    assert list(sweep["outcome"]) == ["finished", "bad_input", "bad_input", "finished"]
    assert sweep["vertical.speed"][0] == -1
    assert "a parameter named by int" in sweep.rows[1].message


def _refused(height):
    return simulate(engine_model("bouncing_ball"), duration="1 s", parameters={"drop_height": height})


def test_errors_come_whole_from_other_processes():
    with multiprocessing.get_context("fork").Pool(1) as pool, pytest.raises(InputError) as caught:
        pool.map(_refused, ["1 kg"])
    assert [fault.where for fault in caught.value.faults] == ["drop_height"]
    again = pickle.loads(pickle.dumps(caught.value))
    assert (again.faults, str(again), again.subject) == (caught.value.faults, str(caught.value), caught.value.subject)


def test_batches_in_threads_side_by_side(ball):
    """With Python 3.11's cached properties, whose lock a fork inherits, 4 of 10 such programs hung.

    Of CasADi's own lock a fork has a copy too: who has threads starts processes otherwise.
    """
    code = """
import multiprocessing, threading
multiprocessing.set_start_method("forkserver")
from hertzwerk.runtime import simulate, simulate_many
from hertzwerk.runtime.loading import engine_model
ball, sets = engine_model("bouncing_ball"), [{"drop_height": f"{0.5 + 0.01 * i} m"} for i in range(12)]
def batch():
    sweep = simulate_many(ball, sets, duration="2 s", tolerance=1e-8, workers=2, compiled=False)
    print(len(sweep), *sorted(set(map(str, sweep["outcome"]))), flush=True)
def alone():
    for _ in range(10):
        simulate(ball, duration="1 s", tolerance=1e-8, compiled=False).impacts
threads = [threading.Thread(target=target) for target in (batch, alone, batch, alone, batch)]
for thread in threads: thread.start()
for thread in threads: thread.join()
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout == "12 finished\n" * 3


SHARES_NOTHING = """
import multiprocessing, os, sys
import numpy as np
from hertzwerk.runtime import sweep
from hertzwerk.runtime.loading import engine_model
def highest(run):
    return float(run["vertical.travel"].max())
def process(run):
    return os.getpid()
if __name__ == "__main__":
    model, asked = engine_model("bouncing_ball"), {"over": {"drop_height": "0.3..0.5 m:4"}, "duration": "0.5 s", "workers": 2}
    def rows(**functions):
        return sweep(model, outputs=["floor.peak_force", "final.vertical.travel"], functions=functions, **asked)
    forked = rows(highest=highest)
    multiprocessing.set_start_method(sys.argv[1])
    started = rows(highest=highest)
    print(*(name for name in forked.names if name != "wall_s" and not np.array_equal(forked[name], started[name])))
    print(len(set(rows(process=process)["process"])) > 1, set(rows(process=lambda run: process(run))["process"]) == {os.getpid()})
"""


@pytest.mark.slow
@pytest.mark.parametrize("start", ["spawn", pytest.param("forkserver", marks=pytest.mark.exhaustive)])
def test_processes_that_share_nothing_give_the_same_rows(start, tmp_path):
    """A function that cannot be sent to them is called in threads."""
    program = tmp_path / "program.py"
    program.write_text(SHARES_NOTHING)
    command = [sys.executable, "-W", "error", str(program), start]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout == "\nTrue True\n"


@pytest.mark.parametrize("ending", [signal.SIGKILL, signal.SIGTERM])
def test_workers_end_with_a_parent_that_is_killed(ending):
    code = """
import os, time
from hertzwerk.runtime import simulate_many
from hertzwerk.runtime.loading import engine_model
def tell(run):
    os.write(1, f"{os.getpid():10}\\n".encode())
    time.sleep(600 if run.engine.initial["vertical.speed"] else 0)
    return 0.0
sets = [{}] + [{"vertical.speed": "-1 m/s"}] * 3
simulate_many(engine_model("bouncing_ball"), sets, duration="1 s", tolerance=1e-6, workers=2, compiled=False, functions={"x": tell})
"""
    parent = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    workers = {int(parent.stdout.readline()) for _ in range(3)} - {parent.pid}
    assert len(workers) == 2
    parent.send_signal(ending)
    parent.wait(10)
    parent.stdout.close()
    deadline = time.monotonic() + 20
    while (alive := [worker for worker in workers if Path(f"/proc/{worker}").exists()]) and time.monotonic() < deadline:
        time.sleep(0.05)
    for worker in alive:
        os.kill(worker, signal.SIGKILL)
    assert not alive


def test_of_all_rows_only_the_guilty_ones_are_lost(ball):
    def die(run):
        if round(run.engine.initial["vertical.travel"], 6) in (1.3, 1.9):  # 0.1 m above the drop height
            os._exit(3)
        return run.engine.t_end

    heights = [round(0.5 + 0.1 * i, 1) for i in range(20)]
    sets = [{"drop_height": f"{height} m"} for height in heights]
    sweep = simulate_many(ball, sets, duration="1 s", compiled=False, workers=2, functions={"end": die}, tolerance=1e-6)
    assert [row.index for row in sweep] == list(range(20))
    assert [h for h, row in zip(heights, sweep, strict=True) if row.outcome == "lost"] == [1.2, 1.8]
    assert all(row["end"] == 1 for row in sweep if row.outcome != "lost")
    assert all("died" in row.message for row in sweep if row.outcome == "lost")


@pytest.mark.skipif(sys.platform != "linux", reason="processes that are forked")
def test_processes_look_for_no_garbage_in_what_they_were_forked_with(ball):
    def left_out(run):
        return gc.get_freeze_count()

    sets = [{"drop_height": height} for height in HEIGHTS[:2]]
    how = {"compiled": False, "functions": {"left_out": left_out}, **SETTINGS}
    ours, theirs = (simulate_many(ball, sets, workers=workers, **how)["left_out"] for workers in (1, 2))
    assert ours.max() == gc.get_freeze_count() < theirs.min()


def test_a_grid_changes_no_row_and_is_what_outputs_see(ball):
    sets = [{"drop_height": height} for height in HEIGHTS[:3]]
    outputs = {"rows": lambda run: float(len(run.t))}
    steps, grid = (
        simulate_many(ball, sets, workers=1, compiled=False, grid=output, functions=outputs, **SETTINGS)
        for output in (None, 11)
    )
    assert list(grid["rows"]) == [11] * 3
    for name in ("peak_force", "impacts", "energy_residual", "steps", "final.vertical.speed"):
        assert np.array_equal(steps[name], grid[name]), name
    with pytest.raises(InputError, match="grid"):
        simulate_many(ball, sets, duration="1 s", grid=1, tolerance=1e-6)


def test_csv(ball, tmp_path):
    sweep = simulate_many(ball, [{"drop_height": "1 m"}, {"drop_height": "-1 kg"}], duration="1 s", tolerance=1e-6)
    path = sweep.to_csv(tmp_path / "sweep.csv")
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [row["outcome"] for row in rows] == ["finished", "bad_input"]
    assert float(rows[0]["final.vertical.speed [m/s]"]) == sweep["final.vertical.speed"][0]
    assert rows[0]["drop_height [m]"] == "1"
    with pytest.raises(FileExistsError):
        sweep.to_csv(path)
    with pytest.raises(KeyError, match="peak_force"):
        sweep["peak"]


@pytest.fixture
def interruptible():
    """Ctrl-C raises; a shell that starts the tests in the background has it ignored."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize("workers", [1, 2])
@pytest.mark.usefixtures("interruptible")
def test_ctrl_c_returns_the_rows_that_are_done(workers):
    """The first two runs are short, the others take minutes."""
    model = point(lambda d, v, v0: 1e14 * d, push=lambda t, x, v: -10.0 + 0 * t, scales=(1e-2, 1.0, 100.0, 1.0))
    sets = [{"path.travel": "1e8 m"}] * 2 + [{}] * 6
    done = threading.Event()

    def interrupt():
        done.wait(30)
        time.sleep(0.2)
        os.kill(os.getpid(), signal.SIGINT)

    killer = threading.Thread(target=interrupt)
    killer.start()
    sweep = simulate_many(
        model, sets, duration=1e6, tolerance=1e-10, compiled=False, workers=workers, max_steps=10**9, max_events=10**9,
        progress=lambda fraction: done.set() if fraction >= 0.25 else None,
    )  # fmt: skip
    killer.join()
    assert sweep.interrupted
    assert [row.index for row in sweep] == [0, 1]
    assert "interrupted" in str(sweep)


def test_sets_name_the_joints_states_in_absolute_coordinates_too():
    angles = [0.2, 0.4]
    sets = [{"shoulder.angle": f"{angle} rad", "length": "0.5 m"} for angle in angles]
    models = (engine_model("double_pendulum", coordinates=kind) for kind in (None, "absolute"))
    tree, absolute = (simulate_many(m, sets, duration="0.1 s", tolerance=1e-9, workers=1) for m in models)
    assert list(absolute["outcome"]) == ["finished"] * 2
    assert list(absolute["shoulder.angle"]) == angles
    assert absolute["final.upper.angle"] == pytest.approx(tree["final.shoulder.angle"], abs=1e-7)
