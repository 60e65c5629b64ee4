"""Pages in a real browser, under their own policy: nothing is cut, nothing fetched, tables sort."""

import pytest
from pages import BROWSER, seen

from hertzwerk.derive import LAWS, audit_scene
from hertzwerk.derive.common.markup import Markup, joined
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.model.build import built_in_scenes, scene_from
from hertzwerk.runtime.output.reports.html_page import Origin, Section, page, table
from hertzwerk.runtime.output.reports.model_report import model_page
from hertzwerk.runtime.output.reports.run_report import run_page

pytestmark = pytest.mark.skipif(BROWSER is None, reason="no chromium (apt-get install chromium)")


def test_a_page_is_whole_fetches_nothing_and_sorts(tmp_path):
    run = simulate(load("slider_crank"), duration="6 ms", tolerance=1e-7)
    actual = seen(run_page(run), tmp_path)
    assert actual["cut"] == []
    assert (actual["fetched"], actual["violations"]) == ([], [])
    before, up, down = actual["sorted"]["Impacts/peak force [kN]"]
    assert before != up
    assert up == sorted(before, key=float)
    assert down == up[::-1]
    before, up, _ = actual["sorted"]["Parameters/parameter"]
    assert up == sorted(before)


def test_faults_of_a_page_are_found(tmp_path):
    rows = [["b", 2.0], ["a", 10.0], [Markup(f"<b style='white-space: pre'>{'wide ' * 400}</b>"), 1.0]]
    formula = Markup(f"<math><mi>{'x' * 300}</mi></math>")
    content = joined(
        [table([("text", ""), ("number", "")], rows), formula, Markup("<img src='http://127.0.0.1:9/x.png'>")]
    )
    bad = page("run", "a", "", Markup("<script>window.alerted = 1</script>"), [Section("One", content)], Origin("x"))
    actual = seen(bad, tmp_path)
    assert actual["sorted"]["One/number"][1:] == [["1", "2", "10"], ["10", "2", "1"]]
    assert any("wide" in text for text in actual["cut"])
    assert any("xxx" in text for text in actual["cut"])
    assert actual["alerted"] == 0  # the policy holds back what is no script of the page's own
    assert {text.split()[0] for text in actual["violations"]} == {"script-src-elem", "img-src"}


def test_a_table_of_many_columns_fits_a_sheet_of_paper(tmp_path):
    many = [(f"penetration {part}", "km/s^2") for part in "abcdefg"]
    heads = [("n", ""), ("outcome", ""), *many, ("penetration/clearance", "")]
    rows = [[1.5, "energy_not_closed", *[1.2345e-10] * 7, 0.01232]] * 3
    wide = page("study", "a", "", Markup(""), [Section("One", table(heads, rows))], Origin("x"))
    assert seen(wide, tmp_path)["cut"] == []


IN_CI = ("slider_crank",)


@pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=pytest.mark.slow if n in IN_CI else pytest.mark.exhaustive) for n in built_in_scenes()],
)
def test_equations_of_every_scene_fit(name, tmp_path):
    assert seen(model_page(load(name).engine), tmp_path)["cut"] == []


def test_output_of_a_notebook_fits_its_cell(tmp_path):
    scene, model = scene_from("slider_crank"), load("slider_crank")
    run = simulate(model, duration="12 ms")
    shown = (scene, model, run, audit_scene(scene), *LAWS.values())
    sections = [Section(f"Cell {k}", Markup(thing._repr_html_())) for k, thing in enumerate(shown)]
    actual = seen(page("run", "notebook", "", Markup(""), sections, Origin("x")), tmp_path)
    assert actual["cut"] == []
    assert actual["fetched"] == []
