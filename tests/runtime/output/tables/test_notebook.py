"""What notebooks show of results: short, whole, and text that stays text."""

from dataclasses import replace
from html.parser import HTMLParser

import sympy as sp
from each import each

from hertzwerk.derive import LAWS, Parameter, audit_catalogue, audit_scene, laws
from hertzwerk.runtime import Solution, load, simulate
from hertzwerk.runtime.engine.model.build import scene_from
from hertzwerk.runtime.studies.sweeps.rows.row import Row
from hertzwerk.runtime.studies.sweeps.sweep_table import COMPLETE, Sweep


class Cells(HTMLParser):
    """Texts and tags of a page."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags, self.texts, self.open = [], [], []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.open += [tag] if tag != "img" else []

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def test_a_run_reports_outcome_parameters_and_impacts(tmp_path):
    run = simulate(load("bouncing_ball"), duration="3 s", tolerance=1e-6, parameters={"restitution": 0.6})
    assert len(run.impacts) > 8
    assert repr(run).startswith("<Solution bouncing_ball: finished: 3 s in ")
    assert len(repr(run)) < 160
    for shown in (run, Solution.load(run.save(tmp_path / "run.npz"))):
        page = Cells(shown._repr_html_())
        assert not page.open
        assert {"restitution", "0.6 1", f"{run.impacts[0].peak_force:.4g}"} < set(page.texts)
        assert page.texts.count("floor") == 8
        assert f"and {len(run.impacts) - 8} more impacts" in page.texts
        assert {"script", "link", "img"}.isdisjoint(page.tags)


def test_texts_of_a_result_are_no_tags():
    run = simulate(load("pendulum"), duration="0.1 s", tolerance=1e-6)
    page = replace(run, engine=run.engine.with_warning("<script>alert(1)</script> & more"))._repr_html_()
    assert "script" not in Cells(page).tags
    assert "<script>alert(1)</script> & more" in Cells(page).texts


def test_a_sweep_shows_its_first_rows():
    rows = tuple(Row(i, {"gap": f"{i} mm"}, "finished", values={"gap": i * 1e-3}) for i in range(12))
    columns = {"gap": "m", "outcome": ""}
    sweep = Sweep("two_spheres", rows, columns, ("gap",), COMPLETE)
    assert repr(sweep) == "<Sweep two_spheres: 12 rows (12 finished)>"
    page = Cells(sweep._repr_html_())
    assert not page.open
    assert page.texts[3:7] == [": 12 rows (12 finished)", "gap [m]", "outcome", "0"]
    assert page.tags.count("tr") == 11
    assert "0.009" in page.texts
    assert "0.01" not in page.texts
    assert "and 2 more rows" in page.texts


def test_a_scene_and_a_model_show_all_that_they_declare():
    scene = scene_from("slider_crank")
    page = Cells(scene._repr_html_())
    assert not page.open
    for part in (*scene.mechanism.joints, *scene.mechanism.pairs, *scene.effects, *scene.parameters.values()):
        assert part.name in page.texts
    assert {"ground → crank", "rod and slider", "0.3", "kg"} < set(page.texts)
    assert (
        "<b>" not in scene.named("other", "<b> & more").summary
        or "<b> & more" in Cells(scene.named("other", "<b> & more")._repr_html_()).texts
    )
    model = load("slider_crank")
    page = Cells(model._repr_html_())
    assert not page.open
    assert page.tags.count("img") == 1
    assert {*model.parameters, *(name for name, _, _ in model.engine.module.EFFECTS)} < set(page.texts)


@each("name", LAWS)
def test_every_law_shows_formulas_symbols_and_source(name):
    page = Cells(LAWS[name]._repr_html_())
    assert not page.open
    assert LAWS[name].source in "".join(page.texts)
    assert "code" not in page.tags or name in PLAIN
    assert page.tags.count("math") >= len(LAWS[name].parameters)


PLAIN = ()  # laws with an expression whose LaTeX has no MathML


def test_laws_with_values_and_audits_are_shown():
    e = Parameter("restitution", "1", 0.8)
    assert "restitution/2" in Cells(laws.flores(e=e / sp.Integer(2))._repr_html_()).texts
    findings = audit_scene(scene_from("slider_crank"))
    page = Cells(findings._repr_html_())
    assert f"{len(findings)} findings, all consistent" in page.texts
    assert page.texts.count("consistent") == sum(finding.verdict == "consistent" for finding in findings)
    assert len(findings) > 8
    page = Cells(audit_catalogue()._repr_html_())
    assert not page.open
    assert any("repaired as goldsmith_m3" in text for text in page.texts)
