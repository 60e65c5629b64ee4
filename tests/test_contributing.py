"""The recipes of CONTRIBUTING.md, followed in temporary files: what each makes works like what is built in."""

import re
import shutil
import sys
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import hertzwerk.derive as hd
from hertzwerk.derive.audit.admissibility import faults_if_consistent
from hertzwerk.derive.audit.audit import audit_law
from hertzwerk.derive.common.execute_file import names_defined_by
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.cli import GROUPS, main
from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS

PAGE = (Path(__file__).parents[1] / "CONTRIBUTING.md").read_text(encoding="utf-8")
RECIPES = dict(re.findall(r"^## An? ([\w ]+)\n(.*?)(?=^## |\Z)", PAGE, re.MULTILINE | re.DOTALL))
STUDY = (Path(__file__).parents[1] / "runtime" / "handbook" / "howto" / "study" / "own-study.md").read_text(
    encoding="utf-8"
)


@pytest.fixture
def made(tmp_path):
    """A recipe's files in a temporary folder, and the names that its Python file defines."""

    def follow(text, file):
        for name, content in re.findall(r"^```\w+\n# (\S+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
            (tmp_path / name).write_text(content, encoding="utf-8")
        return names_defined_by(tmp_path / file)

    return follow


def test_recipes_are_six_of_at_most_eight_lines_and_the_map_has_every_folder():
    assert list(RECIPES) == ["law", "joint", "effect", "scene", "method", "command"]
    for name, text in RECIPES.items():
        doing = re.findall(
            r"^(?:\d+\. |   ).*", re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL), re.MULTILINE
        )
        assert len(doing) <= 8, name
        steps = re.findall(r"^(\d+)\. ", text, re.MULTILINE)
        assert steps == [str(i + 1) for i in range(len(steps))] != []
    root = Path(__file__).parents[1]
    drawn = PAGE.split("## Map")[1].split("\n## ")[0]
    floors = {path.name for side in ("derive", "runtime") for path in (root / side).iterdir() if path.is_dir()} - {
        "__pycache__"
    }
    rooms = {path.name for side in ("derive", "runtime") for path in (root / side).glob("*/*") if path.is_dir()} - {
        "__pycache__"
    }
    assert [name for name in sorted(floors | rooms) if f" {name}/" not in drawn] == []


@pytest.mark.parametrize("name", RECIPES)
def test_every_file_that_a_recipe_names_is_there(name):
    """But for the one it is about, NAME; a star stands for several."""
    root = Path(__file__).parents[1]
    paths = {
        path
        for path in re.findall(r"(?:`|> )((?:derive|runtime|tests|\.readme)/[\w./*-]+)", RECIPES[name])
        if "NAME" not in path
    }
    assert paths
    assert [path for path in paths if not list(root.glob(path.rstrip("/")))] == []


def test_a_law(made, monkeypatch):
    law = made(RECIPES["law"], "law.py")["hardening"]
    assert all(finding.verdict == "consistent" for finding in audit_law(law))
    assert list(faults_if_consistent(law)) == []
    softening = replace(law, name="softening", force=-law.force, stored=-law.stored)
    assert list(faults_if_consistent(softening)) != []
    monkeypatch.setitem(hd.LAWS, law.name, law)  # the catalogue finds it in its file
    shown = CliRunner().invoke(main, ["laws", "hardening"])
    assert shown.exit_code == 0
    assert "Duffing 1918" in shown.stdout
    run = simulate(load("soft_ball", laws={"floor": "hardening(k=2e4 N/m, h=1 mm)"}), duration="0.5 s", tolerance=1e-9)
    assert run.outcome.finished
    assert run.energy_residual < 1e-7
    depth, force = run["floor.penetration"], run["floor.normal_force"]
    inside = depth > 0
    assert inside.any()
    assert force[inside] == pytest.approx(2e4 * depth[inside] * (1 + (depth[inside] / 1e-3) ** 2), rel=1e-9)


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("closing", [False, True])
def test_a_joint(made, closing, coordinates):
    """In every role as a slide and a pin through a body without mass."""
    kind = made(RECIPES["joint"], "joint.py")["PinInSlot"]
    size, pace = hd.Parameter("size", "m", 0.3), hd.Parameter("pace", "m/s", 1.0)
    body, between = (
        hd.Body("body", hd.Parameter("mass", "kg", 1), hd.Parameter("J", "kg m^2", 0.02), (size, 0, 0)),
        hd.Body("between", 0),
    )
    turn, travel = hd.Parameter("turn", "rad/s", 2.0), hd.Parameter("travel_speed", "m/s", 0.5)
    effects = hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), -hd.Y), hd.EnergyLedger()

    def motion(*joints, coordinates="tree", **speed):
        scene = hd.Scene(
            hd.Mechanism("slot", joints), effects, hd.Scales(size, pace, size), hd.Start(speed=speed)
        ).with_coordinates(coordinates)
        run = simulate(load(scene), duration=0.5, tolerance=1e-11)
        assert run.outcome.finished
        q = run.engine.history.part("y")[-1][: run.engine.model.nq]
        positions = run.engine.model.function("poses")(
            run.t[-1], q, run.engine.history.controls[: run.engine.model.nc]
        )[0]
        return np.array(positions)[:3, 0]

    own = kind("own", hd.GROUND, body, hd.X, hd.Z)
    first = [hd.Free("free", hd.GROUND, body)] if closing else []
    speed = (
        {"free.x_speed": travel, "free.angular_speed_z": turn} if closing else {"own.travel": travel, "own.angle": turn}
    )
    built_in = motion(
        hd.Prismatic("slide", hd.GROUND, between, hd.X), hd.Revolute("pin", between, body, hd.Z), slide=travel, pin=turn
    )
    assert motion(*first, own, coordinates=coordinates, **speed) == pytest.approx(built_in, abs=1e-8)


def test_an_effect(made):
    """Against the closed form of a body that drag alone slows, v0/(1 + c v0 t/m); and its units are proven."""
    kind = made(RECIPES["effect"], "effect.py")["AirDrag"]
    mass, pace, size = hd.Parameter("mass", "kg", 2), hd.Parameter("pace", "m/s", 5), hd.Parameter("size", "m", 1)
    sled = hd.Mechanism("sled", (hd.Prismatic("slide", hd.GROUND, hd.Body("sled", mass), axis=hd.X),))

    def scene(drag):
        return hd.Scene(
            sled, (kind("air", "slide", drag), hd.EnergyLedger()), hd.Scales(size, pace), hd.Start(speed={"slide": pace}),
        )  # fmt: skip

    run = simulate(load(scene(hd.Parameter("drag", "kg/m", 0.3))), duration=3.0, tolerance=1e-11)
    assert run["slide.speed"] == pytest.approx(5 / (1 + 0.3 * 5 * run.t / 2), rel=1e-9)
    assert run["air.dissipated"][-1] == pytest.approx(2 * 5**2 / 2 - run["energy"][-1], rel=1e-8)
    with pytest.raises(hd.InputError, match="effect air, drag"):
        scene(hd.Parameter("drag", "kg", 0.3))


def test_an_effect_with_states(made):
    """A satellite's attitude by a relay on x + lead v: its limit cycle in closed form, 4 h/(lead a) long, v to h/lead."""
    kind = made(RECIPES["effect"], "relay.py")["Relay"]
    h, lead, acceleration = 0.01, 0.1, 3 / 2
    signal = hd.coordinate_of("slide") + hd.Parameter("lead", "s", lead) * hd.speed_of("slide")
    relay = kind("relay", "slide", hd.Parameter("thrust", "N", 3), signal, hd.Parameter("hysteresis", "m", h))
    body, scales = (
        hd.Body("body", hd.Parameter("mass", "kg", 2)),
        hd.Scales(hd.Parameter("size", "m", h), hd.Parameter("pace", "m/s", 0.1)),
    )
    thrown = hd.Start(speed={"slide": hd.Parameter("thrown", "m/s", h / lead)})
    scene = hd.Scene(
        hd.Mechanism("satellite", (hd.Prismatic("slide", hd.GROUND, body, axis=hd.X),)), (relay, hd.EnergyLedger()), scales, thrown,
    )  # fmt: skip
    period = 4 * h / (lead * acceleration)
    model = load(scene)
    for method in ("auto", "esdirk"):
        run = simulate(model, duration=10.2 * period, tolerance=1e-8, method=method)
        turns = run.t[1:][np.diff(run["relay.sign"]) != 0]
        assert len(turns) == run.statistics.events == 20
        assert 2 * np.diff(turns[4:]) == pytest.approx(period, rel=1e-9)
        assert np.max(np.abs(run["slide.speed"])) == pytest.approx(h / lead, rel=1e-9)
        assert run["relay.spent"] == pytest.approx(3 * run.t, rel=1e-12)
        assert run.energy_residual < 1e-9
    back = simulate(model, duration=period, tolerance=1e-8, initial={"relay.sign": -1, "slide.travel": "0 m"})
    assert back["relay.sign"][0] == -1
    with pytest.raises(hd.InputError, match="effect relay, signal"):
        replace(scene, effects=(replace(relay, signal=hd.speed_of("slide")),))


def test_a_method(made, monkeypatch):
    monkeypatch.setitem(METHODS, "bogacki_shampine", (made(RECIPES["method"], "method.py")["bogacki_shampine"],))
    model = load("pendulum")
    errors = []
    for tolerance in (1e-6, 1e-9):
        run = simulate(model, duration=1.0, tolerance=tolerance, method="bogacki_shampine")
        exact = simulate(model, duration=1.0, tolerance=1e-12, method="dop853").engine.final["hinge.angle"]
        errors.append((run.statistics.steps, abs(run.engine.final["hinge.angle"] - exact)))
    (few, large), (many, small) = errors
    assert np.log(large / small) / np.log(many / few) == pytest.approx(3, abs=0.3)
    with pytest.raises(hd.InputError, match="bogacki_shampin"):
        simulate(model, duration=1.0, method="bogacki_shampin")


def test_a_command(made, monkeypatch):
    command = made(RECIPES["command"], "command.py")["freedoms"]
    monkeypatch.setitem(main.commands, command.name, command)
    monkeypatch.setitem(GROUPS["Analyse"], command.name, "command")
    done = CliRunner().invoke(main, ["freedoms", "double_pendulum"])
    assert (done.exit_code, done.stdout) == (0, "double_pendulum: 2\n")
    assert CliRunner().invoke(main, ["freedoms", "nothing"]).exit_code == 2
    assert "freedoms" in CliRunner().invoke(main, ["--help"]).stdout


def test_a_scene(made, own_folder):
    made(RECIPES["scene"], "my_pendulum.py")
    written = CliRunner().invoke(main, ["derive", "my_pendulum.py", "--out", "generated"])
    assert written.exit_code == 0, written.output
    assert (own_folder / "generated" / "my_pendulum.py").is_file()
    scenario = own_folder / "my_pendulum.toml"
    assert CliRunner().invoke(main, ["validate", scenario.name]).exit_code == 0
    scenario.write_text(scenario.read_text().replace("1e-3 rad", "1.1e-3 rad"))
    assert CliRunner().invoke(main, ["validate", scenario.name]).exit_code == 1


def test_a_study(made, own_folder):
    """Against Hertz; with a wrong one the command says so."""
    made(STUDY, "my_study.py")
    done = CliRunner().invoke(main, ["study", "my_study.py", "--quick", "--out", "drops"])
    assert done.exit_code == 0, done.output
    assert "holds" in done.stdout
    written = {"study.md", "study.json", "forces.csv", "forces.png", "forces.svg", "rows"}
    assert {path.name for path in (own_folder / "drops").iterdir()} == written
    file = own_folder / "my_study.py"
    file.write_text(file.read_text().replace("depths**1.5", "1.002 * depths**1.5"))
    wrong = CliRunner().invoke(main, ["study", "my_study.py", "--quick"])
    assert (wrong.exit_code, "fails" in wrong.stdout) == (1, True)


def test_hooks_are_local_and_fetch_nothing():
    """Their commands are those of the development environment."""
    hooks = (Path(__file__).parents[1] / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    assert re.findall(r"repo: (\S+)", hooks) == ["local"]
    entries = [entry.split() for entry in re.findall(r"entry: (.*)", hooks)]
    assert [entry[:2] for entry in entries] == [
        ["ruff", "check"], ["ruff", "format"], ["mypy", "-p"], ["hertzwerk", "derive"],
    ]  # fmt: skip
    assert re.findall(r"language: (\S+)", hooks) == ["system"] * len(entries)
    assert all(shutil.which(entry[0], path=str(Path(sys.executable).parent)) for entry in entries)


def test_the_citation_and_the_change_log_are_of_this_version():
    root = Path(__file__).parents[1]
    version = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    assert f"\nversion: {version}\n" in (root / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\n## {version}\n" in (root / "CHANGELOG.md").read_text(encoding="utf-8")
