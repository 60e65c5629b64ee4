"""Every README and page of the handbook keeps its promises: commands and links exist, and lists are complete."""

import inspect
import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner
from each import each

import hertzwerk.derive
from hertzwerk.derive.laws.law import Law
from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.analysis.validation.scenario import Scenario
from hertzwerk.runtime.cli import main
from hertzwerk.runtime.engine.solution import outcome
from hertzwerk.runtime.engine.solution.history import units_of
from hertzwerk.runtime.handbook.reference_pages import GENERATED

ROOT = Path(__file__).parents[1]
DOCUMENTS = (
    "README.md", "CONTRIBUTING.md", *(f"{room}/README.md" for room in ("derive", "derive/laws", "derive/scenes", "runtime", "tests")),
)  # fmt: skip
HANDBOOK = Path("runtime", "handbook")
PAGES = tuple(page.relative_to(ROOT).as_posix() for page in sorted((ROOT / HANDBOOK).rglob("*.md")))
TEXTS = {name: (ROOT / name).read_text(encoding="utf-8") for name in (*DOCUMENTS, *PAGES)}
# Commands and options that take many seconds, each with tests of its own or a step of .ci/run
LONG = {
    *("accuracy", "animate", "effects", "export", "hardcases", "minimise", "propagate", "report", "study", "validate"),
    *("--check", "--section", "--table"),
}


def blocks(name, *languages):
    matches = re.findall(r"^```(\w+)\n(.*?)^```$", TEXTS[name], re.MULTILINE | re.DOTALL)
    return [text for language, text in matches if language in languages]


PYTHON = [
    pytest.param(name, text, id=f"{name}-{i}")
    for name in DOCUMENTS
    if name
    != "CONTRIBUTING.md"  # its blocks are run by test_contributing.py, those of the handbook in tests/runtime/handbook
    for i, text in enumerate(blocks(name, "python"))
]
SHELL = {
    name: [line.removeprefix("$ ") for text in blocks(name, "sh", "console") for line in text.splitlines()]
    for name in TEXTS
}


def commands(name):
    """Arguments of every command line of hertzwerk that a block shows."""
    lines = (line for line in SHELL[name] if line.startswith("hertzwerk "))
    return [shlex.split(line, comments=True)[1:] for line in lines]


# -- the first page ----------------------------------------------------------------------------------------------------


def test_the_first_page_has_the_set_up_by_line_40_and_at_most_100_lines():
    top = "\n".join(TEXTS["README.md"].splitlines()[:40])
    for promised in ("pip install .", "hertzwerk run slider_crank", "pytest", "```python", ".readme/slider_pin.png)"):
        assert promised in top
    assert len(TEXTS["README.md"].splitlines()) <= 100
    assert len(blocks("README.md", "python")[0].splitlines()) <= 10


@pytest.mark.parametrize("folder", ["derive", "runtime"])
def test_a_folder_is_described_in_at_most_120_lines(folder):
    assert len(TEXTS[f"{folder}/README.md"].splitlines()) <= 120


def test_laws_are_counted_and_commands_listed():
    verdicts = [law.verdict for law in hertzwerk.derive.laws.LAWS.values() if law.kind == "stiffness"]
    odd = sum(verdict != "consistent" for verdict in verdicts)
    assert f"| {odd} of {len(verdicts)} stiffness laws have" in TEXTS["README.md"]
    listed = re.findall(r"^\| `hertzwerk (\w+)", TEXTS["runtime/README.md"], re.MULTILINE)
    assert set(listed) == set(main.list_commands(None))


# -- all pages ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("name", "text"), PYTHON)
def test_python_runs_as_written(name, text, own_folder):
    """Where warnings are errors; what it says it writes, it writes."""
    exec(compile(text, name, "exec"), {"__name__": "__main__"})
    for picture in re.findall(r'savefig\("([^"]+)"', text):
        assert (own_folder / picture).read_bytes().startswith(b"\x89PNG")


@each("name", TEXTS)
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
def test_commands_run_as_written(name, long, own_folder):
    """In the order they stand in, in one folder, but for those of other machines, see runtime/studies/sweeps/rows/test_cluster.py.

    Pictures of a scene's run, which take four fifths of its time, are drawn once.
    """
    drawn = set()
    for arguments in commands(name):
        if "--cluster" not in arguments and bool(LONG & {*arguments}) == long:
            again = arguments[0] == "run" and (arguments[1] in drawn or "--continue" in arguments)
            drawn |= {*arguments[1:2]} if arguments[0] == "run" else set()
            done = CliRunner().invoke(main, [*arguments, *(["--no-plots"] if again else [])])
            assert done.exit_code == 0, (arguments, done.output)


@each("name", TEXTS)
def test_links_lead_somewhere(name):
    prose = re.sub(r"^```.*?^```$|`[^`\n]*`", "", TEXTS[name], flags=re.MULTILINE | re.DOTALL)
    if name in PAGES:  # whose pictures their code draws
        prose = re.sub(r"!\[[^\]]*\]\([^)]*\)", "", prose)
    targets = re.findall(r"\]\(([^)#]+)[^)]*\)", prose)
    generated = {f"{page}.md" for page in GENERATED} if name.startswith(f"{HANDBOOK}/reference/") else set()
    assert [
        target
        for target in targets
        if "://" not in target and target not in generated and not (ROOT / name).parent.joinpath(target).exists()
    ] == []


def test_pictures_are_small_shown_and_of_all_mechanisms():
    # Those that are committed; the handbook's are drawn when it is built.
    shown = {Path(target).name for name in DOCUMENTS for target in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", TEXTS[name])}
    pictures = {path.name: path.read_bytes() for path in (ROOT / ".readme").iterdir()}
    assert set(pictures) == shown
    assert all(content.startswith(b"\x89PNG\r\n\x1a\n") and len(content) < 850_000 for content in pictures.values())
    from PIL import Image

    from hertzwerk.runtime.engine.model.build import built_in_scenes

    with Image.open(ROOT / ".readme" / "mechanisms.png") as picture:
        assert picture.text["Description"].split() == list(built_in_scenes())


# -- lists that are complete -------------------------------------------------------------------------------------------


INNER = {  # of which people write none
    *(
        "Element", "Effect", "JointEffect", "PairEffect", "Joint", "Pair", "Touch", "Freedom", "Interval", "Finding",
        "Fault",
    ),
    *("BoundLaw", "Quantity", "Slot", "Varying"),
}  # fmt: skip
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


def pages(*folders):
    """Text of all pages in folders of the handbook."""
    return "\n".join(
        TEXTS[name] for name in PAGES if name.startswith(tuple(f"{HANDBOOK}/{folder}/" for folder in folders))
    )


DECLARATION = pages("howto/model", "howto/contact", "reference")


@each("kind", [kind for kind in DECLARED if kind.__name__ not in INNER])
def test_every_record_stands_there_with_its_signature(kind):
    assert f"`{written(kind)}`" in DECLARATION
    assert TEXTS[f"{HANDBOOK}/reference/effects.md"].count(f"\n| `{kind.__name__}(") <= 1  # none of an older signature


def test_names_scenes_keys_and_outcomes_are_explained():
    text = pages("howto/model", "howto/contact", "howto/exchange", "reference", "explanation")
    assert [name for name in dir(hertzwerk.derive) if not re.search(rf"\b{name}\b", text)] == []
    shown = re.findall(r"^\| `hertzwerk run (\w+)`", TEXTS["derive/scenes/README.md"], re.MULTILINE)
    assert sorted(shown) == sorted(NAMES)
    page = TEXTS[f"{HANDBOOK}/reference/file-formats.md"].split("## Scenario files")[1].split("| quantity |")[0]
    keys = {key for row in re.findall(r"^\| (`.*?) \|", page, re.MULTILINE) for key in re.findall(r"`(\w+)`", row)}
    assert keys == set(Scenario.model_fields)
    page = TEXTS[f"{HANDBOOK}/howto/run/accuracy-unreachable.md"]
    named = {name for row in re.findall(r"^\| (`.*?) \|", page, re.MULTILINE) for name in re.findall(r"`(\w+)`", row)}
    literal = re.findall(r'^        "([a-z]+_[a-z_]+)",$', inspect.getsource(outcome), re.MULTILINE)
    assert len(literal) > 3
    assert named - {"outcome"} >= {*literal, *(name for name, *_ in outcome._OUTCOMES.values())}


def test_how_to_pages_have_20_to_40_lines():
    lengths = {name: len(TEXTS[name].splitlines()) for name in PAGES if "/howto/" in name}
    assert {
        name: length for name, length in lengths.items() if not 20 <= length <= 40 and not name.endswith("index.md")
    } == {}


def patterns():
    """The names of histories that the handbook lists, as regular expressions."""
    page = "\n".join(TEXTS[f"{HANDBOOK}/{name}.md"] for name in ("reference/histories", "howto/run/joint-reactions"))
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
