"""Text and tree of an expression, with bounds on exponents against hostile text."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import PicklableError
from hertzwerk.derive.expressions.dimension.dimension import Dimension, canonical
from hertzwerk.derive.expressions.dimension.symbolic import converted
from hertzwerk.derive.expressions.dimension.tree import Node

MAX_DEGREE = 6  # degree of an exponent in its names
MAX_OPERATIONS = 60  # operations in an exponent of a dimension

_COMPLEX = f"an exponent of degree at most {MAX_DEGREE}, made of at most four names"


class TextError(PicklableError):
    """Expression text that cannot be read: `position` (from 1), found, expected, and remedy."""

    def __init__(self, text: str, start: int, found: str, expected: str, remedy: str = "") -> None:
        self.text, self.position, self.found, self.expected, self.remedy = text, start + 1, found, expected, remedy
        around = text if len(text) <= 60 else text[max(0, start - 25) : start + 25].strip()
        way_out = f"; {remedy}" if remedy else ""
        super().__init__(
            f"expression {around!r}, character {self.position}: found {found}, expected {expected}{way_out}"
        )


@dataclass(frozen=True)
class Expression:
    """A text and its tree."""

    source: str
    root: Node

    def quote(self, node: Node) -> str:
        """Text of a node."""
        return self.source[node.start : node.end]

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names in the text, in the order written."""
        return tuple(dict.fromkeys(node.name for node in self.root.walk() if node.op == "name"))

    def __str__(self) -> str:
        return self.source

    def part(self, node: Node, operands: Sequence[int]) -> Node:
        """Part of a sum or product from the first operand kept to the last, as far as the text can be cut."""
        first, last = operands[0], operands[-1]
        while first > 0 and node.args[first].op == "inverse":  # a divisor needs its dividend
            first -= 1
        if first == last:
            return node.args[first]
        (start, _), (_, end) = node.spans[first], node.spans[last]
        inside = slice(first, last + 1)
        return replace(node, start=start, end=end, args=node.args[inside], spans=node.spans[inside])

    def value(self, node: Node, constants: Any) -> Any:
        """Exponent of constants as a SymPy expression; bounded, because comparison expands it."""
        names = {part.name for part in node.walk() if part.op == "name"}
        if max(_degree(node)) > MAX_DEGREE or len(names) > 4:
            raise TextError(self.source, node.start, "an exponent too long to compare", _COMPLEX)
        value = to_sympy(self, constants, node)
        exact = value.xreplace({x: canonical(float(x)) for x in value.atoms(sp.Float)})
        if exact.has(sp.zoo, sp.nan, sp.oo, sp.I):
            written = f"the exponent {self.quote(node)}, which is no number here"
            raise TextError(self.source, node.start, written, "a finite real number")
        return exact

    def bounded(self, node: Node, dimension: Dimension) -> Dimension:
        """The dimension; raises TextError if its exponents cannot be compared in bounded time."""
        if any(not e.is_Rational and e.count_ops() > MAX_OPERATIONS for e in dimension.exponents):
            raise TextError(self.source, node.start, "exponents too long to compare", _COMPLEX)
        return dimension


def _degree(node: Node) -> tuple[int, int]:
    """Bounds on the degree of numerator and denominator of an exponent, in its names."""
    if not node.args:
        return (1, 0) if node.op == "name" else (0, 0)
    parts = [_degree(arg) for arg in node.args]
    if node.op in ("sum", "neg"):
        below = sum(part[1] for part in parts)
        return max(above + below - own for above, own in parts), below
    if node.op == "product":
        return sum(part[0] for part in parts), sum(part[1] for part in parts)
    if node.op == "inverse":
        return parts[0][1], parts[0][0]
    if node.op == "**" and node.args[1].number is not None:
        size = max(1, math.ceil(abs(node.args[1].number)))
        above, below = (size * parts[0][0], size * parts[0][1])
        return (above, below) if node.args[1].number >= 0 else (below, above)
    return 1 + sum(map(max, parts)), 0


def to_sympy(expression: Expression, symbols: Mapping[str, Any], node: Node | None = None) -> Any:
    """SymPy expression of a tree (or one of its nodes), with names replaced by `symbols`.

    Derivatives and integrals stay unevaluated. Raises KeyError for a name that `symbols` lacks, TextError where SymPy
    finds the result undefined, as in tan(pi/2).
    """
    node = expression.root if node is None else node
    try:
        result = converted(node, symbols)
    except (ArithmeticError, TypeError, ValueError):  # raised by SymPy for an undefined operand
        result = sp.nan
    if result.has(sp.zoo, sp.nan):
        raise TextError(expression.source, node.start, "an expression without a value", "one that is defined")
    return result
