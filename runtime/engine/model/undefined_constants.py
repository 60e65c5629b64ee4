"""Constants of a module without a value: the expression that they come from, and the parameters in it."""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator
from types import ModuleType, SimpleNamespace
from typing import NamedTuple

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.model.generated_text import text_of


class Origin(NamedTuple):
    """First of a module's constants without a finite value.

    Its expression, the values in that, and the parameters that it follows from.
    """

    name: str
    value: float
    expression: str
    operands: dict[str, float]
    parameters: tuple[str, ...]


def origin(module: ModuleType | SimpleNamespace, p: np.ndarray) -> Origin | None:
    """Return where a constant is first not finite at parameters p (SI); None for a module without a text.

    The text of a module is of our own emitter: its function `constants` is made anew to return what it computes on the way.
    """
    tree = ast.parse(text_of(module))
    function = next((n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == "constants"), None)
    if function is None:
        return None
    function.body[-1] = ast.Return(ast.Call(ast.Name("locals", ast.Load()), [], []))
    scope = dict(vars(module))
    exec(compile(ast.fix_missing_locations(ast.Module([function], [])), "<constants>", "exec"), scope)
    results = scope["constants"](ca.DM(p))
    values = {name: float(value) for name, value in results.items() if isinstance(value, ca.DM) and value.numel() == 1}
    made = {name: value for statement in function.body for name, value in _assigned(statement)}
    for name, expression in made.items():
        if not math.isfinite(values.get(name, 0.0)):
            operands = {other: values[other] for other in _names(expression) if other in values}
            rows = [row[0] for row in module.PARAMETERS]
            parameters = tuple(rows[i] for i in dict.fromkeys(_places(name, made)))
            return Origin(name, values[name], ast.unparse(expression), operands, parameters)
    return None


def _assigned(statement: ast.stmt) -> Iterator[tuple[str, ast.expr]]:
    """Yield the names that a statement assigns, each with its expression or the call that returns it."""
    if not isinstance(statement, ast.Assign):
        return
    target, value = statement.targets[0], statement.value
    names = target.elts if isinstance(target, ast.Tuple) else [target]
    values = value.elts if isinstance(target, ast.Tuple) and isinstance(value, ast.Tuple) else [value] * len(names)
    yield from ((ast.unparse(name), each) for name, each in zip(names, values, strict=True))


def _names(expression: ast.expr) -> Iterator[str]:
    yield from dict.fromkeys(node.id for node in ast.walk(expression) if isinstance(node, ast.Name))


def _places(name: str, made: dict[str, ast.expr]) -> Iterator[int]:
    """Yield the places in p that a value follows from."""
    expression = made[name]
    if isinstance(expression, ast.Subscript) and isinstance(expression.slice, ast.Constant):
        yield int(str(expression.slice.value))
        return
    for other in _names(expression):
        if other in made:
            yield from _places(other, made)
