"""`hertzwerk laws`: the list, the sheet of a law; exit codes and JSON."""

import json

import pytest


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
        (("--stub", "flores"), "it alone"),
    ],
)
def test_bad_input(hertzwerk, tmp_path, arguments, said):
    done = hertzwerk("laws", *arguments, code=2)
    assert said in done.output
    assert list(tmp_path.iterdir()) == []


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
