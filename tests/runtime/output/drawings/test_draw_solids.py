"""Bodies of simple shapes are drawn as what they are: outlines against their closed forms."""

import numpy as np
import pytest
from matplotlib.patches import Polygon

from hertzwerk.derive import GROUND, Body, EnergyLedger, Mechanism, Parameter, Revolute, Scales, Scene, Start, X, Y, Z
from hertzwerk.runtime import load
from hertzwerk.runtime.output.drawings.ground_planes import ground_planes
from hertzwerk.runtime.output.drawings.parts import Parts
from hertzwerk.runtime.output.drawings.places import Places
from hertzwerk.runtime.output.drawings.view import view_of
from hertzwerk.runtime.output.plots.unit_prefixes import Scale

R, H, L, M = Parameter("r", "m", 0.3), Parameter("h", "m", 0.1), Parameter("l", "m", 0.8), Parameter("m", "kg", 1)
TURN = 0.4


def parts_of(body):
    """A body turned by 0.4 rad about z, projected."""
    scene = Scene(
        Mechanism("shown", (Revolute("pin", GROUND, body, axis=Z),)), (EnergyLedger(),), Scales(length=R, speed=Parameter("pace", "m/s", 1), arm=R),
        Start(position={"pin": Parameter("turn", "rad", TURN)}),
    )  # fmt: skip
    model = load(scene)
    places = Places.at_start(model.engine, None, None)
    return model, Parts(places, view_of(places), Scale("m", 1.0))


def reach(outline, angle):
    """Largest extent of an outline in a direction of the paper."""
    return np.max(outline @ [np.cos(angle), np.sin(angle)])


@pytest.mark.parametrize(
    ("body", "along", "across"),
    [
        (Body.box("it", L, R, H, mass=M), 0.4, 0.15), (Body.cylinder("it", R, L, mass=M, axis=X), 0.4, 0.3), (Body.sphere("it", R, mass=M), 0.3, 0.3),
        (Body.cylinder("it", R, L, mass=M), 0.3, 0.3), (Body.tube("it", R, H, L, mass=M, axis=Y), 0.3, 0.4),
        (Body.cone("it", R, L, mass=M, axis=X), 0.6, 0.3), (Body.rod("it", L, mass=M, axis=X), 0.4, 0.0),
    ],
    ids=lambda value: value.shapes[0].kind if isinstance(value, Body) else "",
)  # fmt: skip
def test_outlines_are_those_of_the_turned_solid(body, along, across):
    model, parts = parts_of(body)
    mark = next(mark for mark in parts.places.landmarks if mark.kind.startswith("solid_"))
    outline = parts.solid(mark, 0)
    assert reach(outline, TURN) == pytest.approx(along, rel=2e-3)
    assert reach(outline, TURN + np.pi / 2) == pytest.approx(across, rel=2e-3, abs=1e-12)
    assert model.draw().axes[0].patches


def test_holes_are_white_and_seen_from_their_end_alone():
    def colours(axis):
        bore = Body.cylinder("bore", H, L, mass=M / 9, axis=axis)
        figure = parts_of(Body.of("it", Body.box("block", L, L, L, mass=M), without=(bore,)))[0].draw()
        return [patch.get_facecolor()[:3] for patch in figure.axes[0].patches if isinstance(patch, Polygon)]

    assert colours(Z).count((1.0, 1.0, 1.0)) == colours(X).count((1.0, 1.0, 1.0)) + 1


def test_planes_of_the_ground_that_meet_are_the_walls_of_a_box():
    """Corners by hand: floor and walls end at each other, and reach as high as the fifth sphere."""
    walls = ground_planes(Places.at_start(load("spheres_in_box").engine, {}, {}))
    corners = {tuple(np.round(corner, 9) + 0.0) for _, outline in walls.values() for corner in outline}
    assert len(walls) == 5 and all(len(outline) == 4 for _, outline in walls.values())
    assert corners == {(x, y, z) for x in (-0.05, 0.05) for y in (0.0, 0.091) for z in (-0.05, 0.05)}
