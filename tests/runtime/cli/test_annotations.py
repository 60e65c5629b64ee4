"""`hertzwerk audit --format`: what GitHub and code scanners show, at which file and line; the hooks of pre-commit."""

import json
import re
from pathlib import Path

import pytest
from commands import called

ROOT = Path(__file__).parents[3]
LAWS = """# pads

[[law]]
name = "felt"
kind = "stiffness"
form = "any"
title = "Felt"
source = "measured"
force = "K*d"
symbols.K = { unit = "N/m", meaning = "stiffness" }

[[law]]
name = "foam"
kind = "stiffness"
form = "any"
title = "Foam pad"
source = "measured"
force = "K*d**2"
symbols.K = { unit = "N/m^1.5", meaning = "stiffness" }
"""
LAW = """from hertzwerk.derive import Quantity, StiffnessLaw, laws

d, K = laws.law.d, Quantity("K", "N/m", "stiffness")
pad = StiffnessLaw(
    name="pad", title="100 %, soft", parameters=(K,), force=K * d**2, stored=K * d**3 / 3, forms=("point",), source="measured", grade="C"
)
"""
BROKEN = "from hertzwerk.derive import Scene\n\nscene = Scene(mistake)\n"


@pytest.fixture
def project(own_folder):
    """A scratch repository with sound and wrong laws, in a folder with a blank."""
    (own_folder / "my laws").mkdir()
    (own_folder / "my laws" / "pads.toml").write_text(LAWS)
    (own_folder / "my laws" / "pad.py").write_text(LAW)
    return own_folder


def audit(*words, code=0):
    return called("audit", *words, code=code).output


def test_github_shows_each_finding_at_its_line(project):
    text = audit("my laws", "--format", "github", code=1)
    actual = [
        re.fullmatch(r"::error file=([^,]*),line=(\d+),title=([^:]*)::(.*)", line).groups()
        for line in text.splitlines()
    ]
    assert ("my laws/pads.toml", "18", "foam%2C force") in [each[:3] for each in actual]
    assert {each[:2] for each in actual} == {("my laws/pads.toml", "18"), ("my laws/pad.py", "5")}
    assert all("expected N" in each[3] or "expected J" in each[3] for each in actual)
    (project / "my laws" / "pads.toml").write_text(LAWS.replace("d**2", "d**1.5"))
    assert audit("my laws/pads.toml", "--format", "github") == "\n"


def test_files_that_cannot_be_audited_are_annotated_too(project):
    (project / "broken.py").write_text(BROKEN)
    (project / "my laws" / "pads.toml").write_text(LAWS.replace('"N/m^1.5"', '"N/m^"'))
    text = audit(".", "--format", "github", code=2)
    assert re.search(r"::error file=broken.py,line=3,title=.*::found NameError: name 'mistake' is not defined", text)
    assert re.search(r"::error file=my laws/pads.toml,line=\d+,title=.*foam", text)


REQUIRED = {  # what section 3 of SARIF 2.1.0 requires of the objects that are used
    "log": {"version", "runs"}, "run": {"tool", "results"}, "driver": {"name"}, "rule": {"id"}, "result": {"message", "ruleId", "level", "locations"},
}  # fmt: skip


def test_sarif_has_what_the_standard_requires(project):
    log = json.loads(audit("my laws", "--format", "sarif", code=1))
    assert REQUIRED["log"] <= log.keys()
    assert log["version"] == "2.1.0"
    (run,) = log["runs"]
    assert REQUIRED["run"] <= run.keys()
    assert REQUIRED["driver"] <= run["tool"]["driver"].keys()
    known = [rule["id"] for rule in run["tool"]["driver"]["rules"] if REQUIRED["rule"] <= rule.keys()]
    assert len(run["results"]) >= 2
    for result in run["results"]:
        assert REQUIRED["result"] <= result.keys()
        assert result["ruleId"] in known
        assert result["level"] in ("none", "note", "warning", "error")
        assert result["message"]["text"]
        (place,) = (each["physicalLocation"] for each in result["locations"])
        uri = place["artifactLocation"]["uri"]  # a URI reference, RFC 3986
        assert uri in ("my%20laws/pads.toml", "my%20laws/pad.py")
        assert place["region"]["startLine"] >= 1
    assert json.loads(audit("my laws/pads.toml", "--format", "sarif", code=1))["runs"][0]["results"]


@pytest.mark.parametrize("words", [("--laws",), ("--expr", "K*d"), ("my laws", "--json")])
def test_a_format_is_of_files_alone(project, words):
    assert "--format with --json, or without files" in audit(*words, "--format", "sarif", code=2)


SCENE = """from hertzwerk.derive import GROUND, X, Body, JointSpring, Mechanism, Parameter, Prismatic, Scales, Scene

slider = Body("slider", mass=Parameter("mass", "kg", 1))
scene = Scene(
    Mechanism("swing", joints=(Prismatic("slide", GROUND, slider, axis=X),)),
    effects=(JointSpring("spring", "slide", Parameter("stiffness", "N/m", 10)),),
    scales=Scales(length=Parameter("size", "m", 1), speed=Parameter("speed_scale", "m/s", 1)),
)
"""


def test_the_recipe_for_a_project_of_ones_own(project):
    """Its commands and its test of pytest, in a scratch repository: current and sound, then neither."""
    page = (ROOT / "CONTRIBUTING.md").read_text()
    recipe = page.split("## Projects with scenes of their own")[1].split("\n## ")[0]
    (project / "scenes").mkdir()
    (project / "scenes" / "swing.py").write_text(SCENE)
    check, review = (
        line.split("#")[0].replace("scenes/*.py", "scenes/swing.py").split()[1:]
        for line in re.findall("^hertzwerk .*", recipe, re.M)
    )
    names = {}
    exec(recipe.split("```python\n")[1].split("```")[0], names)
    called(*check[:-1]), called(*check)
    assert called(*review).output == "\n"
    names["test_units_agree"]()
    (project / "scenes" / "pads.toml").write_text(LAWS)
    (project / "scenes" / "swing.py").write_text(SCENE.replace("10)", "20)"))
    called(*check, code=1), called(*review, code=1)
    with pytest.raises(AssertionError):
        names["test_units_agree"]()


def test_hooks_do_what_they_say(project):
    """Each hook's entry is a command; tried on files of the types that pre-commit would give it."""
    text = (ROOT / ".pre-commit-hooks.yaml").read_text()
    entries = dict(re.findall(r"- id: (\S+)\n(?:  .*\n)*?  entry: (.*)\n", text))
    assert set(entries) == {"hertzwerk-audit", "hertzwerk-modules"}
    for entry in entries.values():
        called(*entry.split()[1:], "--help")
    files = sorted(map(str, Path().rglob("*.*")))
    called(*entries["hertzwerk-audit"].split()[1:], *files, code=1)
