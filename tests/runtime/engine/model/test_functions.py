"""CasADi functions as the handbook lists them: arguments and results of all, and what those of a step return."""

import re
from pathlib import Path

import numpy as np
import pytest

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.integration.step.layout import layouts
from hertzwerk.runtime.engine.model.model import _INPUTS

PAGE = Path(__file__).parents[4] / "runtime" / "handbook" / "howto" / "exchange" / "casadi-functions.md"
TABLE = PAGE.read_text(encoding="utf-8").partition("| function | arguments | results |")[2].partition("\n\n")[0]
LISTED = {
    name: row[2].split()
    for row in re.findall(r"^\| (.*?) \| `([\w ]+)` \|", TABLE, re.MULTILINE)
    for row in [(*row, row[1])]
    for name in re.findall(r"`([\w<>]+)`", row[0])
}
SCENES = ("slider_crank", "geared_hoist")


def test_the_table_lists_every_function_of_a_module():
    assert {name.replace("contact_<pair>", "contact") for name in LISTED} - {
        "rates", "ends", "holding", "begin", "step", "attempt",
    } == set(_INPUTS)  # fmt: skip
    for name, inputs in _INPUTS.items():
        assert LISTED["contact_<pair>" if name == "contact" else name] == inputs.split()


@pytest.mark.parametrize("scene", SCENES)
def test_functions_take_what_the_table_says(scene):
    model = load(scene)
    names = [name for name in LISTED if name not in _INPUTS or model.engine.has_function(name)]
    for name in names:
        for one in [f"contact_{pair}" for pair in model.pairs] if name == "contact_<pair>" else [name]:
            function = model.function(one)
            if one != "begin":
                assert function.name_in() == LISTED[name], one
            assert function.n_in() == len(LISTED[name])


def test_attempts_are_the_steps_of_a_run():
    model = load("slider_crank")
    run = simulate(model, duration="0.3 ms", tolerance=1e-8, method="dop853", compiled=False)
    attempt, state, place = model.function("attempt"), layouts(model.engine).state, 0
    row, last = run.engine.history.rows[0], run.engine.history.controls
    seen = [row]
    while place < 40 and len(seen) < 12:
        row, place = np.array(attempt(row, last)).ravel(), place + 1
        if row[state["accepted"]][0]:
            seen.append(row)
    kept = [*("t", "y", "mode", "m")]
    for part in kept:
        np.testing.assert_array_equal(np.array(seen)[:, state[part]], run.engine.history.part(part)[: len(seen)])


def test_rates_are_the_slopes_of_a_run():
    model = load("slider_crank")
    run = simulate(model, duration="0.3 ms", tolerance=1e-8, compiled=False)
    rates, history = model.function("rates"), run.engine.history
    for i in (0, len(run.t) // 2, len(run.t) - 1):
        at = (history.part(part)[i] for part in ("t", "y", "mode", "m"))
        np.testing.assert_array_equal(np.array(rates(*at, model.bind().c)).ravel(), history.part("dy")[i])


def test_steps_of_other_methods_and_unknown_names():
    model = load("bouncing_ball")
    assert model.function("step", "esdirk").size1_out(0) == layouts(model.engine).trial.size
    with pytest.raises(InputError, match="attempt"):
        model.function("atempt")
    with pytest.raises(InputError, match="dop853"):
        model.function("attempt", "euler")
