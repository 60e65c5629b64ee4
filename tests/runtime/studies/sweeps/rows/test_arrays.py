"""Sections and histories of a sweep: closed forms, single runs bitwise, a store that keeps them, faults all at once."""

import csv
import json
import math
import sqlite3

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Sweep, simulate, sweep
from hertzwerk.runtime.studies.sweeps import sweep_store
from hertzwerk.runtime.studies.sweeps.rows import poincare_section

CRANK = {"duration": "6 rev", "tolerance": 1e-7, "compiled": False, "workers": 1}
BALL = {"duration": "2 s", "tolerance": 1e-10, "compiled": False, "workers": 1}
FREE = {"gravity": "0 m/s^2", "start_angle": "0.25 rad"}


def test_returns_of_the_drive_are_whole_turns_with_the_states_of_the_run_bitwise(crank):
    table = sweep(
        crank, {"crank_speed": "3000, -5000 rpm"}, section="main_bearing.angle = 90 deg", after="2 rev", **CRANK
    )
    for row, speed in zip(table, (3000, -5000), strict=True):
        first = 2.25 if speed > 0 else 2.75  # backwards 90 degrees come after three quarters of a turn
        actual = table.section.of(row)
        assert actual["t"] == pytest.approx((first + np.arange(4)) * 60 / abs(speed), rel=1e-15)
        run = simulate(crank, parameters=row.stated, duration="6 rev", tolerance=1e-7, compiled=False)
        for name in ("crank_pin.angle", "guide.speed"):
            assert np.array_equal(actual[name], run.at(actual["t"])[name])
    assert table.section.units == {
        "t": "s", "crank_pin.angle": "rad", "guide.travel": "m", "crank_pin.speed": "rad/s", "guide.speed": "m/s",
    }  # fmt: skip


def test_the_phase_of_what_depends_on_time_is_that_of_a_constant_drive(crank):
    one, other = (
        sweep(crank, {"crank_speed": "3000 rpm"}, section=place, **CRANK).section["t"][0]
        for place in ("phase = 0.5 rad", "main_bearing.angle = 0.5 rad")
    )
    assert len(one) == 6
    assert one == pytest.approx(other, rel=1e-14)


@pytest.mark.parametrize("direction", ["rising", "falling", "both"])
@pytest.mark.parametrize("speed", [7.0, -7.0])
def test_a_body_that_turns_freely_returns_after_whole_turns(direction, speed):
    """Closed form: angle 0.25 + w t is 1 modulo 2 pi."""
    (row,) = table = sweep(
        *("pendulum", {"hinge.speed": f"{speed} rad/s"}), parameters=FREE, section=f"hinge.angle = 1 rad {direction}",
        after="1 s", duration="5 s", tolerance=1e-10, compiled=False, workers=1,
    )  # fmt: skip
    turns = np.arange(-10, 10)
    times = np.sort((0.75 + 2 * math.pi * turns) / speed)
    known = times[(times > 1) & (times <= 5)] if direction in ("both", "rising" if speed > 0 else "falling") else []
    actual = table.section.of(row)
    assert actual["t"] == pytest.approx(np.array(known), abs=1e-12)
    assert actual["hinge.angle"] == pytest.approx(0.25 + speed * actual["t"], rel=1e-12)
    assert np.all(np.abs(np.sin((actual["hinge.angle"] - 1) / 2)) < 1e-14)


def test_a_return_at_the_end_of_the_transient_belongs_to_it():
    """An angle of .25 + 2 pi n t returns at 1 s, which rounding has on either side of `after`."""
    speeds = [2 * math.pi * n for n in range(1, 8)]
    table = sweep(
        *("pendulum", {"hinge.speed": [f"{speed!r} rad/s" for speed in speeds]}), parameters=FREE,
        section="hinge.angle = 0.25 rad", after="1 s", duration="1.9 s", tolerance=1e-10, compiled=False, workers=1,
    )  # fmt: skip
    for n, row in enumerate(table, 1):
        known = np.arange(n + 1, 1.9 * n) / n
        assert table.section.of(row)["t"] == pytest.approx(known, abs=1e-12)


def test_a_section_that_trusts_rounding_counts_some_of_them(monkeypatch):
    monkeypatch.setattr(poincare_section, "EDGE", 0.0)
    with pytest.raises(AssertionError):
        test_a_return_at_the_end_of_the_transient_belongs_to_it()


def test_events_are_those_of_rigid_bounces(ball):
    """An elastic ball strikes after the time of fall and then of flight; Hertz's contacts last 0.1 ms."""
    table = sweep(
        *(ball, {"drop_height": "0.5, 1 m"}), parameters={"restitution": 1},
        section="floor.gap = 0 m falling", histories=["vertical.speed", "floor.gap"], **BALL,
    )  # fmt: skip
    for row, height in zip(table, (0.5, 1.0), strict=True):
        fall, speed = math.sqrt(2 * height / 9.81), math.sqrt(2 * 9.81 * height)
        actual = table.section.of(row)
        run = simulate(ball, parameters={"restitution": 1, **row.stated}, duration="2 s", tolerance=1e-10)
        assert actual["t"] == pytest.approx([impact.t for impact in run.impacts], rel=1e-13)
        assert len(actual["t"]) == math.floor((2 / fall + 1) / 2)
        assert np.all(np.abs(actual["floor.gap"]) < 1e-14)
        assert actual["vertical.speed"] == pytest.approx(-speed, rel=1e-6)


def test_crossings_within_a_step_are_all_found(ball):
    """Thrown up, a ball passes a height twice, however long the steps of free flight are."""
    how = {"parameters": {"vertical.travel": "10 m"}, "duration": "0.5 s", "tolerance": 1e-10, "compiled": False}
    height = 10 + 3 * 0.302 - 9.81 * 0.302**2 / 2
    up, down = np.sort(np.roots([-9.81 / 2, 3, 10 - height]))
    both = sweep(ball, {"vertical.speed": "3 m/s"}, section=f"vertical.travel = {height!r} m both", workers=1, **how)
    assert both.section["t"][0] == pytest.approx([up, down], rel=1e-10)
    falling = sweep(ball, {"vertical.speed": "3 m/s"}, section="vertical.speed=0 falling", workers=1, **how)
    assert falling.section["t"][0] == pytest.approx([3 / 9.81], rel=1e-12)


def test_a_section_without_subdivided_steps_would_miss_crossings(ball, monkeypatch):
    monkeypatch.setattr(poincare_section, "LEAST_PARTS", 1)
    monkeypatch.setattr(poincare_section, "MOST_PARTS", 1)
    with pytest.raises(AssertionError):
        test_crossings_within_a_step_are_all_found(ball)


@pytest.mark.parametrize(("name", "value"), [("TURN", 6.2831), ("WHOLE", 1.0)])
def test_a_wrong_turn_or_end_shows(crank, monkeypatch, name, value):
    monkeypatch.setattr(poincare_section, name, value)
    with pytest.raises(AssertionError):
        test_returns_of_the_drive_are_whole_turns_with_the_states_of_the_run_bitwise(crank)


def test_histories_on_a_grid_are_those_of_the_run(crank):
    how = {"grid": "1 ms", "after": "4 ms", "histories": ["guide.acceleration", "slider_pin.normal_force"]}
    (row,) = table = sweep(crank, {"clearance": "0.2 mm"}, **how, **{**CRANK, "duration": "10 ms"})
    run = simulate(crank, parameters=row.stated, duration="10 ms", tolerance=1e-7, compiled=False)
    actual = table.histories.of(row)
    assert actual["t"] == pytest.approx(np.arange(4, 11) * 1e-3, rel=1e-15)
    for name in how["histories"]:
        assert np.array_equal(actual[name], run.at(actual["t"])[name])
    assert table.histories.units == {"t": "s", "guide.acceleration": "m/s^2", "slider_pin.normal_force": "N"}
    assert row.arrays["histories"].data != row.arrays["histories"].array.tobytes()
    with pytest.raises(LookupError, match="section="):
        _ = table.section


def test_a_run_that_ends_early_has_the_points_it_reached(crank):
    (row,) = table = sweep(crank, {"clearance": "0.2 mm"}, section="main_bearing.angle = 0", max_steps=1200, **CRANK)
    assert row.outcome == "too_many_steps"
    (short,) = table.section["t"]
    assert 0 < len(short) < 6
    nothing = sweep(crank, {"clearance": "-1, 0.2 mm"}, section="main_bearing.angle = 0", **CRANK)
    assert [len(t) for t in nothing.section["t"]] == [0, 6]


def test_a_store_keeps_arrays_with_their_rows_bitwise(ball, tmp_path):
    over = {"drop_height": "0.5..1 m:4"}
    how = {"section": "floor.gap = 0 falling", "grid": 11, "outputs": ["impacts"], **BALL}
    plain = sweep(ball, over, **how)
    table = sweep(ball, over, out=tmp_path / "a", **how)
    assert (
        [row.arrays for row in table]
        == [row.arrays for row in plain]
        == [row.arrays for row in Sweep.load(tmp_path / "a")]
    )
    texts = {name: (tmp_path / "a" / name).read_bytes() for name in ("table.csv", "section.csv", "histories.csv")}
    with sqlite3.connect(tmp_path / "a" / sweep_store.ROWS) as rows:
        (key,) = rows.execute("SELECT key FROM points WHERE number = 2").fetchone()
        rows.execute("DELETE FROM rows WHERE key = ?", (key,))
    for name in texts:
        (tmp_path / "a" / name).unlink()
    sweep(ball, over, out=tmp_path / "a", **how)
    assert {name: (tmp_path / "a" / name).read_bytes() for name in texts} == texts
    for change in ({"section": "floor.gap = 0 rising"}, {"after": "0.1 s"}, {"grid": 12}, {"histories": ["floor.gap"]}):
        with pytest.raises(InputError, match="as of the sweep there"):
            sweep(ball, over, out=tmp_path / "a", **{**how, **change})
    sweep(ball, over, out=tmp_path / "a", widen=True, **{**how, "after": "0.1 s"})
    with sqlite3.connect(tmp_path / "a" / sweep_store.ROWS) as rows:
        assert rows.execute("SELECT count(*) FROM rows").fetchone() == (8,)


def test_files_open_without_hertzwerk(ball, tmp_path):
    table = sweep(
        ball, {"drop_height": "0.5, 1 m"}, section="floor.gap = 0 falling", histories=["vertical.speed"], **BALL
    )
    arrays = table.section
    with open(arrays.to_csv(tmp_path / "a.csv"), newline="") as file:  # noqa: PTH123
        head, *lines = csv.reader(file)
    assert head == ["row", "drop_height [m]", "t [s]", "vertical.speed [m/s]"]
    for i, speeds in enumerate(arrays["vertical.speed"]):
        mine = [line for line in lines if line[0] == str(i)]
        assert np.array_equal([float(line[3]) for line in mine], speeds)
        assert {float(line[1]) for line in mine} == {(0.5, 1.0)[i]}
    record = json.loads(arrays.to_json(tmp_path / "a.json").read_text())
    assert record["units"] == {"drop_height": "m", "t": "s", "vertical.speed": "m/s"}
    assert [row["arrays"]["t"] for row in record["rows"]] == [t.tolist() for t in arrays["t"]]
    with pytest.raises(FileExistsError):
        arrays.to_csv(tmp_path / "a.csv")


@pytest.mark.parametrize(
    ("given", "faults"),
    [
        ({"section": "main_bering.angle = 0"}, {"main_bering.angle": "did you mean main_bearing.angle"}),
        ({"section": "guide.travel"}, {"section": "NAME = VALUE"}),
        ({"section": "guide.travel = 1 kg"}, {"section, guide.travel": "a value in m"}),
        ({"section": "guide.travel = 1"}, {"section, guide.travel": "without a unit"}),
        ({"section": "main_bearing.angle = 0 rising"}, {"section": "turns one way"}),
        ({"section": "guide.travel = x m", "grid": "x", "histories": ["guide"]}, {"section": "x m", "guide": "history"}),
        ({"section": "phase = 0", "after": "9 rev"}, {"after": "less than the duration"}),
        ({"section": "phase = 0", "after": "1 kg", "grid": "2 N"}, {"after": "1 kg"}),
        ({"grid": "2 N"}, {"grid": "2 N"}),
        ({"after": "1 ms", "histories": ["guide.travel"]}, {"after": "section or a grid", "histories": "section"}),
        ({"section": 3, "histories": "guide.travel"}, {"section": "3", "histories": "a list of names"}),
        ({"grid": "steps"}, {"grid": "steps"}),
    ],
)  # fmt: skip
def test_bad_input_is_reported_at_once(crank, given, faults):
    with pytest.raises(InputError) as caught:
        sweep(crank, {"clearance": "0.1, 0.2 mm"}, **given, **CRANK)
    reported = {fault.where: str(fault) for fault in caught.value.faults}
    assert set(faults) <= set(reported)
    for where, text in faults.items():
        assert text in reported[where]


def test_a_section_of_a_drive_is_not_offered_without_one(ball):
    with pytest.raises(InputError, match="no history or angle of a drive of this name"):
        sweep(ball, {"drop_height": "1 m"}, section="phase = 0", **BALL)
