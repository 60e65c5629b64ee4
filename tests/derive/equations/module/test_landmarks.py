"""Landmarks of a scene: one row for everything a picture shows, numbers by hand, and nothing else in the module changed by them."""

import numpy as np
import pytest
from derived import Derived

from hertzwerk.derive.equations.derivation import derive
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from reference.workshop import workshop

ROWS = (
    ("column", "cylindrical", "parent", "ground", ("axis",)), ("column", "cylindrical", "child", "post", ("axis",)),
    ("knee", "universal", "parent", "post", ("axis",)), ("knee", "universal", "child", "arm", ("axis",)),
    ("table", "planar", "parent", "ground", ("normal",)), ("table", "planar", "child", "bare", ("normal",)),
    ("seat", "revolute", "parent", "bare", ("axis",)), ("seat", "revolute", "child", "crown", ("axis",)),
    ("slope", "sphere_on_plane", "sphere", "ball", ("radius",)),
    ("slope", "sphere_on_plane", "plane", "ground", ("normal",)), ("own", "custom", "first", "ball", ()),
    ("own", "custom", "second", "ground", ()), ("gravity", "gravity", "direction", "ground", ("axis",)),
    ("motor", "turn_drive", "child", "post", ("axis",)), ("lift", "slide_spring", "parent", "ground", ("axis",)),
    ("lift", "slide_spring", "child", "post", ()), ("ease", "turn_damper", "child", "arm", ("axis",)),
    ("shove", "slide_force", "parent", "ground", ("axis",)), ("shove", "slide_force", "child", "bare", ()),
    ("pull", "spring", "first", "arm", ()), ("pull", "spring", "second", "ground", ()),
    ("load", "force", "point", "arm", ()), ("load", "force", "axes", "ground", ("force",)),
    ("gust", "force", "point", "arm", ()), ("twist", "moment", "centre", "crown", ()),
    ("twist", "moment", "axes", "crown", ("moment",)), ("post", "body", "centre", "post", ()),
    ("arm", "body", "centre", "arm", ()), ("crown", "body", "centre", "crown", ()),
    ("ball", "body", "centre", "ball", ()),
)  # fmt: skip
TILTED = (0, -0.5, np.sqrt(0.75))  # Z turned about X by 30 degrees
NUMBERS = {
    ("column", "parent"): (0.2, 0, 0, *TILTED), ("column", "child"): (0, 0, 0, 0, 0, 1),
    ("knee", "parent"): (0, 0, 0.2, 0.6, 0.8, 0), ("knee", "child"): (0, 0, 0, 0, 1, 0),
    ("slope", "sphere"): (0, 0, 0, 0.05), ("slope", "plane"): (0, 0, 0.2, *TILTED),
    ("lift", "parent"): (0.2, 0, 0, *TILTED), ("ease", "child"): (0, 0, 0, 0, 1, 0),
    ("gravity", "direction"): (0, 0, 0, 0, 0, -1), ("pull", "second"): (0, 0.2, 0),
    ("load", "axes"): (0, 0, 0, 0, 0, -3), ("twist", "axes"): (0, 0, 0, 0, 5, 0), ("crown", "centre"): (0, 0.2, 0),
}  # fmt: skip


@pytest.fixture(scope="module")
def derived():
    return Derived(workshop())


def test_everything_a_picture_shows_has_a_row_with_its_numbers(derived):
    # No joint that forbids nothing, no pair without contact, no mass centre of a massless body, no direction of a force that varies.
    assert derived.LANDMARKS == ROWS
    actual = dict(zip(((row[0], row[2]) for row in ROWS), derived.call("landmarks"), strict=True))
    for key, numbers in NUMBERS.items():
        assert actual[key] == pytest.approx(numbers, abs=1e-15), key


def test_effects_left_out_leave_no_landmark():
    everything = {row[0] for row in Derived(slider_crank).LANDMARKS}
    left = {row[0] for row in Derived(slider_crank.without("gravity", "slider_pin_friction", "slider_pin")).LANDMARKS}
    assert everything - left == {"gravity", "slider_pin"}


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_landmarks_cost_a_run_nothing(coordinates, monkeypatch):
    """Without them every other function is the same, and so are the constants: they read the parameters alone."""
    scene = slider_crank.with_coordinates(coordinates)
    with_them = derive(scene)
    assert with_them.functions[-1].name == "landmarks"
    assert with_them.functions[-1].arguments == ("p",)
    monkeypatch.setattr("hertzwerk.derive.equations.module.equation_system.landmarks_of", lambda scene: iter(()))
    without = derive(scene)
    assert without.functions[:-1] == with_them.functions[:-1]
    assert without.constants == with_them.constants


def test_landmarks_are_those_of_the_scene_as_declared_in_any_coordinates():
    """The bodies' own joints to the ground, which absolute coordinates make up, are not drawn."""
    rows = [Derived(slider_crank.with_coordinates(coordinates)).LANDMARKS for coordinates in ("tree", "absolute")]
    assert rows[0] == rows[1]
