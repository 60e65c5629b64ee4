"""`hertzwerk statics`, `modes` and `run --start equilibrium`: what they print, write and refuse."""

import json
import math

import pytest
from commands import called


def test_statics_prints_and_draws_and_a_run_starts_at_rest(tmp_path):
    picture = tmp_path / "rest.png"
    text = called("statics", "bouncing_ball", "--set", "mass=2 kg", "--out", str(picture)).stdout
    assert "at rest" in text and "19.62" in text
    assert picture.read_bytes().startswith(b"\x89PNG")
    error = called(
        "statics", "bouncing_ball", "--out", str(picture), "--set", "mass=2 m", "--at", "soon", code=2
    ).stderr
    assert "exists" in error
    text = called("statics", "ball_between_walls", "--json").stdout
    record = json.loads(text)
    assert record["outcome"]["name"] == "not_unique" and record["indifferent"] == ["track.travel"]
    text = called("statics", "woodpecker", code=1).stdout
    assert "nothing holds" in text and "value" not in text
    text = called("run", "bouncing_ball", "--start", "equilibrium", "--duration", "1 ms", "--json").stdout
    assert json.loads(text)["outcome"] == "finished"
    called("run", "--continue", str(tmp_path), "--start", "equilibrium", code=2)


def test_modes_prints_numbers(tmp_path):
    picture = tmp_path / "modes.png"
    text = called("modes", "pendulum", "--json", "--out", str(picture)).stdout
    record = json.loads(text)
    assert record["stable"] and picture.exists()
    assert record["modes"][0]["frequency"] == pytest.approx(math.sqrt(9.81) / (2 * math.pi))
    text = called("modes", "pendulum", "--nearest", "--set", "start_angle=178 deg").stdout
    assert "unstable" in text and "grows by e in 0.319275 s" in text


def test_shapes_stand_in_columns_of_amplitude_and_phase_that_is_0_or_180_deg_for_rounding():
    """`modes slider_crank` said "crank_pin.angle 4.473e-06 at 51.5 deg rad"."""
    text = called("modes", "slider_crank").stdout
    assert "; 2 modes" in text
    rows = [line.split() for line in text.splitlines()]
    first = rows.index(["mode", "coordinate", "amplitude", "unit", "phase", "[deg]"]) + 1
    assert [len(row) for row in rows[first : first + 4]] == [5, 4, 5, 4]
    assert rows[first + 1] == ["guide.travel", "1", "m", "0"]
    for (name, amplitude, unit, phase), x in zip(
        (row[-4:] for row in rows[first : first + 2]),
        json.loads(called("modes", "slider_crank", "--json").stdout)["modes"][0]["shape"].values(),
        strict=True,
    ):
        turned = float(amplitude) * math.e ** (1j * math.radians(float(phase)))
        assert turned == pytest.approx(complex(*x), rel=1e-3), (name, unit)
    assert "; 1 mode\n" in called("modes", "pendulum").stdout
    # A double pendulum without damping swings in phase or against it: -6e-15 and -180 deg were printed.
    rows = [line.split() for line in called("modes", "double_pendulum").output.splitlines()]
    begin = rows.index(["mode", "coordinate", "amplitude", "unit", "phase", "[deg]"]) + 1
    assert [row[-1] for row in rows[begin : begin + 4]] == ["0", "0", "180", "0"]


@pytest.mark.parametrize("scene", ["spatial_slider_crank", "journal_lubricated", "ball_in_socket"])
def test_statics_shows_no_negative_zero(scene):
    """A drive was held by "-0 N m", a ball lay at -5.7e-42 m."""
    text = called("statics", scene, "--json").stdout
    values = [row["value"] for row in json.loads(text)["values"]]
    assert 0 in values
    assert all(math.copysign(1, value) == 1 for value in values if abs(value) < 1e-30)
