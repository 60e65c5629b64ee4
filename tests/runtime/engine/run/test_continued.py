"""A run that goes on is bitwise the one that had not ended: whatever ended it, by every method, in contact, with memory, sticking."""

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from hertzwerk.runtime import InputError, Solution, simulate
from hertzwerk.runtime.engine.model.build import build_hard_scene
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model

built = cache(engine_model)  # with its functions, for all tests here
TOLERANCE = 1e-8
INCLINES = {name: EngineModel(build_hard_scene(name)) for name in ("incline_lugre", "incline_coulomb")}


def model(name):
    return INCLINES.get(name) or built(name)


def assert_bitwise(whole, *parts):
    """Histories one after the other are those of the whole."""
    one = parts[0]
    for name in ("t", *whole):
        values = one[name]
        t = one.t
        for part in parts[1:]:
            values = np.concatenate([values[t < part.engine.t_start], part[name]])
            t = np.concatenate([t[t < part.engine.t_start], part.t])
        assert values.tobytes() == whole[name].tobytes(), name


RUNS = [
    *(("slider_crank", method, "6 ms", {}) for method in ("dop853", "auto", "dopri5", "esdirk", "rodas")),
    pytest.param("incline_lugre", "dop853", "5 ms", {}, marks=pytest.mark.exhaustive), ("incline_lugre", "auto", "0.1 s", {}),
    ("incline_coulomb", "dop853", "0.2 s", {}), ("spatial_slider_crank", "dop853", "20 ms", {}), ("yielding_ball", "dop853", "0.8 s", {}),
]  # fmt: skip


@pytest.mark.by_turns(2)
@pytest.mark.parametrize(("scene", "method", "duration", "options"), RUNS)
def test_wherever_it_was_stopped(scene, method, duration, options):
    """After steps spread over the run, in contact and in flight, and then once more."""
    crank, requested = model(scene), {"duration": duration, "tolerance": TOLERANCE, "method": method, **options}
    whole = simulate(crank, **requested)
    count = whole.statistics.steps
    assert whole.outcome.finished
    assert scene != "incline_lugre" or method != "auto" or len(whole.engine.choices) > 1  # it changes method on the way
    modes = [whole[f"{pair}.mode"] for pair in crank.pairs]
    touching = [int(i) for mode in modes for i in np.flatnonzero(mode == 1)[1:2]]
    for steps in sorted({1, count // 2, count - 1, *touching}):
        stopped = simulate(crank, **requested, max_steps=steps)
        assert stopped.outcome.name == "too_many_steps"
        rest = stopped.continued()
        assert rest.outcome.finished
        assert_bitwise(whole, stopped, rest)
        repeated = stopped.statistics.steps + rest.statistics.steps - whole.statistics.steps
        assert repeated in (0, 1)  # the last one is
    stopped = simulate(crank, **requested, max_steps=count // 4)
    again = stopped.continued(max_steps=3)
    assert_bitwise(whole, stopped, again, again.continued())


@pytest.mark.parametrize("ends", ["user", "clock"])
def test_stopped_by_the_user_or_the_clock(ends):
    crank, options = built("slider_crank"), {"duration": "48 ms", "tolerance": TOLERANCE, "compiled": False}
    whole = simulate(crank, **options)

    def stop(done):
        if done > 0.3:
            raise KeyboardInterrupt

    stopped = simulate(crank, **options, **({"progress": stop} if ends == "user" else {"wall_time": 1e-9}))
    assert stopped.outcome.name == ("interrupted" if ends == "user" else "wall_time_limit")
    assert_bitwise(whole, stopped, stopped.continued())


@pytest.mark.parametrize("method", ["dop853", "esdirk"])
def test_a_run_that_was_finished_goes_on_as_if_it_had_not_ended_there(method):
    crank, options = built("slider_crank"), {"tolerance": TOLERANCE, "method": method}
    whole = simulate(crank, duration="24 ms", **options)
    for end in ("1.7 ms", "11 ms", "23.9 ms"):
        short = simulate(crank, duration=end, **options)
        assert short.outcome.finished
        rest = short.continued("24 ms")
        assert rest.engine.t_start < short.engine.t_end
        assert_bitwise(whole, short, rest)
        assert rest.settings.duration == whole.settings.duration


def test_grids_go_on_and_find_what_the_whole_finds():
    crank, options = built("slider_crank"), {"duration": "24 ms", "tolerance": TOLERANCE, "grid": "0.1 ms"}
    whole, stopped = simulate(crank, **options), simulate(crank, **options, max_steps=500)
    rest = stopped.continued(grid="0.1 ms")
    assert_bitwise(whole, stopped, rest)
    assert rest.t[0] - stopped.t[-1] < 1.01e-4
    onsets = {impact.t for impact in whole.impacts}
    assert {i.t for i in stopped.impacts} | {i.t for i in rest.impacts if i.t > rest.engine.t_start} == onsets
    assert rest.energy_residual < 1e-6


def test_averages_of_a_part_are_those_of_its_time():
    crank = built("slider_crank")
    short = simulate(crank, duration="24 ms", tolerance=TOLERANCE)
    rest = short.continued("180 ms", compiled=False)
    sums = rest.engine.findings.sums()
    assert sums.count == 13  # periods of 12 ms from 24 ms on
    of_sums = float(np.sum(sums.impulse[:, 0])) / (sums.count * sums.interval)
    t, force = rest.t, rest["slider_pin.normal_force"]
    within = t <= rest.engine.t_start + sums.count * sums.interval
    assert of_sums == pytest.approx(
        float(np.trapezoid(force[within], t[within])) / (sums.count * sums.interval), rel=0.02
    )
    assert all(average.mean is not None for average in rest.averages())


def test_an_accuracy_gives_a_run_that_goes_on_at_its_tolerance_and_says_so():
    crank = built("slider_crank")
    short = simulate(crank, duration="6 ms", accuracy=1e-5)
    rest = short.continued("12 ms")
    assert rest.settings.tolerance == short.settings.tolerance
    assert rest.error is None
    assert rest.settings.accuracy is None
    assert "without an error estimate" in rest.warnings[-1]
    assert_bitwise(simulate(crank, duration="12 ms", tolerance=short.settings.tolerance), short, rest)


def test_a_run_that_cannot_continue_says_why():
    crank = built("slider_crank")
    short = simulate(crank, duration="1 ms", tolerance=TOLERANCE)
    for duration in ("1 ms", "0.5 ms", None):
        with pytest.raises(InputError, match=r"more than the 0\.001 s that the run reached"):
            short.continued(duration)
    with pytest.raises(InputError, match="other equations"):
        short.continued("2 ms", target=built("bouncing_ball"))
    with pytest.raises(InputError, match="it would end in the same way"):
        replace(short, outcome=replace(short.outcome, name="not_finite")).continued("2 ms")


# ---- from the command line -------------------------------------------------------------------------------------------


COMMAND = "run", "--no-plots"
SET = ("--set", "clearance=0.3 mm", "--set", "guide.speed=0.1 m/s")


def test_a_folder_goes_on_in_a_new_one_bitwise(hertzwerk):
    crank = built("slider_crank")
    how = ("--duration", "12 ms", "--max-steps", "300", "--method", "esdirk", "--out", "one")
    first = hertzwerk("slider_crank", *SET, *how, code=1)
    assert "too_many_steps" in first.output
    assert "hertzwerk run --continue one" in first.output
    hertzwerk("--continue", "one", "--out", "two")
    further = ("--continue", "two", "--duration", "18 ms", "--out", "three")
    hertzwerk("slider_crank", *SET[:2], "--method", "esdirk", *further)
    one, two, three = (Solution.load(f"{name}/states.npz") for name in ("one", "two", "three"))
    values = {"parameters": {"clearance": "0.3 mm"}, "initial": {"guide.speed": "0.1 m/s"}}
    options = {"tolerance": one.settings.tolerance, "method": "esdirk", **values}
    assert_bitwise(simulate(crank, duration="12 ms", **options), one, two)
    assert_bitwise(simulate(crank, duration="18 ms", **options), one, two, three)
    record = json.loads(Path("three/run.json").read_text())
    assert record["request"]["continues"] == "two"
    assert any("continues from" in warning for warning in record["warnings"])


def test_options_that_differ_from_the_run_are_refused_with_the_difference(hertzwerk):
    hertzwerk("slider_crank", *SET, "--duration", "1 ms", "--grid", "100", "--out", "one")
    for options, words in (
        (("--set", "clearance=0.2 mm"), "0.3 mm"), (("--set", "guide.speed=0.2 m/s"), "0.1 m/s"),
        (("--method", "rodas"), "expected auto"), (("--accuracy", "1e-3"), "without an estimate"),
        (("--without", "slider_pin_friction"), "none"), (("--law", "slider_pin=flores"), "none"),
        (("bouncing_ball",), "slider_crank"), (("--duration", "2 ms"), "100 points over 0.001 s"),
        (("--duration", "1 ms", "--grid", "0.1 ms"), "more than the 0.001 s"),
        (("--max-steps", "many"), "positive whole number"),
    ):  # fmt: skip
        assert words in hertzwerk(*options, "--continue", "one", "--out", "two", code=2).output
        assert not Path("two").exists()
    for folder in ("nowhere", "."):
        hertzwerk("--continue", folder, code=2)
    hertzwerk(code=2)


def test_limits_of_the_command_line(hertzwerk):
    hertzwerk("slider_crank", "--duration", "100 s", "--wall-time", "0.2 s", "--out", "one", code=1)
    assert json.loads(Path("one/run.json").read_text())["outcome"] == "wall_time_limit"
