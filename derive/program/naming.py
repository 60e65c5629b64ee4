"""Names in words for constants and shared subexpressions that have none of their own.

They are names of the text alone. The program keeps its numbered symbols, by which SymPy orders sums and products: a
name changes no rounding.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Set
from typing import Any

import sympy as sp

LONGEST = 48
"""Most characters of a name in words; what would need more keeps its number."""

_COEFFICIENTS = {
    sp.Integer(1): "",
    sp.Integer(2): "twice_",
    sp.Rational(1, 2): "half_",
    sp.Rational(1, 3): "third_of_",
    sp.Rational(1, 4): "quarter_of_",
    sp.Rational(2, 5): "two_fifths_of_",
}
_POWERS = {2: "_squared", 3: "_cubed"}
_JOINTS = ("_plus_", "_minus_", "_times_", "_over_")
_FRONTS = ("minus_", "inverse_", *filter(None, _COEFFICIENTS.values()))


def names_in_words(
    numbered: Iterable[tuple[sp.Symbol, Any]], known: Mapping[str, str], taken: Set[str]
) -> dict[str, str]:
    """Name of each numbered symbol -> its name in words, or itself where none is short and free.

    `numbered` are symbols and their expressions in order, `known` are names given before.
    """
    names, used = dict(known), {*taken, *known.values()}
    for symbol, expression in numbered:
        words = _sum(expression, names) if expression.is_Add else _product(expression, names)
        usable = words is not None and words.isidentifier() and len(words) <= LONGEST and words not in used
        names[symbol.name] = words if usable and words is not None else symbol.name
        used.add(names[symbol.name])
    return names


def _sum(expression: Any, names: Mapping[str, str]) -> str | None:
    terms = [("minus", _product(-term, names)) if term.as_coeff_Mul()[0] < 0 else ("plus", _product(term, names))
             for term in expression.args]  # fmt: skip
    terms.sort(key=lambda term: term[0] == "minus")  # as they are printed
    texts = [text for _, text in terms if text is not None and not _compound(text)]
    if len(texts) < len(terms):
        return None
    whole = "".join(f"_{sign}_{text}" for (sign, _), text in zip(terms, texts, strict=True))
    return whole.removeprefix("_plus_").removeprefix("_")


def _product(expression: Any, names: Mapping[str, str]) -> str | None:
    coefficient, rest = expression.as_coeff_Mul()
    before = _COEFFICIENTS.get(abs(coefficient))
    if rest == 1:
        return "one" if coefficient == 1 else None
    above = [_power(factor, names) for factor in sp.Mul.make_args(rest) if not _below(factor)]
    below = [_power(1 / factor, names) for factor in sp.Mul.make_args(rest) if _below(factor)]
    parts = [part for part in (*above, *below) if part is not None]
    if before is None or len(parts) < len(above) + len(below) or len(below) > 1:
        return None
    text = "_times_".join(parts[: len(above)])
    if below:
        text = f"{text}_over_{parts[-1]}" if above else f"inverse_{parts[-1]}"
    return f"{'minus_' if coefficient < 0 else ''}{before}{text}"


def _power(factor: Any, names: Mapping[str, str]) -> str | None:
    base, exponent = factor.as_base_exp()
    text = _atom(base, names)
    if text is None or exponent == 1:
        return text
    if exponent == sp.S.Half:
        return f"sqrt_{text}"
    if not exponent.is_Integer or exponent < 0:  # exp(-1) is a power of E that no quotient takes below
        return None
    return text + _POWERS.get(int(exponent), f"_to_the_{exponent}")


def _atom(node: Any, names: Mapping[str, str]) -> str | None:
    if isinstance(node, (sp.sin, sp.cos, sp.tan, sp.asin, sp.acos, sp.atan)):
        inner = _atom(node.args[0], names)
        return inner and f"{type(node).__name__}_{inner}"
    if node.is_Integer or node.is_NumberSymbol:
        return str(node)
    if not node.is_Symbol:
        return None
    text = names.get(node.name)
    if text is None:
        return str(node.name)
    return None if text == node.name or text.startswith(_FRONTS) or _compound(text) else text


def _compound(text: str) -> bool:
    return any(joint in text for joint in _JOINTS)


def _below(factor: Any) -> bool:
    return bool(factor.is_Pow and factor.exp.is_number and factor.exp.is_negative)
