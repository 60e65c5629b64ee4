"""User-defined laws from a TOML file; their expressions are parsed and never executed.

    [[law]]
    name = "my_foam"
    kind = "stiffness"                # stiffness: force, stored?, reach?, exponent?, relation?     damping: factor or term, exponent?, release?
    title = "Foam pad"                # friction: force, slope? (else its derivative at rest)     film: along, across, couple
    source = "measured, 2024"
    form = "any"                      # form of contact: point, line, surface, any, or a list; required for a stiffness law
    force = "K*d**n*exp(d/h)"
    exponent = "n"
    reach = "h"
    symbols.K = { unit = "N/m^n", meaning = "stiffness", limits = "(0, inf)" }
    symbols.n = { unit = "1", meaning = "exponent", limits = "[1, 3]" }
    symbols.h = { unit = "mm", meaning = "thickness", default = 20 }
    definitions = [{ symbol = "E_eff", unit = "Pa", meaning = "...", expression = "..." }]    # intermediate results, in order
    ranges.dR = { defined = "[5e-6, 1 mm]", recommended = "..." }                             # a bound without a unit is in the symbol's unit

The parameters are the symbols, in the order written. The quantities supplied by a contact (d in a stiffness law; d,
v, v0, F, k_t in a damping law; N, s in a friction law; epsilon_w, epsilon_c in a film law) and the geometry of its
pair (R_eff, dR, L, m_eff, ...) need no declaration. All faults of a file are reported at once: of each table by
itself (`lawtable`), and where it has none, of its entries in relation to each other. A law with consistent units is
tested numerically too (`behaviour`): a force that decreases, a `stored` that is not its integral are faults.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import sympy as sp

from hertzwerk.derive.audit.admissibility import faults_if_consistent
from hertzwerk.derive.audit.audit import Finding
from hertzwerk.derive.audit.audit_text import finding, undeclared, with_culprit
from hertzwerk.derive.common.execute_file import beside
from hertzwerk.derive.common.faults import Fault, InputError, refuse
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.common.toml_file import read_toml
from hertzwerk.derive.common.units import UnitError, parse_quantity, parse_unit, rate_remedy
from hertzwerk.derive.expressions.dimension.declared import Declared, dimension_of_unit
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.dimension.expression import Expression, TextError, to_sympy
from hertzwerk.derive.expressions.dimension.reader import RESERVED, plain_name
from hertzwerk.derive.expressions.parameter import Interval, Parameter
from hertzwerk.derive.laws import law as record
from hertzwerk.derive.laws.law import DampingLaw, FilmLaw, FrictionLaw, Law, Quantity, Range, StiffnessLaw

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.user_files.law_table import DefinitionTable, LawTable, SymbolTable


@dataclass(frozen=True)
class _Kind:
    """Kind of law: its record, the quantities supplied by a contact, its expressions with their units."""

    record: type[Any]
    supplied: tuple[Quantity, ...]
    expressions: dict[str, str]


_KINDS = {
    "stiffness": _Kind(
        StiffnessLaw, (record.d,), {"force": "N", "relation": "m", "stored": "J", "reach": "m", "exponent": "1"}
    ),
    "damping": _Kind(
        DampingLaw, (record.d, record.v, record.v0, record.F, record.k_t), {"factor": "1", "term": "N", "exponent": "1"}
    ),
    "friction": _Kind(FrictionLaw, (record.N, record.s), {"force": "N", "slope": "N s/m"}),
    "film": _Kind(FilmLaw, (record.eps_w, record.eps_c), {"along": "N s/m", "across": "N s/m", "couple": "N m s"}),
}
_PLAIN = ("name", "title", "source", "grade", "verdict", "fitted_in", "repair", "note")


@dataclass(frozen=True)
class WrittenLaw:
    """A law and its expressions as written, for the audit: (description, text, required unit)."""

    law: Law
    texts: tuple[tuple[str, Expression, Dimension], ...]
    declared: Declared


def laws_from(path: str | Path) -> dict[str, Law]:
    """Laws of a TOML file by name, for use in a scene; a relative path is from the scene file's folder.

    Raises InputError with every fault of the file.
    """
    return {written.law.name: written.law for written in read_laws(beside(path))}


def read_laws(path: str | Path) -> tuple[WrittenLaw, ...]:
    """Laws of a TOML file with their texts. Raises InputError with every fault of the file."""
    from hertzwerk.derive.exchange.user_files.law_table import (
        validated,  # imports pydantic, which a scene without files does not need
    )

    content = read_toml(path, "tables [[law]]")
    tables = content.get("law")
    faults = [Fault(str(path), f"the key {key!r}", "tables [[law]] alone") for key in content if key != "law"]
    if not isinstance(tables, list) or not tables or not all(isinstance(table, dict) for table in tables):
        raise InputError(str(path), [*faults, Fault(str(path), "no laws", "tables [[law]], one per law")])
    written: list[WrittenLaw] = []
    names: list[object] = []
    for number, entry in enumerate(tables, start=1):
        name = entry.get("name")
        where = f"law {name if isinstance(name, str) and name else number}"
        if name in names:
            faults.append(Fault(where, f"a second {where}", "names that are unique"))
        names.append(name)
        table, wrong = validated(where, entry)
        reader = None if table is None else _Reader(table, where)
        law = None if reader is None else reader.law()
        faults.extend(wrong if reader is None else reader.faults)
        if law is not None:
            written.append(law)
            faults.extend(faults_if_consistent(law.law))
    refuse(str(path), faults)
    return tuple(written)


def audit_laws_as_written(path: str | Path) -> tuple[Finding, ...]:
    """One finding per definition and expression of the laws of a TOML file, quoting its text.

    Raises InputError.
    """
    findings: list[Finding] = []
    for written in read_laws(path):
        law = written.law
        own = []
        for quantity, expression, unit in written.texts:
            place = {
                "effect": law.name,
                "quantity": quantity,
                "law": law.name,
                "kind": law.kind,
                "title": law.title,
                "source": law.source,
            }
            row = finding(expression, written.declared, unit, **place)
            outside = law.fitted_in and row.verdict == "inconsistent"
            own.append(replace(row, verdict="outside_si") if outside else row)
        if law.verdict == "consistent":
            names = dict.fromkeys(
                symbol.name for symbol in (*law.parameters, *(symbol for symbol, _ in law.definitions))
            )
            own = with_culprit(own, written.texts, written.declared, names)
        findings.extend(own)
    return tuple(findings)


class _Reader:
    """Converter of a valid [[law]] table to a record; checks its entries against each other."""

    def __init__(self, table: LawTable, where: str) -> None:
        self.table = table
        self.where = where
        self.kind = _KINDS[table.kind]
        self.state = [symbol.name for symbol in self.kind.supplied]
        self.faults: list[Fault] = []
        self.quantities: dict[str, Quantity] = {}
        self.dimensions: dict[str, Dimension] = {}
        self.constants: dict[str, Quantity] = {}
        self.texts: list[tuple[str, Expression, Dimension]] = []

    def fault(self, label: str, found: str, expected: str, remedy: str = "") -> None:
        self.faults.append(Fault(f"{self.where}, {label}" if label else self.where, found, expected, remedy))

    def law(self) -> WrittenLaw | None:
        """The law, or None where there are faults."""
        table = self.table
        symbols = {name: self.symbol(f"symbols.{name}", name, entry) for name, entry in table.symbols.items()}
        parameters = tuple(symbol for symbol in symbols.values() if symbol is not None)
        defaults = tuple((symbol, Parameter(symbol.name, symbol.unit, table.symbols[name].default, symbol.meaning))
                         for name, symbol in symbols.items() if symbol is not None and table.symbols[name].default is not None)  # fmt: skip
        self.constants = {symbol.name: symbol for symbol in parameters if symbol.unit.strip() == "1"}
        for symbol in (*self.kind.supplied, *record.GEOMETRY, *parameters):
            self.declare(symbol)
        definitions, fields, ranges = self.definitions(), self.expressions(), self.ranges()
        if self.faults:
            return None
        plain = {key: getattr(table, key) for key in _PLAIN} | {"title": table.title or table.name}
        forms = {} if table.form is None else {"forms": table.form}
        common = {**plain, **forms, "parameters": parameters, "definitions": definitions, "defaults": defaults}
        try:
            law = self.kind.record(**common, **self.of_kind(fields, ranges))
        except (ValueError, TypeError) as error:  # raised by the record
            self.fault("", str(error), "a law")
        if self.faults:
            return None
        units = {name: quantity.unit for name, quantity in self.quantities.items()}
        meanings = {name: quantity.meaning for name, quantity in self.quantities.items()}
        declared = Declared(self.dimensions, self.constants, self.constants, units, meanings)
        return WrittenLaw(law, tuple(self.texts), declared)

    # -- symbols ------------------------------------------------------------------------------------------------------

    def symbol(self, where: str, written: str, entry: SymbolTable | DefinitionTable) -> Quantity | None:
        """Make a declared symbol; None if its name cannot be used."""
        name = plain_name(written)
        if name in RESERVED:
            self.fault(where, f"the name {name!r}, which expressions use themselves", "another name")
        elif name in self.state:
            self.fault(where, f"a declaration of {name}, which the contact supplies", "another name, or no declaration")
        elif wrong := tuple(name_faults(f"{self.where}, {where}", name)):
            self.faults.extend(wrong)
        else:
            limits = getattr(entry, "limits", None)
            return Quantity(name, entry.unit, entry.meaning, self.interval(f"{where}.limits", limits, entry.unit))
        return None

    def declare(self, symbol: Quantity) -> None:
        """Add a symbol to those that later expressions may contain."""
        self.quantities[symbol.name] = symbol
        try:
            self.dimensions[symbol.name] = dimension_of_unit(symbol.unit, self.constants)
        except UnitError as error:
            self.fault(f"symbol {symbol.name}", f"the unit {symbol.unit!r}", "a unit", str(error))
            self.dimensions[symbol.name] = Dimension()

    def interval(self, where: str, parts: tuple[str, ...] | None, unit: str) -> Interval | None:
        """Interval in SI from brackets and bounds; a bound without a unit is in `unit`."""
        if parts is None:
            return None
        bounds: list[float | None] = []
        for bound in parts[1:3]:
            try:
                bounds.append(None if bound in ("inf", "+inf", "-inf") else _bound(bound, unit))
            except UnitError as error:
                self.fault(where, repr(bound), f"a number, alone or with a unit like {unit}", str(error))
                return None
        lower, upper = bounds
        if lower is not None and upper is not None and lower > upper:
            self.fault(where, f"{parts[0]}{parts[1]}, {parts[2]}{parts[3]}", "a lower bound below the upper one")
        return Interval(lower, upper, parts[0] == "(" and lower is not None, parts[3] == ")" and upper is not None)

    def ranges(self) -> tuple[Range, ...]:
        """Defined and recommended ranges, by symbol."""
        rows = []
        for name, entry in self.table.ranges.items():
            quantity = self.quantities.get(plain_name(name))
            if quantity is None or name in self.state:
                self.fault(f"ranges.{name}", f"the name {name!r}", "a parameter or a quantity of the pair")
                continue
            for kind in ("defined", "recommended"):
                interval = self.interval(f"ranges.{name}.{kind}", getattr(entry, kind), quantity.unit)
                if interval is not None:
                    rows.append(Range(quantity, interval, kind))
        return tuple(rows)

    # -- expressions --------------------------------------------------------------------------------------------------

    def expression(
        self, where: str, expression: Expression, unit: str, forbidden: Collection[str], extra: Iterable[Quantity] = ()
    ) -> sp.Expr | None:
        """SymPy expression of a text, which is kept for the audit."""
        known = self.quantities | {symbol.name: symbol for symbol in extra}
        unknown = undeclared(expression, known)
        for fault in unknown:
            name = fault.where.removeprefix("name ")
            self.fault(where, f"the name {name}", "a symbol of the law, of the contact or of the pair", fault.remedy)
        depends = [name for name in forbidden if name in expression.names]
        for name in depends:
            remedy = "Definitions are computed once per run, not in the contact."
            self.fault(where, name, f"an expression without {name}", remedy)
        try:
            dimension = dimension_of_unit(unit, self.constants)
        except UnitError:
            return None  # a fault of the symbol with this unit
        if unknown or depends:
            return None
        self.texts.append((where, expression, dimension))
        try:
            return to_sympy(expression, known)
        except TextError as error:
            self.fault(f"{where}, character {error.position}", error.found, error.expected, error.remedy)
            return None

    def definitions(self) -> tuple[tuple[Quantity, sp.Expr], ...]:
        """Intermediate results, each usable in those after it."""
        definitions = []
        for row in self.table.definitions:
            where = f"definition of {row.symbol}"
            symbol = self.symbol(where, row.symbol, row)
            if symbol is not None and symbol.name in self.quantities and symbol.name not in _GEOMETRY:
                self.fault(where, f"a second symbol {symbol.name}", "names that are unique")
            state = () if self.table.kind == "film" else self.state
            expression = self.expression(where, row.expression, symbol.unit if symbol else "1", state)
            if symbol is not None:
                self.declare(symbol)
                if expression is not None:
                    definitions.append((symbol, expression))
        return tuple(definitions)

    def expressions(self) -> dict[str, sp.Expr]:
        """Expressions of the kind of law."""
        expressions: dict[str, sp.Expr] = {}
        for key, unit in self.kind.expressions.items():
            written = getattr(self.table, key)
            if written is None:
                continue
            extra = (record.F,) if key == "relation" else ()  # only in the relation
            for symbol in extra:
                self.dimensions.setdefault(symbol.name, dimension_of_unit(symbol.unit, {}))
            state = self.state if key in ("exponent", "reach", "factor", "slope") else ()
            forbidden = [name for name in state if (key, name) != ("slope", "N")]
            expression = self.expression(key, written, unit, forbidden, extra)
            if expression is not None:
                expressions[key] = expression
        return expressions

    def of_kind(self, fields: dict[str, sp.Expr], ranges: tuple[Range, ...]) -> dict[str, Any]:
        """Fields of the record that the kind adds to the common ones."""
        if self.table.kind == "friction" and "slope" not in fields:
            return {**fields, "slope": self.slope(fields["force"]), "ranges": ranges}
        if self.table.kind != "damping":
            return {**fields, "ranges": ranges}
        of_e = {row.kind: row.interval for row in ranges if row.quantity.name == "e"}
        latched = "factor" in fields or fields["term"].has(record.v0)
        return {**fields, **of_e, "ranges": tuple(row for row in ranges if row.quantity.name != "e"),
                "memory": (record.APPROACH_SPEED,) if latched else (), **self.table.model_dump(include={"release"})}  # fmt: skip

    def slope(self, force: sp.Expr) -> sp.Expr:
        """Derivative of a friction force at rest; a fault where SymPy's may be wrong."""
        derivative = sp.diff(force, record.s)
        doubtful = (sp.sign, sp.Abs, sp.DiracDelta, sp.Heaviside, sp.Derivative, sp.Subs, sp.Max, sp.Min)
        slope = derivative.subs(record.s, 0)
        if derivative.has(*doubtful) or slope.has(sp.nan, sp.zoo, sp.oo):
            actual = "none, and a force whose derivative at rest is no plain expression"
            self.fault("slope", actual, "the slope at s = 0 [N s/m]")
        return slope


_GEOMETRY = {symbol.name for symbol in record.GEOMETRY}


def _bound(text: str, unit: str) -> float:
    """Bound in SI; raises UnitError."""
    value, own = parse_quantity(text)
    bare: Callable[[str], Any] = re.compile(r"[-+\d.eE]+").fullmatch
    if bare(text):
        own = parse_unit(unit)
    elif own.exponents != parse_unit(unit).exponents:
        raise UnitError(f"found {text!r}, expected a quantity in {unit}")
    elif own.mistaken_for(parse_unit(unit)):
        raise UnitError(f"found {text!r}, expected a quantity in {unit}; {rate_remedy(own, value)}")
    bound = own.to_si(value)
    return int(bound) if bound.is_integer() and abs(bound) < 1e9 else bound
