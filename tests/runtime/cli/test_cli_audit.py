"""`hertzwerk audit`: expressions, the catalogue, files and folders; verdicts, JSON and exit codes."""

import json

import pytest

FOAM = """
[[law]]
name = "foam"
kind = "stiffness"
form = "any"
title = "Foam pad"
source = "measured"
force = "K*d**{exponent}"
symbols.K = {{ unit = "N/m^1.5", meaning = "stiffness" }}
"""


@pytest.mark.parametrize(
    ("options", "code", "said"),
    [
        (("--unit", "K=N/m**1.5", "--unit", "d=m", "--value", "n=1.5", "--expect", "N"), 0, "consistent"),
        (("--unit", "K=N/m**1.5", "--unit", "d=m", "--value", "n=1.1", "--expect", "N"), 1, "only with n = 3/2"),
        (("--unit", "K=N/m^n", "--unit", "d=m", "--unit", "n=1", "--expect", "N"), 0, "consistent"),
        (("--unit", "K=N/m^1.5", "--unit", "d=m", "--value", "n=2"), 0, "N m^0.5"),
        (("--unit", "K=Hz", "--unit", "d=m", "--value", "n=1"), 2, "rpm"),
        (("--unit", "K=N/m", "--value", "n=1"), 2, "d"),
    ],
)
def test_one_expression(hertzwerk, options, code, said):
    assert said in hertzwerk("audit", "--expr", "K*d**n", *options, code=code).output


def test_json_of_one_expression_and_advice_on_a_frequency(hertzwerk):
    done = hertzwerk(
        "audit", "--expr", "E*sqrt(R)*d", "--unit", "E=Pa", "--unit", "R=m", "--unit", "d=m", "--expect", "N", "--json", code=1,
    )  # fmt: skip
    (finding,) = json.loads(done.output)["findings"]
    assert (finding["verdict"], finding["found"], finding["expected"]) == ("inconsistent", "N/m^0.5", "N")
    assert finding["consistent_exponent"] == "3/2"
    assert {"law", "kind", "source", "subexpression", "reason", "repair"} <= finding.keys()
    done = hertzwerk("audit", "--expr", "J*f**2", "--unit", "J=kg m^2", "--unit", "f=1/s", "--expect", "J")
    assert "advice        J*f**2 takes f [1/s] as an angular speed: write 2*pi*f if it counts turns" in done.output
    assert "advice" not in hertzwerk("audit", "--expr", "w*t", "--unit", "w=rad/s", "--unit", "t=s").output


def test_the_catalogue_has_the_verdicts_it_states(hertzwerk, monkeypatch):
    done = hertzwerk("audit", "--laws", "--json")
    verdicts = {finding["law"]: finding["verdict"] for finding in json.loads(done.output)["findings"]}
    assert verdicts["bai_zhao"] == "inconsistent"
    assert verdicts["pereira_internal"] == "outside_si"
    assert verdicts["hertz_point"] == "consistent"
    assert (
        "R" in hertzwerk("audit", "--laws").output.split("wang_liu_internal")[0].split()[-1]
    )  # the grade stands beside the name
    monkeypatch.setattr(
        "hertzwerk.derive.exchange.user_files.audit_files.differing_verdicts", lambda findings: ("hertz_point",)
    )
    hertzwerk("audit", "--laws", code=1)


def test_law_files_and_scenes_without_laws_are_audited(hertzwerk, tmp_path):
    (tmp_path / "good.toml").write_text(FOAM.format(exponent="1.5"))
    hertzwerk("audit", "good.toml")
    (tmp_path / "bad.toml").write_text(FOAM.format(exponent="1.1").replace('"foam"', '"foam_2"'))
    done = hertzwerk("audit", ".", code=1)
    assert "K*d**1.1" in done.output
    hertzwerk("audit", "good.toml")
    # The table was empty, and the program was not mentioned in a file of the user's own.
    done = hertzwerk("audit", "pendulum")
    expected = "consistent 0 law expressions, and every assignment and output of the program"
    assert " ".join(done.output.split()) == expected


def test_files_of_a_folder_that_define_a_scene_are_executed_and_no_others(hertzwerk, tmp_path):
    (tmp_path / "beside.py").write_text("import os, hertzwerk.derive\n\nscene = 1 / 0\n")
    (tmp_path / "plain.py").write_text("import hertzwerk\n\nnames = [scene for scene in 'ab']\nopen('run', 'w')\n")
    assert "beside.py" in hertzwerk("audit", ".", code=2).output
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize(
    "arguments",
    [(), ("slider_crank", "--laws"), ("slider_crank", "--expect", "N"), ("nowhere.toml",), ("no_such_scene",)],
)
def test_bad_input_exits_2(hertzwerk, arguments):
    hertzwerk("audit", *arguments, code=2)


PENDULUM = """
from hertzwerk.derive import GROUND, Body, Contact, Mechanism, Parameter, PinInBush, Planar, Revolute, Scales, Scene, Start, Z, laws

length, clearance, mass = Parameter("length", "mm", 200), Parameter("clearance", "mm", 0.1), Parameter("mass", "kg", 1)
upper, lower = (Body(name, mass, mass * length**2) for name in ("upper", "lower"))
elbow = PinInBush("elbow", upper.at(0, -length, 0), lower.at(0, 0, 0), Z, Parameter("bush", "mm", 8), clearance)
joints = Revolute("shoulder", GROUND, upper, Z), Planar("plane", GROUND, lower)
scene = Scene(
    Mechanism("loose", joints, (elbow,)),
    (Contact("elbow", laws.power(Parameter("K", "N/m", 1e7), n=1)),),
    Scales(clearance, Parameter("pace", "m/s", 1), arm=length),
    Start({start}),
)
"""


@pytest.mark.parametrize(
    ("start", "found"),
    [
        ("", "start, positions: found under-determined: shoulder.angle, plane.x; expected 1 more value among them"),
        ('{"shoulder": Parameter("at", "deg", 20)}', None),
    ],
)
def test_a_start_from_which_no_run_begins_is_a_finding(hertzwerk, tmp_path, start, found):
    """With free positions the audit stated `consistent`, and the run was refused."""
    (tmp_path / "loose.py").write_text(PENDULUM.replace("{start}", start))
    code = 0 if found is None else 1
    said = hertzwerk("audit", "loose.py", code=code)
    assert (found or "every assignment") in said.output
    record = json.loads(hertzwerk("audit", "loose.py", "--json", code=code).output)["findings"][-1]
    assert (record["verdict"], record["kind"]) == (
        ("consistent", "stiffness") if found is None else ("refused", "start")
    )
    if start == "":
        assert "in the scene's Start, or `initial`" in said.output
        assert "::error file=loose.py" in hertzwerk("audit", "loose.py", "--format", "github", code=1).output
