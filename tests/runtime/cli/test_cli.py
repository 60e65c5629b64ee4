"""The command line as its users meet it: exit codes, plain output in a pipe, one new folder per run, and nothing written for bad input."""

import csv
import importlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from each import each

from hertzwerk.runtime.engine.model.build import built_in_scenes
from hertzwerk.runtime.system import digests

SCENE = """
from hertzwerk.derive import GROUND, Body, Contact, Gravity, Mechanism, Parameter, Prismatic, Scales, Scene, SphereOnPlane, Start, Y
from hertzwerk.derive.laws import power

m, R, h = Parameter("mass", "kg", 1), Parameter("radius", "m", 0.1), Parameter("height", "m", 0.1)
ball = Body("ball", mass=m)
mechanism = Mechanism(
    "my_ball",
    joints=(Prismatic("vertical", GROUND, ball, axis=Y),),
    pairs=(SphereOnPlane("floor", sphere=ball.at(0, 0, 0), radius=R, plane=GROUND.at(0, 0, 0), normal=Y),),
)
scene = Scene(
    mechanism,
    effects=(
        Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
        Contact("floor", power(Parameter("stiffness", "N/m^1.5", 1e8), 1.5)),
    ),
    start=Start(position={"vertical": R + h}),
    scales=Scales(length=R, speed=Parameter("speed_scale", "m/s", 1)),
)
"""


@pytest.fixture(autouse=True)
def _cache(tmp_path, monkeypatch):
    monkeypatch.setenv("HERTZWERK_CACHE", str(tmp_path / ".cache"))


def written() -> list[str]:
    return sorted(path.name for path in Path.cwd().iterdir() if not path.name.startswith("."))


def process(*arguments, **environment):
    command = [
        sys.executable, "-W", "error", "-c", "from hertzwerk.runtime.cli import main; main(prog_name='hertzwerk')",
        *arguments,
    ]  # fmt: skip
    return subprocess.run(
        command, capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL, env={**os.environ, **environment},
    )  # fmt: skip


# ---- list, audit, derive ---------------------------------------------------------------------------------------------


def test_list_names_every_scene_in_plain_text(hertzwerk):
    done = hertzwerk("list")
    assert [line.split()[0] for line in done.output.splitlines()[1:]] == list(built_in_scenes())
    assert "\x1b" not in done.output


def test_audit_of_an_inconsistent_law_exits_1_and_derive_refuses_it(hertzwerk):
    Path("mine.py").write_text(SCENE.replace("1e8), 1.5)", "1e8), 1)"))
    assert "N/m^0.5" in hertzwerk("audit", "mine.py", code=1).output
    assert "N/m^0.5" in hertzwerk("derive", "mine.py", "--out", "out", code=2).output
    assert written() == ["mine.py"]


def test_check_without_target_compares_all_built_in_scenes_and_writes_nothing(hertzwerk):
    """And finds that the committed modules are what the scenes derive to."""
    done = hertzwerk("derive", "--check")
    assert all(name in done.output for name in built_in_scenes())
    assert written() == []


def test_check_shows_the_difference_and_the_accepting_command(hertzwerk):
    hertzwerk("derive", "soft_ball", "--out", "out")
    hertzwerk("derive", "soft_ball", "--check", "--out", "out")
    path = Path("out/soft_ball.py")
    path.write_text(path.read_text().replace("1.4e+08", "1.5e+08").replace("140000000.0", "150000000.0"))
    done = hertzwerk("derive", "soft_ball", "--check", "--out", "out", code=1)
    assert "\n-" in done.output
    assert "\n+" in done.output
    assert "hertzwerk derive soft_ball --out out" in done.output


def test_outside_the_repository_derived_modules_are_the_models_that_run_with_their_neighbours(hertzwerk):
    Path("mine.py").write_text(SCENE)
    hertzwerk("derive", "mine.py", "--out", "out")
    text = Path("out/my_ball.py").read_text()
    assert str(Path.cwd()) not in text
    assert "mine.py" in text
    # On the old code the second file had the height of the first one's neighbour.
    own = SCENE.replace('"m", 0.1), Parameter("height", "m", 0.1)', '"m", 0.1), Parameter("height", "m", HEIGHT)')
    path = list(sys.path)
    for folder, height in (("one", 0.2), ("two", 0.3)):
        Path(folder).mkdir()
        Path(folder, "sizes_of_mine.py").write_text(f"HEIGHT = {height}\n")
        Path(folder, "mine.py").write_text("from sizes_of_mine import HEIGHT\n" + own)
        done = hertzwerk("run", f"{folder}/mine.py", "--json", "--duration", "0.4 s")
        speed = json.loads(done.output)["impacts"][0]["speed"]
        assert speed == pytest.approx((2 * 9.81 * height) ** 0.5, rel=1e-6)
    assert sys.path == path


@pytest.mark.parametrize("arguments", [("soft_ball",), ("mine.py", "soft_ball"), ()])
def test_outside_the_repository_derive_wants_a_folder(hertzwerk, arguments):
    Path("mine.py").write_text(SCENE)
    done = hertzwerk("derive", *arguments, code=2)
    assert ("--out" if arguments else "TARGET: found none") in done.output
    assert written() == ["mine.py"]


def test_inside_the_repository_derive_writes_the_generated_folder(hertzwerk):
    Path("pyproject.toml").write_text('[project]\nname = "hertzwerk"\n')
    shutil.copytree(importlib.import_module("hertzwerk.derive").__path__[0], "derive")
    Path("deep/er").mkdir(parents=True)
    os.chdir("deep/er")
    hertzwerk("derive", "soft_ball", "two_spheres")
    assert sorted(path.name for path in Path("../../generated").iterdir()) == ["soft_ball.py", "two_spheres.py"]


def test_a_repository_is_not_overwritten_by_another_derivation(hertzwerk):
    Path("pyproject.toml").write_text('[project]\nname = "hertzwerk"\n')
    shutil.copytree(importlib.import_module("hertzwerk.derive").__path__[0], "derive")
    with Path("derive/equations/motion/kinematics.py").open("a") as stream:
        stream.write("# changed\n")
    done = hertzwerk("derive", "soft_ball", code=2)
    assert "pip install" in done.output
    assert not Path("generated").exists()


# ---- run -------------------------------------------------------------------------------------------------------------


def test_a_run_is_one_new_folder_with_everything_in_it(hertzwerk):
    hertzwerk("run", "two_spheres")
    folder = Path("runs/two_spheres-001")
    assert sorted(path.name for path in folder.iterdir()) == [
        "mechanism.png", "overview.png", "run.json", "spheres.png", "states.csv", "states.npz",
    ]  # fmt: skip
    kept = json.loads((folder / "run.json").read_text())
    assert kept["parameters"]["youngs_modulus"] == {"value": 207, "unit": "GPa"}
    assert kept["versions"].keys() == {"hertzwerk", "casadi", "numpy", "python"}
    assert kept["statistics"]["steps"] == kept["steps"] > 0
    assert kept["outcome"] == "finished"
    with (folder / "states.csv").open() as stream:
        rows = list(csv.reader(stream))
    with np.load(folder / "states.npz") as data:
        column = rows[0].index("target_path.speed [m/s]")
        assert [float(row[column]) for row in rows[1:]] == data["target_path.speed"].tolist()
    assert [path.name for path in Path("runs").iterdir()] == ["two_spheres-001"]


def test_of_many_pairs_those_with_the_largest_forces_have_a_picture(hertzwerk, monkeypatch):
    monkeypatch.setattr("hertzwerk.runtime.cli.run_folder.PICTURED", 1)
    done = hertzwerk("run", "ball_between_walls")
    (folder,) = Path("runs").iterdir()
    impacts = json.loads((folder / "run.json").read_text())["impacts"]
    largest = max(impacts, key=lambda impact: impact["peak_force"])["contact"]
    assert len({impact["contact"] for impact in impacts}) == 2
    pictures = {path.stem for path in folder.glob("*.png")} - {"overview", "mechanism"}
    assert pictures == {largest}
    assert "1 of 2 pairs have no picture" in " ".join(done.output.split())


def test_a_run_gets_the_next_folder_and_leaves_one_with_other_content_alone(hertzwerk):
    for _ in range(3):
        hertzwerk("run", "two_spheres", "--no-plots")
    assert sorted(path.name for path in Path("runs").iterdir()) == [f"two_spheres-00{k}" for k in (1, 2, 3)]
    assert not list(Path("runs").rglob("*.png"))
    Path("kept").mkdir()
    Path("kept/thesis.txt").write_text("mine")
    hertzwerk("run", "two_spheres", "--out", "kept", code=2)
    assert [path.name for path in Path("kept").iterdir()] == ["thesis.txt"]
    Path("empty").mkdir()
    hertzwerk("run", "two_spheres", "--no-plots", "--out", "empty")
    hertzwerk("run", "two_spheres", "--no-plots", "--out", "empty", code=2)


def test_json_has_the_promised_fields_and_writes_nothing(hertzwerk):
    done = hertzwerk("run", "ball_between_walls", "--json")
    content = json.loads(done.output)
    assert list(content) == [
        "scene", "outcome", "t_start", "t_end", "duration", "accuracy", "tolerance", "method", "compiled", "steps",
        "rejected", "rhs_evaluations", "wall_s", "impacts", "final", "energy_residual", "error_estimate", "horizon",
        "growth", "decade_cost", "warnings", "advice",
    ]  # fmt: skip
    assert content["impacts"][0].keys() == {"contact", "t", "speed", "peak_force", "duration"}
    assert content["t_end"] == content["duration"] == 1.3
    assert 0 < content["error_estimate"] <= content["accuracy"] == 1e-9
    assert content["tolerance"] < content["accuracy"]
    assert content["horizon"] is None
    assert 1 < content["decade_cost"] < 2
    assert content["final"].keys() >= {"track.travel", "track.speed"}
    assert len(content["impacts"]) == 10
    assert written() == []


def test_a_run_reports_its_error_and_another_outcome_exits_1_and_keeps_what_there_is(hertzwerk):
    done = hertzwerk("run", "two_spheres", "--no-plots", "--accuracy", "2.5e-5")
    assert re.search(
        r"accuracy requested 2.5e-5, estimated [\d.]+e-\d+ at t = 0.\d+ s, [\d.]+e-\d+ at the end; ten times more would cost about 1.\d x the time",
        " ".join(done.output.split()),
    )
    assert max(map(len, done.output.splitlines())) <= 100  # in a pipe
    kept = json.loads(Path("runs/two_spheres-001/run.json").read_text())
    assert max(kept["error"]["values"]) == kept["error_estimate"] <= 2.5e-5
    assert len(kept["error"]["values"]) == len(kept["error"]["times"]) > 50
    done = hertzwerk("run", "two_spheres", "--no-plots", "--accuracy", "1e-12", code=1)
    assert "accuracy_unreachable" in done.output
    done = hertzwerk("run", "ball_between_walls", "--no-plots", "--max-steps", "5", code=1)
    assert "too_many_steps" in done.output
    assert "remedy" in done.output
    assert json.loads(Path("runs/ball_between_walls-001/run.json").read_text())["outcome"] == "too_many_steps"


def test_parameters_states_and_laws_can_be_set(hertzwerk):
    done = hertzwerk("run", "two_spheres", "--json", "--set", "striker_path.speed=600 mm/s", "--set", "restitution=1")
    content = json.loads(done.output)
    assert content["impacts"][0]["speed"] == pytest.approx(0.6, rel=1e-12)
    assert content["final"]["target_path.speed"] == pytest.approx(0.6, rel=1e-6)
    varied = json.loads(hertzwerk("run", "two_spheres", "--json", "--law", "spheres=hunt_crossley").output)
    assert varied["impacts"][0]["peak_force"] != pytest.approx(content["impacts"][0]["peak_force"], rel=1e-3)


def test_variations_and_other_coordinates_come_from_the_cache_the_second_time(hertzwerk, monkeypatch):
    line = ("run", "pendulum", "--json", "--duration", "0.5 s", "--set", "hinge.speed=1 rad/s")
    by_joints = json.loads(hertzwerk(*line).output)["final"]
    by_bodies = json.loads(hertzwerk(*line, "--coordinates", "absolute").output)["final"]
    assert {name.split(".")[0] for name in by_bodies} != {name.split(".")[0] for name in by_joints}
    turned = next(value for name, value in by_bodies.items() if name.endswith(".angle"))
    assert turned == pytest.approx(by_joints["hinge.angle"], abs=1e-5)
    varied = ("run", "two_spheres", "--json", "--without", "energy_ledger")
    first = json.loads(hertzwerk(*varied).output)["final"]
    monkeypatch.setitem(sys.modules, "hertzwerk.derive.equations.derivation", None)  # an import now fails
    assert json.loads(hertzwerk(*line, "--coordinates", "absolute").output)["final"] == by_bodies
    assert json.loads(hertzwerk(*varied).output)["final"] == first


def test_other_coordinates_are_derived_into_a_folder_of_their_own(hertzwerk):
    done = hertzwerk("derive", "pendulum", "--coordinates", "auto", code=2)
    assert "--out DIR" in done.output
    hertzwerk("derive", "pendulum", "--coordinates", "auto", "--out", "here")
    assert "Coordinates: of the joints, as the cheaper: " in Path("here/pendulum.py").read_text()
    hertzwerk("derive", "pendulum", "--coordinates", "auto", "--check", "--out", "here")
    hertzwerk("derive", "pendulum", "--coordinates", "absolute", "--check", "--out", "here", code=1)


def test_the_command_that_a_check_proposes_keeps_the_coordinates_of_the_module_and_works(hertzwerk):
    Path("mine.py").write_text(SCENE)
    check = "derive", "mine.py", "--check", "--out", "two words"
    absolute = hertzwerk(*check, "--coordinates", "absolute", code=1)
    commands = [re.search("`hertzwerk (.+)`", absolute.output)[1]]
    hertzwerk(*shlex.split(commands[0]))
    hertzwerk(*check)  # in the coordinates that the module states
    (module,) = Path("two words").iterdir()
    assert "regenerate with `hertzwerk derive mine.py --coordinates absolute`.\n" in module.read_text()
    module.write_text(module.read_text().replace("0.1", "0.2", 1))
    assert "hertzwerk derive mine.py --coordinates absolute --out" in hertzwerk("run", module, code=2).output
    for more in ((), ("--coordinates", "tree")):
        said = hertzwerk(*check, *more, code=1).output
        commands.append(re.search("accept with\\s+`hertzwerk (.+)`", said)[1])
    assert commands[0] == commands[1] != commands[2]
    for command, coordinates in zip(commands[1:], ([], ["--coordinates", "tree"]), strict=True):
        hertzwerk(*check, *coordinates, code=1)
        hertzwerk(*shlex.split(command))
        hertzwerk(*check, *coordinates)


def test_validate_reports_every_check_and_fails_if_one_does(hertzwerk):
    done = hertzwerk("validate", "two_spheres")
    assert "0.3 (1 - e)/2" in " ".join(done.output.split())
    assert "failed" not in done.output
    Path("mine.toml").write_text(
        'scene = "two_spheres"\nduration = "10 ms"\n[[checks]]\nquantity = "impacts"\nexpected = "1"\ntolerance = 0.1\nsource = "guess"\n'
    )
    done = hertzwerk("validate", "mine.toml", code=1)
    assert "failed" in done.output
    assert "guess" in done.output


# ---- bad input -------------------------------------------------------------------------------------------------------

BAD = [  # a fault of each option; others are refused by the functions behind, see tests/runtime/test_calls.py
    (("slider_crank", "--set", "clearance=0.2 furlong"), "furlong"),
    (("slider_crank", "--set", "clearance"), "NAME=VALUE"),
    (("slider_crank", "--set", "clearance=1 mm", "--set", "clearance=2 mm"), "twice"),
    (("slider_crank", "--set", "guide.travel=3 kg"), "guide.travel"),
    (("slider_crank", "--duration", "5 mm"), "duration"), (("slider_crank", "--accuracy", "high"), "accuracy"),
    (("slider_crank", "--method", "euler"), "dop853"), (("slider_crank", "--without", "frictoin"), "frictoin"),
    (("slider_crank", "--law", "slider_pin=newton"), "newton"),
    (("slider_crank", "--law", "slider_pin"), "NAME=VALUE"),
    (("slider_crank", "--coordinates", "cartesian"), "'tree', 'absolute' or 'auto'"),
    (("bouncing_ball", "--set", "exponent=1.1"), "stiffness"), (("no_such_scene",), "slider_crank"),
    (("no_such_file.py",), "no_such_file.py"), ((".",), "scene"),
]  # fmt: skip


@each(("arguments", "word"), BAD)
def test_bad_input_is_one_error_and_nothing_is_written(hertzwerk, arguments, word):
    done = hertzwerk("run", *arguments, code=2)
    assert word in done.output
    assert "Traceback" not in done.output
    assert written() == []


def test_all_faults_come_at_once_also_where_a_variation_cannot_be_made(hertzwerk):
    Path("full").mkdir()
    Path("full/other").touch()
    line = "run slider_crank --set clearance=0.2 --set nope=1 --set broken --duration 0s --accuracy 7 --method euler --out full"
    done = hertzwerk(*line.split(), code=2)
    for word in ("clearance", "nope", "broken", "duration", "accuracy", "euler", "full"):
        assert word in done.output, word
    assert written() == ["full"]
    line = "run slider_crank --coordinates polar --without nothing --accuracy 7 --method euler --set broken"
    done = hertzwerk(*line.split(), code=2)
    for word in ("polar", "nothing", "accuracy", "euler", "broken"):
        assert word in done.stderr
    done = hertzwerk(*["accuracy", "slider_crank", "--without", "nothing", "--set", "broken"], code=2)
    assert "nothing" in done.stderr and "broken" in done.stderr


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("x = 1\n1/0\n", ("mine.py, line 2", "ZeroDivisionError")), ("def f():\n    raise ValueError('deep')\nf()\n", ("mine.py, line 2", "deep")),
        ("x = (\n", ("mine.py, line 1", "SyntaxError")), ("import sys\nsys.exit('no')\n", ("mine.py, line 2", "SystemExit")),
        ("import nowhere_to_be_found\n", ("mine.py, line 1", "nowhere_to_be_found")), ("x = 1\n", ("mine.py", "scene")),
        ("scene = 'text'\n", ("mine.py", "str")), ("\x00", ("mine.py",)), (SCENE.replace('"kg", 1)', '"kg", -1)'), ("mine.py, line", "mass")),
        (SCENE.replace('"kg", 1)', '"m", 1)').replace('"radius", "m"', '"radius", "kg"'), ("mass", "radius")),
    ],
)  # fmt: skip
def test_a_scene_file_that_fails_is_named_with_its_line(hertzwerk, text, words):
    Path("mine.py").write_text(text)
    done = hertzwerk("run", "mine.py", "--duration", "1 s", code=2)
    assert all(word in done.output for word in words), done.output
    assert written() == ["mine.py"]


def test_a_run_that_cannot_be_written_leaves_nothing_half_done(hertzwerk, monkeypatch):
    def fails(*_):
        raise OSError("disk full")

    monkeypatch.setattr(digests, "json_text", fails)
    monkeypatch.setattr("hertzwerk.runtime.Solution.save", fails)
    done = hertzwerk("run", "two_spheres", "--no-plots", code=1)
    assert "2 impacts" in done.output or "1 impact" in done.output
    assert "disk full" in done.output
    assert list(Path("runs").iterdir()) == []


# ---- the process as a whole ------------------------------------------------------------------------------------------


def test_a_run_of_a_generated_scene_imports_no_more_than_it_needs(own_folder):
    command = [
        sys.executable, "-X", "importtime", "-c", "from hertzwerk.runtime.cli import main; main()", "run",
        "slider_crank", "--no-plots",
    ]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL)
    assert done.returncode == 0
    imported = {line.rpartition("|")[2].strip().split(".")[0] for line in done.stderr.splitlines()}
    assert {"casadi", "numpy", "click"} <= imported
    assert not imported & {"sympy", "matplotlib", "pydantic", "scipy", "rich", "pandas", "xarray", "pyarrow", "h5py"}


def test_errors_go_to_stderr_and_the_version_is_reported(own_folder):
    done = process("run", "slider_crank", "--json", "--accuracy", "7")
    assert (done.returncode, done.stdout) == (2, "")
    assert "accuracy" in done.stderr
    done = process("--version")
    assert done.returncode == 0
    assert "casadi" in done.stdout
