"""A store loses nothing: kills at random moments, a full disk, another definition, another process; and computes nothing twice."""

import json
import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import time
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.equations.inverse_dynamics import derived_histories
from hertzwerk.derive.expressions.algebra.vectors import dot
from hertzwerk.derive.scenes import pendulum
from hertzwerk.runtime import Sweep, sweep
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps import batch, sweep_store
from hertzwerk.runtime.studies.sweeps.points.design_points import Design
from hertzwerk.runtime.studies.sweeps.rows.row import Row
from hertzwerk.runtime.studies.sweeps.stored_rows import StoredRows

BALL = {"duration": "2 s", "tolerance": 1e-8, "compiled": False, "workers": 1}
OVER = {"drop_height": "0.5..1.5 m:5"}


@pytest.fixture
def counted(tmp_path):
    """A function for `sweep` that tells which rows were computed."""
    heights = []
    file = str(tmp_path / "computed")

    def height(run):
        with open(file, "a") as log:  # noqa: PTH123
            log.write(f"{run.engine.initial['vertical.travel']!r}\n")
        return 0.0

    def computed():
        lines = Path(file).read_text().split() if Path(file).exists() else []
        new = lines[len(heights) :]
        heights.extend(new)
        return len(new)

    return height, computed


def table(folder):
    return (folder / sweep_store.TABLE).read_bytes()


def same(one, other):
    assert one.columns == other.columns
    assert [(row.index, row.stated) for row in one] == [(row.index, row.stated) for row in other]
    for name in one.names:
        np.testing.assert_array_equal(one[name], other[name])


def test_stored_rows_equal_those_returned_and_are_not_computed_again(ball, tmp_path, counted):
    height, computed = counted
    how = {**BALL, "parameters": {"radius": "21 mm"}, "functions": {"n": height}}
    how |= {"outputs": ["floor.peak_force", "floor.impact_rate", "final.vertical.speed"]}
    plain = sweep(ball, OVER, **how)
    assert computed() == 5
    kept = sweep(ball, OVER, out=tmp_path / "a", **how)
    assert computed() == 5
    same(plain, kept)
    same(kept, Sweep.load(tmp_path / "a"))
    again = sweep(ball, OVER, out=tmp_path / "a", **how)
    assert computed() == 0
    same(kept, again)
    assert again.outcome.finished
    assert (tmp_path / "a" / "model.py").read_text() == Path(ball.module.__file__).read_text()


def test_a_wider_sweep_computes_what_is_new_alone_once_it_is_allowed_to(ball, tmp_path, counted):
    height, computed = counted
    how = {**BALL, "functions": {"n": height}}
    sweep(ball, OVER, out=tmp_path / "a", **how)
    wider = {"drop_height": "0.5..1.5 m:9"}
    with pytest.raises(InputError) as refused:
        sweep(ball, wider, out=tmp_path / "a", **how)
    (fault,) = refused.value.faults
    assert (fault.where, fault.found) == ("over.drop_height", "'0.5..1.5 m:9'")
    assert fault.expected.startswith("'0.5..1.5 m:5'")
    computed()
    widened = sweep(ball, wider, out=tmp_path / "a", widen=True, **how)
    assert computed() == 4
    same(widened, sweep(ball, wider, **how))


def test_rows_whose_numbers_would_change_are_computed_anew(ball, tmp_path, counted):
    """Laws, settings, values, outputs, own functions; and the same numbers in other units are the same."""
    height, computed = counted
    over = {"drop_height": "0.5, 1 m"}
    how = {**BALL, "functions": {"n": height}, "out": tmp_path / "a"}
    sweep("bouncing_ball", over, **how)
    computed()
    for change in (
        {"laws": {"floor": "hunt_crossley"}}, {"tolerance": 1e-7}, {"duration": "1 s"}, {"parameters": {"radius": "21 mm"}}, {"outputs": ["impacts"]},
        {"functions": {"n": lambda run: height(run) + 1}},
    ):  # fmt: skip
        with pytest.raises(InputError, match="as of the sweep there"):
            sweep("bouncing_ball", over, **{**how, **change})
        sweep("bouncing_ball", over, widen=True, **{**how, **change})
        assert computed() == 2, change
    sweep("bouncing_ball", {"drop_height": "500, 1000 mm"}, widen=True, **{**how, "duration": "2000 ms"})
    assert computed() == 0


def test_readings_that_are_derived_otherwise_are_computed_anew(tmp_path, monkeypatch):
    """Their formulas are no part of the model's text: a row of theirs is that of the formulas that it was computed by."""
    over, how = {"length": "1, 2 m"}, {"duration": "0.1 s", "workers": 1, "compiled": False}

    def swept(name, **more):
        return sweep(engine_model(pendulum.scene), over, outputs=[name], out=tmp_path / name, **how, **more)

    before, other = swept("bob.speed.max"), swept("hinge.angle.max")
    monkeypatch.setattr(derived_histories, "dot", lambda a, b: 4 * dot(a, b))
    with pytest.raises(InputError, match="readings"):
        swept("bob.speed.max")
    now = swept("bob.speed.max", widen=True)
    np.testing.assert_allclose(now["bob.speed.max"], 2 * before["bob.speed.max"], rtol=1e-12)
    same(other, swept("hinge.angle.max"))


def test_equal_points_share_a_row(ball, tmp_path, counted):
    height, computed = counted
    actual = sweep(ball, {"drop_height": "1, 1 m"}, functions={"n": height}, out=tmp_path / "a", **BALL)
    assert (len(actual), computed()) == (2, 1)
    assert actual.rows[0].outputs == actual.rows[1].outputs


def test_a_folder_of_something_else_is_left_alone(ball, tmp_path):
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(InputError, match=r"other content \(mine\.txt\)"):
        sweep(ball, OVER, out=tmp_path, **BALL)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
    with pytest.raises(InputError, match="which is a file"):
        sweep(ball, OVER, out=tmp_path / "mine.txt", **BALL)
    with pytest.raises(InputError, match="no sweep"):
        Sweep.load(tmp_path)
    folder = tmp_path / "a"
    sweep(ball, OVER, out=folder, **BALL)
    (folder / sweep_store.DEFINITION).write_text("{")
    with pytest.raises(InputError, match="a definition as a sweep wrote it"):
        sweep(ball, OVER, out=folder, **BALL)


def test_a_second_process_is_refused_and_readers_are_not(tmp_path):
    code = """
import sys
from pathlib import Path
from hertzwerk.runtime.studies.sweeps.sweep_store import opened
with opened(Path(sys.argv[1])) as store:
    print("open", flush=True)
    sys.stdin.readline()
"""
    folder = tmp_path / "a"
    sweep("bouncing_ball", OVER, out=folder, **BALL)
    with subprocess.Popen(
        [sys.executable, "-c", code, str(folder)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as other:
        other.stdout.readline()
        with pytest.raises(InputError, match="one in use"):
            sweep("bouncing_ball", OVER, out=folder, **BALL)
        assert len(Sweep.load(folder)) == 5
        other.kill()
    assert len(sweep("bouncing_ball", OVER, out=folder, **BALL)) == 5
    with sweep_store.opened(folder), pytest.raises(InputError, match="one in use"), sweep_store.opened(folder):
        pass


def rows_of(folder):
    """Rows in a folder, none before there is a definition."""
    return Sweep.load(folder).rows if (folder / sweep_store.DEFINITION).exists() else ()


def row(i):
    return Row(i, {}, "finished", outputs={"x": float(i)})


def on_disk(folder, elsewhere):
    """Rows in the database file alone, without its log: what the disk has been told to keep."""
    shutil.copyfile(folder / sweep_store.ROWS, elsewhere)
    try:
        with sqlite3.connect(elsewhere) as copy:
            return [key for (key,) in copy.execute("SELECT key FROM rows ORDER BY key")]
    except sqlite3.DatabaseError:
        return []


@pytest.mark.parametrize("broken", [False, True])
def test_a_row_is_written_through_though_no_other_follows(tmp_path, monkeypatch, broken):
    """Without the thread, the seeded fault, it stays in the log; within a second is what the interval allows."""
    if broken:
        monkeypatch.setattr(sweep_store._Syncing, "run", lambda self: None)
    with sweep_store.opened(tmp_path / "a") as opened:
        opened.add({"k": row(0)}, {})
        deadline = time.monotonic() + (2 if broken else 30)
        while (actual := on_disk(tmp_path / "a", tmp_path / "copy")) != ["k"] and time.monotonic() < deadline:
            time.sleep(0.05)
    assert actual == ([] if broken else ["k"])
    assert sweep_store.SYNC < 1


@pytest.mark.parametrize("compiled", [False, "auto"])
def test_a_lost_row_is_tried_anew_by_the_next_call_and_in_a_process_of_its_own(ball, tmp_path, compiled):
    """A call by one worker, which is this process, leaves it; of two, the first kills two more, and the next stores it."""
    tries = str(tmp_path / "tries")

    def end(run):
        if run.engine.initial["vertical.travel"] > 1.4:
            with open(tries, "a") as log:  # noqa: PTH123
                log.write("x")
            if Path(tries).stat().st_size <= 4:
                os._exit(3)
        return run.engine.t_end

    how = {**BALL, "compiled": compiled, "workers": 2, "functions": {"end": end}, "out": tmp_path / "a"}
    first = sweep(ball, OVER, **how)
    assert list(first["outcome"]) == ["finished"] * 4 + ["lost"]
    assert "the next call tries it again" in first.rows[-1].message
    assert first["drop_height"][-1] == 1.5
    assert list(sweep(ball, OVER, **{**how, "workers": 1})["outcome"])[-1] == "lost"
    assert Path(tries).stat().st_size == 2
    assert list(sweep(ball, OVER, **how)["outcome"])[-1] == "lost"
    assert Path(tries).stat().st_size == 4
    assert list(sweep(ball, OVER, **how)["outcome"]) == ["finished"] * 5
    same(sweep(ball, OVER, **how), sweep(ball, OVER, **{**how, "out": None, "workers": 1}))


def test_a_row_comes_back_bitwise_and_cannot_be_stored_again(tmp_path):
    outputs = {"x": 0.1 + 0.2, "y": -0.0, "z": float("nan"), "u": float("inf"), "v": 5e-324}
    written = Row(0, {"b": "2", "a": (0.1, "mm")}, "failed", "why", {"a": 1e-4}, outputs, ("one", "two"), 0.25)
    with sweep_store.opened(tmp_path / "a") as opened:
        opened.add({"k": written}, {0: "k"})
    (read,) = StoredRows(tmp_path / "a" / sweep_store.ROWS, "", Design({"a": ((0.1, "mm"),)}, fixed={"b": "2"}))
    assert repr(read) == repr(written)
    with sweep_store.opened(tmp_path / "b") as opened:
        opened.add({"k": row(0)}, {})
        with pytest.raises(sqlite3.IntegrityError):
            opened.add({"k": row(0)}, {})


# -- a full disk -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("how", ["pages", "tmpfs"])
def test_a_full_disk_ends_with_an_outcome_and_goes_on_with_space(ball, tmp_path, monkeypatch, counted, how):
    height, computed = counted
    folder = tmp_path / "disk" / "a"
    over = {"drop_height": "0.5..1.5 m:120"}
    long = {**BALL, "duration": "0.3 s", "functions": {"n": height}, "outputs": ["floor.peak_force"]}
    connected = sweep_store.connected
    if how == "pages":

        def limited(file):
            connection = connected(file)
            if file.name == sweep_store.ROWS:
                connection.execute("PRAGMA max_page_count = 9")
            return connection

        monkeypatch.setattr(sweep_store, "connected", limited)
    else:
        folder.parent.mkdir()
        mount = ["mount", "-t", "tmpfs", "-o", "size=200k", "none", str(folder.parent)]
        if os.getuid() or shutil.which("mount") is None or subprocess.run(mount, capture_output=True).returncode:
            pytest.skip("no right to mount a small disk")
    try:
        ended = sweep(ball, over, out=folder, **long)
        assert ended.outcome.name == "not_stored"
        assert "disk is full" in ended.outcome.message
        assert 0 < len(ended) < 120
        monkeypatch.undo()
        if how == "tmpfs":
            subprocess.run(["mount", "-o", "remount,size=8m", str(folder.parent)], check=True)
        before = computed()
        assert before <= len(ended) + 1
        whole = sweep(ball, over, out=folder, **long)
        assert whole.outcome.finished
        assert computed() == 120 - len(ended)
        same(whole, sweep(ball, over, **long))
    finally:
        if how == "tmpfs":
            subprocess.run(["umount", str(folder.parent)], check=False)


# -- kills -------------------------------------------------------------------------------------------------------------

DRIVER = """
import os, sys
from hertzwerk.runtime import sweep
from hertzwerk.runtime.studies.sweeps import sweep_store

def note(run):
    with open(sys.argv[2], "a") as log:
        log.write(f"{sys.argv[3]} {run.settings.parameters['drop_height'][0]!r}\\n")
    return run.engine.final["vertical.travel"]

def late(self, rows, points, held={}, where={}):
    held |= rows
    where |= points
    if len(held) >= 30:
        add(self, held, where)
        held.clear()
        where.clear()

def told(fraction, done=[]):
    # a line for every row that is done, and one before the first
    now = round(fraction * int(sys.argv[4]))
    os.write(1, b"row\\n" * (now - done[-1] if done else 1))
    done.append(now)

add = sweep_store.Store.add
if sys.argv[5] == "late":
    sweep_store.Store.add = late
sweep("bouncing_ball", {"drop_height": f"0.5..1.5 m:{sys.argv[4]}"}, duration="3 s", tolerance=1e-10, compiled=False,
      outputs=["floor.peak_force", "floor.impact_rate"], functions={"note": note}, workers=2, out=sys.argv[1],
      progress=told)
"""


def survive(tmp_path, kills, fault="none"):
    """Kill a sweep again and again, let it end, and compare it with one that was left alone."""
    (tmp_path / "driver.py").write_text(DRIVER)
    chance = random.Random(f"{kills} kills")
    rows = 40 * kills + 30  # more than are computed until the last kill

    def start(folder, log, session):
        arguments = [str(tmp_path / "driver.py"), str(folder), str(log), str(session), str(rows), fault]
        return subprocess.Popen([sys.executable, *arguments], start_new_session=True, stdout=subprocess.PIPE)

    folder, log = tmp_path / "killed", tmp_path / "log"
    stored = []  # the heights whose rows are there, before every session
    session = 0
    while len(stored) < kills:
        process = start(folder, log, session)
        told = 0  # rows of this session that it said were done
        if chance.random() < 0.1:
            time.sleep(chance.uniform(0, 2))  # wherever it is
        else:
            told = chance.randint(0, 19)
            for _ in range(told + 1):  # the first line comes before any row
                process.stdout.readline()
            time.sleep(chance.uniform(0, 0.03))
        assert process.poll() is None, "the sweep ended before it was killed"
        if chance.random() < 0.5:
            os.kill(process.pid, signal.SIGKILL)  # its workers see to themselves
        else:
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        known = len(stored[-1]) if stored else 0
        stored.append({row.stated["drop_height"][0] for row in rows_of(folder)})
        assert len(stored[-1]) >= known + told, "a finished row was lost"
        session += 1
    for ended in (start(folder, log, session), start(tmp_path / "whole", tmp_path / "other", 0)):
        ended.communicate()
        assert ended.returncode == 0

    computed = [line.split() for line in log.read_text().splitlines()]
    again = [(int(when), float(height)) for when, height in computed]
    assert all(height not in stored[when - 1] for when, height in again if when), "a stored row was computed again"
    assert all(before <= after for before, after in pairwise(stored)), "a row was lost"
    assert sum(before < after for before, after in pairwise([set(), *stored])) > kills / 2, "kills before any row"
    heights = [height for _, height in again]
    assert len(set(heights)) == rows
    quickest = min(row.wall_s for row in rows_of(folder))
    in_flight = 4 * max(int(batch.TOGETHER / quickest), 1)  # two tasks for each worker
    assert len(heights) - rows <= in_flight * kills
    with sqlite3.connect(folder / sweep_store.ROWS) as database:
        assert database.execute("SELECT count(*), count(DISTINCT key) FROM rows").fetchone() == (rows, rows)
    assert table(folder) == table(tmp_path / "whole")
    counts = [len(each) for each in stored]
    print(f"{kills} kills, {rows} rows, stored after each {counts}, {len(heights) - rows} computed again")


FORKED = pytest.mark.skipif(sys.platform != "linux", reason="processes are forked")


@FORKED
@pytest.mark.parametrize(
    "kills", [pytest.param(3, marks=pytest.mark.slow), pytest.param(50, marks=pytest.mark.exhaustive)]
)
def test_kills_at_random_moments_lose_nothing_and_repeat_what_was_in_flight_alone(tmp_path, kills):
    survive(tmp_path, kills)


@FORKED
@pytest.mark.exhaustive
def test_rows_that_are_stored_ten_at_a_time_would_be_found_missing(tmp_path):
    with pytest.raises(AssertionError, match=r"a finished row was lost|<= \(\d+ \* 3\)"):  # or computed again
        survive(tmp_path, 3, "late")


def test_definitions_are_plain_and_say_where_they_come_from(ball, tmp_path):
    model = engine_model("bouncing_ball", laws={"floor": "hunt_crossley"})
    sweep(model, {"mass": "0.1..0.2 kg:2"}, out=tmp_path / "a", **BALL)
    record = json.loads((tmp_path / "a" / sweep_store.DEFINITION).read_text())
    assert (record["target"], record["laws"]) == ("bouncing_ball", {"floor": "hunt_crossley"})
    assert record["over"] == {"mass": "0.1..0.2 kg:2"}
    assert record["seed"] == 0
    assert {"hertzwerk", "casadi", "numpy"} <= set(record["versions"])
