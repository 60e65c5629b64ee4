"""Rules of dimensions, one per operation; an operation without a rule is an error.

A dimensional base takes a rational exponent or one of constant parameters; a product with a literal 0 has every
dimension, as 0 has.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol

import sympy as sp

from hertzwerk.derive.expressions.dimension.dimension import ONE, ZERO, Dimension, DimensionError, canonical
from hertzwerk.derive.expressions.dimension.expression import Expression
from hertzwerk.derive.expressions.dimension.symbolic import Symbolic
from hertzwerk.derive.expressions.dimension.tree import COMPARISONS, Node


@dataclass(frozen=True)
class Signature:
    """Rule of an operation: the dimensions of its arguments (equal, none, any), and its own."""

    arguments: Literal["alike", "pure", "any"]
    result: Literal["same", "one"]


class Walk(Protocol):
    """Protocol of the walker as rules and repairs need it."""

    tree: Expression | Symbolic
    table: Mapping[Any, Dimension]
    constants: Collection[Any]

    def __call__(self, node: Node) -> Dimension:
        """Dimension of a node."""

    def alike(self, node: Node, args: Sequence[Node]) -> Dimension:
        """Common dimension of all arguments."""

    def pure(self, node: Node, arg: Node, rule: str) -> DimensionError:
        """Fault of an argument that should be dimensionless."""

    def fault(
        self,
        node: Node,
        found: Dimension | str,
        expected: Dimension | str,
        reason: str,
        culprit: Node | None = None,
        operands: Sequence[Node] = (),
    ) -> DimensionError:
        """A fault at a node."""


def _product(walk: Walk, node: Node) -> Dimension:
    total = ONE
    for factor in node.args:
        total = walk.tree.bounded(node, total * walk(factor))
    return total


def _power(walk: Walk, node: Node) -> Dimension:
    base, exponent = node.args
    dimension = walk(base)
    if exponent.op == "number":
        result: Dimension = dimension ** canonical(exponent.number)
        return result
    if not walk(exponent).dimensionless:
        raise walk.pure(node, exponent, "an exponent is dimensionless")
    if dimension.dimensionless:
        return dimension
    names = dict.fromkeys(part.name for part in exponent.walk() if part.op == "name")
    strange = [str(name) for name in names if name not in walk.constants]
    value = None if strange else walk.tree.value(exponent, walk.constants)
    if value is not None and (value.is_Rational or (value.free_symbols and value.is_finite is not False)):
        powered: Dimension = dimension**value
        return powered
    quoted = walk.tree.quote(exponent)
    cause = f"{', '.join(strange)}, no constant parameter" if strange else f"{quoted}, which is not rational"
    reason = f"in {walk.tree.quote(node)}, the unit of a power of {dimension} depends on {cause}"
    expected = "a rational exponent, or one of constant parameters"
    raise walk.fault(node, f"{dimension} to the power {quoted}", expected, reason, operands=(base, exponent))


def _where(walk: Walk, node: Node) -> Dimension:
    for arg in node.args:
        walk(arg)
    return walk.alike(node, [arg for arg in node.args if not arg.condition])


def _spline(walk: Walk, node: Node) -> Dimension:
    (argument,) = node.args
    table, _, order = node.expr.args
    per, of = (Dimension.from_unit(unit) for unit in table.units)
    if not (dimension := walk(argument)).matches(per):
        quoted = walk.tree.quote(argument)
        reason = f"in {walk.tree.quote(node)}, {quoted} is {dimension}, and {table} is a table of arguments in {per}"
        raise walk.fault(node, dimension, per, reason, argument, (argument,))
    result: Dimension = of / per**order
    return result


def _derivative(walk: Walk, node: Node) -> Dimension:
    total = walk(node.args[0])
    for variable in node.args[1:]:
        total = total / walk(variable)
    return total


def _integral(walk: Walk, node: Node) -> Dimension:
    function, *limits = node.args
    return walk(function) * walk.alike(node, limits)


def _determinant(walk: Walk, node: Node) -> Dimension:
    if node.args[0].shape is None:
        raise TypeError("a matrix without a shape")
    return walk(node.args[0]) ** node.args[0].shape[0]


def _rows(
    arguments: Literal["alike", "pure", "any"], result: Literal["same", "one"], *ops: str
) -> dict[str, Signature]:
    return dict.fromkeys(ops, Signature(arguments, result))


SIGNATURES: Mapping[str, Signature | Callable[[Walk, Node], Dimension]] = {
    "number": lambda walk, node: ZERO if node.number == 0 else ONE,
    "inf": lambda walk, node: ZERO,
    "product": _product,
    "@": _product,
    "**": _power,
    "where": _where,
    "spline": _spline,
    "diff": _derivative,
    "integrate": _integral,
    "det": _determinant,
    **dict.fromkeys(("inverse", "inv"), lambda walk, node: ONE / walk(node.args[0])),
    "sqrt": lambda walk, node: walk(node.args[0]) ** sp.Rational(1, 2),
    **_rows("alike", "same", "sum", "neg", "max", "min", "abs", "mod", "matrix", "transpose", "trace"),
    **_rows("alike", "one", "atan2", *COMPARISONS),
    **_rows("any", "one", "pi", "true", "sign", "Heaviside"),
    **_rows(
        "pure", "one", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh"
    ),
    **_rows("pure", "one", "exp", "log", "LambertW", "gamma", "erf", "floor", "ceiling", "and", "or", "not"),
}

NOUNS = {
    "sum": "a sum",
    "matrix": "a matrix",
    "where": "a choice",
    "integrate": "a variable of integration with its limits",
}
NOUNS |= dict.fromkeys(COMPARISONS, "a comparison")
