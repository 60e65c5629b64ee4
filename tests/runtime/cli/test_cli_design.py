"""Commands propagate and minimise: what they print, files that define them, bad input."""

import json
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from commands import called
from pages import Outline

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime.studies.sweeps.definition_file import read_definition_file
from hertzwerk.runtime.studies.uncertainty.propagation import propagate
from hertzwerk.runtime.system.digests import sealed

FILE = """
target = "bouncing_ball"
duration = "0.4 s"
tolerance = 1e-8
outputs = ["final.vertical.speed"]
sample = 8
[uncertain]
gravity = "Normal(9.81 m/s^2, 0.2 m/s^2)"
"""
MINIMUM = """
target = "bouncing_ball"
objective = "(final.vertical.travel - 0.8*drop_height)**2"
duration = "0.4 s"
tolerance = 1e-8
[over]
gravity = "1..12 m/s^2"
"""


@pytest.fixture
def file(tmp_path):
    def write(text):
        (tmp_path / "definition.toml").write_text(text)
        return str(tmp_path / "definition.toml")

    return write


def test_propagate_by_options_and_by_file(file, tmp_path):
    options = ("--uncertain", "gravity=Normal(9.81 m/s^2, 0.2 m/s^2)", "--output", "final.vertical.speed", "--sample", "8",
               "--duration", "0.4 s", "--tolerance", "1e-8")  # fmt: skip
    kept = tmp_path / "kept"
    reported = called(
        "propagate", "bouncing_ball", *options, "--table", str(tmp_path / "found.csv"), "--out", str(kept)
    )
    assert "standard deviation by derivatives 0.08 m/s" in reported.output
    assert (tmp_path / "found.csv").exists()
    called("report", str(kept))
    outline = Outline((kept / "report.html").read_text("utf-8"))
    (head, spread) = outline.tables["Spread"][0]
    assert spread[0] == "final.vertical.speed" and float(spread[head.index("std by derivatives")]) == pytest.approx(
        0.08, rel=1e-4
    )
    assert {"Picture", "Contributions", "Origin"} <= set(outline.texts["h2"])
    with closing(sqlite3.connect(kept / "rows.sqlite")) as rows, rows:  # a digit of one number
        here = "key = (SELECT key FROM points WHERE number = 2)"
        rows.execute(f"UPDATE rows SET outputs = replace(outputs, '9', '8') WHERE {here}")
    reported = called("propagate", "bouncing_ball", *options, "--out", str(kept))
    assert "rows of it are whole; row 2 damaged" in " ".join(reported.output.split())
    assert "row 2 damaged" in json.loads((kept / "propagation.json").read_text())["damage"]
    assert "damage" not in called("propagate", "bouncing_ball", *options, "--out", str(kept)).output
    one, other = (
        json.loads(called("propagate", *of, "--json").output) for of in (("bouncing_ball", *options), (file(FILE),))
    )
    assert one == other
    assert one["outputs"]["final.vertical.speed"]["linear"] == pytest.approx(0.08, rel=1e-6)


def test_files_of_a_definition_are_named_from_its_folder(file, tmp_path):
    stated = Path(file(f'laws = {{ floor = "pads.toml:foam" }}\n{FILE}'))
    with pytest.raises(InputError, match=str(tmp_path / "pads.toml")):
        read_definition_file(stated, propagate)


def test_minimise_by_options_and_by_file(file, tmp_path):
    options = ("--objective", "(final.vertical.travel - 0.8*drop_height)**2", "--over", "gravity=1..12 m/s^2",
               "--duration", "0.4 s", "--tolerance", "1e-8")  # fmt: skip
    one, other = (
        json.loads(called("minimise", *of, "--json").output) for of in (("bouncing_ball", *options), (file(MINIMUM),))
    )
    assert one == other
    assert one["outcome"] == "finished"
    bounded = called("minimise", "bouncing_ball", *options, "--constraint", "gravity >= 20 m/s^2", code=1)
    assert "infeasible" in bounded.output
    kept = tmp_path / "kept"
    lightly = (*options, "--constraint", "gravity >= 0.5 m/s^2")
    called("minimise", "bouncing_ball", *lightly, "--out", str(kept))
    called("minimise", "bouncing_ball", *options, "--out", str(kept), code=2)
    called("report", str(kept))
    outline = Outline((kept / "report.html").read_text("utf-8"))
    assert outline.tables["Values"][0][1][0] == "gravity"
    assert outline.tables["Constraints"][0][1][-1] == "is kept"
    assert len(outline.tables["Runs"][0]) == 1 + len(json.loads((kept / "minimum.json").read_text())["trials"])
    record = (kept / "minimum.json").read_text()
    (kept / "minimum.json").write_text(record.replace("1", "3", 1))
    assert "digest does not fit" in " ".join(called("report", str(kept), "--overwrite", code=2).output.split())
    (kept / "minimum.json").write_text(json.dumps(sealed({})))
    assert "a record that `hertzwerk minimise` wrote" in called("report", str(kept), "--overwrite", code=2).output


@pytest.mark.parametrize(
    ("arguments", "places"),
    [
        (("propagate", "bouncing_ball", "--uncertain", "gravity=Gauss(1)", "--uncertain", "mass"), ("--uncertain", "mass")),
        (("propagate", "bouncing_ball", "--uncertain", "gravity=Normal(1 s)", "--sample", "7"), ("gravity", "sample")),
        (("minimise", "bouncing_ball", "--over", "mass=1"), ("over['mass']", "objective")),
        (("minimise", "bouncing_ball", "--objective", "mass", "--constraint", "mass"), ("--constraint",)),
    ],
)  # fmt: skip
def test_bad_options_are_reported_at_once(arguments, places):
    reported = called(*arguments, "--duration", "0.1 s", code=2)
    assert all(place in reported.output for place in places)


def test_bad_files_are_reported_at_once(file):
    reported = called("propagate", file("target = 3\nsampel = 8\n"), code=2)
    assert all(place in reported.output for place in ("sampel", "sample", "uncertain", "duration", "target"))
    called("propagate", file(FILE), "--sample", "8", code=2)
    reported = called(
        "minimise",
        file(MINIMUM.replace("[over]", 'max_runs = "3"\nlaws = {roof = "flores"}\n[over]\nmass = true')),
        code=2,
    )
    assert all(place in reported.output for place in ("max_runs", "over", "roof"))
