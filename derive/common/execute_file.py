"""Execution of a user's Python file, or import of a module, for the names it defines."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from types import ModuleType
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError, as_path, unreadable

_FOLDER: ContextVar[Path | None] = ContextVar("folder of the file that is executed", default=None)
_NEIGHBOURS: set[str] = set()
"""Modules that files imported from their folders: another folder may have others of these names."""


def beside(path: str | Path) -> Path:
    """Resolve a path relative to the scene file being executed; unchanged elsewhere. Raises InputError."""
    return (_FOLDER.get() or Path()) / as_path("path", path)


def names_defined_by(path: Path) -> dict[str, Any]:
    """Names defined by a Python file, which may import from its folder, anew each time.

    Raises InputError for any error in the file.
    """
    try:
        code = compile(path.read_bytes(), str(path), "exec")
    except OSError as error:
        raise InputError(str(path), [unreadable(path, error, "a readable Python file")]) from error
    except (SyntaxError, ValueError, MemoryError, RecursionError) as error:
        where = f"{path}, line {getattr(error, 'lineno', None) or 1}"
        raise InputError(str(path), [Fault(where, f"{type(error).__name__}: {error}", "Python source")]) from error
    module = ModuleType("hertzwerk_scene_file")
    module.__file__ = str(path)
    folder = path.resolve().parent
    with _imports_from(folder, 0, folder):
        sys.modules[module.__name__] = module  # dataclasses and pickling look their module up
        try:
            exec(code, module.__dict__)
        except (Exception, SystemExit) as error:  # whatever the file does wrong is the file's fault
            raise _input_error(path, error) from error
        finally:
            del sys.modules[module.__name__]
    return module.__dict__


def sympy_remedy(names: Mapping[str, Any]) -> str:
    """Return the line that makes a scene of a file's model of SymPy, "" where it has none."""
    mechanics = "sympy.physics.mechanics."
    if not any(str(getattr(value, "__module__", "")).startswith(mechanics) for value in names.values()):
        return ""
    methods = ("KanesMethod", "LagrangesMethod", "System")
    model = next((name for name, value in names.items() if type(value).__name__ in methods), "method")
    return (
        f"A model of SymPy becomes one: scene = from_sympy({model}, units={{...}}, parameters={{...}}, origin=...)"
        ".scene(scales=Scales(...)), after `from hertzwerk.derive import Scales, from_sympy`."
    )


def names_imported(name: str, wanted: str) -> dict[str, Any]:
    """Names of a module, which may be in the working folder; raises InputError for any error in it.

    `wanted` is one of them, or a module in it that is imported as well.
    """
    file = file_of_module(name)
    with _imports_from(Path.cwd(), len(sys.path), file and file.parent):  # after what is installed
        try:
            return vars(__import__(name, fromlist=[wanted]))
        except (Exception, SystemExit) as error:
            if isinstance(error, ModuleNotFoundError) and f"{name}.".startswith(f"{error.name}."):
                expected = "a module that is installed, or in the working folder"
                raise InputError(name, [Fault(name, "no module of this name", expected)]) from error
            raise _input_error(file or Path(name), error) from error


def file_of_module(name: str) -> Path | None:
    """Return the file of a module without executing anything of its packages, None where there is none."""
    folders: Any = [*sys.path, str(Path.cwd())]
    spec, known = None, ""
    for part in name.split("."):
        known = f"{known}.{part}".lstrip(".")
        finders = (finder.find_spec(known, folders) for finder in sys.meta_path)
        spec = next(filter(None, finders), None) if folders else None
        folders = None if spec is None else spec.submodule_search_locations
    return Path(spec.origin) if spec is not None and spec.origin and spec.has_location else None


@contextmanager
def _imports_from(folder: Path, place: int, beside: Path | None) -> Iterator[None]:
    """Import from a folder as well, at a place in the path; what was imported from another is forgotten."""
    while _NEIGHBOURS:
        sys.modules.pop(_NEIGHBOURS.pop(), None)
    before = set(sys.modules)
    sys.path.insert(place, str(folder))
    token = _FOLDER.set(beside)
    try:
        yield
    finally:
        _FOLDER.reset(token)
        sys.path.remove(str(folder))
        _NEIGHBOURS.update(name for name in set(sys.modules) - before if _is_beside(name, folder))


def _is_beside(name: str, folder: Path) -> bool:
    """Whether a module is a file of the folder, or of a package in it."""
    package = name.partition(".")[0]
    file = getattr(sys.modules.get(package), "__file__", None)
    return file is not None and Path(file).parent in (folder, folder / package)


def _input_error(path: Path, error: BaseException) -> InputError:
    frames = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
    where = f"{path}, line {frames[-1].lineno}" if frames else str(path)
    if isinstance(error, InputError):
        return InputError(f"{where}: {error.subject}", error.faults)
    actual = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    return InputError(
        str(path), [Fault(where, actual, "a scene file that runs", "the file was executed and raised this error")]
    )
