"""Seated starts: journals lie where the closed joint's force presses them, against statics and Newton's equations of the ideal slider-crank."""

from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.derive import Drive, InputError, PointForce, Start
from hertzwerk.derive.scenes.bouncing_ball import scene as ball
from hertzwerk.derive.scenes.journal_in_bearing import journal
from hertzwerk.derive.scenes.journal_in_bearing import load as weight
from hertzwerk.derive.scenes.journal_in_bearing import scene as bearing
from hertzwerk.derive.scenes.slider_crank import w
from hertzwerk.derive.scenes.slider_crank_two_clearances import scene as with_two
from hertzwerk.derive.scenes.translational_clearance import scene as sliding
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.start.start_values import start_of
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(2)  # methods and coordinates that run the same code

R, L, OMEGA = 0.05, 0.12, 5000 * np.pi / 30
ROD, SLIDER, INERTIA, CENTRE = 0.21, 0.14, 2.5e-4, 0.06
SEATED = Start(seated=True)
CRANK = replace(with_two, start=SEATED).without("crank_pin_friction", "slider_pin_friction")
CRANK = CRANK.replace(crank_drive=Drive("crank_drive", "main_bearing", speed=w))


def state(model, parameters=None, initial=None):
    """Eccentricities, normal forces, and second derivatives of the gaps under them."""
    bound, q, u = start_of(model, parameters or {}, initial or {})
    y = np.array(model.function("outputs")(0, q, u, bound.c)).ravel()
    e = y[[".eccentricity_" in name for name in model.outputs]].reshape(-1, 2)
    f, forces = np.array(model.function("applied")(0, q, u, bound.c)).ravel(), []
    for pair in model.pairs:
        pushed, _, force, *_ = model.function(f"contact_{pair}")(0, q, u, np.zeros(model.nz), [1e9] * model.nm, bound.c)
        f += np.array(pushed).ravel()
        forces.append(float(force))
    a = model.function("accelerations")(0, q, u, f, bound.c)[0]
    return e, forces, np.array(model.function("gap_accelerations")(0, q, u, a, bound.c)).ravel()


@pytest.mark.parametrize("exponent", [1.0, 1.5, 2.2])
def test_a_loaded_journal_rests_as_deep_as_its_load_presses_it_and_stays(exponent, seated_bearing):
    stiffness = 500 / 1.5e-5**exponent
    given = {"exponent": exponent, "contact_stiffness": (stiffness, f"N/m^{exponent:g}")}
    (e,), (force,), _ = state(seated_bearing, given)
    assert e == pytest.approx((5e-4 + 1.5e-5) * np.array([0.6, -0.8]), rel=1e-9)
    assert force == pytest.approx(500, rel=1e-8)
    run = simulate(seated_bearing, duration="5 ms", accuracy=1e-6, parameters=given)
    assert run.outcome.finished
    assert [(impact.t, impact.duration) for impact in run.impacts] == [(0.0, None)]  # one contact, which never ends
    assert np.ptp(run["bearing.gap"]) < 1e-6 * 5e-4


@pytest.fixture(scope="module")
def seated_bearing():
    oblique = PointForce("load", journal.at(0, 0, 0), (weight * 3 / 5, -weight * 4 / 5, 0))
    return engine_model(replace(bearing.without("bearing_friction").replace(load=oblique), start=SEATED))


def ideal_forces(angle):
    """Forces on the rod at its crank pin and on the slider at its pin [N], along the ground's axes: Newton and Euler for the ideal mechanism."""
    phi = -np.arcsin(R / L * np.sin(angle))
    along, across = np.array([np.cos(phi), np.sin(phi)]), np.array([-np.sin(phi), np.cos(phi)])
    turning = -R * OMEGA * np.cos(angle) / (L * np.cos(phi))
    spin_up = (R * OMEGA**2 * np.sin(angle) + L * np.sin(phi) * turning**2) / (L * np.cos(phi))
    at_pin = -R * OMEGA**2 * np.array([np.cos(angle), np.sin(angle)])
    centre, slider = (at_pin + d * (spin_up * across - turning**2 * along) for d in (CENTRE, L))
    inertial = ROD * (centre + np.array([0, 9.81]))
    on_slider_x = SLIDER * slider[0]
    moment = -(INERTIA * spin_up + CENTRE * across @ inertial) / L
    on_slider = np.array([on_slider_x, (moment + along[1] * on_slider_x) / along[0]])
    return inertial + on_slider, on_slider, np.array([along, across])


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("degrees", [0, 50, -130])
def test_journals_of_a_slider_crank_lie_where_the_ideal_joints_press_them(coordinates, degrees, slider_cranks):
    """Nearly rigid and with 1 um of clearance the mechanism is the ideal one."""
    nearly = {"clearance": "1 um", "youngs_modulus": "2e8 GPa"}
    near = {"main_bearing.angle": (degrees, "deg")}
    e, forces, off = state(slider_cranks[coordinates], nearly, near)
    on_rod, on_slider, axes = ideal_forces(np.radians(degrees))
    assert forces == pytest.approx(np.linalg.norm([on_rod, on_slider], axis=1), rel=1e-3)
    for result, force in zip(e, (axes @ on_rod, on_slider), strict=True):
        assert result / np.linalg.norm(result) == pytest.approx(force / np.linalg.norm(force), abs=1e-3)
    as_it_is = state(slider_cranks[coordinates], {}, near)
    assert as_it_is[1] == pytest.approx(forces, rel=0.05)
    assert (
        max(abs(off).max(), abs(as_it_is[2]).max()) < 1e-5 * R * OMEGA**2
    )  # what presses is in balance with what holds


@pytest.fixture(scope="module")
def slider_cranks():
    return {coordinates: engine_model(CRANK.with_coordinates(coordinates)) for coordinates in ("tree", "absolute")}


def test_a_seated_start_has_the_joints_forces_and_a_centred_one_impacts(slider_cranks):
    seated = simulate(slider_cranks["tree"], duration="0.5 ms", tolerance=1e-7)
    centred = simulate(engine_model("slider_crank_two_clearances"), duration="0.5 ms", tolerance=1e-7)
    for pair, force in zip(("crank_pin", "slider_pin"), ideal_forces(0)[:2], strict=True):
        first = [next(i.peak_force for i in run.impacts if i.contact == pair) for run in (seated, centred)]
        assert first[0] == pytest.approx(np.linalg.norm(force), rel=0.1)
        assert first[1] > 5 * first[0]
    assert len(seated.impacts) == 2


def test_bodies_that_cannot_be_seated_are_reported():
    for scene, actual in (
        (ball, "floor (sphere_on_plane)"),
        (sliding, "rear_lower (corner_on_face)"),
        (bearing.without("bearing", "bearing_friction"), "bearing (no contact)"),
    ):
        with pytest.raises(InputError) as refused:
            replace(scene, start=replace(scene.start, seated=True))
        (fault,) = refused.value.faults
        assert actual in fault.found
        assert "pin_in_bush" in fault.expected
    with pytest.raises(InputError, match="expected True or False"):
        replace(bearing, start=Start(seated="yes"))
    centred = engine_model(
        replace(with_two, start=replace(with_two.start, seated=True))
    )  # which states where all bodies are
    with pytest.raises(InputError) as refused:
        start_of(centred, {}, {})
    assert "omit some, which are then solved for" in refused.value.faults[0].remedy
