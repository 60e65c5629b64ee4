"""File of Python that makes a scene's equations with SymPy when it is imported."""

from __future__ import annotations

import keyword
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any

import sympy as sp
from sympy.printing.str import StrPrinter

from hertzwerk.derive.exchange.sympy_models.to_sympy import TIME, SymPyEquations
from hertzwerk.derive.expressions.algebra.functions import with_pieces

TAKEN = {"sp", "dynamicsymbols", "t", "q", "u", "kinematics", "mass_matrix", "forcing", "holonomic_constraints",
         "nonholonomic_constraints", "specified", "units", "values", "names"}  # fmt: skip
"""Names of the file itself."""


class _Printer(StrPrinter):  # type: ignore[misc]  # SymPy is untyped
    """Printer of Python that builds the expression again, exactly."""

    def __init__(self, variables: Mapping[sp.Symbol, str]) -> None:
        super().__init__()
        self.variables = variables

    def _print_Function(self, node: Any) -> str:
        return f"sp.{node.func.__name__}({', '.join(map(self._print, node.args))})"

    _print_Abs = _print_Max = _print_Min = _print_Piecewise = _print_Function

    def _print_ExprCondPair(self, node: Any) -> str:
        return f"({self._print(node.expr)}, {self._print(node.cond)})"

    def _print_BooleanTrue(self, _: Any) -> str:
        return "True"

    def _print_Rational(self, node: Any) -> str:
        return f"sp.Rational({node.p}, {node.q})"

    def _print_Float(self, node: Any) -> str:
        return f"sp.Float({float(node)!r})"

    def _print_Pi(self, _: Any) -> str:
        return "sp.pi"

    def _print_Exp1(self, _: Any) -> str:
        return "sp.E"

    def _print_Symbol(self, node: Any) -> str:
        return self.variables.get(node, _variable(node.name))

    def _print_Pow(self, node: Any, rational: bool = False) -> str:
        base, exponent = (f"({self._print(part)})" for part in (node.base, node.exp))
        return f"{base}**{exponent}"


def _variable(name: str) -> str:
    return f"{name}_" if name in TAKEN or keyword.iskeyword(name) else name


def python_file(
    equations: SymPyEquations, name: str, values: Mapping[str, tuple[float, str]] = MappingProxyType({})
) -> str:
    """Text of the file; `values` with their units stand in place of the parameters' defaults."""
    stated = {
        symbol: values.get(symbol.name, (value, equations.units[symbol])) for symbol, value in equations.values.items()
    }
    units = equations.units | {symbol: unit for symbol, (_, unit) in stated.items()}
    return "\n".join(_lines(equations, name, {symbol: value for symbol, (value, _) in stated.items()}, units)) + "\n"


def _lines(
    equations: SymPyEquations, name: str, values: Mapping[Any, float], units: Mapping[Any, str]
) -> Iterator[str]:
    program = equations.program
    variables = {s: "t" if a == TIME else _variable(s.name) for s, a in program.instead.items()}
    text = _Printer(variables).doprint
    yield f'"""Equations of {name} for SymPy, written by hertzwerk: mass_matrix u\' = forcing, q\' = kinematics.'
    yield ""
    if equations.holonomic_constraints or equations.nonholonomic_constraints:
        yield "Forces of the constraints, of the multipliers, come on top of the forcing."
    yield "Units of every symbol are in `units`, defaults of constants in `values`; `specified` are functions of time, as forces of contacts."
    yield '"""'
    yield ""
    yield "import sympy as sp"
    yield "from sympy.physics.mechanics import dynamicsymbols"
    yield ""
    yield "t = dynamicsymbols._t"
    for symbol, other in program.instead.items():
        if other.args:
            yield f'{variables[symbol]} = dynamicsymbols("{other.func.__name__}")'
        elif other != TIME:
            yield f'{variables[symbol]} = sp.Symbol("{other.name}")'
    yield ""

    def of(value: Any) -> str:
        return str(text(with_pieces(sp.sympify(value))))

    for symbol, expression in program.steps:
        if symbol not in variables:
            yield f"{_variable(symbol.name)} = {of(expression)}"
    yield ""
    r = program.results
    named = {a: variables[s] for s, a in program.instead.items()}
    yield f"q = sp.Matrix([{', '.join(named[a] for a in equations.q)}])"
    yield f"u = sp.Matrix([{', '.join(named[a] for a in equations.u)}])"
    pairs = zip(equations.q, r["kinematics"], strict=True)
    yield f"kinematics = {{{', '.join(f'{named[a]}.diff(t): {of(rate)}' for a, rate in pairs)}}}"
    yield "mass_matrix = sp.Matrix([" + ", ".join(f"[{', '.join(map(of, row))}]" for row in r["mass_matrix"]) + "])"
    for which in ("forcing", "holonomic_constraints", "nonholonomic_constraints"):
        yield f"{which} = sp.Matrix([{', '.join(map(of, r[which]))}])"
    yield f"specified = {{{', '.join(f'{named[a]}: {meaning!r}' for a, meaning in equations.specified.items())}}}"
    yield f"units = {{{', '.join(f'{named[a]}: {unit!r}' for a, unit in units.items())}}}"
    yield f"values = {{{', '.join(f'{named[a]}: {value!r}' for a, value in values.items())}}}"
    yield f"names = {{{', '.join(f'{label!r}: {named[a]}' for label, a in equations.names.items())}}}"
