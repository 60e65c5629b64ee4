"""Text of a generated module: a module made of it, and read back from one."""

from __future__ import annotations

import hashlib
import linecache
from functools import cache
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.module_format import EMPTY, FORMAT, generated_text, require_intact


def module_of(name: str, text: str, path: Path | None = None) -> ModuleType:
    """Return the module that a text of our own emitter is; raises InputError for any other text.

    path    its file, where it has one
    """
    require_intact(text, name, path)
    module = ModuleType(f"hertzwerk_generated_{name}")
    module.__file__ = f"<generated {name} {hashlib.sha256(text.encode()).hexdigest()[:12]}>"
    linecache.cache[module.__file__] = (len(text), None, text.splitlines(keepends=True), module.__file__)
    exec(compile(text, module.__file__, "exec"), module.__dict__)
    return module


def text_of(module: ModuleType | SimpleNamespace) -> str:
    """Return the text of a generated module; "" where there is none, as of a saved run's tables."""
    return "".join(linecache.getlines(getattr(module, "__file__", None) or ""))


def module_in(path: Path) -> ModuleType | None:
    """Return the generated module in a file, None for any other file.

    Raises InputError for a module of another format, or with an altered text.
    """
    text = generated_text(path)
    return None if text is None else module_of(path.stem, text, path)


def require_tables(module: ModuleType | SimpleNamespace) -> None:
    """Raise InputError for a module of another format, without a table, or imported from an altered file."""
    if isinstance(module, ModuleType) and module.__spec__ is not None:
        _require_intact_file(module)
    missing = ", ".join(name for name in EMPTY if not hasattr(module, name))
    form = getattr(module, "FORMAT", None)
    if form != FORMAT or missing:
        name, actual = getattr(module, "NAME", "module"), f"the format {form!r}"
        raise InputError(name, [Fault("module", f"{actual} without {missing}" if missing else actual, repr(FORMAT))])


@cache
def _require_intact_file(module: ModuleType) -> None:
    text = text_of(module)
    if text:  # without a source there is nothing to compare
        require_intact(text, module.__name__.rpartition(".")[2])


def with_tables(**content: Any) -> SimpleNamespace:
    """Return what serves as a module: functions and tables that are given, all others without rows."""
    return SimpleNamespace(**{**EMPTY, "FORMAT": FORMAT, **content})
