"""Unit audit of one expression given as text, with units or values of its names.

audit_expression("K*d**n", {"K": "N/m^1.5", "d": "m"}, {"n": 1.1}, "N") -> Finding
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from hertzwerk.derive.audit.audit import Finding, with_repairs
from hertzwerk.derive.common.faults import Fault, InputError, noted, refuse
from hertzwerk.derive.common.units import Unit, UnitError, parse_unit
from hertzwerk.derive.expressions.dimension.culprit import Row, culprits, powers_in
from hertzwerk.derive.expressions.dimension.declared import Declared, dimension_of_unit, examine
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension, DimensionFault
from hertzwerk.derive.expressions.dimension.expression import Expression, TextError
from hertzwerk.derive.expressions.dimension.frequencies import frequencies_as_angular
from hertzwerk.derive.expressions.dimension.reader import NAMES_TOO, plain_name, read


def declarations(units: Iterable[str], values: Iterable[str]) -> tuple[dict[str, str], dict[str, float]]:
    """Parse texts `NAME=UNIT` and `NAME=NUMBER` (such as 1.1 or 3/2). Raises InputError."""
    faults: list[Fault] = []
    entries: dict[str, dict[str, str]] = {"unit": {}, "value": {}}
    for kind, texts in (("unit", units), ("value", values)):
        for text in texts:
            name, sign, rest = text.partition("=")
            name = plain_name(name.strip())
            if not sign or not rest.strip():
                expected = "NAME=UNIT, as in K=N/m^1.5" if kind == "unit" else "NAME=NUMBER, as in n=1.1"
                faults.append(Fault(f"--{kind}", repr(text), expected))
            elif name in entries[kind]:
                faults.append(Fault(f"--{kind}", f"a second {kind} of {name}", "one"))
            else:
                entries[kind][name] = rest.strip()
    numbers: dict[str, float] = {}
    for name, text in entries["value"].items():
        try:
            number = read(text).root.number
        except TextError as error:
            number = None
            faults.append(Fault(f"--value {name}", error.found, error.expected, error.remedy))
        else:
            if number is None:
                faults.append(Fault(f"--value {name}", repr(text), "a number", "A unit is given by --unit."))
        numbers[name] = 0.0 if number is None else number
    refuse("options", faults)
    return entries["unit"], numbers


def audit_expression(
    text: str, units: Mapping[str, str], values: Mapping[str, float] | None = None, expect: str | None = None
) -> Finding:
    """Audit of the units of one expression given as text.

    `units` declares names (name -> unit text), `values` gives numbers for names of unit 1 (or for names that `units`
    lacks), `expect` is the unit the result must have; without it the finding's `found` is the unit it has. Raises
    InputError, listing every fault, for text that cannot be read and for undeclared names.
    """
    faults: list[Fault] = []
    expression, declared, expected = None, None, None
    try:
        expression = read(text)
        faults.extend(undeclared(expression, {plain_name(name) for name in (*units, *(values or {}))}))
    except TextError as error:
        faults.append(Fault(f"expression, character {error.position}", error.found, error.expected, error.remedy))
    with noted(faults):
        declared = Declared.of(units, values)
    try:
        if expect is not None:
            expected = parse_unit(expect) if declared is None else dimension_of_unit(expect, declared.constants)
    except UnitError as error:
        faults.append(Fault("expected unit", repr(expect), "a unit", str(error)))
    if faults or expression is None or declared is None or isinstance(expected, Unit):
        raise InputError(f"expression {text!r}" if len(str(text)) <= 60 else "expression", faults)
    said = finding(expression, declared, expected, effect="", quantity="expression", kind="expression")
    return with_culprit([said], [("expression", expression, expected)], declared, expression.names)[0]


def undeclared(expression: Expression, names: Iterable[str]) -> list[Fault]:
    """Faults of names in the text that are not declared."""
    known = sorted(names)
    faults = []
    for name in expression.names:
        if name not in known:
            close = difflib.get_close_matches(name, known, n=2, cutoff=0.6)
            offer = f"Did you mean {' or '.join(close)}? " if close else ""
            remedy = f"{offer}Declare it: {name} with its unit, 1 for a number."
            faults.append(Fault(f"name {name}", "no unit for it", "a declared name", remedy))
    for node in expression.root.walk():
        if node.op in NAMES_TOO and node.op in known:
            remedy = (
                f"A product with {node.op} is written {node.op}*(...); for the function give the quantity another name."
            )
            faults.append(
                Fault(
                    f"name {node.op}",
                    f"{expression.quote(node)!r}, where {node.op} is declared",
                    "a function or a quantity",
                    remedy,
                )
            )
    return faults


Text = tuple[str, Expression, Dimension | None]
"""Description of an expression, its text, its required dimension; a "definition of NAME" must have that of the name."""


def with_culprit(
    findings: list[Finding], texts: Sequence[Text], declared: Declared, candidates: Iterable[str]
) -> list[Finding]:
    """Add to each finding the symbol whose unit is wrong, where there is one, as its repair.

    The texts share their names.
    """
    if all(finding.verdict == "consistent" for finding in findings):
        return findings

    def row(place: str, expression: Expression, expected: Dimension | None) -> Row:
        name = place.removeprefix("definition of ")

        def fault(dimensions: Mapping[str, Dimension]) -> DimensionFault | None:
            numbers = {n: declared.constants.get(n, sp.Symbol(n, real=True)) for n, d in dimensions.items() if d == ONE}
            known = replace(declared, dimensions=dimensions, constants=numbers, symbols=numbers)
            try:
                return examine(expression, known, dimensions[name] if name != place else expected)[1]
            except TextError:
                return DimensionFault(str(expression), (), "unknown", "", "an exponent that cannot be compared")

        return Row(fault, lambda symbol: powers_in(expression.root, symbol))

    return with_repairs(
        findings,
        culprits(
            [row(*text) for text in texts],
            declared.dimensions,
            {name: declared.units.get(name, "1") for name in candidates},
        ),
    )


def finding(expression: Expression, declared: Declared, expected: Dimension | None, **place: Any) -> Finding:
    """Finding on one expression; `place` has its effect, quantity, law, kind, title, source."""
    try:
        dimension, fault = examine(expression, declared, expected)
    except TextError as error:
        where = f"expression, character {error.position}"
        raise InputError(str(expression), [Fault(where, error.found, error.expected, error.remedy)]) from None
    if fault is None:
        shown = expected if expected is not None and dimension is not None and dimension.every else dimension
        doubts = frequencies_as_angular(expression.root, declared.units, expression.quote)
        return Finding(verdict="consistent", expression=str(expression), found=str(shown), symbols=_symbols(expression, str(expression), declared),
                       expected="" if expected is None else str(expected), advice="; ".join(doubts), **{**_NOWHERE, **place})  # fmt: skip
    exponent = None if fault.consistent_exponent is None else str(fault.consistent_exponent)
    return Finding(
        verdict="inconsistent", expression=str(expression), found=fault.found, expected=fault.expected, subexpression=fault.subexpression,
        symbols=_symbols(expression, fault.subexpression, declared), reason=fault.reason, consistent_exponent=exponent, repair=fault.repair,
        **{**_NOWHERE, **place},
    )  # fmt: skip


_NOWHERE = dict.fromkeys(("effect", "quantity", "law", "title", "source"), "")


def _symbols(expression: Expression, part: str, declared: Declared) -> tuple[tuple[str, str, str], ...]:
    inside = {node.name for node in read(part).root.walk() if node.op == "name"}
    return tuple(
        (name, str(declared.dimensions[name]), declared.meanings.get(name, ""))
        for name in expression.names
        if name in inside
    )
