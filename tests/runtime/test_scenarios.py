"""Scenario files: the built-in ones are sound and come out; faulty ones are refused with all their faults; a check can fail."""

import pytest

from hertzwerk.derive.faults import InputError
from hertzwerk.runtime import scenarios
from hertzwerk.runtime.build import built_in_scenes
from hertzwerk.runtime.scenario import load_scenario
from hertzwerk.runtime.validate import measure, run_scenario, validate

GOOD = """
scene = "two_spheres"
duration = "0.1 s"
[[checks]]
quantity = "impacts.0.speed"
expected = "0.3 m/s"
tolerance = 1e-9
source = "the striker's speed"
"""


@pytest.fixture(scope="module")
def spheres():
    return run_scenario(load_scenario("two_spheres"))


def written(tmp_path, text):
    path = tmp_path / "s.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_every_built_in_scene_has_a_scenario():
    assert scenarios.names() == built_in_scenes()
    assert all(load_scenario(name).scene == name for name in scenarios.names())
    assert all(load_scenario(name).checks for name in scenarios.names())


@pytest.mark.parametrize("name", scenarios.names())
def test_built_in_scenarios_come_out(name):
    scenario = load_scenario(name)
    solution = run_scenario(scenario)
    assert solution.outcome.name == "finished"
    failed = [str(verdict) for verdict in validate(scenario, solution) if not verdict.passed]
    assert failed == []
    assert solution.model.has_ledger
    assert solution.energy_residual < 10 * scenario.accuracy


@pytest.mark.parametrize(
    ("check", "passes"),
    [
        ('expected = "0.3 m/s"\ntolerance = 1e-9', True),
        ('expected = "300 mm/s"\ntolerance = 1e-9', True),
        ('expected = "0.3001 m/s"\ntolerance = 1e-4', False),
        ('expected = "-0.3 m/s"\ntolerance = 0.5', False),
        ('at_most = "0.31 m/s"', True),
        ('at_most = "0.29 m/s"', False),
    ],
)
def test_a_check_can_fail(tmp_path, spheres, check, passes):
    text = GOOD.replace('expected = "0.3 m/s"\ntolerance = 1e-9', check)
    (verdict,) = validate(load_scenario(written(tmp_path, text)), spheres)
    assert verdict.passed is passes
    assert verdict.measured == pytest.approx(0.3)
    assert "impacts.0.speed = 0.3" in str(verdict)


def test_what_does_not_exist_fails_and_is_not_invented(tmp_path, spheres):
    text = GOOD.replace("impacts.0.speed", "impacts.7.speed")
    (verdict,) = validate(load_scenario(written(tmp_path, text)), spheres)
    assert verdict.measured is None
    assert not verdict.passed


def test_quantities_are_those_of_the_solution(spheres):
    assert measure(spheres, "impacts") == 1
    assert measure(spheres, "final.target_path.speed") == spheres["target_path.speed"][-1]
    assert measure(spheres, "max.target_path.speed") == max(spheres["target_path.speed"])
    assert measure(spheres, "min.spheres.gap") == min(spheres["spheres.gap"])
    assert measure(spheres, "energy_residual") == spheres.energy_residual


def test_a_check_in_the_wrong_unit_is_refused(tmp_path, spheres):
    scenario = load_scenario(written(tmp_path, GOOD.replace("0.3 m/s", "0.3 m")))
    with pytest.raises(InputError, match=r"impacts\.0\.speed.*m/s"):
        validate(scenario, spheres)


def test_a_check_of_an_unknown_name_is_refused(tmp_path, spheres):
    scenario = load_scenario(written(tmp_path, GOOD.replace("impacts.0.speed", "final.target.speed")))
    with pytest.raises(InputError, match=r"target_path\.speed"):
        validate(scenario, spheres)


def test_all_faults_of_a_file_come_at_once(tmp_path):
    text = """
scene = "two_spheres"
duration = "0.1 kg"
accuracy = 2.0
method = "euler"
unknown = 1
[parameters]
mass = "2 furlongs per fortnight"
[[checks]]
quantity = "impacts.first.speed"
expected = "0.3 m/s"
source = "x"
"""
    with pytest.raises(InputError) as caught:
        load_scenario(written(tmp_path, text))
    places = {fault.where for fault in caught.value.faults}
    assert places == {"duration", "accuracy", "method", "unknown", "parameters.mass", "checks.0.quantity"}


@pytest.mark.parametrize("duration", ["-1 s", "0 s", "1", "nan s", "inf s", "5 mm"])
def test_durations_are_positive_times(tmp_path, duration):
    with pytest.raises(InputError, match="duration"):
        load_scenario(written(tmp_path, GOOD.replace("0.1 s", duration)))


@pytest.mark.parametrize(
    "form", ["tolerance = 1e-3", 'expected = "0 m/s"\ntolerance = 1e-3', 'expected = "1 m/s"\nat_most = "1 m/s"']
)
def test_a_check_has_one_complete_form(tmp_path, form):
    with pytest.raises(InputError, match="checks"):
        load_scenario(written(tmp_path, GOOD.replace('expected = "0.3 m/s"\ntolerance = 1e-9', form)))


@pytest.mark.parametrize("target", ["nowhere", "nowhere.toml"])
def test_a_missing_scenario_is_bad_input(target, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match="nowhere"):
        load_scenario(target)


def test_text_that_is_no_toml_is_bad_input(tmp_path):
    with pytest.raises(InputError, match="TOML"):
        load_scenario(written(tmp_path, "scene = "))
