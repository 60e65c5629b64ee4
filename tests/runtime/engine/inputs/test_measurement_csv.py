"""Measured data are read as they stand, and every fault is found with its line."""

from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Measurement, read_measurement

GOOD = "# oscilloscope\ntime [ms],a [mm/s^2],note [V]\n0,1,x\n0.5,,y\n\n1.5,nan,z\n2,-4e3,0\n"


def written(folder, text, name="data.csv"):
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


def faults_of(folder, text, columns=None):
    with pytest.raises(InputError) as error:
        read_measurement(written(folder, text), columns)
    return [str(fault).replace("\n   ", "") for fault in error.value.faults]


def test_columns_are_read_with_units_and_missing_samples_also_of_a_written_run(tmp_path):
    data = read_measurement(written(tmp_path, GOOD), ["a"])
    assert data.times.tolist() == [0, 0.0005, 0.0015, 0.002]
    np.testing.assert_equal(data.columns, {"a": np.array([1, np.nan, np.nan, -4e3])})
    np.testing.assert_allclose(data.si("a"), [1e-3, np.nan, np.nan, -4.0], rtol=1e-15)
    assert data.source.endswith("data.csv") and data.units == {"a": "mm/s^2"}
    from hertzwerk.runtime import load, simulate

    run = simulate(load("soft_ball"), duration="20 ms", tolerance=1e-6)
    data = read_measurement(run.to_file(tmp_path / "states.csv"), ["vertical.travel", "floor.normal_force"])
    assert np.array_equal(data.times, run.t) and np.array_equal(
        data.si("floor.normal_force"), run["floor.normal_force"]
    )


@pytest.mark.parametrize("delimiter", [";", "\t", " , "])
def test_other_delimiters_quotes_and_a_byte_order_mark_are_read(tmp_path, delimiter):
    text = f'\ufeff"t [s]"{delimiter}"x [m]"\n1{delimiter}"2"\n3{delimiter}4'
    data = read_measurement(written(tmp_path, text))
    assert (data.times.tolist(), data.columns["x"].tolist()) == ([1, 3], [2, 4])


def test_two_lines_of_one_time_are_a_jump_of_which_the_later_counts(tmp_path):
    data = read_measurement(written(tmp_path, "t [s],a [m]\n0,1\n1,2\n1,\n2,4\n2,5\n3,6\n"))
    assert data.times.tolist() == [0, 1, 2, 3]
    np.testing.assert_equal(data.columns["a"], np.array([1, np.nan, 5, 6]))
    assert data.jumps == 2
    for text in ("t [s],a [m]\n0,1\n1,2\n1,3\n1,4\n2,5\n", "t [s],a [m]\n0,1\n1,2\n1,3\n1,4\n1,5\n2,5\n"):
        assert "line 5: found the time 1, a third time" in faults_of(tmp_path, text)[0]


def test_the_file_of_a_run_with_two_rows_at_an_event_is_compared(tmp_path):
    from hertzwerk.runtime import compare, load, simulate

    run = simulate(load("soft_ball"), duration="1 s", tolerance=1e-9)
    onset = int(np.searchsorted(run.t, run.impacts[0].t))
    rows = run.engine.history.rows[np.sort([*range(len(run.t)), onset])]
    twice = replace(run, engine=replace(run.engine, history=run.engine.history.of(rows)))
    assert np.sum(np.diff(twice.t) == 0) == 1
    comparison = compare(run, twice.to_file(tmp_path / "states.csv"), map={"vertical.travel": "vertical.travel"})
    assert comparison.signals[0].residual.rms < 1e-12
    assert "1 times are repeated" in str(comparison)


def test_all_faults_of_a_file_come_at_once_with_their_lines_and_long_lists_are_cut(tmp_path):
    text = 't [s],a [m/s^2],b [furlong],c,d [m]\n0,1,1,1,1\n1,x,1,1,inf\n1,2,1,1,2\n0.5,2,1,1,2\n,2,1,1,2\n7,2\n8,2,1,1,"3,5"\n'
    actual = faults_of(tmp_path, text)
    for expected in (
        "line 1, b: found 'b [furlong]'", "line 1, c: found 'c'; expected name [unit] [1] for a plain number",
        "line 3, a: found 'x'", "line 3, d: found 'inf'", "line 5: found the time 0.5, after 1",
        "line 6: found no time", "line 7: found 2 cells; expected 5",
        "line 8, d: found '3,5', and '0.5' in line 5, t; expected one decimal mark",
    ):  # fmt: skip
        assert any(expected in fault for fault in actual), (expected, actual)
    assert len(actual) == 8
    result = faults_of(tmp_path, "t [s];a [m]\n" + "".join(f"{i};{i}x\n" for i in range(30)))
    assert len(result) == 21 and "line 2, a: found '0x'" in result[0] and "10 faults more" in result[-1]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a [m],b [m]\n1,2\n2,3\n", "one time column"), ("t [s],time [s]\n1,2\n2,3\n", "t, time among"),
        ("t [m],b [m]\n1,2\n2,3\n", "a unit of time"), ("t [s],b [m],b [m]\n1,2,3\n2,3,4\n", "2 columns of this name"),
        ("t [s],b [m]\n1,2\n", "two or more"), ("t [s],b [m]\n1,\n2,nan\n", "no sample"), ("# only this\n", "no lines"),
    ],
)  # fmt: skip
def test_headings_and_sizes_are_checked(tmp_path, text, expected):
    assert any(expected in fault for fault in faults_of(tmp_path, text))


def test_an_unknown_column_and_an_unreadable_file_are_refused(tmp_path):
    assert any(
        "did you mean acceleration?" in f
        for f in faults_of(tmp_path, "t [s],acceleration [m/s^2]\n1,2\n2,3\n", ["accleration"])
    )
    (tmp_path / "binary.csv").write_bytes(b"\xff\xfe\x00")
    for name, expected in (("binary.csv", "not UTF-8"), ("absent.csv", "no such file"), (".", "a folder")):
        with pytest.raises(InputError, match=expected):
            read_measurement(tmp_path / name)


@pytest.mark.parametrize(
    ("times", "values", "unit"),
    [([0, 1], [1], "m"), ([0, 0], [1, 2], "m"), ([1, 0], [1, 2], "m"), ([0, np.nan], [1, 2], "m"), ([0, 1], [1, 2], "furlong")],
)  # fmt: skip
def test_a_record_refuses_to_exist_if_it_is_wrong(times, values, unit):
    with pytest.raises(InputError):
        Measurement(np.array(times), {"x": np.array(values)}, {"x": unit})
