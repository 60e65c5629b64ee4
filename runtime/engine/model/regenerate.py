"""Generated modules from their scenes: derived, written, or compared with those in place."""

from __future__ import annotations

import difflib
import importlib
import pkgutil
import tomllib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.model.build import (
    derive_digest,
    derive_text,
    equations,
    is_file,
    scene_from,
    source_of,
    vary,
)
from hertzwerk.runtime.system.atomic_files import write_atomically

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.readable_equations.readable_record import Readable


@dataclass(frozen=True)
class Derived:
    """Derived module of a target: the name of its scene, and the text."""

    target: str
    name: str
    text: str


@dataclass(frozen=True)
class Difference:
    """Difference between a module in place and the derived one, and the command that accepts the latter."""

    name: str
    diff: str
    accept: str


def derived(targets: Sequence[str], coordinates: str | None = None) -> tuple[Derived, ...]:
    """Derive the modules of all targets or of none; InputError holds the faults of all.

    In the scenes' coordinates or others.
    """
    seen: set[str] = set()

    def one(target: str) -> Derived:
        scene = vary(scene_from(target), coordinates=coordinates)
        if scene.name in seen:
            raise InputError(target, [Fault(target, f"a second scene named {scene.name}", "one name per scene")])
        seen.add(scene.name)
        return Derived(target, scene.name, derive_text(scene, source_of(target)))

    return _all_or_none(targets, one)


def shown(targets: Sequence[str], coordinates: str | None = None) -> tuple[Readable, ...]:
    """Return the equations of all targets or of none, for people; InputError holds the faults of all.

    In the scenes' coordinates or others.
    """
    return _all_or_none(targets, lambda target: equations(vary(scene_from(target), coordinates=coordinates)))


_T = TypeVar("_T")


def _all_or_none(targets: Sequence[str], make: Callable[[str], _T]) -> tuple[_T, ...]:
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


def repository_folder(targets: Sequence[str]) -> Path:
    """Return generated/ of the hertzwerk repository around the working folder.

    Raises InputError where the targets need another folder.
    """
    subject = "derive: name a folder for the modules with --out DIR"
    files = [target for target in targets if is_file(target)]
    if files:
        raise InputError(subject, [Fault("--out", "none", f"a folder for the module of {file}") for file in files])
    for folder in (Path.cwd(), *Path.cwd().parents):
        if _project_name(folder / "pyproject.toml") == "hertzwerk":
            if derive_digest(folder / "derive") != derive_digest():
                found = "another hertzwerk.derive in use than this repository's"
                remedy = 'pip install -e ".[dev]" --config-settings editable_mode=strict'
                raise InputError("derive", [Fault(str(folder), found, "the same sources", remedy)])
            return folder / "generated"
    raise InputError(subject, [Fault("--out", "none", "a folder, as this is no clone of hertzwerk's repository")])


def write(modules: Sequence[Derived], folder: Path) -> tuple[Path, ...]:
    """Write modules into a folder, made if need be; return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = tuple(folder / f"{module.name}.py" for module in modules)
    for path, module in zip(paths, modules, strict=True):
        write_atomically(path, module.text.encode())
    return paths


def difference(module: Derived, folder: Path | None) -> Difference | None:
    """Return the difference of a module in a folder, or the installed one, to the derived one; or None."""
    path = folder / f"{module.name}.py" if folder is not None else _installed(module.name)
    present = path.read_text(encoding="utf-8") if path is not None and path.is_file() else ""
    if present == module.text:
        return None
    before, after = (text.splitlines(keepends=True) for text in (present, module.text))
    diff = difflib.unified_diff(before, after, f"{module.name}.py in place", f"{module.name}.py derived")
    where = f" --out {folder}" if folder is not None else " --out DIR" if is_file(module.target) else ""
    return Difference(module.name, "".join(diff), f"hertzwerk derive {module.target}{where}")


def generated_names() -> tuple[str, ...]:
    """Return the names of the installed generated modules, sorted; imports none of them."""
    package = importlib.import_module("hertzwerk.generated")
    return tuple(
        sorted(found.name for found in pkgutil.iter_modules(package.__path__) if not found.name.startswith("_"))
    )


def _installed(name: str) -> Path | None:
    package = importlib.import_module("hertzwerk.generated")
    return next((path for folder in package.__path__ if (path := Path(folder) / f"{name}.py").is_file()), None)


def _project_name(file: Path) -> str | None:
    try:
        name = tomllib.loads(file.read_text(encoding="utf-8")).get("project", {}).get("name")
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError):
        return None
    return name if isinstance(name, str) else None
