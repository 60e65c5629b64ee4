"""Repairs of a wrong dimension: a value of a constant exponent, another power, a missing factor.

For a text the sentence refers to the text; for a SymPy expression, whose order is SymPy's, it explains: `K is
N/m^1.5: K*d**n is a force only for n = 3/2`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp
from sympy.solvers.solveset import NonlinearError

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension, canonical, quantity
from hertzwerk.derive.expressions.dimension.rules import Walk
from hertzwerk.derive.expressions.dimension.tree import Node

Offer = tuple[Any, str | None]
"""Exponent that makes the units consistent, if there is one, and a sentence."""


def repair(walk: Walk, culprit: Node, found: Dimension, expected: Dimension) -> Offer:
    """Find a repair that gives the culprit the expected dimension."""
    missing = expected / found
    symbols = {symbol for exponent in missing.exponents for symbol in exponent.free_symbols}
    if symbols:
        return _constant(walk, culprit, expected, missing, sorted(symbols, key=str))
    if culprit.condition:
        return None, None
    return _power(walk, culprit, expected, missing) or (None, _lacking(walk, culprit, found, missing))


def _constant(walk: Walk, culprit: Node, expected: Dimension, missing: Dimension, symbols: list[Any]) -> Offer:
    """The value of a constant that makes the exponents agree."""
    for symbol in symbols:
        try:
            solution = sp.linsolve([sp.numer(exponent) for exponent in missing.exponents], [symbol])
        except NonlinearError:
            continue
        for (value,) in solution:
            if culprit.expr is None:
                return value, f"consistent only with {symbol} = {value}"
            powers = [factor for factor in _operands(culprit) if factor.op == "**" and factor.args[1].expr == symbol]
            if len(powers) == 1:
                return value, _only_for(walk, culprit, powers[0], symbol, value, expected)
            return value, f"{culprit.expr} is {quantity(expected)} only for {symbol} = {value}"
    return None, f"no value of {', '.join(map(str, symbols))} makes it {_unit(expected)}"


def _power(walk: Walk, culprit: Node, expected: Dimension, missing: Dimension) -> Offer | None:
    """Another exponent on one factor: of a bare name first, d in E*sqrt(R)*d, then the least, L in L**2.

    What is offered is substituted, and has the expected dimension.
    """
    powers = grouped((factor.name, factor) for factor in _factors(culprit))
    everywhere = [node.name for node in culprit.walk() if node.op == "name"]
    offers = []
    for place, (name, parts) in enumerate(powers.items()):
        dimension, total = walk.table[name], sp.Add(*(part.exponent * part.outer for part in parts))
        if dimension.dimensionless or everywhere.count(name) > len(parts):  # it stands elsewhere too
            continue
        step, outer = _logarithm(missing, dimension), parts[0].outer
        # a smaller or larger power, or the factor on the wrong side of the line; no other change of sign
        if step is None or not ((step + total) * total > 0 or step == -2 * total):
            continue
        if any(part.outer != outer for part in parts):
            continue
        changed = _with_exponent(culprit, parts[0].path, name, parts[0].exponent + step / outer)
        if walk(changed) == expected:
            offers.append(
                (total == 1, -abs(step + total), place, parts, sp.Add(*(p.exponent for p in parts)) + step / outer)
            )
    if not offers:
        return None
    *_, parts, exponent = max(offers, key=lambda offer: offer[:3])
    first, name = parts[0], parts[0].name
    if culprit.expr is not None and len(parts) == 1 and first.node in _operands(culprit):
        return exponent, _only_for(walk, culprit, first.node, None, exponent, expected)
    power = "" if exponent == 1 else f"**{exponent}" if exponent.is_Integer and exponent > 0 else f"**({exponent})"
    total = " in all" if len(parts) > 1 else ""
    stead = f" in place of {walk.tree.quote(first.node)}" if first.node.op == "sqrt" and not total else ""
    length = exponent == 2 and first.outer == 1 and walk.table[name] == _LENGTH
    other = f", or with {name}{total} and a factor of unit m" if length else ""
    return exponent, f"with {name}{power}{total}{stead} it is {_unit(expected)}{other}"


def _operands(node: Node) -> tuple[Node, ...]:
    return node.args if node.op == "product" else (node,)


@dataclass(frozen=True)
class _Factor:
    """Power of a name in a product.

    `path` leads to its `node`; `outer` is the power that the node is raised to in all.
    """

    name: Any
    node: Node
    path: tuple[int, ...]
    exponent: Any
    outer: Any


def _factors(node: Node, outer: Any = sp.S.One, path: tuple[int, ...] = ()) -> Iterable[_Factor]:
    """Yield the factors of a product that are powers of a name, as far as exponents are numbers."""
    exponent = sp.S.One
    if node.op in ("inverse", "sqrt"):
        exponent = sp.S.NegativeOne if node.op == "inverse" else sp.S.Half
    elif node.op == "**" and node.args[1].number is not None:
        exponent = canonical(node.args[1].number)
    elif node.op not in ("name", "product", "neg"):
        return
    inner = node.args[0] if node.op in ("sqrt", "**") else node
    if inner.op == "name":
        yield _Factor(inner.name, node, path, exponent, outer)
        return
    for k, factor in enumerate(node.args[:1] if node.op == "**" else node.args):
        yield from _factors(factor, outer * exponent, (*path, k))


def _with_exponent(node: Node, path: tuple[int, ...], name: Any, exponent: Any) -> Node:
    """The tree with a power of the name at the end of the path."""
    if not path:
        return Node("**", args=(Node("name", name=name), Node("number", number=exponent)))
    changed = _with_exponent(node.args[path[0]], path[1:], name, exponent)
    return replace(node, args=(*node.args[: path[0]], changed, *node.args[path[0] + 1 :]))


def _only_for(walk: Walk, culprit: Node, factor: Node, symbol: Any, value: Any, expected: Dimension) -> str:
    """Sentence such as `K is N/m^1.5: K*d**n is a force only for n = 3/2`, for a factor d**n.

    A number in place of n is named at the end: `, not 1`.
    """
    base, power = factor.expr.as_base_exp()
    names = {str(name) for name in culprit.expr.free_symbols}
    name = symbol or sp.Symbol("p" if "n" in names else "n")
    of_base = walk(factor) if factor.op == "name" else walk(factor.args[0])
    rest = culprit.expr / factor.expr
    prefix = "" if rest.is_number else f"{rest} is {walk(culprit) / of_base**power}: "
    text = f"{prefix}{rest * base**name} is {quantity(expected)} only for {name} = {value}"
    if value == 2 and of_base == _LENGTH:
        return f"{text}; multiplied by a length, for {name} = 1"
    return text if symbol else f"{text}, not {sp.sstr(power, full_prec=False)}"


def _lacking(walk: Walk, culprit: Node, dimension: Dimension, missing: Dimension) -> str:
    """Sentence on the missing factor, and on the number that may hide it."""
    culprit = culprit.args[0] if culprit.op == "neg" else culprit
    if dimension == ONE and not culprit.args:
        return f"{walk.tree.quote(culprit)} would need the unit {missing}"
    factors = culprit.args if culprit.op == "product" else ()
    numbers = [node for node in factors if node.number is not None and node.op in ("number", "neg")]
    caution = ""
    if len(numbers) == 1 and abs(numbers[0].number) not in (0, 1):
        caution = f"; if the number {walk.tree.quote(numbers[0])} hides it, declare it with its unit"
    return f"a factor of unit {missing} is missing{caution}"


def _unit(dimension: Dimension) -> str:
    return "dimensionless" if dimension == ONE else str(dimension)


def _logarithm(value: Dimension, base: Dimension) -> Any:
    """The rational y with base**y == value, if there is one."""
    pairs = zip(value.exponents, base.exponents, strict=True)
    ratios = {v / b for v, b in pairs if b != 0}
    ratio = next(iter(ratios))
    return ratio if len(ratios) == 1 and ratio.is_Rational and base**ratio == value else None


_LENGTH = Dimension(L=1)
