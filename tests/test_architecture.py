"""The arrows of the design, read from the imports themselves: every room, and the rooms it may import.

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
HALLS = {
    ("runtime", "integrate"),
    ("runtime", "pictures"),
    ("runtime", "sweeps"),
}  # whose sub-folders are rooms of their own

# Rooms are folders, and the loose files beside them; "." is the folder's own __init__. The arrows are all there are, in functions and under
# TYPE_CHECKING too. Rooms of the same side go by their name alone.
ROOMS = {
    "derive": {
        ".": "algebra audit contact declare derivation effects exported faults files imported laws mechanism",
        "algebra": "faults identifiers units",
        "alike": "contact declare effects mechanism module program",
        "audit": "algebra declare dimension faults html laws mechanism program units",
        "contact": "algebra dimension effects faults identifiers laws mechanism motion units",
        "declare": "algebra dimension effects faults html identifiers laws mechanism units",
        "derivation": "alike audit declare emit faults module motion program readings",
        "dimension": "algebra faults units",
        "effects": "algebra dimension faults identifiers laws mechanism program units",
        "emit": "faults program",
        "exported": "algebra declare dimension faults mechanism module motion program",
        "faults": "",
        "files": "algebra audit declare derivation dimension effects faults identifiers laws mechanism units",
        "html": "",
        "identifiers": "faults",
        "imported": "algebra audit declare dimension effects exported faults identifiers mechanism motion units",
        "laws": "algebra faults html mechanism units",
        "mechanism": "algebra dimension faults identifiers units",
        "module": "algebra audit contact declare dimension effects faults laws mechanism motion program",
        "motion": "algebra audit declare dimension effects faults mechanism program",
        "program": "algebra dimension mechanism",
        "readable": "algebra audit declare derivation effects laws mechanism module program",
        "readings": "algebra declare dimension effects mechanism module motion program",
        "scenes": ". contact declare effects laws mechanism sheets",
        "sheets": "algebra audit contact declare dimension effects emit faults laws mechanism program units",
        "units": "",
    },
    "runtime": {
        ".": "comparing derive/faults design effects fitting inputs loading measured model parameter_fit simulation solution "
        "statics sweeps",
        "accuracy": "",
        "cli": "accuracy derive/audit derive/faults derive/sheets derive/units design effects export fitting hard_cases host inputs "
        "integrate/tableaux loading measured model parameter_fit pictures pictures/draw pictures/motion pictures/studies report run sensitivity "
        "simulation solution start statics studies sweeps sweeps/points tables validate work_precision",
        "command_line": "cli",
        "comparing": "measured model pictures/studies solution",
        "design": "derive/declare derive/dimension derive/faults derive/files derive/html derive/units host inputs loading model "
        "pictures/sweeps run sensitivity simulation solution start sweeps sweeps/points",
        "effects": "accuracy derive/declare derive/faults inputs integrate/step loading model run simulation solution start",
        "export": "accuracy derive/faults derive/html derive/units host integrate/events integrate/loop integrate/step integrate/tableaux model run "
        "report sensitivity simulation solution start tables",
        "fitting": "derive/faults derive/html design inputs loading measured model run sensitivity simulation solution start sweeps",
        "hard_cases": "host integrate/loop integrate/step integrate/tableaux loading model run simulation solution",
        "host": "derive/faults",
        "inputs": "derive/faults derive/units measured model run",
        "integrate": "host integrate/events integrate/loop integrate/step model",
        "integrate/alike": "model",
        "integrate/events": "integrate/alike integrate/friction integrate/step integrate/tableaux model",
        "integrate/friction": "",
        "integrate/loop": "host integrate/alike integrate/events integrate/step integrate/tableaux model",
        "integrate/step": "host integrate/alike integrate/friction integrate/tableaux model",
        "integrate/tableaux": "host",
        "loading": "derive/declare derive/faults integrate/loop integrate/step integrate/tableaux model pictures/draw tables",
        "measured": "accuracy derive/faults derive/units host model solution",
        "model": "derive/audit derive/declare derive/derivation derive/dimension derive/exported derive/faults derive/files derive/laws "
        "derive/readable derive/scenes derive/sheets derive/units host",
        "package": "derive/declare derive/faults loading simulation",
        "parameter_fit": "fitting measured model pictures/studies run",
        "pictures": "host model run solution start",
        "pictures/draw": "derive/faults host model pictures run solution start",
        "pictures/motion": "derive/faults host pictures pictures/draw solution",
        "pictures/sweeps": "derive/faults pictures solution",
        "pictures/studies": "accuracy derive/sheets effects fitting integrate/tableaux measured pictures studies validate "
        "work_precision",
        "report": "accuracy derive/html derive/readable host model pictures pictures/draw run solution",
        "run": "accuracy derive/faults derive/units host integrate integrate/alike integrate/loop integrate/step integrate/tableaux model solution "
        "start",
        "sensitivity": "accuracy derive/faults host integrate/events integrate/loop integrate/step integrate/tableaux model solution start",
        "simulation": "accuracy derive/faults host inputs integrate/step loading model pictures pictures/draw "
        "pictures/motion report run sensitivity solution tables",
        "solution": "accuracy derive/faults derive/units host integrate/alike integrate/loop integrate/step integrate/tableaux model",
        "start": "derive/faults host integrate/step integrate/tableaux model",
        "statics": "derive/faults derive/html host inputs integrate/friction integrate/step loading model pictures/draw run solution start",
        "studies": "derive/faults derive/sheets derive/units effects host loading measured model pictures simulation solution "
        "sweeps",
        "sweeps": "derive/declare derive/faults derive/files derive/html derive/units host inputs loading model run sensitivity "
        "simulation solution start pictures/sweeps sweeps/kept sweeps/points tables",
        "sweeps/kept": "derive/faults derive/units model run solution",
        "sweeps/points": "derive/faults derive/units host inputs model run start",
        "tables": "derive/faults derive/html derive/units host model solution",
        "validate": "derive/faults derive/files derive/sheets derive/units inputs integrate/tableaux loading model run "
        "simulation solution",
        "work_precision": "accuracy derive/faults host integrate/loop integrate/tableaux model run sensitivity simulation solution",
    },
}


def arrows() -> dict[str, set[str]]:
    """ROOMS, every room by its full name."""

    def full(side: str, room: str) -> str:
        return side if room == "." else room if room.partition("/")[0] in SIDES else f"{side}/{room}"

    return {
        full(side, room): {full(side, other) for other in others.split()}
        for side, rooms in ROOMS.items()
        for room, others in rooms.items()
    }


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


def room_of(path: Path) -> str:
    """Room of a file or folder: its side alone for a top-level __init__, the folder below it, or the loose file's name."""
    parts = path.with_suffix("").parts
    if parts[-1] == "__init__":
        parts = parts[:-1]
    depth = 3 if parts[:2] in HALLS and len(parts) > 3 else 2
    return "/".join(parts[:depth])


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


@cache
def graph() -> dict[str, set[str]]:
    """Rooms and the rooms that their files import."""
    found: dict[str, set[str]] = {}
    for file, others in file_graph().items():
        room = room_of(file)
        found.setdefault(room, set()).update({room_of(other) for other in others} - {room})
    return found


def test_every_arrow_between_rooms_is_listed():
    assert graph() == arrows()


def test_the_arrows_have_no_ring():
    list(TopologicalSorter(arrows()).static_order())


def test_an_arrow_back_closes_a_ring():
    back = arrows() | {"derive/units": {"runtime/simulation"}}
    with pytest.raises(CycleError):
        list(TopologicalSorter(back).static_order())


# Arrows between files of one room that close a ring, and why they stay: from a folder or file, to a file.
FILE_RINGS = {
    (
        "derive/declare/soundness",
        "derive/declare/scene.py",
    ): "a scene checks itself when it is made; its checks name its type",
    (
        "runtime/sweeps/stored_rows.py",
        "runtime/sweeps/sweep_table.py",
    ): "a sweep saves and reads itself; the format imports what it makes",
}


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
    fronts = {"derive", "runtime"}
    assert {room for room, others in graph().items() if fronts & others} <= {"derive/scenes", "runtime/model"}


def test_derive_imports_sympy_and_nothing_of_the_other_side():
    assert (
        offenders(
            sources("derive"),
            "casadi",
            "numpy",
            "scipy",
            "matplotlib",
            "hertzwerk.generated",
            "hertzwerk.runtime",
        )
        == []
    )
    assert offenders(sources("derive"), "sympy") != []


def test_derive_imports_pydantic_only_where_a_file_is_read():
    assert {file.name for file in sources("derive") if any(reaches(m, "pydantic") for m in modules(file))} == {
        "form.py",
        "lawtable.py",
        "urdf_elements.py",
    }
    loaded = "import sys; from hertzwerk.derive.files import lawfile, urdf; sys.exit('pydantic' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", loaded], check=False).returncode == 0


HTML = [str(file.relative_to(ROOT / "derive")) for file in sources("derive/html")]


SHARED = ["units.py", "faults.py", "identifiers.py", "files/tomlfile.py", "files/form.py", *HTML]


@pytest.mark.parametrize("name", SHARED)
def test_what_both_sides_share_imports_the_standard_library_and_pydantic(name):
    for module in modules(ROOT / "derive" / name):
        own = reaches(module, "hertzwerk.derive.faults", "hertzwerk.derive.html", "pydantic")
        assert module.split(".")[0] in sys.stdlib_module_names or own, module


def test_generated_modules_import_casadi_only():
    for file in sources("generated"):
        assert set(modules(file)) <= {"casadi"}, file


def test_runtime_never_imports_sympy():
    assert offenders(sources("runtime"), "sympy") == []


def test_only_build_opens_the_door_to_derive_and_lazily():
    """Names for type checkers aside, of derive the other side sees what both share, and imports build's door when it is opened."""
    shared = (
        "hertzwerk.derive.units",
        "hertzwerk.derive.faults",
        "hertzwerk.derive.identifiers",
        "hertzwerk.derive.files.form",
        "hertzwerk.derive.files.tomlfile",
        "hertzwerk.derive.html",
    )
    for file in sources("runtime"):
        for node, _, typing, at_import in imports(file):
            module = node.module or "" if isinstance(node, ast.ImportFrom) else ""
            if reaches(module, "hertzwerk.derive") and not reaches(module, *shared) and not typing:
                names = {alias.name for alias in node.names}
                if module == "hertzwerk.derive" and names <= {"units", "faults", "identifiers", "html"}:
                    continue
                assert file.name == "build.py", f"{file} imports {module}"
                assert not at_import, f"{file} imports {module} when it is imported"


COMMANDS = [
    "accuracy",
    "animate",
    "audit",
    "compare",
    "derive",
    "draw",
    "effects",
    "export",
    "fit",
    "hardcases",
    "laws",
    "minimise",
    "propagate",
    "reports",
    "run",
    "studies",
    "statics",
    "sweep",
]
CLI = {
    *(f"cli/{name}.py" for name in ["__init__", "target", "terminal"]),
    *(f"cli/commands/{name}.py" for name in COMMANDS),
}
PICTURES = {
    "pictures/plot.py",
    "pictures/saving.py",
    "pictures/arrangement.py",
    "pictures/plot_panel.py",
    *(f"pictures/motion/{name}.py" for name in ["film", "moving_paper", "stage", "writers"]),
    *(
        f"pictures/studies/plot_{name}.py"
        for name in ["accuracy", "band", "comparison", "effects", "fit", "laws", "moments", "page"]
    ),
    "pictures/sweeps/plot_minimum.py",
    "pictures/sweeps/plot_sweep.py",
    "pictures/sweeps/plot_uncertainty.py",
    *(f"pictures/draw/{name}.py" for name in ["drawing", "insets", "labels", "paper", "picture", "gallery"]),
}


@pytest.mark.parametrize(
    ("libraries", "home"),
    [
        (("matplotlib",), PICTURES),
        (("click", "rich"), CLI),
        (("pydantic",), {"validate/scenario.py", "sweeps/sweep_file.py"}),
    ],
)
def test_heavy_libraries_have_one_importer(libraries, home):
    importers = {
        file.relative_to(ROOT / "runtime").as_posix()
        for file in sources("runtime")
        if any(reaches(module, *libraries) for module in runs(file))
    }
    assert importers == home


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


# Base names of several files, and the concept that they share.
SAME_CONCEPT = {
    "audit": "the audit of units, and the command that prints it",
    "equations": "the equations of motion, and those of a scene for people",
    "loops": "the constraints of closed loops, and the functions of them in a module",
    "lubrication": "the laws of films, and the effect that takes them",
    "readings": "histories beyond the states: their derivation, and their evaluation over a run",
    "scales": "sizes that errors are measured by: as declared, their equations, and their numbers",
    "start": "coordinates and speeds at t = 0: as declared, and their functions in a module",
    "study": "a study's rows and what follows from them, of effects and of work-precision",
}


def repeated(files: list[Path]) -> set[str]:
    """Base names that occur more than once."""
    counts = Counter(file.stem for file in files if file.stem != "__init__")
    return {name for name, count in counts.items() if count > 1}


def test_a_base_name_stands_for_one_concept():
    assert repeated(files()) == set(SAME_CONCEPT)


def test_a_repeated_base_name_would_be_found():
    paths = [
        "derive/a/x.py",
        "runtime/b/x.py",
        "runtime/c/y.py",
        "runtime/d/y.py",
        "derive/a/z.py",
        "derive/b/z.py",
        "derive/c/w.py",
    ]
    assert repeated([ROOT / path for path in paths]) == {"x", "y", "z"}


def test_a_room_holds_about_a_dozen_files():
    """The built-in scenes and the commands aside, one a file, of which there are as many as there are."""
    sizes = Counter(file.parent for file in files() if file.stem != "__init__")
    assert {
        str(folder): size for folder, size in sizes.items() if size > 14 and folder.name not in ("scenes", "commands")
    } == {}


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
    assert {"hertzwerk.runtime.pictures", "hertzwerk.derive", "sympy.core", "hertzwerk.derive.scenes"} <= set(
        modules(file)
    )
    file_graph.cache_clear()
    found = graph.__wrapped__()["runtime/inner"]
    file_graph.cache_clear()
    assert found == {"runtime/pictures", "derive", "derive/scenes", "runtime/simulation"}


if __name__ == "__main__":
    print("digraph hertzwerk {")
    for room, others in sorted(graph().items()):
        for other in sorted(others):
            print(f'    "{room}" -> "{other}";')
    print("}")
