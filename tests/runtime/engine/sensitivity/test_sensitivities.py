"""Derivatives of runs: against closed forms, against differences of runs, and with each term of the jumps left out."""

import copy
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import sympy as sp
from blocks import CARRIAGE, MASS, WEIGHT, block

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.laws import coulomb, power, smooth_coulomb
from hertzwerk.runtime import Samples, simulate
from hertzwerk.runtime.engine.model.si_values import si_units
from hertzwerk.runtime.engine.sensitivity import changes_along_run, saltation, step_chain, tangent
from hertzwerk.runtime.loading import engine_model

CRANK = {"duration": "1.5 ms", "tolerance": 1e-12}
DASHPOT = {
    "floor": "power(K=1e6 N/m, n=1) x power_damping(chi=200 N s/m, m=0)"
}  # jumps at the onset, releases overlapping


def made(model, changes=(), **how):
    """A run with changes of parameters and initial states in SI."""
    units = {**si_units(model), **model.units}
    given = {name: (value, units[name] or "1") for name, value in dict(changes).items()}
    parts = ({name: given[name] for name in given if (name in model.parameters) == kind} for kind in (True, False))
    return simulate(
        model, method=how.pop("method", "dop853"), compiled=False, parameters=next(parts), initial=next(parts), **how
    )


def difference(model, name, now, read, step=1e-3, **how):
    """Derivative by central differences, twice extrapolated, and how far that is from once."""
    by = [step * (abs(now) or 1) / 2**k for k in range(3)]
    first = [
        (read(made(model, {name: now + d}, **how)) - read(made(model, {name: now - d}, **how))) / (2 * d) for d in by
    ]
    second = [(4 * b - a) / 3 for a, b in pairwise(first)]
    found = (16 * second[1] - second[0]) / 15
    return found, np.abs(found - second[1])


def compared(model, names, read, step=1e-3, **how):
    """Check derivatives at the end against differences, of the largest in each history, where those are sure."""
    run = made(model, **how)
    actual, bound, judged = run.sensitivities(*names), model.bind(), 0
    worst = 0.0
    for name in names:
        now = bound[name] if name in model.parameters else run.engine.initial[name]
        expected, unsure = difference(
            model, name, now, lambda r: np.array([r.engine.final[s] for s in read]), step=step, **how
        )
        for state, value, doubt in zip(read, expected, unsure, strict=True):
            history = actual[state, name]
            size = np.nanmax(np.abs(history))
            if doubt <= 1e-7 * size:
                judged += 1
                worst = max(worst, abs(history[-1] - value) / size)
    assert judged >= len(names)
    assert worst <= 1e-6


# -- closed forms ------------------------------------------------------------------------------------------------------


def test_flight_is_free_fall(ball):
    """y = h - g t^2/2, falling to the floor at t = sqrt(2 (h - r)/g), with sqrt(2 g (h - r)): drop_height counts from the floor."""
    run = made(ball, duration="1 s", tolerance=1e-12)
    result, g = run.sensitivities("gravity", "vertical.travel"), ball.bind()["gravity"]
    free = run.t < run.impacts[0].t
    np.testing.assert_allclose(result["vertical.travel", "gravity"][free], -(run.t[free] ** 2) / 2, rtol=0, atol=1e-13)
    np.testing.assert_allclose(result["vertical.travel", "vertical.travel"][free], 1, rtol=1e-13)
    (impact,) = run.impacts
    assert result.impacts("t", "gravity")[0] == pytest.approx(-impact.t / (2 * g), rel=1e-10)
    assert result.impacts("t", "vertical.travel")[0] == pytest.approx(1 / impact.speed, rel=1e-10)
    assert result.impacts("speed", "vertical.travel")[0] == pytest.approx(g / impact.speed, rel=1e-10)
    assert result.unit("vertical.travel", "gravity") == "m/(m/s^2)"


def test_a_hertz_impact_follows_its_power_laws():
    """Undamped: depth ~ (m v^2/K)^(2/5), force ~ K^(2/5) (m v^2)^(3/5); equal masses, K ~ E."""
    spheres = engine_model("two_spheres")
    run = made(spheres, {"restitution": 1.0}, duration="0.05 s", tolerance=1e-12)
    found, bound, (impact,) = run.sensitivities("mass", "youngs_modulus"), spheres.bind(), run.impacts
    for name, of_depth, of_force in (("mass", 2 / 5, 3 / 5), ("youngs_modulus", -2 / 5, 2 / 5)):
        depth, force = (found.impacts(what, name)[0] * bound[name] for what in ("peak_penetration", "peak_force"))
        assert depth / impact.peak_penetration == pytest.approx(of_depth, rel=2e-7)
        assert force / impact.peak_force == pytest.approx(of_force, rel=2e-7)


# -- differences of runs -----------------------------------------------------------------------------------------------


def test_impacts_of_a_falling_ball_and_a_crank_with_clearance(ball, crank):
    compared(ball, ("restitution", "drop_height", "gravity", "vertical.travel"), ("vertical.travel", "vertical.speed"),
             duration="2 s", tolerance=1e-12)  # fmt: skip
    compared(crank, ("restitution", "clearance", "friction_coefficient", "crank_radius", "guide.travel"),
             ("guide.travel", "crank_pin.speed", "slider_pin.dissipated"), step=1e-4, **CRANK)  # fmt: skip


def test_a_force_that_jumps_and_a_release_under_overlap():
    model = engine_model("bouncing_ball", laws=DASHPOT)
    run = made(model, duration="2 s", tolerance=1e-12)
    assert set(run["floor.mode"]) == {0, 1, 2}
    names, states = (
        ("floor_chi", "floor_K", "mass", "drop_height"),
        ("vertical.travel", "vertical.speed", "floor.dissipated"),
    )
    compared(model, names, states, duration="2 s", tolerance=1e-12)


@pytest.fixture(scope="module")
def sliding():
    """A block that slides to rest: by v^2/(2 a) in v/a, with a = mu_k m g/(m + carriage)."""
    return engine_model(block(coulomb(hd.Parameter("mu_k", "1", 0.2), hd.Parameter("mu_s", "1", 0.3))))


def test_friction_that_stops(sliding):
    speed, a = 1.0, 0.2 * WEIGHT / (MASS + CARRIAGE)
    run = made(sliding, {"slide": speed}, duration="1 s", tolerance=1e-12)
    derivatives = run.sensitivities("slide", "mu_k", "mu_s")
    assert run["floor_0.slip"][-1] == 0
    assert derivatives["along_0.travel", "slide"][-1] == pytest.approx(speed / a, rel=1e-9)
    assert derivatives["along_0.travel", "mu_k"][-1] == pytest.approx(-(speed**2) / (2 * a * 0.2), rel=1e-9)
    assert (
        np.abs(
            [derivatives["along_0.travel", "mu_s"], derivatives["along_0.speed", "mu_k"][-1:].repeat(len(run.t))]
        ).max()
        < 1e-12
    )
    assert derivatives["floor_0.friction_force", "mu_k"][1] == pytest.approx(WEIGHT, rel=1e-6)


def stop_of(sliding, method):
    """Derivatives of the time of a block's stop by its speed and friction beside v/a and its own, relative errors."""
    speed, a = 1.0, 0.2 * WEIGHT / (MASS + CARRIAGE)
    run = made(sliding, {"slide": speed}, duration="1 s", tolerance=1e-10, method=method)
    (row,), (times,) = run.sensitivities("slide", "mu_k").events
    assert run.t[row] == pytest.approx(speed / a, rel=1e-9)
    return times / np.array([1 / a, -speed / (a * 0.2)]) - 1


def test_friction_stops_at_a_time_that_speed_and_friction_tell(sliding, monkeypatch):
    for method in ("dop853", "dopri5", "auto", "esdirk", "rodas"):
        assert np.abs(stop_of(sliding, method)).max() < 1e-8, method
    events = changes_along_run.events_of
    faster = lambda *of: (jump := events(*of)) and replace(jump, slopes=(jump.slopes[0] * 1.0001, jump.slopes[1]))  # noqa: E731
    monkeypatch.setattr(changes_along_run, "events_of", faster)
    assert np.abs(stop_of(sliding, "dop853")).min() > 1e-5


def test_absolute_coordinates_close_their_loops(crank):
    model = engine_model("slider_crank", coordinates="absolute")
    absolute, tree = made(model, **CRANK), made(crank, **CRANK)
    for name in ("restitution", "clearance"):
        one, other = (run.sensitivities(name).at(np.array([1.4e-3]), "guide.travel", name) for run in (absolute, tree))
        np.testing.assert_allclose(one, other, rtol=2e-6)
    of_constraints = [absolute.sensitivities("crank_radius")[name, "crank_radius"] for name in model.constraints]
    assert np.abs(of_constraints).max() < 1e-7


@pytest.mark.parametrize("method", ["dopri5", "esdirk", "rodas", "auto"])
def test_every_method_in_the_graph(ball, method):
    how = {"duration": "0.7 s", "tolerance": 1e-11}
    derivatives = made(ball, method=method, **how).sensitivities("restitution", "drop_height")
    exact = made(ball, duration="0.7 s", tolerance=1e-13).sensitivities("restitution", "drop_height")
    for name in derivatives.names:
        for state in ("vertical.travel", "vertical.speed"):
            assert derivatives[state, name][-1] == pytest.approx(exact[state, name][-1], rel=2e-6), name


def test_shape_parameters_of_a_cam_have_derivatives():
    """By differences of runs; the way of a roller's centre does not depend on its radius, as the rim follows it."""
    cam, how = engine_model("cam_follower"), {"duration": "2 ms", "tolerance": 1e-12}
    compared(cam, ("lift", "base", "cam_speed"), ("guide.travel", "guide.speed"), **how)
    derivatives = made(cam, **how).sensitivities("roller_radius", "lift")
    assert np.abs(derivatives["guide.travel", "roller_radius"]).max() < 1e-9
    assert np.abs(derivatives["guide.travel", "lift"]).max() > 1e-3


def test_every_history_has_a_derivative(crank):
    """By differences at a time of its own, in contact: forces, gaps, energies, readings of bodies, contacts and joints."""
    names = ("slider_pin.normal_force", "slider_pin.penetration", "slider_pin.gap", "slider_pin.gap_rate", "energy",
             "slider_pin.sliding_velocity", "guide.acceleration", "slider_pin.approach_speed", "slider_pin.force_x",
             "rod.kinetic_energy", "crank_pin.reaction_x", "crank_drive.torque")  # fmt: skip
    run = made(crank, duration="0.3 ms", tolerance=1e-12)
    t = np.array([0.255e-3])
    assert run.at(t)["slider_pin.penetration"] > 0
    actual, now = run.sensitivities("clearance"), crank.bind()["clearance"]
    expected, unsure = difference(crank, "clearance", now, lambda r: np.array([r.at(t)[name][0] for name in names]),
                                  step=1e-4, duration="0.3 ms", tolerance=1e-12)  # fmt: skip
    for name, value, doubt in zip(names, expected, unsure, strict=True):
        assert doubt < 1e-6 * abs(value) or doubt < 1e-9, name
        assert actual.at(t, name, "clearance")[0] == pytest.approx(value, rel=5e-6, abs=1e-8), name


# -- how steps are taken -----------------------------------------------------------------------------------------------


def test_steps_too_coarse_for_a_derivative_are_solved_apart(monkeypatch):
    """Damping with the fourth root of the penetration: beside the surface its derivative has no bound."""
    model, how = (
        engine_model("bouncing_ball", laws={"floor": "power(K=1e6 N/m^1.5, n=1.5) x tsuji"}),
        {"duration": "0.7 s"},
    )
    expected, _ = difference(
        model, "drop_height", 1, lambda r: r["vertical.speed"][-1], step=1e-2, tolerance=1e-13, **how
    )
    run = made(model, tolerance=1e-9, **how)
    result = {}
    for name, level in (("as they are", step_chain.COARSE), ("all apart", 0.0), ("none apart", np.inf)):
        monkeypatch.setattr(step_chain, "COARSE", level)
        monkeypatch.setattr(step_chain, "LEAST", min(level, 1e-6))
        result[name] = run.sensitivities("drop_height")["vertical.speed", "drop_height"][-1]
    assert result["as they are"] == pytest.approx(result["all apart"], rel=2e-6)
    assert result["all apart"] == pytest.approx(expected, rel=2e-5)
    assert result["none apart"] != pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize("moving", [True, False])
def test_impacts_that_move_in_time_cost_no_accuracy(moving, monkeypatch):
    """Two impacts of a steep law: with changes at fixed times, as large as accelerations, half of one is lost."""
    model = engine_model("bouncing_ball", laws={"floor": "power(K=2.4e10 N/m^1.5, n=1.5) x tsuji"})
    how = {"duration": "1.5 s"}
    expected, _ = difference(
        model, "restitution", 0.9, lambda r: r["vertical.travel"][-1], step=1e-3, tolerance=1e-12, **how
    )
    if not moving:
        monkeypatch.setattr(saltation, "moves_with_events", lambda _: False)
    actual = made(model, tolerance=1e-7, **how).sensitivities("restitution")["vertical.travel", "restitution"][-1]
    assert (actual == pytest.approx(expected, rel=3e-3)) == moving


@pytest.mark.parametrize("known", [True, False])
def test_a_force_that_jumps_at_a_time_of_its_own_after_an_impact(known, monkeypatch):
    """An impact that comes later does not delay it: x = v (t - ti) - g (t - ti)^2/2 + a (t - t0)^2/2."""
    height, jump = hd.Parameter("height", "m", 0.1), hd.Parameter("jump", "m/s^2", 20)
    ball = hd.Body("ball", mass=hd.Parameter("mass", "kg", 1))
    at = hd.Parameter("at", "s", 0.2)
    scene = hd.Scene(
        hd.Mechanism("pushed", (hd.Prismatic("up", hd.GROUND, ball, axis=hd.Y),), (hd.SphereOnPlane(
            "floor", sphere=ball.at(0, 0, 0), radius=hd.Parameter("radius", "m", 0.01), plane=hd.GROUND.at(0, 0, 0), normal=hd.Y),)),
        (hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), direction=-hd.Y),
         hd.Contact("floor", power(hd.Parameter("K", "N/m^1.5", 1e9), n=1.5)),
         hd.JointForce("push", "up", ball.mass * sp.Piecewise((0, at > hd.T), (jump, True)))),
        hd.Scales(height, hd.Parameter("pace", "m/s", 1)),
        hd.Start(position={"up": height + hd.Parameter("radius", "m", 0.01)}),
    )  # fmt: skip
    model = engine_model(scene)
    assert not tangent.moves_with_events(model)
    how = {"duration": "0.25 s", "tolerance": 1e-10}
    expected, unsure = difference(model, "height", 0.1, lambda r: r["up.travel"][-1], step=1e-3, **how)
    assert unsure < 1e-5
    if not known:
        for module in (saltation, step_chain):
            monkeypatch.setattr(module, "moves_with_events", lambda _: True)
    actual = made(model, **how).sensitivities("height")["up.travel", "height"][-1]
    assert (actual == pytest.approx(expected, rel=1e-4)) == known


def test_implicit_steps_whose_stages_newton_s_method_does_not_reach_are_solved_apart(monkeypatch):
    """One iteration does not get there in contact, three do."""
    how = {"duration": "0.7 s", "tolerance": 1e-9}
    exact = made(engine_model("bouncing_ball"), **how).sensitivities("drop_height")["vertical.speed", "drop_height"][-1]
    shares = []
    for iterations in (step_chain.ITERATIONS, 1):
        monkeypatch.setattr(step_chain, "ITERATIONS", iterations)
        ball = copy.copy(engine_model("bouncing_ball"))  # built anew
        derivatives = made(ball, method="esdirk", **how).sensitivities("drop_height")
        assert derivatives["vertical.speed", "drop_height"][-1] == pytest.approx(exact, rel=2e-4)
        shares.append(np.mean(derivatives._followed.apart))
    assert shares[0] == 0 < 0.1 < shares[1]


def test_contacts_that_overlap_in_time_behind_implicit_steps():
    """Estimates of the steps in a row of balls that touch are up to a thousandfold too small: 6e-6 were they believed."""
    model, how = engine_model("newtons_cradle"), {"duration": "0.5 s"}
    exact = made(model, tolerance=1e-13, **how).sensitivities("length")["string_4.angle", "length"]
    result = made(model, method="esdirk", tolerance=1e-12, **how).sensitivities("length")["string_4.angle", "length"]
    assert result[-1] == pytest.approx(exact[-1], abs=1e-6 * np.abs(exact).max())


def test_many_derivatives_are_those_of_each_alone(crank):
    run = made(crank, duration="0.5 ms", tolerance=1e-9)
    names = [name for name in crank.parameters if crank.bind()[name]][: step_chain.WIDTH + 2]
    assert len(names) > step_chain.WIDTH
    together = run.sensitivities(*names)
    for name in (names[0], names[-1]):
        alone = run.sensitivities(name)["guide.travel", name]
        np.testing.assert_allclose(together["guide.travel", name], alone, rtol=1e-7, atol=1e-12 * np.abs(alone).max())


# -- every term matters ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("scene", "left_out"),
    [
        ("dashpot", lambda jump: replace(jump, slopes=(jump.slopes[1], jump.slopes[1]))),
        ("dashpot", lambda jump: replace(jump, booked=np.zeros_like(jump.booked))),
        ("crank", lambda jump: replace(jump, latched=np.full_like(jump.latched, saltation.UNCHANGED))),
        ("sliding", lambda jump: replace(jump, slopes=(jump.slopes[1], jump.slopes[1]))),
    ],
    ids=["field that jumps", "booked energy", "latched speed", "friction that stops"],
)
def test_a_jump_without_one_of_its_terms_is_wrong(scene, left_out, monkeypatch, crank, sliding):
    model, to, state, how = {
        "dashpot": (engine_model("bouncing_ball", laws=DASHPOT), "drop_height", "floor.dissipated", {"duration": "1 s"}),
        "crank": (crank, "clearance", "guide.travel", {"duration": "0.5 ms"}),
        "sliding": (sliding, "slide", "along_0.travel", {"duration": "1 s", "changes": {"slide": 1.0}}),
    }[scene]  # fmt: skip
    right = made(model, tolerance=1e-10, **how).sensitivities(to)[state, to]
    events = changes_along_run.events_of
    monkeypatch.setattr(changes_along_run, "events_of", lambda *of: left_out(events(*of)))
    wrong = made(model, tolerance=1e-10, **how).sensitivities(to)[state, to]
    assert abs(right[-1] - wrong[-1]) > 1e-3 * abs(right[-1])


# -- what has no derivative, and bad input -----------------------------------------------------------------------------


def test_a_run_returns_them_on_request(crank):
    how = {"duration": "1 ms", "tolerance": 1e-9, "compiled": False}
    run = simulate(crank, **how, sensitivities=("restitution", "guide.travel"))
    later = simulate(crank, **how).sensitivities("restitution", "guide.travel")
    result = run.sensitivities()["slider_pin.normal_force", "restitution"]
    np.testing.assert_array_equal(result, later["slider_pin.normal_force", "restitution"])
    assert (run.sensitivities().unit("slider_pin.normal_force", "restitution"), len(result)) == ("N", len(run.t))
    assert (
        run.sensitivities().impacts("speed", "restitution").tolist() == later.impacts("speed", "restitution").tolist()
    )
    grid = simulate(crank, **how, grid=20, sensitivities=("restitution",))
    travel = grid.sensitivities().at(grid.t, "guide.travel", "restitution")
    assert travel.shape == (20,)
    assert travel[-1] == pytest.approx(later["guide.travel", "restitution"][-1], rel=1e-9)


@pytest.mark.parametrize(
    ("how", "said"),
    [
        ({"sensitivities": ("restitutio",)}, "did you mean restitution"),
        ({"sensitivities": "restitution"}, "expected names"),
        ({"sensitivities": ("restitution",), "method": "cvodes"}, 'a run by cvodes.*method="auto"'),
    ],
)
def test_derivatives_that_cannot_be_followed_are_refused_before_the_run(crank, how, said):
    with pytest.raises(InputError, match=f"(?s){said}"):
        simulate(crank, duration="1 ms", tolerance=1e-6, **how)


def test_a_graze_ends_it_by_name(crank, monkeypatch):
    """Surfaces that touch without approaching: a run that lands so, made by taking every landing for one."""
    run = made(crank, duration="0.5 ms", tolerance=1e-9)
    monkeypatch.setattr(saltation, "LANDING", 1e12)
    derivatives = run.sensitivities("clearance")
    assert "graze" in derivatives.reason
    assert derivatives.until == run.impacts[0].t
    history = derivatives["guide.travel", "clearance"]
    assert np.isfinite(history[run.t < derivatives.until]).all()
    assert np.isnan(history[run.t >= derivatives.until]).all()


def test_events_at_one_instant_that_would_part_have_no_derivative():
    """Two balls land at once; raising one alone parts their landings, a change of gravity does not."""
    model = engine_model(pair_of_balls())
    run = made(model, duration="0.5 s", tolerance=1e-10)
    assert len({impact.t for impact in run.impacts}) == 1
    together, parted = (run.sensitivities(name) for name in ("gravity", "left.travel"))
    assert (together.reason, together.until) == ("", run.engine.t_end)
    assert (parted.reason, parted.until) == ("simultaneous events that would separate", run.impacts[0].t)


def pair_of_balls():
    mass, radius, height = (
        hd.Parameter("mass", "kg", 1), hd.Parameter("radius", "m", 0.1), hd.Parameter("height", "m", 1),
    )  # fmt: skip
    joints, pairs, contacts = [], [], []
    for name in ("left", "right"):
        ball = hd.Body(f"{name}_ball", mass=mass)
        joints.append(hd.Prismatic(name, hd.GROUND, ball, axis=hd.Y))
        pairs.append(hd.SphereOnPlane(f"{name}_floor", ball.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y))
        contacts.append(hd.Contact(f"{name}_floor", power(hd.Parameter("K", "N/m^1.5", 1e8), 1.5)))
    return hd.Scene(
        hd.Mechanism("balls", tuple(joints), tuple(pairs)),
        (hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), direction=-hd.Y), *contacts),
        hd.Scales(length=height, speed=hd.Parameter("pace", "m/s", 1)),
        hd.Start(position={"left": height, "right": height}),
    )


def test_names_and_runs_without_derivatives_are_refused(ball, tmp_path):
    run = made(ball, duration="0.1 s", tolerance=1e-9)
    with pytest.raises(InputError) as refused:
        run.sensitivities("restitutoin", "hight", "gravity")
    assert [fault.where for fault in refused.value.faults] == ["restitutoin", "hight"]
    with pytest.raises(InputError, match="names: found none"):
        run.sensitivities()
    with pytest.raises(InputError, match="stiffness"):
        run.sensitivities("gravity")["vertical.travel", "stiffness"]
    run = made(ball, duration="0.1 s", tolerance=1e-9, grid=[0.05])
    assert run.sensitivities("gravity").at(np.array([0.05]), "vertical.travel", "gravity")[0] == pytest.approx(
        -(0.05**2) / 2
    )
    saved = type(run).load(run.save(tmp_path / "run.npz"))
    with pytest.raises(InputError, match="without its steps"):
        saved.sensitivities("gravity")
    with pytest.raises(InputError, match="without its steps"):
        run.continued("0.2 s").sensitivities("gravity")


def test_a_load_by_an_input_changes_nothing_itself_and_an_infinite_derivative_ends_them():
    """A force F(t) held in pieces on a mass: x = double integral of F/m, so that dx/dm = -x/m."""
    mass = hd.Parameter("mass", "kg", 2.0)
    scene = hd.Scene(
        hd.Mechanism("pushed", (hd.Prismatic("slide", hd.GROUND, hd.Body("cart", mass), axis=hd.Y),)),
        (hd.JointForce("push", "slide", hd.Input("force", "N")),),
        hd.Scales(hd.Parameter("size", "m", 1), hd.Parameter("pace", "m/s", 1)),
    )
    samples = Samples(np.array([0.0, 0.3, 0.5, 1.0]), np.array([1.0, -2.0, 3.0, 0.0]), ("s", "N"), "held")
    run = simulate(engine_model(scene), duration="1 s", tolerance=1e-10, inputs={"force": samples})
    derivatives = run.sensitivities("mass")
    np.testing.assert_allclose(derivatives["slide.travel", "mass"], -run["slide.travel"] / 2, atol=1e-12)
    assert not derivatives["force", "mass"].any()
    # A force like the root of the travel, which stays zero.
    body, far = hd.Body("body", hd.Parameter("m", "kg", 1.0)), hd.Parameter("far", "m", 1.0)
    force = hd.Parameter("F", "N", 1.0) * sp.sqrt(hd.coordinate_of("rail") / far)
    declared = hd.Scene(
        hd.Mechanism("rooted", (hd.Prismatic("rail", hd.GROUND, body, axis=hd.Y),)),
        (hd.JointForce("root", "rail", force),),
        hd.Scales(far, hd.Parameter("pace", "m/s", 1.0)),
    )
    run = simulate(engine_model(declared), duration=1.0, tolerance=1e-9)
    derivatives = run.sensitivities("F")
    assert derivatives.reason.startswith("the equations have no finite derivatives in the step before ")
    assert derivatives.until == run.t[1]
    assert np.isnan(derivatives["rail.travel", "F"][1:]).all()


def test_a_ball_that_rests_in_space_has_derivatives():
    """Its slip is zero, where the size of a vector has no slope: K by 1 % presses it in by 2/3 %."""
    m, g, r, K = (hd.Parameter(*row) for row in (("m", "kg", 1.0), ("g", "m/s^2", 9.81), ("r", "m", 0.1), ("K", "N/m^1.5", 1e7)))  # fmt: skip
    law = smooth_coulomb(hd.Parameter("mu", "1", 0.3), hd.Parameter("v_s", "mm/s", 1.0))
    ball = hd.Body("ball", m, (2 * m * r**2 / 5,) * 3)
    floor = hd.SphereOnPlane("floor", ball.at(0, 0, 0), r, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    declared = hd.Scene(
        hd.Mechanism("resting", (hd.Free("free", hd.GROUND, ball),), (floor,)),
        (hd.Gravity("gravity", g, direction=-hd.Y), hd.Contact("floor", power(K, 1.5)), hd.Friction("rub", "floor", law)),
        hd.Scales(hd.Parameter("depth", "mm", 0.1), hd.Parameter("pace", "m/s", 1.0), arm=r),
        hd.Start(position={"free.y": r - (m * g / K) ** sp.Rational(2, 3)}),
    )  # fmt: skip
    run = simulate(engine_model(declared), duration=0.01, tolerance=1e-10)
    derivatives = run.sensitivities("K", "mu")
    assert derivatives.reason == ""
    depth = (9.81 / 1e7) ** (2 / 3)
    assert derivatives["free.y", "K"] == pytest.approx(2 / 3 * depth / 1e7, rel=1e-6)
    assert np.all(derivatives["free.x", "mu"] == 0)
