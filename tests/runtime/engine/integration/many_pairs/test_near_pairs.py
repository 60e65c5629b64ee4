"""Lists of near pairs: runs with one against runs that evaluate every pair in every step."""

import numpy as np
import pytest

from hertzwerk.derive import InputError
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.loop import near_list
from hertzwerk.runtime.engine.integration.many_pairs import near_pairs
from hertzwerk.runtime.engine.integration.many_pairs.near_pairs import near_model
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model
from reference import scenes

N = 8
OPTIONS = {"duration": "0.1 s", "tolerance": 1e-7, "method": "dop853", "compiled": False}


@pytest.fixture(scope="module")
def box():
    """Eight spheres in a box, 68 pairs; too few for a list unless it is asked for."""
    return engine_model(scenes.spheres_in_box(N))


@pytest.fixture(scope="module")
def listed(box):
    """The same with a list of a fifth of the spheres' pairs."""
    model = EngineModel(box.module, box.declaration)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(near_pairs, "WORTH", 0.0)
        patched.setattr(near_pairs, "PLACES", 1)
        assert near_model(model) is not None
    return model


def fast(seed):
    """Random speeds of all spheres, several m/s, so that they meet one another and all walls."""
    random = np.random.default_rng(seed)
    return {f"flight_{i}.{x}_speed": f"{random.normal() * 3!r} m/s" for i in range(1, N + 1) for x in "xyz"}


def begun(run):
    return [(impact.contact, impact.t) for impact in run.impacts]


@pytest.fixture(scope="module")
def every_pair_evaluated(box):
    return simulate(box, initial=fast(1), **OPTIONS)


def test_no_impact_of_fast_spheres_is_missed_and_dissipation_stays_booked_after_a_pair_leaves_the_list(
    listed, every_pair_evaluated, monkeypatch
):
    made, renewed = [], near_list.renewed
    monkeypatch.setattr(
        "hertzwerk.runtime.engine.integration.loop.chunk.renewed", lambda *given: made.append(0) or renewed(*given)
    )
    run, every = simulate(listed, initial=fast(1), **OPTIONS), every_pair_evaluated
    assert run.outcome.name == "finished" and len(made) > 10
    assert len({pair for pair, _ in begun(every)}) > 20
    assert [pair for pair, _ in begun(run)] == [pair for pair, _ in begun(every)]
    assert [t for _, t in begun(run)] == pytest.approx([t for _, t in begun(every)], abs=1e-9)
    for name in every:
        actual, expected = run.at([0.08])[name], every.at([0.08])[name]
        assert actual == pytest.approx(expected, abs=1e-6 * np.max(np.abs(every[name])) + 1e-9), name
    assert len(run.engine.history.departures) > 3
    names = [name for name in every if name.endswith(".dissipated")]
    ends = [[float(of[name][-1]) for name in names] for of in (run, every)]
    assert ends[0] == pytest.approx(ends[1], rel=1e-6, abs=1e-12)
    dense = run.engine.history.part("y")[-1][-len(names) :]
    assert dense.tolist() == ends[0]


@pytest.mark.parametrize("factor", [10, 1e9])
def test_a_list_that_is_kept_too_long_misses_impacts(listed, every_pair_evaluated, monkeypatch, factor):
    made = near_list._list
    monkeypatch.setattr(near_list, "_list", lambda *given: [*made(*given)[:2], factor * made(*given)[2]])
    run = simulate(listed, initial=fast(1), **OPTIONS)
    assert begun(run) != begun(every_pair_evaluated)


def test_a_state_grows_with_bodies_not_with_pairs(monkeypatch):
    monkeypatch.setattr(near_pairs, "WORTH", 0.0)
    monkeypatch.setattr(near_pairs, "PLACES", 1)
    small, large = (near_model(engine_model(scenes.balls(n))) for n in (6, 9))
    assert layouts(large).state.size < 1.7 * layouts(small).state.size
    assert large.whole.k > 2.1 * small.whole.k


def test_few_pairs_have_no_list_and_a_pair_without_a_bound_by_centres_is_always_listed(box, monkeypatch):
    assert near_model(box) is None
    # Landmarks that are off their body's origin, or a plane that moves.
    rows = [
        ("floor_2", kind, role, "ball_1" if role == "plane" else body, more)
        if pair == "floor_2"
        else (pair, kind, role, body, more)
        for pair, kind, role, body, more in box.module.LANDMARKS
    ]
    bounded = near_pairs._bodies(box)
    assert None not in bounded
    monkeypatch.setattr(box.module, "LANDMARKS", tuple(rows))
    assert [pair for pair, of in zip(box.pairs, near_pairs._bodies(box), strict=True) if of is None] == ["floor_2"]
    landmarks = box.module.landmarks

    def moved(p):
        found = list(landmarks(p))
        found[0] = found[0] + 1e-3
        return found

    monkeypatch.setattr(box.module, "landmarks", moved)
    assert len([of for of in near_pairs._bodies(box) if of is None]) == 2


def test_sensitivities_and_continuation_say_what_a_list_does_not_have(listed):
    with pytest.raises(InputError, match="lists the near ones"):
        simulate(listed, sensitivities=["radius"], **OPTIONS)
    run = simulate(listed, **{**OPTIONS, "duration": "1 ms"})
    assert run.engine.checkpoint is None


def test_pairs_that_latch_nothing_are_listed(monkeypatch):
    """Damping by the stiffness alone needs no speed of approach: the run with a list did not start."""
    monkeypatch.setattr(near_pairs, "WORTH", 0.0)
    monkeypatch.setattr(near_pairs, "PLACES", 1)
    listed = engine_model(scenes.falling_balls(12))
    assert near_model(listed) is not None and not listed.latches
    run = simulate(listed, duration="0.2 s", tolerance=1e-7, method="dopri5", compiled=False)
    monkeypatch.setattr(near_pairs, "WORTH", np.inf)
    every = simulate(
        engine_model(scenes.falling_balls(12)), duration="0.2 s", tolerance=1e-7, method="dopri5", compiled=False
    )
    assert len(begun(every)) >= 5 and [pair for pair, _ in begun(run)] == [pair for pair, _ in begun(every)]
    assert [t for _, t in begun(run)] == pytest.approx([t for _, t in begun(every)], abs=1e-9)
    assert run["flight_3.z"][-1] == pytest.approx(every["flight_3.z"][-1], abs=1e-7)
    assert run.engine.history.part("m").shape == (len(run.engine.history.t), 0)


@pytest.mark.exhaustive
def test_a_hundred_spheres_move_bit_for_bit_as_with_every_pair_in_every_step(monkeypatch):
    model = engine_model(scenes.spheres_in_box(100, 5))
    options = {"duration": "25 ms", "tolerance": 1e-6, "method": "dopri5", "compiled": False, "grid": None}
    assert near_model(model) is not None
    run = simulate(model, **options)
    monkeypatch.setattr(near_pairs, "WORTH", np.inf)
    whole = EngineModel(model.module, model.declaration)
    assert near_model(whole) is None
    every = simulate(whole, **options)
    assert len(run.impacts) > 20 and begun(run) == begun(every)
    moving = slice(0, model.nq + model.nu)
    assert np.array_equal(run.engine.history.part("y")[:, moving], every.engine.history.part("y")[:, moving])
