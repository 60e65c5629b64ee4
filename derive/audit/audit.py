"""Unit audit of a scene: its laws as written and as bound, then every assignment and output."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from hertzwerk.derive.audit.contact_forms import advice
from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.markup import coloured, heading, table, tag
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.declare.scene.scene import Scene, require_scene
from hertzwerk.derive.expressions.dimension.culprit import Culprit, Row, culprits, likeliest, powers_in, sentence
from hertzwerk.derive.expressions.dimension.dimension import ONE, Dimension, DimensionError, DimensionFault
from hertzwerk.derive.expressions.dimension.frequencies import frequencies_as_angular
from hertzwerk.derive.expressions.dimension.symbolic import Symbolic, reader, symbolic
from hertzwerk.derive.expressions.dimension.walker import Walker, check, dimension_of
from hertzwerk.derive.laws.law import GEOMETRY, STATE, BoundLaw, Law
from hertzwerk.derive.program.program import Program


@dataclass(frozen=True)
class Finding:
    """Result of the audit for one expression.

    `verdict` is consistent, inconsistent, outside_si (inconsistent, but the law names the units it was fitted in),
    unchecked (inconsistent, run on purpose), refused (a start from which no run begins), or advice: the units are
    consistent, and `reason` is another objection to the law.
    """

    effect: str
    quantity: str
    law: str
    title: str
    source: str
    verdict: str
    expression: str
    symbols: tuple[tuple[str, str, str], ...] = ()
    """(name, unit, meaning) of the symbols of the expression."""
    found: str = ""
    expected: str = ""
    subexpression: str = ""
    reason: str = ""
    consistent_exponent: str | None = None
    repair: str | None = None
    grade: str = ""
    """Reliability of the law's formula, A to C; R is a reconstruction."""
    kind: str = ""
    """Kind of the law (stiffness, damping, friction), or expression, program, form of contact, frequency, start."""
    advice: str = ""
    """Doubt of a consistent expression that units cannot show: a frequency taken as an angular speed."""

    @property
    def sound(self) -> bool:
        """Whether the units are consistent."""
        return self.verdict in ("consistent", "advice")

    @property
    def sentence(self) -> str:
        """The finding in one sentence."""
        if self.verdict == "consistent":
            return f"{self.expression} is {self.found}"
        return f"{self.reason}; {self.repair}" if self.repair else self.reason

    def record(self) -> dict[str, str | None]:
        """The finding as plain values for JSON, None where empty; a law run unchecked is inconsistent."""
        verdict = "inconsistent" if self.verdict == "unchecked" else self.verdict
        first = {
            "law": self.law or None,
            "kind": self.kind or None,
            "source": self.source or None,
            "grade": self.grade or None,
        }
        names = ("found", "expected", "subexpression", "reason", "consistent_exponent", "repair", "advice")
        return {**first, "verdict": verdict, **{name: getattr(self, name) or None for name in names}}

    def __str__(self) -> str:
        """The finding as it is shown to people, with explanation and remedy."""
        if not self.effect:
            return self.sentence
        lines = [f"{self.effect}, {self.quantity}: {self.title}"]
        width = max(14, len(self.expression))
        for k, (name, unit, meaning) in enumerate(self.symbols):
            lines.append(
                f"    {self.expression if k == 0 else '':<{width}}  {f'{name} [{unit}]':<12} {meaning}".rstrip()
            )
        if not self.symbols:
            lines.append(f"    {self.subexpression or self.expression}")
        if self.verdict == "consistent":
            return "\n".join([*lines, f"    {self.found}, consistent"])
        lines.append(f"    found {self.found}, expected {self.expected}")
        lines.append(f"{self.repair}." if self.repair else f"{self.reason}.")
        if self.consistent_exponent is not None and self.quantity == "normal force":
            lines.append(
                f"Either keep n = {self.consistent_exponent}, or give a stiffness with its own unit: power(K [N/m^n], n), "
                "or take a line-contact law\nwith the joint's length: johnson, popov_line, wang_liu_internal."
            )
        if self.law:
            lines.append("To see what the inconsistent law does, mark it: Contact(..., unchecked=True).")
        return "\n".join(lines)


class Findings(tuple[Finding, ...]):
    """Findings of an audit, shown as a table of what was found and what is wrong."""

    __slots__ = ()

    def _repr_html_(self) -> str:
        wrong = [finding for finding in self if not finding.sound]
        summary = (
            f"{len(self)} findings, {len(wrong)} inconsistent" if wrong else f"{len(self)} findings, all consistent"
        )
        rows = [
            (
                coloured(f.verdict, f.sound),
                f"{f.effect}, {f.quantity}",
                tag("code", f.subexpression or f.expression, style="overflow-wrap:anywhere"),
                f.found if f.sound else f"{f.found}, not {f.expected}",
                f.repair or f.reason,
            )
            for f in self
        ]
        header = ("verdict", "expression", "as written", "unit", "what to do")
        return heading("audit", summary, "", good=not wrong) + table(header, rows)


class InconsistentUnits(InputError):
    """A scene with inconsistent units; `findings` are all of them."""

    def __init__(self, scene: Scene, findings: Iterable[Finding]) -> None:
        self.findings = tuple(findings)
        faults = [Fault(f"{f.effect}, {f.quantity}", f.found, f.expected, f.repair or f.reason) for f in self.findings]
        super().__init__(f"scene {scene.name}", faults)
        count = f"{len(faults)} unit error" + ("s" if len(faults) != 1 else "")
        self.args = (f"derive {scene.name}: {count}, nothing written\n\n" + "\n\n".join(map(str, self.findings)),)


def refuse_inconsistent(scene: Scene, findings: Iterable[Finding]) -> None:
    """Raise InconsistentUnits if any finding is inconsistent."""
    wrong = [finding for finding in findings if finding.verdict == "inconsistent"]
    if wrong:
        raise InconsistentUnits(scene, wrong)


def advice_findings(scene: Scene) -> tuple[Finding, ...]:
    """Advice: form of contact, pairs without effects, frequencies taken as angular speeds."""
    said = [("form of contact", text) for text in advice(scene)]
    used = {name for effect in scene.effects for name in effect.pairs}
    said += [
        ("pair", f"pair {pair.name} has no Contact: its surfaces pass through each other")
        for pair in scene.mechanism.pairs
        if pair.name not in used
    ]
    doubts: dict[Any, list[str]] = {}  # of many slots that share a value
    for slot in scene.slots():
        if slot.value not in doubts:
            value = sp.sympify(slot.value)
            units = {symbol: symbol.unit for symbol in value.free_symbols if hasattr(symbol, "unit")}
            doubts[slot.value] = list(_doubts(value, units))
        said += [("frequency", f"{slot.where}: {text}") for text in doubts[slot.value]]
    return tuple(
        Finding(scene.name, kind, "", "", "", "advice", "", reason=text, kind=kind)
        for kind, text in dict.fromkeys(said)
    )


def audit_laws(scene: Scene) -> tuple[Finding, ...]:
    """One finding per expression of every law in the scene."""
    require_scene(scene)
    findings: list[Finding] = []
    known: dict[Any, list[Finding]] = {}
    for effect in scene.effects:
        for bound in effect.laws:
            findings.extend(_law_findings(scene, effect.name, bound, effect.unchecked, known))
    return tuple(findings)


def audit_law(law: Law) -> tuple[Finding, ...]:
    """One finding per definition and expression of a law, with the units it declares."""
    names = {symbol.name: symbol for symbol in law.parameters if symbol.unit == "1"}
    table = {symbol: _dimension(symbol.unit, names) for symbol in law.symbols()}
    wrong = "outside_si" if law.fitted_in else "inconsistent"
    rows = [*_definitions(law), *law.expressions()]
    findings = [_law_finding(law, row, table, {}, [*names.values(), *_numbers(law)], names) for row in rows]
    if law.verdict == "consistent" and verdict(findings) != "consistent":
        findings = with_repairs(findings, _culprits(law, table, names))
    return tuple(replace(f, verdict=wrong) if f.verdict != "consistent" else f for f in findings)


def _culprits(law: Law, table: Mapping[sp.Symbol, Dimension], names: Mapping[str, sp.Symbol]) -> Sequence[Culprit]:
    """Symbols of a law by whose unit alone its faults would go."""
    own = [symbol for symbol in table if symbol not in (*STATE, *GEOMETRY) or symbol in law.parameters]
    defined = {f"definition of {symbol.name}": symbol for symbol, _ in law.definitions}

    def row(quantity: str, expression: sp.Expr, unit: str) -> Row:
        def fault(dimensions: Mapping[sp.Symbol, Dimension]) -> DimensionFault | None:
            expected = dimensions[defined[quantity]] if quantity in defined else _dimension(unit, names)
            return check(expression, dimensions, expected, [s for s in own if dimensions[s] == ONE])

        return Row(fault, lambda symbol: powers_in(symbolic(expression), symbol))

    rows = [row(*entry) for entry in (*_definitions(law), *law.expressions())]
    return culprits(rows, table, {symbol: symbol.unit for symbol in own})


def with_repairs(findings: list[Finding], suspects: Sequence[Culprit]) -> list[Finding]:
    """Add the likeliest symbols with a wrong unit to the findings as their repair.

    Another exponent that would do is kept beside it. If there is no such symbol and only one expression is
    inconsistent, the repair points to that expression.
    """
    faulty = [finding for finding in findings if finding.verdict != "consistent"]
    alone = len(findings) == 1
    best = likeliest(suspects, alone)

    def repaired(finding: Finding) -> Finding:
        if finding.verdict == "consistent":
            return finding
        if best and alone:
            repair = "; or ".join(filter(None, (sentence(best, "it"), finding.repair)))
            # every symbol has a unit given by the user: a plain number may hide the missing one
            all_given = finding.consistent_exponent is None and not finding.law
            return finding if all_given else replace(finding, repair=repair)
        if best:
            return replace(finding, repair=sentence(best, "every expression of the law"), consistent_exponent=None)
        only = f"every other expression of the law holds, so that it is the {finding.quantity} that is wrong"
        one = len(faulty) == 1 and not alone
        return replace(finding, repair="; ".join(filter(None, (only if one else "", finding.repair))) or None)

    return [repaired(finding) for finding in findings]


def verdict(findings: Iterable[Finding]) -> str:
    """Verdict of a law: that of its first finding that is not consistent."""
    return next((finding.verdict for finding in findings if finding.verdict != "consistent"), "consistent")


def _numbers(law: Law) -> list[sp.Symbol]:
    """Dimensionless definitions of a law: computed once, so allowed in an exponent."""
    return [symbol for symbol, _ in law.definitions if symbol.unit == "1"]


def _definitions(law: Law) -> Iterable[tuple[str, sp.Expr, str]]:
    return ((f"definition of {s.name}", e, s.unit) for s, e in law.definitions)


def _law_findings(
    scene: Scene, effect: str, bound: BoundLaw, unchecked: bool, known: dict[Any, list[Finding]]
) -> Iterable[Finding]:
    """Findings of a bound law; `known` are those of laws bound alike, as in contacts of a kind."""
    law = bound.law
    table = _law_table(scene, bound)
    exponents = {s: sp.sympify(value) for s, value in bound.binding.items() if s.unit == "1"}
    numbers = ", ".join(f"{s.name} = {value}" for s, value in exponents.items() if value.is_number)
    constants = [*scene.parameters.values(), *exponents, *_numbers(law)]
    force_is_wrong = False
    key = (id(law), *exponents.items(), *(table[symbol] for symbol in law.symbols()))
    if key not in known:
        rows = (*(row for row in _definitions(law) if "^n" not in row[2]), *law.expressions())
        known[key] = [_law_finding(law, row, table, exponents, constants, {}) for row in rows]
    for finding in known[key]:
        if force_is_wrong and finding.quantity == "stored energy":
            continue  # follows from the wrong force
        force_is_wrong = force_is_wrong or (finding.quantity == "normal force" and finding.verdict != "consistent")
        yield replace(
            finding,
            effect=effect,
            title=f"{law.title}{f', {numbers}' if numbers else ''}",
            verdict="unchecked" if unchecked and finding.verdict == "inconsistent" else finding.verdict,
        )


def _law_finding(
    law: Law,
    row: tuple[str, sp.Expr, str],
    table: Mapping[sp.Symbol, Dimension],
    exponents: Mapping[sp.Symbol, sp.Expr],
    constants: list[sp.Symbol],
    names: Mapping[str, sp.Symbol],
) -> Finding:
    """Finding of one (what, expression, unit) of a law.

    `exponents` are given values of exponents; `names` are symbols left open in units.
    """
    quantity, expression, unit = row
    expected = _dimension(unit, names)
    fault = check(expression.xreplace(exponents), table, expected, constants)
    general = check(expression, table, expected, constants) or fault  # with the exponent left open, for the remedy
    symbols = tuple(
        (s.name, str(table[s]), s.meaning)
        for s in sorted(_symbols_with_units(_smallest(expression, general), table), key=lambda symbol: symbol in STATE)
        if s.unit != "1"
    )
    return Finding(
        effect=law.name,
        quantity=quantity,
        law=law.name,
        kind=law.kind,
        title=law.title,
        source=law.source,
        grade=law.grade,
        verdict="consistent" if fault is None else "inconsistent",
        expression=str(expression),
        symbols=symbols,
        found=str(expected) if fault is None else fault.found,
        expected=str(expected) if fault is None else fault.expected,
        subexpression="" if fault is None else fault.subexpression,
        reason="" if fault is None else fault.reason,
        consistent_exponent=_exponent(general) if fault is not None else None,
        repair=None if fault is None or general is None else general.repair,
        advice="" if fault else "; ".join(_doubts(expression, {q: q.unit for q in law.symbols()})),
    )


def _law_table(scene: Scene, bound: BoundLaw) -> dict[sp.Symbol, Dimension]:
    """Dimensions of a bound law's symbols: of parameters as bound, of all others as declared."""
    parameters = scene.dimensions
    table = dict(parameters)
    for symbol, value in bound.binding.items():
        number = sp.sympify(value)
        table[symbol] = ONE if number.is_number else dimension_of(number, parameters, list(parameters))
    return table | {symbol: _dimension(symbol.unit, {}) for symbol in bound.law.symbols() if symbol not in table}


def _dimension(unit: str, names: Mapping[str, sp.Symbol]) -> Dimension:
    return Dimension.from_unit(parse_unit(unit), names)


def _symbols_with_units(expression: Any, table: Mapping[sp.Symbol, Dimension]) -> list[Any]:
    """Symbols with a unit in an expression, in order of appearance."""
    return list(dict.fromkeys(node for node in sp.preorder_traversal(expression) if node in table))


def _smallest(expression: Any, fault: DimensionFault | None) -> Any:
    """Sub-expression named by a fault; the whole expression where there is no fault."""
    if fault is None:
        return expression
    return next((node for node in sp.preorder_traversal(expression) if str(node) == fault.subexpression), expression)


def _doubts(expression: sp.Expr, units: Mapping[sp.Symbol, str]) -> Iterator[str]:
    """Yield what units cannot show of a consistent expression."""
    return frequencies_as_angular(symbolic(expression), units, Symbolic().quote)


def _exponent(fault: DimensionFault | None) -> str | None:
    return None if fault is None or fault.consistent_exponent is None else str(fault.consistent_exponent)


def audit_program(program: Program) -> tuple[dict[sp.Symbol, str], tuple[Finding, ...]]:
    """Unit of every symbol of a program, and one finding per inconsistent assignment or output.

    The first finding of a chain is the cause: results that depend on it are taken as unknown and skipped.
    """
    table: dict[sp.Symbol, Dimension] = dict(program.tape.declared)
    constants = [
        symbol for symbol in (*program.tape.inputs, *program.tape.assignments) if program.tape.is_constant(symbol)
    ]
    findings: list[Finding] = []
    read, walk = reader(), Walker(Symbolic(), table, constants)

    def examine(quantity: str, expression: Any, expected: Dimension | None) -> Dimension | None:
        try:
            return walk.result(read(expression), expected)
        except DimensionError as error:
            if error.fault.found != "unknown":
                findings.append(_finding(program, quantity, expression, error.fault))
            return None

    for symbol, expression in program.assignments():
        if symbol not in table and (dimension := examine(f"assignment {symbol.name}", expression, None)) is not None:
            table[symbol] = dimension
    for function in program.functions:
        for result in function.results:
            for label, unit, expression in zip(result.labels, result.units, result.expressions, strict=True):
                if unit:
                    expected = Dimension.from_unit(unit)
                    examine(f"output {function.name}.{result.name}[{label}]", sp.sympify(expression), expected)
    texts = {dimension: str(dimension) for dimension in dict.fromkeys(table.values())}
    return {symbol: texts[dimension] for symbol, dimension in table.items()}, tuple(findings)


def _finding(program: Program, quantity: str, expression: Any, fault: DimensionFault) -> Finding:
    return Finding(
        effect=program.scene.name, quantity=quantity, law="", title=fault.reason, source="", verdict="inconsistent",
        expression=str(expression), found=fault.found, expected=fault.expected, subexpression=fault.subexpression,
        reason=fault.reason, consistent_exponent=_exponent(fault), repair=fault.repair, kind="program",
    )  # fmt: skip
