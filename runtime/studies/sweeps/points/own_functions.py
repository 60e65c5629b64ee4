"""Digest of a user's function: its code and what that uses, so that a changed one is known as another."""

from __future__ import annotations

import functools
import hashlib
import types
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from hertzwerk.derive.common.faults import Fault, InputError

PLAIN = (int, float, complex, str, bytes, bool, type(None), type(Ellipsis))


def digest(name: str, function: Callable[..., Any]) -> str:
    """Return the digest of a function: its code, values, and what it uses of its own module.

    Comments and layout do not matter. Raises InputError for enclosed values that cannot be distinguished.
    """
    try:
        described = repr(_described(function, getattr(function, "__module__", None), ()))
    except _UnknownError as error:
        remedy = "pass such values as numbers or text"
        raise InputError(
            "sweep", [Fault(f"functions[{name!r}]", str(error), "numbers, text, functions", remedy)]
        ) from None
    return hashlib.sha256(described.encode()).hexdigest()[:32]


class _UnknownError(TypeError):
    """A value whose changes could not be noticed."""


def _described(value: Any, home: str | None, within: tuple[int, ...]) -> Any:
    """Return plain values that are equal for equal code and values; `within`: functions under way."""

    def go(each: Any) -> Any:
        return _described(each, home, within)

    if isinstance(value, PLAIN):
        return (type(value).__name__, repr(value))
    if isinstance(value, tuple | list):
        return (type(value).__name__, *map(go, value))
    if isinstance(value, set | frozenset):
        return ("set", *sorted(map(repr, map(go, value))))
    if isinstance(value, Mapping):
        return ("mapping", *((go(key), go(each)) for key, each in value.items()))
    if isinstance(value, np.ndarray | np.generic):
        return (
            "array",
            str(value.dtype),
            np.shape(value),
            hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest(),
        )
    if isinstance(value, functools.partial):
        return ("partial", go(value.func), go(value.args), go(value.keywords))
    if isinstance(value, types.MethodType):
        return ("method", go(value.__func__), go(value.__self__))
    if isinstance(value, types.ModuleType):
        return ("module", value.__name__)
    if isinstance(value, types.FunctionType) and value.__module__ == home:
        if id(value) in within:
            return "recursion"
        return _function(value, home, (*within, id(value)))
    if isinstance(value, type | types.FunctionType | types.BuiltinFunctionType | np.ufunc) or _is_wrapped(value):
        return ("name", getattr(value, "__module__", ""), getattr(value, "__qualname__", value.__name__))
    raise _UnknownError(f"a value of type {type(value).__name__}, enclosed or used, whose changes cannot be noticed")


def _is_wrapped(value: Any) -> bool:
    """Return whether a value is a function of another package that is no plain function, as NumPy's are."""
    return callable(value) and hasattr(value, "__wrapped__") and hasattr(value, "__name__")


def _function(function: types.FunctionType, home: str | None, within: tuple[int, ...]) -> Any:
    cells = [cell.cell_contents for cell in function.__closure__ or ()]
    used = {
        name: function.__globals__[name]
        for name in sorted({*_names(function.__code__)})
        if name in function.__globals__
    }
    parts = (function.__defaults__, function.__kwdefaults__, cells, used)
    return ("function", _code(function.__code__), *(_described(part, home, within) for part in parts))


def _names(code: types.CodeType) -> Iterator[str]:
    """Yield the names of globals and attributes in code, and in code within it."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, types.CodeType):
            yield from _names(constant)


def _code(code: types.CodeType) -> Any:
    constants = tuple(
        _code(each) if isinstance(each, types.CodeType) else _described(each, None, ()) for each in code.co_consts
    )
    return (code.co_code.hex(), constants, code.co_names, code.co_varnames, code.co_freevars)
