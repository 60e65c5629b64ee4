"""`hertzwerk rigid`: what it prints, draws and refuses."""

import json

import pytest
from commands import called

BALL = ("rigid", "bouncing_ball", "--restitution", "floor=restitution", "--duration", "0.5 s")


def test_rigid_prints_draws_and_compares(tmp_path):
    picture = tmp_path / "rigid.png"
    text = called(*BALL, "--out", str(picture)).stdout
    assert picture.stat().st_size > 10_000
    assert "4.42945" in text and "3.9865" in text  # sqrt(2 g h), and 0.9 of it
    record = json.loads(called(*BALL, "--stiffness", "stiffness", "--factors", "0.1, 1", "--json").stdout)
    assert [each["factor"] for each in record["stiffer"]] == [0.1, 1]
    impact = record["impacts"][0]
    assert impact["separation"] == pytest.approx(0.9 * impact["speed"], rel=1e-12)


def test_rigid_lists_every_fault(tmp_path):
    error = called(*BALL, "--friction", "flor=0.1", "--input", "a=1", "--out", str(tmp_path), code=2).stderr
    assert all(fault in error for fault in ("flor=0.1", "--input", "--out"))
