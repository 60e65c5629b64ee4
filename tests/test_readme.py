"""Every README keeps its promises: its code runs, its commands and links are there, and what it lists is all there is."""

import inspect
import re
import shlex
import tomllib
from pathlib import Path

import pytest
from click.testing import CliRunner
from each import each

import hertzwerk.derive
from hertzwerk.derive.laws.law import Law
from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.analysis.validation.scenario import Scenario, load_scenario
from hertzwerk.runtime.cli import main
from hertzwerk.runtime.engine.solution import outcome
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.studies.sweeps.sweep_file import read_sweep

ROOT = Path(__file__).parents[1]
DOCUMENTS = (
    "README.md",
    "CONTRIBUTING.md",
    *(f"{room}/README.md" for room in ("derive", "derive/laws", "derive/scenes", "runtime", "tests")),
)
TEXTS = {name: (ROOT / name).read_text(encoding="utf-8") for name in DOCUMENTS}
# Commands and options that take many seconds, each with tests of its own or a step of .ci/run
LONG = {
    *("accuracy", "animate", "effects", "export", "hardcases", "propagate", "report", "study", "validate"),
    *("--check", "--restitution", "--section", "--table"),
}


def blocks(name, *languages):
    found = re.findall(r"^```(\w+)\n(.*?)^```$", TEXTS[name], re.MULTILINE | re.DOTALL)
    return [text for language, text in found if language in languages]


def write_files(name, folder):
    """Blocks that begin with the name of a file become that file."""
    for text in blocks(name, "python", "toml", "xml"):
        if file := re.match(r"(?:# |<!-- )(\w+\.\w+)(?: -->)?\n", text):
            (folder / file[1]).write_text(text, encoding="utf-8")


PYTHON = [
    pytest.param(name, text, id=f"{name}-{i}", marks=pytest.mark.slow if name == "runtime/README.md" else ())
    for name in DOCUMENTS
    if name != "CONTRIBUTING.md"  # its blocks are run by test_contributing.py
    for i, text in enumerate(blocks(name, "python"))
]
TOML = [(name, text) for name in DOCUMENTS for text in blocks(name, "toml") if name != "CONTRIBUTING.md"]
SHELL = {name: [line for text in blocks(name, "sh") for line in text.splitlines()] for name in DOCUMENTS}


def commands(name):
    """Arguments of every command line of hertzwerk that a block shows."""
    lines = (line for line in SHELL[name] if line.startswith("hertzwerk "))
    return [shlex.split(line, comments=True)[1:] for line in lines]


# -- the first page ----------------------------------------------------------------------------------------------------


def test_set_up_example_and_picture_stand_by_line_40():
    top = "\n".join(TEXTS["README.md"].splitlines()[:40])
    for promised in ("pip install .", "hertzwerk run slider_crank", "pytest", "```python", ".readme/slider_pin.png)"):
        assert promised in top


def test_it_has_at_most_125_lines_and_its_example_20():
    assert len(TEXTS["README.md"].splitlines()) <= 125
    assert len(blocks("README.md", "python")[0].splitlines()) <= 20


def test_it_lists_all_commands():
    assert set(re.findall(r"^\| `hertzwerk (\w+)", TEXTS["README.md"], re.MULTILINE)) == set(main.list_commands(None))


# -- all pages ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "text"), PYTHON)
def test_python_runs_as_written(name, text, tmp_path, monkeypatch):
    """Where warnings are errors; what it says it writes, it writes."""
    monkeypatch.chdir(tmp_path)
    write_files(name, tmp_path)
    exec(compile(text, name, "exec"), {"__name__": "__main__"})
    for picture in re.findall(r'savefig\("([^"]+)"', text):
        assert (tmp_path / picture).read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(("name", "text"), TOML)
def test_toml_is_read_as_written(name, text, tmp_path):
    write_files(name, tmp_path)
    file = tmp_path / re.match(r"# (\S+)\n", text)[1]
    if "law" in tomllib.loads(text):
        assert hertzwerk.derive.laws_from(file)
    elif "over" in tomllib.loads(text):
        assert read_sweep(file)["outputs"]
    else:
        assert load_scenario(file).checks


@pytest.mark.parametrize("name", DOCUMENTS)
def test_every_command_and_option_it_shows_exists(name):
    shown = {line.strip("`") for line in re.findall(r"`hertzwerk [a-z][^`]*`", TEXTS[name])}
    for command, *rest in [*commands(name), *(line.split()[1:] for line in shown)]:
        if command not in ("COMMAND", "--help"):
            known = {name for option in main.get_command(None, command).params for name in option.opts} | {"--help"}
            assert {word for word in rest if word.startswith("--")} <= known, command


RUNS = [
    pytest.param(name, long, marks=pytest.mark.exhaustive if long else pytest.mark.slow)
    for name in DOCUMENTS
    if name != "CONTRIBUTING.md"  # its recipe is for a project of one's own: test_contributing.py makes one
    for long in (False, True)
    if any(bool(LONG & {*arguments}) == long for arguments in commands(name))
]


@pytest.mark.parametrize(("name", "long"), RUNS)
def test_commands_run_as_written(name, long, tmp_path, monkeypatch):
    """In the order they stand in, in one folder, but for those of other machines, see runtime/studies/sweeps/rows/test_cluster.py.

    Pictures of a scene's run, which take four fifths of its time, are drawn once.
    """
    monkeypatch.chdir(tmp_path)
    write_files(name, tmp_path)
    drawn = set()
    for arguments in commands(name):
        if "--cluster" not in arguments and bool(LONG & {*arguments}) == long:
            again = arguments[0] == "run" and (arguments[1] in drawn or "--continue" in arguments)
            drawn |= {*arguments[1:2]} if arguments[0] == "run" else set()
            done = CliRunner().invoke(main, [*arguments, *(["--no-plots"] if again else [])])
            assert done.exit_code == 0, (arguments, done.output)


@pytest.mark.parametrize("name", DOCUMENTS)
def test_links_lead_somewhere(name):
    prose = re.sub(r"^```.*?^```$|`[^`\n]*`", "", TEXTS[name], flags=re.MULTILINE | re.DOTALL)
    targets = re.findall(r"\]\(([^)#]+)[^)]*\)", prose)
    assert [
        target for target in targets if "://" not in target and not (ROOT / name).parent.joinpath(target).exists()
    ] == []


def test_pictures_are_small_and_each_is_shown():
    shown = {Path(target).name for text in TEXTS.values() for target in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)}
    pictures = {path.name: path.read_bytes() for path in (ROOT / ".readme").iterdir()}
    assert set(pictures) == shown
    assert all(content.startswith(b"\x89PNG\r\n\x1a\n") and len(content) < 800_000 for content in pictures.values())


def test_the_picture_of_all_mechanisms_has_them_all():
    from PIL import Image

    from hertzwerk.runtime.engine.model.build import built_in_scenes

    with Image.open(ROOT / ".readme" / "mechanisms.png") as picture:
        assert picture.text["Description"].split() == list(built_in_scenes())


# -- lists that are complete -------------------------------------------------------------------------------------------


INNER = {  # of which people write none
    *(
        "Element",
        "Effect",
        "JointEffect",
        "PairEffect",
        "Joint",
        "Pair",
        "Touch",
        "Freedom",
        "Interval",
        "Finding",
        "Fault",
    ),
    *("BoundLaw", "Quantity", "Slot", "Varying"),
}
DECLARED = [
    kind
    for kind in (getattr(hertzwerk.derive, name) for name in dir(hertzwerk.derive))
    if inspect.isclass(kind) and not issubclass(kind, Law | Exception)
]


def written(kind):
    """A record's signature as the README writes it."""
    defaults = {"Ground()": "GROUND", "Direction(components=(0, 0, 1))": "Z", "Direction(components=(1, 0, 0))": "X",
                "Direction(components=(0, 1, 0))": "Y"}  # fmt: skip
    parts = []
    for parameter in inspect.signature(kind).parameters.values():
        if parameter.kind is parameter.VAR_KEYWORD:
            continue
        default = "" if parameter.default is parameter.empty else repr(parameter.default)
        if default == "<factory>":
            default = {"start": "Start()"}.get(parameter.name, "{}")
        parts.append(parameter.name + (f"={defaults.get(default, default)}" if default else ""))
    return f"{kind.__name__}({', '.join(parts)})"


@each("kind", [kind for kind in DECLARED if kind.__name__ not in INNER])
def test_every_record_stands_there_with_its_signature(kind):
    assert f"`{written(kind)}`" in TEXTS["derive/README.md"]


def test_every_public_name_is_explained():
    assert [name for name in dir(hertzwerk.derive) if not re.search(rf"\b{name}\b", TEXTS["derive/README.md"])] == []


def test_every_scene_is_in_the_gallery():
    shown = re.findall(r"^\| `hertzwerk run (\w+)`", TEXTS["derive/scenes/README.md"], re.MULTILINE)
    assert sorted(shown) == sorted(NAMES)


def test_every_key_of_a_scenario_is_explained():
    page = TEXTS["derive/README.md"].split("## Scenario files")[1]
    keys = {key for row in re.findall(r"^\| (`.*?) \|", page, re.MULTILINE) for key in re.findall(r"`(\w+)`", row)}
    assert keys == set(Scenario.model_fields)


def test_every_outcome_is_explained():
    page = TEXTS["runtime/README.md"].split("## Outcomes")[1].split("\n## ")[0]
    named = {name for row in re.findall(r"^\| (`.*?) \|", page, re.MULTILINE) for name in re.findall(r"`(\w+)`", row)}
    literal = re.findall(r'^        "([a-z]+_[a-z_]+)",$', inspect.getsource(outcome), re.MULTILINE)
    assert len(literal) > 3
    assert named - {"outcome"} >= {*literal, *(name for name, *_ in outcome._OUTCOMES.values())}


def patterns():
    """The names of histories that the README lists, as regular expressions."""
    page = TEXTS["runtime/README.md"].split("## Outputs")[1].split("\n## ")[0]
    for row in re.findall(r"^\| (`.*?) \|", page, re.MULTILINE):
        for name, more in re.findall(r"`([^`]+)`(\.\.)?", row):
            pattern = re.sub(r"<\w+>", r"\\w+", name.replace(".", r"\."))
            yield name, re.sub(r"([xyz]|0)$", {"0": "[0-3]"}.get(pattern[-1], "[xyz]"), pattern) if more else pattern


def test_every_history_is_explained():
    """Of every scene, from the list that a run has its histories of."""
    absolute = load("double_pendulum", coordinates="absolute")
    listed = [set(units_of(model.engine, None)) - {"t"} for model in (*map(load, NAMES), absolute)]
    assert set(simulate(absolute, duration=1e-6, tolerance=1e-3, method="dopri5")) == listed[-1]
    names = set().union(*listed)
    known = dict(patterns())
    assert [name for name in sorted(names) if not any(re.fullmatch(pattern, name) for pattern in known.values())] == []
