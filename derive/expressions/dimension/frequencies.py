"""Search for frequencies that are taken as angular speeds: cos(f*t), J*f**2 with f in 1/s.

A factor of 2 pi may be missing, which units cannot show, because an angle has none. rad/s and rpm are angular speeds.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import sympy as sp

from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.expressions.dimension.dimension import canonical
from hertzwerk.derive.expressions.dimension.tree import Node

_PERIODIC = ("sin", "cos", "tan")
_TURN = 1e-3  # relative distance of a number from 2 pi, or its square, within which it is one
_PER_SECOND = parse_unit("1/s").exponents


def frequencies_as_angular(root: Node, units: Mapping[Any, str], quote: Callable[[Node], str]) -> Iterator[str]:
    """Yield advice on names in 1/s in the argument of a periodic function, or squared in a product.

    units    of the names, as declared
    """
    plain = {name for name, unit in units.items() if (u := parse_unit(unit)).exponents == _PER_SECOND and not u.angle}
    angular = {name for name, unit in units.items() if parse_unit(unit).angle}
    said: set[Any] = set()
    for node, product in _products(root):
        factors = list(_factors(product))
        if any(_is_turn(factor) or factor.name in angular for factor, _ in factors):
            continue
        powers: dict[Any, Any] = {}
        for factor, power in factors:
            if units.get(factor.name, "1") != "1":
                powers[factor.name] = powers.get(factor.name, 0) + power
        for name, power in powers.items():
            squared = abs(power) == 2 and len(powers) > 1
            if name in plain and name not in said and (node.op in _PERIODIC or squared):
                said.add(name)
                how = f"write 2*pi*{name} if it counts turns, or declare it in rad/s"
                yield f"{quote(node)} takes {name} [{units[name]}] as an angular speed: {how}"


def _products(node: Node) -> Iterator[tuple[Node, Node]]:
    """Yield the largest products, and the terms in arguments of periodic functions, beside that function."""
    inner = list(node.args)
    if node.op in ("product", "inverse", "sqrt", "**"):
        yield node, node
        factors = [factor for factor, _ in _factors(node)]
        inner = inner if factors == [node] else factors
    elif node.op in _PERIODIC:
        yield from ((node, term) for term in _terms(node.args[0]))
    for part in inner:
        yield from _products(part)


def _terms(node: Node) -> Iterator[Node]:
    if node.op in ("sum", "neg"):
        for term in node.args:
            yield from _terms(term)
    else:
        yield node


def _factors(node: Node, power: Any = sp.S.One) -> Iterator[tuple[Node, Any]]:
    """Yield what a product consists of, with exponents, as far as they are numbers."""
    if node.op in ("product", "neg"):
        for factor in node.args:
            yield from _factors(factor, power)
    elif node.op in ("inverse", "sqrt"):
        yield from _factors(node.args[0], -power if node.op == "inverse" else power / 2)
    elif node.op == "**" and node.args[1].number is not None:
        yield from _factors(node.args[0], power * canonical(node.args[1].number))
    else:
        yield node, power


def _is_turn(node: Node) -> bool:
    """Whether a factor is pi, or a number such as 3.1416, 6.2832, 39.478."""
    if node.op == "pi" or node.number is None:
        return node.op == "pi"
    turns = abs(float(node.number)) / (2 * math.pi)
    return any(abs(turns / unit - 1) < _TURN for unit in (0.5, 1, 2 * math.pi))
