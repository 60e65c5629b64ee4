"""The catalogue knows every law by name, and builds those alone that are wanted."""

import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from hertzwerk.derive import laws
from hertzwerk.derive.laws import catalogue
from hertzwerk.derive.laws.catalogue import FILES, LAWS, Catalogue
from hertzwerk.derive.laws.law import Law


def test_every_law_of_a_file_is_named_with_it_and_no_other():
    named = {}
    for file, names in FILES:
        named.setdefault(file, set()).update(names.split())
    files = [path.stem for path in (Path(laws.__file__).parent / "formulas").glob("*.py") if path.stem != "__init__"]
    modules = {file: import_module(f"hertzwerk.derive.laws.formulas.{file}") for file in files}
    made = {
        file: {law.name for law in vars(module).values() if isinstance(law, Law)} for file, module in modules.items()
    }
    made["reconstruction"].remove("johnson")  # of which it is a variation
    assert {file: names for file, names in made.items() if names} == named


def test_a_law_imports_its_file_alone(monkeypatch):
    known, imported = laws.flores, []
    monkeypatch.setattr(
        catalogue, "import_module", lambda name, package: imported.append(name) or import_module(name, package)
    )
    fresh = Catalogue()
    assert "flores" in fresh
    assert len(fresh) == len(list(fresh)) == len(LAWS)
    assert imported == []
    assert fresh["flores"] is fresh["flores"] is known
    assert imported == [".formulas.damping"]
    for none in ("nothing", "damping"):
        with pytest.raises(KeyError):
            fresh[none]
    with pytest.raises(AttributeError):
        laws.nothing  # noqa: B018
    assert {"flores", "LAWS"} <= set(dir(laws))
    assert dict(fresh) == dict(LAWS)


def test_a_derivation_imports_the_files_of_its_laws_alone():
    code = (
        "import sys; from hertzwerk.runtime.engine.model.build import derive_text, scene_from; derive_text(scene_from('bouncing_ball'), '');"
        "from hertzwerk.derive.laws.catalogue import FILES; made = {f for f, _ in FILES if f'hertzwerk.derive.laws.formulas.{f}' in sys.modules};"
        "sys.exit(str(made) if made != {'stiffness', 'damping'} else 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
