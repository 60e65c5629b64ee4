"""Conversion of trees to SymPy expressions and back."""

from __future__ import annotations

import operator
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import BooleanFalse, BooleanTrue
from sympy.matrices import MatrixBase

from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.sectors import Mean, Share
from hertzwerk.derive.expressions.algebra.splines import Spline
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.dimension.tree import Node

MAX_NESTED = 2  # deepest nesting of functions of numbers that SymPy evaluates exactly


# --- to SymPy ---------------------------------------------------------------------------------------------------------


def converted(node: Node, symbols: Mapping[str, Any]) -> Any:
    """SymPy expression of a node, with names replaced by `symbols`.

    Raises any exception of SymPy for an undefined operand.
    """
    if node.op == "number":
        return _number(node.number or 0.0)
    if node.op == "name":
        return symbols[node.name]
    if node.op in ("pi", "inf"):
        return sp.pi if node.op == "pi" else -sp.oo if node.name else sp.oo
    if node.number is not None and not node.condition and node.nested > MAX_NESTED:
        return sp.Float(node.number, 17)  # exact evaluation of cos(cos(...)) takes unbounded time
    args = [converted(arg, symbols) for arg in node.args]
    if node.op == "matrix":
        if node.shape is None:
            raise TypeError("a matrix without a shape")
        return sp.ImmutableDenseMatrix(*node.shape, args)
    if node.op == "product" and node.shape is not None:
        scalars = [arg for arg, child in zip(args, node.args, strict=True) if child.shape is None]
        matrix = next(arg for arg, child in zip(args, node.args, strict=True) if child.shape is not None)
        return sp.MatMul(sp.Mul(*scalars), matrix, evaluate=False)
    if node.shape is not None and node.op in _OF_MATRICES:
        return _OF_MATRICES[node.op](*args)
    return SYMPY[node.op](*args)


def _number(value: float) -> Any:
    """Exact rational of a short decimal (1.5 -> 3/2), so that exponents compare exactly; else a double."""
    fraction = Fraction(repr(value))
    short = abs(fraction.numerator) < _SHORT and fraction.denominator < _SHORT
    return sp.Rational(fraction.numerator, fraction.denominator) if short else sp.Float(value, 17)


_SHORT = 10**12  # exact as doubles, so that their quotient is the decimal number rounded once


SYMPY: dict[str, Callable[..., Any]] = {
    "sum": sp.Add, "product": sp.Mul, "neg": operator.neg, "inverse": lambda x: 1 / x, "**": sp.Pow, "sqrt": sp.sqrt,
    "exp": sp.exp, "log": sp.log, "sin": sp.sin, "cos": sp.cos, "tan": sp.tan, "asin": sp.asin, "acos": sp.acos,
    "atan": sp.atan, "atan2": sp.atan2, "sinh": sp.sinh, "cosh": sp.cosh, "tanh": sp.tanh, "abs": sp.Abs,
    "min": sp.Min, "max": sp.Max, "sign": sp.sign, "gamma": sp.gamma, "LambertW": sp.LambertW, "where": Where, "diff": sp.Derivative,
    "integrate": lambda f, x, *bounds: sp.Integral(f, (x, *bounds)),
    "<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge, "==": sp.Eq, "!=": sp.Ne, "and": sp.And, "or": sp.Or, "not": sp.Not,
    "det": sp.Determinant, "trace": sp.Trace,
}  # fmt: skip
"""Operation -> the SymPy class or function for it; the classes are read back as their operations."""

_OF_MATRICES: dict[str, Callable[..., Any]] = {
    "sum": lambda *terms: sp.MatAdd(*terms, evaluate=False), "neg": lambda a: sp.MatMul(-1, a, evaluate=False),
    "@": lambda a, b: sp.MatMul(a, b, evaluate=False), "transpose": sp.Transpose, "inv": sp.Inverse,
    "diff": sp.Derivative, "integrate": lambda f, x, *bounds: sp.Integral(f, (x, *bounds)),
}  # fmt: skip


# --- from SymPy -------------------------------------------------------------------------------------------------------

_OPERATIONS: dict[type, str] = {made: op for op, made in SYMPY.items() if isinstance(made, type)} | {
    sp.MatAdd: "sum", sp.MatMul: "product", sp.ImmutableDenseMatrix: "matrix", sp.Transpose: "transpose", sp.Inverse: "inv", sp.Mod: "mod",
    **{f: f.__name__ for f in (sp.asinh, sp.acosh, sp.atanh, sp.erf, sp.floor, sp.ceiling, sp.Heaviside)},
}  # fmt: skip
_PLAIN = {made: _OPERATIONS[made] for made in (sp.Add, sp.Mul, sp.Pow)}


class Symbolic:
    """Trees of SymPy expressions, quoted as SymPy prints them."""

    def quote(self, node: Node) -> str:
        """Printed expression of a node."""
        return str(node.expr)

    def part(self, node: Node, operands: Sequence[int]) -> Node:
        """Product of the factors kept; a sum stays whole, since its order is SymPy's."""
        if node.op == "sum" or len(operands) == len(node.args):
            return node
        args = tuple(node.args[k] for k in operands)
        return args[0] if len(args) == 1 else replace(node, args=args, expr=sp.Mul(*(arg.expr for arg in args)))

    def value(self, node: Node, constants: Collection[Any]) -> Any:
        """The exponent itself."""
        return node.expr

    def bounded(self, node: Node, dimension: Dimension) -> Dimension:
        """The dimension itself: SymPy has already compared its exponents."""
        return dimension


@lru_cache(maxsize=1024)
def symbolic(expression: Any) -> Node:
    """Root of the tree of an immutable SymPy expression."""
    return reader()(expression)


def reader() -> Callable[[Any], Node]:
    """Reader of immutable SymPy expressions; equal sub-expressions, also of two of them, share a node."""
    nodes: dict[Any, Node] = {}

    def read(expr: Any) -> Node:
        node = nodes.get(expr)
        if node is None:
            node = nodes[expr] = _node(expr, read)
        return node

    return read


def _node(expr: Any, read: Callable[[Any], Node]) -> Node:
    """Make one node; expressions without an operation keep the name of their SymPy class."""
    op = _PLAIN.get(type(expr))  # nearly all nodes are one of these or a name
    if op is not None:
        return Node(op, args=tuple(map(read, expr.args)), expr=expr)
    if isinstance(expr, (sp.Symbol, AppliedUndef)):
        return Node("name", name=expr, expr=expr)
    if isinstance(expr, sp.Number) and expr.is_extended_real and expr is not sp.nan:
        return Node("inf", expr=expr) if expr.is_infinite else Node("number", number=expr, expr=expr)
    if isinstance(expr, sp.NumberSymbol):
        return Node("pi", expr=expr)
    if isinstance(expr, (BooleanTrue, BooleanFalse)):
        return Node("true", expr=expr)
    args = expr.args
    if isinstance(expr, sp.Piecewise):
        args = (*(condition for _, condition in args), *(branch for branch, _ in args))
        return Node("where", args=tuple(map(read, args)), expr=expr)
    if isinstance(expr, sp.Integral):
        whole = read(expr.function)
        for limit in expr.limits:
            whole = Node("integrate", args=(whole, *map(read, limit)), expr=expr)
        return whole
    if isinstance(expr, sp.Derivative) and all(count.is_Integer for _, count in expr.variable_count):
        args = (expr.expr, *(variable for variable, count in expr.variable_count for _ in range(count)))
    elif isinstance(expr, sp.ImmutableDenseMatrix):
        args = expr.flat()
    elif isinstance(expr, Spline):
        return Node("spline", args=(read(expr.args[1]),), expr=expr)
    elif isinstance(expr, Mean):  # of shares, which are pure numbers
        return Node("sum", args=tuple(map(read, args[1:])), expr=expr)
    elif isinstance(expr, Share):
        return Node("number", number=sp.S.One, expr=expr)
    op = _OPERATIONS.get(type(expr))
    shape = expr.shape if expr.is_Matrix else None
    return (
        Node(type(expr).__name__, expr=expr)
        if op is None
        else Node(op, args=tuple(map(read, args)), shape=shape, expr=expr)
    )


def as_immutable(expression: Any) -> Any:
    """The expression as an immutable SymPy object; raises SympifyError if it is no expression."""
    return expression.as_immutable() if isinstance(expression, MatrixBase) else sp.sympify(expression, strict=True)
