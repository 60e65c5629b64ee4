"""Pictures say what they show: peaks that acted, what was changed, every coordinate, units that fit, no noise, no film called flight."""

import re
from functools import cache

import numpy as np
import pytest
from commands import called

from hertzwerk.runtime import Model, Solution, load, simulate
from hertzwerk.runtime.engine.run.continuation import with_steps
from hertzwerk.runtime.output.drawings import picture
from hertzwerk.runtime.output.plots import curves, picture_samples, plot_panel, title
from hertzwerk.runtime.output.plots.curves import Curves

built = cache(load)  # with its functions, for all tests here


def texts(figure):
    return " ".join(artist.get_text() for artist in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def titles(figure):
    return [axis.get_title("left") for axis in figure.axes if axis.get_visible()]


@pytest.fixture(scope="module")
def crank():
    return simulate(built("slider_crank"), duration="6 ms", tolerance=1e-6)


@pytest.fixture(scope="module")
def coarse():
    """The same, of which 61 rows were kept: one in four impacts has a row."""
    return simulate(built("slider_crank"), duration="6 ms", tolerance=1e-6, grid="0.1 ms")


@pytest.fixture(autouse=True)
def _sampled_anew(crank, coarse):
    yield
    crank.engine.shared_results.clear()
    coarse.engine.shared_results.clear()


# ---- peaks -----------------------------------------------------------------------------------------------------------


def missed(run) -> float:
    """Largest part of an impact's peak that the curve of its force misses."""
    run.engine.shared_results.clear()  # sampled anew
    (axis,) = run.plot("slider_pin.normal_force").axes
    unit = {"kN": 1e3, "N": 1.0}[re.search(r"\[(k?N)\]", axis.get_title("left"))[1]]
    t, force = (np.asarray(values) for values in axis.get_lines()[0].get_data())
    t = t * 1e-3
    assert len(run.impacts) > 10
    peaks = [(np.max(force[(t >= i.t) & (t <= i.t + (i.duration or 1))], initial=0.0) * unit, i.peak_force)
             for i in run.impacts]  # fmt: skip
    assert all(drawn < 1.001 * acted for drawn, acted in peaks)
    return max(1 - drawn / acted for drawn, acted in peaks)


def test_curves_reach_the_peaks_that_acted_whatever_was_kept(crank, coarse, tmp_path):
    loose = simulate(built("slider_crank"), duration="6 ms", tolerance=1e-3)
    for run in (crank, coarse, loose):
        assert missed(run) < 1e-4
    rows = Solution.load(coarse.save(tmp_path / "rows.npz"))
    assert missed(rows) < 1e-12  # told by the impacts
    assert "straight lines" in texts(rows.plot())
    steps = Solution.load(crank.save(tmp_path / "steps.npz"))
    assert missed(steps) < 1e-2
    assert "straight lines" not in texts(steps.plot())


def test_rows_alone_and_steps_alone_would_miss_them(crank, coarse, monkeypatch):
    monkeypatch.setattr(picture_samples, "PARTS", 1)
    monkeypatch.setattr(picture_samples, "EVEN", 2)
    monkeypatch.setattr(picture_samples, "hardest", lambda _: [])
    assert missed(crank) > 1e-3
    monkeypatch.setattr(curves, "with_steps", lambda run: run)
    assert missed(coarse) > 0.5


def test_a_run_on_a_grid_is_made_again_bitwise(crank, coarse):
    again = with_steps(coarse)
    assert np.array_equal(again.t, crank.t)
    assert np.array_equal(again.engine.history.rows, crank.engine.history.rows)
    assert with_steps(crank) is crank
    stopped = simulate(built("slider_crank"), duration="6 ms", tolerance=1e-6, grid=100, max_steps=100)
    again = with_steps(stopped)
    assert again.t[-1] == stopped.engine.t_end < 6e-3
    assert np.array_equal(again.engine.history.rows, crank.engine.history.rows[: len(again.t)])


# ---- title -----------------------------------------------------------------------------------------------------------


def test_titles_name_what_differs_from_the_scene(crank, monkeypatch):
    run = simulate(built("slider_crank"), duration="1 ms", tolerance=1e-6,
                   parameters={"clearance": "0.2 mm"}, initial={"guide.travel": "170.1 mm"})  # fmt: skip
    said = "clearance = 0.2 mm, guide.travel = 170.1 mm"
    for figure in (run.plot(), run.plot("slider_pin"), run.plot("guide.speed"), run.draw()):
        assert said in texts(figure)
        assert "crank_speed" not in texts(figure)
    assert "=" not in title.differences(crank)
    assert "clearance = 0.1 mm" in texts(Model(run.engine.model).draw(parameters={"clearance": "0.1 mm"}))
    monkeypatch.setattr(plot_panel, "differences", lambda _: "")
    assert said not in texts(run.plot())  # it is the title that tells


def test_the_command_draws_what_was_given_into_the_title(tmp_path, monkeypatch):
    recorded = []
    figure = picture.figure
    monkeypatch.setattr(picture, "figure", lambda *given: recorded.append(figure(*given)) or recorded[-1])
    monkeypatch.chdir(tmp_path)
    for more in (["--start"], ["--duration", "50 ms"]):
        command = ["draw", "bouncing_ball", "--set", "drop_height=0.2 m", "--overwrite", *more]
        called(*command)
        assert "drop_height = 0.2 m" in texts(recorded[-1])


# ---- panels ----------------------------------------------------------------------------------------------------------


def test_every_coordinate_is_drawn(crank):
    shown = [title for title in titles(crank.plot()) if "ideal" not in title]
    assert [title.split(" [")[0] for title in shown][:2] == ["Position", "Speed"]
    assert {"Angle", "Angular speed"} < {title.split(" [")[0] for title in shown}
    for name in ("slider_crank_three_clearances", "spatial_slider_crank"):
        run = simulate(built(name), duration="1 ms", tolerance=1e-4)
        drawn = sum(len([line for line in axis.get_lines() if line.get_label() != "ideal mechanism"])
                    for axis in run.plot().axes if re.match(r"(Position|Angle)( of \w+)? \[", axis.get_title("left")))  # fmt: skip
        assert drawn == run.engine.model.nq


def test_energy_that_nothing_changes_is_said_to_be_constant_and_not_drawn_as_noise():
    run = simulate(built("double_pendulum"), duration="1 s", tolerance=1e-12)
    (axis,) = (axis for axis in run.plot().axes if axis.get_title("left").startswith("Energy"))
    assert "constant to 1e-12" in axis.get_title("left")
    lines = {line.get_label(): np.asarray(line.get_ydata()) for line in axis.get_lines()}
    assert np.max(np.abs(lines["kinetic"] + lines["potential"])) < 1e-9 * np.ptp(lines["kinetic"])
    assert np.ptp(axis.get_ylim()) >= np.ptp(lines["kinetic"])
    assert np.max(np.abs(lines["mechanical"])) < 1e-9 * np.ptp(axis.get_ylim())


@pytest.mark.parametrize("noise", [1e-15, 1e-9])
def test_a_constant_is_drawn_flat_but_for_a_change_that_is_more_than_rounding(crank, noise):
    curves = Curves.of(crank)
    (axis,) = crank.plot("energy").axes
    axis.clear()
    plot_panel.lines(axis, curves, "m", {"still": 0.3 + noise * np.sin(1e4 * curves.t)})
    constant = noise < 1e-12
    assert (np.ptp(axis.get_ylim()) > 1) == constant  # mm
    assert ("constant to 1e-12" in texts(axis.figure)) == constant
