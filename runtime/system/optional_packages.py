"""Optional dependencies: imported when called for, or one error that names the extra to install."""

from __future__ import annotations

from importlib import import_module, util
from types import ModuleType

from hertzwerk.derive.common.faults import Fault, InputError


def required(name: str, extra: str) -> ModuleType:
    """Import a package of an extra; raises InputError that names the extra where it is missing."""
    try:
        return import_module(name)
    except ImportError as error:
        raise InputError(name, [missing(extra, name)]) from error


def missing(extra: str, *names: str) -> Fault:
    """Return the fault of packages of an extra that are not installed."""
    return Fault(
        ", ".join(names), "not installed", f"the extra [{extra}] of hertzwerk", f"pip install 'hertzwerk[{extra}]'"
    )


def missing_of(extra: str, *names: str) -> list[Fault]:
    """Return a fault that names those of the packages that are not installed, or none."""
    absent = [name for name in names if util.find_spec(name) is None]
    return [missing(extra, *absent)] if absent else []
