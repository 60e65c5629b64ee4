"""Public names: one list for Python and for type checkers, which see what each of them is."""

import importlib
import os
import subprocess
import sys
import types
from pathlib import Path

import pytest

from hertzwerk.names import handed_on

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
        "-> hertzwerk.derive.declare.scene.scene.Scene",
        "(name: str, parent: ",
        "hertzwerk.derive.laws.catalogue.Catalogue",
        "-> hertzwerk.runtime.loading.Model",
        "-> hertzwerk.runtime.simulation.Solution",
        "def (e: ",
        '"hertzwerk.derive.laws.law.BoundLaw"',
        'error: Unexpected keyword argument "q"',
        'error: Module "hertzwerk.derive" has no attribute "Nothing"',
        "Found 2 errors",
    ):
        assert expected in printed, printed
