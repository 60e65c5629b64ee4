"""Implicit methods: tables that refuse faults, measured orders, stiff cases in few steps, the choice between methods, SUNDIALS as reference."""

import dataclasses
import math
import signal

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from each import each
from handmade import point
from jacobians import check_jacobian, start_of

import hertzwerk.derive as hd
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.loop.attempt import integrator
from hertzwerk.runtime.engine.integration.loop.method_choice import Choosing
from hertzwerk.runtime.engine.integration.loop.plain_attempt import advance
from hertzwerk.runtime.engine.integration.step import implicit_step as implicit
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE
from hertzwerk.runtime.engine.integration.step.implicit_step import _linearised_by_calls, linearised
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.integration.step.linear_systems import solver
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import ErrorEstimate
from hertzwerk.runtime.engine.integration.tableaux.implicit_tableaux import (
    DiagonallyImplicit,
    Rosenbrock,
    esdirk54,
    rodas5p,
)
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS
from hertzwerk.runtime.engine.model.build import scene_from
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.run.built_engine import engine_for
from hertzwerk.runtime.engine.solution.error_scales import of_parameters
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.system.interrupt import defer_interrupts
from reference import closed_forms

pytestmark = pytest.mark.by_turns(5)  # methods and sizes that run the same code

IMPLICIT = ("rodas", "esdirk")
STATIC = (9.81 / 2.4e10) ** (2 / 3)  # m, penetration of the bouncing ball at rest


# ---- tables ----------------------------------------------------------------------------------------------------------


def with_entry(rows, i, j, by):
    return tuple(tuple(x + by * ((r, c) == (i, j)) for c, x in enumerate(row)) for r, row in enumerate(rows))


def refused(table, **changes):
    with pytest.raises(ValueError, match=r"found a fault in a coefficient table|not A-stable|not L-stable"):
        dataclasses.replace(table, **changes)


def test_a_fault_in_any_coefficient_of_the_rosenbrock_table_is_refused():
    table = rodas5p()
    for name in ("a", "c"):
        rows = getattr(table, name)
        for i, row in enumerate(rows):
            for j in range(len(row)):
                refused(table, **{name: with_entry(rows, i, j, 1e-9)})
    for name in ("m", "alpha", "gammas"):
        values = getattr(table, name)
        for i in range(len(values)):
            refused(table, **{name: tuple(x + 1e-9 * (k == i) for k, x in enumerate(values))})
    refused(table, gamma=table.gamma + 1e-9)
    for i in range(7):  # a multiple of the last weight alone is an estimate too
        refused(table, error=ErrorEstimate(tuple(1e-9 * (k == i) + (k == 7) for k in range(8)), 4))


def test_a_fault_in_any_coefficient_of_the_runge_kutta_table_or_an_unstable_one_is_refused():
    """The first column is changed too, so that the row sums do not give it away."""
    table = esdirk54()
    for i in range(1, len(table.A)):
        for j in range(1, i + 1):
            refused(table, A=with_entry(with_entry(table.A, i, j, 1e-9), i, 0, -1e-9))
    for i in range(1, len(table.c)):
        refused(table, c=tuple(x + 1e-9 * (k == i) for k, x in enumerate(table.c)))
    for i in range(len(table.A)):
        weights = tuple(x + 1e-9 * (k == i) for k, x in enumerate(table.error.weights))
        refused(table, error=ErrorEstimate(weights, 4))
    # From 3.12 on `sum` compensates: 0.041223397456907174, and runs by this method had other bits there.
    assert esdirk54().error.weights[0] == 0.041223397456907396
    # The trapezoidal rule is A-stable with |R| = 1 at infinity; a method of gamma = 0.2 and order 2 is not A-stable.
    trapezium = {"name": "trapezium", "order": 2, "c": (0.0, 1.0), "error": ErrorEstimate((0.5, -0.5), 1)}
    with pytest.raises(ValueError, match="not L-stable"):
        DiagonallyImplicit(A=((0.0,), (0.5, 0.5)), **trapezium)
    with pytest.raises(ValueError, match="not A-stable"):
        Rosenbrock(
            name="weak", order=2, gamma=0.2, a=((), (5.0,)), c=((), (-10.0,)), m=(7.5, 2.5), alpha=(0.0, 1.0),
            gammas=(0.2, -0.2), error=ErrorEstimate((2.5, 2.5), 1),
        )  # fmt: skip


@each("make", [rodas5p, esdirk54])
def test_more_order_than_there_is_cannot_be_claimed(make):
    table = make()
    with pytest.raises(ValueError, match="conditions of order 6"):
        dataclasses.replace(table, order=6)
    with pytest.raises(ValueError, match="error weights meet the conditions of order 5"):
        dataclasses.replace(table, error=dataclasses.replace(table.error, order=5))
    with pytest.raises(ValueError, match="all zero"):
        dataclasses.replace(table, error=ErrorEstimate((0.0,) * len(table.error.weights), 4))


# ---- the linear system -----------------------------------------------------------------------------------------------


@each(("nq", "nu", "nz"), [(1, 1, 1), (2, 2, 3), (3, 3, 0), (8, 8, 2)])
def test_the_structured_solution_is_that_of_the_whole_matrix(nq, nu, nz):
    """q' = B u, u' = anything, z fed by all and feeding nothing; beyond four speeds a chain, where elimination goes by structure."""
    rng = np.random.default_rng(nq)
    n = nq + nu + nz
    J = np.zeros((n, n))
    J[:nq, nq : nq + nu] = np.eye(nq)
    dense = rng.normal(size=(nu, nq + nu))
    near = np.abs(np.subtract.outer(np.arange(nu), np.arange(nu))) <= 1
    J[nq : nq + nu, : nq + nu] = dense if nu <= 4 else dense * np.hstack([near, near]) - 6 * np.eye(nu, nq + nu, nq)
    J[nq + nu :, : nq + nu] = rng.normal(size=(nz, nq + nu))
    r, h = rng.normal(size=n), 0.7
    entries = ca.SX.sym("J", ca.DM(J).sparsity())
    right = ca.SX.sym("r", n)
    solve = ca.Function("solve", [entries, right], [solver(entries, h, nq)(right)])
    assert np.allclose(np.array(solve(ca.DM(J), r)).ravel(), np.linalg.solve(np.eye(n) - h * J, r), rtol=1e-12)


def test_a_pivot_that_vanishes_is_exchanged():
    J = ca.SX.sym("J", 2, 2)
    r = ca.SX.sym("r", 2)
    solve = ca.Function("solve", [J, r], [solver(J, 1.0, 0)(r)])
    assert np.array(solve(ca.DM([[1.0, -2.0], [-4.0, 1.0]]), [2.0, 8.0])).ravel() == pytest.approx(
        [2.0, 1.0], rel=1e-15
    )


@pytest.mark.parametrize(("name", "moved"), [("slider_crank", 1), ("two_spheres", 0)])
def test_jacobian_against_differences(name, moved):
    model = engine_model(name)
    bound, side = model.bind(), -1 if name == "slider_crank" else 1
    (q, u), scale = start_of(model, bound), of_parameters(model, bound).state
    while float(model.function("gaps")(0, q, u, bound.c)[0]) > -0.1 * scale[moved]:
        q[moved] += side * 0.1 * scale[moved]
    y = np.concatenate([q, u + 0.1 * scale[model.nq : -model.nz], np.zeros(model.nz)])
    check_jacobian(model, y, np.ones(model.k), np.full(model.nm, 2.0), bound, steps=1e-5)


@each("depth", [0.0, -1e-12])
def test_at_the_surface_the_jacobian_is_a_number(ball, depth):
    """The derivative of d^1.5 written with a root is 0/0 at d = 0, and not a number where the bodies do not overlap."""
    for function in (linearised(ball), _linearised_by_calls(ball, BY_MODE)):
        J, dt = function(0.0, [0.1 - depth, -3.0, 0.0], [1.0], [3.0], ball.bind().c)
        assert np.array_equal(np.array(J), [[0, 1, 0], [0, 0, 0], [0, 0, 0]])
        assert np.array_equal(np.array(dt).ravel(), np.zeros(3))


# ---- orders ----------------------------------------------------------------------------------------------------------


def controls_of(model, made, bound, tolerance):
    scales = of_parameters(model, bound)
    layout = made.layouts.controls
    controls = np.zeros(layout.size)
    numbers = {"c": bound.c, "scale": scales.state, "scales": scales.scene, "tolerance": tolerance}
    for name, value in (numbers | {"t_end": 1.0, "h_max": 1.0, "floor": 1e-3}).items():
        controls[layout[name]] = value
    return controls, scales


def by_steps(model, method, start, time, count, **parameters):
    """State, in scales, after so many equal steps within one contact."""
    made = engine_for(model, method, compiled=False).integrator
    controls, scales = controls_of(model, made, model.bind(parameters), 1e-11)
    layouts = made.layouts
    state = np.array(made.begin(0.0, *start, np.zeros(len(model.latches)), controls)).ravel()
    for _ in range(count):
        trial = np.array(made.step()(state, controls, time / count)).ravel()
        for name in ("t", "y", "dy"):
            state[layouts.state[name]] = trial[layouts.trial[name]]
    return state[layouts.state["y"]] / scales.state


ORDERS = {  # order; time [s], steps, restitution: where the error is that of the leading term, and above rounding
    **dict.fromkeys(("dopri5", *IMPLICIT), (5, 6e-05, 16, 0.7)),
    "dop853": (8, 1e-4, 5, 1.0),
}


@pytest.mark.parametrize("method", ORDERS)
def test_order_on_a_smooth_contact_phase(ball, method):
    """80 um deep in contact, closing at 3 m/s (nearer to the surface d^1.5 is less smooth than order 8 needs)."""
    order, time, steps, e = ORDERS[method]
    start = ([0.1 - 8e-5], [-3.0])
    exact = by_steps(ball, "dop853", start, time, 60, restitution=e)
    errors = [np.max(np.abs(by_steps(ball, method, start, time, n, restitution=e) - exact)) for n in (steps, 2 * steps)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.3)


@pytest.mark.parametrize("method", IMPLICIT)
def test_order_where_the_time_occurs_itself(crank, method):
    """The driven slider-crank, in contact with friction of a wide layer: the term df/dt counts."""
    start = ([0.0, 0.17 - 5.4e-4], [-741.7649320975901, -3.0])
    wide = {"friction_speed": "1 m/s"}
    exact = by_steps(crank, "dop853", start, 1e-5, 100, **wide)
    errors = [np.max(np.abs(by_steps(crank, method, start, 1e-5, n, **wide) - exact)) for n in (6, 12)]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(5, abs=0.3)


@pytest.mark.parametrize("method", [*IMPLICIT, "auto"])
def test_compiled_is_bitwise_the_virtual_machine(ball, method, tmp_path, monkeypatch):
    """From bounces to rest: with both kinds of steps where the method has them."""
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path))
    options = {"duration": "2 s", "tolerance": 1e-6, "method": method, "parameters": {"restitution": 0.5}}
    machine, native = (simulate(ball, compiled=compiled, **options) for compiled in (False, True))
    assert np.array_equal(machine.engine.history.rows, native.engine.history.rows)
    if method == "auto":
        assert {choice.method for choice in machine.engine.choices} == {"explicit", "implicit"}


@pytest.mark.parametrize("method", IMPLICIT)
def test_dense_output_has_the_method_s_accuracy(ball, method):
    run = simulate(ball, duration="1 s", tolerance=1e-9, method=method, parameters={"restitution": 1.0})
    times = np.linspace(0, 0.45, 50)
    assert np.allclose(run.at(times)["vertical.travel"], 1.1 - 9.81 * times**2 / 2, rtol=0, atol=1e-13)
    middle = run.impacts[0].t + np.linspace(0, 1, 100) * run.impacts[0].duration
    energy = run.at(middle)["energy"]
    assert np.max(np.abs(energy - energy[0])) < 1e-7 * 9.81


# ---- stiff -----------------------------------------------------------------------------------------------------------


def settled(run, most):
    assert run.outcome.finished
    assert run.statistics.steps < most
    assert run.energy_residual < 1e-3  # of the energy that settling moves, which is little
    assert 0.1 - run.engine.final["vertical.travel"] == pytest.approx(STATIC, rel=1e-8)
    assert abs(run.engine.final["vertical.speed"]) < 1e-10
    return run


@pytest.mark.parametrize("method", [*IMPLICIT, "auto"])
@pytest.mark.parametrize("tolerance", [1e-5, 1e-8])
def test_settling_at_restitution_one_hundredth(ball, method, tolerance):
    """At least ten times fewer steps than explicit at 1e-5 (measured: 80 times over 1 s); and as many over 10 s."""
    options = {"tolerance": tolerance, "parameters": {"restitution": 0.01}}
    run = settled(simulate(ball, duration="1 s", method=method, **options), 300)
    if tolerance == 1e-5:
        explicit = simulate(ball, duration="1 s", method="dop853", **options)
        assert explicit.statistics.steps > 10 * run.statistics.steps
        assert explicit.statistics.rhs_evaluations > 10 * run.statistics.rhs_evaluations
    longer = settled(simulate(ball, duration="10 s", method=method, **options), 300)
    assert longer.statistics.steps < run.statistics.steps + 30


@pytest.mark.parametrize("method", [*IMPLICIT, "auto"])
@pytest.mark.parametrize("depth", [1.0, 1.2, 0.5])
def test_at_rest_under_the_damping_of_a_minute_approach_speed(ball, method, depth):
    """v0 = 1e-5 m/s makes the damping 1e6 times that of the impact: an explicit method needs 350,000 steps for this second."""
    run = simulate(
        ball, duration="1 s", tolerance=1e-6, method=method, parameters={"restitution": 0.5, "approach_floor": "1e-5 m/s"},
        initial={"vertical.travel": f"{0.1 - depth * STATIC!r} m", "vertical.speed": "0 m/s"},
    )  # fmt: skip
    settled(run, 100)


def pushed_ball():
    """A ball dropped by 10 um under a force that changes within the contact, of the size of the contact's."""
    scene = scene_from("bouncing_ball")
    push, pulse = hd.Parameter("push", "N", 4000), hd.Parameter("pulse", "rad/s", 5e3)
    effects = (*scene.effects, hd.JointForce("push", "vertical", -push * sp.sin(pulse * hd.T)))
    return dataclasses.replace(scene, effects=effects)


@pytest.mark.parametrize(
    ("made", "method"), [(lambda: "slider_crank", "rodas"), (lambda: "slider_crank", "esdirk"), (pushed_ball, "rodas")]
)
def test_steps_made_of_calls_are_those_written_out(made, method, monkeypatch):
    """Large models' steps call what those of others have written out: the same but for the order of a few sums."""
    options = {"duration": "3 ms", "tolerance": 1e-8, "method": method, "compiled": False}
    options |= {"parameters": {"drop_height": "10 um"}} if made is pushed_ball else {}
    written = simulate(engine_model(made()), **options)
    monkeypatch.setattr(implicit, "LARGE", 0)
    called = simulate(engine_model(made()), **options)
    assert called.statistics.events == written.statistics.events > 0
    assert called.statistics.steps == pytest.approx(written.statistics.steps, abs=2)
    joint = "vertical" if made is pushed_ball else "guide"
    for name in (f"{joint}.travel", f"{joint}.speed"):
        assert called.engine.final[name] == pytest.approx(written.engine.final[name], rel=1e-7)


@pytest.fixture(scope="module")
def swung():
    """Two arms that swing about different axes, by the positions and rotations of their bodies: ten constraints."""
    mass, inertia, reach, lift, pace = (
        hd.Parameter(*row)
        for row in (
            ("mass", "kg", 1.0), ("inertia", "kg m^2", 0.02), ("reach", "m", 0.5), ("lift", "rad", 0.4), ("pace", "rad/s", 3.0),
        )
    )  # fmt: skip
    upper, lower = (hd.Body(name, mass, (inertia, 2 * inertia, inertia), centre=(0, -reach, 0)) for name in "ab")
    joints = (hd.Revolute("hip", hd.GROUND, upper, hd.Z), hd.Revolute("knee", upper.at(0, -reach, 0), lower, hd.X))
    start = hd.Start(position={"hip": lift, "knee": lift}, speed={"hip": pace, "knee": pace})
    scales = hd.Scales(reach, hd.Parameter("typical_speed", "m/s", 1.0), reach)
    effects = (hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), -hd.Y), hd.EnergyLedger())
    return engine_model(hd.Scene(hd.Mechanism("swung", joints), effects, scales, start).with_coordinates("absolute"))


def test_derivatives_of_a_constrained_motion_are_those_of_how_it_is_solved_for(swung):
    """Of the equations that accelerations solve it takes a fraction of the operations."""
    run = simulate(swung, duration="0.3 s", tolerance=1e-10, method="dop853")
    y, c = run.engine.history.part("y")[-1], run.engine.history.controls[: swung.nc]
    q, u = y[: swung.nq], y[swung.nq : swung.nq + swung.nu]
    f = np.array(swung.function("applied")(0, q, u, c)).ravel() + np.linspace(-1, 1, swung.nu)
    found = implicit._motion_derivatives(swung)
    t, *symbols = (ca.SX.sym(name, found.numel_in(i)) for i, name in enumerate("tyfc"))
    q, u, _ = ca.vertsplit(symbols[0], [0, swung.nq, swung.nq + swung.nu, y.size])
    a, _, multipliers = swung.function("accelerations").call([t, q, u, *symbols[1:]])
    straight = [ca.jacobian(a, ca.vertcat(symbols[0], t)), ca.jacobian(a, symbols[1])]
    solving = ca.Function("solving", [t, *symbols], [*straight, a, multipliers])
    direct, mobility, a, multipliers = solving(0, y, f, c)
    rows = slice(swung.nq, swung.nq + swung.nu)
    for one, two in zip(found(0, y, f, c), (direct, mobility), strict=True):
        one, two = np.array(one)[rows], np.array(two)
        assert np.abs(one - two).max() < 1e-9 * np.abs(two).max() > 0
    assert found.n_instructions() < 0.6 * solving.n_instructions()
    needed, second = swung.function("balance")(0, y[: swung.nq], y[rows], a, multipliers, c)
    assert np.abs(np.array(needed).ravel() - f).max() < 1e-9 > np.abs(np.array(second)).max()


@pytest.mark.parametrize("method", IMPLICIT)
def test_a_constrained_motion_is_the_same_by_calls(swung, method, monkeypatch):
    options = {"duration": "0.3 s", "tolerance": 1e-8, "method": method, "compiled": False}
    written = simulate(swung, **options)
    monkeypatch.setattr(implicit, "LARGE", 0)
    called = simulate(EngineModel(swung.module, swung.declaration), **options)
    assert called.statistics.steps == pytest.approx(written.statistics.steps, abs=2)
    ends = [run.engine.history.part("y")[-1, : swung.nq] for run in (called, written)]
    assert ends[0] == pytest.approx(ends[1], abs=1e-7)


# ---- the choice ------------------------------------------------------------------------------------------------------


def test_building_what_chooses_is_interrupted(crank):
    """A signal that waits is heeded between the classes of attempts, and what was being built can be built afterwards."""
    made = integrator(crank, tuple(table() for table in METHODS["auto"]))
    with pytest.raises(KeyboardInterrupt, match="waited"), defer_interrupts():
        signal.raise_signal(signal.SIGINT)
        try:
            made.with_choice()
        except KeyboardInterrupt:
            raise KeyboardInterrupt("waited") from None
    assert made.with_choice() is made.with_choice()


def test_auto_stays_explicit_on_impacts(crank):
    """Where nothing is stiff the run is that of the explicit method, step by step."""
    auto, explicit = (
        simulate(engine_model("slider_crank_frictionless"), duration="6 ms", tolerance=1e-7, method=method)
        for method in ("auto", "dop853")
    )
    assert [choice.method for choice in auto.engine.choices] == ["explicit"]
    assert np.array_equal(auto.engine.history.part("y"), explicit.engine.history.part("y"))


def test_looking_for_stiffness_costs_nothing_in_free_flight_and_little_in_contact(ball):
    """By instructions: where no acceleration depends on the state there is nothing to look for."""
    table, vectors = METHODS["dop853"][0](), layouts(ball)
    flight, contact = (
        [advance(ball, vectors, table, contacts, c).n_instructions() for c in (Choosing.NONE, Choosing.ON_SUSPICION)]
        for contacts in ((), (0,))
    )
    assert flight[1] - flight[0] <= 4
    assert 10 < contact[1] - contact[0] < 0.05 * contact[0]
    crank = engine_model("slider_crank_two_clearances")  # whose slider no acceleration of a flight depends on
    none, looking = (
        advance(crank, layouts(crank), table, (), c).n_instructions() for c in (Choosing.NONE, Choosing.ON_SUSPICION)
    )
    assert 10 < looking - none < 0.05 * none


def test_auto_changes_when_the_ball_settles_and_says_why(ball):
    run = simulate(ball, duration="2 s", tolerance=1e-6, method="auto", parameters={"restitution": 0.5})
    first, second, *_ = run.engine.choices
    assert (first.method, first.t) == ("explicit", 0)
    assert second.method == "implicit"
    assert second.t > run.impacts[4].t  # not for the bounces
    assert "stability" in second.reason
    alone = [
        simulate(ball, duration="2 s", tolerance=1e-6, method=m, parameters={"restitution": 0.5})
        for m in ("dop853", "esdirk")
    ]
    assert all(run.statistics.steps < other.statistics.steps for other in alone)


@pytest.mark.slow
def test_auto_leaves_implicit_steps_that_save_fewer_explicit_ones_than_they_cost():
    """Corners that rub, at 1e-9: an implicit step costs 3.3 explicit ones. It goes on bitwise from between two changes, by explicit steps alone."""
    model = engine_model("translational_clearance")
    auto, explicit = (simulate(model, duration="42 ms", tolerance=1e-9, method=m) for m in ("auto", "dop853"))
    implicit = int(np.sum(auto.engine.history.part("method")[1:]))
    assert implicit > 100
    assert auto.statistics.steps - implicit + 3.3 * implicit < 1.15 * explicit.statistics.steps
    assert {choice.method for choice in auto.engine.choices[2:]} == {"explicit", "implicit"}
    back, again = (choice.t for choice in auto.engine.choices[2:4])
    part = simulate(model, duration=(back + again) / 2, tolerance=1e-9, method="auto")
    rest = part.continued("42 ms")
    assert np.array_equal(rest.engine.history.rows, auto.engine.history.rows[auto.t >= rest.t[0]])


# ---- SUNDIALS --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["cvodes", pytest.param("idas", marks=pytest.mark.exhaustive)])
def test_sundials_between_two_walls(method):
    model, options = engine_model("ball_between_walls"), {"duration": "0.5 s", "parameters": {"restitution": 0.9}}
    run = simulate(model, tolerance=1e-11, method=method, **options)
    h = closed_forms.factor("hunt_crossley", "0.9")
    bounces = closed_forms.ball_between_walls("1e6", 1, "1.6", 10, h, 10, "0.4", "0.8")
    assert run.outcome.finished
    assert len(run.impacts) == sum(bounce.onset < 0.5 for bounce in bounces)
    for impact, bounce in zip(run.impacts, bounces, strict=False):
        assert impact.t == pytest.approx(bounce.onset, rel=1e-7)
        assert impact.speed == pytest.approx(bounce.approach, rel=1e-7)
        assert impact.peak_penetration == pytest.approx(bounce.depth, rel=1e-6)
    assert run.energy_residual < 1e-6


def test_sundials_ends_and_refuses_like_the_engine(ball):
    assert (
        simulate(ball, duration="1 s", method="cvodes", max_steps=30, tolerance=1e-6).outcome.name == "too_many_steps"
    )
    assert simulate(ball, duration="5 s", method="cvodes", max_events=2, tolerance=1e-6).outcome.name == "event_limit"
    model = point(
        lambda d, v, v0: 1e3 * d, push=lambda t, x, v: -10.0 + 0 * t, in_range=lambda d: d < 0.05, scales=(1e-2, 1, 100, 1),
    )  # fmt: skip
    assert simulate(model, duration=1.0, method="cvodes", tolerance=1e-6).outcome.name == "outside_law_range"

    def stop(fraction):
        raise KeyboardInterrupt

    assert simulate(ball, duration="1 s", method="cvodes", progress=stop, tolerance=1e-6).outcome.name == "interrupted"
