"""Inputs as users give them: what becomes of arrays, tables, functions and files, and every fault at once."""

import math

import numpy as np
import pytest
from shaken import shaken

from hertzwerk.derive import InputError, Table
from hertzwerk.runtime import Samples, simulate
from hertzwerk.runtime.engine.inputs.input_values import located, signals_of, with_input_values
from hertzwerk.runtime.engine.inputs.time_series import sampled
from hertzwerk.runtime.engine.model.signal import Schedule

TIMES = np.array([0.0, 0.3, 0.5, 2.0])
VALUES = np.array([1.0, -2.0, 4.0, 0.0])


def signal(value, seconds=2.0):
    faults = []
    found = signals_of(shaken(), {"push": value}, seconds, faults)
    assert not faults, faults
    return found["push"]


def refused(value, seconds=2.0):
    faults = []
    signals_of(shaken(), {"push": value}, seconds, faults)
    return "\n".join(map(str, faults))


@pytest.mark.parametrize("value", ["3 N", (0.003, "kN"), "0.003 kN"])
def test_a_constant(value):
    assert signal(value)(np.array([0.0, 1e9])) == pytest.approx([3.0, 3.0], rel=1e-15)


def test_samples_are_held_joined_or_a_spline_and_tables_are_joined():
    t = np.linspace(0, 2, 1001)
    np.testing.assert_allclose(signal((TIMES, VALUES))(t), np.interp(t, TIMES, VALUES), rtol=0, atol=1e-14)
    held = signal(Samples(1e3 * TIMES, 1e-3 * VALUES, ("ms", "kN"), "held"))
    np.testing.assert_allclose(held(t), VALUES[np.searchsorted(TIMES, t, side="right") - 1], rtol=1e-15)
    assert held.end == 3.5  # the last one as long as the one before
    cubic = signal(Samples(t, np.sin(3 * t), ("s", "N"), "cubic"))
    np.testing.assert_allclose(cubic(t[:-1] + 1e-3), np.sin(3 * (t[:-1] + 1e-3)), rtol=0, atol=1e-11)
    held = signal(Samples(range(6), (1, 1, 1, 2, 2, 3), ("s", "N"), "held"))
    assert list(held.begins) == [0, 3, 5]
    table = Table("lift", (0, 1000, 2000), (0, 1, 0), ("ms", "kN"))
    assert signal(table)(np.array([0.0, 1.0, 2.0])) == pytest.approx([0, 1000, 0], abs=1e-9)


@pytest.mark.parametrize(
    "function", [lambda t: 4 * math.cos(30 * t), lambda t: 4.0 if t < 1.2345 else -1.0, lambda t: abs(math.sin(5 * t)), lambda t: 7.0],
    ids=["smooth", "jump", "kink", "constant"],
)  # fmt: skip
def test_a_function_is_sampled_to_its_accuracy(function):
    result = signal(function)
    times = np.random.default_rng(1).uniform(0, 2, 2000)
    assert np.max(np.abs(result(times) - [function(t) for t in times])) < 2e-10 * 7


def test_a_jump_of_a_function_is_where_it_is():
    result = signal(lambda t: 4.0 if t < 1.2345 else -1.0)
    assert np.min(np.abs(result.begins - 1.2345)) < 1e-12 and len(result.begins) < 70


def test_a_function_that_cannot_be_resolved_is_refused(monkeypatch):
    rng = np.random.default_rng(0)
    assert "do not resolve" in refused(lambda t: rng.random())
    monkeypatch.setattr("hertzwerk.runtime.engine.inputs.time_series.MOST", 1000)
    assert "as samples" in refused(lambda t: math.sin(1e9 * t))
    assert "ZeroDivisionError at t = 0 s" in refused(lambda t: 1 / t)
    assert "nan at t" in refused(lambda t: math.nan)


def test_a_column_of_a_file_is_read_with_the_arguments_behind_its_name(own_folder):
    path = own_folder / "bench.csv"
    path.write_text("time [ms],load [kN],other [m]\n0,1,0\n300,-2,0\n400,nan,0\n500,4,0\n2000,0,0\n")
    t = np.linspace(0, 2, 1001)
    np.testing.assert_allclose(signal(f"{path}:load")(t), 1e3 * np.interp(t, TIMES, VALUES), atol=1e-10)
    assert signal(f"{path}:load:held")(np.array([0.29])) == pytest.approx([1000])
    assert "no column of this name" in refused(f"{path}:force") and "values in N" in refused(f"{path}:other")
    assert "one of linear, held, cubic" in refused(f"{path}:load:bent") and "no such file" in refused("none.csv:load")
    path.write_text("made by hand\nZeit;1.5;CH 2\n0;15;1,234\n300;25;-999\n2000;35;2,345\n")
    text = (
        f"{path}?skip=1&decimal=,&units.time=ms&columns.time=1&units.load=kN&columns.load=CH 2&missing=-999:load:held"
    )
    actual = signal(text)
    np.testing.assert_allclose(actual(np.array([0.0, 0.4, 2.0])), [1234, 1234, 2345])
    assert located(f"torque={text}".replace(f"{path}", "bench.csv"), own_folder) == f"torque={text}"
    assert "?mark: found no argument; expected skip, decimal" in refused(f"{path}?mark=,:load")
    assert "two numbers" in refused(
        f"{path}?skip=1&units.time=ms&columns.time=1&units.load=kN&columns.load=CH 2&missing=-999:load"
    )


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("3 m", "expected a value in N"), (3.0, "3, a number without a unit"), (None, "a value such as"), (True, "a value such as"),
        (Samples((0, 1), (1, 2), ("m", "N")), "a unit of time"), (Samples((0, 1), (1, 2), ("s", "m")), "values in m"),
        (Samples((0, 1), (1, 2), ("s", "pushes")), "unit 'pushes'"), (Samples((0, 1), (1, 2), ("s", "N"), "bent"), "one of linear, held, cubic"),
        (Samples((0, 1, 1, 0.5), (1, 2, 3, 4), ("s", "N")), "the time 1 after 1 in place 3, and 1 more like it"),
        (Samples((0, 1), (1, math.nan), ("s", "N")), "the value nan in place 2"), (Samples((0,), (1,), ("s", "N")), "two or more"),
        (Samples((0, 1), (1, "x"), ("s", "N")), "an array of times"), (Table("lift", (0, 1), (0, 1), ("s", "m")), "values in m"),
        (Table("lift", (1, 0), (0, 1), ("s", "N")), "arguments that increase"),
    ],
)  # fmt: skip
def test_faults_name_the_input_and_what_is_wrong(value, said):
    text = refused(value)
    assert text.startswith(("input push", "table lift")) and said in text


def test_a_run_reports_all_its_faults_at_once_and_inputs_of_another_scene():
    given = {"psh": "3 N"}
    with pytest.raises(InputError) as error:
        simulate(shaken(), duration="2 s", inputs=given, parameters={"mass": "2 N"}, method="euler")
    text = str(error.value)
    assert "4 faults" in text and all(part in text for part in ("psh", "input push: found no value", "mass", "euler"))
    assert "of the shaker" in text
    with pytest.raises(InputError, match="no input of this name"):
        from hertzwerk.runtime.loading import engine_model

        simulate(engine_model("soft_ball"), duration="1 ms", inputs={"push": "3 N"})


@pytest.mark.parametrize("times", [(0.0, 1.9), (0.1, 2.0)])
def test_values_that_do_not_cover_the_run_are_refused(times):
    with pytest.raises(InputError, match="values over the whole run, from 0 to 2 s"):
        simulate(shaken(), duration="2 s", inputs={"push": (times, (1, 2))})


def test_inputs_are_kept_by_the_model_that_has_them_in_pieces_with_the_breakpoints_of_all():
    model, faults = with_input_values(shaken(), {"push": "3 N"}, "1 s", {})
    assert not faults
    assert model.known is shaken().known  # what is built is shared
    assert simulate(model, duration="1 ms")["push"][-1] == 3
    assert simulate(model, duration="1 ms", inputs={"push": "4 N"})["push"][-1] == 4
    first, second = signal((TIMES, VALUES)), signal(Samples((-1, 0.4, 3), (1, 2, 3), ("s", "N"), "held"))
    schedule = Schedule([first, second])
    assert list(schedule.stops) == [0.0, 0.3, 0.4, 0.5, 3.0]
    assert schedule.place(0.4) == 2 and schedule.stop(2, 0.45) == 0.45 and schedule.stop(4, 9.0) == 9.0
    np.testing.assert_array_equal(schedule.pieces[2], [0.3, -2, 30, 0, 0, 0, 0, 0.4, 2, 0, 0, 0, 0, 0])


@pytest.mark.parametrize(("power", "smooth"), [(0, -1), (1, 0), (2, 1), (3, 2)])
def test_a_function_is_as_smooth_as_its_kink_between_two_pieces_leaves_it(power, smooth):
    """|t - 0.5|^k, halved before: k - 1 of its derivatives are continuous; pieces end at 0.5."""
    signal = sampled(lambda t: abs(t - 0.5) ** power * (1 if t > 0.5 else -0.5), 1.0, "a kink")
    assert 0.5 in signal.begins or power == 0
    assert signal.smooth == smooth
