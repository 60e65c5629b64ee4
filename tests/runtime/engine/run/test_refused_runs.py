"""What the runtime is asked for and cannot do: one InputError, before it has computed anything that would be lost."""

from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.derive import Contact, InputError, Parameter
from hertzwerk.derive.laws import pereira_internal, pereira_internal_si
from hertzwerk.derive.scenes.slider_crank import mechanism, scene, steel
from hertzwerk.runtime import load, simulate_many

BALL = load("bouncing_ball")


@pytest.mark.parametrize("compiled", [False, "auto"])
@pytest.mark.parametrize("workers", [1, 2])
def test_an_output_that_is_an_array_is_refused_with_the_first_row(compiled, workers):
    recorded = []

    def heights(run):
        recorded.append(run)
        return run["vertical.travel"]

    sets = [{"drop_height": (0.1 + 0.01 * i, "m")} for i in range(8)]
    with pytest.raises(
        InputError, match=r"functions: found output heights returned an array of shape \(\d+,\); expected a number"
    ):
        simulate_many(
            BALL, sets, duration="0.5 s", tolerance=1e-6, workers=workers, compiled=compiled, functions={"heights": heights},
        )  # fmt: skip
    assert len(recorded) <= 1  # in this process


def test_an_array_of_one_number_in_no_dimension_is_one():
    table = simulate_many(
        BALL, [{}], duration="0.1 s", tolerance=1e-6, functions={"top": lambda run: np.max(run["vertical.travel"])}
    )
    assert table.rows[0].outcome == "finished"
    assert table.rows[0].outputs["top"] > 0


def test_an_unchecked_law_without_a_value_is_one_fault_that_names_it():
    """Published for millimetres: in metres it takes a power of a logarithm that is negative."""
    pin = replace(mechanism.pairs[0], length=Parameter("pin_length", "mm", 20))
    long = replace(scene, mechanism=replace(mechanism, pairs=(pin,)))
    wrong = load(long.replace(slider_pin=Contact("slider_pin", pereira_internal(steel, steel), unchecked=True)))
    with pytest.raises(InputError) as refused:
        wrong.bind()
    assert "effect slider_pin: found pereira_internal, UNCHECKED without a value" in str(refused.value)
    assert "hidden units" in str(refused.value)
    assert len(refused.value.faults) == 1
    length, pressure = Parameter("l_ref", "mm", 1), Parameter("p_ref", "MPa", 1)
    right = load(
        long.replace(slider_pin=Contact("slider_pin", pereira_internal_si(steel, steel, l_ref=length, p_ref=pressure)))
    )
    assert np.all(np.isfinite(right.bind().c))
