"""Starts are found, kept and checked: against the closed forms of four-bar and slider-crank, which know nothing of joints, pairs or assembly."""

import math
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp
from commands import called

import hertzwerk.derive as hd
from hertzwerk.derive.laws import flores, hertz_point
from hertzwerk.derive.scenes.four_bar_clearance import base, c, coupler, crank, k, l, r, rocker, steel, w
from hertzwerk.derive.scenes.four_bar_clearance import scene as with_one
from hertzwerk.derive.scenes.slider_crank_three_clearances import scene as with_three
from hertzwerk.runtime import simulate, simulate_many
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.start.separation import overlaps
from hertzwerk.runtime.engine.start.start_values import as_stated, assembled, start_of
from hertzwerk.runtime.loading import engine_model
from reference import scenes

R, L, K, BASE, C, W = 0.05, 0.12, 0.10, 0.13, 5e-4, 1000 * np.pi / 30
BUSH = hd.Parameter("bush_radius", "mm", 10)
JOURNALS = (
    "ball_in_socket", "four_bar_clearance", "journal_in_bearing", "journal_lubricated", "slider_crank",
    "slider_crank_dc_motor", "slider_crank_three_clearances", "slider_crank_two_clearances", "spatial_slider_crank",
)  # fmt: skip


def fresh(start):
    """A four-bar with clearance at both ends of its coupler, as somebody declares it who has not assembled it."""
    mechanism = hd.Mechanism(
        "fresh_four_bar",
        joints=(
            hd.Revolute("main_bearing", hd.GROUND, crank, axis=hd.Z),
            hd.Planar("coupler_plane", hd.GROUND, coupler),
            hd.Revolute("rocker_bearing", hd.GROUND.at(base, 0, 0), rocker, axis=hd.Z),
        ),
        pairs=(
            hd.PinInBush("crank_pin", crank.at(r, 0, 0), coupler.at(0, 0, 0), hd.Z, BUSH, c),
            hd.PinInBush("rocker_pin", coupler.at(l, 0, 0), rocker.at(k, 0, 0), hd.Z, BUSH, c),
        ),
    )
    contacts = (
        hd.Contact(pair.name, hertz_point(steel, steel), flores(hd.Parameter("restitution", "1", 0.9)))
        for pair in mechanism.pairs
    )
    turned = hd.Drive("crank_drive", "main_bearing", speed=w)
    return hd.Scene(mechanism, (turned, with_one.effect("gravity"), *contacts), hd.Scales(c, r * w, l), start)


def near(coupler_start, rocker_start):
    """One of the two ways to assemble it."""
    angles = hd.Parameter("coupler_start", "deg", coupler_start), hd.Parameter("rocker_start", "deg", rocker_start)
    return hd.Start(near=dict(zip(("coupler_plane.angle", "rocker_bearing"), angles, strict=True)))


LOWER, UPPER = fresh(near(-60, -100)), fresh(near(60, 100))


@pytest.fixture(scope="module")
def models():
    built = {}

    def model(scene, coordinates="tree"):
        key = (id(scene), coordinates)
        if key not in built:
            built[key] = engine_model(scene.with_coordinates(coordinates))
        return built[key]

    return model


def four_bar(angle, upper):
    """Angles of coupler and rocker, and their rates, by the law of cosines on the diagonal."""
    pin = R * np.array([np.cos(angle), np.sin(angle)])
    way = np.array([BASE, 0]) - pin
    diagonal, heading = np.hypot(*way), np.arctan2(way[1], way[0])
    at_coupler = np.arccos((L**2 + diagonal**2 - K**2) / (2 * L * diagonal))
    of_coupler = heading + (at_coupler if upper else -at_coupler)
    tip = pin + L * np.array([np.cos(of_coupler), np.sin(of_coupler)])
    of_rocker = np.arctan2(tip[1], tip[0] - BASE)
    columns = np.array(
        [[-L * np.sin(of_coupler), K * np.sin(of_rocker)], [L * np.cos(of_coupler), -K * np.cos(of_rocker)]]
    )
    rates = np.linalg.solve(columns, -R * W * np.array([-np.sin(angle), np.cos(angle)]))
    return pin, of_coupler, of_rocker, rates


def started(model, initial):
    bound, q, u = start_of(model, {}, initial)
    found = dict(zip((*model.coordinates, *model.speeds), (*q, *u), strict=True))
    if model.joints is not model:  # outputs tell what joints do
        y = np.array(model.function("outputs")(0, q, u, bound.c)).ravel()
        found |= dict(zip(model.outputs, y, strict=True))
    return found


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("upper", [True, False])
def test_a_four_bar_is_assembled_from_the_angle_of_its_crank(coordinates, upper, models):
    model = models(UPPER if upper else LOWER, coordinates)
    for degrees in (0, 20, -35):
        pin, of_coupler, of_rocker, rates = four_bar(np.radians(degrees), upper)
        result = started(model, {"main_bearing.angle": (degrees, "deg")})
        place, velocity = ([result[f"coupler_plane.{x}{kind}"] for x in "xy"] for kind in ("", "_speed"))
        assert place == pytest.approx(pin, abs=1e-13)
        assert velocity == pytest.approx(W * np.array([-pin[1], pin[0]]), abs=1e-11)
        assert result["coupler_plane.angle"] == pytest.approx(of_coupler, abs=1e-12)
        assert result["rocker_bearing.angle"] == pytest.approx(of_rocker, abs=1e-12)
        assert result["coupler_plane.angle_speed"] == pytest.approx(rates[0], rel=1e-11)
        assert result["rocker_bearing.speed"] == pytest.approx(rates[1], rel=1e-11)


def test_first_impacts_are_those_of_the_clearance_and_not_of_a_start_at_rest(models):
    model = models(LOWER)
    run = simulate(model, duration="10 ms", tolerance=1e-7)
    still = simulate(
        model, duration="10 ms", tolerance=1e-7, initial={name: (0.0, model.units[name]) for name in model.speeds}
    )
    speeds, from_rest = (max(impact.speed for impact in each.impacts[:3]) for each in (run, still))
    forces, of_rest = (max(impact.peak_force for impact in each.impacts[:3]) for each in (run, still))
    assert from_rest >= R * W  # the whole speed of the crank's pin
    assert speeds < 0.25 * R * W
    assert of_rest > 30e3
    assert forces < of_rest / 5


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
def test_a_slider_crank_with_three_clearances_from_nothing_is_its_closed_form(coordinates, models):
    model = models(FROM_NOTHING, coordinates)
    actual, turning = started(model, {}), 5000 * np.pi / 30
    expected = {"rod_plane.x": R, "guide.travel": R + L}
    expected |= {"rod_plane.y_speed": R * turning, "rod_plane.angle_speed": -R * turning / L}
    joints = (*model.joints.coordinates, *model.joints.speeds)
    assert {"crank_plane.x", "rod_plane.angle", "guide.speed"} < set(joints)
    for name in joints:
        assert actual[name] == pytest.approx(expected.get(name, 0), rel=1e-12, abs=1e-11), name


FROM_NOTHING = replace(with_three, start=hd.Start())


@pytest.mark.parametrize("name", JOURNALS)
def test_a_start_that_is_closed_as_it_stands_is_taken_as_it_is(name):
    model = engine_model(name)
    bound = model.bind()
    stated = [np.array(x).ravel() for x in model.function("start")(bound.p)]
    _, *result = start_of(model, {}, {})
    assert all(np.array_equal(a, b) for a, b in zip(result, stated, strict=True))


def test_stated_start_values_stay_and_the_rest_is_solved_for(models):
    model = models(LOWER)
    result = started(model, {"coupler_plane.x": "50.3 mm", "coupler_plane.x_speed": "0.1 m/s"})
    assert (result["coupler_plane.x"], result["coupler_plane.x_speed"]) == (0.0503, 0.1)
    bound, q, u = start_of(model, {}, {"coupler_plane.x": "50.3 mm"})
    e = np.array(model.function("outputs")(0, q, u, bound.c)).ravel()
    assert np.hypot(*e[:2]) == pytest.approx(3e-4, rel=1e-9)  # the crank's pin is beside its middle by what was given
    assert np.hypot(*e[2:]) < 1e-9
    shifted = start_of(engine_model("slider_crank"), {}, {"guide.travel": "170.3 mm"})[1]
    assert list(shifted) == [0.0, 0.1703]


def faults_of(model, initial, parameters=None):
    with pytest.raises(hd.InputError) as refused:
        simulate(model, duration="1 ms", tolerance=1e-6, initial=initial, parameters=parameters)
    return refused.value.faults


def test_too_much_too_little_and_out_of_reach_are_named_with_the_coordinate_and_the_change(models):
    (fault,) = faults_of(models(LOWER), {"rocker_bearing.angle": "-80 deg"})
    assert "crank_pin open by" in fault.found
    assert "rocker_pin open by" in fault.found
    assert (
        "rocker_bearing.angle at -1.69612 rad in place of -1.39626 rad closes it, a change of -0.3 rad" in fault.remedy
    )
    (fault,) = faults_of(models(LOWER), {}, {"rocker_length": "0.02 m"})
    assert "out of reach" in fault.found
    assert "driven by crank_drive" in fault.remedy
    # Without its drive the crank of a start that says nothing may be anywhere.
    (fault,) = faults_of(engine_model(LOWER.without("crank_drive")), {})
    assert "under-determined" in fault.found
    assert "main_bearing.angle" in fault.found
    assert fault.expected == "1 more value among them"


def test_too_few_positions_and_speeds_are_one_error():
    """The speeds were reported after the positions had been stated: a rod that hangs by its pin on a shaken carriage."""
    length = hd.Parameter("hang", "mm", 100)
    mass = hd.Parameter("m", "kg", 1)
    carriage, rod = hd.Body("carriage", mass), hd.Body("rod", mass, mass * length**2)
    mechanism = hd.Mechanism(
        "hanging",
        (hd.Prismatic("guide", hd.GROUND, carriage, axis=hd.X), hd.Planar("plane", hd.GROUND, rod)),
        (hd.PinInBush("pin", rod.at(0, length, 0), carriage.at(0, 0, 0), hd.Z, BUSH, c),),
    )
    drive = hd.Harmonic(
        "shake", "guide", hd.Parameter("amplitude", "mm", 5), frequency=hd.Parameter("rate", "rad/s", 20)
    )
    model = engine_model(
        hd.Scene(
            mechanism,
            (drive, hd.Contact("pin", hertz_point(steel, steel))),
            hd.Scales(c, hd.Parameter("pace", "m/s", 1), arm=length),
        )
    )
    faults = faults_of(model, {})
    assert [fault.where for fault in faults] == ["start, positions", "start, speeds"]
    assert all("under-determined" in fault.found for fault in faults)
    assert started(model, {"plane.angle": "0 rad", "plane.angle_speed": "0 rad/s"})["plane.y"] == pytest.approx(
        -0.1, rel=1e-12
    )


# -- starts are checked ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("scene", "initial", "pair", "change"),
    [
        ("slider_crank", {"guide.travel": "172 mm"}, "slider_pin", ("guide.travel", 0.1705)),
        ("bouncing_ball", {"vertical.travel": "40 mm"}, "floor", ("vertical.travel", 0.1)),
        ("bouncing_ball", {"vertical.travel": "-1 m"}, "floor", ("vertical.travel", 0.1)),
    ],
)
def test_surfaces_deep_in_each_other_are_named_with_what_brings_them_apart(scene, initial, pair, change):
    model = engine_model(scene)
    (fault,) = faults_of(model, initial)
    name, there = change
    assert fault.where == f"start, {pair}"
    assert f"they touch with {name} at {there:.6g} m" in fault.remedy
    touching = simulate(model, duration="0.1 ms", tolerance=1e-6, initial={name: (there, "m")})
    assert touching.outcome.finished
    assert abs(touching[f"{pair}.gap"][0]) < 1e-9


def test_gears_that_start_tooth_on_tooth_are_turned_by_half_a_pitch():
    """The turn that parts one pair of flanks alone presses the other pair: it was proposed."""
    model = engine_model("gears_with_backlash")
    (fault,) = faults_of(model, {"idler.angle": (math.pi / 31, "rad")})
    result = re.search(r"they are apart with idler.angle at (\S+) rad", fault.remedy)
    assert float(result[1]) == pytest.approx(0, abs=1e-3)
    run = simulate(model, duration="1 us", tolerance=1e-6, initial={"idler.angle": (float(result[1]), "rad")})
    assert min(run["mesh_1.gap"][0], run["mesh_2.gap"][0]) > 0


def test_the_angle_of_a_crank_that_a_coupling_moves_brings_a_yoke_off_its_stop():
    """r cos(angle) + radius = stop: 40 mm cos(angle) = 40 mm - 10 mm, with the yoke solved for."""
    r, mass, pace = hd.Parameter("r", "mm", 40), hd.Parameter("m", "kg", 1), hd.Parameter("pace", "m/s", 1)
    crank, yoke = hd.Body("crank", mass, mass * r**2), hd.Body("yoke", mass)
    stop = hd.GROUND.at(hd.Parameter("stop", "mm", 40), 0, 0)
    hit = hd.SphereOnPlane("hit", yoke.at(0, 0, 0), hd.Parameter("nose", "mm", 10), stop, normal=-hd.X)
    joints = hd.Revolute("main", hd.GROUND, crank, hd.Z), hd.Prismatic("guide", hd.GROUND, yoke, hd.X)
    slot = hd.Coupling("slot", equation=hd.coordinate_of("guide") - r * sp.cos(hd.coordinate_of("main")))
    contact, start = hd.Contact("hit", hertz_point(steel, steel)), hd.Start({"main": hd.Parameter("at", "deg", 10)})
    scales = hd.Scales(r, pace, arm=r)
    model = engine_model(hd.Scene(hd.Mechanism("yoke", joints, (hit,)), (slot, contact), scales, start))
    (fault,) = faults_of(model, {})
    assert f"they touch with main.angle at {math.acos(30 / 40):.6g} rad" in fault.remedy


def test_the_depth_that_is_allowed_is_that_of_hertz_at_five_times_the_speed():
    """sqrt(K d^2.5/m) = 5 sqrt(2 g h): d = 0.00083979 m, of K = 2.4e10 N/m^1.5, m = 1 kg, h = 1 m."""
    (fault,) = faults_of(engine_model("bouncing_ball"), {"vertical.travel": "20 mm"})
    assert "a penetration of 0.08 m" in str(fault)
    assert "at most about 0.00084 m" in str(fault)
    # The first stores 22 times the kinetic energy of the scene; a shallow start that is fast may be meant, too.
    how, preloaded = {"duration": "1 ms", "tolerance": 1e-6}, {"gap": "-1 mm", "restitution": 1.0, "speed": "0.1 m/s"}
    squeezed = simulate(engine_model("ball_between_walls"), **how, parameters=preloaded)
    assert squeezed.outcome.finished
    assert len(squeezed.impacts) >= 2
    assert simulate("bouncing_ball", **how, initial={"vertical.travel": "0.099 m"}).outcome.finished


def test_a_start_one_clearance_deep_is_allowed_and_reported():
    """Stiffness alone throws it apart at twice the crank's speed: an impact might press so deep, a slip of the pen as well."""
    crank = engine_model("slider_crank")
    texts = simulate(
        crank, duration="24 ms", tolerance=1e-6, initial={"guide.travel": "171 mm"}, method="dop853", max_steps=2000
    )
    assert texts.outcome.name == "too_many_steps"
    assert 'take method="auto"' in texts.outcome.remedy
    (warning,) = (text for text in texts.warnings if "starts in overlap" in text)
    assert warning.startswith("slider_pin starts in overlap: start with a gap. ")
    assert "\nwarning: slider_pin starts in overlap: start with a gap\n" in str(texts)
    assert "they touch with guide.travel at 0.1705 m in place of 0.171 m" in warning
    assert "Stiffness alone would throw its 0.0005 m apart at 51.4 m/s" in warning
    assert "damping, which has no approach speed, may hold it there" in warning
    for allowed in ("170 mm", "170.5 mm", "170.6 mm"):  # apart, touching, and pressed as an impact of the scene might
        run = simulate(crank, duration="24 ms", tolerance=1e-6, initial={"guide.travel": allowed})
        assert run.outcome.finished
        assert not any("in overlap" in text for text in run.warnings)
    again = texts.continued(max_steps=10)
    assert not any("in overlap" in text for text in again.warnings)


def test_a_start_far_outside_is_reported_by_the_row_and_by_the_command_line(tmp_path):
    (row,) = simulate_many("slider_crank", [{"guide.travel": "170 cm"}], duration="1 ms", tolerance=1e-6).rows
    assert row.outcome == "bad_input"
    assert "slider_pin open by 1.53 m" in row.message
    said = called("run", "slider_crank", "--set", "guide.travel=170 cm", "--out", tmp_path / "run", code=2)
    assert "guide.travel at 0.17 m in place of 1.7 m closes it" in " ".join(said.output.split())
    assert not (tmp_path / "run").exists()


def test_a_start_that_is_closed_as_stated_is_that_which_assembly_keeps_and_no_other_is_taken_for_one():
    kept = {}
    for name in ("slider_crank_two_clearances", "bricard", "flyball_governor", "n_four_bar", "bicycle"):
        model = engine_model(name)
        bound = model.bind()
        stated, result = map(np.concatenate, (model.evaluate("start", bound.p), assembled(model, bound, {}, [])))
        kept[name] = np.array_equal(stated, result)
        start = as_stated(model, bound)
        assert (start is not None) == kept[name], name
        assert start is None or np.array_equal(np.concatenate(start), result), name
    assert set(kept.values()) == {True, False}


def test_overlaps_of_many_spheres_are_those_of_pairs_written_out_and_looked_at_one_by_one(monkeypatch):
    """Spheres pushed into each other, floor and wall; no function of all pairs is evaluated for what is wrong with one."""
    model = engine_model(scenes.spheres_in_box(6))
    initial = {"flight_2.x": "-10 mm", "flight_3.x": "-20 mm", "flight_3.y": "25 mm"}
    initial |= {"flight_4.y": "2 mm", "flight_5.z": "51 mm"}
    tables = {name: x for name, x in vars(model.module).items() if not name.startswith("__")}
    written = EngineModel(SimpleNamespace(**{**tables, "FAMILIES": ()}))
    calls = []
    evaluate = EngineModel.evaluate
    monkeypatch.setattr(
        EngineModel, "evaluate", lambda self, name, *given: calls.append(name) or evaluate(self, name, *given)
    )
    actual = []
    for each in (model, written):
        bound, faults = each.bind(), []
        q, u = assembled(each, bound, initial, faults)
        actual.append(overlaps(each, bound, initial, q, u))
        assert not faults
        calls.append("")
    ours, theirs = actual
    assert len(ours[0]) >= 3
    assert ours == theirs
    assert not {"gaps", "gap_accelerations"} & set(calls[: calls.index("")])
    assert "gaps" in calls
