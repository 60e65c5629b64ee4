"""Pairs that are alike are found by their operations, and vectors over them have the values of each written out."""

from functools import cache

import casadi as ca
import numpy as np
import pytest

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.events.event_location import NO_EVENT, locate, search
from hertzwerk.runtime.engine.integration.loop.attempt import integrator
from hertzwerk.runtime.engine.integration.loop.c_compilation import c_text
from hertzwerk.runtime.engine.integration.loop.chunk import chunk
from hertzwerk.runtime.engine.integration.many_pairs.selection import places_of, running_sum
from hertzwerk.runtime.engine.integration.many_pairs.vectorised import alike, over_items
from hertzwerk.runtime.engine.integration.step import layout, stepper
from hertzwerk.runtime.engine.integration.step.contact_classes import BY_MODE
from hertzwerk.runtime.engine.integration.step.explicit_step import calls_parts, flow, written_flow
from hertzwerk.runtime.engine.integration.step.layout import CONTACT
from hertzwerk.runtime.engine.integration.step.many_contacts import LADDER, SPARSE, contact_forces, of_pairs
from hertzwerk.runtime.engine.integration.step.rounding_errors import STATE, bounds, gap_rounding
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model
from reference import scenes


@cache
def balls(n):
    return engine_model(scenes.balls(n))


def given(model, names, seed):
    """Random arguments: most pairs overlap, and a third are in contact."""
    random, bound = np.random.default_rng(seed), model.bind()
    q, u = (0.04 * random.standard_normal(n) for n in (model.nq, model.nu))
    mode = random.integers(0, 3, model.k).astype(float)
    values = {"t": 0.3, "q": q, "u": u, "a": random.standard_normal(model.nu), "mode": mode, "c": bound.c}
    values |= {"y": np.concatenate([q, u, np.zeros(model.nz)]), "m": random.uniform(0.5, 1, model.nm)}
    return [values[name] for name in names.split()]


def arrays(function, arguments):
    return [np.array(x).ravel() for x in function.call([*arguments])]


@pytest.mark.parametrize("name", ["gaps", "gap_accelerations"])
def test_vectors_over_pairs_have_every_bit(name):
    model = balls(6)
    function, vectors = model.function(name), of_pairs(model, name)
    assert vectors.is_a("MXFunction")
    for seed in range(20):
        arguments = given(model, "t q u a c" if "acc" in name else "t q u c", seed)
        for expected, actual in zip(arrays(function, arguments), arrays(vectors, arguments), strict=True):
            assert np.array_equal(expected, actual)


def test_bounds_of_rounding_have_every_bit():
    model = balls(6)
    arguments = given(model, "t q u c", 3)
    expected, actual = arrays(bounds(model.function("gaps"), STATE), arguments), arrays(gap_rounding(model), arguments)
    assert all(np.array_equal(a, b) for a, b in zip(expected, actual, strict=True))


@pytest.mark.parametrize("contacts", [(), BY_MODE], ids=["flight", "contact"])
def test_right_hand_side_is_that_of_pairs_written_out(contacts):
    """Sums of forces are rounded in another order; forces, gaps and their rates have every bit."""
    model = balls(6)
    assert calls_parts(model)
    called, written = flow(model, contacts), written_flow(model, contacts)
    touched = 0
    for seed in range(10):
        arguments = given(model, "t y mode m c", seed)
        assert arrays(called.rates, arguments)[0] == pytest.approx(
            arrays(written.rates, arguments)[0], rel=1e-12, abs=1e-9
        )
        actual = dict(zip(called.ends.name_out(), arrays(called.ends, arguments), strict=True))
        expected = dict(zip(written.ends.name_out(), arrays(written.ends, arguments), strict=True))
        for part in ("gap", "gap_rate", "force", "in_range"):
            assert np.array_equal(actual[part], expected[part])
        for part in ("dy", "gap_acceleration", "force_rate", "kinetic", "potential"):
            assert actual[part] == pytest.approx(expected[part], rel=1e-10, abs=1e-7)
        touched += np.count_nonzero(actual["force"])
    assert touched > 30 if contacts is BY_MODE else touched == 0


def touching(model, number, seed):
    """Arguments of contact forces with a number of pairs in contact."""
    t, y, mode, m, c = given(model, "t y mode m c", seed)
    mode[:] = np.where(mode == CONTACT, 0, mode)
    mode[np.random.default_rng(seed).choice(model.k, number, replace=False)] = CONTACT
    return t, y, mode, m, c, np.array(contact_forces(model).touching(mode)).ravel()


@pytest.mark.parametrize("number", [0, 1, 2, 4, 5, 78])
def test_pairs_in_contact_alone_have_every_bit_of_all(number):
    """On every rung that has as many places; the least of them is chosen."""
    model = balls(12)
    forces, rungs = (
        contact_forces(model),
        [rung for rung in LADDER if SPARSE * rung <= 36],
    )  # balls on balls; 9 on the floor
    for seed in range(3):
        arguments = touching(model, number, seed)
        dy = 10 * np.random.default_rng(seed).standard_normal(arguments[1].size)
        counts = np.count_nonzero(arguments[2][:66] == CONTACT), np.count_nonzero(arguments[2][66:] == CONTACT)
        fits = [counts[0] <= rung and (counts[1] <= rung or SPARSE * rung > 12) for rung in rungs]
        assert arguments[-1][0] == fits.index(True) if any(fits) else len(rungs)
        for function, given in (
            (forces.contacts, arguments), (forces.pushes, arguments), (forces.rates, (*arguments, dy)),
        ):  # fmt: skip
            every = arrays(function, [len(rungs), *given])
            for rung in np.flatnonzero(fits):
                assert all(np.array_equal(a, b) for a, b in zip(arrays(function, [rung, *given]), every, strict=True))
        assert number // 10 <= np.count_nonzero(every[0]) <= number  # of some the surfaces are apart


def test_a_rung_with_too_few_places_leaves_contacts_out():
    model = balls(12)
    arguments = touching(model, 20, 0)
    some, every = (arrays(contact_forces(model).contacts, [rung, *arguments]) for rung in (0, 2))
    assert np.count_nonzero(some[2]) < np.count_nonzero(every[2])


def test_sums_up_to_each_entry_and_places_of_ones():
    x = ca.MX.sym("x", 300)
    sums, places = ca.Function("sums", [x], [running_sum(x)]), ca.Function("places", [x], [places_of(x, 4)])
    ones = np.random.default_rng(0).integers(0, 2, 300)
    assert np.array_equal(arrays(sums, [ones])[0], np.cumsum(ones))
    assert np.array_equal(arrays(places, [ones])[0], np.flatnonzero(ones)[:4])
    assert np.array_equal(arrays(places, [np.eye(300)[7]])[0], [7, 300, 300, 300])


@pytest.mark.parametrize("number", [0, 1, 4, 5, 40])
def test_the_first_event_of_many_pairs_is_that_of_each_sought_alone(number):
    """Up to four pairs are looked for by their places, more among all."""
    random = np.random.default_rng(number)
    bernstein = np.vstack([np.ones((1, 40)), random.uniform(-2, 1, (5, 40))])
    wanted, margin, doubt = np.zeros(40), random.uniform(0, 1e-3, 40), random.uniform(0, 0.5, 40)
    wanted[random.choice(40, number, replace=False)] = 1
    each = [float(locate()(bernstein[:, j], margin[j], doubt[j])) for j in np.flatnonzero(wanted)]
    assert float(search(40)(wanted, bernstein, margin, doubt)) == min(each, default=NO_EVENT)
    assert number < 4 or min(each) < 1


@pytest.mark.parametrize("contacts", [(), BY_MODE], ids=["flight", "contact"])
def test_the_dependence_of_rates_is_found_from_kinds(contacts):
    result, written = (made(balls(6), contacts).dependence for made in (flow, written_flow))
    assert result == written
    assert flow(balls(6), contacts).quadratures == balls(6).nz


def test_operations_grow_with_kinds_not_with_pairs_and_c_by_little():
    small, large = (of_pairs(balls(n), "gaps") for n in (6, 8))  # 21 and 36 pairs
    assert small.n_instructions() == large.n_instructions()
    assert balls(8).function("gaps").n_instructions() > 1.5 * balls(6).function("gaps").n_instructions()
    # A further pair adds its places in tables and its own text in functions that are not of pairs; written out it added 36 kB.
    (table,) = (table() for table in METHODS["dop853"])
    sizes = [len(c_text([chunk(integrator(balls(n), (table,)))])) for n in (7, 9)]  # of one ladder
    assert (sizes[1] - sizes[0]) / (45 - 28) < 2000
    assert sizes[1] < 500_000


def items(*expressions):
    x = ca.SX.sym("x", 12)
    made = [ca.SX(expression(*(x[3 * i + j] for j in range(3)))) for i, expression in enumerate(expressions)]
    return x, made


def kinds(*expressions):
    x, made = items(*expressions)
    actual = alike([x], made)
    values = np.random.default_rng(1).uniform(1, 2, 12)
    symbol = ca.MX.sym("x", 12)
    results = ca.Function("found", [symbol], actual.results([symbol]))
    expected = np.array(ca.Function("expected", [x], [ca.vertcat(*made)])(values)).ravel()
    assert np.array_equal(np.array(results(values)).ravel(), expected)
    return sorted(kind.items for kind in actual.kinds)


def plain(a, b, c):
    return ca.sqrt(a) * b + 2 * c


@pytest.mark.parametrize(
    "other",
    [
        lambda a, b, c: ca.sqrt(a) * b - 2 * c, lambda a, b, c: ca.sqrt(a) * b + 3 * c, lambda a, b, c: ca.sqrt(a) * a + 2 * c,
        lambda a, b, c: ca.cos(a) * b + 2 * c,
    ],
    ids=["operation", "constant", "the same leaf twice", "function"],
)  # fmt: skip
def test_pairs_that_differ_are_of_another_kind(other):
    assert kinds(plain, plain, other, plain) == [[0, 1, 3], [2]]


def test_leaves_in_another_place_are_the_same_kind_shared_values_are_computed_once_and_functions_stay_whole():
    assert kinds(plain, plain, lambda a, b, c: plain(c, a, b), plain) == [[0, 1, 2, 3]]
    x = ca.SX.sym("x", 5)
    common = ca.exp(x[4])
    result = alike([x], [ca.SX(common * x[i]) for i in range(4)])
    assert [kind.items for kind in result.kinds] == [[0, 1, 2, 3]]
    assert result.shared.numel_out(0) == 1
    assert ca.OP_EXP not in {result.kinds[0].one.instruction_id(i) for i in range(result.kinds[0].one.n_instructions())}
    x = ca.SX.sym("x", 2)
    table = ca.interpolant("table", "linear", [[0.0, 1.0]], [0.0, 1.0])
    assert alike([x], [table(x[i]) for i in range(2)]) is None
    function = ca.Function("looked_up", [x], [ca.vertcat(table(x[0]), table(x[1]))])
    assert over_items(function) is function


@pytest.mark.parametrize("method", ["dop853", "rodas", "auto"])
def test_runs_of_many_pairs_keep_their_energy(method):
    """21 pairs, hits of balls and of the floor: the ledger, which no step controls, closes."""
    run = simulate(balls(6), duration="0.25 s", tolerance=1e-8, method=method, compiled=False)
    assert run.outcome.name == "finished"
    assert len(run.impacts) >= 5
    assert run.energy_residual < 1e-5


def test_c_of_vectors_has_the_digits_of_the_virtual_machine():
    """With contacts alone that are looked up, and all of them."""
    assert contact_forces(balls(7)).touching.numel_out(0) > 1
    runs = [simulate(balls(7), duration="0.15 s", tolerance=1e-7, compiled=compiled) for compiled in (False, True)]
    assert len(runs[0].impacts) >= 3
    assert np.array_equal(runs[0].engine.history.rows, runs[1].engine.history.rows)


@pytest.mark.parametrize("name", ["slider_crank", "tippe_top"])
def test_called_stages_give_the_run_of_inlined_ones(name, monkeypatch):
    """The same operations in the same order, but what `cse` finds over several stages."""
    inlined = simulate(engine_model(name), duration="5 ms", tolerance=1e-8, method="dop853", compiled=False)
    monkeypatch.setattr(stepper, "INLINED", 0)
    called = simulate(
        EngineModel(engine_model(name).module), duration="5 ms", tolerance=1e-8, method="dop853", compiled=False
    )
    assert called.statistics.steps == inlined.statistics.steps
    assert called.engine.history.part("y") == pytest.approx(inlined.engine.history.part("y"), rel=1e-11, abs=1e-13)


@pytest.mark.parametrize(
    ("name", "duration", "share"), [("chain_on_table", "0.1 s", 0.95), ("ball_bearing", "1 ms", 0.82)]
)
def test_events_of_several_pairs_in_vectors_change_no_bit(name, duration, share, monkeypatch):
    """share: of the C of the loop where they are written out for each pair, at most."""
    model, tables = engine_model(name), tuple(table() for table in METHODS["dop853"])
    monkeypatch.setattr(layout, "SEVERAL", model.k)
    scalars = EngineModel(model.module)
    options = {"duration": duration, "tolerance": 1e-6, "method": "dop853", "compiled": False}
    expected = simulate(scalars, **options)
    monkeypatch.undo()
    actual = simulate(EngineModel(model.module), **options)
    assert expected.statistics.events >= 3
    assert np.array_equal(expected.engine.history.rows, actual.engine.history.rows)
    less, more = (len(c_text([chunk(integrator(of.engine.model, tables))])) for of in (actual, expected))
    assert less < share * more
