"""Models and runs pickle and copy: to the bit what they were, and able to go on, in another process too."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest

from hertzwerk.runtime import Solution, simulate
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model

RUNS = {
    "impacts": ("slider_crank", {"duration": "10 ms"}),
    "closed loop, implicit": ("four_bar_clearance", {"duration": "5 ms", "method": "esdirk", "tolerance": 1e-6}),
    "redundant constraints": ("bricard", {"duration": "0.1 s", "tolerance": 1e-6}),
    "a grid": ("bouncing_ball", {"duration": "0.5 s", "grid": 100}),
}


def restored(thing):
    return pickle.loads(pickle.dumps(thing))


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("again", [restored, copy.deepcopy], ids=["pickled", "copied"])
@pytest.mark.parametrize("name", RUNS)
def test_a_run_is_what_it_was(name, again):
    scene, options = RUNS[name]
    run = simulate(engine_model(scene), compiled=False, **options)
    twin = again(run)
    assert twin.engine.history is not run.engine.history
    assert twin.engine.model is not run.engine.model
    assert (str(twin), twin.impacts, twin.warnings) == (str(run), run.impacts, run.warnings)
    for history in ("t", *run):
        assert np.array_equal(twin[history].view(np.uint64), run[history].view(np.uint64)), history
    assert (twin.energy_residual, twin.engine.choices) == (run.energy_residual, run.engine.choices)
    times = np.linspace(0, run.engine.t_end, 17) if run.engine.history.steps else run.t[:5]
    rows = [each.engine.history.at(times).rows for each in (twin, run)]
    assert np.array_equal(*rows)
    longer = [each.continued(2 * run.settings.duration, compiled=False) for each in (twin, run)]
    assert np.array_equal(*(part.engine.history.rows[-1] for part in longer))


def test_a_copy_has_its_own_inputs_and_a_variation_keeps_its_scene(crank):
    other = copy.deepcopy(crank)
    other.module.NAME = "another"
    assert engine_model("slider_crank").module.NAME == crank.module.NAME == "slider_crank"
    model = restored(engine_model("slider_crank", without=["slider_pin_friction"]))
    assert "slider_pin_friction" not in [row[0] for row in model.module.EFFECTS]
    assert "tanh" not in model.equations().markdown()


def test_a_saved_run_is_what_it_was(crank, tmp_path):
    saved = Solution.load(simulate(crank, duration="3 ms").save(tmp_path / "run.npz"))
    twin = restored(saved)
    assert np.array_equal(twin["guide.travel"], saved["guide.travel"])
    assert (twin.impacts, str(twin)) == (saved.impacts, str(saved))
    assert isinstance(twin.engine.model, EngineModel)


def travel(model):
    return simulate(model, duration="2 ms", compiled=False)["guide.travel"][-1]


@pytest.mark.slow
@pytest.mark.parametrize("start", [pytest.param("spawn", marks=pytest.mark.exhaustive), "forkserver"])
def test_a_process_that_shares_nothing_runs_it(crank, start):
    with multiprocessing.get_context(start).Pool(1) as pool:
        assert pool.map(travel, [crank]) == [travel(crank)]
