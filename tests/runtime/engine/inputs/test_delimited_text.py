"""Files as instruments and spreadsheets write them: each is read right, or refused with one clear error."""

import math
import random
from dataclasses import dataclass, field

import numpy as np
import pytest
from each import each

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import read_impacts, read_measurement
from hertzwerk.runtime.engine.inputs.delimited_text import Numbers

NAN = math.nan
TWO = {"t": "s", "x": "mm"}  # units of two columns


@dataclass(frozen=True)
class File:
    """File, the arguments that read it, and times [s] with columns and units, or what the error says."""

    text: str
    expected: tuple[list[float], dict[str, list[float]], str] | str
    how: dict = field(default_factory=dict)
    encoding: str = "utf-8"


TEKTRONIX = "Model,MSO54\n\nHorizontal Units,s\nRecord Length,3\n\nLabels,,\nTIME,CH1,CH2\n-1e-06,0.1,2\n0,0.2,3\n1e-06,9.9E+37,4\n"
KEYSIGHT = "x-axis,1,2\nsecond,Volt,Volt\n-5.0E-04,+1.5E+00,0\n0.0E+00,+2.5E+00,1\n"
PICOSCOPE = "Time,Channel A,Channel B\n(ms),(mV),(V)\n\n-1.50000000,20.5,∞\n-1.40000000,-∞,0.25\n-1.30000000,21.5,0.5\n"
LVM = (
    "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t{mark}\nMulti_Headings\tNo\n"
    "X_Columns\tOne\nTime_Pref\tRelative\nDate\t2026/11/27\nTime\t10:11:12,5\n***End_of_Header***\t\n\t\nChannels\t2\t\t\n"
    "Samples\t3\t3\t\nDate\t2026/11/27\t2026/11/27\t\nTime\t10:11:12,5\t10:11:12,5\t\nY_Unit_Label\tVolts\tVolts\t\nX0\t0,0\t0,0\t\n"
    "Delta_X\t0,001\t0,001\t\n***End_of_Header***\t\t\t\nX_Value\tForce\tTravel\tComment\n"
)
LVM_UNITS = {
    "columns": {"t": "X_Value", "Force": "Force", "Travel": "Travel"},
    "units": {"t": "s", "Force": "V", "Travel": "V"},
}
TRC = (
    "PathFileType\t4\t(X/Y/Z)\tdrop.trc\nDataRate\tUnits\tNumMarkers\n60\t{units}\t2\nFrame#\tTime\tball\t\t\twall\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n1\t0.0\t1\t2\t3\t9\t8\t7\n2\t0.5\t1\t4\t\t9\t8\t6\n"
)
MOTIVE = (
    "Format Version,1.23,Take Name,drop,Capture Frame Rate,100.000000\n\n,,Rigid Body,Rigid Body,Rigid Body,Marker\n"
    ",,Ball,Ball,Ball,Ball:1\n,,Position,Position,Position,Position\nFrame,Time (Seconds),X,Y,Z,X\n"
    "0,0.000000,0.1,0.5,0.2,9\n1,0.010000,0.1,0.4,0.2,9\n2,0.020000,,,,\n"
)

FILES = {
    # oscilloscopes
    "tektronix": File(
        TEKTRONIX,
        ([-1e-6, 0, 1e-6], {"CH1": [0.1, 0.2, NAN], "CH2": [2, 3, 4]}, "V"),
        {"units": {"TIME": "s", "CH1": "V", "CH2": "V"}},
    ),
    "tektronix without units": File(TEKTRONIX, "units={'TIME':"),
    "tektronix, numbers beside the header": File(
        "Record Length,3.0e+00,,-0.005,0.48,\nSample Interval,4.0e-06,,-0.004,0.52,\n,,,-0.003,0.56,\n",
        ([-0.005, -0.004, -0.003], {"x": [0.48, 0.52, 0.56]}, "V"),
        {"columns": {"t": 4, "x": 5}, "units": {"t": "s", "x": "V"}},
    ),
    "keysight": File(
        KEYSIGHT,
        ([-5e-4, 0], {"a": [1.5, 2.5], "b": [0, 1]}, "V"),
        {"columns": {"t": "x-axis", "a": "1", "b": "2"}},
    ),
    "keysight without the time": File(KEYSIGHT, "one time column"),
    "picoscope": File(
        PICOSCOPE,
        ([-1.5e-3, -1.4e-3, -1.3e-3], {"Channel A": [20.5, NAN, 21.5]}, "mV"),
        {"columns": ["Channel A"]},
    ),
    "picoscope, german": File(
        "Zeit;Kanal A\n(ms);(V)\n\n-1,50;0,1234\n-1,40;-1,0001\n",
        ([-1.5e-3, -1.4e-3], {"Kanal A": [0.1234, -1.0001]}, "V"),
    ),
    "rigol counts samples": File("X,CH1,Start,Increment,\nSequence,Volt,-6.0e-03,2.0e-05\n0,0.1,,\n1,0.2,,\n", "one time column"),
    "lecroy": File(
        "LECROYWS,1,Waveform\nSegments,1,SegmentSize,3\nSegment,TrigTime,TimeSinceSegment1\n#1,27-Nov-2026 10:00:00,0\nTime,Ampl\n"
        "-2e-05,0.5\n0,0.25\n2e-05,1\n",
        ([-2e-5, 0, 2e-5], {"Ampl": [0.5, 0.25, 1]}, "V"),
        {"units": {"Time": "s", "Ampl": "V"}},
    ),
    "rohde": File('"in s","C1 in V"\n0,1\n1,2\n', "one time column"),
    "siglent": File(
        "Record Length,Analog:3\nSample Interval,2e-09\nVertical Units,V\nSource,CH1\nSecond,Volt\n0.1,1\n0.2,2\n",
        ([0.1, 0.2], {"u": [1, 2]}, "V"),
        {"columns": {"t": "Second", "u": "Volt"}, "units": {"t": "s", "u": "V"}},
    ),
    "hantek": File(
        "nr,time,ch1\n0,0,-0.16\n1,2e-05,-0.16\n2,4e-05,-0.08\n",
        ([0, 2e-5, 4e-5], {"ch1": [-0.16, -0.16, -0.08]}, "V"),
        {"columns": ["ch1"], "units": {"time": "s", "ch1": "V"}},
    ),
    "meter with overload": File(
        "Time [s];U [V]\n0;1.5\n1;OVL\n2;O.L\n3;OL\n4;****\n", "'****'; expected a finite number"
    ),
    "meter with its own mark": File(
        "Time [s];U [V]\n0;1.5\n1;OVL\n2;O.L\n3;****\n4;-999.00\n",
        ([0, 1, 2, 3, 4], {"U": [1.5, NAN, NAN, NAN, NAN]}, "V"),
        {"missing": ["****", "-999"]},
    ),
    # LabVIEW
    "lvm": File(
        LVM.format(mark=".") + "0.000000\t1.5\t0.25\n0.001000\t1.25\t0.5\n0.002000\t1.0\t0.75\tend\n",
        ([0, 0.001, 0.002], {"Force": [1.5, 1.25, 1], "Travel": [0.25, 0.5, 0.75]}, "V"),
        LVM_UNITS,
    ),
    "lvm, german": File(
        LVM.format(mark=",") + "0,000000\t1,234\t0,25\n0,001000\t1,250\t0,5\n",
        ([0, 0.001], {"Force": [1.234, 1.25], "Travel": [0.25, 0.5]}, "V"),
        LVM_UNITS,
    ),
    "lvm as it is": File(
        LVM.format(mark=".") + "0.000000\t1.5\t0.25\n0.001000\t1.25\t0.5\n",
        ([0, 0.001], {"Force": [1.5, 1.25], "Travel": [0.25, 0.5]}, "V"),
    ),
    "lvm without labels of units": File(
        LVM.format(mark=".").replace("Y_Unit_Label\tVolts\tVolts\t\n", "") + "0.0\t1\t2\n0.1\t1\t2\n", "Force: found 'Force'; expected name [unit]"
    ),
    "lvm over a frequency": File(
        LVM.format(mark=".").replace("X0", "X_Dimension\tFrequency\tFrequency\t\nX0") + "0.0\t1\t2\n0.1\t1\t2\n", "X_Value: found 'X_Value'"
    ),
    "x_value beside a time": File("t [s],X_Value [mm]\n0,1\n1,2\n", "found t, X_Value among 't, X_Value'; expected one time column"),
    "lvm of two blocks": File(
        LVM.format(mark=".") + "0.0\t1\t2\n0.1\t1\t2\nX_Value\tForce\tTravel\tComment\n0.2\t1\t2\n", "line 24, t: found 'X_Value'", LVM_UNITS
    ),
    "labview spreadsheet": File("0.000\t1.5\n0.001\t2.5\n", ([0, 0.001], {"x": [1.5, 2.5]}, "mm"), {"columns": {"t": 1, "x": 2}, "units": TWO}),
    "labview spreadsheet as it is": File("0.000\t1.5\n0.001\t2.5\n", "one time column"),
    # spreadsheets
    "excel": File("t [s],x [mm]\r\n0,1.5\r\n0.5,#N/A\r\n1,2.5\r\n", ([0, 0.5, 1], {"x": [1.5, NAN, 2.5]}, "mm")),
    "excel, old macintosh": File("t [s],x [mm]\r0,1.5\r0.5,2.5", ([0, 0.5], {"x": [1.5, 2.5]}, "mm")),
    "excel, commas at the end": File("t [s],x [mm],\n0,1.5,\n0.5,2.5,\n", ([0, 0.5], {"x": [1.5, 2.5]}, "mm")),
    "excel, commas at the end of numbers": File("t [s],x [mm]\n0,1.5,\n0.5,,\n1,2,\n", ([0, 0.5, 1], {"x": [1.5, NAN, 2]}, "mm")),
    "excel, empty columns": File("t [s],x [mm],,\n0,1.5,,\n0.5,2.5,,\n", ([0, 0.5], {"x": [1.5, 2.5]}, "mm")),
    "excel, text under no heading": File("t [s],x [mm],,\n0,1.5,,\n0.5,2.5,why,\n", "line 3: found 4 cells; expected 2"),
    "excel, thousands": File('t [s],x [mm]\n0,"1,234.5"\n1,"2,500.25"\n', ([0, 1], {"x": [1234.5, 2500.25]}, "mm")),
    "excel, thousands or decimals": File('t [s],x [mm]\n0,"1,234"\n1,"2,500"\n', 'decimal="." reads 1234, decimal="," reads 1.234'),
    "excel, thousands beside decimals": File('t [s],x [mm]\n0.5,"1,234"\n1,"2,500"\n', "which is two numbers"),
    "excel, thousands stated": File(
        't [s],x [mm]\n0.5,"1,234"\n1,"2,500"\n', ([0.5, 1], {"x": [1234, 2500]}, "mm"), {"decimal": "."}
    ),
    "excel, german": File(
        "Zeit [s];Höhe [mm]\r\n0,0;1,5\r\n0,5;#NV\r\n1,0;1.234,5\r\n",
        ([0, 0.5, 1], {"Höhe": [1.5, NAN, 1234.5]}, "mm"),
        encoding="cp1252",
    ),
    "excel, german, two readings": File("t [s];x [mm]\n0;1,234\n1;2,500\n", 'decimal="." reads 1234, decimal="," reads 1.234'),
    "excel, german, stated": File("t [s];x [mm]\n0;1,234\n1;2,500\n", ([0, 1], {"x": [1.234, 2.5]}, "mm"), {"decimal": ","}),
    "excel, german, thousands without decimals": File("t [s];x [mm]\n0,5;1.234\n1;2.500\n", "which is two numbers"),
    "excel, german, whole thousands": File("t [s];x [mm]\n1;1.234\n2;2.500\n", 'decimal="." reads 1.234, decimal="," reads 1234'),
    "three digits after a point": File("t [s];x [mm]\n1;1.234\n2;0.500\n", ([1, 2], {"x": [1.234, 0.5]}, "mm")),
    "excel, german, thousands stated": File(
        "t [s];x [mm]\n0,5;1.234\n1;2.500\n", ([0.5, 1], {"x": [1234, 2500]}, "mm"), {"decimal": ","}
    ),
    "excel, two decimal marks": File("t [s];x [mm]\n0,5;1.5\n1;2\n", "'0,5', and '1.5' in line 2, x; expected one decimal mark"),
    "excel, decimal commas between commas": File("t [s],x [mm]\n0,5,1,5\n1,0,2,5\n", "found 4 cells; expected 2"),
    "excel, quoted decimal commas": File('"t [s]","x [mm]"\n"0,5","1,5"\n"1","2"\n', ([0.5, 1], {"x": [1.5, 2]}, "mm")),
    "excel, unicode text": File("t [s]\tx [mm]\r\n0\t1.5\r\n1\t2.5\r\n", ([0, 1], {"x": [1.5, 2.5]}, "mm"), encoding="utf-16"),
    "a letter lost before": File("t [s];x\ufffd [mm]\n0;1.5\n1;2.5\n", ([0, 1], {"x\ufffd": [1.5, 2.5]}, "mm")),
    "excel, separator stated": File("sep=;\nt [s];x [mm]\n0;1.5\n1;2.5\n", ([0, 1], {"x": [1.5, 2.5]}, "mm")),
    "excel, dates": File("t [s];x [mm]\n27.11.2026;1.5\n28.11.2026;2.5\n", "'27.11.2026'; expected a finite number"),
    "excel, a workbook": File("PK\x03\x04\x14\x00\x06\x00", "save a workbook as CSV first"),
    "excel, wrong formula": File("t [s];x [mm]\n0;1.5\n1;#DIV/0!\n", "line 3, x: found '#DIV/0!'"),
    # MATLAB, NumPy, simulation programs
    "matlab table": File("t_s,x_mm\n0,1.5\n1,NaN\n", "one time column"),
    "matlab table, named": File(
        "t_s,x_mm\n0,1.5\n1,NaN\n", ([0, 1], {"x": [1.5, NAN]}, "mm"), {"columns": {"t": "t_s", "x": "x_mm"}, "units": TWO}
    ),
    "matlab ascii": File(
        "   0.0000000e+00   1.5000000e+00\n   1.0000000e+00   2.5000000e+00\n",
        ([0, 1], {"x": [1.5, 2.5]}, "mm"),
        {"columns": {"t": 1, "x": 2}, "units": TWO},
    ),
    "numpy": File("# t [s] x [mm]\n0.0 1.5\n1.0 2.5\n", ([0, 1], {"x": [1.5, 2.5]}, "mm")),
    "comsol": File(
        "% Model:              ball.mph\n% Version:            COMSOL 6\n% t (s)              x (mm)\n0                    1.5\n1 2.5\n",
        ([0, 1], {"x": [1.5, 2.5]}, "mm"),
    ),
    "adams, uneven spaces": File("Time  free height (mm)\n0 1.5\n1 2.5\n", "found 2 cells; expected 3"),
    "minus signs of typesetters": File("t [s];x [mm]\n\u22121;1.5\n0;\u22122.5\n", ([-1, 0], {"x": [1.5, -2.5]}, "mm")),
    "underscores": File("t [s];x [mm]\n0;1_000\n1;2\n", "'1_000'; expected a finite number"),
    # headings
    "units in parentheses": File("Time (ms),x (mm)\n0,1.5\n1,2.5\n", ([0, 0.001], {"x": [1.5, 2.5]}, "mm")),
    "units behind strokes": File("t/ms,x / mm\n0,1.5\n1,2.5\n", ([0, 0.001], {"x": [1.5, 2.5]}, "mm")),
    "units below": File("t,x\nms,mm\n0,1.5\n1,2.5\n", ([0, 0.001], {"x": [1.5, 2.5]}, "mm")),
    "units in words": File("t,x\n[seconds],[millimeters]\n0,1.5\n1,2.5\n", ([0, 1], {"x": [1.5, 2.5]}, "mm")),
    "two units": File("t [s],x [mm]\ns,m\n0,1.5\n1,2.5\n", "the units [mm] and, below, [m]"),
    "units behind two strokes": File("t/s,x/m/s\n0,1.5\n1,2.5\n", "found 'x/m/s'; expected name [unit]"),
    "a number in parentheses": File("t (s),x (1)\n0,1.5\n1,2.5\n", "found 'x (1)'; expected name [unit]"),
    "a name in parentheses": File("t (s),x (left)\n0,1.5\n1,2.5\n", ([0, 1], {"x (left)": [1.5, 2.5]}, "mm"), {"units": {"x (left)": "mm"}}),
    "a unit in place of the file's": File("t (s),x (A)\n0,1.5\n1,2.5\n", ([0, 1], {"x": [1.5, 2.5]}, "mm"), {"units": {"x": "mm"}}),
    "unit for no column": File("t [s],x [mm]\n0,1.5\n1,2.5\n", "y: found no column of this name", {"units": {"y": "m"}}),
    "skipped lines": File("t [s],x [mm]\n0,9\n\nt [s],x [mm]\n0,1.5\n1,2.5\n", ([0, 1], {"x": [1.5, 2.5]}, "mm"), {"skip": 2}),
    "a block before the headings": File("t [s],x [mm]\n0,9\n\nt [s],x [mm]\n0,1.5\n1,2.5\n", "line 4, t: found 't [s]'"),
    "no such number of lines": File("t [s],x [mm]\n0,1\n1,2\n", "skip: found -1", {"skip": -1}),
    "no such mark": File("t [s],x [mm]\n0,1\n1,2\n", "decimal: found ';'", {"decimal": ";"}),
    # motion capture
    "motive": File(
        MOTIVE, ([0, 0.01, 0.02], {"y": [0.5, 0.4, NAN]}, "mm"), {"columns": {"t": "Time (Seconds)", "y": 4}, "units": {"y": "mm"}}
    ),
    "motive, column twice": File(MOTIVE, "X: found 2 columns of this name", {"columns": ["X"], "units": {"X": "m"}}),
    "vicon counts frames": File("Trajectories\n100\n,,ball,,\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n1,0,1,2,3\n2,0,1,2,3\n", "one time column"),
    "opensim": File(
        "drop\nversion=1\nnRows=2\nnColumns=2\ninDegrees=no\nendheader\ntime\tball_ty\n0.0\t1.5\n0.01\t1.25\n",
        ([0, 0.01], {"ball_ty": [1.5, 1.25]}, "mm"),
        {"units": {"time": "s", "ball_ty": "mm"}},
    ),
    "trc": File(
        TRC.format(units="mm"),
        ([0, 0.5], {"ball.X": [1, 1], "ball.Y": [2, 4], "ball.Z": [3, NAN], "wall.X": [9, 9], "wall.Y": [8, 8], "wall.Z": [7, 6]}, "mm"),
        {"columns": [f"{marker}.{axis}" for marker in ("ball", "wall") for axis in "XYZ"]},
    ),
    "trc, one coordinate of one marker": File(TRC.format(units="mm"), ([0, 0.5], {"height": [2, 4]}, "mm"), {"columns": {"height": "ball.Y"}}),
    "trc without a unit": File(TRC.format(units=""), "ball.Y: found 'ball.Y'; expected name [unit]", {"columns": ["ball.Y"]}),
    "vernier": File(
        "Latest: Time (s),Latest: Position (mm)\n0,1.5\n0.05,2.5\n",
        ([0, 0.05], {"x": [1.5, 2.5]}, "mm"),
        {"columns": {"t": "Latest: Time", "x": "Latest: Position"}},
    ),
}  # fmt: skip


def written(folder, file):
    path = folder / "data.csv"
    path.write_bytes(file.text.encode(file.encoding))
    return path


@each("name", FILES)
def test_a_file_is_read_right_or_refused(tmp_path, name):
    file = FILES[name]
    if isinstance(file.expected, str):
        with pytest.raises(InputError) as error:
            read_measurement(written(tmp_path, file), **file.how)
        assert file.expected in " ".join(str(error.value).split()), str(error.value)
        return
    times, columns, unit = file.expected
    measurement = read_measurement(written(tmp_path, file), **file.how)
    np.testing.assert_allclose(measurement.times, times, rtol=1e-15)
    np.testing.assert_equal(measurement.columns, {name: np.array(values) for name, values in columns.items()})
    assert set(measurement.units.values()) == {unit}


def rendered(random, values):
    """Return a file of the rows (time, a, b), None where missing, in a random dialect, and whether it can be read."""
    delimiter = random.choice(",;\t")
    mark = random.choice(".,")
    group = random.choice(["", "", ",."[mark == ","]])
    digits = random.choice([0, 1, 3, 6])
    end = random.choice(["\n", "\r\n", "\r"])
    gap = random.choice(["", "nan", "N/A", "-", "#NV"])
    quoted = random.random() < 0.5 or (delimiter == "," and (group or random.random() < 0.9))
    trailing = delimiter * (random.random() < 0.3)

    def cell(x):
        if x is None:
            return gap
        text = f"{x:{',' if group else ''}.{digits}f}".translate(str.maketrans({",": group or ",", ".": mark}))
        return f'"{text}"' if quoted else text

    names, style = ("time", "a", "b"), random.choice(["{} [{}]", "{} ({})", "{}/{}", "{}"])
    units = ("ms", "mm", "N")
    lines = [f"made by {random.random()}", "Operator;x", "1,5"][: random.randrange(4)]
    lines.append(delimiter.join(style.format(*pair) for pair in zip(names, units, strict=True)) + trailing)
    if style == "{}":
        lines.append(delimiter.join(units) + trailing)
    lines += [delimiter.join(map(cell, row)) + trailing for row in values]
    encoding = random.choice(["utf-8", "utf-8-sig", "utf-16", "latin-1"])
    exact = [[None if x is None else round(x, digits) for x in row] for row in values]
    return (end.join(lines) + end).encode(encoding), exact, mark


def test_random_dialects_of_known_numbers_give_these_numbers_or_an_error(tmp_path):
    """Whatever a program writes: no file is read as other numbers, and most are read."""
    dice, read, path = random.Random(1), 0, tmp_path / "data.csv"
    for _ in range(600):
        size = 10 ** dice.uniform(-1, 5)
        rows = [
            (
                float(k + dice.choice([0, 1000])) if k else 0.0,
                *(None if dice.random() < 0.1 else dice.gauss(0, size) for _ in "ab"),
            )
            for k in range(dice.randrange(2, 6))
        ]
        rows = [(1.5 * k * size, *row[1:]) for k, row in enumerate(rows)]
        content, exact, mark = rendered(dice, rows)
        path.write_bytes(content)
        how = {"decimal": mark} if dice.random() < 0.3 else {}
        try:
            measurement = read_measurement(path, **how)
        except InputError:
            continue
        read += 1
        times, *columns = (np.array(column, dtype=float) for column in zip(*exact, strict=True))
        kept = np.append(np.diff(times) > 0, True)
        np.testing.assert_allclose(measurement.times, 1e-3 * times[kept], rtol=1e-15, err_msg=str(content))
        for name, values in zip("ab", columns, strict=True):
            np.testing.assert_array_equal(measurement.columns[name], values[kept], str(content))
    assert read > 280, read


def test_clean_files_are_read_by_numpy_whole(tmp_path, monkeypatch):
    """Cell by cell a million rows take as long as they did before, tens of times `loadtxt`."""
    monkeypatch.setattr(Numbers, "_by_cells", lambda *_: pytest.fail("read cell by cell"))
    for text in ("t [s],x [m]\n0,1.5\n1,\n", "t [s];x [m]\n0,5;1,25\n1,5;2,75\n", "t [s] x [m]\n0 1\n1 nan\n2 3\n"):
        assert read_measurement(written(tmp_path, File(text, ""))).times.size >= 2


def test_arrays_and_data_frames_are_taken():
    pandas = pytest.importorskip("pandas")
    arrays = {"t [ms]": [0, 1, 2], "x": np.ma.array([1.5, 7.0, 2.5], mask=[False, True, False])}
    frame = pandas.DataFrame({"x": [1.5, NAN, 2.5]}, index=pandas.Index([0.0, 1e-3, 2e-3], name="t"))
    frame.attrs["units"] = {"t": "s", "x": "mm"}
    for data, how in ((arrays, {"units": {"x": "mm"}}), (frame, {})):
        measurement = read_measurement(data, **how)
        np.testing.assert_allclose(measurement.times, [0, 1e-3, 2e-3])
        np.testing.assert_equal(
            (measurement.columns, measurement.units), ({"x": np.array([1.5, NAN, 2.5])}, {"x": "mm"})
        )
    impacts = read_impacts({"impact [1]": [1, 2, 4], "t [s]": [0.1, 0.2, 0.4]})
    assert impacts.numbers.tolist() == [1, 2, 4]


@each(
    ("data", "expected"),
    [
        ({"t [s]": np.array(["2026-11-27", "2026-11-28"], "datetime64[s]"), "x [m]": [1, 2]}, "t: found datetime64"),
        ({"t [s]": [0, 1], "x [m]": ["1,5", "2"]}, "x: found <U3 of shape (2,)"),
        ({"t [s]": [0, 1], "x [m]": [1, 2, 3]}, "x: found int64 of shape (3,)"),
        ({"t [s]": [0, 2, 1], "x [m]": [1, 2, 3]}, "row 3: found the time 1, after 2"),
        ({"t [s]": [0, 1], "x": [1, 2]}, "found 'x'; expected name [unit]"),
    ],
)
def test_arrays_that_are_no_measurement_are_refused(data, expected):
    with pytest.raises(InputError) as error:
        read_measurement(data)
    assert expected in str(error.value)
