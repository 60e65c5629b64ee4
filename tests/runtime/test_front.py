"""Every public function takes the same targets, and calls one thing by one name."""

import inspect
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from each import each

from hertzwerk import runtime
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.scenes.bouncing_ball import scene
from hertzwerk.runtime import (
    Measurement,
    RigidImpact,
    compare,
    equilibrium,
    fit,
    fit_laws,
    fit_moments,
    load,
    minimise,
    modes,
    propagate,
    rigid_limit,
    simulate,
    simulate_many,
    study_effects,
    sweep,
)

BALL = load("bouncing_ball")
FILE = Path(__file__).parents[2] / "derive" / "scenes" / "bouncing_ball.py"
TARGETS = {"name": "bouncing_ball", "path": FILE, "file": str(FILE), "scene": scene, "model": BALL}
DROP = Measurement([0.0, 0.1, 0.2], {"vertical.travel": [1.0, 0.95, 0.8]}, {"vertical.travel": "m"})
SHORT = {"duration": "10 ms", "tolerance": 1e-6}
WAVE = Measurement(
    [0.002 * k for k in range(30)], {"vertical.travel": [1.1 - 4.905 * (0.002 * k) ** 2 for k in range(30)]}, {"vertical.travel": "m"},
)  # fmt: skip
CALLS: dict[str, Callable[..., Any]] = {
    "simulate": lambda target, **more: simulate(target, **SHORT, **more),
    "simulate_many": lambda target, **more: simulate_many(target, [{}], **SHORT, workers=1, **more),
    "sweep": lambda target, **more: sweep(target, {"mass": "1, 2 kg"}, **SHORT, workers=1, **more),
    "propagate": lambda target, **more: propagate(target, {"mass": "Uniform(1 kg, 2 kg)"}, **SHORT, sample=8, **more),
    "minimise": lambda target, **more: minimise(target, "final.vertical.travel", {"mass": "1..2 kg"}, **SHORT, **more),
    "fit": lambda target, **more: fit(target, DROP, free={"drop_height": "0.9..1.1 m"}, **more),
    "fit_laws": lambda target, **more: fit_laws(
        target, DROP, {"floor": ["flores", "hunt_crossley"]}, free={"drop_height": "0.9..1.1 m"}, **more
    ),
    "fit_moments": lambda target, **more: fit_moments(
        target, {"final.vertical.travel": "0.9 +- 0.1 m"}, free={"drop_height": "0.9..1.1 m"}, duration="10 ms", **more
    ),
    "compare": lambda target, **more: compare(target, WAVE, tolerance=1e-6, **more),
    "equilibrium": lambda target, **more: equilibrium(target, **more),
    "modes": lambda target, **more: modes(target, **more),
    "study_effects": lambda target, **more: study_effects(target, **SHORT, **more),
    "rigid_limit": lambda target, **more: rigid_limit(target, RigidImpact(0.5), **SHORT, **more),
}
WITHOUT_PROGRESS = {"compare", "equilibrium", "minimise", "modes"}


@each("function", CALLS)
@each("target", TARGETS)
def test_every_function_takes_every_target(function, target):
    """What is no parameter of the scene is refused by name, which takes the scene."""
    with pytest.raises(InputError, match=r"bouncing_ball|laws") as caught:
        CALLS[function](TARGETS[target], parameters={"mas": "1 kg"})
    assert any("mas" in str(fault) and "mass" in str(fault) for fault in caught.value.faults)


@each("function", CALLS)
@each("target", [5, None, ["bouncing_ball"], "bouncing_bal", Path("no_such_scene.py")])
def test_a_value_that_is_no_target_is_refused(function, target):
    with pytest.raises(InputError):
        CALLS[function](target)


@each("function", CALLS)
def test_values_are_parameters_and_initial_states(function):
    """Initial states may stand among the parameters; in both they are refused."""
    with pytest.raises(InputError) as caught:
        CALLS[function](
            BALL, parameters={"vertical.travel": "1 m", "mass": 1}, initial={"vertical.travel": "2 m", "no": 0}
        )
    reported = "\n".join(map(str, caught.value.faults))
    assert "vertical.travel: found among parameters and initial" in reported
    names = inspect.signature(getattr(runtime, function)).parameters
    assert next(iter(names)) == "target"
    assert not {"values", "model", "output", "how", "limits"} & set(names)


@each("function", sorted(set(CALLS) - WITHOUT_PROGRESS))
def test_a_progress_that_cannot_be_called_is_refused(function):
    with pytest.raises(InputError, match="progress: found 3"):
        CALLS[function](BALL, progress=3)


def test_a_start_among_the_parameters_is_the_start():
    start = {"vertical.travel": "0.5 m"}
    run, other = simulate(BALL, parameters=start, **SHORT), simulate(BALL, initial=start, **SHORT)
    assert run.engine.initial == other.engine.initial != simulate(BALL, **SHORT).engine.initial
    assert run.engine.final == other.engine.final


def test_a_varied_model_is_the_scene_varied():
    """A model can be varied as a name can, again and again, and keeps what it was varied by."""
    once = load("slider_crank", without=["slider_pin_friction"])
    twice, named = load(once, without=["gravity"]), load("slider_crank", without=["slider_pin_friction", "gravity"])
    assert list(twice.effects) == list(named.effects)
    assert load(BALL).engine is BALL.engine


def test_a_scene_is_run_as_long_as_the_data_it_is_compared_with_last():
    actual, run = compare("bouncing_ball", WAVE, tolerance=1e-6), simulate(BALL, duration="58 ms", tolerance=1e-6)
    assert actual.solution.engine.t_end == pytest.approx(0.058, rel=1e-15)
    assert actual.solution.engine.final == pytest.approx(run.engine.final, rel=1e-12)
    assert compare(run, WAVE).csv() == actual.csv()
    for data in (run, run.engine.history, 3, None):
        with pytest.raises(InputError, match="data: found"):
            compare(run, data)
        with pytest.raises(InputError, match="data: found"):
            fit(BALL, data, free=["drop_height"])
    with pytest.raises(InputError, match="values beside a run"):
        compare(run, WAVE, duration="1 s")
