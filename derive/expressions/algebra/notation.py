"""Print expressions in Python syntax and in LaTeX."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter
from sympy.printing.str import StrPrinter

from hertzwerk.derive.expressions.algebra.functions import Where, with_pieces

_EULER = sp.Symbol("e_Euler")


class _Text(StrPrinter):  # type: ignore[misc]  # SymPy is untyped
    """Printer of Python syntax as read by `hertzwerk audit --expr`."""

    def _print_Exp1(self, _: Any) -> str:
        return "exp(1)"  # E is a modulus

    def _print_Function(self, node: Any) -> str:
        name = {"Where": "where", "Max": "max", "Min": "min", "Abs": "abs"}.get(node.func.__name__, node.func.__name__)
        return f"{name}({', '.join(map(self._print, node.args))})"

    _print_Max = _print_Min = _print_Abs = _print_Function


class _Latex(LatexPrinter):  # type: ignore[misc]
    """LaTeX printer with an upright Euler's number, distinct from the restitution e."""

    def _print_exp(self, node: Any, exp: str | None = None) -> str:
        power = rf"\mathrm{{e}}^{{{self._print(node.args[0])}}}"
        return power if exp is None else rf"\left({power}\right)^{{{exp}}}"


class _Running(_Latex):
    """LaTeX printer for the equations of a scene.

    Sums begin with a positive term; branches, also those of an else, are cases; functions of one symbol have no brackets.
    """

    def _needs_function_brackets(self, argument: Any) -> bool:
        return not argument.is_Symbol

    def _as_ordered_terms(self, expression: Any, order: Any = None) -> list[Any]:
        terms = super()._as_ordered_terms(expression, order)
        return sorted(terms, key=_is_negative) if _is_negative(terms[0]) else terms

    def _print_Where(self, node: Any, exp: str | None = None) -> str:
        rows = ""
        while isinstance(node, Where):
            condition, value, node = node.args
            rows += rf"{self._print(value)} & \text{{if }} {self._print(condition)} \\ "
        cases = rf"\begin{{cases}} {rows}{self._print(node)} & \text{{else}} \end{{cases}}"
        return cases if exp is None else rf"\left({cases}\right)^{{{exp}}}"


def _is_negative(term: Any) -> bool:
    return bool(term.could_extract_minus_sign())


def text_of(expression: Any) -> str:
    """An expression in Python syntax, `where(condition, a, b)` for a branch, or `min(a, b)`."""
    return str(_Text().doprint(tidy(_with_least(expression))))


def latex_of(expression: Any, letters: Mapping[Any, str] | None = None) -> str:
    """An expression in LaTeX; with the names `letters`, in the style of the equations of a scene."""
    shown = _with_least(expression)
    if letters is not None:
        names = {_EULER: r"\mathrm{e}", **letters}
        printer = _Running({"symbol_names": names, "fold_frac_powers": True, "fold_func_brackets": True})
        return str(printer.doprint(tidy(shown).xreplace({sp.E: _EULER})))
    shown = with_pieces(tidy(shown))
    names = {symbol: latex_name(symbol) for symbol in shown.free_symbols} | {_EULER: r"\mathrm{e}"}
    return str(_Latex({"symbol_names": names}).doprint(shown.xreplace({sp.E: _EULER})))


def _with_least(expression: Any) -> Any:
    """Write branches that take the lesser of two as Min: for texts, never to be differentiated."""
    return sp.sympify(expression).replace(
        lambda node: isinstance(node, Where) and node.args[0].func is sp.Lt and node.args[0].args == node.args[1:],
        lambda node: sp.Min(*node.args[1:], evaluate=False),
    )


def latex_name(symbol: Any) -> str:
    """A symbol's name in LaTeX: Greek letters, words upright in the subscript."""
    if symbol.name == "dR":
        return r"\Delta R"
    name, _, subscript = symbol.name.partition("_")
    if len(subscript) > 1 and subscript.isalpha():
        return rf"{sp.latex(sp.Symbol(name))}_{{\mathrm{{{subscript}}}}}"
    return str(sp.latex(sp.Symbol(symbol.name)))


def tidy(expression: Any) -> Any:
    """Take common factors out of sums, as in 3*(1 - e)/2, unless that is longer."""
    tidy = sp.factor_terms(expression, sign=False)
    return min(tidy, expression, key=lambda e: (str(e).startswith("-"), len(str(e))))
