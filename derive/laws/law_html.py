"""Laws as notebooks show them: formulas, symbols with units, source."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from hertzwerk.derive.common.markup import Markup, joined, tag
from hertzwerk.derive.common.mathml import inline, lines_of
from hertzwerk.derive.common.plain_table import heading, table
from hertzwerk.derive.expressions.algebra.notation import latex_name, latex_of, text_of

_LETTERS = {"penetration": "d", "normal force": "F", "stored energy": "W", "damping force": r"F_{\mathrm{d}}",
            "friction force": r"F_{\mathrm{t}}"}  # fmt: skip


def law_html(law: Any, bound: Any = None) -> Markup:
    """Title, formulas, parameters with their values where they are bound, source, note.

    `law` is a Law, `bound` a BoundLaw of it: both import this file.
    """
    parts = [heading(law.name, f"{law.kind} law, {law.verdict}", f": {law.title}", good=law.verdict == "consistent")]
    parts += [tag("p", formula) for formula in _formulas(law)]
    values = {} if bound is None else bound.binding
    header = ("symbol", "unit", "meaning", *(("value",) if bound is not None else ()))
    rows = [
        (inline(latex_name(symbol)), symbol.unit, symbol.meaning, *((text_of(values[symbol]),) if symbol in values else ()))
        for symbol in law.parameters
    ]  # fmt: skip
    parts += [table(header, rows)] if rows else []
    parts += [tag("p", f"Grade {law.grade}. {law.source}")]
    parts += [tag("p", law.note)] if law.note else []
    return joined(parts)


def _formulas(law: Any) -> Iterator[Markup]:
    """Yield each expression of a law, then its intermediate results."""
    for quantity, expression, unit in law.expressions():
        yield joined(
            [f"{quantity[:1].upper()}{quantity[1:]} [{unit}]: ", _math(_LETTERS.get(quantity, ""), expression)]
        )
    for symbol, expression in law.definitions:
        yield joined(
            ["with ", _math(latex_name(symbol), expression), f" [{symbol.unit}]" if symbol.unit != "1" else ""]
        )


def _math(name: str, expression: Any) -> Markup:
    """An expression as MathML, after its name; its text where the reader of LaTeX does not know something."""
    latex = latex_of(expression, {symbol: latex_name(symbol) for symbol in expression.free_symbols})
    try:
        return joined((line for line, _ in lines_of(f"{name} = {latex}" if name else latex)), " ")
    except ValueError:
        return tag("code", text_of(expression))
