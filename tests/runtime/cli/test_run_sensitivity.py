"""`hertzwerk run --sensitivity`: derivatives in the run's folder, and names that are none."""

import csv
import json

import pytest
from commands import called
from pages import Outline

from hertzwerk.runtime import load, simulate


def test_derivatives_are_written_beside_the_run(tmp_path):
    requested = ["run", "slider_crank", "--duration", "0.6 ms", "--sensitivity", "restitution", "--no-plots"]
    result = called(*requested, "--out", tmp_path / "run")
    assert "sensitivities.csv" in result.output
    header, *rows = csv.reader((tmp_path / "run" / "sensitivities.csv").read_text().splitlines())
    run = simulate(load("slider_crank"), duration="0.6 ms", sensitivities=("restitution",))
    travel = run.sensitivities()["guide.travel", "restitution"]
    assert float(rows[-1][header.index("d(guide.travel)/d(restitution) [m]")]) == pytest.approx(travel[-1], rel=1e-12)
    record = json.loads((tmp_path / "run" / "run.json").read_text())["sensitivities"]["restitution"]
    assert record["final"]["guide.travel"] == pytest.approx(travel[-1], rel=1e-12)
    assert record["impacts"]["peak_force"] == pytest.approx(run.sensitivities().impacts("peak_force", "restitution"))
    called("report", tmp_path / "run")
    final, impacts = Outline((tmp_path / "run" / "report.html").read_text("utf-8")).tables["Sensitivities"]
    shown = {row[0]: row[1].replace("\N{MINUS SIGN}", "-") for row in final}
    assert float(shown["guide.travel"]) == pytest.approx(travel[-1], rel=1e-4)
    assert len(impacts) == 1 + len(run.impacts)
    assert {row[0]: row[2] for row in final}["guide.travel"] == "m"  # by a number
    again = called("run", "--continue", tmp_path / "run", "--sensitivity", "restitution", code=2)
    assert "a run from its start" in again.output
    result = called("run", "slider_crank", "--duration", "1 ms", "--sensitivity", "restitutio", code=2)
    assert "did you mean restitution" in result.output
