"""Public names: one list for Python and for type checkers, which see what each of them is; names say what things are."""

import ast
import importlib
import os
import re
import subprocess
import sys
import types
from pathlib import Path

import pytest
from statements import statements

from hertzwerk.names import handed_on

ROOT = Path(__file__).parents[1]
RIDDLES = {"told", "tell", "tells", "asked", "ask", "asks", "given", "found", "what", "has", "kept", "seen"}
ALLOWED = {
    "found": "errors state what was found and what was expected",
    "tell": "a method of Python's files",
}
SIDES = ("derive", "runtime")
FRONTS = ("hertzwerk", "hertzwerk.derive", "hertzwerk.runtime")


@pytest.mark.parametrize("front", FRONTS)
def test_every_name_that_is_listed_is_there(front):
    package = importlib.import_module(front)
    assert package.__all__ == dir(package)
    assert all(getattr(package, name) is not None for name in package.__all__)
    with pytest.raises(AttributeError, match="has no attribute 'nothing'"):
        _ = package.nothing


def test_names_are_read_from_what_type_checkers_import(monkeypatch):
    """One that its home has not is an error when it is asked for, not before."""
    source = "if TYPE_CHECKING:\n    from math import pi as pi, nothing as nothing\nelse:\n    from math import tau\n"
    module = types.ModuleType("front")
    module.__loader__ = types.SimpleNamespace(get_source=lambda name: source)
    monkeypatch.setitem(sys.modules, "front", module)
    names, look_up, listed = handed_on("front")
    assert names == listed() == ["nothing", "pi"]
    assert look_up("pi") == module.pi == 3.141592653589793
    for absent in ("nothing", "tau"):
        with pytest.raises(AttributeError):
            look_up(absent)


@pytest.mark.slow
def test_a_type_checker_sees_what_the_names_are(tmp_path):
    """Seeded faults among them: a name that is not there, a parameter that a law has not."""
    (tmp_path / "seen.py").write_text(
        "from hertzwerk import load\n"
        "from hertzwerk.derive import LAWS, Revolute, Scene, laws\n"
        "from hertzwerk.runtime import simulate\n"
        "reveal_type(Scene)\nreveal_type(Revolute)\nreveal_type(LAWS)\nreveal_type(load)\nreveal_type(simulate)\n"
        "reveal_type(laws.flores.__call__)\nreveal_type(laws.johnson(1, 2, 3, 4))\n"
        "laws.flores(q=1)\n"
        "from hertzwerk.derive import Nothing\n",
        encoding="utf-8",
    )
    settings = Path(__file__).parents[1] / "pyproject.toml"
    command = [sys.executable, "-m", "mypy", "--config-file", str(settings), "seen.py"]
    environment = {"MYPY_CACHE_DIR": str(tmp_path / "cache")} | dict(os.environ)  # what .ci/run has read of the package
    printed = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300).stdout
    for expected in (
        "-> hertzwerk.derive.declare.scene.scene.Scene", "(name: str, parent: ",
        "hertzwerk.derive.laws.catalogue.Catalogue", "-> hertzwerk.runtime.loading.Model",
        "-> hertzwerk.runtime.simulation.Solution", "def (e: ", '"hertzwerk.derive.laws.law.BoundLaw"',
        'error: Unexpected keyword argument "q"', 'error: Module "hertzwerk.derive" has no attribute "Nothing"',
        "Found 2 errors",
    ):  # fmt: skip
        assert expected in printed, printed


def riddles(text):
    """Names of classes, functions, fields and constants that do not say what the thing is, as 'line: name'."""
    names = set()
    for node in statements(ast.parse(text)):
        body = node.body if isinstance(node, ast.Module | ast.ClassDef) else []
        names |= {(each.lineno, each.name) for each in body if isinstance(each, ast.ClassDef | ast.FunctionDef)}
        names |= {(part.lineno, part.id) for each in body for part in stored(each) if isinstance(part, ast.Name)}
        names |= {(part.lineno, part.attr) for part in stored(node) if isinstance(part, ast.Attribute)}  # self.x = ...
    return [f"{line}: {name}" for line, name in sorted(names) if riddle(name)]


def stored(statement):
    """Names and attributes that an assignment sets."""
    if not isinstance(statement, ast.Assign | ast.AnnAssign):
        return []
    targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
    parts = (part for target in targets for part in ast.walk(target))
    return [part for part in parts if isinstance(getattr(part, "ctx", None), ast.Store)]


def riddle(name):
    """Whether a word of a name is a riddle; `has_modes` is a question, and what is allowed is allowed alone."""
    words = re.findall(r"[A-Z]?[a-z]+|[A-Z]+", name)
    words = words[1:] if len(words) > 1 and words[0] == "has" else words
    return name not in ALLOWED and bool(RIDDLES & {word.lower() for word in words})


@pytest.mark.parametrize("side", SIDES)
def test_names_parameters_and_locals_say_what_they_are(side):
    files = sorted((ROOT / side).rglob("*.py"))
    assert files
    assert [str(file.relative_to(ROOT)) for file in files if riddle(file.stem)] == []
    for file in files:
        text = file.read_text("utf-8")
        assert [*riddles(text), *riddles_within(text)] == [], file


def riddles_within(text):
    """Parameters and locals of that kind, as 'line: name'; `found` beside `expected` is a parameter of what makes errors."""
    names, fields = set(), set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ClassDef):
            fields |= {part for each in node.body for part in stored(each)}
        elif isinstance(node, ast.FunctionDef | ast.Lambda):
            spec = node.args
            parameters = [*spec.posonlyargs, *spec.args, *spec.kwonlyargs, *filter(None, (spec.vararg, spec.kwarg))]
            pair = {"found", "expected"} <= {each.arg for each in parameters}
            names |= {(each.lineno, each.arg) for each in parameters if not (pair and each.arg == "found")}
            names |= {(node.lineno, node.name)} if isinstance(node, ast.FunctionDef) else set()
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and node not in fields:
            names.add((node.lineno, node.id))
    return [f"{line}: {name}" for line, name in sorted(names) if name in RIDDLES - {"tell"}]


@pytest.mark.parametrize(
    "text",
    [
        "def f(what): pass", "def f(*, expected, **given): pass", "x = [found for found in y]",
        "def f():\n    for a, (b, seen) in c: pass", "def f():\n    if (kept := g()): return kept",
        "def f():\n    def told(): pass", "x = lambda found: found[0]",
    ],
)  # fmt: skip
def test_a_local_that_is_a_riddle_is_found(text):
    assert len(riddles_within(text)) == 1
    assert riddles_within("def fault(where, found, expected): return Fault(where, found, expected)") == []
    assert riddles_within("class A:\n    found: str\nFault(found=1, expected=2).found") == []


@pytest.mark.parametrize(
    "text", ["class Asked: pass", "class A:\n    kept: int", "def read_given(): pass", "KEPT, B = 1, 2", "def f(x):\n    x._found = 1"],
)  # fmt: skip
def test_a_name_that_is_a_riddle_is_found(text):
    assert len(riddles(text)) == 1
    assert (
        riddles("class A:\n    found: str\n    has_modes = True\n    def f(self):\n        found = self.has_modes")
        == []
    )


def test_names_of_tests_are_plain():
    """They say what holds: none begins `test_what`, none has a thing told or asked."""
    files = sorted((ROOT / "tests").rglob("test_*.py"))
    names = [name for file in files for name in re.findall(r"^def (test_\w+)", file.read_text("utf-8"), re.MULTILINE)]
    assert len(names) > 2000
    assert [name for name in names if re.match(r"test_what_|.*_(told|tells|asked)(_|$)", name)] == []
