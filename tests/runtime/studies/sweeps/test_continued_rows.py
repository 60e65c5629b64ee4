"""Values followed up and down: each row is the run from the end of the one before, bitwise, whatever was stored already."""

import sqlite3
import subprocess
import sys

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Sweep, simulate, sweep
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps import sweep_store

CRANK = {
    "duration": "2 rev", "tolerance": 1e-6, "compiled": False, "workers": 1, "section": "main_bearing.angle = 0",
    "histories": ["slider_pin.eccentricity_x"],
}  # fmt: skip
OVER = {"crank_speed": "3000..5000 rpm:4"}


def test_a_contact_in_progress_goes_on_as_it_was():
    """Cut within a contact, the motion goes on as the whole one, if the approach speed is handed over; not without."""
    ball, how = engine_model("bouncing_ball"), {"tolerance": 1e-11, "compiled": False}
    whole = simulate(ball, duration="0.6 s", **how)
    impact = whole.impacts[0]
    cut = impact.t + impact.duration * 0.3
    state = whole.at([cut])
    start = {name: (float(state[name][0]), ball.units[name]) for name in ("vertical.travel", "vertical.speed")}
    latch = {"floor.approach_speed": (float(state["floor.approach_speed"][0]), "m/s")}
    rest = simulate(ball, duration=0.6 - cut, initial={**start, **latch}, **how)
    anew = simulate(ball, duration=0.6 - cut, initial=start, **how)
    assert rest.engine.final["vertical.travel"] == pytest.approx(whole.engine.final["vertical.travel"], abs=1e-8)
    assert abs(anew.engine.final["vertical.travel"] - whole.engine.final["vertical.travel"]) > 1e-4
    with pytest.raises(InputError, match="a value in m/s"):
        simulate(ball, duration="0.1 s", initial={"floor.approach_speed": "1 kg"})


@pytest.mark.parametrize("continued", ["up", "down"])
def test_each_value_starts_from_the_end_of_the_one_before_bitwise(crank, continued):
    table = sweep(crank, OVER, continued=continued, **CRANK)
    names = [*crank.coordinates, *crank.speeds, *crank.latches]
    units = {**crank.units, "slider_pin.approach_speed": "m/s"}
    start = {}
    for row in table if continued == "up" else reversed(table.rows):
        run = simulate(crank, parameters=row.stated, initial=start, duration="2 rev", tolerance=1e-6, compiled=False)
        assert row.final == run.engine.final
        assert list(row.stated) == ["crank_speed"]
        start = {name: (float(run.engine.ends[name][-1]), units[name]) for name in names}
    assert list(table["crank_speed"]) == sorted(table["crank_speed"])


def test_up_and_down_differ_and_so_do_their_keys(crank, tmp_path):
    up, down, plain = (
        sweep(crank, OVER, out=tmp_path / str(way), continued=way, **CRANK) for way in ("up", "down", None)
    )
    assert np.all(up["final.guide.travel"][1:3] != down["final.guide.travel"][1:3])
    assert up["final.guide.travel"][0] == plain["final.guide.travel"][0]
    assert down["final.guide.travel"][-1] == plain["final.guide.travel"][-1]
    keys = [keys_in(tmp_path / str(way)) for way in ("up", "down", None)]
    assert len({key for some in keys for key in some}) == 12
    wider = {"crank_speed": "2500, 3000, 3666.6666666666665, 4333.333333333333, 5000 rpm"}
    sweep(crank, wider, out=tmp_path / "up", continued="up", widen=True, **CRANK)
    assert not set(keys[0]) & set(keys_in(tmp_path / "up"))  # another start of the first: another of every one


def keys_in(folder):
    with sqlite3.connect(folder / sweep_store.ROWS) as rows:
        return [key for (key,) in rows.execute("SELECT key FROM points ORDER BY number")]


@pytest.mark.parametrize("lost", [(1,), (0, 2), (3,), (1, 2, 3)])
def test_rows_that_are_missing_are_followed_from_those_that_are_there(crank, tmp_path, lost):
    whole = sweep(crank, OVER, out=tmp_path / "a", continued="up", **CRANK)
    texts = {name: (tmp_path / "a" / name).read_bytes() for name in ("table.csv", "section.csv")}
    keys = keys_in(tmp_path / "a")
    with sqlite3.connect(tmp_path / "a" / sweep_store.ROWS) as rows:
        for i in lost:
            rows.execute("DELETE FROM rows WHERE key = ?", (keys[i],))
    again = sweep(crank, OVER, out=tmp_path / "a", continued="up", **CRANK)
    assert {name: (tmp_path / "a" / name).read_bytes() for name in texts} == texts
    assert [row.arrays for row in again] == [row.arrays for row in whole]


FALLS = {
    "over": {"restitution": "0.5..0.9:40"}, "duration": "3 s", "tolerance": 1e-10, "compiled": False, "workers": 1, "continued": "up",
}  # fmt: skip
FOLLOWED = f"""
import os, sys
from hertzwerk.runtime import sweep
sweep("bouncing_ball", **{FALLS}, out=sys.argv[1], progress=lambda fraction: os.write(1, b"row\\n"))
"""


@pytest.mark.slow
def test_a_chain_that_is_killed_goes_on_from_the_rows_that_are_stored(tmp_path):
    """Killed after 3 and after 6 more rows; the end is bitwise that of a chain that was left alone, and no row is repeated."""
    command, stored = [sys.executable, "-c", FOLLOWED, str(tmp_path / "killed")], []
    for reported in (3, 6):
        process = subprocess.Popen(command, stdout=subprocess.PIPE)
        for _ in range(reported + 1):  # the first line comes before any row
            assert process.stdout.readline()
        process.kill()
        process.communicate()
        rows = Sweep.load(tmp_path / "killed").rows
        assert [row.index for row in rows] == list(range(len(rows)))
        stored.append({row.index: row.wall_s for row in rows})
    assert len(stored[0]) >= 3
    assert len(stored[1]) >= len(stored[0]) + 6
    assert len(stored[-1]) < 40, "it ended before it was killed"
    killed, whole = (sweep("bouncing_ball", **FALLS, out=tmp_path / folder).rows for folder in ("killed", "whole"))
    assert len(whole) == 40
    assert [row.outputs for row in killed] == [row.outputs for row in whole]
    assert [row.arrays for row in killed] == [row.arrays for row in whole]
    for known in stored:  # a row that is there is not computed again: its time stays
        assert {row.index: row.wall_s for row in killed if row.index in known} == known


def test_several_starts_are_followed_side_by_side(crank):
    over = {**OVER, "guide.travel": "169.8, 170 mm"}
    both = sweep(crank, over, continued="up", **{**CRANK, "workers": 2})
    for i, place in enumerate(("169.8 mm", "170 mm")):
        alone = sweep(crank, OVER, parameters={"guide.travel": place}, continued="up", **CRANK)
        assert np.array_equal(both["final.guide.travel"][i::2], alone["final.guide.travel"])
        assert np.isfinite(alone["final.guide.travel"]).all()
        assert both["guide.travel"][i::2] == pytest.approx(float(place.split()[0]) * 1e-3)


def test_a_row_that_failed_hands_on_the_start_it_had(crank):
    over = {"clearance": "-0.1, 0.2, 0.3 mm"}
    with_failure = sweep(crank, over, continued="up", **CRANK)
    without = sweep(crank, {"clearance": "0.2, 0.3 mm"}, continued="up", **CRANK)
    assert with_failure.counts() == {"finished": 2, "bad_input": 1}
    assert np.array_equal(with_failure["final.guide.travel"][1:], without["final.guide.travel"])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"continued": "sideways"}, "up or down"),
        ({"duration": "2.5 rev"}, "a whole number of periods"),
        ({"over": {"crank_pin.angle": "0, 1 deg"}}, "no parameter that is varied"),
    ],
)
def test_bad_input_is_reported(crank, change, message):
    with pytest.raises(InputError, match=message):
        sweep(crank, **{"over": OVER, "continued": "up", **CRANK, **change})
