"""Dimensions: exponents over the five base quantities, and faults of dimension.

Each exponent is a SymPy expression: `[K] = M L^(1-n) T^-2` with symbolic n is a value. Numbers are dimensionless,
zero and infinity have every dimension. `walker` finds the dimension of an expression.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy

from hertzwerk.derive.common.faults import PicklableError
from hertzwerk.derive.common.units import Exponent, Exponents, Unit, UnitError, parse_unit, rational, unit_text

Expr = Any  # a SymPy expression; SymPy is untyped

# --- dimensions -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Dimension:
    """Exponents over mass, length, time, temperature and electric current.

    `every` marks the dimension of zero, which matches all.
    """

    M: Expr = sympy.S.Zero
    L: Expr = sympy.S.Zero
    T: Expr = sympy.S.Zero
    Theta: Expr = sympy.S.Zero
    I: Expr = sympy.S.Zero
    every: bool = False

    def __post_init__(self) -> None:
        for name in ("M", "L", "T", "Theta", "I"):
            object.__setattr__(self, name, canonical(getattr(self, name)))
        object.__setattr__(self, "_hash", hash((*self.exponents, self.every)))  # once, not in every look-up

    def __hash__(self) -> int:
        return self._hash  # type: ignore[attr-defined, no-any-return]

    def __reduce__(self) -> tuple[Any, ...]:
        return Dimension, (*self.exponents, self.every)  # hashes of names differ by process

    @classmethod
    def from_unit(cls, unit: Unit | str, symbols: Mapping[str, Expr] | None = None) -> Dimension:
        """Dimension of a unit (or its text), names in its exponents replaced by `symbols` (or numbers)."""
        unit = parse_unit(unit) if isinstance(unit, str) else unit
        if not unit.free_names:
            return _of_unit(unit)
        symbols = symbols or {}
        if missing := [name for name in unit.free_names if name not in symbols]:
            raise UnitError(f"unit {unit}: found the exponent {', '.join(missing)}, expected the name of a parameter")
        return cls(
            *(
                sum((canonical(c) * symbols[name] for name, c in e.terms), start=canonical(e.constant))
                for e in unit.exponents
            )
        )

    @property
    def exponents(self) -> tuple[Expr, Expr, Expr, Expr, Expr]:
        """The five exponents as SymPy expressions."""
        return self.M, self.L, self.T, self.Theta, self.I

    @property
    def dimensionless(self) -> bool:
        """Whether it is the dimension of a number (that of zero is)."""
        return self.every or self == ONE

    def matches(self, other: Dimension) -> bool:
        """Whether quantities of both dimensions may be added: equal, or one of them zero's."""
        return self.every or other.every or self == other

    def __mul__(self, other: Dimension) -> Dimension:
        return _multiply(self, other)

    def __truediv__(self, other: Dimension) -> Dimension:
        return _multiply(self, _raise(other, sympy.S.NegativeOne))

    def __pow__(self, exponent: Expr) -> Dimension:
        return _raise(self, canonical(exponent))

    def __str__(self) -> str:
        if self.every:
            return "any unit"
        mass, length, time, temperature, current = (_linear(exponent) for exponent in self.exponents)
        exponents: Exponents = (mass, length, time, temperature, current)
        return unit_text(exponents)


@lru_cache(maxsize=4096)
def _of_unit(unit: Unit) -> Dimension:
    """Dimension of a unit without names in its exponents."""
    return Dimension(*(canonical(exponent.constant) for exponent in unit.exponents))


def canonical(value: Expr) -> Expr:
    """Canonical form of an exponent, identical for equal ones: rational, or a cancelled quotient."""
    if isinstance(value, sympy.Rational):
        return value
    if isinstance(value, (int, float, Fraction, sympy.Float)):
        exact = rational(float(value) if isinstance(value, sympy.Float) else value)
        return sympy.Rational(exact.numerator, exact.denominator)
    return _cancelled(sympy.sympify(value, strict=True))


@lru_cache(maxsize=4096)
def _cancelled(value: Expr) -> Expr:
    return sympy.cancel(value.xreplace({x: canonical(x) for x in value.atoms(sympy.Float)}))


@lru_cache(maxsize=65536)
def _multiply(a: Dimension, b: Dimension) -> Dimension:
    return ZERO if a.every or b.every else Dimension(*(x + y for x, y in zip(a.exponents, b.exponents, strict=True)))


@lru_cache(maxsize=65536)
def _raise(a: Dimension, exponent: Expr) -> Dimension:
    return ZERO if a.every else Dimension(*(x * exponent for x in a.exponents))


def _linear(exponent: Expr) -> Exponent:
    """Linear form of an exponent for printing; terms other than names (1/k, k*n) are in parentheses."""
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
        ("m/s", "a speed"), ("m/s^2", "an acceleration"), ("A", "an electric current"), ("V", "a voltage"),
    )
}  # fmt: skip


def quantity(dimension: Dimension) -> str:
    """Name of a dimension that has one ("a force"), else its unit."""
    return _QUANTITIES.get(dimension, str(dimension))


# --- faults ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DimensionFault:
    """Fault of an expression without a dimension, or not the expected one.

    It names the smallest sub-expression, and a repair.
    """

    subexpression: str
    operands: tuple[tuple[str, str], ...]  # parts of the sub-expression: text, unit text
    found: str  # unit text
    expected: str  # unit text
    reason: str
    # SymPy number: value of the symbolic exponent, or of the power named in `repair`
    consistent_exponent: Expr | None = None
    repair: str | None = None
    # expected over found, where these are dimensions
    missing: Dimension | None = field(default=None, compare=False, repr=False)

    def __str__(self) -> str:
        lines = [f"{self.subexpression}: {self.reason}"]
        lines += [f"    {text} [{unit}]" for text, unit in self.operands]
        lines += [f"found {self.found}, expected {self.expected}"]
        return "\n".join(lines + ([f"{self.repair}."] if self.repair else []))


class DimensionError(PicklableError):
    """An expression without a dimension; `fault` has the place and the reason."""

    def __init__(self, fault: DimensionFault) -> None:
        super().__init__(str(fault))
        self.fault = fault
