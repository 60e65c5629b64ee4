"""Execution of a user's Python file, as by `python file.py`, for the names it defines."""

from __future__ import annotations

import sys
import traceback
from contextvars import ContextVar
from pathlib import Path
from types import ModuleType
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError, unreadable

_FOLDER: ContextVar[Path | None] = ContextVar("folder of the file that is executed", default=None)
_NEIGHBOURS: set[str] = (
    set()
)  # modules that files imported from their folders: another folder may have others of these names


def beside(path: str | Path) -> Path:
    """Resolve a path relative to the scene file being executed; unchanged elsewhere."""
    folder = _FOLDER.get()
    return Path(path) if folder is None else folder / path


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
    while _NEIGHBOURS:
        sys.modules.pop(_NEIGHBOURS.pop(), None)
    before = set(sys.modules)
    sys.modules[module.__name__] = module  # dataclasses and pickling look their module up
    sys.path.insert(0, str(folder))
    token = _FOLDER.set(folder)
    try:
        exec(code, module.__dict__)
    except (Exception, SystemExit) as error:  # whatever the file does wrong is the file's fault
        raise _input_error(path, error) from error
    finally:
        _FOLDER.reset(token)
        sys.path.remove(str(folder))
        del sys.modules[module.__name__]
        _NEIGHBOURS.update(name for name in set(sys.modules) - before if _is_beside(name, folder))
    return module.__dict__


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
    found = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
    return InputError(
        str(path), [Fault(where, found, "a scene file that runs", "the file was executed and raised this error")]
    )
