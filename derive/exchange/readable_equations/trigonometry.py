"""Contract products of sines and cosines: cos a cos b + sin a sin b = cos(a - b)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from typing import Any

import sympy as sp

MOST_TERMS = 80  # of an expanded sum that is searched


def contract_products(expression: Any, angle: Callable[[Any], Any]) -> Any:
    """Contract products of sines and cosines, and cos^2 + sin^2, to fewer terms; also in powers.

    `angle` chooses the form of a sum of angles.
    """
    if not expression.has(sp.sin, sp.cos):
        return expression
    powers = expression.replace(
        lambda node: node.is_Pow and node.base.is_Add, lambda node: _contracted(node.base, angle) ** node.exp
    )  # from within
    return _contracted(powers, angle)


def _contracted(expression: Any, angle: Callable[[Any], Any]) -> Any:
    """Contract the terms of a sum, and nothing within them."""
    parts = sp.Add.make_args(expression)
    turning = [part for part in parts if part.has(sp.sin, sp.cos)]
    terms = [_split(term) for part in turning for term in sp.Add.make_args(sp.expand(part))]
    if len(terms) > MOST_TERMS:
        return expression
    count = len(terms)
    while _contract_one(terms, angle):
        pass
    if len(terms) == count:
        return expression
    collected: dict[Any, Any] = {}
    for rest, trig in terms:
        factor = sp.Mul(*trig.elements())
        collected[factor] = collected.get(factor, sp.S.Zero) + rest
    still = (part for part in parts if part not in turning)
    return sp.Add(*still, *(sp.factor(rest) * factor for factor, rest in collected.items()))


def _split(term: Any) -> tuple[Any, Counter[Any]]:
    """Split a term into its factor without sines and cosines, and its sines and cosines."""
    trig: Counter[Any] = Counter()
    rest = []
    for factor in sp.Mul.make_args(term):
        base, power = factor.as_base_exp()
        if isinstance(base, sp.sin | sp.cos) and power.is_Integer and power > 0:
            trig[base] += int(power)
        else:
            rest.append(factor)
    return sp.Mul(*rest), trig


def _contract_one(terms: list[tuple[Any, Counter[Any]]], angle: Callable[[Any], Any]) -> bool:
    """Contract the first pair of terms that can be contract_products; False where there is none."""
    for i, (first, trig) in enumerate(terms):
        for j in range(i + 1, len(terms)):
            second, other = terms[j]
            if second not in (first, -first):
                continue
            common = trig & other
            together = _together(trig - common, other - common, 1 if second == first else -1, angle)
            if together is not None:
                rest, own = _split(together)
                del terms[j]
                terms[i] = (first * rest, common + own)
                _collect(terms)
                return True
    return False


def _together(one: Counter[Any], two: Counter[Any], sign: int, angle: Callable[[Any], Any]) -> Any:
    """Contract `one` + sign * `two` to one sine, cosine or number; None where that is impossible."""
    a, b = list(one.elements()), list(two.elements())
    if len(a) != 2 or len(b) != 2:
        return None
    kinds = [sum(isinstance(f, sp.cos) for f in factors) for factors in (a, b)]
    if sorted(kinds) == [0, 2]:
        cosines, sines = (a, b) if kinds[0] == 2 else (b, a)
        x, y = (f.args[0] for f in cosines)
        if Counter((x, y)) != Counter(f.args[0] for f in sines) or (x == y and sign < 0):
            return None
        return (1 if kinds[0] == 2 else sign) * sp.cos(angle(x - y if sign > 0 else x + y))
    if kinds == [1, 1]:
        (x,) = (f.args[0] for f in a if isinstance(f, sp.sin))
        (y,) = (f.args[0] for f in a if isinstance(f, sp.cos))
        if {sp.cos(x), sp.sin(y)} != set(b):
            return None
        return sp.sin(angle(x + y if sign > 0 else x - y))
    return None


def _collect(terms: list[tuple[Any, Counter[Any]]]) -> None:
    """Combine the first two like terms whose coefficients are equal or opposite."""
    for i, (first, trig) in enumerate(terms):
        for j in range(i + 1, len(terms)):
            second, other = terms[j]
            if trig == other and second in (first, -first):
                del terms[j]
                terms[i] = (first + second, trig)
                if terms[i][0] == 0:
                    del terms[i]
                return
