"""Python text of expressions over CasADi, independent of the hash seed.

One rule per type of SymPy node; a node without a rule is an error. Powers are strength-reduced (`d**(3/2)` ->
`d*sqrt(d)`), names are those of the derivation.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.algebra.box_features import Features, Stacked
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.expressions.algebra.planar_curve import (
    Between,
    ChainPoints,
    Drawn,
    DrawnTeeth,
    Entry,
    Nearest,
    Place,
    Sampled,
    Support,
)
from hertzwerk.derive.expressions.algebra.sectors import Mean, Share, Shares
from hertzwerk.derive.expressions.algebra.splines import Spline
from hertzwerk.derive.expressions.parameter import CURVE, TABLE

_SUM, _PRODUCT, _UNARY, _POWER, _ATOM = range(1, 6)


class EmitError(TypeError):
    """A SymPy node the emitter has no rule for."""


def expression_text(expression: Any) -> str:
    """Python text of a SymPy expression, over CasADi. Raises EmitError for a node without a rule."""
    return _text(sp.sympify(expression))[0]


def _text(node: Any) -> tuple[str, int]:
    rule = _RULES.get(type(node)) or next((_RULES[kind] for kind in type(node).__mro__ if kind in _RULES), None)
    if rule is None:
        raise EmitError(f"no rule to emit {type(node).__name__}: {node}")
    return rule(node)


def _wrapped(node: Any, least: int) -> str:
    text, strength = _text(node)
    return text if strength >= least else f"({text})"


def _number(node: Any) -> tuple[str, int]:
    if not node.is_finite:
        raise EmitError(f"no rule to emit {node}: it is no finite number")
    if node.is_Rational and not node.is_Integer:
        text = f"{abs(node.p)}/{node.q}"
        return (f"-{text}", _SUM) if node.p < 0 else (text, _PRODUCT)
    text = repr(float(node)) if node.is_Float or node.is_NumberSymbol else str(int(node))
    return text, (_SUM if text.startswith("-") else _ATOM)


def _sum(node: Any) -> tuple[str, int]:
    # Positive terms first, so that a sum does not begin with a sign.
    terms = sorted(((_is_negative(term), term) for term in node.args), key=operator.itemgetter(0))
    text = _wrapped(terms[0][1], _SUM)
    for negative, term in terms[1:]:
        text += f" - {_wrapped(-term, _PRODUCT)}" if negative else f" + {_wrapped(term, _SUM)}"
    return text, _SUM


def _is_negative(node: Any) -> bool:
    """Whether it is written with a sign in front; of a product SymPy would make the opposite to find out."""
    if node.is_Mul:
        return bool(node.args[0].is_Number and node.args[0].is_extended_negative)
    return not node.is_Symbol and bool(node.could_extract_minus_sign())


def _product(node: Any) -> tuple[str, int]:
    if _is_negative(node):
        return f"-{_wrapped(-node, _PRODUCT)}", _SUM
    above: list[Any] = []
    below: list[Any] = []
    for factor in node.args:
        if factor.is_Pow and factor.exp.is_number and factor.exp.is_negative:
            below.append(sp.Pow(factor.base, -factor.exp, evaluate=False) if factor.exp != -1 else factor.base)
        elif factor.is_Rational and factor.q != 1:
            above.extend([sp.Integer(factor.p)] if factor.p != 1 else [])
            below.append(sp.Integer(factor.q))
        else:
            above.append(factor)
    text = "*".join(_wrapped(factor, _PRODUCT) for factor in above) or "1"
    if below:
        quotient = "*".join(_wrapped(factor, _UNARY if len(below) == 1 else _PRODUCT) for factor in below)
        text += (
            f"/({quotient})" if len(below) > 1 or ("*" in quotient and not quotient.endswith(")")) else f"/{quotient}"
        )
    return text, _PRODUCT


def _power(node: Any) -> tuple[str, int]:
    base, exponent = node.base, node.exp
    if exponent.is_Rational and exponent.is_negative:
        return f"1/{_wrapped(sp.Pow(base, -exponent, evaluate=False) if exponent != -1 else base, _UNARY)}", _PRODUCT
    if exponent.is_Rational and exponent.q == 2:
        root, whole = f"ca.sqrt({_text(base)[0]})", exponent.p // 2
        if whole == 0:
            return root, _ATOM
        if whole == 1:  # a sign in front belongs to the first factor
            return f"{_wrapped(base, _SUM if _is_negative(base) and not base.is_Add else _PRODUCT)}*{root}", _PRODUCT
        return f"{_whole_power(base, whole)[0]}*{root}", _PRODUCT
    if exponent.is_Integer:
        return _whole_power(base, int(exponent))
    return f"{_wrapped(base, _ATOM)}**{_wrapped(exponent, _ATOM)}", _POWER


def _whole_power(base: Any, exponent: int) -> tuple[str, int]:
    text = _wrapped(base, _ATOM)
    if exponent <= 3 and base.is_Symbol:
        return "*".join([text] * exponent), _PRODUCT
    return f"{text}**{exponent}", _POWER


def _call(name: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        return f"{name}({', '.join(_text(arg)[0] for arg in node.args)})", _ATOM

    return rule


def _nested(name: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        text = _text(node.args[-1])[0]
        for arg in reversed(node.args[:-1]):
            text = f"{name}({_text(arg)[0]}, {text})"
        return text, _ATOM

    return rule


def _relation(sign: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        return f"{_wrapped(node.lhs, _SUM)} {sign} {_wrapped(node.rhs, _SUM)}", 0

    return rule


def _lambert_w(node: Any) -> tuple[str, int]:
    if len(node.args) != 2 or node.args[1] != -1:
        raise EmitError(f"no rule to emit the branch of {node}; the lower one is LambertW(x, -1)")
    return f"_lambert_w_lower({_text(node.args[0])[0]})", _ATOM


def _spline(node: Any) -> tuple[str, int]:
    table, argument, order = node.args
    return f"_spline({table_name(table)}, {_text(argument)[0]})[{order}]", _ATOM


def _sampled(helper: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        curve, *arguments = node.args
        return f"{helper}{curve.searched}({_curve(curve)}, {_vector(arguments)})", _ATOM

    return rule


def _drawn_teeth(node: Any) -> tuple[str, int]:
    curve, root, *arguments = node.args
    return f"_drawn_teeth({_curve(curve)}, {_vector(arguments)}, {_text(root)[0]})", _ATOM


def _search(helper: str) -> Callable[[Any], tuple[str, int]]:
    def rule(node: Any) -> tuple[str, int]:
        curve, samples, x, y, *arguments = node.args
        return (
            f"{helper}{curve.searched}({_curve(curve)}, {samples.name}, {_vector(arguments)}, {_vector([x, y])})",
            _ATOM,
        )

    return rule


def _between(node: Any) -> tuple[str, int]:
    first, second, one, two, *pose = node.args
    points = [point.row for point in pose if isinstance(point, ChainPoints | Place)]
    end = 4 + len(first.parameters)
    parameters = pose[4:end], pose[end : end + len(second.parameters)]
    parts = [
        _curve(first),
        _curve(second),
        one.name,
        two.name,
        *map(_vector, (*parameters, pose[:4])),
        *map(repr, points),
    ]
    return f"_between{first.searched}({', '.join(parts)})", _ATOM


def _entry(node: Any) -> tuple[str, int]:
    vector, k = node.args
    return f"{vector.name}[{int(k)}]", _ATOM


def _vector(values: Any) -> str:
    return f"ca.vertcat({', '.join(_text(value)[0] for value in values)})"


def _curve(curve: Any) -> str:
    function, data = curve_names(curve)
    return f"{function}, {data}"


def curve_names(curve: Any) -> tuple[str, str]:
    """Names of a curve's function and of its data in the module."""
    return f"{curve.name}{CURVE}", f"{curve.name.upper()}{CURVE.upper()}"


def table_name(table: Any) -> str:
    """Name of a table's polynomials in the module."""
    return f"{table.name.upper()}{TABLE}"


_RULES: dict[type, Callable[[Any], tuple[str, int]]] = {
    sp.Symbol: lambda node: (node.name, _ATOM),
    sp.Number: _number,
    sp.NumberSymbol: _number,
    sp.Add: _sum,
    sp.Mul: _product,
    sp.Pow: _power,
    sp.Abs: _call("ca.fabs"),
    sp.sign: _call("ca.sign"),
    sp.sin: _call("ca.sin"),
    sp.cos: _call("ca.cos"),
    sp.tan: _call("ca.tan"),
    sp.asin: _call("ca.asin"),
    sp.acos: _call("ca.acos"),
    sp.atan: _call("ca.atan"),
    sp.atan2: _call("ca.atan2"),
    sp.sinh: _call("ca.sinh"),
    sp.cosh: _call("ca.cosh"),
    sp.tanh: _call("ca.tanh"),
    sp.exp: _call("ca.exp"),
    sp.log: _call("ca.log"),
    sp.Min: _nested("ca.fmin"),
    sp.Max: _nested("ca.fmax"),
    Where: _call("ca.if_else"),
    Spline: _spline,
    Sampled: _sampled("_samples"),
    Drawn: _sampled("_drawn"),
    DrawnTeeth: _drawn_teeth,
    Nearest: _search("_nearest"),
    Support: _search("_support"),
    Between: _between,
    Entry: _entry,
    Stacked: lambda node: (_vector(node.args), _ATOM),
    Features: _call("_features"),
    Shares: _call("_shares"),
    Share: _entry,
    Mean: lambda node: (f"ca.dot({node.args[0].name}, {_vector(node.args[1:])})", _ATOM),
    sp.LambertW: _lambert_w,
    sp.gamma: _call("_gamma"),
    sp.StrictGreaterThan: _relation(">"),
    sp.StrictLessThan: _relation("<"),
    sp.GreaterThan: _relation(">="),
    sp.LessThan: _relation("<="),
}
