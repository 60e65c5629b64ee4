"""Dimension of an expression's text, as written, or the smallest sub-expression that has none, quoted from the text.

The rules are those of `dimension.SIGNATURES`, one row per operation, walked over the tree of `text.read` instead of a SymPy expression, which
would already have collapsed `d**1`, `m - m + s` or `0*x`. Nothing is evaluated but exponents, and those are made of numbers and of constant
parameters: names with unit 1, names given by value. A product with a literal 0 has every dimension, as 0 has.

    examine(expression, declared, expected) -> (dimension, fault), one of them None
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

import sympy as sp
from sympy.solvers.solveset import NonlinearError

from hertzwerk.derive.dimension.dimension import (
    ONE,
    SIGNATURES,
    ZERO,
    Dimension,
    DimensionError,
    DimensionFault,
    Signature,
)
from hertzwerk.derive.dimension.reader import RESERVED, SYMPY, Expression, Node, TextError, plain_name, to_sympy
from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.derive.units import UnitError, parse_unit, rational

__all__ = ["Declared", "dimension_of_unit", "examine"]

MAX_DEGREE = 6  # of an exponent in its names
MAX_OPERATIONS = 60  # of an exponent of a dimension

_COMPLEX = f"an exponent of degree at most {MAX_DEGREE}, made of at most four names"


@dataclass(frozen=True)
class Declared:
    """What the names of an expression are: a dimension each, and those that are constant parameters, as values exponents may have."""

    dimensions: Mapping[str, Dimension]
    constants: Mapping[str, Any] = field(default_factory=dict)
    """Constant name -> its symbol, or the number it is given."""
    symbols: Mapping[str, Any] = field(default_factory=dict)
    """Constant name -> its symbol, whether a number is given or not."""
    units: Mapping[str, str] = field(default_factory=dict)
    """Name -> unit as declared."""
    meanings: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, units: Mapping[str, str], values: Mapping[str, float] | None = None) -> Declared:
        """From unit texts and given numbers; raises InputError with every fault."""
        units = {plain_name(name): unit for name, unit in units.items()}
        values = {plain_name(name): value for name, value in (values or {}).items()}
        faults = [*_name_faults([*units, *values]), *_value_faults(values)]
        symbols = {name: sp.Symbol(name, real=True) for name in dict.fromkeys((*units, *values))
                   if name not in units or units[name].strip() == "1"}  # fmt: skip
        constants = {name: _exact(values[name]) if name in values and math.isfinite(values[name]) else symbol
                     for name, symbol in symbols.items()}  # fmt: skip
        dimensions: dict[str, Dimension] = {name: ONE for name in values if name not in units}
        for name, unit in units.items():
            try:
                dimensions[name] = dimension_of_unit(unit, constants)
            except UnitError as error:
                faults.append(Fault(f"unit of {name}", repr(unit), "a unit", str(error)))
        if faults:
            raise InputError("expression", faults)
        return cls(dimensions, constants, symbols, units)

    @property
    def general(self) -> Declared:
        """The same with every constant left open, its number forgotten."""
        dimensions = dict(self.dimensions)
        for name, unit in self.units.items():
            dimensions[name] = dimension_of_unit(unit, self.symbols)
        return replace(self, dimensions=dimensions, constants=self.symbols)


def dimension_of_unit(unit: str, constants: Mapping[str, Any]) -> Dimension:
    """The dimension of a unit's text; the names in its exponents must be constants. Raises UnitError."""
    parsed = parse_unit(unit)
    for name in parsed.free_names:
        if name not in constants:
            raise UnitError(
                f"unit {unit!r}: found the exponent {name}, expected a declared name of unit 1; "
                f"declare {name} with unit 1, or give its value"
            )
    return Dimension.from_unit(parsed, constants)


def _name_faults(names: Iterable[str]) -> Iterable[Fault]:
    for name in dict.fromkeys(names):
        if name in RESERVED:
            yield Fault(f"name {name}", f"{name!r}, which expressions use themselves", "another name")
        elif not name.isidentifier():
            yield Fault(f"name {name!r}", repr(name), "a name of letters, digits and _")


def _value_faults(values: Mapping[str, float]) -> Iterable[Fault]:
    for name, value in values.items():
        if not math.isfinite(value):
            yield Fault(f"value of {name}", f"{value}", "a finite number")


def _exact(value: float) -> Any:
    fraction = rational(value)
    return sp.Rational(fraction.numerator, fraction.denominator)


def examine(
    expression: Expression, declared: Declared, expected: Dimension | None = None
) -> tuple[Dimension | None, DimensionFault | None]:
    """The dimension of an expression, or the fault that keeps it from having one (or the one expected).

    Raises TextError for exponents too complex to compare. Where numbers are given for constants, the repair is the one for any number.
    """
    try:
        return _Walk(expression, declared).result(expected), None
    except DimensionError as error:
        fault = error.fault
    if declared.constants != declared.symbols and fault.found != fault.expected:
        try:
            _Walk(expression, declared.general).result(expected)
        except DimensionError as error:  # with the exponent left open: what would do
            if error.fault.subexpression == fault.subexpression and error.fault.consistent_exponent is not None:
                lesson = error.fault
                fault = replace(fault, consistent_exponent=lesson.consistent_exponent, repair=lesson.repair)
    return None, fault


# --- the walk ---------------------------------------------------------------------------------------------------------

_NOUNS = {
    "sum": "a sum",
    "matrix": "a matrix",
    "where": "a choice",
    "integrate": "a variable of integration with its limits",
}
_NOUNS |= dict.fromkeys(("<", "<=", ">", ">=", "==", "!="), "a comparison")


class _Walk:
    """One expression's walk from the leaves up: the first node without a dimension raises DimensionError."""

    def __init__(self, expression: Expression, declared: Declared) -> None:
        self.expression = expression
        self.declared = declared
        self.memo: dict[int, Dimension] = {}

    def result(self, expected: Dimension | None) -> Dimension:
        """The dimension of the whole, which must be the expected one."""
        if expected is not None:  # first, so that of two terms the one that is not expected is at fault
            self.expect(self.expression.root, expected)
        return self(self.expression.root)

    def __call__(self, node: Node) -> Dimension:
        found = self.memo.get(id(node))
        if found is None:
            found = self.memo[id(node)] = self.bounded(node, self.rule(node))
        return found

    def bounded(self, node: Node, dimension: Dimension) -> Dimension:
        """A dimension whose exponents can still be compared in bounded time."""
        if any(not e.is_Rational and e.count_ops() > MAX_OPERATIONS for e in dimension.exponents):
            raise TextError(self.expression.source, node.start, "exponents too long to compare", _COMPLEX)
        return dimension

    def quote(self, node: Node) -> str:
        return self.expression.quote(node)

    def rule(self, node: Node) -> Dimension:
        if node.op == "number":
            return ZERO if node.number == 0 else ONE
        if node.op == "name":
            return self.declared.dimensions[node.name]
        rule = _RULES.get(node.op)
        if rule is not None:
            result: Dimension = rule(self, node)
            return result
        signature = SIGNATURES[SYMPY[node.op]]  # type: ignore[index]
        if not isinstance(signature, Signature):
            raise TypeError("an operation without a signature")
        if signature.arguments == "alike":
            common = self.alike(node, node.args)
            return common if signature.result == "same" else ONE
        for arg in node.args:
            if not self(arg).dimensionless and signature.arguments == "pure":
                raise self.pure(node, arg, f"{node.op} takes a dimensionless argument")
        return ONE

    def dimensions(self, node: Node, args: Sequence[Node]) -> list[Dimension]:
        """One per argument; of a sum, logarithms that together are one of a number, log(a) - log(b) = log(a/b), have that of their factors."""
        logarithms = (
            {id(arg): found for arg in args if (found := self.logarithm_in(arg)) is not None}
            if node.op == "sum"
            else {}
        )
        inside: dict[tuple[str, ...], Dimension] = {}
        for factors, share, argument in logarithms.values():
            key = tuple(sorted(map(self.quote, factors)))
            inside[key] = inside.get(key, ONE) * self(argument) ** share
        dimensions = []
        for arg in args:
            factors = logarithms[id(arg)][0] if id(arg) in logarithms else ()
            whole = id(arg) in logarithms and inside[tuple(sorted(map(self.quote, factors)))].dimensionless
            total = ONE
            for factor in factors if whole else (arg,):
                total = total * self(factor)
            dimensions.append(total)
        return dimensions

    def logarithm_in(self, node: Node) -> tuple[tuple[Node, ...], Fraction, Node] | None:
        """Factors, rational share and argument of a product with one logarithm: 2*x*log(a) -> ((x,), 2, a); None for another node."""
        if node.op == "neg":
            found = self.logarithm_in(node.args[0])
            return None if found is None else (found[0], -found[1], found[2])
        factors = node.args if node.op == "product" else (node,)
        logarithms = [factor for factor in factors if factor.op == "log"]
        if len(logarithms) != 1:
            return None
        numbers = [factor.number for factor in factors if factor.number is not None]
        if 0 in numbers:
            return None
        others = tuple(factor for factor in factors if factor is not logarithms[0] and factor.number is None)
        return others, math.prod(map(rational, numbers), start=Fraction(1)), logarithms[0].args[0]

    def alike(self, node: Node, args: Sequence[Node], expected: Dimension | None = None) -> Dimension:
        """The one dimension of all arguments; of several the commonest is expected, not a plain number's in a tie."""
        dimensions = self.dimensions(node, args)
        counts = {dimension: dimensions.count(dimension) for dimension in dimensions if not dimension.every}
        if len(counts) <= 1:
            return next(iter(counts), ZERO)
        expected = expected or max(counts, key=lambda dimension: (counts[dimension], dimension != ONE))
        odd, found = next(pair for pair in zip(args, dimensions, strict=True) if not pair[1].matches(expected))
        beside = next((d for d in dimensions if d == expected), next(d for d in counts if d != found))
        quoted = self.quote(node)
        if node.op == "sum":  # up to the term that no longer fits
            last = max(dimensions.index(found), dimensions.index(beside))
            quoted = self.expression.source[node.spans[0][0] : node.spans[last][1]]
        noun = _NOUNS.get(node.op, node.op)
        reason = f"in {quoted}, {self.quote(odd)} is {found} beside {beside}, and {noun} takes operands of one unit"
        raise self.fault(quoted, found, expected, reason, odd)

    def pure(self, node: Node, arg: Node, rule: str) -> DimensionError:
        """The fault of an argument that should be dimensionless."""
        found = self(arg)
        reason = f"in {self.quote(node)}, {self.quote(arg)} is {found}, and {rule}"
        return self.fault(self.quote(node), found, ONE, reason, arg)

    def fault(
        self, quoted: str, found: Dimension | str, expected: Dimension | str, reason: str, culprit: Node | None = None
    ) -> DimensionError:
        exponent, repair, missing = None, None, None
        if culprit is not None and isinstance(found, Dimension) and isinstance(expected, Dimension):
            exponent, repair = _Repair(self, culprit, found, expected).offer()
            missing = expected / found
        return DimensionError(DimensionFault(quoted, (), str(found), str(expected), reason, exponent, repair, missing))

    def expect(self, node: Node, expected: Dimension) -> None:
        """Raise unless the node has the dimension: at the wrong term of a sum or branch, where only some are."""
        if node.op == "neg":
            return self.expect(node.args[0], expected)
        terms = _branches(node)
        dimensions = self.dimensions(node, terms)
        wrong = [not dimension.matches(expected) for dimension in dimensions]
        if any(wrong) and not (all(wrong) and len(set(dimensions)) == 1):
            term = terms[wrong.index(True)]
            if (
                not term.args or self.logarithm_in(term) is not None
            ):  # by itself a symbol is never wrong: quote what it stands in
                self.alike(node, terms, expected)
            self.expect(term, expected)
        found = self(node)
        if found.matches(expected):
            return None
        quoted = self.quoted_factors(node)
        raise self.fault(quoted, found, expected, f"{quoted} is {found}, expected {expected}", node)

    def quoted_factors(self, node: Node) -> str:
        """A product without the dimensionless sums at its ends: (1 + h*v/v0) cannot be at fault and would only hide what is."""
        if node.op != "product":
            return self.quote(node)
        first, last = 0, len(node.args) - 1
        while last > first and self.innocent(node.args[last]):
            last -= 1
        while first < last and self.innocent(node.args[first]) and node.args[first + 1].op != "inverse":
            first += 1
        if first == last:
            return self.quote(node.args[first])
        return self.expression.source[node.spans[first][0] : node.spans[last][1]]

    def innocent(self, factor: Node) -> bool:
        inner = factor.args[0] if factor.op == "inverse" else factor
        return inner.op == "sum" and self(inner).dimensionless


def _branches(node: Node) -> tuple[Node, ...]:
    """The parts that must each have the dimension of the whole."""
    if node.op == "where":
        return node.args[1:]
    return node.args if node.op in ("sum", "min", "max", "abs", "matrix") else ()


def _sum(walk: _Walk, node: Node) -> Dimension:
    return walk.alike(node, node.args)


def _product(walk: _Walk, node: Node) -> Dimension:
    total = ONE
    for factor in node.args:
        total = walk.bounded(node, total * walk(factor))
    return total


def _power(walk: _Walk, node: Node) -> Dimension:
    base, exponent = node.args
    dimension = walk(base)
    if not walk(exponent).dimensionless:
        raise walk.pure(node, exponent, "an exponent is dimensionless")
    if dimension.dimensionless:
        return dimension
    names = dict.fromkeys(part.name for part in exponent.walk() if part.op == "name")
    strange = [name for name in names if name not in walk.declared.constants]
    value = None if strange else _value(walk, exponent)
    if value is not None and (value.is_Rational or (value.free_symbols and value.is_finite is not False)):
        result: Dimension = dimension**value
        return result
    quoted = walk.quote(exponent)
    given = f"{', '.join(strange)}, no constant parameter" if strange else f"{quoted}, which is not rational"
    reason = f"in {walk.quote(node)}, the unit of a power of {dimension} depends on {given}"
    found = f"{dimension} to the power {quoted}"
    raise walk.fault(walk.quote(node), found, "a rational exponent, or one of constant parameters", reason)


def _value(walk: _Walk, exponent: Node) -> Any:
    """An exponent of constants as SymPy has it; bounded, because expanding it is what comparing it costs."""
    names = {part.name for part in exponent.walk() if part.op == "name"}
    if max(_degree(exponent)) > MAX_DEGREE or len(names) > 4:
        raise TextError(walk.expression.source, exponent.start, "an exponent too long to compare", _COMPLEX)
    value = to_sympy(walk.expression, walk.declared.constants, exponent)
    exact = value.xreplace({x: _exact(float(x)) for x in value.atoms(sp.Float)})
    if exact.has(sp.zoo, sp.nan, sp.oo, sp.I):
        written = f"the exponent {walk.quote(exponent)}, which is no number here"
        raise TextError(walk.expression.source, exponent.start, written, "a finite real number")
    return exact


def _degree(node: Node) -> tuple[int, int]:
    """Bounds on the degree of numerator and denominator of an exponent, in its names."""
    if not node.args:
        return (1, 0) if node.op == "name" else (0, 0)
    parts = [_degree(arg) for arg in node.args]
    if node.op in ("sum", "neg"):
        below = sum(part[1] for part in parts)
        return max(above + below - own for above, own in parts), below
    if node.op == "product":
        return sum(part[0] for part in parts), sum(part[1] for part in parts)
    if node.op == "inverse":
        return parts[0][1], parts[0][0]
    if node.op == "**" and node.args[1].number is not None:
        size = max(1, math.ceil(abs(node.args[1].number)))
        above, below = (size * parts[0][0], size * parts[0][1])
        return (above, below) if node.args[1].number >= 0 else (below, above)
    return 1 + sum(map(max, parts)), 0


def _where(walk: _Walk, node: Node) -> Dimension:
    walk(node.args[0])
    return walk.alike(node, node.args[1:])


def _derivative(walk: _Walk, node: Node) -> Dimension:
    total = walk(node.args[0])
    for variable in node.args[1:]:
        total = total / walk(variable)
    return total


def _integral(walk: _Walk, node: Node) -> Dimension:
    function, *limits = node.args
    return walk(function) * walk.alike(node, limits)


def _determinant(walk: _Walk, node: Node) -> Dimension:
    if node.args[0].shape is None:
        raise TypeError("a matrix without a shape")
    return walk(node.args[0]) ** node.args[0].shape[0]


def _same(walk: _Walk, node: Node) -> Dimension:
    return walk(node.args[0])


def _logic(walk: _Walk, node: Node) -> Dimension:
    for arg in node.args:
        walk(arg)
    return ONE


_RULES: dict[str, Any] = {
    "pi": lambda walk, node: ONE,
    "inf": lambda walk, node: ZERO,
    "sum": _sum,
    "product": _product,
    "@": _product,
    "neg": _same,
    "inverse": lambda walk, node: ONE / walk(node.args[0]),
    "**": _power,
    "sqrt": lambda walk, node: walk(node.args[0]) ** sp.Rational(1, 2),
    "where": _where,
    "diff": _derivative,
    "integrate": _integral,
    "matrix": _sum,
    "transpose": _same,
    "trace": _same,
    "inv": lambda walk, node: ONE / walk(node.args[0]),
    "det": _determinant,
    **dict.fromkeys(("and", "or", "not"), _logic),
}
"""Operations that are no function of SIGNATURES."""


# --- repairs ----------------------------------------------------------------------------------------------------------


class _Repair:
    """What would make a culprit right: the value of a constant exponent, another exponent on one factor, or what is missing."""

    def __init__(self, walk: _Walk, culprit: Node, found: Dimension, expected: Dimension) -> None:
        self.walk = walk
        self.culprit = culprit
        self.found = found
        self.expected = expected
        self.missing = expected / found

    def offer(self) -> tuple[Any, str | None]:
        """The exponent, if one would do, and a sentence."""
        symbols = {symbol for exponent in self.missing.exponents for symbol in exponent.free_symbols}
        if symbols:
            return self.constant(sorted(symbols, key=str))
        if self.culprit.condition:
            return None, None
        return self.power() or (None, self.lacking())

    def constant(self, symbols: list[Any]) -> tuple[Any, str]:
        """The value of a constant that makes the exponents agree."""
        for symbol in symbols:
            try:
                solution = sp.linsolve([sp.numer(exponent) for exponent in self.missing.exponents], [symbol])
            except NonlinearError:
                continue
            for (value,) in solution:
                return value, f"consistent only with {symbol} = {value}"
        return None, f"no value of {', '.join(map(str, symbols))} makes it {_unit(self.expected)}"

    def power(self) -> tuple[Any, str] | None:
        """Another exponent on one factor; a bare name is the likeliest to lack its own: d in E*sqrt(R)*d."""
        powers: dict[str, list[Fraction]] = {}
        for name, exponent in self.factors(self.culprit, Fraction(1)):
            powers.setdefault(name, []).append(exponent)
        everywhere = [node.name for node in self.culprit.walk() if node.op == "name"]
        offers = []
        for place, (name, parts) in enumerate(powers.items()):
            dimension, exponent = self.walk.declared.dimensions[name], sum(parts, Fraction(0))
            if dimension.dimensionless or everywhere.count(name) > len(parts):  # it stands elsewhere too
                continue
            step = _logarithm(self.missing, dimension)
            # a smaller or larger power, or the factor on the wrong side of the line; no other change of sign
            if step is not None and ((step + exponent) * exponent > 0 or step == -2 * exponent):
                offers.append((exponent == 1, place, name, step + exponent))
        if not offers:
            return None
        _, _, name, exponent = max(offers)
        power = "" if exponent == 1 else f"**{exponent}" if exponent.is_Integer and exponent > 0 else f"**({exponent})"
        total = " in all" if len(powers[name]) > 1 else ""
        length = exponent == 2 and self.walk.declared.dimensions[name] == Dimension(L=1)
        other = f", or with {name}{total} and a factor of unit m" if length else ""
        return exponent, f"with {name}{power}{total} it is {_unit(self.expected)}{other}"

    def factors(self, node: Node, power: Fraction) -> Iterable[tuple[str, Fraction]]:
        """(name, exponent) of the factors of a product that are powers of a name, as far as exponents are numbers."""
        if node.op == "product":
            for factor in node.args:
                yield from self.factors(factor, power)
        elif node.op == "neg":
            yield from self.factors(node.args[0], power)
        elif node.op in ("inverse", "sqrt"):
            yield from self.factors(node.args[0], power * (Fraction(-1) if node.op == "inverse" else Fraction(1, 2)))
        elif node.op == "**" and node.args[1].number is not None:
            yield from self.factors(node.args[0], power * rational(node.args[1].number))
        elif node.op == "name":
            yield node.name, power

    def lacking(self) -> str:
        """What is missing, and the number that may hide it."""
        culprit = self.culprit.args[0] if self.culprit.op == "neg" else self.culprit
        if self.found == ONE and not culprit.args:
            return f"{self.walk.quote(culprit)} would need the unit {self.missing}"
        factors = culprit.args if culprit.op == "product" else ()
        numbers = [node for node in factors if node.number is not None and node.op in ("number", "neg")]
        hidden = ""
        if len(numbers) == 1 and abs(numbers[0].number or 0) not in (0, 1):
            hidden = f"; if the number {self.walk.quote(numbers[0])} hides it, declare it with its unit"
        return f"a factor of unit {self.missing} is missing{hidden}"


def _unit(dimension: Dimension) -> str:
    return "dimensionless" if dimension == ONE else str(dimension)


def _logarithm(value: Dimension, base: Dimension) -> Any:
    """The rational y with base**y == value, if there is one."""
    pairs = zip(value.exponents, base.exponents, strict=True)
    ratios = {v / b for v, b in pairs if b != 0}
    ratio = next(iter(ratios))
    return ratio if len(ratios) == 1 and ratio.is_Rational and base**ratio == value else None
