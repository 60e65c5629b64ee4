"""`hertzwerk laws`: the list, the sheet of a law, the restitution study with its picture; exit codes and JSON."""

import json

import pytest

from hertzwerk.runtime.analysis.validation import restitution
from hertzwerk.runtime.analysis.validation.plot_restitution import figure


@pytest.fixture
def study(restitutions):
    return restitutions


@pytest.fixture
def studied(study, monkeypatch):
    monkeypatch.setattr(restitution, "study", lambda progress=None: study)


def test_the_list(hertzwerk):
    done = hertzwerk("laws")
    rows = done.output.splitlines()
    assert any(row.split()[:4] == ["johnson", "stiffness", "A", "consistent"] for row in rows)
    assert any(row.split()[:4] == ["wang_liu_internal", "stiffness", "R", "consistent"] for row in rows)
    listed = json.loads(hertzwerk("laws", "--json").output)["laws"]
    assert {
        "kind": "damping", "law": "tsuji", "title": "Tsuji, Tanaka and Ishida", "made for": "any contact",
        "grade": "A", "verdict": "consistent", "memory": "",
    } in listed  # fmt: skip
    assert {
        **{row["law"]: row["memory"] for row in listed}, "flores": "v0", "tsuji": "", "kelvin_voigt": "", "lugre": "z",
    } == {row["law"]: row["memory"] for row in listed}  # fmt: skip
    assert len(listed) == len(rows) - 3


def test_sheets_as_text_and_json(hertzwerk):
    done = hertzwerk("laws", "wang_liu_secant", "lankarani_nikravesh", "goldsmith")
    for said in (
        "R: reconstruction: the expression of the paper was not available", "made for pin_in_bush",
        r"F = \frac{\pi E_{\mathrm{eff}} L d \sqrt{\frac{d}{2 d + 2 \Delta R}}}{2}",
        "1e-06            84.6596    1.4990", "h = 3*(1 - e**2)/4",
        "e -> 1        h -> 0, the elastic law; e out -> 1", "e -> 0        h -> 3/4; e out -> 0.663",
        "inconsistent  units, as published", "hertzwerk laws goldsmith_m3",
    ):  # fmt: skip
        assert said in done.output
    (actual,) = json.loads(hertzwerk("laws", "tsuji", "--json").output)["laws"]
    assert actual["restitution"]["coefficient_at_zero"] == "sqrt(5)"
    assert actual["restitution"]["beside"] == "3/2"
    assert actual["exponent"] == "1/4"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("jonson",), "did you mean johnson"),
        (("--restitution", "flores"), "every damping law"),
        (("flores", "--out", "x"), "--restitution beside it"),
    ],
)
def test_bad_input(hertzwerk, tmp_path, arguments, said):
    done = hertzwerk("laws", *arguments, code=2)
    assert said in done.output
    assert list(tmp_path.iterdir()) == []


def test_the_study_as_json(hertzwerk, studied, tmp_path):
    done = hertzwerk("laws", "--restitution", "--json")
    assert json.loads(done.output)["largest_difference"] < 1e-9
    assert list(tmp_path.iterdir()) == []
    hertzwerk("laws", "--restitution", "--json", "--no-plots", "--out", "mine")
    assert {file.name for file in (tmp_path / "mine").iterdir()} == {"restitution.csv", "restitution.json"}
    hertzwerk("laws", "--restitution", "--out", "mine", code=2)  # never overwrites


def test_a_disagreement_is_exit_code_1(hertzwerk, study, monkeypatch):
    from dataclasses import replace

    off = replace(study.curves[0], simulated=study.curves[0].simulated + 2e-9)
    wrong = restitution.Study((off, *study.curves[1:]), study.others)
    monkeypatch.setattr(restitution, "study", lambda progress=None: wrong)
    done = hertzwerk("laws", "--restitution", "--no-plots", code=1)
    assert "different" in done.output


def test_the_picture_shows_every_law_and_range(study, tmp_path):
    """A panel per law with its name, what it does, and its recommended range shaded; no label stands outside the page."""
    page = figure(study)
    page.savefig(tmp_path / "page.png")
    panels = {axis.get_title(loc="left").split()[0]: axis for axis in page.axes}
    for curve in study.curves:
        axis = panels[curve.law]
        (shade,) = axis.patches
        x = shade.get_corners()[:, 0]
        assert (min(x), max(x)) == pytest.approx(curve.recommended)
        dots = axis.lines[-1].get_ydata()
        assert dots == pytest.approx(curve.deviation[curve.inside])
    frame = page.bbox
    for axis in page.axes:
        for text in axis.texts:
            box = text.get_window_extent()
            assert frame.x0 <= box.x0
            assert box.x1 <= frame.x1


def test_the_picture_of_a_band(hertzwerk, tmp_path):
    picture = tmp_path / "band.png"
    done = hertzwerk("laws", "wang_liu_internal", "--picture", str(picture))
    assert "wang_liu_secant" in done.output and str(picture) in done.output.replace("\n", "")
    assert picture.read_bytes().startswith(b"\x89PNG")
    for arguments, said in (
        (("wang_liu_internal", "--picture", str(picture)), "which exists"), (("johnson", "--picture", str(tmp_path / "other.png")), "of grade A"),
        (("--picture", str(tmp_path / "other.png")), "no law"), (("wang_liu_internal", "--picture", str(tmp_path / "other.pdf")), "FILE.png"),
    ):  # fmt: skip
        refused = hertzwerk("laws", *arguments, code=2)
        assert said in " ".join(refused.output.split())
    assert [path.name for path in tmp_path.iterdir()] == ["band.png"]
