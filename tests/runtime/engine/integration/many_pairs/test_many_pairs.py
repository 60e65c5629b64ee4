"""Many contact pairs: a step evaluates the pairs in contact and no others, and a row of spheres does what the laws of impact say."""

from functools import cache
from types import ModuleType

import casadi as ca
import numpy as np
import pytest
from handmade import point

from hertzwerk.derive.scenes.ball_bearing import bearing
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.events import event_location
from hertzwerk.runtime.engine.integration.loop.attempt import integrator
from hertzwerk.runtime.engine.integration.loop.plain_attempt import advance, no_event_of_any_pair
from hertzwerk.runtime.engine.integration.step import contact_classes as classes
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE, contact_classes
from hertzwerk.runtime.engine.integration.step.explicit_step import calls_parts, flow, written_flow
from hertzwerk.runtime.engine.integration.step.implicit_step import DIVERGED
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.integration.tableaux.implicit_tableaux import esdirk54, rodas5p
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model
from reference import closed_forms, scenes

pytestmark = pytest.mark.by_turns(5)  # methods and sizes that run the same code

APART, CLOSE = "1 mm", "0.1 um"  # gaps between neighbours; an impact is about 10 um deep


@cache
def row(n):
    return engine_model(scenes.row(n))


def hit(model, gap, **options):
    """The row, its first sphere coming in."""
    return simulate(model, duration="5 ms", parameters={"gap": gap}, **options)


def part(run, name):
    return run.engine.history.part(name)


@pytest.mark.parametrize(("method", "gap"), [("dop853", APART), ("dop853", CLOSE), ("rodas", CLOSE), ("auto", CLOSE)])
def test_a_class_for_each_pair_changes_no_number(monkeypatch, method, gap):
    """Steps that evaluate one pair alone, against the same steps with every pair evaluated and masked.

    Explicit steps are bitwise the same; implicit ones eliminate fewer unknowns, which rounds otherwise.
    """
    options = {"tolerance": 1e-7, "method": method, "compiled": False}
    own = hit(row(4), gap, **options)
    monkeypatch.setattr(classes, "ALONE", 0)
    masked = hit(EngineModel(row(4).module), gap, **options)
    first, second, third, several = 2.0, 3.0, 4.0, 5.0
    assert ({first, several} if gap == CLOSE else {first, second, third}) <= set(part(own, "class")[:, 0])
    assert set(part(masked, "class")[:, 0]) == {0.0, 1.0, 2.0}
    if method == "dop853":
        names = own.engine.history.integrator.layouts.state.sizes
        assert [name for name in names if not np.array_equal(part(own, name), part(masked, name))] == ["class"]
    assert part(own, "y") == pytest.approx(part(masked, "y"), rel=1e-10, abs=1e-13)


def test_a_pair_out_of_contact_costs_no_operation_of_a_stage():
    """Guards that nothing reaches: a stage in contact does what it does without them, and sets the rates of their ledgers to zero."""
    bare, guarded = (engine_model(scenes.guarded_crank(guards)) for guards in (0, 3))
    operations = [flow(model, (0,)).rates.n_instructions() for model in (bare, guarded)]
    assert operations[1] - operations[0] == guarded.nz - bare.nz == 3


def test_reactions_of_a_drive_beside_many_contacts_are_those_of_pairs_written_out():
    """They depend on the forces of the pairs that touch: with 24 pairs the bearing's loop was not built, nor with 48 that of its flight."""
    model = engine_model(bearing(12, "bearing_12"))
    assert calls_parts(model)
    random = np.random.default_rng(36)
    y = random.uniform(-1e-3, 1e-3, model.nq + model.nu + model.nz)
    for contacts, touching in ((BY_MODE, 1.0), ((), 0.0)):
        at = 0.0, y, touching * (np.arange(model.k) % 2), np.ones(model.nm), model.bind().c
        here, there = (np.array(made(model, contacts).holding(*at)[1]).ravel() for made in (flow, written_flow))
        assert here.size == 1
        assert here == pytest.approx(there, rel=1e-12)


def every_pair(model, contacts):
    """In place of `pairs_by_polynomial`: all of them, in every step."""
    return list(range(model.k))


def operations(function):
    ids = [function.instruction_id(i) for i in range(function.n_instructions())]
    return sum(number not in (ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST) for number in ids)


def test_a_pair_far_from_contact_costs_no_event_polynomial(monkeypatch):
    """A guard more adds to a step what it takes to see that it is far, less than a polynomial; that is left to a function called where it is not."""
    models = [engine_model(scenes.guarded_crank(guards)) for guards in (1, 3)]
    (table,) = (table() for table in METHODS["dop853"])

    def each(make):
        return (operations(make(models[1])) - operations(make(models[0]))) / 2

    for contacts in ((), (0,)):
        lean = each(lambda model, c=contacts: advance(model, layouts(model), table, c))
        with monkeypatch.context() as patched:
            patched.setattr("hertzwerk.runtime.engine.integration.loop.plain_attempt.pairs_by_polynomial", every_pair)
            requested = each(lambda model, c=contacts: advance(model, layouts(model), table, c))
        assert lean < requested - 20
        # half is for the time of the next landing, a fifth for gaps that come and go within the step
        assert lean < 90
    assert each(lambda model: no_event_of_any_pair(model, layouts(model))) > 40  # called where a pair may be near


def test_far_means_clear():
    """At random gaps, rates and accelerations: no pair that is far may have an event, or doubt of one; and many are neither far nor clear."""
    model = engine_model(scenes.guarded_crank(3))
    vectors = layouts(model)
    parts = (vectors.state, vectors.controls, vectors.state)
    given = [part.symbol(name) for part, name in zip(parts, ("state", "controls", "next"), strict=True)]
    old, run, end = (part.split(x) for part, x in zip(parts, given, strict=True))
    pairs, flying = [0, 1, 2, 3], ca.SX.zeros(model.k)
    judged = [
        event_location.far_apart(model, run, old, end, pairs),
        event_location.no_event_possible(model, run, flying, old, end, pairs),
    ]
    judge = ca.Function("judge", given, judged)
    random, seen = np.random.default_rng(5), np.zeros((2, 2))
    controls = np.zeros(vectors.controls.size)
    for name, value in {"scale": 1.0, "scales": 1.0, "tolerance": 1e-6}.items():
        controls[vectors.controls[name]] = value
    for _ in range(2000):
        states = random.standard_normal((2, vectors.state.size))
        states[:, vectors.state["h"]] = 10 ** random.uniform(-2, 1)
        states[:, vectors.state["gap"]] = np.abs(states[:, vectors.state["gap"]])
        states[:, vectors.state["force"]] = 0.0
        is_far, is_clear = (np.array(x).ravel() for x in judge(states[0], controls, states[1]))
        for i, j in zip(is_far, is_clear, strict=True):
            seen[int(i), int(j)] += 1
    assert seen[1, 0] == 0
    assert min(seen[1, 1], seen[0, 1], seen[0, 0]) > 400


@pytest.mark.parametrize("gap", [APART, CLOSE])
def test_pairs_that_are_not_evaluated_change_no_bit(monkeypatch, gap):
    options = {"tolerance": 1e-7, "compiled": False}
    lean = hit(row(4), gap, **options)
    monkeypatch.setattr("hertzwerk.runtime.engine.integration.loop.plain_attempt.pairs_by_polynomial", every_pair)
    requested = hit(EngineModel(row(4).module), gap, **options)
    assert np.array_equal(lean.engine.history.rows, requested.engine.history.rows)


MARKS = (ca.OP_ERF, ca.OP_ASINH, ca.OP_ATANH)  # which nothing else uses


@pytest.mark.parametrize("method", ["dop853", "rodas"])
def test_free_flight_evaluates_no_contact_and_one_contact_no_other(method):
    """Every result of each pair's contact goes through an operation of its own: those of the pairs that touch are in the step, and no others."""
    functions = {ca.OP_ERF: ca.erf, ca.OP_ASINH: ca.asinh, ca.OP_ATANH: ca.atanh}
    module = ModuleType("marked")
    module.__dict__.update(engine_model("slider_crank_three_clearances").module.__dict__)
    names = [name for name, _ in module.PAIRS]

    def marked(contact, mark):
        return lambda *given: tuple(functions[mark](ca.SX(result)) for result in contact(*given))

    for name, mark in zip(names, MARKS, strict=True):
        setattr(module, f"contact_{name}", marked(getattr(module, f"contact_{name}"), mark))
    model = EngineModel(module)
    (table,) = (table() for table in METHODS[method])
    for contacts in contact_classes(model):
        step = advance(model, layouts(model), table, contacts)
        actual = {f.instruction_id(i) for f in (step, *step.find_functions()) for i in range(f.n_instructions())}
        assert actual & set(MARKS) == {MARKS[j] for j in (range(model.k) if contacts is BY_MODE else contacts)}


@pytest.mark.parametrize("method", [pytest.param("dop853", marks=pytest.mark.exhaustive), "auto"])
def test_the_same_digits_compiled(method):
    machine, native = (hit(row(4), CLOSE, tolerance=1e-8, method=method, compiled=c) for c in (False, True))
    assert np.array_equal(machine.engine.history.rows, native.engine.history.rows)


def linear(B):
    """Points on a line each, u' = B u, without contact."""
    n = len(B)
    model = point()
    names = [f"path_{i}" for i in range(n)]
    model.module.__dict__.update(
        PARAMETERS=(("speed", "m/s", 1.0, "of each"),), COORDINATES=tuple((f"{name}.travel", "m") for name in names),
        SPEEDS=tuple((f"{name}.speed", "m/s") for name in names), start=lambda p: (ca.SX.zeros(n), p[0] * ca.SX(range(1, n + 1))),
        scales=lambda p: (ca.SX.ones(n), ca.SX.ones(n), ca.SX(0, 1), ca.SX.ones(4)), applied=lambda t, q, u, c: ca.mtimes(ca.DM(B), u),
    )  # fmt: skip
    return EngineModel(model.module)


@pytest.mark.parametrize("table", [rodas5p(), esdirk54()], ids=lambda table: table.name)
@pytest.mark.parametrize(("pivot", "refused"), [(0.3, False), (1e-3, False), (1e-12, True), (0.0, True)])
def test_a_step_whose_equations_were_not_solved_is_refused(table, pivot, refused):
    """I - h gamma J = pivot I + N with N skew: all is well but for elimination on the diagonal, where rows are not exchanged.

    Without the check a Rosenbrock step goes on from speeds that are wrong in the first digit.
    """
    n, h = 6, 1e-3
    random = np.random.default_rng(1).standard_normal((n, n))
    N = random - random.T
    assert np.linalg.cond(N) < 10
    engine = integrator(linear(((1 - pivot) * np.eye(n) - N) / (h * table.gamma)), (table,))
    q, u = engine.model.function("start")(1.0)
    controls, layout = np.zeros(engine.layouts.controls.size), engine.layouts.controls
    for name, value in {"scale": 1e9, "scales": 1.0, "tolerance": 1e-3, "t_end": 1.0, "h_max": 1.0}.items():
        controls[layout[name]] = value
    trial = np.array(
        engine.step()(engine.begin(0, q, u, np.zeros(len(engine.model.latches)), controls), controls, h)
    ).ravel()
    (error,) = trial[engine.layouts.trial["error"]]
    assert (error < DIVERGED) != refused


def passed_on(n, method, restitution, tolerance=1e-8, **options):
    """The run of a row with gaps until the last sphere has left."""
    duration = 2e-3 / 0.5 * n if restitution < 1 else 1.2e-3 * n
    options = {"duration": duration, "parameters": {"restitution": restitution}, "compiled": False, **options}
    return simulate(row(n), method=method, tolerance=tolerance, **options)


def momentum_error(run, n):
    """Largest change of the total momentum over a run, relative to the start's."""
    return np.max(np.abs(sum(run[f"path_{i}.speed"] for i in range(n)) - 1))


@pytest.mark.parametrize(
    ("n", "method"),
    [(5, "dop853"), (5, "dopri5"), (5, "rodas"), (5, "esdirk"), (5, "auto"), (20, "dop853"), (20, "esdirk")],
)
def test_an_elastic_row_hands_the_speed_to_its_last_sphere(n, method):
    """Gaps between the spheres: n - 1 impacts of two equal spheres one after another, each of which exchanges the speeds."""
    run = passed_on(n, method, 1.0)
    assert run.outcome.finished
    assert [impact.contact for impact in run.impacts] == [f"pair_{i}" for i in range(n - 1)]
    assert [run.engine.final[f"path_{i}.speed"] for i in range(n)] == pytest.approx([*(n - 1) * [0], 1], abs=1e-7 * n)
    assert momentum_error(run, n) < 1e-14 * n
    assert run.energy_residual < 2e-7 * n


@pytest.mark.parametrize(("n", "method"), [(5, "dop853"), (5, "esdirk"), (20, "dop853")])
def test_a_damped_row_follows_the_products_of_two_body_impacts(n, method):
    """Each impact leaves (1 - e)/2 of the speed and hands on (1 + e)/2, with e what the law returns in a free impact."""
    run = passed_on(n, method, 0.9)
    stiffness = 4 / 3 * 207e9 / (2 * (1 - 0.3**2)) * 0.01**0.5
    e = float(closed_forms.collision(str(stiffness), 1.5, "0.05", 1, closed_forms.factor("flores", "0.9")).restitution)
    speeds = [((1 + e) / 2) ** i for i in range(n)]
    expected = [*((1 - e) / 2 * v for v in speeds[:-1]), speeds[-1]]
    assert [impact.speed for impact in run.impacts] == pytest.approx(speeds[:-1], rel=2e-7)
    assert [run.engine.final[f"path_{i}.speed"] for i in range(n)] == pytest.approx(expected, abs=2e-7)
    assert momentum_error(run, n) < 1e-14 * n
    assert run.energy_residual < 5e-7
