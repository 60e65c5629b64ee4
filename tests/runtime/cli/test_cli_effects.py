"""`hertzwerk effects`: the table, JSON, the picture, and what it refuses."""

import json

import matplotlib.image
import numpy as np
import pytest

from hertzwerk.runtime.analysis.effect_study import leaving_out
from hertzwerk.runtime.analysis.effect_study.plot_effects import figure

COMMAND = ("effects",)


@pytest.fixture(scope="module")
def study():
    return leaving_out.study_effects("bouncing_ball", duration="0.8 s", tolerance=1e-7, within=0.02)


@pytest.fixture
def studied(study, monkeypatch):
    monkeypatch.setattr(leaving_out, "study_effects", lambda target, **options: study)


def test_the_report(hertzwerk, studied, tmp_path):
    done = hertzwerk("bouncing_ball", "--within", "2%")
    rows = {line.split("  ")[0]: line for line in done.output.splitlines()}
    assert "-100 %" in rows["floor"]
    assert "14 of 14" in rows["floor"]
    assert rows["energy_ledger"].count("below error") >= 3
    assert "Smallest scene within 2 %: gravity, floor." in done.output
    assert "scenes tried" in done.output
    folder = tmp_path / "runs" / "bouncing_ball-effects-001"
    assert {file.name for file in folder.iterdir()} == {"effects.json", "effects.png"}
    picture = matplotlib.image.imread(folder / "effects.png")
    assert np.ptp(picture[..., :3]) > 0.9


def test_json_is_plain_and_writes_nothing(hertzwerk, tmp_path):
    done = hertzwerk("pendulum", "--duration", "1 s", "--tolerance", "1e-6", "--within", "0.02", "--json")
    record = json.loads(done.output)
    gravity, ledger = record["rows"]
    assert set(gravity) >= {"effect", "operations", "states", "events", "time_share", "changes", "why"}
    assert gravity["changes"] == {"peak_acceleration": -1.0, "amplitude.hinge.angle": -1.0}
    assert ledger["changes"] == {"peak_acceleration": None, "amplitude.hinge.angle": None}
    assert set(ledger["why"].values()) == {"below error"}
    assert record["smallest"] == ["gravity"]
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--within", "much"), "such as 2%"), (("--within", "120%"), "below 100 %"), (("--tolerance", "fine"), "a number"),
        (("--output", "max.hinge.angel"), "did you mean hinge.angle"), (("--set", "bob_mess=2 kg", "--duration", "1 kg"), "2 faults"),
        (("--without", "spring"), "one of gravity"),
    ],
)  # fmt: skip
def test_bad_input(hertzwerk, tmp_path, arguments, said):
    done = hertzwerk("pendulum", *arguments, code=2)
    assert said in done.output
    assert list(tmp_path.iterdir()) == []


def test_a_scene_that_does_not_run_is_exit_code_1(hertzwerk, tmp_path, monkeypatch, study):
    from dataclasses import replace

    from hertzwerk.runtime.engine.solution.outcome import Outcome

    lost = replace(study, outcome=Outcome("not_finite", "at t = 1 s", "look at the last states"), rows=())
    monkeypatch.setattr(leaving_out, "study_effects", lambda target, **options: lost)
    done = hertzwerk("bouncing_ball", code=1)
    assert "not_finite" in done.output
    assert list(tmp_path.iterdir()) == []


def test_the_picture_has_a_row_for_every_effect_and_shows_what_was_not_seen(study):
    page = figure(study)
    first, *_ = page.axes
    assert [tick.get_text() for tick in first.get_yticklabels()] == [row.effect for row in study.rows]
    panels = {axis.get_title(loc="left").split("\n")[0]: axis for axis in page.axes}
    for output in study.outputs:
        texts = [text.get_text() for text in panels[output.name].texts]
        assert texts.count("below error") == 1
        assert texts.count("−100 %") + texts.count("−100.0 %") >= 1
    page.canvas.draw()
    for axis in page.axes:
        for text in axis.texts:
            box = text.get_window_extent()
            assert page.bbox.x0 <= box.x0, text
            assert box.x1 <= page.bbox.x1, text
