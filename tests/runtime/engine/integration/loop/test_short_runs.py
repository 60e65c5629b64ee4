"""Runs that end where they begin, or after one step: everything that is made of a run is made of them too."""

import json

import pytest
import sympy as sp

from hertzwerk.derive import JointForce, Parameter, coordinate_of
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.runtime import Solution, load, simulate
from hertzwerk.runtime.cli import run_folder

PERIOD = 0.012  # of the crank [s]


@pytest.fixture(scope="module")
def stuck():
    """A slider under a force that is no real number from the start on."""
    push, reach = Parameter("push", "N", 1), Parameter("reach", "m", 1)
    force = JointForce("push", "guide", push * sp.sqrt(coordinate_of("guide") / reach - 1))
    scene = slider_crank.replace(gravity=force)
    return simulate(load(scene), duration="24 ms", tolerance=1e-6)


def everything(run, folder):
    """Averages, files, pictures of every pair, the saved run."""
    shown = run.averages()
    files = run_folder.write(run, folder / "run", plots=True, averages=True).files
    again = Solution.load(folder / "run" / "states.npz")
    assert again.engine.final == run.engine.final
    assert again.averages() == shown
    assert run.outcome.name in str(run)
    about = json.loads((folder / "run" / "run.json").read_text())
    assert about["outcome"] == run.outcome.name
    assert {"mechanism.png", "overview.png", "slider_pin.png"} <= set(files)
    return shown


def test_a_run_without_a_step_has_sums_of_no_interval(stuck, tmp_path):
    assert (stuck.outcome.name, stuck.engine.t_end, stuck.statistics.steps) == ("not_finite", 0.0, 0)
    for average in everything(stuck, tmp_path):
        assert average.mean is None
        assert average.block == pytest.approx(PERIOD)
        assert "not longer than its transient" in average.reason
    assert stuck.impacts == ()
    sums = stuck.engine.findings.sums()
    assert (sums.count, len(sums.memory)) == (0, 1)


def test_a_run_of_one_step_on_a_grid_has_one_row(tmp_path):
    run = simulate(load("slider_crank"), duration="24 ms", tolerance=1e-6, grid=100, max_steps=1)
    assert (run.outcome.name, run.statistics.steps, len(run.t)) == ("too_many_steps", 1, 1)
    assert all(average.mean is None for average in everything(run, tmp_path))
