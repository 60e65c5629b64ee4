"""`hertzwerk statics`, `modes` and `run --start equilibrium`: what they print, write and refuse."""

import json
import math

import pytest
from click.testing import CliRunner

from hertzwerk.runtime.cli import main


def called(*words: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(main, words)
    return result.exit_code, result.stdout, result.stderr


def test_statics_prints_and_draws(tmp_path):
    picture = tmp_path / "rest.png"
    code, text, _ = called("statics", "bouncing_ball", "--set", "mass=2 kg", "--out", str(picture))
    assert code == 0 and "found" in text and "19.62" in text
    assert picture.read_bytes().startswith(b"\x89PNG")
    code, _, error = called("statics", "bouncing_ball", "--out", str(picture), "--set", "mass=2 m", "--at", "soon")
    assert code == 2
    assert "exists" in error
    code, text, _ = called("statics", "ball_between_walls", "--json")
    found = json.loads(text)
    assert code == 0 and found["outcome"]["name"] == "not_unique" and found["indifferent"] == ["track.travel"]


def test_modes_prints_numbers(tmp_path):
    picture = tmp_path / "modes.png"
    code, text, _ = called("modes", "pendulum", "--json", "--out", str(picture))
    found = json.loads(text)
    assert code == 0 and found["stable"] and picture.exists()
    assert found["modes"][0]["frequency"] == pytest.approx(math.sqrt(9.81) / (2 * math.pi))
    code, text, _ = called("modes", "pendulum", "--nearest", "--set", "start_angle=178 deg")
    assert code == 0 and "unstable" in text and "grows by e in 0.319275 s" in text


def test_a_run_starts_at_rest(tmp_path):
    code, text, error = called("run", "bouncing_ball", "--start", "equilibrium", "--duration", "1 ms", "--json")
    assert code == 0, error
    assert json.loads(text)["outcome"] == "finished"
    code, _, error = called("run", "--continue", str(tmp_path), "--start", "equilibrium")
    assert code == 2
