"""Text of a program's functions: one builder over CasADi each, with its docstring."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp

from hertzwerk.derive.faults import visible
from hertzwerk.derive.program.expression_text import curve_names, expression_text
from hertzwerk.derive.program.naming import names_in_words
from hertzwerk.derive.program.program import Function, Program, Result, eliminate_common_subexpressions

_WIDTH = 116  # columns of the text
_NAME = re.compile(r"[^\W\d]\w*")
_CASADI = re.compile(r"\bca\.")

_ARGUMENTS = {
    "t": "t [s]",
    "p": "p: PARAMETERS, in SI",
    "q": "q: COORDINATES",
    "u": "u: SPEEDS",
    "a": "a: rates of the speeds",
    "z": "z: MEMORY",
    "m": "m: LATCHES",
    "c": "c: CONSTANTS",
    "f": "f: generalised forces",
    "reactions": "reactions of the drives",
    "wanted": "wanted: rates of CONSTRAINTS",
    "multipliers": "multipliers: forces that hold CONSTRAINTS",
    "friction": "friction: force of each pair of SLIPS along its tangent",
    "touching": "touching: forces and points of the contacts",
    "joints": "joints: JOINT_COORDINATES",
    "joint_speeds": "joint_speeds: JOINT_SPEEDS",
}


def function_text(program: Program, function: Function) -> str:
    """Text of one builder."""
    unpacked = _unpacked(program, function)
    function = eliminate_common_subexpressions(function)
    names = _names(program, function)
    own = program.tape.own
    lines = [f"def {function.name}({', '.join(map(own, function.arguments))}):", *_docstring(function, own)]
    code = [*unpacked, *(f"{symbol.name} = {expression_text(expression)}" for symbol, expression in function.body)]
    lines += [f"    {_renamed(line, names)}" for line in code]
    lines += _return(function, names)
    if own("ca") != "ca":
        lines = [_CASADI.sub(f"{own('ca')}.", line) for line in lines]
    return "\n".join(lines)


def curve_text(curve: Any) -> str:
    """Text of the function of a curve, also of a vector of its parameter."""
    name, _ = curve_names(curve)
    if curve.searched:
        return _chain_text(name, curve)
    taken = {symbol.name for symbol in curve.given}
    s = sp.Symbol(next(letter for letter in ("s", "along", "s_") if letter not in taken), real=True)
    x, y = curve.x.xreplace({curve.s: s}), curve.y.xreplace({curve.s: s})
    values = tuple(expression.diff(s, order) for order in (0, 1, 2) for expression in (x, y))
    result = Result(name, ("",) * 6, ("",) * 6, values)
    function = eliminate_common_subexpressions(Function(name, "", (), (), (result,)))
    words = names_in_words(function.body, {}, taken | {s.name})
    lines = [
        f"def {name}({', '.join(symbol.name for symbol in (s, *curve.given))}):",
        f"    \"\"\"Point of the curve {curve.name} at its parameter, and derivatives by it: x, y, x', y', x'', y''.\"\"\"",
        *(f"    {symbol.name} = {expression_text(expression)}" for symbol, expression in function.body),
        f"    return {', '.join(map(expression_text, function.results[0].expressions))}",
    ]
    return "\n".join([*lines[:2], *(_renamed(line, words) for line in lines[2:])])


def _chain_text(name: str, chain: Any) -> str:
    """Text of the function of a chain of arcs and lines."""
    values = tuple(value for piece in chain.pieces for value in piece)
    result = Result(name, ("",) * len(values), ("",) * len(values), values)
    function = eliminate_common_subexpressions(Function(name, "", (), (), (result,)))
    words = names_in_words(function.body, {}, {symbol.name for symbol in chain.given})
    lines = [
        f"def {name}({', '.join(symbol.name for symbol in chain.given)}):",
        f'    """Pieces of the chain {chain.name}: start x, y, end x, y, centre x, y of each."""',
        *(f"    {symbol.name} = {expression_text(expression)}" for symbol, expression in function.body),
        f"    return {', '.join(map(expression_text, function.results[0].expressions))}",
    ]
    return "\n".join([*lines[:2], *(_renamed(line, words) for line in lines[2:])])


def _names(program: Program, function: Function) -> dict[str, str]:
    """Names that stand for numbered ones in the text: of the assignment that is equal, else in words."""
    named = {
        x.name: program.names.get(symbol.name, symbol.name)
        for x, symbol in function.shared.items()
        if symbol is not None
    }
    unnamed = [(symbol, e) for symbol, e in function.body if symbol in function.shared and symbol.name not in named]
    return names_in_words(unnamed, {**program.names, **named}, program.tape.names)


def _renamed(code: str, names: Mapping[str, str]) -> str:
    return _NAME.sub(lambda name: names.get(name[0], name[0]), code)


def _return(function: Function, names: Mapping[str, str]) -> list[str]:
    """Return statement; if long, one result per line, and if that is long, several lines per result."""
    columns = [_renamed(_column(result), names) for result in function.results]
    line = f"    return {', '.join(columns)}"
    if len(line) <= _WIDTH:
        return [line]
    if len(columns) == 1:
        return _wrapped_lines(columns[0], "    return ", " " * 8)
    lines = [line for column in columns for line in _wrapped_lines(f"{column},", " " * 8, " " * 12)]
    return ["    return (", *lines, "    )"]


def _wrapped_lines(code: str, first: str, then: str) -> list[str]:
    """Break code inside CasADi's brackets at blanks where it is too long."""
    return textwrap.wrap(
        code,
        _WIDTH,
        initial_indent=first,
        subsequent_indent=then,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _docstring(function: Function, own: Callable[[str], str]) -> list[str]:
    arguments = "; ".join(own(name) + _ARGUMENTS[name].removeprefix(name) for name in function.arguments)
    lines = _prose_lines(function.summary, '    """', " " * 4)
    lines += ["", f"    Arguments: {arguments}.", "    Returns, each a column vector:"]
    for result in function.results:
        entries = ", ".join(
            f"{label} [{unit}]" if unit else label for label, unit in zip(result.labels, result.units, strict=True)
        )
        entry = f"{result.name} ({len(result.labels)},): {entries or 'empty'}"
        lines += _prose_lines(entry, " " * 8, " " * 12)
    return [*lines, '    """']


def _prose_lines(text: str, first: str, then: str) -> list[str]:
    """Wrap text for a docstring, then escape it: an escape must not be broken."""
    lines = textwrap.wrap(text, _WIDTH, initial_indent=" " * len(first), subsequent_indent=then)
    return [indent + prose(line) for indent, line in zip((first, *[then] * len(lines)), lines, strict=False)]


def _unpacked(program: Program, function: Function) -> list[str]:
    """One line per entry the function reads."""
    positions: dict[Any, str] = {}
    own = program.tape.own
    if "c" in function.arguments:
        end = 0
        for symbol in program.constants:
            begin, end = end, end + program.tape.widths.get(symbol, 1)
            place = f"{begin}:{end}" if symbol in program.tape.widths else f"{begin}"
            positions[symbol] = f"{own('c')}[{place}]"
    else:
        parameters = [symbol for symbol, group in program.tape.inputs.items() if group == "p"]
        positions.update((symbol, f"{own('p')}[{k}]") for k, symbol in enumerate(parameters))
    count: dict[str, int] = {}
    for symbol, group in program.tape.inputs.items():
        if group not in ("p", "t", "c"):
            positions[symbol] = f"{own(group)}[{count.get(group, 0)}]"
            count[group] = count.get(group, 0) + 1
    wanted = set(function.reads)
    return [f"{symbol.name} = {place}" for symbol, place in positions.items() if symbol in wanted]


def _column(result: Result) -> str:
    return f"ca.vertcat({', '.join(expression_text(expression) for expression in result.expressions)})"


def prose(text: str) -> str:
    """Text of a scene on one line, escaped for a docstring."""
    return visible(" ".join(text.split())).replace("\\", "\\\\").replace('"', "'")
