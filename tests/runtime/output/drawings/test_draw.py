"""Pictures of mechanisms: points where closed forms put them, clearances as large as the picture says, names that cover nothing."""

import re
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from commands import called
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Polygon

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Model, Solution, load, simulate
from hertzwerk.runtime.output.drawings import labels, picture
from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.drawing_primitives import Paper
from hertzwerk.runtime.output.drawings.picture import PANEL
from hertzwerk.runtime.output.drawings.places import Places
from reference.workshop import workshop

CRANK, ROD, PACE = 0.05, 0.12, 30.0  # m, m, rad/s


def ideal_slider_crank() -> hd.Scene:
    """Crank at constant speed, rod, slider; the slider's pin closes the loop."""
    p = hd.Parameter
    r, l, w = p("crank_length", "m", CRANK), p("rod_length", "m", ROD), p("pace", "rad/s", PACE)
    inertia = hd.Parameter("inertia", "kg m^2", 1e-3)
    crank, slider = (hd.Body(name, hd.Parameter(f"{name}_mass", "kg", 1), inertia) for name in ("crank", "slider"))
    rod = hd.Body("rod", hd.Parameter("rod_mass", "kg", 1), inertia, centre=(l / 2, 0, 0))
    return hd.Scene(
        hd.Mechanism(
            "ideal_slider_crank",
            (
                hd.Revolute("bearing", hd.GROUND, crank, axis=hd.Z), hd.Revolute("crank_pin", crank.at(r, 0, 0), rod, axis=hd.Z),
                hd.Prismatic("guide", hd.GROUND, slider, axis=hd.X), hd.Revolute("slider_pin", slider, rod.at(l, 0, 0), axis=hd.Z),
            ),
        ),
        effects=(
            hd.ConstantSpeed("drive", "bearing", w),
            hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Y),
        ),
        start=hd.Start(position={"guide": r + l}),
        scales=hd.Scales(length=r, speed=r * w, arm=r),
    )  # fmt: skip


@pytest.fixture(scope="module", params=["tree", "absolute"])
def turning(request):
    """Places of the ideal slider-crank over a revolution."""
    model = load(ideal_slider_crank().with_coordinates(request.param))
    return Places.over(simulate(model, duration=2 * np.pi / PACE, tolerance=1e-10))


@pytest.fixture(scope="module")
def crank():
    return simulate(load("slider_crank"), duration="6 ms", tolerance=1e-6)


def point(places: Places, part: str, place: str) -> np.ndarray:
    (mark,) = (mark for mark in places.landmarks if (mark.part, mark.place) == (part, place))
    return places.point(mark)


# ---- where landmarks are ---------------------------------------------------------------------------------------------


def test_joint_points_of_a_slider_crank_are_those_of_its_closed_form(turning):
    angle = PACE * turning.t
    pin = CRANK * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    slider = np.zeros_like(pin)
    slider[:, 0] = CRANK * np.cos(angle) + np.sqrt(ROD**2 - (CRANK * np.sin(angle)) ** 2)
    for part, expected in (("crank_pin", pin), ("slider_pin", slider)):
        for place in ("parent", "child"):
            assert np.max(np.abs(point(turning, part, place) - expected)) < 1e-9, (part, place)
    assert np.ptp(slider[:, 0]) == pytest.approx(2 * CRANK, rel=1e-4)  # a whole revolution was seen
    for part in ("bearing", "crank_pin", "slider_pin"):
        apart = point(turning, part, "parent") - point(turning, part, "child")
        assert np.max(np.abs(apart)) < 1e-11, part


def test_a_start_is_assembled_before_it_is_drawn():
    """A four-bar whose crank alone is given: the coupler's end is where two circles meet."""
    places = Places.at_start(load("n_four_bar").engine, {}, {"foot_0.angle": "0.4 rad"})
    top = point(places, "left_0", "parent")[0]
    assert top == pytest.approx([-np.sin(0.4), np.cos(0.4), 0], abs=1e-12)
    foot, reach = np.array([1.0, 0.0]), 1.0  # of the next post; beam and post are 1 m
    middle, half = (top[:2] + foot) / 2, np.linalg.norm(foot - top[:2]) / 2
    across = np.array([-(foot - top[:2])[1], (foot - top[:2])[0]]) / (2 * half)
    meeting = [middle + sign * np.sqrt(reach**2 - half**2) * across for sign in (1, -1)]
    actual = point(places, "right_0", "child")[0][:2]
    assert min(np.max(np.abs(actual - place)) for place in meeting) < 1e-10
    assert point(places, "right_0", "parent")[0][:2] == pytest.approx(actual, abs=1e-10)


def test_points_and_axes_in_space_by_hand():
    """Spatial slider-crank: crank upright at (0, 0.1, 0.12), its end 0.08 higher; rod of 0.3 to the slider at sqrt(0.09 - 0.01 - 0.04)."""
    places = Places.at_start(load("spatial_slider_crank").engine, {}, {})
    end = (0, 0.1, 0.2)
    assert point(places, "crank_ball", "socket")[0] == pytest.approx(end, abs=1e-15)
    assert point(places, "crank_ball", "ball")[0] == pytest.approx(end, abs=1e-15)
    assert point(places, "slider_joint", "child")[0] == pytest.approx((0.2, 0, 0), abs=1e-15)
    assert point(places, "rod", "centre")[0] == pytest.approx((0.1, 0.05, 0.1), abs=1e-15)
    (axis,) = (mark for mark in places.landmarks if (mark.part, mark.place) == ("slider_joint", "child"))
    yaw = -np.arctan(0.5)
    assert places.direction(axis, "axis")[0] == pytest.approx((-np.sin(yaw), np.cos(yaw), 0), abs=1e-15)


# ---- pictures --------------------------------------------------------------------------------------------------------


def texts(figure) -> str:
    return " ".join(artist.get_text() for artist in figure.findobj(lambda artist: hasattr(artist, "get_text")))


def circles(axis) -> list[tuple[float, np.ndarray]]:
    """Radius and centre of the round polygons of an axis, largest first."""
    found = []
    for patch in axis.findobj(Polygon):
        outline = patch.get_xy()[:-1]
        radii = np.linalg.norm(outline - np.mean(outline[:-1], axis=0), axis=1)
        if len(outline) > 100 and np.ptp(radii) < 1e-6 * np.max(radii):
            found.append((float(np.max(radii)), np.mean(outline[:-1], axis=0)))
    return sorted(found, key=lambda entry: -entry[0])


def _per_inch(figure, axis) -> float:
    """Centimetres of the mechanism on an inch of an axis."""
    return np.ptp(axis.get_xlim()) / (axis.get_position(original=True).width * figure.get_size_inches()[0])


def test_a_clearance_is_drawn_to_scale_and_enlarged_as_the_picture_says(crank):
    figure = crank.draw()
    main, inset = figure.axes
    _, (hole, bush), (pin, centre) = circles(main)  # rim, hole, pin, in cm
    assert (hole, pin) == pytest.approx((1.0, 0.95), rel=1e-6)
    assert bush == pytest.approx([17, 0], abs=1e-6)
    assert centre == pytest.approx(bush, abs=1e-6)
    inches = [_per_inch(figure, axis) for axis in (main, inset)]
    said = re.search(r"([\d.]+)×, its clearance ([\d.]+)×", texts(figure))
    whole, clearance = map(float, said.groups())
    assert inches[0] / inches[1] == pytest.approx(whole, rel=0.05)  # two digits
    _, (hole, _), (pin, _) = circles(inset)
    assert (hole - pin) / inches[1] / (0.05 / inches[0]) == pytest.approx(clearance, rel=0.05)


@pytest.mark.parametrize("name", ["newtons_cradle", "slider_crank_three_clearances", "bricard"])
def test_everything_is_in_the_frame_and_names_cover_nothing(name):
    figure = load(name).draw()
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    drawing = Drawing.of(Places.at_start(load(name).engine, {}, {}), PANEL)
    left, right, bottom, top = drawing.frame
    assert np.all((drawing.parts.extents > (left, bottom)) & (drawing.parts.extents < (right, top)))
    main, names = figure.axes[0], [text for text in figure.axes[0].texts if text.get_gid() == "name"]
    assert {text.get_text() for text in names} >= set(load(name).engine.module.BODIES)
    boxes = [text.get_window_extent(canvas.get_renderer()) for text in names]
    frame = main.get_window_extent()
    assert all(frame.contains(*box.p0) and frame.contains(*box.p1) for box in boxes)
    assert not [(a, b) for i, a in enumerate(boxes) for b in boxes[i + 1 :] if a.overlaps(b)]
    assert main.get_aspect() == 1


def test_names_of_things_at_one_place_stand_beside_each_other():
    figure = Figure(figsize=(4, 4))
    axis = figure.add_axes((0, 0, 1, 1), xlim=(-2, 2), ylim=(-2, 2))
    paper = Paper(axis, 1 / 72)
    paper.line(np.array([[-2.0, 0.0], [2.0, 0.0]]))
    labels.place(
        paper, [labels.Label(f"name_{k}", np.zeros((1, 2)), "black") for k in range(8)], (-2, 2, -2, 2), 1 / 72
    )
    renderer = FigureCanvasAgg(figure).get_renderer()
    boxes = [text.get_window_extent(renderer) for text in axis.texts]
    assert len(boxes) == 8
    assert not [(a, b) for i, a in enumerate(boxes) for b in boxes[i + 1 :] if a.overlaps(b)]
    level = axis.transData.transform((0, 0))[1]  # of the line they are beside
    assert not any(box.y0 < level < box.y1 for box in boxes)


def test_scenes_of_a_users_own_are_drawn_in_space_and_with_every_element(tmp_path):
    model = load(workshop())
    figure = model.draw(initial={"fly.z": "0.4 m", "knee.angle_2": "0.3 rad"})
    figure.savefig(tmp_path / "workshop.png")
    for name in ("post", "arm", "crown", "ball", "pull", "lift", "load", "motor", "twist"):
        assert name in texts(figure), name
    assert Drawing.of(Places.at_start(model.engine, {}, {}), PANEL).parts.view.names is None
    with pytest.raises(InputError, match=r"knee\.angle_3"):
        model.draw(initial={"knee.angle_3": "1 rad"})


def test_runs_that_kept_a_grid_are_drawn_and_saved_ones_say_why_not(tmp_path):
    of_law = {"exponent": "1.4", "stiffness": "2e9 N/m^1.4"}
    run = simulate(load("bouncing_ball"), duration="1 s", tolerance=1e-6, parameters=of_law, grid=40)
    assert run.draw().axes
    saved = Solution.load(run.save(tmp_path / "run.npz"))
    with pytest.raises(InputError, match=r"(?s)saved run.*simulate again"):
        saved.draw()
    with pytest.raises(InputError, match=r"load\('bouncing_ball'\)"):
        Model(saved.engine.model).draw()


# ---- command line ----------------------------------------------------------------------------------------------------


def test_a_knife_edge_lies_along_its_motion_and_what_has_no_mass_no_shape_has_no_name():
    arm = hd.Parameter("arm", "m", 0.3)
    cart = hd.Body("cart", 0)
    sleigh = hd.Body("sleigh", hd.Parameter("mass", "kg", 2), hd.Parameter("inertia", "kg m^2", 0.1))
    joints = hd.Prismatic("way", hd.GROUND, cart, axis=hd.X), hd.Prismatic("up", cart, sleigh, axis=hd.Y)
    scene = hd.Scene(
        hd.Mechanism("skating", joints),
        (hd.KnifeEdge("skate", sleigh.at(-arm, 0, 0), hd.Y),),
        hd.Scales(arm, hd.Parameter("pace", "m/s", 1), arm=arm),
    )
    figure = load(scene).draw()
    words = [text.get_text() for text in figure.axes[0].texts]
    assert "sleigh" in words
    assert "cart" not in words
    blades = [line for line in figure.axes[0].lines if line.get_linewidth() == 2.4]
    assert len(blades) == 1
    assert np.ptp(blades[0].get_ydata()) < 1e-9 < np.ptp(blades[0].get_xdata())


def test_draw_writes_one_picture_and_never_over_another(own_folder):

    hertzwerk = partial(called, "draw")
    hertzwerk("pendulum", "--set", "start_angle=-30 deg", "--duration", "0.5 s")
    assert Path("pendulum.png").read_bytes().startswith(b"\x89PNG")
    hertzwerk("pendulum", "--start", code=2)  # it is there
    hertzwerk("pendulum", "--start", "--overwrite")
    hertzwerk("pendulum", "two_spheres", "--start", "--out", "both.png")
    assert sorted(path.name for path in Path().iterdir()) == ["both.png", "pendulum.png"]
    bad = hertzwerk("pendulum", "two_spheres", "--start", "--duration", "1 s", "--set", "mass", code=2)
    assert "--start" in bad.output
    assert "several targets" in bad.output
    assert "NAME=VALUE" in bad.output


def test_a_warning_on_a_narrow_picture_is_not_cut():
    warning = "accommodating communication of MWMW, and normal forces that are far above what the law is for; " * 2
    page = picture.figure(Places.at_start(load("bouncing_ball").engine, None, None), (warning,))
    renderer = FigureCanvasAgg(page).get_renderer()
    assert max(text.get_window_extent(renderer).x1 for text in page.texts) < page.bbox.x1


def test_details_too_far_away_and_mechanisms_too_large_to_be_drawn_are_refused():
    """Matplotlib warned of identical limits, or raised a bare ValueError."""
    for length in ("1e13 m", "1e90 m"):
        with pytest.raises(InputError, match=r"(?s)slider_pin, 0\.028 m large .*check the units"):
            load("slider_crank").draw(parameters={"rod_length": length})
    for height in ("1.7e308 m", "1e200 m"):
        with pytest.raises(InputError, match="check the units"):
            load("bouncing_ball").draw(parameters={"drop_height": height})
    load("bouncing_ball").draw(parameters={"drop_height": "9e99 m"})
