"""Pictures: they show what they claim, say what a reader must know, and cover nothing."""

import pickle

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection
from matplotlib.patches import Circle

import hertzwerk.derive as hd
from hertzwerk.derive.laws import coulomb, power
from hertzwerk.runtime import Solution, load, simulate
from hertzwerk.runtime.engine.model.build import scene_from
from hertzwerk.runtime.engine.solution.solution import EngineRun
from hertzwerk.runtime.output.plots import curves
from hertzwerk.runtime.output.plots.dents import dents_of
from hertzwerk.runtime.output.plots.picture_samples import dense
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of
from hertzwerk.runtime.output.plots.worn_contours import INSTANTS, contour, worn_surfaces

C = 0.5e-3  # clearance [m]


@pytest.fixture(scope="module")
def crank():
    return simulate(load("slider_crank"), duration="24 ms", tolerance=1e-6)


@pytest.fixture(scope="module")
def ball():
    return simulate(load("soft_ball"), duration="1 s", tolerance=1e-6)


def texts(figure):
    return " ".join(artist.get_text() for artist in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def test_dollars_of_a_summary_are_no_mathematics(tmp_path):
    """A run was lost when its picture was drawn: Matplotlib could not read `x^{`."""
    model = load(scene_from("soft_ball").named("soft_ball", "a $x^{$ b & <i> \\ $"))
    run = simulate(model, duration="0.5 s", tolerance=1e-6)
    assert "a $x^{$ b & <i> \\ $" in texts(run.draw()).replace(r"\$", "$")
    for number, picture in enumerate((run.draw(), run.plot(), run.plot("floor"))):
        picture.savefig(tmp_path / f"{number}.png")
    assert "A \\$x^{\\$ b &amp; &lt;i> \\\\ \\$." in str(model.equations())


@pytest.mark.parametrize("output", [None, 5])
def test_a_run_is_sampled_once_for_all_of_its_pictures(output, monkeypatch):
    calls = []
    monkeypatch.setattr(curves, "dense", lambda run: calls.append(run) or dense(run))
    run = simulate(load("soft_ball"), duration="1 s", tolerance=1e-6, grid=output)
    run.plot(), run.plot("floor"), run.plot("energy")
    assert len(calls) == 1
    assert b"Curves" not in pickle.dumps(run)  # what pictures share is theirs
    run.continued("1.5 s").plot()
    assert len(calls) == 2
    monkeypatch.setattr(EngineRun, "shared_results", property(lambda run: {}))  # seeded fault: nothing is kept
    run.plot(), run.plot("floor")
    assert len(calls) == 4


def test_journal_path_leaves_the_clearance_circle_by_the_penetration_only(crank):
    (axis,) = (axis for axis in crank.plot("slider_pin").axes if axis.get_aspect() == 1)
    (circle,) = axis.findobj(Circle)
    assert circle.radius == pytest.approx(C * 1e3, rel=1e-9)  # shown in mm
    free, touching = (np.concatenate(lines.get_segments()) for lines in axis.findobj(LineCollection))
    assert np.max(np.hypot(*free.T)) <= 1.001 * C * 1e3
    deepest = max(impact.peak_penetration for impact in crank.impacts) * 1e3
    assert np.max(np.hypot(*touching.T)) - C * 1e3 == pytest.approx(deepest, rel=5e-3)  # sampled
    assert axis.get_xlim()[1] > np.max(np.hypot(*touching.T))


def test_overview_shows_slider_and_ideal_mechanism(crank):
    figure = crank.plot()
    titles = [axis.get_title("left") for axis in figure.axes if axis.get_visible()]
    for wanted in ("Position", "Speed", "Acceleration", "ideal", "Contact force of slider_pin [kN]", "Energy"):
        assert any(wanted in title for title in titles), wanted
    (axis,) = (axis for axis in figure.axes if axis.get_title("left").startswith("Position ["))
    ideal, real = (line.get_ydata() for line in axis.get_lines())
    assert 0 < np.max(np.abs(real - ideal)) < 1.0  # mm
    assert np.max(ideal) == pytest.approx(170, rel=1e-9)


@pytest.mark.parametrize("name", [None, "slider_pin"])
def test_legends_cover_no_data(crank, name):
    figure = crank.plot(*([name] if name else []))
    FigureCanvasAgg(figure).draw()
    legends = [(axis, axis.get_legend()) for axis in figure.axes if axis.get_legend()]
    assert legends
    for axis, legend in legends:
        box, panel = legend.get_window_extent(), axis.get_window_extent()
        assert box.y0 >= panel.y1 - 1 or box.y1 <= panel.y0 + 1
        assert box.x1 <= figure.bbox.x1
    assert not [
        (a, b)
        for i, (_, a) in enumerate(legends)
        for _, b in legends[i + 1 :]
        if a.get_window_extent().overlaps(b.get_window_extent())
    ]


def test_many_curves_have_legends_in_rows_that_cover_nothing():
    figure = simulate(load("slider_crank_three_clearances"), duration="12 ms", tolerance=1e-6).plot()
    FigureCanvasAgg(figure).draw()
    tops = {}
    for axis in figure.axes:
        if axis.get_visible() and axis.get_legend():
            box, panel = axis.get_legend().get_window_extent(), axis.get_window_extent()
            title = axis._left_title.get_window_extent()
            assert panel.y1 - 1 <= box.y0
            assert box.y1 <= title.y0 + 2
            assert box.x1 <= panel.x1 + 0.1 * panel.width
            assert panel.width > 0.35 * figure.bbox.width
            tops[axis.get_title("left")] = box.height
    assert max(tops.values()) > 1.5 * min(tops.values())  # one of them in several rows


def test_first_impact_of_a_ball_is_drawn_to_its_peak(ball):
    figure = ball.plot("floor")
    assert "Gap [m]" in texts(figure)
    peak = max(
        np.max(line.get_ydata())
        for axis in figure.axes
        if "[kN]" in axis.get_title("left")
        for line in axis.get_lines()
    )
    assert peak == pytest.approx(ball.impacts[0].peak_force / 1e3, rel=1e-4)


def test_unchecked_laws_and_warnings_stand_on_the_picture():
    scene = scene_from("two_spheres")
    stiffness = power(1e8 * scene.parameters["youngs_modulus"] / 207e9, 1)  # Pa, not N/m
    wrong = scene.replace(spheres=hd.Contact("spheres", stiffness, scene.effect("spheres").damping, unchecked=True))
    run = simulate(load(wrong), duration="50 ms", parameters={"restitution": "0.7"}, tolerance=1e-6)
    for figure in (run.plot(), run.plot("spheres")):
        assert "UNCHECKED" in texts(figure)


@pytest.mark.parametrize(
    ("unit", "values", "shown"),
    [("m", [0.5e-3], "mm"), ("m", [78e-6], "µm"), ("m", [1.2], "m"), ("N", [46e3], "kN"), ("N", [3.0], "N"),
     ("s", [0.024], "ms"), ("s", [5.0], "s"), ("rad", [0.1], "rad"), ("m", [0.0], "m"), ("J", [np.nan, 2.0], "J"),
     ("N", [290.0], "N"), ("N", [0.0], "N"), ("rad", [2e-3], "mrad"), ("m/s^2", [3e5], "km/s²"), ("kg m^2", [2e-4], "kg m²")],
)  # fmt: skip
def test_units_are_those_a_person_reads(unit, values, shown):
    scale = scale_of(unit, values)
    assert scale.unit == shown
    assert scale(scale.factor) == 1


def test_an_overview_shows_friction_in_joints_and_names_whose_work_it_draws():
    """Work of any effect but a drive was named "drives' work"."""
    volt, ohm, henry, constant, load, mu, length, speed, mass = (
        hd.Parameter(name, unit, 1)
        for name, unit in (
            *(("V", "V"), ("R", "ohm"), ("L", "H"), ("k", "N/A"), ("load", "N"), ("mu", "1"), ("l", "m")),
            *(("v", "m/s"), ("mass", "kg")),
        )
    )
    mechanism = hd.Mechanism("linear_motor", (hd.Prismatic("slide", hd.GROUND, hd.Body("block", mass), axis=hd.X),))
    friction = hd.JointFriction("drag", "slide", coulomb(mu_k=mu / 4, mu_s=mu / 2), normal_force=load)
    motor = hd.DCMotor("motor", "slide", volt, ohm, henry, constant)
    scene = hd.Scene(mechanism, (friction, motor, hd.EnergyLedger()), hd.Scales(length, speed))
    shown = texts(simulate(scene, duration="5 s").plot())
    assert "Friction force of drag" in shown
    assert "work, motor" in shown
    assert "drives" not in shown


def test_the_page_of_a_wear_has_its_contours(tmp_path):
    """Between the sectors the contour is that of the gap: the clearance in the direction of the pin, and the depth there."""
    run = simulate("worn_slider_crank", duration="2 ms", tolerance=1e-7, parameters={"repetitions": (1e5, "1")})
    surfaces = worn_surfaces(run, "wear")
    assert {name: depths.shape for name, depths in surfaces.items()} == dict.fromkeys(("bush", "pin"), (32, len(run.t)))
    row = int(np.argmax(run["slider_pin.normal_force"]))
    x, y = run["slider_pin.eccentricity_x"][row], run["slider_pin.eccentricity_y"][row]
    toward = np.arctan2(y, x)
    of_pin = toward - run["rod.angle"][row]
    depth = sum(
        contour(surfaces[name][:, row], np.array([angle]))[0] for name, angle in (("bush", toward), ("pin", of_pin))
    )
    assert depth > 1e-9
    assert run["slider_pin.penetration"][row] == pytest.approx(np.hypot(x, y) - 5e-4 - depth, abs=1e-13)
    figure = run.plot("wear")
    contours, unrolled, volume = figure.axes
    assert "depth enlarged" in contours.get_title(loc="left")
    assert len(contours.lines) == 2 * (1 + INSTANTS) and len(unrolled.lines) == 2 * INSTANTS
    assert volume.lines[0].get_ydata()[-1] == pytest.approx(run["wear.volume"][-1] * 1e9)
    saved = Solution.load(run.save(tmp_path / "run.npz"))
    assert len(saved.plot("wear").axes) == 3  # without the factor, as it holds no sizes


def test_the_page_of_a_contact_that_yields_has_its_dents(tmp_path):
    """To scale: the cap of the first dent is as deep as its history, and as wide as the contact was."""
    run = simulate("yielding_ball", duration="0.8 s", tolerance=1e-7, compiled=False)
    (depth, half), second = dents_of(run, "floor")
    assert depth == run["floor.dent"].max() > second[0] > 1e-6
    assert half == pytest.approx(np.sqrt(0.025 * run["floor.deepest"].max()), rel=1e-12)
    axis = run.plot("floor").axes[0]
    factor = float(axis.get_title(loc="left").split(" times")[0].split()[-1])
    x, y = axis.lines[0].get_data()
    assert (x[-1], -y.min()) == pytest.approx((1e3 * half, 1e3 * factor * depth), rel=1e-9)
    saved = Solution.load(run.save(tmp_path / "run.npz"))
    assert dents_of(saved, "floor") == [] and saved.plot("floor").axes  # without sizes no widths
    assert dents_of(simulate("yielding_ball", duration="0.2 s", tolerance=1e-7, compiled=False), "floor") == []
