"""What notebooks show of results: short, whole, and text that stays text."""

from dataclasses import replace
from html.parser import HTMLParser

from hertzwerk.runtime import Solution, load, simulate
from hertzwerk.runtime.sweeps.sweep_table import COMPLETE, Row, Sweep


class Cells(HTMLParser):
    """Texts and tags of a page."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags, self.texts, self.open = [], [], []
        self.feed(page)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def test_a_run_tells_outcome_parameters_and_impacts(tmp_path):
    run = simulate(load("bouncing_ball"), duration="3 s", tolerance=1e-6, parameters={"restitution": 0.6})
    assert len(run.impacts) > 8
    assert repr(run).startswith("<Solution bouncing_ball: finished: 3000 ms in ")
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
    page = replace(run, warnings=("<script>alert(1)</script> & more",))._repr_html_()
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
