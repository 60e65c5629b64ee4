"""`hertzwerk fit`: report, JSON, files, exit codes, and all faults before it runs."""

import json

import matplotlib.image
import numpy as np
import pytest
from commands import called

from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.system.digests import sealed

HOW = ("--map", "height=vertical.travel", "--noise", "height=1 mm", "--starts", "2")


COMMAND = ("fit", "bouncing_ball")


@pytest.fixture(scope="module")
def texts():
    """Heights of two drops of a ball [mm], with noise."""
    found, rng, t = {}, np.random.default_rng(3), np.linspace(0.05, 0.75, 40)
    for name, height in (("one.csv", 1.0), ("two.csv", 0.6)):
        run = simulate(
            load("bouncing_ball"), duration="0.8 s", tolerance=1e-10, parameters={"drop_height": (height, "m")}
        )
        heights = 1e3 * run.at(t)["vertical.travel"] + rng.normal(0, 1, len(t))
        rows = [f"{a:.9g},{b:.9g}" for a, b in zip(t, heights, strict=True)]
        found[name] = "\n".join(["time [s],height [mm]", *rows])
    return found


@pytest.fixture
def data(tmp_path, texts):
    for name, text in texts.items():
        (tmp_path / name).write_text(text)


def test_options_say_how_files_are_read(hertzwerk, data):
    how = (
        "--units", "height=furlong", "--units", "time=h", "--decimal", ",", "--columns", "height=7", "--missing", "x",
    )  # fmt: skip
    done = hertzwerk("--measured", "one.csv", *how, *HOW, "--free", "restitution=0.3..1", code=2)
    assert "found no column 7; expected a number from 1 to 2" in done.output
    for others in (how[:-4], (*how[:-4], "--moment", "height.rms", "--duration", "1 s")):
        done = hertzwerk(
            "--measured", "one.csv", *others, "--map", "height=vertical.travel", "--free", "restitution=0.3..1", code=2
        )
        assert "'furlong'" in done.output, done.output


def test_two_runs_and_their_files(hertzwerk, data, tmp_path):
    both = ("--measured", "one.csv", "--measured", "two.csv", "--at", "two.csv:drop_height=0.6 m")
    done = hertzwerk(*both, *HOW, "--free", "restitution=0.3..1", "--out", "fitted")
    for expected in (
        "restitution   0.", "linear: curvature", "explains the residuals", "fitted/ (fit.json, fit.csv, fit.png)",
    ):  # fmt: skip
        assert expected in done.output
    content = json.loads((tmp_path / "fitted" / "fit.json").read_text())
    value = content["values"]["restitution"]
    assert value["interval"]["low"] < 0.9 < value["interval"]["high"] and content["command"].startswith("hertzwerk fit")
    assert len((tmp_path / "fitted" / "fit.csv").read_text().splitlines()) == 81
    assert matplotlib.image.imread(tmp_path / "fitted" / "fit.png").std() > 0.05
    called("report", "fitted")
    text = (tmp_path / "fitted" / "report.html").read_text()
    for expected in ("explained", "p-value", "linear: curvature", "data:image/png", "Correlation"):
        assert expected in text
    (tmp_path / "fitted" / "fit.json").write_text(json.dumps(sealed({"explained": True, "unidentified": []})))
    broken = called("report", "fitted", "--overwrite", code=2)
    assert "a record that `hertzwerk fit` wrote" in " ".join(broken.output.split())
    again = hertzwerk(*both, *HOW, "--free", "restitution", "--out", "fitted", code=2)
    assert "--out: found fitted, which has other content" in again.output


def test_json_alone_writes_nothing_and_an_undetermined_fit_is_another_outcome(hertzwerk, data, tmp_path):
    done = hertzwerk(
        "--measured", "one.csv", *HOW, "--free", "restitution=0.3..1", "--free", "stiffness=1e9..1e12 N/m^1.5", "--profile", "none", "--json", code=1,
    )  # fmt: skip
    content = json.loads(done.output)
    assert content["unidentified"] and content["explained"] is True
    assert not (tmp_path / "runs").exists()


def test_every_fault_in_one_error(hertzwerk, data):
    done = hertzwerk(
        "--measured", "one.csv", "--map", "hieght=vertical.travel", "--free", "restitutoin=0.3..1", "--at", "three.csv:mass=1 kg",
        "--offset", "2..1 ms", "--starts", "-1", code=2
    )  # fmt: skip
    for part in ("did you mean height", "did you mean restitution", "three.csv", "the lower end first", "starts"):
        assert part in done.output


def test_laws_and_statistics(hertzwerk, data, tmp_path):
    bad = hertzwerk(
        "--measured", "one.csv", *HOW, "--free", "restitution", "--laws", "floor=flores,no_such_law", "--laws", "roof=flores", code=2,
    )  # fmt: skip
    assert "no_such_law" in bad.output
    neither = hertzwerk("--free", "restitution", code=2)
    assert "--measured: found none, and no --moment" in neither.output
    beside = hertzwerk(
        "--measured", "one.csv", "--moment", "floor.impulse=8.86 +- 0.1 N", "--free", "drop_height=0.7..1.5 m",
        "--offset", "1 ms", "--starts", "3", "--profile", "none", code=2,
    )  # fmt: skip
    assert "--measured, --offset, --starts, --profile: found beside --moment" in beside.output
    assert "a value in N s" in beside.output
    moment = ("--moment", "floor.impulse=8.859 +- 0.05 N s", "--duration", "0.7 s", "--set", "restitution=1")
    hertzwerk(*moment, "--free", "drop_height=0.7..1.5 m", "--out", "fitted")
    value = json.loads((tmp_path / "fitted" / "fit.json").read_text())["values"]["drop_height"]
    assert abs(value["value"] - 1) < 0.003
