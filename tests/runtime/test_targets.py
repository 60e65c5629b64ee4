"""Targets: scenes in files and packages by name, and generated modules, in commands and functions."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from commands import called

from hertzwerk import InputError, load, simulate
from hertzwerk.runtime import Model, study_effects, sweep
from hertzwerk.runtime.engine.model.build import file_of, located_target, split_target

SCENES = """
from hertzwerk.derive import GROUND, Body, Contact, EnergyLedger, Gravity, Mechanism, Parameter, Prismatic, Scales, Scene
from hertzwerk.derive import SphereOnPlane, Start, Y, laws


def ball(name, mass):
    body, radius, height = Body("ball", mass=Parameter("mass", "kg", mass)), Parameter("radius", "mm", 20), Parameter("drop_height", "m", 0.01)
    return Scene(
        Mechanism(name, joints=(Prismatic("vertical", GROUND, body, axis=Y),),
                  pairs=(SphereOnPlane("floor", sphere=body.at(0, 0, 0), radius=radius, plane=GROUND.at(0, 0, 0), normal=Y),)),
        effects=(
            Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), direction=-Y),
            Contact("floor", laws.power(Parameter("stiffness", "N/m^1.5", 1e6), n=1.5), laws.flores(e=Parameter("restitution", "1", 0.8))),
            EnergyLedger(),
        ),
        start=Start(position={"vertical": radius + height}),
        scales=Scales(length=radius, speed=Parameter("speed_scale", "m/s", 1)),
    )


"""
RUN = {"duration": "60 ms", "tolerance": 1e-6, "compiled": False}


@pytest.fixture(scope="module")
def derived(tmp_path_factory):
    """A folder with a file of one scene, a file and a package of two, and the generated modules of them."""
    folder = tmp_path_factory.mktemp("project")
    (folder / "my_ball.py").write_text(SCENES + 'scene = ball("my_ball", 0.1)\n')
    two = SCENES + 'light, heavy = ball("light_ball", 0.1), ball("heavy_ball", 1)\n'
    (folder / "balls.py").write_text(two)
    (folder / "plant").mkdir()
    (folder / "plant" / "__init__.py").write_text("")
    (folder / "plant" / "scenes.py").write_text(two)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        called("derive", "my_ball.py", "balls.py:light", "plant.scenes:heavy")
    return folder


@pytest.fixture
def project(derived, tmp_path, monkeypatch):
    folder = Path(shutil.copytree(derived, tmp_path / "project"))
    monkeypatch.chdir(folder)
    return folder


def told(*words, code=0):
    return called(*words, code=code).output


def test_a_module_is_written_beside_its_scene_and_never_over_it(project):
    assert (project / "my_ball.py").read_text().startswith(SCENES)
    for file in ("my_ball_generated.py", "light_ball.py", "plant/heavy_ball.py"):
        assert (project / file).is_file()
    told("derive", "my_ball.py", "--out", ".")  # the folder of the scene by another way
    assert (project / "my_ball.py").read_text().startswith(SCENES)
    (project / "light_ball.py").write_text("mine = 1\n")
    assert "light_ball.py: found a file that is no generated module" in told("derive", "balls.py:light", code=2)
    assert (project / "light_ball.py").read_text() == "mine = 1\n"


def test_a_generated_module_runs_bit_by_bit_as_its_scene(project):
    targets = "my_ball.py", "my_ball_generated.py", project / "my_ball_generated.py"
    runs = [simulate(load(target), **RUN) for target in targets]
    assert len({run.engine.history.rows.tobytes() for run in runs}) == 1
    assert len(runs[0].impacts) == 1
    module = load("my_ball_generated.py").engine.module
    assert load(module).engine.module is Model(module).engine.module is module
    assert Model("my_ball_generated.py").parameters == Model("my_ball.py").parameters
    told("run", "my_ball_generated.py", "--duration", "60 ms", "--out", "found")
    told("run", "--continue", "found", "--duration", "70 ms", "--out", "on")
    assert "my_ball" in told("list", "my_ball_generated.py")
    told("report", "my_ball_generated.py", "--out", "page.html")


@pytest.mark.parametrize(
    ("target", "name", "source"),
    [
        ("balls.py:heavy", "heavy_ball", "balls.py:heavy"), (Path("balls.py:light"), "light_ball", "balls.py:light"),
        ("light_ball.py", "light_ball", "balls.py:light"), ("plant.scenes:heavy", "heavy_ball", "plant.scenes:heavy"),
        ("plant:heavy_ball", "heavy_ball", "plant.scenes:heavy"),
    ],
)  # fmt: skip
def test_a_scene_or_module_is_found_by_its_name(project, target, name, source):
    model = load(target)
    assert (model.name, model.engine.module.SOURCE) == (name, source)


@pytest.mark.parametrize(
    ("target", "found"),
    [
        ("balls.py", "no `scene`; expected one of balls.py:light, balls.py:heavy"),
        ("balls.py:ball", "`ball` of type function; expected one of balls.py:light"),
        ("plant.scenes:nothing", "no `nothing`; expected one of plant.scenes:light"),
        ("plant.other:heavy", "no module of this name; expected a module that is installed, or in the working folder"),
        ("nowhere:scene", "no module of this name"),
        ("my_ball_generated.py:scene", "`scene` of a generated module; expected the module itself, my_ball_gen"),
        ("light_bal", "no scene of this name"),
    ],
)
def test_a_wrong_name_gets_one_error_with_those_there_are(project, target, found):
    with pytest.raises(InputError, match=re.escape(found)):
        load(target)
    assert found in told("list", target, code=2)


@pytest.mark.parametrize(
    "call",
    [
        lambda file: load(file, without=["gravity"]), lambda file: load(load(file), laws={"floor": "hunt_crossley"}),
        lambda file: load(file, coordinates="absolute"), lambda file: study_effects(file, **RUN), lambda file: load(file).equations(),
        lambda file: simulate(load(file), **RUN)["floor.point_x"], lambda file: told("run", file, "--without", "gravity", code=2),
        lambda file: told("derive", file, "--show", code=2), lambda file: told("derive", file, code=2), lambda file: told("audit", file, code=2),
        lambda file: told("effects", file, "--duration", "10 ms", code=2),
    ],
)  # fmt: skip
def test_functions_that_need_the_scene_name_it(project, call):
    try:
        text = call("my_ball_generated.py")
    except (InputError, KeyError) as error:
        text = str(error)
    way_out = r"hertzwerk derive my_ball\.py --show|load the scene, of my_ball\.py"
    assert re.search(way_out, " ".join(text.split()))
    assert "without its scene" in text


def test_an_altered_module_is_refused_unexecuted_with_the_command_that_regenerates_it(project, capsys):
    file = project / "modules" / "light_ball.py"
    file.parent.mkdir()
    shutil.move(project / "light_ball.py", file)
    file.write_text(f'{file.read_text()}\nprint("executed")\n')
    with pytest.raises(InputError, match=r"hertzwerk derive balls.py:light --out modules"):
        load("modules/light_ball.py")
    assert "does not fit its digest" in told("run", "modules/light_ball.py", "--duration", "1 ms", code=2)
    assert "executed" not in capsys.readouterr().out
    told("derive", "balls.py:light", "--out", "modules")
    assert load("modules/light_ball.py").name == "light_ball"
    told("derive", "my_ball.py", "--out", "modules")  # a module with the name of its scene's file
    own = project / "modules" / "my_ball.py"
    own.write_text(f"{own.read_text()}\n")
    with pytest.raises(InputError, match=r"hertzwerk derive my_ball.py --out modules"):
        load("modules/my_ball.py")
    (project / "scenes").mkdir()
    for name in ("my_ball.py", "balls.py"):
        shutil.move(project / name, project / "scenes")
    told("derive", "scenes/my_ball.py", "--out", "modules")
    for name in ("copy.py", "light_ball.py"):  # both beside a sound module of the first one's source's name
        (project / "modules" / name).write_text(f"{(own if name == 'copy.py' else file).read_text()}\n")
    for name, source in (("copy.py", "my_ball.py"), ("light_ball.py", "balls.py:light")):
        with pytest.raises(InputError, match=rf"hertzwerk derive scenes/{source} --out modules"):
            load(f"modules/{name}")


def test_a_check_says_in_one_line_that_no_module_is_in_place(project):
    targets = "my_ball.py", "balls.py:light", "plant.scenes:heavy"
    told("derive", *targets, "--check")
    said = told("derive", *targets, "--check", "--out", "gen", code=1).replace("\n" + 14 * " ", " ").splitlines()
    assert len(said) == 3  # labels; long lines go on below
    assert said[1].endswith(
        "light_ball: no module at gen/light_ball.py; write it with `hertzwerk derive balls.py:light --out gen`"
    )
    (project / "light_ball.py").write_text((project / "light_ball.py").read_text().replace("20,", "21,"))
    said = told("derive", *targets, "--check", code=1)
    assert '-    ("radius", "mm", 21,' in said
    assert "accept with `hertzwerk derive balls.py:light`" in said


def test_a_sweep_of_a_module_goes_on_and_not_with_another(project):
    for target in ("light_ball.py", "plant.scenes:heavy"):
        into = f"sweep of {target[0]}"
        how = {"outputs": ["impacts"], "duration": "60 ms", "tolerance": 1e-6, "out": into}
        table = sweep(target, over={"restitution": [0.5, 0.7]}, **how)
        assert [row.outcome for row in table] == ["finished"] * 2
        told("sweep", "--resume", into)
        file = file_of(target)
        file.write_text(file.read_text() + "\n")
        assert "it is not executed" in told("sweep", "--resume", into, code=2)


def test_a_target_is_split_only_where_it_names_python():
    assert split_target("a/b.py:scene") == ("a/b.py", "scene")
    assert split_target("C:\\b.py") == ("C:\\b.py", "")
    assert split_target("a.b:c") == ("a.b", "c")
    assert split_target("slider_crank") == ("slider_crank", "")
    assert split_target("b.py:") == ("b.py:", "")
    assert located_target("b.py:scene", Path("there")) == "there/b.py:scene"
    assert located_target("a.b:c", Path("there")) == "a.b:c"
    assert np.all([file_of(name) is None for name in ("slider_crank", "nowhere.at_all:scene")])
