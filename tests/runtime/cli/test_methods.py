"""The methods stand in one list: one that is added there is known to input, help, scenarios, studies and hard cases."""

import subprocess
import sys

from commands import called

from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS

ADDED = """
from dataclasses import replace
from hertzwerk.runtime.engine.integration.tableaux import methods
from hertzwerk.runtime.engine.integration.tableaux.explicit_tableaux import dopri5

for known in (methods.EXPLICIT, methods.IN_GRAPH, methods.METHODS):
    known["own"] = (lambda: replace(dopri5(), name="own"),)

import inspect
from click.testing import CliRunner
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.cli import main
from hertzwerk.runtime.analysis.hard_cases import case
from hertzwerk.runtime.analysis.validation.scenario import Scenario
from hertzwerk.runtime.analysis.work_precision import reference_run, work_precision_study

for command in ("run", "effects"):
    assert "own" in CliRunner().invoke(main, [command, "--help"]).output
assert Scenario(scene="soft_ball", duration="1 s", method="own").method == "own"
assert "own" in inspect.signature(work_precision_study.study).parameters["methods"].default
assert "own" in reference_run.METHODS and "own" in case.METHODS and "own" in case.EXPLICIT
run = simulate(load("soft_ball"), duration="1 ms", tolerance=1e-4, method="own")
assert run.outcome.finished and run.settings.method == "own"
"""


def test_a_method_that_is_added_to_the_list_is_known_everywhere():
    subprocess.run([sys.executable, "-c", ADDED], check=True)


def test_help_and_the_docstring_of_simulate_name_every_method():
    for command in ("run", "effects"):
        assert all(name in called(command, "--help").output for name in METHODS)
    assert simulate.__doc__ is not None
    assert all(f'"{name}"' in simulate.__doc__ for name in METHODS)
