"""Reports of runs: the numbers of the run, everything escaped, nothing fetched, the same page again."""

import json
from dataclasses import replace
from types import SimpleNamespace

import pytest
from commands import called
from pages import Outline

from hertzwerk.runtime import Solution, simulate
from hertzwerk.runtime.engine.model.build import scene_from
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.output.reports import run_report
from hertzwerk.runtime.system.digests import sealed

HOSTILE = "</style><script>window.alerted = 1</script><img src=x onerror=alert(1)> & \"q\" 'a' $x^{$"
UNPRINTABLE = f"{HOSTILE}\x00\ud800"


@pytest.fixture(scope="module")
def ball():
    return simulate(engine_model("soft_ball"), duration="1 s", accuracy=1e-6, parameters={"drop_height": "0.5 m"})


@pytest.fixture(scope="module")
def page(ball):
    return run_report.run_page(ball)


def column(table, name):
    j = [head.partition(" [")[0].strip() for head in table[0]].index(name)
    return [row[j] for row in table[1:]]


def test_a_page_has_the_numbers_of_its_run(ball, page):
    outline = Outline(page)
    (impacts,), (parameters,) = outline.tables["Impacts"], outline.tables["Parameters"]
    assert "1 of" in page
    assert column(parameters, "the model's own")[column(parameters, "parameter").index("drop_height")] == "1 m"
    own = zip(column(parameters, "parameter"), column(parameters, "the model's own"), strict=True)
    assert [name for name, value in own if value] == ["drop_height"]
    forces = [float(text) for text in column(impacts, "peak force")]
    (scale,) = ({"N": 1, "kN": 1e3}[impacts[0][4].partition("[")[2].rstrip("]")],)
    assert forces == pytest.approx([impact.peak_force / scale for impact in ball.impacts], rel=1e-4)
    assert len(outline.texts["math"]) > 20
    assert page.count("<svg") == 3
    assert str(ball.error) in outline.texts["dd"]
    assert (
        "simulate(load('soft_ball'), duration=1.0, accuracy=1e-06, parameters={'drop_height': '0.5 m'})"
        in outline.texts["pre"]
    )


def test_names_on_a_page_are_its_own_nothing_is_fetched_and_two_pages_are_the_same(page, ball):
    outline = Outline(page)
    assert len(outline.ids) == len(set(outline.ids))
    assert outline.references
    inside = {f"#{name}" for name in outline.ids}
    assert [r for r in outline.references if r not in inside and not r.startswith("data:image/png;base64,")] == []
    assert "http" not in page.replace("http-equiv", "")
    assert "default-src &#x27;none&#x27;" in page
    assert run_report.run_page(ball) == page


def test_hostile_texts_stay_texts(ball):
    model = engine_model(scene_from("soft_ball").named("soft_ball", HOSTILE))
    run = simulate(model, duration="0.5 s", tolerance=1e-6)
    outcome = replace(run.outcome, name="event_limit", message=UNPRINTABLE, remedy=UNPRINTABLE)
    run = replace(run, engine=run.engine.with_warning(UNPRINTABLE), outcome=outcome)
    outline = Outline(run_report.run_page(run))
    assert len(outline.texts["script"]) == 1
    assert "img" not in outline.texts
    seen = HOSTILE + "\N{REPLACEMENT CHARACTER}" * 2
    assert seen in outline.texts["li"]
    assert [text for text in outline.texts["p"] if HOSTILE in text] == [HOSTILE, seen, seen]


@pytest.fixture
def no_pictures(monkeypatch):
    """Pages without them, which take nine tenths of their time."""
    monkeypatch.setattr(run_report, "_pictures", lambda *_: [])


def test_long_tables_say_where_the_whole_is(ball, no_pictures):
    findings = {"impacts": ball.impacts * 250, "energy_residual": None, "choices": (), "lasting": (), "needs": ()}
    many = replace(ball, engine=replace(ball.engine, findings=SimpleNamespace(**findings)))
    page = run_report.run_page(many, whole="there.npz")
    (table,) = Outline(page).tables["Impacts"]
    assert len(table) == 1 + run_report.MOST
    assert "The first 200 of" in page


def test_a_picture_that_fails_is_missing_alone(ball, monkeypatch):
    def fail(*_):
        raise RuntimeError("<no ink>")

    monkeypatch.setattr("hertzwerk.runtime.output.plots.plot_run.overview", fail)
    page = run_report.run_page(ball)
    assert "The picture overview could not be made: RuntimeError: &lt;no ink&gt;" in page
    assert page.count("<svg") == 2


def test_saved_runs_have_equations_where_their_declaration_is_at_hand(ball, tmp_path, no_pictures):
    ball.save(tmp_path / "run.npz")
    saved = Solution.load(tmp_path / "run.npz")
    page = run_report.run_page(saved)
    alone = Outline(page)
    assert "math" not in alone.texts
    assert any("does not contain its scene" in text for text in alone.texts["p"])
    assert len(Outline(run_report.run_page(saved, model=engine_model("soft_ball"))).texts["math"]) > 20
    assert saved.report(tmp_path / "x.html").read_text("utf-8") == page
    with pytest.raises(FileExistsError, match="exists"):
        saved.report(tmp_path / "x.html")


def test_the_command_reports_a_run_folder_with_the_command_that_made_it(own_folder):
    given = (
        "soft_ball", "--set", "drop_height=0.5 m", "--without", "energy_ledger", "--duration", "0.5 s", "--no-plots",
    )  # fmt: skip
    called("run", *given)
    called("report", "runs/soft_ball-001")
    page = (own_folder / "runs/soft_ball-001/report.html").read_text("utf-8")
    made = "hertzwerk run soft_ball --set 'drop_height=0.5 m' --without energy_ledger --duration '0.5 s' --no-plots"
    outline = Outline(page)
    assert made in outline.texts["pre"]
    assert len(outline.texts["math"]) > 20
    assert "energy_ledger" not in column(outline.tables["Effects"][0], "effect")
    assert "casadi" in page
    assert "which exists" in called("report", "runs/soft_ball-001", code=2).output
    record = json.loads((own_folder / "runs/soft_ball-001/run.json").read_text())
    record["request"]["target"] = str(own_folder / "never.py")  # a file is executed only where it is named
    (own_folder / "never.py").write_text("raise SystemExit(7)")
    (own_folder / "runs/soft_ball-001/run.json").write_text(json.dumps(sealed(record)))
    called("report", "runs/soft_ball-001", "--out", "b.html")
    assert "does not contain its scene" in (own_folder / "b.html").read_text("utf-8")


def test_the_command_reports_a_scene(own_folder):
    called("report", "soft_ball")
    outline = Outline((own_folder / "soft_ball.html").read_text("utf-8"))
    assert {"Picture", "Parameters", "Equations"} <= set(outline.texts["h2"])
    (own_folder / "empty").mkdir()
    for wrong in ("sof_ball", "empty"):
        called("report", wrong, code=2)
