"""`hertzwerk compare`: report, JSON, files, exit codes, and all faults before it runs."""

import json

import matplotlib.image
import numpy as np
import pytest

from hertzwerk.runtime import load, read_measurement, simulate
from hertzwerk.runtime.studies.comparison.filtered_run import FilteredRun, Instrument

HOW = ("--bandwidth", "2 kHz", "--offset", "-1..1 ms", "--noise", "force=20 N")


COMMAND = ("compare",)


@pytest.fixture(scope="module")
def text():
    """Force of a ball's impact behind an instrument, with noise and a hole, 0.4 ms early."""
    run = simulate(load("bouncing_ball"), duration="0.47 s", accuracy=1e-6)
    times = 0.44 + 1e-4 * np.arange(250)
    force = FilteredRun(run, ["floor.normal_force"], Instrument(2e3), 1.0).at(times)[:, 0]
    force += np.random.default_rng(1).normal(0, 20, len(times))
    rows = [
        f"{1e3 * t - 0.4:.6f},{'' if i == 3 else f'{f / 1e3:.9f}'}"
        for i, (t, f) in enumerate(zip(times, force, strict=True))
    ]
    return "\n".join(["time [ms],force [kN]", *rows])


@pytest.fixture
def data(tmp_path, text):
    (tmp_path / "data.csv").write_text(text)


def test_the_report_and_its_files(hertzwerk, data, tmp_path):
    done = hertzwerk("bouncing_ball", "--measured", "data.csv", "--map", "force=floor.normal_force", *HOW)
    for expected in (
        "causal, 3 dB down at 2 kHz", "offset 0.39", "249 samples within the run, 1 missing", "explains every residual",
    ):  # fmt: skip
        assert expected in done.output
    folder = tmp_path / "runs" / "bouncing_ball-compare-001"
    assert {file.name for file in folder.iterdir()} == {"comparison.json", "comparison.csv", "comparison.png"}
    assert np.ptp(matplotlib.image.imread(folder / "comparison.png")[..., :3]) > 0.9
    written = read_measurement(folder / "comparison.csv")
    residual = written.columns["force measured"] - written.columns["force run"]
    record = json.loads((folder / "comparison.json").read_text())
    assert np.sqrt(np.nanmean(residual**2)) == pytest.approx(record["signals"][0]["residual"]["rms"])
    assert record["run"]["scene"] == "bouncing_ball" and record["run"]["duration"] < 0.47


def test_a_file_that_states_neither_units_nor_names_is_read_by_options(hertzwerk, text, tmp_path):
    """The numbers of the other file, as a German spreadsheet has them below three lines without a unit."""
    _, *rows = text.split("\n")
    german = "\n".join(rows).replace(",", ";").replace(".", ",").replace(";\n", ";-999\n")
    (tmp_path / "data.csv").write_text(f"Prüfstand;3\nZeit;0\n\nZeit;CH 2\n{german}", encoding="utf-16")
    how = ("--units", "t=ms", "--units", "force=kN", "--columns", "force=CH 2", "--columns", "t=1")
    how = (*how, "--skip-lines", "2", "--decimal", ",", "--missing=-999", "--map", "force=floor.normal_force", *HOW)
    done = hertzwerk("bouncing_ball", "--measured", "data.csv", "--json", *how)
    signal = json.loads(done.output)["signals"][0]
    assert (signal["samples"], signal["missing"]) == (249, 1)


def test_another_start_is_a_difference_and_json_says_so(hertzwerk, data, tmp_path):
    how = ("--map", "force=floor.normal_force", "--set", "mass=1.2 kg", "--json", *HOW)
    done = hertzwerk("bouncing_ball", "--measured", "data.csv", *how, code=1)
    record = json.loads(done.output)
    assert record["differs"] is True and record["signals"][0]["residual"]["explained"] is False
    assert not (tmp_path / "runs").exists()


def test_all_faults_come_before_it_runs_and_help_says_whose_measurement_is_not_to_be_had(hertzwerk, tmp_path):
    (tmp_path / "data.csv").write_text("t [s],force [m]\n0,1\n0,x\n0,2\n")
    wrong = (
        "--map", "force=floor.force", "--bandwidth", "5 rpm", "--offset", "1..0 s", "--set", "mass=1 m", "--noise",
        "force",
    )  # fmt: skip
    done = hertzwerk("bouncing_ball", "--measured", "data.csv", *wrong, code=2)
    for expected in (
        "line 3", "a third time", "'x'", "floor.force", '"5 kHz"', "the lower end first", "mass", "NAME=VALUE",
    ):  # fmt: skip
        assert expected in done.output, (expected, done.output)
    assert not (tmp_path / "runs").exists()
    assert "not to be had" in " ".join(hertzwerk("--help").output.split())
