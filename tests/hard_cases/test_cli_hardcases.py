"""`hertzwerk hardcases`: what it prints, its JSON, its exit codes, and bad input."""

import json

import pytest
from click.testing import CliRunner

from hertzwerk.runtime.analysis.hard_cases import invariants, runner
from hertzwerk.runtime.analysis.hard_cases.case_table import BY_NAME, CASES
from hertzwerk.runtime.analysis.hard_cases.tried_steps import TRIES
from hertzwerk.runtime.cli import main


@pytest.fixture
def without_a_compiler(monkeypatch):
    monkeypatch.setattr(runner, "available", lambda: False)


def run(*arguments):
    return CliRunner().invoke(main, ["hardcases", *arguments], catch_exceptions=False)


def printed(*arguments):
    done = run(*arguments)
    return done.exit_code, json.loads(done.stdout)


def test_json_says_what_was_measured(without_a_compiler, monkeypatch):
    """Methods stand in the case's order, though the last is done first."""
    results = runner.results
    monkeypatch.setattr(
        runner, "results", lambda jobs: sorted(results(jobs), key=lambda result: result.method, reverse=True)
    )
    code, record = printed("--case", "exponent_1", "--method", "dop853", "--method", "esdirk", "--json")
    assert code == 0
    assert record["passed"] is True
    (case,) = record["cases"]
    known = BY_NAME["exponent_1"]
    assert (case["name"], case["hard"], case["expected_outcome"]) == (known.name, known.hard, "finished")
    assert [result["method"] for result in case["results"]] == ["dop853", "esdirk"]
    for result in case["results"]:
        assert result["verdict"] == "passed"
        assert result["outcome"] == "finished"
        assert result["compiled_wall_s"] is None
        assert result["wall_s"] > 0
        rows = {row["name"]: row for row in result["measured"]}
        assert all(row["holds"] and row["value"] <= row["limit"] for row in rows.values())
        assert rows["energy"]["limit"] == pytest.approx(10 * known.tolerance)
        assert rows["steps tried"]["value"] == result["tries"]
        assert rows["final ball.speed"]["value"] <= known.known[0].within == rows["final ball.speed"]["limit"]
        again = runner.result(known, result["method"], native=False)
        assert [row.value for row in again.measured] == [row["value"] for row in result["measured"]]


def test_the_table_fits_a_terminal_and_shows_every_invariant(without_a_compiler):
    done = run("--case", "both_sides_e05")
    lines = done.stdout.splitlines()
    assert done.exit_code == 0
    assert max(map(len, lines)) <= 120
    assert lines[0].startswith("passed  both_sides_e05  two pairs of one sphere hit at the same instant")
    assert lines[1].split() == ["invariant", "limit", "dopri5", "dop853", "rodas", "esdirk", "auto", "cvodes", "idas"]
    for name in ("outcome", "not finite", "energy", "energy rising", "depth/bound", "final left.speed", "steps tried"):
        assert any(line.startswith(f"{name} ") for line in lines), name
    assert lines[-2].split() == ["passed", "1", "of", "1", "cases"]


def test_failing_cases_give_exit_code_1_and_known_failures_a_reason(monkeypatch, without_a_compiler):
    monkeypatch.setitem(TRIES, "exponent_2", dict.fromkeys(TRIES["exponent_2"], 1))
    done = run("--case", "exponent_2", "--method", "dop853")
    assert done.exit_code == 1
    marked = [line for line in done.stdout.splitlines() if "!" in line]
    assert len(marked) == 1
    assert marked[0].startswith(invariants.STEPS)
    assert done.stdout.splitlines()[-2].startswith("failed        1 of 1 cases fail: exponent_2")
    name, method = next((case.name, method) for case in CASES for method, _ in case.failures if method == "dop853")
    done = run("--case", name, "--method", method)
    assert done.exit_code == 0
    assert done.stdout.startswith("known failure")
    reason = next(iter(BY_NAME[name].failures.values()))
    assert reason.split()[0] in done.stdout.split("known  ")[1]


def test_both_paths_are_run_where_there_is_a_compiler_of_all_methods_at_once(monkeypatch, tmp_path):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path))
    code, record = printed("--case", "exponent_1", "--method", "dopri5", "--method", "rodas", "--json")
    assert code == 0
    assert len(record["cases"][0]["results"]) == 2
    for result in record["cases"][0]["results"]:
        assert result["measured"][-1] == {
            "name": runner.SAME, "value": 0, "limit": 0, "unit": "1", "holds": True, "note": result["measured"][-1]["note"]
        }  # fmt: skip
        assert result["compiled_wall_s"] > 0
    assert len(list(tmp_path.glob("compiled-*"))) == 1


def test_a_method_without_c_leaves_its_cell_empty():
    done = run("--case", "exponent_1", "--method", "dopri5", "--method", "idas")
    assert done.exit_code == 0
    rows = {line[:24].strip(): line.split()[-2:] for line in done.stdout.splitlines() if line}
    assert (
        len(next(line for line in done.stdout.splitlines() if runner.SAME in line).split()) == 5
    )  # name, limit, one cell
    assert rows["outcome"] == ["finished", "finished"]


def test_the_list_names_every_case_but_runs_none():
    _, record = printed("--list", "--all", "--json")
    assert [case["name"] for case in record["cases"]] == [case.name for case in CASES]
    _, record = printed("--list", "--json")
    assert [case["name"] for case in record["cases"]] == [case.name for case in CASES if not case.long]
    text = run("--list").stdout
    assert all(case.name in text for case in CASES if not case.long)


def test_bad_input_is_one_error_with_every_fault():
    done = run("--case", "drop_to_rst", "--case", "nothing_of_the_kind_at_all", "--method", "euler")
    assert done.exit_code == 2
    assert done.stdout == ""
    for text in ("drop_to_rst:", "mean drop_to_rest", "nothing_of_the_kind_at_all:", "euler:", "one of dopri5"):
        assert text in done.stderr
    done = run("--case", "settling_flores", "--method", "dopri5")
    assert done.exit_code == 2
    assert "settling_flores with dopri5" in done.stderr
