"""The arrows of the design, read from the imports themselves: declaration -> text -> functions -> solution -> pictures."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGES = ("derive", "generated", "runtime")


def sources(package: str) -> list[Path]:
    return sorted((ROOT / package).rglob("*.py"))


def absolute(node: ast.ImportFrom, file: Path) -> str:
    """Module named by `from X import`, relative imports resolved to hertzwerk.<package>..."""
    if not node.level:
        return node.module or ""
    parts = ["hertzwerk", *file.relative_to(ROOT).parent.parts]
    base = parts[: len(parts) - (node.level - 1)]
    return ".".join([*base, *([node.module] if node.module else [])])


def imports(file: Path) -> Iterator[str]:
    """Every module that a file imports when it runs, wherever in it; `from a import b` counts as a.b too, for b may be a module."""
    tree = ast.parse(file.read_text(encoding="utf-8"))
    typing_only = {
        id(node)
        for block in ast.walk(tree)
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING"
        for statement in block.body
        for node in ast.walk(statement)
    }
    for node in ast.walk(tree):
        if id(node) in typing_only:
            continue
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            module = absolute(node, file)
            yield module
            yield from (f"{module}.{alias.name}" for alias in node.names)
        elif (
            isinstance(node, ast.Call)
            and ast.unparse(node.func) in {"import_module", "importlib.import_module", "__import__"}
            and node.args
        ):
            yield literal_start(node.args[0])


def literal_start(node: ast.expr) -> str:
    """The text an import_module argument starts with."""
    if isinstance(node, ast.Constant):
        return str(node.value)
    if isinstance(node, ast.JoinedStr) and node.values and isinstance(node.values[0], ast.Constant):
        return str(node.values[0].value).rstrip(".")
    return ""


def reaches(module: str, *targets: str) -> bool:
    return any(module == target or module.startswith(target + ".") for target in targets)


def offenders(files: list[Path], *targets: str, allowed: tuple[str, ...] = ()) -> list[str]:
    return [
        f"{file.relative_to(ROOT)} imports {module}"
        for file in files
        for module in imports(file)
        if reaches(module, *targets) and not reaches(module, *allowed)
    ]


def test_every_package_has_sources():
    assert all(sources(package) for package in PACKAGES)


def test_derive_imports_sympy_and_nothing_of_the_other_side():
    assert (
        offenders(
            sources("derive"),
            "casadi",
            "numpy",
            "scipy",
            "matplotlib",
            "pydantic",
            "hertzwerk.generated",
            "hertzwerk.runtime",
        )
        == []
    )
    assert offenders(sources("derive"), "sympy") != []


@pytest.mark.parametrize("name", ["units.py", "faults.py", "tomlfile.py"])
def test_what_both_sides_share_imports_only_the_standard_library(name):
    import sys

    for module in imports(ROOT / "derive" / name):
        assert module.split(".")[0] in sys.stdlib_module_names or reaches(module, "hertzwerk.derive.faults"), module


def test_generated_modules_import_casadi_only():
    for file in sources("generated"):
        assert set(imports(file)) <= {"casadi"}, file


def test_runtime_never_imports_sympy():
    assert offenders(sources("runtime"), "sympy") == []


def test_only_build_opens_the_door_to_derive():
    others = [file for file in sources("runtime") if file.name != "build.py"]
    shared = ("hertzwerk.derive.units", "hertzwerk.derive.faults", "hertzwerk.derive.tomlfile")
    bare = [
        found
        for found in offenders(others, "hertzwerk.derive", allowed=shared)
        if not found.endswith("imports hertzwerk.derive")
    ]
    assert bare == []


def test_build_opens_it_lazily():
    tree = ast.parse((ROOT / "runtime" / "build.py").read_text(encoding="utf-8"))
    at_import = [
        node
        for node in tree.body
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("hertzwerk.derive")
    ]
    assert {node.module for node in at_import} <= {"hertzwerk.derive.units", "hertzwerk.derive.faults"}


CLI = {
    "cli/__init__.py",
    "cli/accuracy.py",
    "cli/audit.py",
    "cli/draw.py",
    "cli/effects.py",
    "cli/hardcases.py",
    "cli/laws.py",
    "cli/run.py",
    "cli/scenes.py",
    "cli/target.py",
    "cli/terminal.py",
}

DRAWING = ("drawing", "insets", "labels", "paper", "picture", "sheet")
PICTURES = {
    "plot.py",
    "plot_accuracy.py",
    "plot_band.py",
    "plot_effects.py",
    "plot_laws.py",
    *(f"draw/{name}.py" for name in DRAWING),
}


@pytest.mark.parametrize(
    ("libraries", "home"),
    [(("matplotlib",), PICTURES), (("click", "rich"), CLI), (("pydantic",), {"scenario.py"})],
)
def test_heavy_libraries_have_one_importer(libraries, home):
    importers = {
        file.relative_to(ROOT / "runtime").as_posix()
        for file in sources("runtime")
        if any(reaches(module, *libraries) for module in imports(file))
    }
    assert importers == home


def test_a_forbidden_import_would_be_found(tmp_path, monkeypatch):
    """The net has no hole where imports hide: in functions, relative, by name, as `from package import module`."""
    monkeypatch.setattr("test_architecture.ROOT" if __name__ == "test_architecture" else f"{__name__}.ROOT", tmp_path)
    file = tmp_path / "runtime" / "inner" / "x.py"
    file.parent.mkdir(parents=True)
    file.write_text(
        "import importlib\nfrom .. import plot\ndef f():\n    from hertzwerk import derive\n    importlib.import_module('sympy.core')\n"
        "    importlib.import_module(f'hertzwerk.derive.scenes.{1}')\n"
    )
    assert {"hertzwerk.runtime.plot", "hertzwerk.derive", "sympy.core", "hertzwerk.derive.scenes"} <= set(imports(file))
