"""The arrows of the design, read from the imports themselves: floors of both sides, each of which imports only what is below it.

`python tests/test_architecture.py` prints the graph of rooms as Graphviz reads it.
"""

import ast
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import NamedTuple

import pytest
from statements import statements

ROOT = Path(__file__).parents[1]
SIDES = ("derive", "runtime")

# What a folder holds, lowest first: each imports only what stands before it, in functions and under TYPE_CHECKING too. "." are the folder's loose
# files. Folders that are not here order their files alone: those may not import each other in a ring.
FLOORS = {
    "derive": "common expressions program laws declare audit equations exchange scenes",
    "runtime": "system engine output loading simulation analysis studies export handbook cli",
}
ROOMS = {
    "derive/expressions": "algebra dimension .", "derive/program": ". emit", "derive/declare": "mechanism effects scene",
    "derive/equations": "flexible motion contact module equal_parts inverse_dynamics .", "derive/equations/contact": ". pairs",
    "derive/exchange": "user_files sympy_models readable_equations law_sheets",
    "runtime/engine": "accuracy model integration start solution run sensitivity inputs",
    "runtime/engine/integration": "tableaux friction many_pairs step events loop .", "runtime/output": "plots drawings films tables reports",
    "runtime/analysis": "statics rigid_limit effect_study work_precision validation hard_cases",
    "runtime/studies": "comparison sweeps uncertainty minimisation fitting paper", "runtime/studies/sweeps": "points rows .",
}  # fmt: skip
ORDERS = {folder: names.split() for folder, names in (FLOORS | ROOMS).items()}

CALLS = ("import_module", "__import__")


def sources(folder: str) -> list[Path]:
    return sorted((ROOT / folder).rglob("*.py"))


def absolute(node: ast.ImportFrom, file: Path) -> str:
    """Module named by `from X import`, relative imports resolved to hertzwerk.<package>..."""
    if not node.level:
        return node.module or ""
    parts = ["hertzwerk", *file.relative_to(ROOT).parent.parts]
    base = parts[: len(parts) - (node.level - 1)]
    return ".".join([*base, *([node.module] if node.module else [])])


class Import(NamedTuple):
    """A module that a file imports, by a statement or a call."""

    node: ast.AST
    module: str
    typing: bool  # under TYPE_CHECKING
    at_import: bool  # of the file, by a statement of its own


@cache
def imports(file: Path) -> tuple[Import, ...]:
    """Every module that a file imports, wherever in it; `from a import b` counts as a.b too, for b may be a module."""
    text = file.read_text(encoding="utf-8")
    tree = ast.parse(text)  # not kept: collecting garbage among the trees of all files takes longer than reading them
    nodes = (ast.walk if any(name in text for name in CALLS) else statements)(tree)
    typing, first = {id(node) for node in for_type_checkers(tree)}, {id(node) for node in tree.body}
    found = ((node, module) for node in nodes for module in imported(node, file))
    return tuple(Import(node, module, id(node) in typing, id(node) in first) for node, module in found)


def imported(node: ast.AST, file: Path) -> Iterator[str]:
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        module = absolute(node, file)
        yield module
        yield from (f"{module}.{alias.name}" for alias in node.names)
    elif isinstance(node, ast.Call) and node.args and getattr(node.func, "attr", getattr(node.func, "id", "")) in CALLS:
        yield literal_start(node.args[0])


def for_type_checkers(tree: ast.Module) -> Iterator[ast.AST]:
    """Statements under TYPE_CHECKING."""
    for block in statements(tree):
        if isinstance(block, ast.If) and ast.unparse(block.test) == "TYPE_CHECKING":
            yield from (node for statement in block.body for node in statements(statement))


def literal_start(node: ast.expr) -> str:
    """The text an import_module argument starts with."""
    if isinstance(node, ast.Constant):
        return str(node.value)
    if isinstance(node, ast.JoinedStr) and node.values and isinstance(node.values[0], ast.Constant):
        return str(node.values[0].value).rstrip(".")
    return ""


def modules(file: Path) -> Iterator[str]:
    return (found.module for found in imports(file))


def reaches(module: str, *targets: str) -> bool:
    return any(module == target or module.startswith(target + ".") for target in targets)


def offenders(files: list[Path], *targets: str) -> list[str]:
    return [
        f"{file.relative_to(ROOT)} imports {module}"
        for file in files
        for module in modules(file)
        if reaches(module, *targets)
    ]


def files() -> list[Path]:
    return [file for side in SIDES for file in sources(side)]


def file_named(module: str) -> Path | None:
    """File, from the root, of the module that a dotted name is; None where it is none of ours."""
    parts = module.split(".")
    if parts[0] != "hertzwerk" or len(parts) < 2 or parts[1] not in SIDES:
        return None
    path = Path(*parts[1:])
    if (ROOT / path).is_dir():
        return path / "__init__.py"
    return path.with_suffix(".py") if (ROOT / path).with_suffix(".py").is_file() else None


@cache
def file_graph() -> dict[Path, set[Path]]:
    """Files, from the root, and the files that they import."""
    found: dict[Path, set[Path]] = {}
    for file in files():
        named: dict[int, list[Path]] = {}
        for each in imports(file):
            if (other := file_named(each.module)) is not None:
                named.setdefault(id(each.node), []).append(other)
        # of `from a import b` the last name found is the nearest: a.b where b is a module, else a
        path = file.relative_to(ROOT)
        found[path] = {other for others in named.values() for other in (others[1:] or others)} - {path}
    return found


def room_in(folder: str, file: Path) -> str:
    """Name of the room that a file has in a folder: a sub-folder, a loose file of a side, "." for other loose files and `__init__`."""
    first, *rest = file.relative_to(folder).with_suffix("").parts
    return first if rest or (folder in SIDES and first != "__init__") else "."


def upward(files: dict[Path, set[Path]], orders: dict[str, list[str]]) -> list[str]:
    """Imports that do not go down, and rooms without a place in the order of their folder."""
    found = []
    for folder, order in orders.items():
        place = {name: k for k, name in enumerate(order)} | ({".": len(order)} if folder in SIDES else {})
        for file, others in files.items():
            for other in others if file.is_relative_to(folder) else ():
                if other.is_relative_to(folder) and (a := room_in(folder, file)) != (b := room_in(folder, other)):
                    if not {a, b} <= {*place}:
                        found.append(f"{a} or {b} is not in the order of {folder}")
                    elif place[b] > place[a] and not (folder in SIDES and b == "." and other.name == "__init__.py"):
                        found.append(f"{file} imports {other}")
    return found


def graph() -> dict[str, set[str]]:
    """Folders and the folders that their files import."""
    found: dict[str, set[str]] = {}
    for file, others in file_graph().items():
        room = str(file.parent)
        found.setdefault(room, set()).update({str(other.parent) for other in others} - {room})
    return found


def test_floors_and_rooms_import_only_what_is_below_them():
    assert upward(file_graph(), ORDERS) == []


@pytest.mark.parametrize("folder", ORDERS)
def test_every_room_has_its_place(folder):
    rooms = {
        room_in(folder, file) for file in file_graph() if file.is_relative_to(folder) and file.name != "__init__.py"
    }
    assert rooms == {*ORDERS[folder]}


def test_an_arrow_upwards_is_found():
    """Between floors, between rooms of a floor, and from a room that nobody knows."""
    for file, other in (
        ("derive/common/units.py", "derive/program/program.py"),
        ("runtime/engine/model/binding.py", "runtime/simulation.py"),
        ("derive/declare/effects/gravity.py", "derive/declare/scene/scene.py"),
        ("runtime/engine/integration/step/projection.py", "runtime/engine/integration/loop/attempt.py"),
        ("runtime/new/x.py", "runtime/system/cache.py"),
    ):
        assert upward({Path(file): {Path(other)}}, ORDERS) != [], file
        assert upward({Path(other): {Path(file)}}, ORDERS) == [] or "new" in file


def test_each_side_shows_nine_entries_and_no_folder_is_full():
    """The gallery and its scenario files aside: one of each, which generated modules name."""
    for side in SIDES:
        shown = {path.name for path in (ROOT / side).iterdir()}
        assert len(shown - {"README.md", "__init__.py", "py.typed", "handbook", "__pycache__"}) <= 9
        assert len({*ORDERS[side]} - {"handbook"}) <= 9
    folders = [folder for side in SIDES for folder in (ROOT / side).rglob("*") if folder.is_dir()]
    full = {
        folder.relative_to(ROOT).as_posix() for folder in folders if sum(f.is_file() for f in folder.iterdir()) > 15
    }
    assert full == {"derive/scenes", "runtime/analysis/validation/scenarios"}
    assert max(len(folder.relative_to(ROOT).parts) - 1 for folder in folders if folder.name != "__pycache__") <= 4


def test_tests_mirror_the_rooms():
    folders = {file.parent.relative_to(ROOT / "tests") for side in SIDES for file in sources(f"tests/{side}")}
    assert [str(folder) for folder in folders if not (ROOT / folder).is_dir()] == []


# Arrows between files of one room that close a ring, and why they stay: from a folder or file, to a file.
RINGS = (  # folder, from, to, why
    ("derive/declare/scene", "checks", "scene.py", "a scene checks itself when it is made; its checks name its type"),
    ("runtime/analysis/rigid_limit", "plot_rigid_limit.py", "rigid_limit.py", "a rigid limit draws itself; its picture names its type"),
    ("runtime/studies/sweeps", "stored_rows.py", "sweep_table.py", "a sweep saves and reads itself; the format imports what it makes"),
    ("runtime/studies/sweeps", "plot_sweep.py", "sweep_table.py", "a sweep draws itself; its picture names its type"),
    ("runtime/studies/uncertainty", "plot_uncertainty.py", "propagation_result.py", "so does propagated uncertainty"),
    ("runtime/studies/minimisation", "plot_minimum.py", "minimum.py", "so does a minimum"),
    ("runtime/studies/fitting", "plot_fit.py", "fit_result.py", "so does a fit"),
    ("runtime/studies/fitting/moments", "plot_moments.py", "moment_fit.py", "so does a fit of moments"),
    ("runtime/studies/comparison", "plot_comparison.py", "comparison_result.py", "so does a comparison"),
)  # fmt: skip
FILE_RINGS = {(f"{folder}/{start}", f"{folder}/{end}"): why for folder, start, end, why in RINGS}


def acyclic(files: dict[Path, set[Path]], listed: dict[tuple[str, str], str]) -> None:
    """Raise CycleError for a ring of files without the listed arrows."""

    def stays(file: Path, other: Path) -> bool:
        return not any(file.is_relative_to(start) and other == Path(end) for start, end in listed)

    kept = {file: {other for other in others if stays(file, other)} for file, others in files.items()}
    list(TopologicalSorter(kept).static_order())


def test_files_have_no_ring_within_their_rooms_either():
    acyclic(file_graph(), FILE_RINGS)


@pytest.mark.parametrize("arrow", FILE_RINGS)
def test_arrows_that_are_listed_close_a_ring(arrow):
    with pytest.raises(CycleError):
        acyclic(file_graph(), {other: why for other, why in FILE_RINGS.items() if other != arrow})


def test_the_fronts_are_imported_by_nobody_but_what_is_written_as_users_write():
    fronts = {Path(side, "__init__.py") for side in SIDES}
    importers = {file for file, others in file_graph().items() if fronts & others}
    assert {str(file.parent) for file in importers} <= {"derive/scenes", "derive/scenes/hard", "runtime/engine/model"}


def test_derive_imports_sympy_and_pydantic_where_a_file_is_read():
    foreign = ("casadi", "numpy", "scipy", "matplotlib", "hertzwerk.generated", "hertzwerk.runtime")
    assert offenders(sources("derive"), *foreign) == []
    assert offenders(sources("derive"), "sympy") != []
    importers = {file.name for file in sources("derive") if any(reaches(m, "pydantic") for m in modules(file))}
    assert importers == {"file_schema.py", "law_table.py", "urdf_elements.py"}
    loaded = "import sys; from hertzwerk.derive.exchange.user_files import law_file, urdf; sys.exit('pydantic' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", loaded], check=False).returncode == 0


@pytest.mark.parametrize("file", sources("derive/common"), ids=lambda file: file.name)
def test_common_imports_the_standard_library_and_pydantic_alone(file):
    for module in modules(file):
        own = reaches(module, "hertzwerk.derive.common", "pydantic")
        own = own or (file.name, module) == ("execute_file.py", "")  # the module that a user names
        assert module.split(".")[0] in sys.stdlib_module_names or own, module


def test_generated_modules_import_casadi_only_and_runtime_never_sympy():
    for file in sources("generated"):
        assert set(modules(file)) <= {"casadi"}, file
    assert offenders(sources("runtime"), "sympy") == []


def test_only_build_opens_the_door_to_derive_and_lazily():
    """Names for type checkers aside, of derive the other side sees what both share, and imports build's door when it is opened."""
    for file in sources("runtime"):
        for node, _, typing, at_import in imports(file):
            module = node.module or "" if isinstance(node, ast.ImportFrom) else ""
            if reaches(module, "hertzwerk.derive") and not reaches(module, "hertzwerk.derive.common") and not typing:
                assert file.name == "build.py", f"{file} imports {module}"
                assert not at_import, f"{file} imports {module} when it is imported"


# The folders, and beginnings of names, of those files that may import a library.
HOMES = {
    ("matplotlib",): ("output/plots/", "output/drawings/", "output/films/", "plot_"),
    ("click", "rich"): ("cli/",),
    ("pydantic",): ("scenario.py", "definition_file.py"),
}


@pytest.mark.parametrize("libraries", HOMES)
def test_heavy_libraries_are_imported_where_they_belong(libraries):
    importers = [
        file.relative_to(ROOT / "runtime").as_posix()
        for file in sources("runtime")
        if any(reaches(module, *libraries) for module in runs(file))
    ]
    assert importers
    for name in importers:
        assert name.startswith(HOMES[libraries]) or name.split("/")[-1].startswith(HOMES[libraries]), name


def runs(file: Path) -> set[str]:
    """Modules that a file imports when it runs: without those under TYPE_CHECKING."""
    return {found.module for found in imports(file) if not found.typing}


def test_no_test_imports_another():
    """What several tests share stands in a module that is none, beside bench.py."""
    assert [
        f"{file} imports {module}"
        for file in sources("tests")
        for module in modules(file)
        if module.split(".")[-1].startswith("test_")
    ] == []


# Names of several rooms or files, and the concept that they share; commands are named as their subjects, and a file may be named as its room.
SAME_CONCEPT = {
    "derived_histories": "histories beyond the states: their derivation, and their evaluation over a run",
    "friction": "the laws of friction, and the limits of its forces in a step",
    "lubrication": "the laws of films, and the effect that takes them",
    "start": "coordinates and speeds at t = 0: as declared, and as a run finds them",
}


def repeated(files: list[Path]) -> set[str]:
    """Names of rooms and files that occur more than once."""
    files = [file.relative_to(ROOT) for file in files if not file.parent.name.endswith("_commands")]
    rooms = {folder for file in files for folder in file.parents[:-1]}
    counts = Counter(file.stem for file in files if file.stem not in ("__init__", file.parent.name))
    counts.update(room.name for room in rooms)
    return {name for name, count in counts.items() if count > 1}


def test_a_name_stands_for_one_concept():
    assert repeated(files()) == set(SAME_CONCEPT)
    paths = [
        "derive/a/x.py", "runtime/b/x.py", "runtime/c/y.py", "derive/d/y/v.py", "derive/f/e/w.py", "runtime/e/u.py",
        "derive/g/g.py",
    ]  # fmt: skip
    assert repeated([ROOT / path for path in paths]) == {"x", "y", "e"}


def test_a_forbidden_import_would_be_found(tmp_path, monkeypatch):
    """The net has no hole where imports hide: in functions, relative, by name, under TYPE_CHECKING, as `from package import module`."""
    monkeypatch.setattr("test_architecture.ROOT" if __name__ == "test_architecture" else f"{__name__}.ROOT", tmp_path)
    file = tmp_path / "runtime" / "inner" / "x.py"
    for folder in ("runtime/inner", "runtime/pictures", "derive/scenes"):
        (tmp_path / folder).mkdir(parents=True)
    file.write_text(
        "import importlib\nfrom .. import pictures\ndef f():\n    from hertzwerk import derive\n    importlib.import_module('sympy.core')\n"
        "    importlib.import_module(f'hertzwerk.derive.scenes.{1}')\n"
        "if TYPE_CHECKING:\n    from hertzwerk.runtime.simulation import simulate\n"
    )
    (tmp_path / "runtime" / "simulation.py").touch()
    found = {"hertzwerk.runtime.pictures", "hertzwerk.derive", "sympy.core", "hertzwerk.derive.scenes"}
    assert found <= set(modules(file))
    actual = file_graph.__wrapped__()[Path("runtime/inner/x.py")]
    rooms = {f"{room}/__init__.py" for room in ("runtime/pictures", "derive", "derive/scenes")}
    assert {str(other) for other in actual} == {*rooms, "runtime/simulation.py"}


if __name__ == "__main__":
    print("digraph hertzwerk {")
    for room, others in sorted(graph().items()):
        for other in sorted(others):
            print(f'    "{room}" -> "{other}";')
    print("}")
