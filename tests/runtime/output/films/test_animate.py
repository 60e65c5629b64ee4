"""Films: as many frames as asked for, shapes moved to where the run has them, forces that acted, files whole or not there."""

import io
import re
import shutil
import subprocess
from base64 import b64decode
from functools import partial
from itertools import pairwise

import numpy as np
import pytest
from commands import called
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon
from PIL import Image

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Solution, simulate
from hertzwerk.runtime.engine.model.build import build_hard_scene
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.picture import PANEL
from hertzwerk.runtime.output.drawings.places import Places
from hertzwerk.runtime.output.films import film as films
from hertzwerk.runtime.output.films.film_clock import Clock
from hertzwerk.runtime.output.films.moving_paper import MovingPaper
from hertzwerk.runtime.output.films.stage import LONGEST, RUBBING, Stage, contact_of, slip_of
from hertzwerk.runtime.output.films.writers import _palette
from hertzwerk.runtime.output.plots.plot_style import CYCLE, VERMILLION


@pytest.fixture(scope="module")
def ball():
    return simulate(engine_model("bouncing_ball"), duration="0.6 s", tolerance=1e-6)


@pytest.fixture(scope="module")
def crank():
    return simulate(engine_model("slider_crank"), duration="3 ms", tolerance=1e-6)


def stage_of(run, frames) -> Stage:
    return Stage.of(run, Clock(np.linspace(run.engine.t_start, run.engine.t_end, frames), 10.0, 1.0))


def frames_of(path) -> list[np.ndarray]:
    found = []
    with Image.open(path) as film:
        for k in range(film.n_frames):
            film.seek(k)
            found.append(np.asarray(film.convert("RGB")))
    return found


# ---- frames ----------------------------------------------------------------------------------------------------------


def test_a_gif_has_the_frames_and_the_length_requested(ball, tmp_path, monkeypatch):
    path = ball.animate(tmp_path / "ball.gif", fps=15, slow=2)
    shown = []
    with Image.open(path) as film:
        assert abs(film.n_frames - 0.6 * 15 * 2) <= 1
        for k in range(film.n_frames):
            film.seek(k)
            shown.append(film.info["duration"])
    assert sum(shown) == pytest.approx(1200, abs=10)  # ms; frames of 70 ms alone would be 1260
    frames = frames_of(path)
    below = slice(100, None)  # the time, which differs always, stands above
    assert all(np.any(a[below] != b[below]) for a, b in pairwise(frames))
    show = Stage.show
    monkeypatch.setattr(Stage, "show", lambda stage, k: show(stage, 0))
    still = frames_of(ball.animate(tmp_path / "still.gif", fps=15, slow=2))
    assert len(still) == 1  # Pillow joins equal frames


def artists(stage) -> int:
    return len(stage.figure.findobj())


def test_a_further_frame_makes_no_shapes(crank, monkeypatch):
    """But an arrow for the first force of a pair, in the drawing and in the window."""
    stage = stage_of(crank, 12)
    stage.show(0)
    made, there = stage.made, artists(stage)
    assert made > 25
    for k in range(1, 12):
        stage.show(k)
    assert stage.made - made <= 2 * 2 * 2 + len(stage.drawing.paths)  # of friction too
    assert artists(stage) - there == stage.made - made
    seen = stage.made
    monkeypatch.setattr(
        MovingPaper, "_next", lambda self, kind, make, look: (self.axis.add_artist(shape := make()), shape)[1]
    )
    stage.show(5)
    assert artists(stage) - there > seen  # the count would tell


def visible(axis, kind):
    return [artist for artist in axis.findobj(kind) if artist.get_visible() and artist.axes is axis]


def test_shapes_are_where_the_run_has_them_and_colours_those_of_the_pictures(ball):
    stage = stage_of(ball, 7)
    for k in (3, 1, 6):
        stage.show(k)
        axis = stage.papers[0].axis
        rounds = [patch.get_xy() for patch in visible(axis, Polygon) if len(patch.get_xy()) > 150]
        (outline,) = rounds
        height = ball.at([stage.clock.times[k]])["vertical.travel"][0]
        middle = (np.max(outline[:, 1]) + np.min(outline[:, 1])) / 2
        assert middle == pytest.approx(height, abs=1e-9)
        assert f"t = {stage.clock.times[k]:.1f}" in stage._time.get_text()
    image = Image.new("RGB", (1 + len(CYCLE), 1), "white")
    for k, colour in enumerate(CYCLE):
        image.putpixel((1 + k, 0), tuple(bytes.fromhex(colour[1:])))
    actual = np.asarray(image.quantize(palette=_palette(), dither=Image.Dither.NONE).convert("RGB"), dtype=int)
    assert np.array_equal(actual[0, 0], (255, 255, 255))
    assert np.max(np.abs(actual - np.asarray(image, dtype=int))) <= 8


def test_the_path_of_a_journal_grows(crank):
    stage = stage_of(crank, 6)
    lengths = []
    for k in range(6):
        stage.show(k)
        (window,) = stage.papers[1:]
        lengths.append(
            max(len(line.get_xdata()) for line in visible(window.axis, Line2D) if line.get_linewidth() == 0.5)
        )
    assert lengths[0] == 1
    assert np.all(np.diff(lengths) > 0)
    assert lengths[-1] == len(stage.drawing.parts.places.t)


def arrows(axis, width=1.6) -> list[np.ndarray]:
    """Lines of forces: those of drives are thinner."""
    return [line for line in visible(axis, Line2D) if (line.get_color(), line.get_linewidth()) == (VERMILLION, width)]


def test_every_impact_has_an_arrow_however_short_it_is(crank, monkeypatch):
    stage = stage_of(crank, 16)
    assert max(i.duration for i in crank.impacts if i.duration) < 0.5 * stage.clock.times[1]
    longest, shown = 0.0, set()
    for k in range(16):
        stage.show(k)
        begin, end = stage.clock.times[max(k - 1, 0)], stage.clock.times[k]
        acted = any(i.t < end and i.t + (i.duration or 1) > begin for i in crank.impacts)
        (window,) = stage.papers[1:]
        assert bool(arrows(window.axis)) == acted == bool(arrows(stage.papers[0].axis)), k
        shown |= {k} if acted else set()
        longest = max([longest, *(np.hypot(*np.ptp(a.get_xydata(), axis=0)) for a in arrows(stage.papers[0].axis))])
    assert 3 < len(shown) < 16
    # the line ends a little before the tip of its head
    assert 0.9 * LONGEST < longest / stage.drawing.point < LONGEST
    at_frames = stage_of(crank, 16)
    monkeypatch.setattr(Stage, "_largest", property(lambda stage: {
        name: force[np.searchsorted(stage.curves.t, stage.clock.times)] for name, force in stage.forces.items()}))  # fmt: skip
    missed = [k for k in shown if not at_frames._acting(k)]
    assert len(missed) > 2  # of forces at the frames alone


def test_friction_is_that_of_its_law_and_acts_against_the_slip(crank):
    """Coulomb's law with a tanh, by hand; of sliding the velocity that the equations have; no ledger is asked."""
    stage = stage_of(crank, 40)
    t, size = stage.curves.t, stage.frictions["slider_pin"]
    force, velocity = (stage.curves[f"slider_pin.{name}"] for name in ("normal_force", "sliding_velocity"))
    by_hand = 0.1 * force * np.tanh(np.abs(velocity) / 0.1)
    assert np.max(by_hand) > 1e3
    np.testing.assert_allclose(size, by_hand, atol=1e-3 * np.max(by_hand))
    places, (kind, marks) = stage.drawing.parts.places, stage._pairs["slider_pin"]
    for m in np.flatnonzero(force > 0.5 * np.max(force))[::5]:
        j = int(np.searchsorted(places.t, t[m]))
        point, normal = contact_of(stage.drawing.parts, kind, marks, j)
        slip = slip_of(places, marks, point, j)
        tangent = np.cross([0, 0, 1], normal)
        assert slip @ tangent == pytest.approx(velocity[m], rel=0.05)  # by differences; positive: the pin turns
    seen = [found for k in range(1, 40) for found in [stage._friction("slider_pin", k, int(stage.at[k]))] if found]
    assert len(seen) > 3
    for k in range(40):
        stage.show(k)
        assert len(arrows(stage.papers[0].axis, RUBBING)) <= len(arrows(stage.papers[0].axis))
    texts = " ".join(text.get_text() for text in stage._layout.page.texts)
    assert "thinner its friction" in texts.replace("\n", " ")


def test_friction_that_holds_a_body_has_its_arrow_too():
    """A block on an incline of 3 in 4: it slides, stops, and is held by 3/5 of its weight, uphill."""
    run = simulate(EngineModel(build_hard_scene("incline_coulomb")), duration="0.2 s", tolerance=1e-8,
                   parameters={"friction_coefficient": 2.0, "static_coefficient": 2.0})  # fmt: skip
    stage = stage_of(run, 9)
    assert run["surface.sliding_velocity"][-1] == pytest.approx(0, abs=1e-12)
    (sliding, drag), (stuck, held) = (stage._friction("surface", k, int(stage.at[k])) for k in (1, 8))
    assert drag == pytest.approx(2 * 0.8 * 9.81, rel=1e-6)
    assert held == pytest.approx(0.6 * 9.81 * 1.001, rel=1e-6)  # of the carriage too
    for way in (sliding, stuck):
        assert way == pytest.approx([-1, 0, 0], abs=1e-12)


@pytest.mark.parametrize("name", ["slider_crank", "two_spheres", "bouncing_ball", "translational_clearance"])
def test_contact_points_and_directions_by_hand(name):
    model = engine_model(name)
    initial = {"guide.travel": "169.6 mm"} if name == "slider_crank" else {}
    parts = Drawing.of(Places.at_start(model, {}, initial), PANEL).parts
    kinds = dict(model.module.PAIRS)
    (kind, marks), *_ = ((kind, marks) for (part, kind), marks in parts.of.items() if part in kinds)
    first, second = (parts.positions[id(mark)][0] for mark in marks)
    found = contact_of(parts, kind, marks, 0)
    point, way = found
    assert np.linalg.norm(way) == pytest.approx(1, rel=1e-12)
    if name == "slider_crank":  # the pin is to the right of the bush by 0.4 mm and 9.5 mm large
        assert first - second == pytest.approx([0.4e-3, 0, 0], abs=1e-12)
        assert point - second == pytest.approx([9.9e-3, 0, 0], abs=1e-12)
        assert way == pytest.approx([-1, 0, 0], abs=1e-12)
    elif name == "two_spheres":
        assert way == pytest.approx((first - second) / np.linalg.norm(first - second), abs=1e-12)
        assert np.linalg.norm(point - second) == pytest.approx(marks[1].size("radius"), rel=1e-12)
    elif name == "bouncing_ball":
        assert point == pytest.approx([0, 1.0, 0], abs=1e-12)  # a metre above the plane
        assert way == pytest.approx([0, 1, 0], abs=1e-12)
    else:
        assert point == pytest.approx(first, abs=1e-15)


@pytest.mark.slow  # it derives what is read of its run
def test_boxes_and_spheres_on_solids_have_arrows_where_their_forces_act():
    """A ball pressed on a box beside its middle, a rectangle flat on another: upwards, from where they touch."""
    sizes = {"r": 10, "w": 100, "h": 80}
    (r, w, h), K = (hd.Parameter(name, "mm", size) for name, size in sizes.items()), hd.Parameter("K", "N/m", 1e6)
    bodies, aside = [hd.Body(name, hd.Parameter("m", "kg", 1)) for name in ("ball", "block")], hd.GROUND.at(w, 0, 0)
    joints = [
        hd.Prismatic(body.name + "_guide", aside if k else hd.GROUND, body, axis=hd.Y) for k, body in enumerate(bodies)
    ]
    one, two = (body.at(0, 0, 0) for body in bodies)
    pairs = (
        hd.SphereOnBox("bed", one, r, hd.GROUND.at(-w / 4, 0, 0), w, h, w),
        hd.BoxOnBox("stack", two, w, h, aside, w, h, r / 10),
    )
    effects = (
        *(hd.Contact(p.name, hd.laws.power(K, 1)) for p in pairs),
        hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), -hd.Y),
    )
    start = hd.Start(position={"ball_guide": h / 2 + r, "block_guide": h})
    scales = hd.Scales(length=r, speed=hd.Parameter("pace", "m/s", 0.1))
    scene = hd.Scene(hd.Mechanism("solids", joints, pairs), effects, scales, start)
    run = simulate(engine_model(scene), duration="5 ms", tolerance=1e-6)
    stage = stage_of(run, 5)
    stage.show(3)
    assert len(arrows(stage.papers[0].axis)) == 5  # of the rectangles four corners
    (point, way), (corner, up) = (stage._contact(name, 3, int(stage.at[3])) for name in ("bed", "stack_1"))
    assert (point, way) == (pytest.approx([0, 0.04, 0], abs=2e-5), pytest.approx([0, 1, 0], abs=1e-12))
    assert (corner, up) == (pytest.approx([0.1 - 0.049, 0.04, 0], abs=2e-5), pytest.approx([0, 1, 0], abs=1e-12))
    assert any("With friction in one: bed, stack_.." in note for note in stage.notes())


# ---- clock -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("span", "slow", "said"),
    [(0.024, 500.0, "500 times slower"), (5.0, 1.0, "Real time"), (100.0, 0.1, "10 times faster"), (1.0, 10.0, "10 times slower")],
)  # fmt: skip
def test_a_film_takes_about_eight_seconds_or_as_long_as_the_motion(span, slow, said):
    clock = Clock.of(0.0, span, 25, None, ".gif", [])
    assert (clock.slow, clock.pace()) == (slow, said)
    assert 4 < len(clock.times) / 25 < 16
    texts = [clock.shown(k) for k in range(len(clock.times))]
    assert len(set(texts)) == len(texts)


# ---- files -----------------------------------------------------------------------------------------------------------


def test_every_fault_of_a_film_is_reported_at_once(ball, tmp_path, monkeypatch):
    with pytest.raises(InputError, match=r"(?s)\.gif, \.mp4, \.html.*fps.*slow"):
        ball.animate(tmp_path / "film.avi", fps=0, slow=-1)
    with pytest.raises(InputError, match="up to 50"):  # browsers show a faster GIF at ten frames a second
        ball.animate(tmp_path / "film.gif", fps=60)
    with pytest.raises(InputError, match=r"frames; expected at most 5,000"):
        ball.animate(tmp_path / "film.gif", slow=1000)
    monkeypatch.setattr("matplotlib.animation.FFMpegFileWriter.isAvailable", lambda: False)
    with pytest.raises(InputError, match="ffmpeg"):
        ball.animate(tmp_path / "film.mp4")
    saved = Solution.load(ball.save(tmp_path / "run.npz"))
    with pytest.raises(InputError, match=r"(?s)saved run.*simulate again"):
        films.animate(saved, tmp_path / "film.gif")
    (tmp_path / "there.gif").write_text("mine")
    with pytest.raises(InputError, match="exists"):
        ball.animate(tmp_path / "there.gif")
    assert (tmp_path / "there.gif").read_text() == "mine"
    assert {path.name for path in tmp_path.iterdir()} == {"run.npz", "there.gif"}


@pytest.mark.parametrize(("after", "left"), [(5, 5), (1, 0)])
def test_an_interrupted_film_has_the_frames_so_far(ball, tmp_path, after, left):
    recorded = []

    def stop(fraction):
        recorded.append(fraction)
        if len(recorded) == after:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ball.animate(tmp_path / "film.gif", fps=20, slow=1, progress=stop)
    assert recorded == sorted(recorded)
    assert [len(frames_of(path)) for path in tmp_path.iterdir()] == ([left] if left else [])


def test_a_page_holds_its_frames_and_fetches_nothing(ball, tmp_path):
    page = ball.animate(tmp_path / "film.html", fps=10, slow=1).read_text()
    assert "http" not in page
    frames = [b64decode(content) for content in re.findall(r"data:image/png;base64,([^\"]*)\"", page)]
    assert len(frames) == 6
    first, *others = (np.asarray(Image.open(io.BytesIO(frame))) for frame in frames)
    assert np.all(first[..., 3] == 255)
    for other in others:  # holds what moved, clear elsewhere
        assert 0 < np.count_nonzero(other[..., 3]) < other[..., 3].size / 4
    assert "fa-" not in re.sub(r"base64,[^\"]*", "", page)


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="no ffmpeg")
def test_a_video_has_the_frames_requested(ball, tmp_path):
    path = ball.animate(tmp_path / "film.mp4", fps=10, slow=2)
    command = ["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames", "-of", "csv=p=0"]
    assert subprocess.run([*command, path], capture_output=True, text=True, check=True).stdout.strip() == "12"


def test_the_command_writes_one_film_and_never_over_another(own_folder):
    command = ["animate", "bouncing_ball", "--duration", "0.3 s", "--fps", "10", "--set", "drop_height=0.2 m"]

    hertzwerk = partial(called, *command)
    assert "6 frames, 2 times slower" in hertzwerk("--slow", "2").output
    before = (own_folder / "bouncing_ball.gif").read_bytes()
    hertzwerk(code=2)
    assert (own_folder / "bouncing_ball.gif").read_bytes() == before
    hertzwerk("--overwrite", "--slow", "1")
    assert (own_folder / "bouncing_ball.gif").read_bytes() != before
    assert ".mp4" in hertzwerk("--out", "film.avi", "--fps", "many", code=2).output


def test_the_command_films_other_coordinates_an_accuracy_and_a_grid(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / ".cache"))
    made = []
    monkeypatch.setattr(
        films, "animate", lambda run, *_, **__: made.append(run) or films.Film("x", 2, 2, Clock(run.t, 1.0, 1.0))
    )
    how = ["--coordinates", "absolute", "--accuracy", "1e-4", "--grid", "7", "--duration", "0.1 s"]
    called("animate", "bouncing_ball", *how)
    called("animate", "bouncing_ball", "--duration", "0.1 s")
    requested, plain = made
    assert (requested.engine.model.coordinates[0], plain.engine.model.coordinates[0]) == ("ball.x", "vertical.travel")
    assert (requested.settings.accuracy, len(requested.t)) == (1e-4, 7)
    assert (plain.settings.accuracy, plain.settings.tolerance) == (None, 1e-6)
