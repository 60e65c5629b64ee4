"""Reports of studies and sweeps: from what their commands wrote, nothing else read, everything escaped."""

import csv
import json

import pytest
from commands import called
from matplotlib.figure import Figure
from pages import Outline

from hertzwerk.runtime.output.reports.html_page import Origin
from hertzwerk.runtime.output.reports.sweep_report import sweep_page
from hertzwerk.runtime.studies.sweeps.sweep_table import COMPLETE, Sweep
from hertzwerk.runtime.system.digests import sealed

SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><path d="M 0 0"/><script>alert(1)</script></svg>'
HOSTILE = "</style><script>alert(1)</script> & <b>"
TABLE = {"name": "t", "title": "Table", "header": [["a", "m/s^2"], ["b", ""]]}
TABLE |= {"rows": [[2.5, HOSTILE], [None, "y"], [1.25, "z"]]}
FIGURES = ("Figure", "f.svg", HOSTILE), ("Away", "../away.svg", "")
STUDY = {
    "title": f"A title {HOSTILE}", "question": HOSTILE, "command": f"hertzwerk study '{HOSTILE}'", "versions": {HOSTILE: HOSTILE},
    "paragraphs": [HOSTILE], "lacking": [f"`{HOSTILE}` {HOSTILE}"],
    "verdicts": [{"text": f"x: 1 {HOSTILE}", "source": HOSTILE, "holds": holds} for holds in (True, False, None)], "tables": [TABLE],
    "figures": [dict(zip(("title", "path", "note"), each, strict=True)) for each in FIGURES],
}  # fmt: skip


@pytest.fixture
def report(own_folder):

    return called


def test_a_study_has_its_verdicts_figures_and_tables(report, tmp_path):
    folder = tmp_path / "study"
    folder.mkdir()
    (folder / "study.json").write_text(json.dumps(sealed(STUDY)))
    (folder / "f.svg").write_text(SVG)
    (tmp_path / "away.svg").write_text(SVG)
    report("report", "study")
    page = (folder / "report.html").read_text("utf-8")
    outline = Outline(page)
    assert len(outline.texts["script"]) == len(outline.texts["svg"]) == 1
    assert outline.tables["Table"] == [[["a [m/s2]", "b"], ["2.5", HOSTILE], ["", "y"], ["1.25", "z"]]]
    assert "1 of 2 comparisons hold" in page
    assert [text.split()[0] for text in outline.texts["li"] if " x: 1" in text] == ["holds", "fails", "found"]
    assert any("../away.svg is not in the folder of the record" in text for text in outline.texts["p"])
    assert STUDY["command"] in outline.texts["pre"]
    assert HOSTILE in outline.texts["code"]


@pytest.mark.parametrize("broken", [{}, {**STUDY, "tables": 3}, {**STUDY, "figures": [1]}, {**STUDY, "verdicts": None}])
def test_a_folder_that_is_no_study_is_refused(report, tmp_path, broken):
    (tmp_path / "study").mkdir()
    (tmp_path / "study" / "study.json").write_text(json.dumps(sealed(broken)))
    assert "expected a record that `hertzwerk study` wrote" in report("report", "study", code=2).output
    assert not (tmp_path / "study" / "report.html").exists()


def test_a_folder_that_does_not_exist_is_no_file_and_no_scene(report):
    for name in ("runs/ball-001", "ball-001"):
        output = report("report", name, code=2).output
        assert f"{name}: found no folder or scene" in " ".join(output.split())


@pytest.mark.parametrize(("alike", "keys"), [(0, ["mass"]), (1, ["same_0", "mass"]), (3, ["row"])])
def test_more_columns_than_fit_are_tables_side_by_side(alike, keys):
    """Every number once, seven columns at most beside what tells the rows apart: their first ones, or their numbers."""
    outputs, same = [f"final.x{i}" for i in range(14)], [f"same_{i}" for i in range(alike)]
    columns = {**dict.fromkeys([*same, "mass"], "kg"), "outcome": "", **dict.fromkeys(outputs, "m"), "message": ""}
    rows = [[*[7.0] * alike, float(i), "finished", *(i + j / 100 for j in range(14)), ""] for i in (1, 2)]
    page = sweep_page("s", COMPLETE, columns, rows, {}, [], [], {}, Origin("x"), "table.csv", lambda: Figure())
    tables = Outline(page).tables["Rows"]
    heads = [[name.partition(" [")[0] for name in head] for head, *_ in tables]
    assert all(head[: len(keys)] == keys and len(head) <= 7 for head in heads)
    others = [*([] if "mass" in keys else [*same, "mass"]), "outcome", *outputs]
    assert [name for head in heads for name in head[len(keys) :]] == others
    actual = [cell for _, _, second in tables for cell in second[len(keys) :]]
    assert [float(cell) for cell in actual[-14:]] == pytest.approx([2 + j / 100 for j in range(14)])


def test_warnings_that_rows_share_are_stated_once_and_values_in_their_units(report, tmp_path):
    """Three clearances given in mm: one warning of speeds in all rows, one of a restitution in those that have it."""
    over = ("--over", "clearance=0.1..0.5 mm:3", "--over", "restitution=0.5,0.9")
    how = ("--duration", "1 rev", "--tolerance", "1e-4", "--output", "slider_pin.impact_rate", "--out", "rows")
    done = report("sweep", "slider_crank", *over, *how, "--workers", "1")
    text = " ".join(done.output.split())
    assert "6 rows have warnings (column `warnings`)" in text
    assert "output slider_pin.impact_rate not determined: fewer than two intervals" in text
    assert " none " not in text
    report("report", "rows", "--out", "rows.html")
    outline = Outline((tmp_path / "rows.html").read_text("utf-8"))
    head, *rows = outline.tables["Rows"][0]
    assert {float(row[head.index("clearance [mm]")]) for row in rows} == {0.1, 0.3, 0.5}
    (restitution,) = (text for text in outline.texts["li"] if "restitution = 0.5" in text)
    (speeds,) = (text for text in outline.texts["li"] if "impacts of slider_pin exceed" in text)
    assert "3 rows: " in restitution
    worst = Sweep.load(tmp_path / "rows").rows[int(speeds.partition(", worst in row ")[2].partition(":")[0])]
    assert "6 rows" in speeds
    assert worst.stated["clearance"] == (0.5, "mm")
    assert any(warning in speeds for warning in worst.warnings)
    head, *rows = outline.tables["Rows"][-1]
    numbers = [row[head.index("warnings")].split(", ") for row in rows]
    for text, having in ((restitution, 3), (speeds, 6)):
        assert sum(text[1 : text.index(")")] in each for each in numbers) == having


def test_a_sweep_has_its_rows_and_definition(report, tmp_path):
    over = ("--over", "drop_height=0.2,0.5 m", "--over", "mass=1,-1 kg")
    how = ("--duration", "0.5 s", "--tolerance", "1e-5", "--output", "floor.peak_force", "--out", "rows")
    report("sweep", "soft_ball", *over, *how, code=1)
    report("report", "rows", "--out", "rows.html")
    outline = Outline((tmp_path / "rows.html").read_text("utf-8"))
    head, *rows = outline.tables["Rows"][0]
    assert len(rows) == 4
    names = [name.partition(" [")[0] for name in head]
    forces = [row[names.index("floor.peak_force")] for row in rows]
    with (tmp_path / "rows" / "table.csv").open(newline="") as file:
        stored = [row["floor.peak_force [N]"] for row in csv.DictReader(file)]
    assert [bool(force) for force in forces] == [True, False, True, False]
    assert [float(force) for force in forces if force] == pytest.approx(
        [float(x) for x in stored if x != "nan"], rel=1e-4
    )
    assert {"Picture", "Rows", "Ranges", "Definition", "Origin"} <= set(outline.texts["h2"])
    settings = dict(row for row in outline.tables["Definition"][0][1:])
    assert (
        settings["over"] == "drop_height = 0.2, 0.5 m; mass = 1.0, -1.0 kg"
        and settings["outputs"] == "floor.peak_force"
    )
    assert {"digest of the module", "digest of the histories beside it"} <= settings.keys()
    assert any("Outputs of soft_ball" in text for text in outline.texts["figcaption"])
    assert "hertzwerk sweep --resume rows" in outline.texts["pre"]
    assert [*zip(outline.texts["dt"][1:], outline.texts["dd"][1:], strict=True)] == [
        ("finished", "2"),
        ("bad input", "2"),
    ]
