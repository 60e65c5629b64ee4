"""Pictures of sweeps show the numbers of the table, in units that fit, and mark what failed."""

import math
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.studies.sweeps import plot_sweep
from hertzwerk.runtime.studies.sweeps.plot_sweep import figure
from hertzwerk.runtime.studies.sweeps.points.design_points import Design
from hertzwerk.runtime.studies.sweeps.rows.row import Packed, Row
from hertzwerk.runtime.studies.sweeps.sweep_table import COMPLETE, Sweep, columns_of

SPEEDS = np.linspace(1000, 5000, 9)
HEIGHTS = np.array([0.1, 0.2, 0.4])


def force(speed, height=1.0):
    return 7.0 * speed * height


def made(rows, varied, design=None, **arrays):
    columns = columns_of(varied, {"pin.force": "N", "pin.force.half_width": "N", "impacts": ""})
    return Sweep("crank", tuple(rows), columns, tuple(varied), COMPLETE, design, **arrays)


def row(i, speed, height=None, outcome="finished", points=None):
    given = {"speed": (float(speed), "rpm"), **({} if height is None else {"height": (float(height), "m")})}
    si = {"speed": speed * math.pi / 30, **({} if height is None else {"height": height})}
    outputs = {"pin.force": force(speed, height or 1.0), "pin.force.half_width": 350.0, "impacts": float(i)}
    arrays = {} if points is None else {"section": Packed.of(points)}
    return Row(i, given, outcome, "", si, outputs if outcome == "finished" else {}, (), 0.0, arrays)


def one(**failing):
    return made([row(i, speed, **(failing if i == 4 else {})) for i, speed in enumerate(SPEEDS)], {"speed": "rad/s"})


def two(broken=None):
    points = [(speed, height) for speed in SPEEDS for height in HEIGHTS]
    rows = [row(i, *point, outcome="failed" if i == broken else "finished") for i, point in enumerate(points)]
    axes = {"speed": tuple((x, "rpm") for x in SPEEDS.tolist()), "height": tuple((x, "m") for x in HEIGHTS.tolist())}
    return made(rows, {"speed": "rad/s", "height": "m"}, Design(axes))


def section():
    """Speeds with two points each, 1 and 3 um/rpm."""
    rows = [row(i, s, points=np.array([[1.0, s * 1e-6], [2.0, 3 * s * 1e-6]])) for i, s in enumerate(SPEEDS)]
    options = {"arrays": {"section": {"t": "s", "pin.x": "m"}}, "place": "section at here"}
    return made(rows, {"speed": "rad/s"}, **options)


def curve(axis, i=0):
    return axis.lines[i].get_xydata().T


def test_one_parameter_is_a_curve_with_its_band_in_the_units_given():
    force_panel, impacts = figure(one()).axes
    x, y = curve(force_panel)
    assert np.array_equal(x, SPEEDS)
    assert y == pytest.approx(force(SPEEDS) / 1e3)
    assert (force_panel.get_xlabel(), force_panel.get_ylabel()) == ("speed [rpm]", "force [kN]")
    (band,) = force_panel.collections
    edges = band.get_paths()[0].vertices
    for at, middle in zip(SPEEDS, force(SPEEDS) / 1e3, strict=True):
        heights = edges[edges[:, 0] == at, 1]
        assert (heights.min(), heights.max()) == pytest.approx((middle - 0.35, middle + 0.35))
    assert not impacts.collections
    assert all(tick == round(tick) for tick in impacts.get_yticks())


def test_rows_that_failed_leave_a_gap_and_a_mark():
    page = figure(one(outcome="failed"))
    _, y = curve(page.axes[0])
    assert np.flatnonzero(np.isnan(y)).tolist() == [4]
    assert curve(page.axes[0], 1)[0].tolist() == [SPEEDS[4]]
    assert any("1 of 9 rows failed" in text.get_text() for text in page.texts)
    page = figure(one(outcome="finished"))
    assert len(page.axes[0].lines) == 1


@pytest.mark.parametrize("broken", [None, 7])
def test_two_parameters_are_a_map_with_every_value_at_its_place(broken):
    page = figure(two(broken), ["pin.force"])
    axis = page.axes[0]
    (mesh,) = axis.collections
    actual = mesh.get_array()
    for i, speed in enumerate(SPEEDS):
        for j, height in enumerate(HEIGHTS):
            if broken == 3 * i + j:
                assert np.ma.is_masked(actual[j, i])
            else:
                assert actual[j, i] == pytest.approx(force(speed, height) / 1e3)
    corners = mesh.get_coordinates()
    assert np.all(corners[0, :-1, 0] < SPEEDS) and np.all(corners[0, 1:, 0] > SPEEDS)
    marked = [(SPEEDS[2], HEIGHTS[1])] if broken else []
    assert [tuple(point) for point in axis.lines[0].get_xydata()] == marked
    assert page.axes[1].get_ylabel() == "force [kN]"


def test_a_section_is_a_dot_for_each_point():
    page = figure(section())
    (axis,) = page.axes
    x, y = curve(axis)
    assert np.array_equal(x, np.repeat(SPEEDS, 2))
    assert y == pytest.approx(np.column_stack([SPEEDS, 3 * SPEEDS]).ravel() * 1e-3)
    assert axis.get_ylabel() == "x [mm]"
    assert any("section at here" in text.get_text() for text in page.texts)
    assert np.array_equal(curve(figure(section(), ["pin.force"]).axes[0])[0], SPEEDS)


def test_angles_of_many_turns_are_drawn_within_one():
    """Angles about 170 and 190 degrees, of some turns: no cluster is cut at 180 degrees, and the label says so."""
    near = np.radians([[0.0, 170.0], [0.0, 190.0 + 360 * 7]])
    rows = [row(i, s, points=near - [0.0, 2 * math.pi * i]) for i, s in enumerate(SPEEDS)]
    options = {"arrays": {"section": {"t": "s", "pin.angle": "rad"}}, "place": "section at here"}
    (panel,) = figure(made(rows, {"speed": "rad/s"}, **options)).axes
    angles = curve(panel)[1].reshape(-1, 2)
    assert "modulo a turn" in panel.get_ylabel()
    assert np.ptp(angles) == pytest.approx(np.radians(20))
    assert np.exp(1j * angles) == pytest.approx(np.exp(1j * np.tile(near[:, 1], (len(SPEEDS), 1))))


@pytest.mark.parametrize("table", [one(), one(outcome="failed"), two(5), section()])
def test_no_text_lies_on_another(table):
    page = figure(table)
    canvas = FigureCanvasAgg(page)
    canvas.draw()
    renderer = canvas.get_renderer()
    for axis in page.axes:
        texts = [axis.xaxis.label, axis.yaxis.label, axis.title, axis._left_title, *page.texts]
        boxes = [text.get_window_extent(renderer) for text in texts if text.get_text()]
        for i, box in enumerate(boxes):
            assert not any(box.overlaps(other) for other in boxes[i + 1 :])


def test_sweeps_that_cannot_be_drawn_are_refused():
    with pytest.raises(InputError, match=r"did you mean pin\.force"):
        figure(one(), ["pin.forse"])
    with pytest.raises(InputError, match="none with numbers"):
        figure(made([], {"speed": "rad/s"}))


# -- more rows than a person can see -------------------------------------------------------------------------------------


def test_of_many_rows_a_curve_shows_the_extremes_and_says_how_many(monkeypatch):
    """One spike and one dip among 300 rows, drawn at 20 places; every 15th row, the seeded fault, has neither."""
    monkeypatch.setattr(plot_sweep, "PLACES", 20)
    speeds = np.linspace(1000, 5000, 300)
    rows = [row(i, speed, outcome="failed" if i == 77 else "finished") for i, speed in enumerate(speeds)]
    rows[131], rows[202] = (replace(rows[i], outputs={**rows[i].outputs, "pin.force": x}) for i, x in ((131, 9e4), (202, -9e4)))  # fmt: skip
    page = figure(made(rows, {"speed": "rad/s"}), ["pin.force"])
    x, y = curve(page.axes[0])
    assert len(x) <= 40
    assert (x[y.argmax()], y.max()) == (speeds[131], 90)
    assert (x[y.argmin()], y.min()) == (speeds[202], -90)
    assert np.abs(y[::15]).max() < 90
    said = " ".join(text.get_text() for text in page.texts)
    assert "300 rows, of which the minimum and the maximum at 20 places are drawn" in " ".join(said.split())
    assert "1 of 300 rows failed" in " ".join(said.split())
    assert curve(page.axes[0], 1)[0].tolist() == [speeds[77]]
