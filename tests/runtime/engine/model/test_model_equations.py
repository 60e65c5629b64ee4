"""Equations for people at the command line and from a model: nothing written, derived anew from the scene the model was loaded from."""

import json
import pickle
from pathlib import Path

import pytest
from commands import called

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model

OWN = """
from dataclasses import replace
from hertzwerk.derive import Parameter
from hertzwerk.derive.scenes.bouncing_ball import scene as ball
gravity = replace(ball.effect("gravity"), acceleration=Parameter("moon", "m/s^2", 1.62))
scene = ball.replace(gravity=gravity).named("on_the_moon")
"""


@pytest.fixture
def hertzwerk(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / ".cache"))
    return called


def test_show_prints_markdown_or_json_and_writes_nothing(hertzwerk):
    result = hertzwerk("derive", "bouncing_ball", "two_spheres", "--show")
    assert "# bouncing_ball" in result.stdout
    assert "# two_spheres" in result.stdout
    assert r"m \ddot{y}_{\mathrm{vertical}} && \text{inertia}" in result.stdout
    assert list(Path.cwd().iterdir()) == []
    result = hertzwerk("derive", "bouncing_ball", "--show", "--json")
    (record,) = json.loads(result.stdout)["equations"]
    equations = [equation for section in record["sections"] for equation in section["equations"]]
    shown = engine_model("bouncing_ball").equations()
    assert [e["latex"] for e in equations] == [e.latex for e in shown.equations]
    assert equations[0]["terms"][1] | {"latex": ""} == {
        "left": False, "meaning": "gravity", "effect": "gravity", "latex": "", "text": "-gravity*mass",
    }  # fmt: skip
    assert {e["name"]: e["enters"] for e in record["effects"]}["gravity"][0] == equations[0]["number"]
    assert result.exit_code == 0


@pytest.mark.parametrize(
    ("arguments", "found"),
    [
        (("--show", "--check"), "--check"), (("--show", "--out", "somewhere"), "--out"), (("--json",), "--json without --show"),
        (("--show", "no_scene", "nor_this"), "nor_this"),
    ],
)  # fmt: skip
def test_bad_input_says_so(hertzwerk, arguments, found):
    result = hertzwerk("derive", "bouncing_ball", *arguments, code=2)
    assert found in result.stderr
    assert result.stdout == ""
    assert list(Path.cwd().iterdir()) == []


def test_a_model_shows_the_scene_it_was_loaded_from(tmp_path):
    plain = engine_model("slider_crank").equations()
    varied = engine_model("slider_crank", without=["slider_pin_friction"], laws={"slider_pin": "flores"}).equations()
    assert "slider_pin_friction" in [effect.name for effect in plain.effects]
    assert "slider_pin_friction" not in [effect.name for effect in varied.effects]
    assert varied["slider_pin_hysteresis_factor"].text != plain["slider_pin_hysteresis_factor"].text
    own = tmp_path / "moon.py"
    own.write_text(OWN)
    model = engine_model(own)
    own.write_text("scene = None")  # the model keeps the scene it was made of
    assert "moon" in model.equations()["row vertical"].text
    assert "moon" in engine_model(model.declaration.scene()).equations()["row vertical"].text


def test_the_handbook_shows_an_equation_as_it_is():
    page = Path(__file__).parents[4] / "runtime" / "handbook" / "howto" / "exchange" / "read-the-equations.md"
    excerpt = page.read_text(encoding="utf-8").split("\n$$\n")[1]
    assert excerpt == engine_model("slider_crank").equations()["row crank_pin"].latex


def test_a_model_of_a_built_in_scene_can_be_sent_to_another_process_and_one_without_its_scene_says_what_to_do():
    declaration = engine_model("slider_crank", without=["gravity"]).declaration
    assert pickle.loads(pickle.dumps(declaration)) == declaration
    saved = EngineModel(engine_model("bouncing_ball").module)  # as Solution.load makes it
    with pytest.raises(InputError, match=r"a model without its scene.*\n.*hertzwerk derive bouncing_ball --show"):
        saved.equations()
