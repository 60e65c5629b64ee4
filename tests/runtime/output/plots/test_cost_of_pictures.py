"""What the pictures of a run cost: each is laid out, drawn and saved once, from as few imports and assemblies as it needs."""

import sys
from subprocess import run as command

import numpy as np
import pytest
from matplotlib import _constrained_layout
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from hertzwerk.runtime import simulate
from hertzwerk.runtime.cli import run_folder
from hertzwerk.runtime.engine.start import ideal_mechanism
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.output.plots import curves, save_figure
from hertzwerk.runtime.output.plots.arrangement import Arrangement
from hertzwerk.runtime.system import forked_tasks as processes


@pytest.fixture(scope="module")
def crank():
    return simulate(engine_model("slider_crank"), duration="24 ms", tolerance=1e-6)


@pytest.fixture
def counts(monkeypatch):
    """Number of calls, by name, of what costs time in a picture; all pictures are made in this process."""
    found = {}

    def counted(owner, name):
        original = getattr(owner, name)

        def call(*arguments, **options):
            found[name] = found.get(name, 0) + 1
            return original(*arguments, **options)

        monkeypatch.setattr(owner, name, call)

    counted(Figure, "draw"), counted(Figure, "savefig"), counted(Arrangement, "execute")
    counted(_constrained_layout, "do_constrained_layout")
    monkeypatch.setattr(processes, "cores", lambda: 1)
    return found


def test_pictures_of_a_run_are_laid_out_drawn_and_saved_once(crank, counts, tmp_path, monkeypatch):
    written = run_folder.write(crank, tmp_path / "once", plots=True)
    assert not written.missing
    assert counts == {"draw": 3, "savefig": 3, "execute": 2}  # the mechanism has its places
    counts.clear()
    monkeypatch.setattr(save_figure, "_lay_out", lambda figure: None)  # seeded fault: Matplotlib does it
    run_folder.write(crank, tmp_path / "twice", plots=True)
    assert counts == {"draw": 5, "savefig": 3, "execute": 2}


def test_pictures_of_a_run_are_made_side_by_side(crank, tmp_path, monkeypatch):
    monkeypatch.setattr(processes, "cores", lambda: 2)
    here = []
    original = Figure.savefig
    monkeypatch.setattr(
        Figure, "savefig", lambda figure, *given, **more: here.append(1) or original(figure, *given, **more)
    )
    written = run_folder.write(crank, tmp_path / "run", plots=True)
    assert not written.missing
    made = sorted(path.stem for path in (tmp_path / "run").glob("*.png"))
    assert made == ["mechanism", "overview", "slider_pin"]
    assert 1 <= len(here) < 3  # the others were saved by another process


def test_the_ideal_mechanism_is_assembled_as_often_as_a_picture_needs(crank, monkeypatch):
    times = []
    follow = ideal_mechanism._Closure.follow
    monkeypatch.setattr(ideal_mechanism._Closure, "follow", lambda *given: times.append(1) or follow(*given))
    shown = curves.Curves._sampled(crank)
    found = shown.ideal
    assert len(times) == curves.KNOTS[0]
    start = np.array([crank[name][0] for name in crank.engine.model.coordinates])
    exact = ideal_mechanism.ideal_motion(
        crank.engine.model, shown.t, start, crank.engine.history.controls[: crank.engine.model.nc]
    )
    for part in ("q", "u", "acceleration"):
        missed = np.abs(getattr(found, part) - getattr(exact, part)) / np.ptp(getattr(exact, part), axis=0)
        assert np.max(missed) < 1e-6  # of a deviation, which is 1/200 of a motion, a picture shows 1/1000
    times.clear()
    long = simulate(engine_model("slider_crank"), duration="0.4 s", tolerance=1e-4)  # 33 revolutions
    assert curves.Curves._sampled(long).ideal is not None
    assert len(times) == sum(curves.KNOTS)


def test_pictures_of_a_run_import_neither_scipy_nor_pyplot():
    code = (
        "import sys; from hertzwerk.runtime import load, simulate; run = simulate(load('slider_crank'), duration='1 ms');"
        "run.plot('slider_pin'), run.plot(), run.draw(); heavy = {'sympy', 'scipy', 'matplotlib.pyplot'} & set(sys.modules);"
        "sys.exit(str(heavy) if heavy else 0)"
    )
    done = command([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("names", [(), ("slider_pin",), ("guide.travel", "slider_pin.normal_force")])
def test_texts_of_a_page_lie_on_it_and_cover_nothing(crank, names):
    """Rooms are estimated from the texts: here the texts are measured."""
    figure = crank.plot(*names)
    FigureCanvasAgg(figure).draw()
    panels = [axis for axis in figure.axes if axis.get_visible()]
    boxes = [axis.get_tightbbox() for axis in panels]
    for box in boxes:
        assert 0 <= box.x0 < box.x1 <= figure.bbox.x1
        assert 0 <= box.y0 < box.y1 <= figure.bbox.y1
    assert not [(a, b) for i, a in enumerate(boxes) for b in boxes[i + 1 :] if a.overlaps(b)]
    texts = [text.get_window_extent() for text in figure.texts if text.get_text()]
    assert not [(a, b) for a in boxes for b in texts if a.overlaps(b)]
    assert sum(axis.bbox.width * axis.bbox.height for axis in panels) > 0.4 * figure.bbox.width * figure.bbox.height
