"""Curves of pictures are straight between their samples to the eye, of long runs and of saved ones, with every peak."""

import numpy as np
import pytest

from hertzwerk.runtime import Solution, simulate
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.output.plots import picture_samples
from hertzwerk.runtime.output.plots.curves import Curves, impact_curves
from hertzwerk.runtime.output.plots.picture_samples import between

PATH = ("slider_pin.eccentricity_x", "slider_pin.eccentricity_y")
SHOWN = (*PATH, "guide.travel", "guide.speed", "crank_pin.speed", "slider_pin.normal_force")
EYE = 3e-3  # of a curve's range
CORNER = 5e-4  # the same: what chords miss a smooth curve by whose corners do not show


@pytest.fixture(scope="module")
def crank():
    """16,000 steps, long ones in flights and short ones in contact."""
    return simulate(engine_model("slider_crank"), duration="0.2 s", tolerance=1e-9)


@pytest.fixture(scope="module")
def saved(crank, tmp_path_factory):
    return Solution.load(crank.save(tmp_path_factory.mktemp("saved") / "run.npz"))


def bent(run: Solution, true: Solution, seen: float = EYE) -> dict[str, float]:
    """Curves whose largest distance from the motion, halfway between their samples, a reader sees; over their range."""
    curves = Curves.of(run)
    moved = true.at((curves.t[1:] + curves.t[:-1]) / 2)
    drawn = {name: (curves[name][1:] + curves[name][:-1]) / 2 for name in SHOWN}
    off = {name: float(np.max(np.abs(drawn[name] - moved[name])) / np.ptp(true[name])) for name in SHOWN}
    return {name: distance for name, distance in off.items() if distance >= seen}


def test_long_and_saved_runs_have_no_kinks(crank, saved):
    """A fixed number of samples was spread over any duration: of .3 s, flights were chords with kinks."""
    assert len(crank.t) > 15_000
    assert bent(crank, crank, CORNER) == {}
    # Straight lines joined the steps: the pin's path was a polygon.
    assert bent(saved, crank) == {}
    # It had five chords; its force is within 1e-3 of the run's own.
    (t, force, depth), (_, live, deep) = (impact_curves(run, run.impacts[0]) for run in (saved, crank))
    assert len(t) == len(force) == 400
    assert np.max(np.abs(force - live)) < 1e-3 * np.max(live)
    assert np.max(np.abs(depth - deep)) < 1e-3 * np.max(deep)


@pytest.mark.parametrize(
    "scene", ["double_pendulum", "ball_in_socket", "two_spheres", "journal_lubricated", "tippe_top"]
)
def test_every_history_of_a_saved_run_is_near_the_motion(scene, tmp_path):
    run = simulate(engine_model(scene), duration="20 ms" if scene == "journal_lubricated" else "0.3 s", tolerance=1e-8)
    kept = Solution.load(run.save(tmp_path / "run.npz"))
    times = np.linspace(0, run.engine.t_end, 3001)
    true, found = run.at(times), between(kept, times)
    for name in (
        *run.engine.model.coordinates, *run.engine.model.speeds, *(f"{pair}.normal_force" for pair in run.engine.model.pairs),
    ):  # fmt: skip
        size = max(float(np.ptp(run[name])), 1e-9)
        assert np.max(np.abs(found[name] - true[name])) < 5e-3 * size, name


def test_more_steps_than_are_drawn_keep_every_force(monkeypatch, crank):
    """Where a picture has fewer samples than steps, curves are coarser, all alike, and peaks stay."""
    monkeypatch.setattr(picture_samples, "MOST", 1000)
    actual = picture_samples.dense(crank)
    peak = max(impact.peak_force for impact in crank.impacts)
    assert len(actual.t) < 10_000
    assert np.max(actual["slider_pin.normal_force"]) == pytest.approx(peak, rel=5e-4)
