"""Dimensional audit of one SymPy expression: its dimension, or the smallest sub-expression that has none.

A dimension is four exponents over M, L, T, Theta, each a SymPy expression: `[K] = M L^(1-n) T^-2` with symbolic n is a
value. The rules are data (`SIGNATURES`, one row per node type); a node without a row is an error, never a guess.
Numbers are dimensionless, zero and infinity have every dimension, and a dimensional base takes a rational exponent or
one made of constant parameters. Expressions are checked as constructed: nothing is simplified on the way.

    dimension_of(expr, table, constants) -> Dimension            raises DimensionError, which carries the fault
    check(expr, table, expected, constants) -> DimensionFault | None
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from typing import Any, Literal

import sympy
from sympy.core.function import AppliedUndef
from sympy.matrices import MatrixBase
from sympy.solvers.solveset import NonlinearError

from hertzwerk.derive.algebra.functions import Where
from hertzwerk.derive.algebra.splines import Spline
from hertzwerk.derive.faults import PicklableError
from hertzwerk.derive.units import Exponent, Exponents, Unit, UnitError, parse_unit, rational, unit_text

__all__ = ["ONE", "SIGNATURES", "ZERO", "Dimension", "DimensionError", "DimensionFault", "check", "dimension_of"]

Expr = Any  # a SymPy expression; SymPy is untyped

# --- dimensions -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Dimension:
    """Exponents over mass, length, time and temperature; `every` marks the dimension of zero, which matches all."""

    M: Expr = sympy.S.Zero
    L: Expr = sympy.S.Zero
    T: Expr = sympy.S.Zero
    Theta: Expr = sympy.S.Zero
    every: bool = False

    def __post_init__(self) -> None:
        for name in ("M", "L", "T", "Theta"):
            object.__setattr__(self, name, _canonical(getattr(self, name)))

    @classmethod
    def from_unit(cls, unit: Unit | str, symbols: Mapping[str, Expr] | None = None) -> Dimension:
        """The dimension of a unit (or its text), the names in its exponents replaced by `symbols` (or numbers)."""
        unit = parse_unit(unit) if isinstance(unit, str) else unit
        if not unit.free_names:
            return _of_unit(unit)
        symbols = symbols or {}
        if missing := [name for name in unit.free_names if name not in symbols]:
            raise UnitError(f"unit {unit}: found the exponent {', '.join(missing)}, expected the name of a parameter")
        return cls(
            *(
                sum((_canonical(c) * symbols[name] for name, c in e.terms), start=_canonical(e.constant))
                for e in unit.exponents
            )
        )

    @property
    def exponents(self) -> tuple[Expr, Expr, Expr, Expr]:
        """The four exponents as SymPy expressions."""
        return self.M, self.L, self.T, self.Theta

    @property
    def dimensionless(self) -> bool:
        """Whether a plain number has it (zero does)."""
        return self.every or self == ONE

    def matches(self, other: Dimension) -> bool:
        """Whether the two may be added: equal, or one of them zero's."""
        return self.every or other.every or self == other

    def __mul__(self, other: Dimension) -> Dimension:
        return _multiply(self, other)

    def __truediv__(self, other: Dimension) -> Dimension:
        return _multiply(self, _raise(other, sympy.S.NegativeOne))

    def __pow__(self, exponent: Expr) -> Dimension:
        return _raise(self, _canonical(exponent))

    def __str__(self) -> str:
        if self.every:
            return "any unit"
        mass, length, time, temperature = (_linear(exponent) for exponent in self.exponents)
        exponents: Exponents = (mass, length, time, temperature)
        return unit_text(exponents)


@lru_cache(maxsize=4096)
def _of_unit(unit: Unit) -> Dimension:
    """Of a unit without names in its exponents."""
    return Dimension(*(_canonical(exponent.constant) for exponent in unit.exponents))


def _canonical(value: Expr) -> Expr:
    """An exponent in the form in which equal exponents are identical: rational, or a cancelled rational function."""
    if isinstance(value, sympy.Rational):
        return value
    if isinstance(value, (int, float, Fraction, sympy.Float)):
        exact = rational(float(value) if isinstance(value, sympy.Float) else value)
        return sympy.Rational(exact.numerator, exact.denominator)
    return _cancelled(sympy.sympify(value, strict=True))


@lru_cache(maxsize=4096)
def _cancelled(value: Expr) -> Expr:
    return sympy.cancel(value.xreplace({x: _canonical(x) for x in value.atoms(sympy.Float)}))


@lru_cache(maxsize=65536)
def _multiply(a: Dimension, b: Dimension) -> Dimension:
    return ZERO if a.every or b.every else Dimension(*(x + y for x, y in zip(a.exponents, b.exponents, strict=True)))


@lru_cache(maxsize=65536)
def _raise(a: Dimension, exponent: Expr) -> Dimension:
    return ZERO if a.every else Dimension(*(x * exponent for x in a.exponents))


def _linear(exponent: Expr) -> Exponent:
    """A SymPy exponent for printing; what is no name (1/k, k*n) prints in parentheses."""
    if exponent.is_Rational:
        return Exponent(Fraction(exponent.p, exponent.q))
    total = Exponent()
    for term, c in sympy.expand(exponent).as_coefficients_dict().items():
        number = Fraction(int(c.p), int(c.q))
        name = str(term) if term.is_Symbol else f"({term})"
        total += Exponent(number) if term == 1 else Exponent(terms=((name, number),))
    return total


ONE = Dimension()
ZERO = Dimension(every=True)

_QUANTITIES = {
    Dimension.from_unit(unit): name
    for unit, name in (
        ("1", "dimensionless"), ("N", "a force"), ("Pa", "a pressure"), ("J", "an energy"), ("W", "a power"),
        ("m", "a length"), ("m^2", "an area"), ("s", "a time"), ("kg", "a mass"), ("K", "a temperature"),
        ("m/s", "a speed"), ("m/s^2", "an acceleration"),
    )
}  # fmt: skip


def _quantity(dimension: Dimension) -> str:
    return _QUANTITIES.get(dimension, str(dimension))


# --- faults ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DimensionFault:
    """Why an expression has no dimension, or not the one expected: the smallest sub-expression, and a way out."""

    subexpression: str
    operands: tuple[tuple[str, str], ...]  # what the sub-expression is made of: text, unit text
    found: str  # unit text
    expected: str  # unit text
    reason: str
    consistent_exponent: Expr | None = None  # SymPy number: of the symbolic exponent, or of the power named in `repair`
    repair: str | None = None
    missing: Dimension | None = field(
        default=None, compare=False, repr=False
    )  # expected over found, where these are dimensions

    def __str__(self) -> str:
        lines = [f"{self.subexpression}: {self.reason}"]
        lines += [f"    {text} [{unit}]" for text, unit in self.operands]
        lines += [f"found {self.found}, expected {self.expected}"]
        return "\n".join(lines + ([f"{self.repair}."] if self.repair else []))


class DimensionError(PicklableError):
    """An expression without a dimension; `fault` says where and why."""

    def __init__(self, fault: DimensionFault) -> None:
        super().__init__(str(fault))
        self.fault = fault


# --- the rules ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Signature:
    """What a node asks of its arguments (one common dimension, none, or nothing) and which dimension it then has."""

    arguments: Literal["alike", "pure", "any"]
    result: Literal["same", "one"]


def _rows(arguments: Literal["alike", "pure", "any"], result: Literal["same", "one"], *nodes: type) -> dict[type, Any]:
    return {node: Signature(arguments, result) for node in nodes}


class _Walk:
    """One expression's walk from the leaves up: the first node without a dimension raises."""

    def __init__(self, table: Mapping[Expr, Dimension], constants: Collection[Expr]) -> None:
        self.table = table
        self.constants = constants
        self.memo: dict[Expr, Dimension] = {}

    def __call__(self, expr: Expr) -> Dimension:
        found = self.memo.get(expr) or self.table.get(expr)
        if found is None:
            found = self.memo[expr] = self.rule(expr)
        return found

    def rule(self, expr: Expr) -> Dimension:
        rule = SIGNATURES.get(type(expr))
        if isinstance(rule, Signature):
            if rule.arguments == "alike":
                common = self.alike(expr, expr.args)
                return common if rule.result == "same" else ONE
            for argument in expr.args:
                if not self(argument).dimensionless and rule.arguments == "pure":
                    raise self.pure(expr, argument, f"{type(expr).__name__} takes a dimensionless argument")
            return ONE
        if rule is not None:
            known: Dimension = rule(self, expr)
            return known
        if expr.is_number and expr.is_Atom and expr.is_extended_real and expr is not sympy.nan:
            return ZERO if expr.is_zero or expr.is_infinite else ONE
        if isinstance(expr, (sympy.logic.boolalg.BooleanTrue, sympy.logic.boolalg.BooleanFalse)):
            return ONE
        if isinstance(expr, (sympy.Symbol, AppliedUndef)):
            raise self.fault(expr, (), "unknown", "a declared unit", "its unit is not declared")
        kind = type(expr).__name__
        raise self.fault(expr, (), "unknown", "a known operation", f"the audit has no rule for {kind}")

    def dimensions(self, expr: Expr, arguments: Sequence[Expr]) -> list[Dimension]:
        """One per argument; of a sum, logarithms that together are one of a number, log(a) - log(b) = log(a/b), have that of their factor."""
        if type(expr) is not sympy.Add or not expr.has(sympy.log):
            return [self(argument) for argument in arguments]
        logarithms = {term: found for term in arguments if (found := _logarithm_in(term)) is not None}
        inside: dict[Expr, Dimension] = {}
        for factor, share, argument in logarithms.values():
            inside[factor] = inside.get(factor, ONE) * _raise(self(argument), share)
        whole = {term: factor for term, (factor, *_) in logarithms.items() if inside[factor].dimensionless}
        return [self(whole.get(argument, argument)) for argument in arguments]

    def alike(self, expr: Expr, arguments: Sequence[Expr], expected: Dimension | None = None) -> Dimension:
        """The one dimension of all arguments; of several the commonest is expected, not a plain number's in a tie."""
        dimensions = self.dimensions(expr, arguments)
        if dimensions and all(dimension is dimensions[0] for dimension in dimensions):
            return dimensions[0]
        distinct = {dimension: dimensions.count(dimension) for dimension in dimensions if not dimension.every}
        if len(distinct) <= 1:
            return next(iter(distinct), ZERO)
        expected = expected or max(distinct, key=lambda dimension: (distinct[dimension], dimension != ONE))
        odd, found = next(pair for pair in zip(arguments, dimensions, strict=True) if not pair[1].matches(expected))
        noun = _NOUNS.get(type(expr), type(expr).__name__)
        reason = f"{noun} takes operands of one unit, and {odd} is {found} beside {expected}"
        operands = tuple(zip(arguments, dimensions, strict=True))
        raise self.fault(expr, operands, found, expected, reason, odd)

    def pure(self, expr: Expr, argument: Expr, reason: str) -> DimensionError:
        """The fault of an argument that should be dimensionless."""
        found = self(argument)
        reason = f"{reason}, and {argument} is {found}"
        return self.fault(expr, ((argument, found),), found, ONE, reason, argument)

    def fault(
        self,
        expr: Expr,
        operands: Sequence[tuple[Expr, Dimension]],
        found: Dimension | str,
        expected: Dimension | str,
        reason: str,
        culprit: Expr | None = None,
    ) -> DimensionError:
        exponent, repair, missing = None, None, None
        if culprit is not None and isinstance(found, Dimension) and isinstance(expected, Dimension):
            exponent, repair = _repair(self, culprit, found, expected)
            missing = expected / found
        texts = tuple(dict.fromkeys((str(operand), str(dimension)) for operand, dimension in operands))
        return DimensionError(
            DimensionFault(str(expr), texts, str(found), str(expected), reason, exponent, repair, missing)
        )

    def expect(self, expr: Expr, expected: Dimension) -> None:
        """Raise unless the expression has the dimension: at the wrong term of a sum or branch, where only some are."""
        terms = _branches(expr)
        dimensions = self.dimensions(expr, terms)
        wrong = [not dimension.matches(expected) for dimension in dimensions]
        if any(wrong) and not (all(wrong) and len(set(dimensions)) == 1):
            term = terms[wrong.index(True)]
            if (
                term.is_Atom or _logarithm_in(term) is not None
            ):  # by itself a symbol is never wrong: quote what it stands in
                self.alike(expr, terms, expected)
            self.expect(term, expected)
        found = self(expr)
        if found.matches(expected):
            return
        # a dimensionless sum as factor, (1 + h*v/v0), cannot be at fault and would only hide what is
        factors = [f for f in sympy.Mul.make_args(expr) if not (f.is_Add and self(f).dimensionless)]
        expr = expr if len(factors) == len(sympy.Mul.make_args(expr)) else sympy.Mul(*factors)
        bases = [f.base if f.is_Pow else f for f in sympy.Mul.make_args(expr)]
        operands = [(base, self(base)) for base in bases if not base.is_number]
        raise self.fault(expr, operands, found, expected, f"it is {found} where {expected} belongs", expr)


def _logarithm_in(term: Expr) -> tuple[Expr, Expr, Expr] | None:
    """Factor, rational share and argument of a product with one logarithm: 2*x*log(a) -> (x, 2, a); None for another term."""
    number, rest = term.as_coeff_Mul(rational=True)
    factors = sympy.Mul.make_args(rest)
    logarithms = [factor for factor in factors if isinstance(factor, sympy.log) and len(factor.args) == 1]
    if len(logarithms) != 1 or not number.is_Rational:
        return None
    return sympy.Mul(*(f for f in factors if f is not logarithms[0])), number, logarithms[0].args[0]


def _branches(expr: Expr) -> tuple[Expr, ...]:
    """The parts that must each have the dimension of the whole."""
    if isinstance(expr, Where):
        return tuple(expr.args[1:])
    if isinstance(expr, sympy.Piecewise):
        return tuple(branch for branch, _ in expr.args)
    return tuple(expr.args) if SIGNATURES.get(type(expr)) == Signature("alike", "same") else ()


def _product(walk: _Walk, expr: Expr) -> Dimension:
    total = ONE
    for factor in expr.args:
        total = total * walk(factor)
    return total


def _power(walk: _Walk, expr: Expr) -> Dimension:
    base, exponent = expr.args
    dimension = walk(base)
    if exponent.is_Rational or exponent.is_Float:
        return _raise(dimension, _canonical(exponent))
    if not walk(exponent).dimensionless:
        raise walk.pure(expr, exponent, "an exponent is dimensionless")
    if dimension.dimensionless:
        return dimension
    strange = sorted(str(symbol) for symbol in exponent.free_symbols if symbol not in walk.constants)
    if strange or not exponent.free_symbols:
        operands = ((base, dimension), (exponent, ONE))
        given = f"{', '.join(strange)}, no constant parameter" if strange else f"the irrational {exponent}"
        reason = f"the unit of a power of {dimension} depends on {given}"
        expected = "a rational exponent, or one of constant parameters"
        raise walk.fault(expr, operands, f"{dimension} to the power {exponent}", expected, reason)
    return _raise(dimension, _canonical(exponent))


def _where(walk: _Walk, expr: Expr) -> Dimension:
    walk(expr.args[0])
    return walk.alike(expr, expr.args[1:])


def _spline(walk: _Walk, expr: Expr) -> Dimension:
    table, argument, order = expr.args
    per, of = (Dimension.from_unit(unit) for unit in table.units)
    if not (found := walk(argument)).matches(per):
        reason = f"{table} is a table of arguments in {per}, and {argument} is {found}"
        raise walk.fault(expr, ((argument, found),), found, per, reason, argument)
    result: Dimension = of / per**order
    return result


def _piecewise(walk: _Walk, expr: Expr) -> Dimension:
    for _, condition in expr.args:
        walk(condition)
    return walk.alike(expr, [branch for branch, _ in expr.args])


def _derivative(walk: _Walk, expr: Expr) -> Dimension:
    total = walk(expr.expr)
    for variable, count in expr.variable_count:
        total = total / walk(variable) ** count
    return total


def _integral(walk: _Walk, expr: Expr) -> Dimension:
    total = walk(expr.function)
    for variable, *bounds in expr.limits:
        total = total * walk.alike(expr, [variable, *bounds])
    return total


def _matrix(walk: _Walk, expr: Expr) -> Dimension:
    return walk.alike(expr, expr.flat())


def _inverse(walk: _Walk, expr: Expr) -> Dimension:
    return ONE / walk(expr.args[0])


def _determinant(walk: _Walk, expr: Expr) -> Dimension:
    return _raise(walk(expr.args[0]), _canonical(expr.args[0].rows))


SIGNATURES: Mapping[type, Signature | Callable[[_Walk, Expr], Dimension]] = {
    sympy.Mul: _product,
    sympy.Pow: _power,
    Where: _where,
    Spline: _spline,
    sympy.Piecewise: _piecewise,
    sympy.Derivative: _derivative,
    sympy.Integral: _integral,
    sympy.ImmutableDenseMatrix: _matrix,
    sympy.MatMul: _product,
    sympy.Inverse: _inverse,
    sympy.Determinant: _determinant,
    **_rows("alike", "same", sympy.Add, sympy.Max, sympy.Min, sympy.Abs, sympy.Mod),
    **_rows("alike", "same", sympy.MatAdd, sympy.Transpose, sympy.Trace),
    **_rows("alike", "one", sympy.atan2, sympy.Eq, sympy.Ne, sympy.Lt, sympy.Le, sympy.Gt, sympy.Ge),
    **_rows("any", "one", sympy.sign, sympy.Heaviside),
    **_rows("pure", "one", sympy.sin, sympy.cos, sympy.tan, sympy.asin, sympy.acos, sympy.atan),
    **_rows("pure", "one", sympy.sinh, sympy.cosh, sympy.tanh, sympy.asinh, sympy.acosh, sympy.atanh),
    **_rows("pure", "one", sympy.exp, sympy.log, sympy.LambertW, sympy.gamma, sympy.erf, sympy.floor, sympy.ceiling),
    **_rows("pure", "one", sympy.And, sympy.Or, sympy.Not),
}


_NOUNS = {sympy.Add: "a sum", sympy.ImmutableDenseMatrix: "a matrix", Where: "a choice", sympy.Piecewise: "a choice"}
_NOUNS |= {sympy.Integral: "a variable of integration with its limits"}
_NOUNS |= dict.fromkeys((sympy.Eq, sympy.Ne, sympy.Lt, sympy.Le, sympy.Gt, sympy.Ge), "a comparison")


# --- the two doors --------------------------------------------------------------------------------------------------


def dimension_of(expr: Expr, table: Mapping[Expr, Dimension], constants: Collection[Expr] = ()) -> Dimension:
    """The dimension of an expression; `table` declares its symbols, `constants` are those allowed in exponents.

    Raises DimensionError, whose `fault` names the smallest sub-expression that has no dimension.
    """
    return _Walk(table, constants)(_node(expr))


def check(
    expr: Expr, table: Mapping[Expr, Dimension], expected: Dimension, constants: Collection[Expr] = ()
) -> DimensionFault | None:
    """The fault that keeps an expression from having the expected dimension, or None."""
    try:
        _Walk(table, constants).expect(_node(expr), expected)
    except DimensionError as error:
        return error.fault
    return None


def _node(expr: Expr) -> Expr:
    return expr.as_immutable() if isinstance(expr, MatrixBase) else sympy.sympify(expr, strict=True)


# --- repairs --------------------------------------------------------------------------------------------------------


def _repair(walk: _Walk, expr: Expr, found: Dimension, expected: Dimension) -> tuple[Expr | None, str | None]:
    """The exponent that would give `expr` the expected dimension, and a sentence that says so, or what is missing."""
    if not isinstance(expr, sympy.Expr) or expr.is_Matrix:  # a comparison, a matrix: no factors to mend
        return None, None
    missing = expected / found
    if any(symbol in walk.constants for exponent in missing.exponents for symbol in exponent.free_symbols):
        return _symbolic_exponent(walk, expr, missing, expected)
    candidates = []
    for place, factor in enumerate(sympy.Mul.make_args(expr)):
        base, power = factor.as_base_exp()
        step = None if walk(base).dimensionless else _logarithm(missing, walk(base))
        if step is not None and power.is_number and power + step != 0:
            # a bare symbol is the likeliest to lack its exponent: d in E*sqrt(R)*d
            likeliness = (base.is_Symbol and power == 1, base.is_Symbol, place)
            candidates.append((likeliness, base, power, _canonical(power) + step))
    if candidates:
        _, base, power, exponent = max(candidates, key=lambda candidate: candidate[0])
        name = sympy.Symbol("n" if sympy.Symbol("n") not in expr.free_symbols else "p")
        rest = expr / base**power
        text = _only_for(walk, rest, base, name, exponent, expected)
        return exponent, text if ";" in text else f"{text}, not {sympy.sstr(power, full_prec=False)}"
    if found == ONE:
        return None, f"{expr} would need the unit {missing}"
    number = expr.as_coeff_Mul()[0]
    hidden = f"; if the number {number} hides it, declare it as a parameter" if abs(number) != 1 else ""
    return None, f"a factor of unit {missing} is missing{hidden}"


def _symbolic_exponent(
    walk: _Walk, expr: Expr, missing: Dimension, expected: Dimension
) -> tuple[Expr | None, str | None]:
    names = {symbol for exponent in missing.exponents for symbol in exponent.free_symbols}
    for name in sorted((symbol for symbol in names if symbol in walk.constants), key=str):
        try:
            solution = sympy.linsolve([sympy.numer(exponent) for exponent in missing.exponents], [name])
        except NonlinearError:
            continue
        for (value,) in solution:
            powers = [f for f in sympy.Mul.make_args(expr) if f.is_Pow and f.exp == name]
            if len(powers) == 1:
                return value, _only_for(walk, expr / powers[0], powers[0].base, name, value, expected)
            return value, f"{expr} is {_quantity(expected)} only for {name} = {value}"
    return None, "no value of " + ", ".join(sorted(map(str, names))) + f" makes {expr} {_quantity(expected)}"


def _only_for(walk: _Walk, rest: Expr, base: Expr, name: Expr, exponent: Expr, expected: Dimension) -> str:
    """`K is N/m^1.5: K*d**n is a force only for n = 3/2`."""
    given = "" if rest.is_number else f"{rest} is {walk(rest)}: "
    text = f"{given}{rest * base**name} is {_quantity(expected)} only for {name} = {exponent}"
    if exponent == 2 and walk(base) == Dimension(L=1):
        text += f"; multiplied by a length, for {name} = 1"
    return text


def _logarithm(value: Dimension, base: Dimension) -> Expr | None:
    """The rational y with base**y == value, if there is one."""
    ratios = {v / b for v, b in zip(value.exponents, base.exponents, strict=True) if b != 0}
    ratio = next(iter(ratios))
    return ratio if len(ratios) == 1 and ratio.is_Rational and base**ratio == value else None
