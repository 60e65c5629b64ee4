"""The wheel, built from a clean export, holds the tree: every module and data file of the packages, nothing else, nothing generic at top level."""

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGES = ("derive", "generated", "runtime")


def exported() -> list[str]:
    """Files that a clean export of the tree has and the wheel is built from; no caches, no build folders."""
    sources = (path for package in PACKAGES for path in (ROOT / package).rglob("*") if path.is_file())
    files = [*sources, *(ROOT / name for name in ("pyproject.toml", "README.md", "LICENSE"))]
    return sorted(path.relative_to(ROOT).as_posix() for path in files if "__pycache__" not in path.parts)


def shipped(name: str) -> bool:
    return name.split("/")[0] in PACKAGES and name.endswith((".py", ".toml", "py.typed"))


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Names in a wheel built from a copy of the tree."""
    export, out = tmp_path_factory.mktemp("export"), tmp_path_factory.mktemp("wheel")
    for name in exported():
        (export / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, export / name)
    command = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", str(out), str(export)]
    subprocess.run(command, check=True, capture_output=True, stdin=subprocess.DEVNULL)
    (built,) = out.glob("hertzwerk-*.whl")
    return zipfile.ZipFile(built).namelist()


@pytest.mark.slow
def test_the_wheel_holds_the_tree(wheel):
    content = {name for name in wheel if not name.split("/")[0].endswith(".dist-info")}
    assert content == {f"hertzwerk/{name}" for name in exported() if shipped(name)}


@pytest.mark.slow
def test_the_wheel_carries_licence_and_console_command(wheel):
    assert any(name.endswith(".dist-info/licenses/LICENSE") for name in wheel)
    assert any(name.endswith(".dist-info/entry_points.txt") for name in wheel)


def test_every_folder_with_modules_is_a_listed_package():
    """A package left out of pyproject.toml would be missing only after an installation."""
    import tomllib

    listed = set(tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]["packages"])
    folders = {f"hertzwerk.{Path(name).parent.as_posix().replace('/', '.')}" for name in exported() if shipped(name)}
    assert listed == folders


@pytest.mark.parametrize("package", PACKAGES)
def test_every_package_is_typed_and_the_namespace_has_no_init(package):
    assert (ROOT / package / "py.typed").is_file()
    assert not (ROOT / "__init__.py").exists()
