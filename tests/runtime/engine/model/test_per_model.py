"""What is computed once per model: kept by function and arguments, freed with the model."""

import copy
import gc
import math
import weakref

import pytest

from hertzwerk.runtime import InputError, load, simulate
from hertzwerk.runtime.engine.model.per_model import per_model
from hertzwerk.runtime.engine.run.run_request import _key
from hertzwerk.runtime.loading import engine_model


@per_model
def counted(model, calls, name):
    calls.append(name)
    return [model.name, name]


class Calls(list):
    __hash__ = object.__hash__


def test_results_are_kept_by_function_and_arguments():
    one, calls = engine_model("bouncing_ball"), Calls()
    other = copy.copy(one)
    first = counted(one, calls, "a")
    assert counted(one, calls, "a") is first
    assert counted(one, calls, "b") is not first
    assert counted(other, calls, "a") is not first
    assert calls == ["a", "b", "a"]


def test_a_model_that_was_run_is_freed_with_what_was_built_for_it():
    model = copy.copy(engine_model("bouncing_ball"))
    run = simulate(model, duration="0.6 s", tolerance=1e-6)
    assert run.impacts
    seen = weakref.ref(model)
    del model, run
    gc.collect()
    assert seen() is None


def test_a_built_in_scene_is_built_once_and_its_variations_are_models_of_their_own():
    ball = engine_model("bouncing_ball")
    assert engine_model("bouncing_ball") is ball
    assert load("bouncing_ball").engine is ball
    assert engine_model("bouncing_ball", coordinates="absolute") is not ball


def test_inputs_that_differ_are_distinguished_and_equal_ones_are_not():
    values = (1, True, 1.0, "1", None, 0.0, -0.0, math.nan, (1, "m"), (1.0, "m"), (True, "m"), {"a": 1}, {"a": True})
    assert len({_key(value) for value in values}) == len(values)
    assert _key(("24 ms", {"mass": (0.2, "kg")}, {})) == _key(("24 ms", {"mass": (0.2, "kg")}, {}))
    assert _key([1]) == _key([1]) != _key([True])
    assert _key(lambda: 1) != _key(lambda: 1)  # never found again
    model = engine_model("bouncing_ball")
    simulate(model, duration="0.1 s", tolerance=1e-6, parameters={"restitution": 1.0})
    with pytest.raises(InputError):
        simulate(model, duration="0.1 s", tolerance=1e-6, parameters={"restitution": True})
