"""Public names of a package, imported on first use (PEP 562).

The one list of them is what the `__init__` of the package imports for type checkers:

if TYPE_CHECKING:
    from package.place import Name as Name
else:
    __all__, __getattr__, __dir__ = handed_on(__name__)
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable
from importlib import import_module
from typing import Any


def handed_on(package: str) -> tuple[list[str], Callable[[str], Any], Callable[[], list[str]]]:
    """Return `__all__`, `__getattr__`, `__dir__` of a package, from the first `if` of its source."""
    namespace = vars(sys.modules[package])
    tree = ast.parse(namespace["__loader__"].get_source(package))
    listed = next(node for node in tree.body if isinstance(node, ast.If))
    homes = {alias.name: row.module for row in listed.body if isinstance(row, ast.ImportFrom) for alias in row.names}

    def look_up(name: str) -> Any:
        """Return the value of a name, imported from its module; a sub-package is a name too."""
        home = homes.get(name)
        if home is None:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value = import_module(f"{package}.{name}") if home == package else getattr(import_module(home), name)
        namespace[name] = value
        return value

    return sorted(homes), look_up, lambda: sorted(homes)
