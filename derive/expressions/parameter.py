"""Parameters: symbols with a unit, a default and a meaning, and ranges of values."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from numbers import Integral, Real
from typing import Any, Self, TypeAlias

import sympy as sp

from hertzwerk.derive.common.faults import Fault
from hertzwerk.derive.common.identifiers import name_faults, text_faults, unit_faults
from hertzwerk.derive.common.units import Unit, parse_unit
from hertzwerk.derive.expressions.algebra.tagged import Tagged
from hertzwerk.derive.expressions.dimension.dimension import Dimension

TABLE = "_TABLE"
"""Suffix of the names of tables in a generated module."""
CURVE = "_curve"
"""Suffix of the name of a curve's function in a generated module, in capitals of its data's."""


class Parameter(Tagged):
    """Named constant of a scene; a SymPy symbol, so it can be used in expressions.

    `unit` is text (`"mm"`, `"N/m^1.5"`, `"N/m^exponent"` with another parameter's name), `default` a number in that
    unit, of NumPy too, or rational. Parameters that differ in anything are different symbols; a scene refuses two of one name.
    """

    __slots__ = ("default", "meaning", "unit")
    tags = ("unit", "default", "meaning")

    def __new__(cls, name: str, unit: str, default: float, meaning: str = "") -> Parameter:
        """Make a new symbol; raises InputError for values that are no text."""
        cls.must_be_text("parameter", name, unit=unit, meaning=meaning)
        return super().__new__(cls, name, unit, plain_number(default), meaning)

    def faults(self) -> Iterator[Fault]:
        """Yield the faults of the declaration itself."""
        where = f"parameter {self.name}"
        yield from name_faults(where, self.name)
        yield from text_faults(f"{where}, meaning", self.meaning)
        if self.name.endswith(TABLE):
            yield Fault(where, f"the name {self.name!r}", f"a name that does not end in {TABLE}, as those of tables do")
        yield from unit_faults(where, self.unit)
        if isinstance(self.default, bool) or not isinstance(self.default, (int, float)):
            yield Fault(where, f"default {self.default!r}", "a number")
        elif not abs(self.default) <= sys.float_info.max:
            yield Fault(where, f"default {self.default!r:.30}", "a finite number")

    @property
    def parsed_unit(self) -> Unit:
        """Parsed unit; raises UnitError."""
        return parse_unit(self.unit)

    @property
    def si(self) -> float:
        """Default in SI."""
        return self.parsed_unit.to_si(self.default)


@dataclass(frozen=True)
class Interval:
    """Range of a quantity in SI; None is unbounded."""

    lower: float | None = None
    upper: float | None = None
    open_left: bool = False
    open_right: bool = False

    def holds(self, value: float) -> bool:
        """Whether `value` lies inside."""
        above = self.lower is None or (value > self.lower if self.open_left else value >= self.lower)
        below = self.upper is None or (value < self.upper if self.open_right else value <= self.upper)
        return above and below

    def __str__(self) -> str:
        left = "(" if self.open_left or self.lower is None else "["
        right = ")" if self.open_right or self.upper is None else "]"
        lower = "-inf" if self.lower is None else f"{self.lower:g}"
        upper = "inf" if self.upper is None else f"{self.upper:g}"
        return f"{left}{lower}, {upper}{right}"


POSITIVE = Interval(lower=0, open_left=True)
NOT_NEGATIVE = Interval(lower=0)

Scalar: TypeAlias = sp.Expr | float
"""A parameter, an expression of parameters, or a number (dimensionless, or 0)."""


def plain_number(value: Any) -> Any:
    """Return a real number of any kind, of NumPy or a fraction, as an int or a float; others as they are."""
    if isinstance(value, bool) or not isinstance(value, Real):
        return value
    try:
        return int(value) if isinstance(value, Integral) else float(value)
    except OverflowError:
        return value


def is_number(value: Any) -> bool:
    """Whether a value is a number or an expression, not text, which SymPy would execute."""
    return isinstance(value, int | float | sp.Expr) and not isinstance(value, bool)


def parameters_of(expression: Any) -> list[Parameter]:
    """List the parameters in `expression` in order of appearance (never in hash order).

    [] for values that are no expression.
    """
    if not isinstance(expression, sp.Basic):
        return []  # numbers, and text, which SymPy would execute
    return list(_parameters_of(expression))


@lru_cache(maxsize=4096)
def _parameters_of(expression: sp.Basic) -> tuple[Parameter, ...]:
    parameters = (node for node in sp.preorder_traversal(expression) if isinstance(node, Parameter))
    return tuple(dict.fromkeys(parameters))


def dimensions_of(parameters: Mapping[str, Parameter]) -> dict[sp.Symbol, Dimension]:
    """Dimension of every parameter; names in unit exponents (`N/m^exponent`) become its parameters."""
    symbols: dict[str, sp.Symbol] = dict(parameters)
    return {p: Dimension.from_unit(p.parsed_unit, symbols) for p in parameters.values()}


def default_value(expression: Any) -> float:
    """Value of an expression at its parameters' defaults, SI; NaN where it is not real."""
    return _default_value(sp.sympify(expression))


@lru_cache(maxsize=4096)
def _default_value(expression: sp.Basic) -> float:
    value = expression.xreplace({p: sp.Float(p.si, 17) for p in parameters_of(expression)})
    return float(value) if value.is_number and value.is_real else math.nan


@dataclass(frozen=True)
class Slot:
    """One quantity of a record: its place, value and unit, and the ranges (SI) it must and should keep.

    `law_symbol` is `<pair>.<symbol>` for quantities that a pair has for its laws alone: without a law that depends on
    it, it is unused.
    """

    where: str
    value: Scalar
    unit: str
    limit: Interval | None = None
    recommended: Interval | None = None
    law_symbol: str = ""

    @classmethod
    def of(cls, unit: str, limit: Interval | None = None, label: str = "", **options: Any) -> Self:
        """Quantity of a field of a record, whose place and value the record gives: an entry of its `measures`."""
        return cls(label, 0, unit, limit, **options)
