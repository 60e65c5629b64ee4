"""Names of an expression's text as declared, and its dimension or smallest sub-expression without one.

The text's own tree is examined: in its SymPy expression, `d**1`, `m - m + s` or `0*x` would already have collapsed.
Exponents consist of numbers and constant parameters: names with unit 1, names given by value.

    examine(expression, declared, expected) -> (dimension, fault), one of them None
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.common.units import UnitError, parse_unit
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension, DimensionError, DimensionFault, canonical
from hertzwerk.derive.expressions.dimension.expression import Expression
from hertzwerk.derive.expressions.dimension.reader import RESERVED, plain_name
from hertzwerk.derive.expressions.dimension.walker import Walker


@dataclass(frozen=True)
class Declared:
    """Declarations of an expression's names: dimensions, and the constants exponents may contain."""

    dimensions: Mapping[str, Dimension]
    constants: Mapping[str, Any] = field(default_factory=dict)
    """Constant name -> its symbol, or its given value."""
    symbols: Mapping[str, Any] = field(default_factory=dict)
    """Constant name -> its symbol, also where a value is given."""
    units: Mapping[str, str] = field(default_factory=dict)
    """Name -> unit as declared."""
    meanings: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, units: Mapping[str, str], values: Mapping[str, float] | None = None) -> Declared:
        """Make from unit texts and given values; raises InputError with every fault."""
        units = {plain_name(name): unit for name, unit in units.items()}
        values = {plain_name(name): value for name, value in (values or {}).items()}
        faults = [*_name_faults([*units, *values]), *_value_faults(values)]
        symbols = {name: sp.Symbol(name, real=True) for name in dict.fromkeys((*units, *values))
                   if name not in units or units[name].strip() == "1"}  # fmt: skip
        constants = {name: canonical(values[name]) if name in values and math.isfinite(values[name]) else symbol
                     for name, symbol in symbols.items()}  # fmt: skip
        dimensions: dict[str, Dimension] = {name: ONE for name in values if name not in units}
        for name, unit in units.items():
            try:
                dimensions[name] = dimension_of_unit(unit, constants)
            except UnitError as error:
                faults.append(Fault(f"unit of {name}", repr(unit), "a unit", str(error)))
        refuse("expression", faults)
        return cls(dimensions, constants, symbols, units)

    @property
    def general(self) -> Declared:
        """The declarations with the given values of constants left open."""
        dimensions = dict(self.dimensions)
        for name, unit in self.units.items():
            dimensions[name] = dimension_of_unit(unit, self.symbols)
        return replace(self, dimensions=dimensions, constants=self.symbols)


def dimension_of_unit(unit: str, constants: Mapping[str, Any]) -> Dimension:
    """Dimension of a unit's text; names in its exponents must be constants. Raises UnitError."""
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


def examine(
    expression: Expression, declared: Declared, expected: Dimension | None = None
) -> tuple[Dimension | None, DimensionFault | None]:
    """Dimension of an expression, or the fault why it has none (or not the expected one).

    Raises TextError for exponents too complex to compare. Where values are given for constants, the repair is the one
    for any value.
    """
    try:
        return Walker(expression, declared.dimensions, declared.constants).result(expression.root, expected), None
    except DimensionError as error:
        fault = error.fault
    if declared.constants != declared.symbols and fault.found != fault.expected:
        general = declared.general
        try:
            Walker(expression, general.dimensions, general.constants).result(expression.root, expected)
        except DimensionError as error:  # with the exponent left open, for the repair
            if error.fault.subexpression == fault.subexpression and error.fault.consistent_exponent is not None:
                general_fault = error.fault
                fault = replace(
                    fault, consistent_exponent=general_fault.consistent_exponent, repair=general_fault.repair
                )
    return None, fault
