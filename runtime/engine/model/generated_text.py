"""Text of a generated module: a module made of it, and read back from one."""

from __future__ import annotations

import hashlib
import linecache
from types import ModuleType, SimpleNamespace


def module_of(name: str, text: str) -> ModuleType:
    """Return the module that a text of our own emitter is."""
    module = ModuleType(f"hertzwerk_generated_{name}")
    module.__file__ = f"<generated {name} {hashlib.sha256(text.encode()).hexdigest()[:12]}>"
    linecache.cache[module.__file__] = (len(text), None, text.splitlines(keepends=True), module.__file__)
    exec(compile(text, module.__file__, "exec"), module.__dict__)
    return module


def text_of(module: ModuleType | SimpleNamespace) -> str:
    """Return the text of a generated module; "" where there is none, as of a saved run's tables."""
    return "".join(linecache.getlines(getattr(module, "__file__", None) or ""))
