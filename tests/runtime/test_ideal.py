"""The ideal mechanism, against the closed form of the slider-crank, which knows nothing of eccentricities."""

import numpy as np
import pytest

from hertzwerk.derive import (
    GROUND,
    Body,
    ConstantSpeed,
    Contact,
    Free,
    Mechanism,
    Parameter,
    PinInBush,
    Revolute,
    Scales,
    Scene,
    X,
    Y,
    Z,
)  # fmt: skip
from hertzwerk.derive.laws import power
from hertzwerk.runtime.ideal import ideal_motion
from hertzwerk.runtime.model import load
from reference import ideal_slider_crank as closed_form

R, L, W = 0.05, 0.12, 5000 * np.pi / 30


def followed(times, parameters=None, scene="slider_crank"):
    model = load(scene)
    bound = model.bind(parameters or {})
    q, _ = model.function("start")(bound.p)
    return ideal_motion(model, times, np.array(q).ravel(), bound.c)


@pytest.mark.parametrize("count", [4, 40, 400])
def test_slider_crank_is_the_closed_form_however_coarse_the_times(count):
    t = np.linspace(0, 0.024, count)
    ideal = followed(t)
    assert ideal["guide.travel"] == pytest.approx(closed_form.position(W * t, R, L), rel=1e-14)
    assert np.max(np.abs(ideal["guide.speed"] - closed_form.velocity(W * t, W, R, L))) < 1e-12 * R * W
    assert (
        np.max(np.abs(ideal.acceleration_of("guide.speed") - closed_form.acceleration(W * t, W, R, L)))
        < 1e-12 * R * W**2
    )


def test_dead_centres_carry_the_textbook_accelerations():
    ideal = followed([0.0, 0.006])
    assert ideal.acceleration_of("guide.speed") == pytest.approx([-19419.3605, 7996.2073], rel=1e-8)


def test_it_does_not_depend_on_clearance_or_on_masses():
    t = np.linspace(0, 0.012, 20)
    one = followed(t)
    other = followed(t, {"clearance": "0.01 mm", "slider_mass": "3 kg"})
    assert np.array_equal(one.q, other.q)
    assert np.array_equal(one.acceleration, other.acceleration)


def test_it_follows_the_given_dimensions():
    t = np.linspace(0, 0.012, 20)
    ideal = followed(t, {"crank_radius": "40 mm", "crank_speed": "1000 rpm"})
    assert ideal["guide.travel"] == pytest.approx(closed_form.position(1000 * np.pi / 30 * t, 0.04, L), rel=1e-14)


def test_none_where_the_mechanism_cannot_close():
    """A crank longer than the rod: at 90 degrees the rod does not reach the guide."""
    t = np.linspace(0, 0.006, 7)
    assert followed(t, {"crank_radius": "0.13 m"}) is None


def test_none_where_no_pin_determines_the_coordinates():
    assert followed([0.0, 0.1], scene="soft_ball") is None


def test_unknown_names_are_refused():
    with pytest.raises(KeyError, match=r"guide\.travel"):
        followed([0.0])["guide.angle"]


def held_body(speed):
    """A free body whose three pins sit in bushes of a driven wheel: their axes X, Y, Z leave it no freedom, so it turns with the wheel."""
    mass, clearance, radius = (
        Parameter("mass", "kg", 1.0),
        Parameter("clearance", "mm", 1.0),
        Parameter("radius", "mm", 10.0),
    )
    inertia = tuple(Parameter(f"J_{k}", "kg m^2", 0.01) for k in "xyz")
    wheel, body = Body("wheel", mass, inertia), Body("body", mass, inertia)
    places = {"first": ((0, 1, 0), X), "second": ((0, 0, 1), Y), "third": ((1, 0, 0), Z)}
    off = Parameter("off", "m", 0.3)
    pairs = tuple(
        PinInBush(name, body.at(*(k * off for k in at)), wheel.at(*(k * off for k in at)), axis, radius, clearance)
        for name, (at, axis) in places.items()
    )
    contacts = tuple(Contact(name, power(Parameter("stiffness", "N/m^1.5", 1e8), 1.5)) for name in places)
    drive = ConstantSpeed("drive", "axle", Parameter("wheel_speed", "rad/s", speed))
    joints = (Revolute("axle", GROUND, wheel, Z), Free("float", GROUND, body))
    scales = Scales(length=clearance, speed=Parameter("pace", "m/s", 1.0), arm=off)
    return load(Scene(Mechanism("held", joints, pairs), (drive, *contacts), scales))


def test_a_free_body_is_assembled_and_followed_on_its_quaternion():
    """Six eccentricities, six speeds, seven coordinates."""
    model, speed = held_body(2.0), 2.0
    t = np.linspace(0, 3, 13)
    near = np.array([0.01, -0.02, 0.01, 0.99, 0.05, -0.03, 0.08])
    near[3:] /= np.linalg.norm(near[3:])
    ideal = ideal_motion(model, t, near, model.bind().c)
    zero = np.zeros_like(t)
    expected = np.column_stack([zero, zero, zero, np.cos(speed * t / 2), zero, zero, np.sin(speed * t / 2)])
    assert np.max(np.abs(ideal.q - expected)) < 1e-13
    assert np.max(np.abs(ideal.u - [0, 0, 0, 0, 0, speed])) < 1e-12
    assert np.max(np.abs(ideal.acceleration)) < 1e-11
