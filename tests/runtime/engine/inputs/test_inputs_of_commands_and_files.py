"""Inputs on the command line, in scenario and sweep files, in sweeps and statics: the same values as in Python."""

import json

import numpy as np
import pytest
from commands import called
from shaken import MASS, PUSHED, STIFFNESS, shaken

from hertzwerk.derive import InputError
from hertzwerk.runtime import Samples, equilibrium, modes, simulate, sweep
from hertzwerk.runtime.analysis.validation.scenario import load_scenario
from hertzwerk.runtime.analysis.validation.validate import run_scenario, validate
from hertzwerk.runtime.engine.inputs.input_values import in_file, located
from hertzwerk.runtime.studies.sweeps.definition_file import read_definition_file

TIMES, LOADS = (0.0, 0.5, 1.0, 2.0), (0.0, 3.0, -1.0, 0.0)


@pytest.fixture
def folder(own_folder):
    (own_folder / "pushed.py").write_text(PUSHED)
    rows = "".join(f"{1e3 * t:g},{v:g}\n" for t, v in zip(TIMES, LOADS, strict=True))
    (own_folder / "bench.csv").write_text(f"time [ms],load [N]\n{rows}")
    return own_folder


def test_the_command_line_takes_constants_and_columns_of_files_and_a_run_goes_on_with_them(folder):
    called("run", "pushed.py", "--duration", "1 s", "--input", "push=bench.csv:load", "--out", "a", "--no-plots")
    command = ("run", "--continue", "a", "--duration", "2 s", "--out", "b", "--no-plots")
    called(*command)
    called(*command[:-2], "c", "--no-plots", "--input", "push=3 N", code=2)
    (folder / "bench.csv").write_text((folder / "bench.csv").read_text().replace("3", "4"))
    assert "other equations or inputs" in called(*command[:-2], "c", "--no-plots", code=2).output
    bad = ("--input", "push=bench.csv:loud", "--input", "shove=3 N", "--set", "mass=2 N")
    wrong = called("run", "pushed.py", "--duration", "3 s", *bad, code=2).output
    assert all(part in wrong for part in ("3 faults", "push, loud", "shove", "mass"))
    assert json.loads(called("statics", "pushed.py", "--input", "push=5 N", "--json").output)


def test_a_scenario_has_inputs_by_files_beside_it(folder):
    path = folder / "push.toml"
    path.write_text(
        'scene = "pushed.py"\nduration = "2 s"\naccuracy = 1e-9\n[inputs]\npush = "bench.csv:load"\n[[checks]]\nquantity = "max.push"\n'
        'expected = "3 N"\ntolerance = 1e-9\nsource = "the file"\n'
    )
    scenario = load_scenario(path)
    assert all(verdict.passed for verdict in validate(scenario, run_scenario(scenario)))
    path.write_text(path.read_text().replace('"bench.csv:load"', '"3 m"'))
    with pytest.raises(InputError, match="input push"):
        load_scenario(path)


def test_a_sweep_has_the_same_inputs_in_all_rows_and_keys_them_by_their_values(folder):
    design = {"stiffness": "40..60 N/m:3"}
    options = {"duration": "1 s", "tolerance": 1e-9, "workers": 1, "out": folder / "rows"}
    file = folder / "push.toml"
    file.write_text(
        'target = "pushed.py"\nduration = "1 s"\n[inputs]\npush = "bench.csv:load"\n[over]\nstiffness = "40..60 N/m:3"\n'
    )
    arguments = read_definition_file(file, sweep)
    assert arguments["inputs"] == {"push": str(folder / "bench.csv:load")}
    table = sweep("pushed.py", design, inputs=arguments["inputs"], **options)
    run = simulate(
        shaken(), duration="1 s", tolerance=1e-9, inputs={"push": (TIMES, LOADS)}, parameters={"damping": "0 N s/m"}
    )
    assert table["final.slide.travel"][1] == pytest.approx(run["slide.travel"][-1], abs=1e-8)
    again = sweep("pushed.py", design, inputs={"push": "bench.csv:load"}, **options)  # the same file by another name
    assert np.array_equal(again["final.slide.travel"], table["final.slide.travel"])
    with pytest.raises(InputError, match="signals"):
        sweep("pushed.py", design, inputs={"push": "2 N"}, **options)
    with pytest.raises(InputError, match="input push: found no value"):
        sweep("pushed.py", design, duration="1 s")


def test_statics_have_the_value_of_the_time():
    push = Samples(TIMES, LOADS, ("s", "N"))
    for at, force in ((0.0, 0.0), ("0.25 s", 1.5), ("1 s", -1.0)):
        rest = equilibrium(shaken(), inputs={"push": push}, at=at)
        assert rest.converged and rest["slide.travel"][0] == pytest.approx(force / STIFFNESS, abs=1e-9)
    (mode,) = modes(shaken(), inputs={"push": "3 N"})
    assert abs(mode.eigenvalue) == pytest.approx(np.sqrt(STIFFNESS / MASS), rel=1e-9)
    with pytest.raises(InputError, match="no value"):
        equilibrium(shaken())
    with pytest.raises(InputError, match="values over the whole run"):
        equilibrium(shaken(), inputs={"push": push}, at="3 s")


@pytest.mark.parametrize(
    ("text", "there"),
    [
        ("push=bench.csv:load", "push=/data/bench.csv:load"), ("bench.csv:load:held", "/data/bench.csv:load:held"),
        ("push=/tmp/bench.csv:load", "push=/tmp/bench.csv:load"), ("push=3 N", "push=3 N"),
    ],
)  # fmt: skip
def test_files_are_seen_from_a_folder(text, there, tmp_path):
    from pathlib import Path

    assert located(text, Path("/data")) == there


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("bench.tsv:t.csv", {"file": "bench.tsv", "column": "t.csv"}), ("bench.csv: ", {}), ("bench.tsv", {}), (3.0, {}),
        ("bench.CSV?missing=N/A ", {"file": "bench.CSV", "how": "?missing=N/A"}),
    ],
)  # fmt: skip
def test_a_column_may_be_called_as_a_file_and_blanks_around_do_not_count(text, parts):
    assert in_file(text) == parts
