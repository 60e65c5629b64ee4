"""Flexible rods in pictures: their sag is enlarged between ends that stay where they are, and the caption states it."""

import numpy as np
import pytest

from hertzwerk.runtime import load, modes, simulate
from hertzwerk.runtime.output.drawings.drawing import Drawing
from hertzwerk.runtime.output.drawings.places import Places


@pytest.fixture(scope="module")
def drawn():
    run = simulate("flexible_slider_crank", duration="4 ms", tolerance=1e-8)
    return run, Drawing.of(Places.over(run), (6.0, 4.0))


def test_the_sag_is_enlarged_the_ends_stay_and_the_caption_states_it(drawn):
    run, drawing = drawn
    parts, last = drawing.parts, -1
    curve = parts.rod("coupler", last) * parts.unit.factor
    angle, end = 150 * run.t[-1], np.array([run["guide.travel"][-1], 0])
    start = 0.15 * np.array([np.cos(angle), np.sin(angle)])
    assert curve[0] == pytest.approx(start, abs=1e-6)
    assert curve[-1] == pytest.approx(end, abs=1e-6)
    way, off = (end - start) / np.linalg.norm(end - start), curve[20] - start
    assert parts.bent == {"coupler": 10.0}
    assert way[0] * off[1] - way[1] * off[0] == pytest.approx(10 * run["coupler.sag_50"][-1], rel=0.01)
    assert "Bending of coupler enlarged 10 times." in drawing.caption()
    assert len(drawing.parts.corners("coupler_start", 0)) > 2


def test_shapes_of_vibration_are_not_enlarged_once_more():
    from hertzwerk.runtime.output.drawings import mode_shapes

    drawn = []
    sheet = mode_shapes.sheet
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            mode_shapes, "sheet", lambda cells, *rest, **more: drawn.extend(cells) or sheet(cells, *rest, **more)
        )
        modes(
            load("flexible_slider_crank"),
        ).plot()
    assert drawn
    assert not any(places.enlarged for places in drawn)
