"""Measurements laid over the figures of a study: units, missing values, what fits no panel."""

from dataclasses import replace

import numpy as np
import pytest
from commands import called

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.engine.inputs.measurement_csv import Measurement
from hertzwerk.runtime.studies.paper.plot_page import figure
from hertzwerk.runtime.studies.paper.study_page import (
    Axis,
    Chart,
    Curve,
    Page,
    Panel,
    Study,
    laid_over,
    require_columns,
    study_of,
)

TIMES = np.array([1e-3, 2e-3, 3e-3])


def page():
    x = np.linspace(0, 10, 3)
    time, acceleration = Axis("time", "ms", history="t"), Axis("a", "km/s²", history="guide.acceleration")
    panels = (
        Panel("a", time, acceleration, (Curve("run", x, x),)),
        Panel("other", Axis("time", "ms"), Axis("b"), (Curve("run", x, x),)),
    )
    return Page("A page", ("Said.",), charts=(Chart("chart", "Chart", panels),))


def test_columns_are_drawn_in_the_units_of_the_axes():
    values = {"guide.acceleration": np.array([2000.0, np.nan, -500.0])}
    over = laid_over(page(), Measurement(TIMES, values, {"guide.acceleration": "m/s^2"}, "rig.csv"))
    first, other = over.charts[0].panels
    measured = first.curves[-1]
    assert (measured.label, measured.look) == ("measured", "measured")
    assert measured.x == pytest.approx([1, 3])
    assert measured.y == pytest.approx([2, -0.5])
    assert len(other.curves) == 1
    assert "rig.csv" in over.paragraphs[-1]
    line = figure(over.charts[0]).axes[0].lines[-1]
    assert (line.get_color(), list(line.get_xdata())) == ("black", pytest.approx([1, 3]))


@pytest.mark.parametrize(
    ("name", "unit", "said"), [("guide.acceleration", "m/s", "a unit like km/s^2"), ("rod.acceleration", "m/s^2", "some of guide.acceleration")],
)  # fmt: skip
def test_an_overlay_that_does_not_fit_is_refused(name, unit, said):
    study = Study("own", "Why?", lambda *_: pytest.fail("it ran"), {"guide.acceleration": "km/s^2"})
    with pytest.raises(InputError) as refused:
        require_columns(study, Measurement(TIMES, {name: TIMES}, {name: unit}, "rig.csv"))
    assert said in str(refused.value)


def test_wrong_columns_and_missing_files_are_refused_before_a_study_runs(tmp_path, monkeypatch):
    """It had run for minutes."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "rig.csv").write_text("t [s],rod.speed [m/s]\n0,1\n1,2\n")
    for name in ("exponents", "bouncing"):
        unrun = replace(study_of(name), run=lambda *_: pytest.fail("it ran"))
        monkeypatch.setattr(f"hertzwerk.runtime.studies.paper.study_{name}.STUDY", unrun)
        assert "rig.csv" in called("study", name, "--measured", "rig.csv", code=2).output
    monkeypatch.chdir(tmp_path)
    assert "no such file" in called("study", "slider_crank", "--measured", "none.csv", code=2).output
