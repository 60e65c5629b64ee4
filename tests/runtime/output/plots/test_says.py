"""Pictures say what they show: peaks that acted, what was changed, every coordinate, units that fit, no noise, no film called flight."""

import re
from functools import cache

import numpy as np
import pytest
from click.testing import CliRunner

from hertzwerk.runtime import Solution, load, simulate
from hertzwerk.runtime.cli import main
from hertzwerk.runtime.output.drawings import picture
from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.picture import PANEL
from hertzwerk.runtime.output.drawings.places import Places
from hertzwerk.runtime.output.plots import picture_samples, plot_panel, title
from hertzwerk.runtime.output.plots import plot_run as pages
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
    return simulate(built("slider_crank"), duration="6 ms", tolerance=1e-6, output="0.1 ms")


@pytest.fixture(autouse=True)
def _sampled_anew(crank, coarse):
    yield
    crank.kept.clear()
    coarse.kept.clear()


# ---- peaks -----------------------------------------------------------------------------------------------------------


def missed(run) -> float:
    """Largest part of an impact's peak that the curve of its force misses."""
    run.kept.clear()  # sampled anew
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
    monkeypatch.setattr(type(coarse), "with_steps", lambda run: run)
    assert missed(coarse) > 0.5


def test_a_run_on_a_grid_is_made_again_bitwise(crank, coarse):
    again = coarse.with_steps()
    assert np.array_equal(again.t, crank.t)
    assert np.array_equal(again.history.rows, crank.history.rows)
    assert crank.with_steps() is crank
    stopped = simulate(built("slider_crank"), duration="6 ms", tolerance=1e-6, output=100, max_steps=100)
    again = stopped.with_steps()
    assert again.t[-1] == stopped.t_end < 6e-3
    assert np.array_equal(again.history.rows, crank.history.rows[: len(again.t)])


def test_loose_steps_are_drawn_smooth():
    run = simulate(built("slider_crank"), duration="3 ms", tolerance=1e-2)
    t = Curves.of(run).t
    onset, end = run.impacts[0].t, run.impacts[0].t + run.impacts[0].duration
    assert np.sum((run.t > onset) & (run.t < end)) < 12 < 40 < np.sum((t > onset) & (t < end))


def test_of_very_many_steps_those_with_the_largest_forces_are_drawn(crank, monkeypatch):
    for name, few in (("FEWEST", 10), ("MOST", 10), ("EVEN", 2), ("PARTS", 1)):
        monkeypatch.setattr(picture_samples, name, few)
    crank.kept.clear()
    assert len(Curves.of(crank).t) < 10 + 18 * len(crank.impacts)
    assert missed(crank) < 1e-2
    crank.kept.clear()
    monkeypatch.setattr(picture_samples, "hardest", lambda _: [])
    assert missed(crank) > 0.05


def test_the_ideal_mechanism_between_its_knots(crank, monkeypatch):
    """Splines through 300 positions against as many Newton iterations as there are samples."""
    every = Curves.of(crank)
    exact = every.ideal
    monkeypatch.setattr("hertzwerk.runtime.output.plots.curves.KNOTS", 300)
    between = Curves.of(crank).ideal
    assert len(between.t) == len(every.t) > 1000
    for name in ("guide.travel", "crank_pin.angle", "guide.speed"):
        assert np.max(np.abs(between[name] - np.interp(every.t, exact.t, exact[name]))) < 1e-4 * np.max(
            np.abs(exact[name])
        )


# ---- title -----------------------------------------------------------------------------------------------------------


def test_titles_name_what_differs_from_the_scene(crank, monkeypatch):
    run = simulate(built("slider_crank"), duration="1 ms", tolerance=1e-6,
                   parameters={"clearance": "0.2 mm"}, initial={"guide.travel": "170.1 mm"})  # fmt: skip
    said = "clearance = 0.2 mm, guide.travel = 170.1 mm"
    for figure in (run.plot(), run.plot("slider_pin"), run.plot("guide.speed"), run.draw()):
        assert said in texts(figure)
        assert "crank_speed" not in texts(figure)
    assert "=" not in title.differences(crank)
    assert "clearance = 0.1 mm" in texts(run.model.draw(parameters={"clearance": "0.1 mm"}))
    monkeypatch.setattr(plot_panel, "differences", lambda _: "")
    assert said not in texts(run.plot())  # it is the title that tells


def test_the_command_draws_what_was_given_into_the_title(tmp_path, monkeypatch):
    seen = []
    figure = picture.figure
    monkeypatch.setattr(picture, "figure", lambda *given: seen.append(figure(*given)) or seen[-1])
    monkeypatch.chdir(tmp_path)
    for more in (["--start"], ["--duration", "50 ms"]):
        command = ["draw", "bouncing_ball", "--set", "drop_height=0.2 m", "--overwrite", *more]
        assert CliRunner().invoke(main, command, catch_exceptions=False).exit_code == 0
        assert "drop_height = 0.2 m" in texts(seen[-1])


def test_titles_name_variations():
    model = load("bouncing_ball", without=["gravity"], laws={"floor": "lankarani_nikravesh"})
    run = simulate(model, duration="10 ms", tolerance=1e-6)
    assert "floor by lankarani_nikravesh, without gravity" in texts(run.plot())
    assert "floor by lankarani_nikravesh, without gravity" in texts(run.draw())


def test_of_many_differences_the_first_are_named():
    model = built("slider_crank")
    given = {name: f"{port.default * 1.01} {port.unit}" for name, port in model.parameters.items()}
    assert title.differences_of(model, given, {}).endswith(f"and {len(given) - title.MOST} more")


# ---- panels ----------------------------------------------------------------------------------------------------------


def test_every_coordinate_is_drawn(crank):
    shown = [title for title in titles(crank.plot()) if "ideal" not in title]
    assert [title.split(" [")[0] for title in shown][:2] == ["Position", "Speed"]
    assert {"Angle", "Angular speed"} < {title.split(" [")[0] for title in shown}
    for name in ("slider_crank_three_clearances", "spatial_slider_crank"):
        run = simulate(built(name), duration="1 ms", tolerance=1e-4)
        drawn = sum(len([line for line in axis.get_lines() if line.get_label() != "ideal mechanism"])
                    for axis in run.plot().axes if re.match(r"(Position|Angle)( of \w+)? \[", axis.get_title("left")))  # fmt: skip
        assert drawn == run.model.nq


def test_many_curves_of_a_panel_are_coloured_in_order(crank):
    curves = Curves.of(crank)
    figure = crank.plot("energy")
    (axis,) = figure.axes
    plot_panel.lines(axis, curves, "rad", {f"link_{i}": i * curves["crank_pin.angle"] for i in range(30)})
    named = [text for text in axis.get_legend_handles_labels()[1] if text.startswith("link")]
    assert named == ["link_0", "link_6", "link_12", "link_17", "link_23", "link_29"]
    assert len({line.get_color() for line in axis.get_lines()}) > 30


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


def test_a_film_is_not_called_flight(monkeypatch):
    run = simulate(built("journal_lubricated"), duration="10 ms", tolerance=1e-6)
    figure = run.plot("bearing")
    assert "on the film" in texts(figure)
    assert "free flight" not in texts(figure)
    assert "Least thickness of the film [µm]; no contact" in titles(figure)
    force = np.max(np.asarray(figure.axes[1].get_lines()[1].get_ydata()))
    assert force == pytest.approx(np.max(Curves.of(run)["oil.force"]), rel=1e-12)
    assert "film, oil" in texts(run.plot())
    monkeypatch.setattr(pages, "films", lambda _: {})
    assert "free flight" in texts(run.plot("bearing"))


def test_faint_positions_carry_their_times(crank):
    drawing = Drawing.of(Places.over(crank), PANEL)
    told = [text.get_text() for text in crank.draw().axes[0].texts if re.fullmatch(r"[\d.]+ ms", text.get_text())]
    assert told == [f"{crank_time * 1e3:.3g} ms" for crank_time in drawing.parts.places.t[list(drawing.ghosts)]]
    assert len(told) == 5
