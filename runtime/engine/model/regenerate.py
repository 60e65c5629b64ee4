"""Generated modules from their scenes: derived, written, or compared with those in place."""

from __future__ import annotations

import difflib
import importlib
import pkgutil
import shlex
import tomllib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.derive.common.module_format import generated_text, stated, stated_coordinates
from hertzwerk.runtime.engine.model.build import (
    derive_digest,
    derive_text,
    equations,
    file_of,
    in_python,
    scene_from,
    source_of,
    vary,
)
from hertzwerk.runtime.system.atomic_files import write_atomically

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.readable_equations.readable_record import Readable


@dataclass(frozen=True)
class Derived:
    """Derived module of a target: the name of its scene, its coordinates if not the scene's, and the text."""

    target: str
    name: str
    coordinates: str | None
    text: str


@dataclass(frozen=True)
class Difference:
    """Difference between a module in place and the derived one, and the command that accepts the latter.

    diff    "" where no module is in place
    """

    place: Path
    diff: str
    accept: str


def derived(
    targets: Iterable[str],
    coordinates: str | None = None,
    in_place: Callable[[str, str], Path] | None = None,
) -> tuple[Derived, ...]:
    """Derive the modules of all targets or of none; InputError holds the faults of all.

    coordinates    other ones than the scenes'
    in_place       file of the module in place, by target and name of the scene: its coordinates are the default
    """
    names: set[str] = set()

    def one(target: str) -> Derived:
        scene = scene_from(target)
        present = generated_text(in_place(target, scene.name)) if in_place and not coordinates else None
        chosen = coordinates if present is None else stated_coordinates(present)
        scene = vary(scene, coordinates=chosen)
        if scene.name in names:
            raise InputError(target, [Fault(target, f"a second scene named {scene.name}", "one name per scene")])
        names.add(scene.name)
        return Derived(target, scene.name, chosen, derive_text(scene, source_of(target), chosen))

    return _all_or_none(targets, one)


def shown(targets: Iterable[str], coordinates: str | None = None) -> tuple[Readable, ...]:
    """Return the equations of all targets or of none, for people; InputError holds the faults of all.

    In the scenes' coordinates or others.
    """
    return _all_or_none(targets, lambda target: equations(vary(scene_from(target), coordinates=coordinates)))


_T = TypeVar("_T")


def _all_or_none(targets: Iterable[str], make: Callable[[str], _T]) -> tuple[_T, ...]:
    made: list[_T] = []
    errors: list[InputError] = []
    for target in targets:
        try:
            made.append(make(target))
        except InputError as error:
            errors.append(error)
    if len(errors) == 1:
        raise errors[0]
    if errors:
        all_of_them = InputError("derive", [fault for error in errors for fault in error.faults])
        all_of_them.args = ("\n\n".join(map(str, errors)),)
        raise all_of_them
    return tuple(made)


def folder_of(target: str) -> Path:
    """Return the folder of a module where none is named: that of its scene's file.

    For a built-in scene generated/ of hertzwerk's repository; raises InputError where there is none.
    """
    file = file_of(target)
    if file is not None:
        return file.parent
    subject = "derive: name a folder for the modules with --out DIR"
    for folder in (Path.cwd(), *Path.cwd().parents):
        if _project_name(folder / "pyproject.toml") == "hertzwerk":
            if derive_digest(folder / "derive") != derive_digest():
                actual = "another hertzwerk.derive in use than this repository's"
                remedy = 'pip install -e ".[dev]" --config-settings editable_mode=strict'
                raise InputError("derive", [Fault(str(folder), actual, "the same sources", remedy)])
            return folder / "generated"
    raise InputError(subject, [Fault("--out", "none", "a folder, as this is no clone of hertzwerk's repository")])


def write(modules: Sequence[Derived], folder: Path | None) -> tuple[Path, ...]:
    """Write modules into a folder, made if need be, or where `folder_of` has them; return their paths.

    Raises InputError where a file that is no generated module stands there.
    """
    paths = tuple(_place(module.target, module.name, folder or folder_of(module.target)) for module in modules)
    refuse(
        "derive",
        [
            Fault(str(path), "a file that is no generated module", "a module, or no file", "name another --out DIR")
            for path in paths
            if path.exists() and generated_text(path) is None
        ],
    )
    for path, module in zip(paths, modules, strict=True):
        path.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(path, module.text.encode())
    return paths


def _place(target: str, name: str, folder: Path) -> Path:
    """Return the file of a module in a folder, under another name where it would replace its scene."""
    path, scene = folder / f"{name}.py", file_of(target)
    same = scene is not None and path.resolve() == scene.resolve()
    return folder / f"{name}_generated.py" if same else path


def compared(
    targets: Iterable[str], coordinates: str | None, folder: Path | None
) -> tuple[tuple[str, Difference | None], ...]:
    """Return the name of each scene, and the difference of its module in place to the derived one, if any.

    In a folder, or beside the scene; of a built-in scene the installed one. Raises InputError with the faults of all.

    coordinates    other ones than those that a module in place states
    """

    def in_place(target: str, name: str) -> Path:
        built_in = folder is None and not in_python(target)
        return _installed(name) if built_in else _place(target, name, folder or folder_of(target))

    modules = derived(targets, coordinates, in_place)
    return tuple((each.name, _difference(each, in_place(each.target, each.name), folder)) for each in modules)


def _difference(module: Derived, path: Path, folder: Path | None) -> Difference | None:
    present = path.read_text(encoding="utf-8") if path.is_file() else ""
    if present == module.text:
        return None
    options = {"--coordinates": module.coordinates, "--out": folder}
    words = [str(word) for option, value in options.items() if value is not None for word in (option, value)]
    accept = shlex.join(["hertzwerk", "derive", module.target, *words])
    before, after = (text.splitlines(keepends=True) for text in (present, module.text))
    diff = difflib.unified_diff(before, after, f"{module.name}.py in place", f"{module.name}.py derived")
    return Difference(path, "".join(diff) if present else "", accept)


def generated_names() -> tuple[str, ...]:
    """Return the names of the installed generated modules, sorted; imports none of them."""
    package = importlib.import_module("hertzwerk.generated")
    return tuple(
        sorted(module.name for module in pkgutil.iter_modules(package.__path__) if not module.name.startswith("_"))
    )


def summary_of(name: str) -> str:
    """Return the summary that an installed generated module states; imports nothing."""
    return stated(_installed(name).read_text(encoding="utf-8"), "SUMMARY")


def _installed(name: str) -> Path:
    paths = [Path(folder) / f"{name}.py" for folder in importlib.import_module("hertzwerk.generated").__path__]
    return next((path for path in paths if path.is_file()), paths[0])


def _project_name(file: Path) -> str | None:
    try:
        name = tomllib.loads(file.read_text(encoding="utf-8")).get("project", {}).get("name")
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return None
    return name if isinstance(name, str) else None
