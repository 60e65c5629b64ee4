"""The archives, built from a clean export: the wheel holds the packages and nothing else, the source distribution the whole tree."""

import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGES = ("derive", "generated", "runtime")
ALONE = (
    "pyproject.toml", "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff", "LICENSE", ".gitignore",
    ".pre-commit-config.yaml", ".pre-commit-hooks.yaml",
)  # fmt: skip
TOP = "runtime/cli/package/"  # installed as hertzwerk/


def exported() -> list[str]:
    """Files that a clean export of the tree has and the archives are built from; no caches, no build folders."""
    sources = (
        path
        for folder in (*PACKAGES, "tests", ".ci", ".github", ".readme")
        for path in (ROOT / folder).rglob("*")
        if path.is_file()
    )
    files = [*sources, *(ROOT / name for name in ALONE)]
    return sorted(path.relative_to(ROOT).as_posix() for path in files if "__pycache__" not in path.parts)


def shipped(name: str) -> bool:
    if name.startswith("runtime/handbook/"):
        return True
    return name.split("/")[0] in PACKAGES and name.endswith(
        (".py", ".pyi", ".toml", "py.typed", ".css", ".js", ".c", ".h", "CMakeLists.txt")
    )


def installed(name: str) -> str:
    return f"hertzwerk/{name.removeprefix(TOP)}"


@pytest.fixture(scope="module")
def archives(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Source distribution of a copy of the tree, with what tools leave in it, and the wheel built from that."""
    export, out = tmp_path_factory.mktemp("export"), tmp_path_factory.mktemp("archives")
    for name in exported():
        (export / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, export / name)
    (export / "tests" / "__pycache__").mkdir()
    (export / "tests" / "__pycache__" / "left.cpython-311.pyc").touch()
    command = [sys.executable, "-m", "build", "--no-isolation", "--outdir", str(out), str(export)]
    subprocess.run(command, check=True, capture_output=True, stdin=subprocess.DEVNULL)
    return next(out.glob("hertzwerk-*.tar.gz")), next(out.glob("hertzwerk-*.whl"))


@pytest.fixture(scope="module")
def wheel(archives) -> list[str]:
    return zipfile.ZipFile(archives[1]).namelist()


@pytest.mark.slow
def test_the_wheel_holds_the_packages(wheel):
    content = {name for name in wheel if not name.split("/")[0].endswith(".dist-info")}
    assert content == {installed(name) for name in exported() if shipped(name)}


@pytest.mark.slow
def test_the_wheel_carries_licence_and_console_command(wheel):
    assert any(name.endswith(".dist-info/licenses/LICENSE") for name in wheel)
    assert any(name.endswith(".dist-info/entry_points.txt") for name in wheel)


@pytest.mark.slow
def test_the_source_distribution_holds_the_tree_with_every_test(archives):
    """setuptools by itself takes the tests that lie directly in tests/, three of many."""
    with tarfile.open(archives[0]) as archive:
        names = [member.name.partition("/")[2] for member in archive if member.isfile()]
    added = {"PKG-INFO", "setup.cfg"}
    assert {name for name in names if ".egg-info/" not in name} - added == set(exported())


@pytest.mark.slow
def test_the_installed_package_is_found_where_a_plain_folder_of_its_name_lies_before_it(archives, tmp_path):
    """A clone under its own name beside a script was imported in place of what is installed, for that was a namespace."""
    zipfile.ZipFile(archives[1]).extractall(tmp_path / "site")
    (tmp_path / "work" / "hertzwerk" / "derive").mkdir(parents=True)
    script = tmp_path / "work" / "script.py"
    script.write_text(
        "import hertzwerk, hertzwerk.derive as d\nprint(hertzwerk.__file__, hertzwerk.__version__, hertzwerk.Scene, d.__file__)\n"
    )
    site = f"import sys, runpy; sys.path[:0] = [{str(script.parent)!r}, {str(tmp_path / 'site')!r}]; runpy.run_path({str(script)!r})"
    actual = subprocess.run(
        [sys.executable, "-c", site], check=True, capture_output=True, text=True, cwd=tmp_path
    ).stdout
    home = tmp_path / "site" / "hertzwerk"
    assert actual.split(" ", 1)[0] == str(home / "__init__.py")
    assert actual.split()[-1] == str(home / "derive" / "__init__.py")
    assert f" {project()['version']} " in actual


def project() -> dict:
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_supported_pythons_are_stated_alike_and_tried_by_forks():
    """In requires-python, the classifiers and the matrix of the workflow; extras of `dev` are all but those of one benchmark."""
    prefix = "Programming Language :: Python :: "
    stated = [each.removeprefix(prefix) for each in project()["classifiers"] if each.startswith(f"{prefix}3.")]
    workflow = (ROOT / ".github" / "workflows" / "ci.yml").read_text(encoding="utf-8")
    assert re.findall(r'"(3\.\d+)"', re.search(r"python: \[(.*)\]", workflow)[1]) == stated
    assert project()["requires-python"] == f">={stated[0]}"
    (extras,) = (each for each in project()["optional-dependencies"]["dev"] if each.startswith("hertzwerk["))
    assert set(re.findall(r"\w+", extras)[1:]) == {*project()["optional-dependencies"]} - {"dev", "peers"}


def test_every_folder_with_modules_is_a_listed_package():
    """A package left out of pyproject.toml would be missing only after an installation."""
    listed = set(tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["setuptools"]["packages"])
    pages = {
        name for name in exported() if name.endswith((".md", "handbook.css", "search_scorer.js"))
    }  # their folders are none
    folders = {
        Path(installed(name)).parent.as_posix().replace("/", ".")
        for name in exported()
        if shipped(name) and name not in pages
    }
    assert listed == folders


@pytest.mark.parametrize("package", [*PACKAGES, TOP])
def test_every_package_is_typed_and_the_clone_is_none(package):
    assert (ROOT / package / "py.typed").is_file()
    assert not (ROOT / "__init__.py").exists()


def test_the_first_names_come_from_the_package_and_nothing_heavy_before_they_are_requested():
    """`import hertzwerk` costs nothing; each name is what its home has, one that is not there is an AttributeError."""
    requested = (
        "import sys, hertzwerk\n"
        "heavy = {'casadi', 'sympy', 'numpy', 'hertzwerk.runtime', 'hertzwerk.derive'} & set(sys.modules)\n"
        "assert not heavy, heavy\n"
        "assert not hasattr(hertzwerk, 'nothing')\n"
        "from hertzwerk import InputError, Scene, load, simulate\n"
        "import hertzwerk.derive, hertzwerk.runtime as runtime\n"
        "assert Scene is hertzwerk.derive.Scene and (InputError, load, simulate) == (runtime.InputError, runtime.load, runtime.simulate)\n"
        "assert set(hertzwerk.__all__) <= set(dir(hertzwerk))\n"
        "print(hertzwerk.__version__)\n"
    )
    out = subprocess.run([sys.executable, "-c", requested], check=True, capture_output=True, text=True).stdout
    assert out.strip() == project()["version"]
