"""Inputs that differ from row to row: files, arrays and functions by label, constants, factors; what they leave out in a study of effects."""

import json
from pathlib import Path

import pytest
from commands import called
from shaken import PUSHED, shaken

from hertzwerk.derive import InputError
from hertzwerk.runtime import Samples, Sweep, simulate, simulate_many, study_effects, sweep
from hertzwerk.runtime.engine.inputs.inputs_by_row import NO_CHOICES, located_choices
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps.definition_file import read_definition_file

TIMES = (0.0, 0.5, 1.0)
LOADS = {"calm": (0.0, 1.0, 0.0), "gusty": (2.0, -3.0, 4.0)}
HOW = {"duration": "1 s", "tolerance": 1e-8, "workers": 1, "compiled": False}
TRAVEL = "final.slide.travel"


@pytest.fixture
def folder(own_folder):
    (own_folder / "pushed.py").write_text(PUSHED)
    for name, loads in LOADS.items():
        rows = "".join(f"{t},{v}\n" for t, v in zip(TIMES, loads, strict=True))
        (own_folder / f"{name}.csv").write_text(f"time [s],push [N]\n{rows}")
    return own_folder


def alone(push, **how):
    """Travel of one run."""
    run = simulate(shaken(), duration="1 s", tolerance=1e-8, compiled=False, inputs={"push": push}, **how)
    return run["slide.travel"][-1]


def test_rows_choose_among_what_simulate_takes_and_are_its_runs(folder):
    def ramp(t):
        return 3 * t

    gusty = Samples(TIMES, LOADS["gusty"], ("s", "N"), "held", source="bench")
    table = sweep(shaken(), {"push": ["calm.csv", ramp, gusty, "2 N"], "damping": "0..1 N s/m:2"}, **HOW)
    assert table["push"].tolist() == [label for label in ("calm.csv", "ramp", "bench", "2 N") for _ in range(2)]
    assert table.axes == {"push": ("calm.csv", "ramp", "bench", "2 N"), "damping": (0.0, 1.0)}
    expected = [alone(push, parameters={"damping": c}) for push in ("calm.csv:push", ramp, gusty, "2 N") for c in ("0 N s/m", "1 N s/m")]  # fmt: skip
    assert table[TRAVEL].tolist() == expected  # bitwise
    assert table.to_xarray()[TRAVEL].sel(push="bench", damping=1.0).item() == expected[5]
    assert "bench" in table.to_csv(folder / "t.csv").read_text() and table.plot().axes


def test_constants_and_factors_are_numbers_like_any_parameter():
    table = sweep(shaken(), {"push": "1..3 N:3", "push.scale": (-1, 0.5)}, zip=False, **HOW)
    assert table["push"].tolist() == [1, 1, 2, 2, 3, 3] and table.unit("push.scale") == ""
    assert table[TRAVEL][2] == pytest.approx(alone("-2 N"), rel=1e-12)
    drawn = sweep(shaken(), {"push.scale": "0.5..1.5"}, sample=3, inputs={"push": (TIMES, LOADS["calm"])}, **HOW)
    for scale, travel in zip(drawn["push.scale"], drawn[TRAVEL], strict=True):
        assert travel == pytest.approx(scale * alone((TIMES, LOADS["calm"])), rel=1e-7)


def test_rows_of_a_store_are_keyed_by_the_values_they_choose(folder):
    over, into = {"push": {"first": "calm.csv:push", "second": "gusty.csv:push:held"}}, folder / "rows"
    made = sweep("pushed.py", over, out=into, **HOW)
    assert Sweep.load(into)["push"].tolist() == ["first", "second"] == made["push"].tolist()
    definition = json.loads((into / "definition.json").read_text())
    assert definition["over"]["push"]["first"] == str(folder / "calm.csv:push")
    called("sweep", "--resume", into)
    renamed = {"push": {"first": "calm.csv:push", "other": "gusty.csv:push:held"}}
    again = sweep("pushed.py", renamed, out=into, widen=True, **HOW)
    assert [row.wall_s for row in again] == [row.wall_s for row in made]  # not computed again
    (folder / "gusty.csv").write_text(
        (folder / "gusty.csv").read_text().replace("4.0", "40.0").replace("-3.0", "-30.0")
    )
    with pytest.raises(InputError, match=r"choices\.push\.other"):
        sweep("pushed.py", renamed, out=into, **HOW)
    assert "choices.push.other" in called("sweep", "--resume", into, code=2).stderr
    other = sweep("pushed.py", renamed, out=into, widen=True, **HOW)
    assert other[TRAVEL][0] == made[TRAVEL][0] and other[TRAVEL][1] != made[TRAVEL][1]
    sweep("pushed.py", {"push": [(TIMES, LOADS["calm"])]}, out=folder / "python", **HOW)
    assert "inputs made in Python: push" in called("sweep", "--resume", folder / "python", code=2).stderr


def test_the_command_line_and_a_file_choose_alike(folder):
    command = ("sweep", "pushed.py", "--over", "push=calm.csv,gusty.csv:push:cubic", "--over", "push.scale=1,2")
    reported = called(*command, "--duration", "1 s", "--tolerance", "1e-8", "--workers", "1", "--json")
    (folder / "inner").mkdir()
    (folder / "inner" / "s.toml").write_text(
        'target = "../pushed.py"\nduration = "1 s"\ntolerance = 1e-8\n[over]\npush = "../calm.csv, ../gusty.csv:push:cubic"\n"push.scale" = [1, 2]\n'
    )
    by_file = sweep(**read_definition_file(folder / "inner" / "s.toml", sweep), workers=1)
    assert by_file["push"].tolist() == ["../calm.csv"] * 2 + ["../gusty.csv:push:cubic"] * 2
    table = json.loads(reported.stdout)["table"]
    assert table[TRAVEL] == by_file[TRAVEL].tolist() and table["push"][::2] == ["calm.csv", "gusty.csv:push:cubic"]
    assert located_choices("0.5..1 N:3", Path("/data")) == "0.5..1 N:3" and located_choices([1, 2], Path("/")) == [1, 2]


def test_sections_and_pictures_of_rows_that_choose(folder):
    over = {"push": {"50 % calm": "calm.csv", "gusty": "gusty.csv"}, "damping": "0..1 N s/m:2"}
    table = sweep("pushed.py", {"push": over["push"]}, grid=3, **HOW)
    lines = table.histories.to_csv(folder / "h.csv").read_text().splitlines()
    assert lines[1].startswith("0,50 % calm,0,") and len(lines) == 7
    assert table.histories.record()["rows"][1]["values"] == {"push": "gusty"}
    drawn = sweep(shaken(), over, **HOW).plot(TRAVEL)
    assert [text.get_text() for text in drawn.axes[0].get_xticklabels()] == ["50 % calm", "gusty"]


def test_many_runs_have_inputs_of_their_own_and_a_name_that_is_no_input_stays_a_value():
    sets = [{"push": (TIMES, LOADS["calm"])}, {"push": "2 N"}, {"push": (TIMES, LOADS["gusty"]), "push.scale": 0.5}, {}]
    table = simulate_many(shaken(), sets, inputs={"push": "1 N"}, duration="1 s", tolerance=1e-8, workers=1)
    assert table["push"].tolist()[:3] == ["samples", "2 N", "samples 2"]
    half = tuple(0.5 * load for load in LOADS["gusty"])
    expected = [alone(push) for push in ((TIMES, LOADS["calm"]), "2 N", (TIMES, half), "1 N")]
    assert table[TRAVEL] == pytest.approx(expected, rel=1e-12)
    bare = simulate_many(shaken(), [{"push": "2 N"}, {"damping": "1 N s/m"}], duration="1 s", tolerance=1e-8, workers=1)
    assert bare.counts() == {"finished": 1, "bad_input": 1} and "no value" in bare.rows[1].message
    model, values = NO_CHOICES.of(shaken(), {"damping": "1 N s/m"})
    assert model is shaken() and values == {"damping": "1 N s/m"}


@pytest.mark.parametrize(
    ("over", "message"),
    [
        ({"push": ["nowhere.csv:load"]}, "nowhere.csv"), ({"push": ["calm.csv:loud", "gusty.csv:push:cubical"]}, "linear, held, cubic"),
        ({"push": "1..2 m:3"}, "input push"), ({"push.scale": "1 N"}, "no value|push.scale"), ({"shove": ["calm.csv"]}, "shove"),
        ({"shove.scale": "1"}, "shove.scale"), ({"push": []}, "no value"),
    ],
)  # fmt: skip
def test_bad_choices_are_reported_at_once(folder, over, message):
    with pytest.raises(InputError, match=message):
        sweep(shaken(), over, **HOW)


def test_effects_are_studied_under_an_input(folder):
    study = study_effects("pushed.py", duration="1 s", inputs={"push": "gusty.csv"}, outputs=["max.slide.travel"])
    changes = {row.effect: row.changes["max.slide.travel"].relative for row in study.rows if row.changes}
    assert study.outcome.finished and abs(changes["motor"]) == pytest.approx(1, rel=1e-6)  # nothing moves without it
    with pytest.raises(InputError, match="input push: found no value"):
        study_effects("pushed.py", duration="1 s")
    with pytest.raises(InputError, match="shove"):
        study_effects("pushed.py", duration="1 s", inputs={"push": "1 N", "shove": "1 N"})
    command = ("effects", "pushed.py", "--input", "push=gusty.csv", "--duration", "0.5 s", "--json")
    called(*command)
    assert engine_model("pushed.py").inputs
