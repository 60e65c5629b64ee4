"""Pages of studies: what they refuse, how they are written, and the command that makes them."""

import json
import shlex
import shutil
import sqlite3
from contextlib import closing

import numpy as np
import pytest

from hertzwerk.runtime import Sweep
from hertzwerk.runtime.cli.page_folder import markdown
from hertzwerk.runtime.studies.paper import study_page
from hertzwerk.runtime.studies.paper.plot_page import figure
from hertzwerk.runtime.studies.paper.study_page import (
    NAMES,
    Axis,
    Chart,
    Curve,
    Page,
    Panel,
    Table,
    Verdict,
    compared,
    laid_over,
    study_of,
)
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps

FILE = """
from hertzwerk.runtime.studies.paper.study_page import Page, Study, compared

def run(quick, progress, sweeps):
    return Page("Own", (f"quick: {quick}",), verdicts=(compared("one", 1.0, LIMIT, 0.1, "me"),))

study = Study("own", "Is one near two?", run)
"""


COMMAND = ("study",)


def page(**fields):
    options = {"title": "A page", "paragraphs": ("word " * 40,), **fields}
    return Page(**options)


def chart(labels):
    x = np.linspace(1, 10, 5)
    curves = tuple(Curve(label, x, x * (k + 1), half_width=x / 10) for k, label in enumerate(labels))
    return Chart(
        "lines", "Lines", (Panel("a", Axis("x", "m"), Axis("y", "N", log=True), curves, marks=((2, "here"),)),)
    )


def test_parts_of_pages():
    assert compared("x", 1.0009, 1.0, 1e-3, "a source").holds
    assert not compared("x", 1.0011, 1.0, 1e-3, "a source").holds
    assert not compared("x", float("nan"), 1.0, 1e-3, "a source").holds
    assert page(verdicts=(Verdict("found", "s"), Verdict("holds", "s", True))).holds
    assert not page(verdicts=(Verdict("found", "s"), Verdict("fails", "s", False))).holds
    with pytest.raises(ValueError, match="row of 1 cells"):
        Table("t", "T", (("a", ""), ("b", "m")), ((1,),))
    with pytest.raises(ValueError, match="equal lengths"):
        Curve("c", [1, 2], [1])
    table = Table("t", "T", (("a", "m"), ("b", ""), ("c", "")), ((1 / 3, None, "text"),))
    text = markdown(page(tables=(table,), lacking=("gone " * 30,), verdicts=(Verdict("found " * 30, "here"),)))
    assert all(len(line) <= 80 for line in text.splitlines())
    assert "| 0.3333 |  | text |" in text
    assert table.csv() == "a [m],b,c\n0.3333333333333333,,text\n"


def drawn(axis, curve):
    (found,) = figure(Chart("c", "C", (Panel("p", Axis("x"), axis, (curve,)),))).axes
    found.figure.draw_without_rendering()
    return found


@pytest.mark.parametrize("x", [[1], [1, 2]])
def test_intervals_end_where_their_quantity_does(x):
    """Also that of a single point, which is no band."""
    counts = Curve("a", x, [0.1] * len(x), half_width=[0.3] * len(x), look="both")
    for least, expected in ((0.0, 0.0), (-np.inf, -0.2)):
        (interval,) = drawn(Axis("n", least=least), counts).collections
        assert min(path.vertices[:, 1].min() for path in interval.get_paths()) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("y", [[0.81, 1.05], [3, 6], [5, 50], [2e3, 2e6], [1e-3, 1e7]])
def test_a_logarithmic_axis_has_numbers_enough(y):
    axis = drawn(Axis("y", log=True), Curve("a", [0, 1], y))
    low, high = axis.get_ylim()
    said = [t.get_text() for v, t in zip(axis.get_yticks(), axis.get_yticklabels(), strict=True) if low <= v <= high]
    assert len(said) > 2
    assert all(said)
    assert not any("e+" in text for text in said)


@pytest.mark.parametrize("count", [1, 3, 12])
def test_a_legend_names_every_curve_and_lies_over_none(count):
    labels = [f"law {k}" for k in range(count)]
    drawn = figure(chart(labels))
    drawn.draw_without_rendering()
    (axis,) = drawn.axes
    legends = [*drawn.legends, *filter(None, [axis.get_legend()])]
    if count == 1:
        assert legends == []
        return
    (legend,) = legends
    assert [text.get_text() for text in legend.get_texts()] == labels
    assert not legend.get_window_extent().overlaps(axis.get_window_extent())
    assert not legend.get_window_extent().overlaps(axis.title.get_window_extent())
    styles = {(line.get_color(), line.get_linestyle()) for line in axis.lines if line.get_label() in labels}
    assert len(styles) == count


def test_the_list(hertzwerk):
    done = hertzwerk()
    assert [line.split()[0] for line in done.stdout.splitlines() if line[0] != " "] == list(NAMES)  # others go on
    assert all(study_of(name).name == name for name in NAMES)
    assert "did you mean exponents" in hertzwerk("exponent", code=2).output


def test_a_study_of_ones_own_is_written_once(hertzwerk, tmp_path):
    (tmp_path / "own.py").write_text(FILE.replace("LIMIT", "2.0"))
    done = hertzwerk("own.py", "--json", code=1)
    assert json.loads(done.stdout)["verdicts"][0]["holds"] is False
    assert not (tmp_path / "runs").exists()
    (tmp_path / "own.py").write_text(FILE.replace("LIMIT", "1.05"))
    done = hertzwerk("own.py", "--quick", "--out", "here")
    record = json.loads((tmp_path / "here" / "study.json").read_text())
    assert record["command"] == "hertzwerk study own.py --quick"
    assert record["paragraphs"] == ["quick: True"]
    assert record["verdicts"][0]["holds"] is True
    assert "versions" in record
    assert "never overwrites" in hertzwerk("own.py", "--quick", "--out", "here", code=2).output
    hertzwerk("own.py")
    assert (tmp_path / "runs" / "own-study-001" / "study.md").is_file()


@pytest.mark.parametrize(
    ("content", "said"), [("study = 3", "`study` of type int"), ("", "no `study`"), ("1/0", "ZeroDivisionError")]
)
def test_files_without_a_study_are_refused(hertzwerk, tmp_path, content, said):
    (tmp_path / "own.py").write_text(content)
    assert said in hertzwerk("own.py", code=2).output


def damage_a_row(folder):
    """Change a digit of what a sweep keeps of its third row, as SQLite itself would write it."""
    with closing(sqlite3.connect(folder / "rows.sqlite")) as rows, rows:
        here = "key = (SELECT key FROM points WHERE number = 2)"
        assert rows.execute(f"UPDATE rows SET outputs = replace(outputs, '0', '1') WHERE {here}").rowcount == 1


SWEPT = """
from contextlib import closing
from pathlib import Path
from hertzwerk.runtime.studies.paper.study_page import Page, Study, Table

def counted(run):
    with open("computed", "a") as file:
        file.write(".")
    return run.engine.t_end

def run(quick, progress, sweeps):
    def stop(fraction):
        if fraction > 0.4 and not Path("again").exists():
            raise KeyboardInterrupt
    over = {"drop_height": "0.3..0.5 m:8"}
    found = sweeps("drops", "bouncing_ball", over, functions={"x": counted}, duration="0.2 s", workers=1, progress=stop)
    return Page("Swept", (), tables=(Table("drops", "Drops", (("x", "s"),), tuple((x,) for x in found["x"])),))

study = Study("swept", "Which rows are kept?", run)
"""


MEASURED = """
from hertzwerk.runtime.studies.paper.study_page import Axis, Chart, Curve, Page, Panel, Study, Verdict

def run(quick, progress, sweeps):
    panel = Panel("a", Axis("time", "ms", history="t"), Axis("a", "m/s^2", history="guide.acceleration"), (Curve("run", [0, 1], [0, 1]),))
    return Page("Beside", (), charts=(Chart("beside", "Beside", (panel,)),), verdicts=(Verdict("it was drawn", "this test", True),))

study = Study("beside", "How does it look?", run, {"guide.acceleration": "m/s^2"})
"""


def test_a_measurement_is_read_by_the_options_of_the_command(hertzwerk, tmp_path, monkeypatch):
    drawn = []
    monkeypatch.setattr(study_page, "laid_over", lambda *about: drawn.append(laid_over(*about)) or drawn[-1])
    (tmp_path / "beside.py").write_text(MEASURED)
    (tmp_path / "bench.csv").write_text("made by hand\nZeit;CH 2\n0,0;1,5\n0,5;-99\n1,0;2,5\n")
    reading = ["--columns", "guide.acceleration=CH 2", "--units", "Zeit=ms", "--units", "CH 2=km/s^2", "--missing=-99"]
    assert "units={'Zeit'" in hertzwerk("beside.py", "--measured", "bench.csv", code=2).output
    hertzwerk("beside.py", "--out", "here", "--measured", "bench.csv", *reading)
    record = json.loads((tmp_path / "here" / "study.json").read_text())
    expected = ["--measured", "bench.csv", *reading[2:6], *reading[:2], "--missing", "-99"]
    assert shlex.split(record["command"])[3:] == expected
    assert "beside.png" in [path.name for path in (tmp_path / "here").iterdir()]
    (page,) = drawn
    _, measured = page.charts[0].panels[0].curves
    np.testing.assert_allclose([measured.x, measured.y], [[0, 1], [1500, 2500]])
    assert "--measured: found none, and options" in hertzwerk("beside.py", *reading, code=2).output


@pytest.mark.parametrize("kept", [True, False, "damaged"])
def test_a_study_that_is_stopped_keeps_its_rows_and_goes_on(hertzwerk, tmp_path, kept):
    (tmp_path / "swept.py").write_text(SWEPT)
    stopped = hertzwerk("swept.py", "--quick", code=1)
    folder = tmp_path / "runs" / "swept-study-001"
    assert "hertzwerk study --resume runs/swept-study-001" in stopped.stdout
    assert [path.name for path in folder.iterdir()] == ["rows"]
    assert len(Sweep.load(folder / "rows" / "drops")) == 4
    beside = hertzwerk("--resume", "runs/swept-study-001", "--quick", "swept.py", code=2)
    assert "NAME, --quick beside it" in beside.output
    if not kept:  # what is counted would show it
        shutil.rmtree(folder / "rows" / "drops")
    if kept == "damaged":
        damage_a_row(folder / "rows" / "drops")
    (tmp_path / "again").touch()
    done = hertzwerk("--resume", "runs/swept-study-001")
    assert (tmp_path / "computed").read_text() == "." * {True: 8, False: 12, "damaged": 9}[kept]
    actual = "drops: rows.sqlite was damaged: 7 rows of it are whole; row 2 damaged"
    assert (actual in " ".join(done.stdout.split())) == (kept == "damaged")
    assert len(json.loads((folder / "study.json").read_text())["damage"]) == (kept == "damaged")
    assert json.loads((folder / "study.json").read_text())["command"].endswith("swept.py --quick")
    assert len((folder / "drops.csv").read_text().splitlines()) == 9
    assert "whose study is done" in hertzwerk("--resume", "runs/swept-study-001", code=2).output
    assert "study that was stopped" in hertzwerk("--resume", "nowhere", code=2).output


CASES = """
from hertzwerk.runtime.loading import load
from hertzwerk.runtime.simulation import simulate
from hertzwerk.runtime.studies.paper.study_page import Page, Study, Table
from hertzwerk.runtime.studies.paper.study_sweeps import until_stopped, whole

def height(case):
    def stop(fraction):
        if case == 3:
            raise KeyboardInterrupt  # as where Ctrl-C strikes during a run, which then ends as interrupted
    return case, whole(simulate(load("bouncing_ball"), duration="0.2 s", progress=stop)).engine.t_end

def run(quick, progress, sweeps):
    rows, missing = until_stopped([1, 2, 3, 4], height, progress)
    return Page("Cases", (), tables=(Table("cases", "Cases", (("case", ""), ("end", "s")), tuple(rows)),), missing=missing)

study = Study("cases", "Which cases are done?", run)
"""


def test_a_study_that_is_stopped_writes_the_cases_that_are_done(hertzwerk, tmp_path):
    (tmp_path / "cases.py").write_text(CASES)
    done = hertzwerk("cases.py", "--out", "here", code=1)
    assert "interrupted" in done.stdout
    assert "2 of 4 cases are done" in done.stdout
    cases = (tmp_path / "here" / "cases.csv").read_text()
    assert [row.split(",")[0] for row in cases.splitlines()] == ["case", "1", "2"]
    assert "**Incomplete**" in (tmp_path / "here" / "study.md").read_text()
    assert "2 of 4" in json.loads((tmp_path / "here" / "study.json").read_text())["missing"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "rows"),
    [*(pytest.param(name, 1, marks=pytest.mark.exhaustive) for name in ("exponents", "stiffness")), ("bouncing", 2)],
)
def test_a_built_in_study_that_is_stopped_draws_what_it_has(name, rows):
    """Its whole page is made from the first cases: tables, figures, verdicts."""
    left = [rows + (name != "bouncing")]  # calls of progress; those two tell of another stage first

    def stop(fraction):
        left[0] -= 1
        if not left[0]:
            raise KeyboardInterrupt

    page = study_of(name).run(True, stop, Sweeps())
    assert f"{rows} of " in page.missing
    assert page.holds
    assert page.tables[-1].rows
    for chart in page.charts:
        figure(chart).draw_without_rendering()
