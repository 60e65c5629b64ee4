"""`hertzwerk rigid`: what it prints, draws and refuses."""

import json

import pytest
from click.testing import CliRunner

from hertzwerk.runtime.cli import main

BALL = ("rigid", "bouncing_ball", "--restitution", "floor=restitution", "--duration", "0.5 s")


def called(*words: str) -> tuple[int, str, str]:
    result = CliRunner().invoke(main, words)
    return result.exit_code, result.stdout, result.stderr


def test_rigid_prints_draws_and_compares(tmp_path):
    picture = tmp_path / "rigid.png"
    code, text, _ = called(*BALL, "--out", str(picture))
    assert code == 0 and picture.stat().st_size > 10_000
    assert "4.42945" in text and "3.9865" in text  # sqrt(2 g h), and 0.9 of it
    record = json.loads(called(*BALL, "--stiffness", "stiffness", "--factors", "0.1, 1", "--json")[1])
    assert [each["factor"] for each in record["stiffer"]] == [0.1, 1]
    impact = record["impacts"][0]
    assert impact["separation"] == pytest.approx(0.9 * impact["speed"], rel=1e-12)


def test_rigid_lists_every_fault(tmp_path):
    code, _, error = called(*BALL, "--friction", "flor=0.1", "--input", "a=1", "--out", str(tmp_path))
    assert code == 2
    assert all(fault in error for fault in ("flor=0.1", "--input", "--out"))
