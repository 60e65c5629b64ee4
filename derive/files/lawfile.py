"""Own laws from a TOML file: the records of `laws.law`, their expressions read as text and never executed.

    [[law]]
    name = "my_foam"
    kind = "stiffness"                # stiffness: force, stored?, reach?, exponent?, relation?     damping: factor or term, exponent?, release?
    title = "Foam pad"                # friction: force, slope? (else its derivative at rest)     film: along, across, couple
    source = "measured, 2024"
    form = "any"                      # of contact it is for: point, line, surface, any, or a list; a stiffness law must say
    force = "K*d**n*exp(d/h)"
    exponent = "n"
    reach = "h"
    symbols.K = { unit = "N/m^n", meaning = "stiffness", limits = "(0, inf)" }
    symbols.n = { unit = "1", meaning = "exponent", limits = "[1, 3]" }
    symbols.h = { unit = "mm", meaning = "thickness", default = 20 }
    definitions = [{ symbol = "E_eff", unit = "Pa", meaning = "...", expression = "..." }]    # intermediate results, in order
    ranges.dR = { defined = "[5e-6, 1 mm]", recommended = "..." }                             # a bare bound is in the symbol's own unit

The parameters are the symbols, in the order written. What a contact supplies (d in a stiffness law; d, v, v0, F, k_t in a damping law; N, s in a
friction law; epsilon_w, epsilon_c in a film law) and the geometry of its pair (R_eff, dR, L, m_eff, ...) need no declaration. All faults of a file
come at once. A law whose units hold is tried over its ranges too (`behaviour`): a force that falls, a `stored` that is not its integral are faults.
"""

from __future__ import annotations

import difflib
import re
import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import sympy as sp

from hertzwerk.derive.audit.audit import Finding
from hertzwerk.derive.audit.behaviour import faults_if_consistent
from hertzwerk.derive.dimension.declared import Declared, dimension_of_unit
from hertzwerk.derive.dimension.dimension import Dimension
from hertzwerk.derive.dimension.expression import Expression, TextError, to_sympy
from hertzwerk.derive.dimension.reader import RESERVED, plain_name, read
from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.derive.files.audit_text import finding, undeclared, with_culprit
from hertzwerk.derive.files.execute import beside
from hertzwerk.derive.files.tomlfile import read_toml
from hertzwerk.derive.identifiers import name_faults
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws import law as record
from hertzwerk.derive.laws.law import DampingLaw, FilmLaw, FrictionLaw, Law, Quantity, Range, StiffnessLaw
from hertzwerk.derive.mechanism.parameter import Interval, Parameter
from hertzwerk.derive.units import UnitError, parse_quantity, parse_unit, rate_remedy

__all__ = ["WrittenLaw", "audit_laws_as_written", "laws_from", "read_laws"]

# kind -> expression field -> (what it is, its unit); the first is required (a damping law: factor or term; a film: all)
_FIELDS: dict[str, dict[str, tuple[str, str]]] = {
    "stiffness": {"force": ("normal force", "N"), "relation": ("penetration", "m"), "stored": ("stored energy", "J"),
                  "reach": ("reach", "m"), "exponent": ("exponent", "1")},
    "damping": {"factor": ("hysteresis factor", "1"), "term": ("damping force", "N"), "exponent": ("exponent", "1")},
    "friction": {"force": ("friction force", "N"), "slope": ("slope of the friction force at rest", "N s/m")},
    "film": {"along": ("drag along the squeeze velocity", "N s/m"), "across": ("drag across the squeeze velocity", "N s/m"),
             "couple": ("drag against the spin", "N m s")},
}  # fmt: skip
_SUPPLIED = {
    "stiffness": (record.d,),
    "damping": (record.d, record.v, record.v0, record.F, record.k_t),
    "friction": (record.N, record.s),
    "film": (record.eps_w, record.eps_c),
}
_RECORDS: dict[str, type[Any]] = {
    "stiffness": StiffnessLaw,
    "damping": DampingLaw,
    "friction": FrictionLaw,
    "film": FilmLaw,
}
_PLAIN = {"name", "kind", "title", "source", "grade", "verdict", "fitted_in", "repair", "note"}
_KEYS = _PLAIN | {"form", "symbols", "definitions", "ranges"}
_VERDICTS = ("consistent", "inconsistent", "outside_si")
_NOT_IN_LAWS = ("diff", "integrate", "matrix", "@", "transpose", "inv", "det", "trace", "and", "or", "not", "==", "!=")


@dataclass(frozen=True)
class WrittenLaw:
    """A law and its expressions as written, for the audit: (what it is, text, unit it must have)."""

    law: Law
    texts: tuple[tuple[str, Expression, Dimension], ...]
    declared: Declared


def laws_from(path: str | Path) -> dict[str, Law]:
    """The laws of a TOML file by name, used in a scene like the built-in ones; a scene file names it from its own folder.

    Raises InputError with every fault of the file.
    """
    return {written.law.name: written.law for written in read_laws(beside(path))}


def read_laws(path: str | Path) -> tuple[WrittenLaw, ...]:
    """The laws of a TOML file with their texts. Raises InputError with every fault of the file."""
    content = read_toml(path, "tables [[law]]")
    tables = content.get("law")
    faults = [Fault(str(path), f"the key {key!r}", "tables [[law]] alone") for key in content if key != "law"]
    if not isinstance(tables, list) or not tables or not all(isinstance(table, dict) for table in tables):
        raise InputError(str(path), [*faults, Fault(str(path), "no laws", "tables [[law]], one per law")])
    written: list[WrittenLaw] = []
    names: list[str] = []
    for number, table in enumerate(tables, start=1):
        reader = _Reader(table, f"law {number}")
        law = reader.law()
        faults.extend(reader.faults)
        if reader.name in names:
            faults.append(Fault(reader.where, f"a second law {reader.name}", "names that are unique"))
        names.append(reader.name)
        if law is not None:
            written.append(law)
            faults.extend(faults_if_consistent(law.law))
    if faults:
        raise InputError(str(path), faults)
    return tuple(written)


def audit_laws_as_written(path: str | Path) -> tuple[Finding, ...]:
    """One finding per definition and expression of every law of a TOML file, quoting its text. Raises InputError."""
    findings: list[Finding] = []
    for written in read_laws(path):
        law = written.law
        own = []
        for what, expression, unit in written.texts:
            place = {
                "effect": law.name,
                "what": what,
                "law": law.name,
                "kind": law.kind,
                "title": law.title,
                "source": law.source,
            }
            found = finding(expression, written.declared, unit, **place)
            outside = law.fitted_in and found.verdict == "inconsistent"
            own.append(replace(found, verdict="outside_si") if outside else found)
        if law.verdict == "consistent":
            names = dict.fromkeys(
                symbol.name for symbol in (*law.parameters, *(symbol for symbol, _ in law.definitions))
            )
            own = with_culprit(own, written.texts, written.declared, names)
        findings.extend(own)
    return tuple(findings)


class _Reader:
    """One [[law]] table: collects every fault, then makes the record if there is none."""

    def __init__(self, table: Mapping[str, Any], where: str) -> None:
        self.table = table
        self.faults: list[Fault] = []
        name = table.get("name")
        self.name = name if isinstance(name, str) else ""
        self.where = f"law {self.name}" if self.name else where
        self.quantities: dict[str, Quantity] = {}
        self.dimensions: dict[str, Dimension] = {}
        self.texts: list[tuple[str, Expression, Dimension]] = []

    def fault(self, what: str, found: str, expected: str, remedy: str = "") -> None:
        self.faults.append(Fault(f"{self.where}, {what}" if what else self.where, found, expected, remedy))

    def law(self) -> WrittenLaw | None:
        """The law, or None where there are faults."""
        kind = self.table.get("kind")
        if not isinstance(kind, str) or kind not in _FIELDS:
            self.fault("kind", "none" if kind is None else repr(kind), f"one of {', '.join(_FIELDS)}")
            return None
        self.kind = kind
        self.keys()
        plain, forms = self.plain(), self.forms()
        self.supplied = {symbol.name: symbol for symbol in (*_SUPPLIED[kind], *record.GEOMETRY)}
        parameters, defaults = self.symbols()
        constants = {symbol.name: symbol for symbol in parameters if symbol.unit.strip() == "1"}
        self.constants = constants
        for symbol in (*self.supplied.values(), *parameters):
            self.declare(symbol)
        definitions = self.definitions()
        fields = self.expressions()
        ranges = self.ranges()
        if self.faults:
            return None
        common = {**plain, **forms, "parameters": parameters, "definitions": definitions, "defaults": defaults}
        try:
            law = _RECORDS[kind](**common, **self.of_kind(fields, ranges))
        except (ValueError, TypeError) as error:  # what the record itself refuses
            self.fault("", str(error), "a law")
        if self.faults:
            return None
        units = {name: quantity.unit for name, quantity in self.quantities.items()}
        meanings = {name: quantity.meaning for name, quantity in self.quantities.items()}
        return WrittenLaw(law, tuple(self.texts), Declared(self.dimensions, constants, constants, units, meanings))

    # -- plain keys ---------------------------------------------------------------------------------------------------

    def keys(self) -> None:
        known = _KEYS | set(_FIELDS[self.kind]) | ({"release"} if self.kind == "damping" else set())
        for key in self.table:
            if key not in known:
                close = difflib.get_close_matches(key, sorted(known), n=1)
                elsewhere = [kind for kind, fields in _FIELDS.items() if key in fields]
                remedy = (
                    f"it belongs to a {elsewhere[0]} law" if elsewhere else f"did you mean {close[0]}?" if close else ""
                )
                self.fault("", f"the key {key!r}", f"one of {', '.join(sorted(known))}", remedy)

    def plain(self) -> dict[str, str]:
        """Name, title, source, grade and what the record states of its units."""
        texts = {key: self.table[key] for key in _PLAIN - {"kind"} if key in self.table}
        for key, text in texts.items():
            if not isinstance(text, str) or len(text) > 2000 or not text.isprintable():
                self.fault(key, repr(text)[:60], "printable text")
        if not self.name.isascii() or any(name_faults("", self.name)):
            self.fault("name", f"{self.table.get('name')!r:.80}", "a name of letters, digits and _, a letter first")
        elif self.name in LAWS:
            self.fault("name", f"{self.name!r}, the name of a built-in law", "a name of its own")
        for key, default in (("title", self.name), ("grade", "C"), ("verdict", "consistent")):
            texts.setdefault(key, default)
        if not str(texts.get("source", "")).strip():
            self.fault("source", "none", "where the law comes from")
        for key, offered in (("grade", tuple(record.GRADES)), ("verdict", _VERDICTS)):
            if texts[key] not in offered:
                self.fault(key, repr(texts[key])[:60], f"one of {', '.join(offered)}")
        if (texts["verdict"] == "outside_si") != bool(texts.get("fitted_in")):
            self.fault(
                "fitted_in", repr(texts.get("fitted_in", "")), "the units of the fit, with verdict outside_si alone"
            )
        return texts

    def forms(self) -> dict[str, tuple[str, ...]]:
        """The forms of contact the law is for, where it says them; a stiffness law must."""
        if "form" not in self.table and self.kind != "stiffness":
            return {}
        given = self.table.get("form")
        words = given if isinstance(given, list) else [given]
        if words == ["any"]:
            return {"forms": record.FORMS}
        if not words or not all(word in record.FORMS for word in words):
            found = "none" if given is None else repr(given)[:60]
            remedy = (
                "The form of contact it is for; any says that it is for all, as a power law whose stiffness is given."
            )
            self.fault("form", found, f"one of {', '.join(record.FORMS)}, any, or a list of them", remedy)
        return {"forms": tuple(words)}

    # -- symbols ------------------------------------------------------------------------------------------------------

    def symbols(self) -> tuple[tuple[Quantity, ...], tuple[tuple[Quantity, Parameter], ...]]:
        """The parameters in order, and those that have a value of the law's own."""
        table = self.table.get("symbols", {})
        if not isinstance(table, dict):
            self.fault("symbols", repr(table)[:60], "a table of symbols, each with unit and meaning")
            return (), ()
        parameters, defaults = [], []
        for name, entry in table.items():
            symbol = self.symbol(f"symbols.{name}", plain_name(name), entry, ("limits", "default"))
            if symbol is None:
                continue
            parameters.append(symbol)
            default = entry.get("default")
            if (
                isinstance(default, (int, float))
                and not isinstance(default, bool)
                and abs(default) <= sys.float_info.max
            ):
                default = default if abs(default) < 2**53 else float(default)
                defaults.append((symbol, Parameter(symbol.name, symbol.unit, default, symbol.meaning)))
            elif default is not None:
                self.fault(
                    f"symbols.{name}", f"the default {shown(default)}", "a finite number, in the unit of the symbol"
                )
        return tuple(parameters), tuple(defaults)

    def symbol(self, where: str, name: str, entry: Any, more: tuple[str, ...]) -> Quantity | None:
        """A declared symbol, its faults told; None if its name cannot be used."""
        if not isinstance(entry, dict):
            self.fault(where, repr(entry)[:60], 'a table such as { unit = "N/m^n", meaning = "stiffness" }')
            return None
        for key in entry:
            if key not in ("unit", "meaning", *more):
                self.fault(where, f"the key {key!r}", f"one of {', '.join(('unit', 'meaning', *more))}")
        unit, meaning = entry.get("unit"), entry.get("meaning", "")
        if not isinstance(meaning, str) or not meaning.isprintable():
            self.fault(where, f"the meaning {meaning!r}"[:60], "printable text")
            meaning = ""
        if not isinstance(unit, str) or not self.readable(where, unit):
            if not isinstance(unit, str):
                self.fault(where, f"the unit {unit!r}"[:60], "unit text such as 'N/m^1.5', '1' for a number")
            unit = "1"  # a stand-in: the law is refused, and its other faults are told without those that follow from this one
        limit = self.interval(f"{where}.limits", entry.get("limits"), unit)
        if name in RESERVED:
            self.fault(where, f"the name {name!r}, which expressions use themselves", "another name")
        elif name in {symbol.name for symbol in _SUPPLIED[self.kind]}:
            self.fault(where, f"a declaration of {name}, which the contact supplies", "another name, or no declaration")
        elif wrong := tuple(name_faults(f"{self.where}, {where}", name)):
            self.faults.extend(wrong)
        else:
            return Quantity(name, unit, meaning, limit)
        return None

    def readable(self, where: str, unit: str) -> bool:
        try:
            parse_unit(unit)
        except UnitError as error:
            self.fault(where, f"the unit {unit!r}", "a unit", str(error))
            return False
        return True

    def declare(self, symbol: Quantity) -> None:
        """Make a symbol known to the expressions that follow."""
        self.quantities[symbol.name] = symbol
        try:
            self.dimensions[symbol.name] = dimension_of_unit(symbol.unit, self.constants)
        except UnitError as error:
            self.fault(f"symbol {symbol.name}", f"the unit {symbol.unit!r}", "a unit", str(error))
            self.dimensions[symbol.name] = Dimension()

    def interval(self, where: str, text: Any, unit: str) -> Interval | None:
        """`(0, 1]`, `[5e-6, 1 mm]` or `(0, inf)` in SI; a bare bound is in `unit`."""
        if text is None:
            return None
        written = re.fullmatch(r"\s*([\[(])([^,]*),([^,]*)([\])])\s*", text) if isinstance(text, str) else None
        if not written:
            self.fault(where, repr(text)[:60], "an interval such as '(0, 1]' or '[0, inf)'")
            return None
        bounds: list[float | None] = []
        for bound in (written[2].strip(), written[3].strip()):
            try:
                bounds.append(None if bound in ("inf", "+inf", "-inf") else _bound(bound, unit))
            except UnitError as error:
                self.fault(where, repr(bound), f"a number, alone or with a unit like {unit}", str(error))
                return None
        lower, upper = bounds
        if lower is not None and upper is not None and lower > upper:
            self.fault(where, repr(text), "a lower bound below the upper one")
        return Interval(lower, upper, written[1] == "(" and lower is not None, written[4] == ")" and upper is not None)

    # -- expressions --------------------------------------------------------------------------------------------------

    def expression(
        self, where: str, text: Any, unit: str, forbidden: Iterable[str] = (), extra: Iterable[Quantity] = ()
    ) -> sp.Expr | None:
        """The SymPy expression of a text, its text kept for the audit."""
        text = repr(text) if isinstance(text, (int, float)) and not isinstance(text, bool) else text
        known = {**self.quantities, **{symbol.name: symbol for symbol in extra}}
        count = len(self.faults)
        try:
            expression = read(text)
        except TextError as error:
            self.fault(f"{where}, character {error.position}", error.found, error.expected, error.remedy)
            return None
        for node in expression.root.walk():
            if node.op in _NOT_IN_LAWS:
                self.fault(
                    where,
                    f"{node.op!r} in {expression.quote(node)[:40]!r}",
                    "operations on scalars, and comparisons < <= > >=",
                )
            if node.op == "LambertW" and len(node.args) == 1:
                self.fault(where, f"{expression.quote(node)[:40]!r}", "the lower branch, LambertW(x, -1)")
        if expression.root.condition:
            self.fault(where, f"the comparison {text!r}", "a quantity")
        for fault in undeclared(expression, known):
            self.fault(
                where,
                f"the name {fault.where.removeprefix('name ')}",
                "a symbol of the law, of the contact or of the pair",
                fault.remedy,
            )
        for name in forbidden:
            if name in expression.names:
                self.fault(
                    where,
                    name,
                    f"an expression without {name}",
                    "Definitions are computed once per run, not in the contact.",
                )
        if len(self.faults) > count:
            return None
        try:
            self.texts.append((where, expression, dimension_of_unit(unit, self.constants)))
        except UnitError:
            return None  # a fault of the symbol that has this unit
        try:
            return to_sympy(expression, known)
        except TextError as error:
            self.fault(f"{where}, character {error.position}", error.found, error.expected, error.remedy)
            return None

    def definitions(self) -> tuple[tuple[Quantity, sp.Expr], ...]:
        """The named intermediate results, each known to those after it."""
        rows = self.table.get("definitions", [])
        if not isinstance(rows, list) or not all(isinstance(row, dict) for row in rows):
            self.fault("definitions", repr(rows)[:60], "a list of tables with symbol, unit, meaning and expression")
            return ()
        found = []
        for row in rows:
            name = row.get("symbol")
            where = f"definition of {name}" if isinstance(name, str) else "definitions"
            entry = {key: value for key, value in row.items() if key not in ("symbol", "expression")}
            symbol = self.symbol(where, plain_name(name) if isinstance(name, str) else "", entry, ())
            if (
                symbol is not None
                and symbol.name in self.quantities
                and symbol.name not in {g.name for g in record.GEOMETRY}
            ):
                self.fault(where, f"a second symbol {symbol.name}", "names that are unique")
            state = [known.name for known in _SUPPLIED[self.kind] if self.kind != "film"]
            expression = self.expression(where, row.get("expression"), symbol.unit if symbol else "1", state)
            if symbol is not None:
                self.declare(symbol)
                if expression is not None:
                    found.append((symbol, expression))
        return tuple(found)

    def expressions(self) -> dict[str, sp.Expr]:
        """The expression fields of the kind."""
        fields = _FIELDS[self.kind]
        alternatives: dict[str, tuple[tuple[str, ...], ...]] = {
            "damping": (("factor", "term"),),
            "film": tuple((key,) for key in fields),
        }
        for required in alternatives.get(self.kind, (("force",),)):
            given = [key for key in required if key in self.table]
            if len(given) != 1:
                self.fault(
                    "",
                    f"{' and '.join(given) or 'no'} {'' if given else ' or '.join(required)}".strip(),
                    "the " + " or the ".join(required),
                )
        found: dict[str, sp.Expr] = {}
        for key, (_, unit) in fields.items():
            if key in self.table:
                state = (
                    [symbol.name for symbol in _SUPPLIED[self.kind]]
                    if key in ("exponent", "reach", "factor", "slope")
                    else []
                )
                state = [name for name in state if not (key == "slope" and name == "N")]
                extra = (record.F,) if key == "relation" else ()
                if key == "relation":
                    self.dimensions.setdefault("F", dimension_of_unit("N", {}))
                expression = self.expression(key, self.table[key], unit, state, extra)
                if expression is not None:
                    found[key] = expression
        return found

    def of_kind(self, fields: dict[str, sp.Expr], ranges: tuple[Range, ...]) -> dict[str, Any]:
        """What the record of the kind has beside the common fields."""
        if self.kind in ("stiffness", "film"):
            return {**fields, "ranges": ranges}
        if self.kind == "friction":
            slope = fields["slope"] if "slope" in fields else self.slope(fields["force"])
            return {**fields, "slope": slope, "ranges": ranges}
        release = self.table.get("release", "force")
        if release not in ("force", "gap"):
            self.fault(
                "release",
                repr(release)[:60],
                "force or gap",
                "force ends the contact where the normal force falls to zero, gap where it opens.",
            )
        of_e = {row.kind: row.interval for row in ranges if row.quantity.name == "e"}
        latched = "factor" in fields or fields["term"].has(record.v0)
        return {**fields, **of_e, "ranges": tuple(row for row in ranges if row.quantity.name != "e"),
                "memory": (record.APPROACH_SPEED,) if latched else (), "release": release}  # fmt: skip

    def slope(self, force: sp.Expr) -> sp.Expr:
        """Derivative of a friction force at rest, where SymPy's is beyond doubt."""
        derivative = sp.diff(force, record.s)
        doubtful = (sp.sign, sp.Abs, sp.DiracDelta, sp.Heaviside, sp.Derivative, sp.Subs, sp.Max, sp.Min)
        slope = derivative.subs(record.s, 0)
        if derivative.has(*doubtful) or slope.has(sp.nan, sp.zoo, sp.oo):
            self.fault(
                "slope",
                "none, and a force whose derivative at rest is no plain expression",
                "the slope at s = 0 [N s/m]",
            )
        return slope

    def ranges(self) -> tuple[Range, ...]:
        """Defined and recommended ranges, by symbol."""
        table = self.table.get("ranges", {})
        if not isinstance(table, dict):
            self.fault("ranges", repr(table)[:60], "a table of symbols")
            return ()
        rows = []
        for name, kinds in table.items():
            quantity = self.quantities.get(plain_name(name))
            state = {symbol.name for symbol in _SUPPLIED[self.kind]}
            if quantity is None or name in state or not isinstance(kinds, dict):
                self.fault(
                    f"ranges.{name}",
                    repr(kinds)[:60],
                    "a parameter or a quantity of the pair, with { defined = ..., recommended = ... }",
                )
                continue
            for kind, text in kinds.items():
                if kind not in ("defined", "recommended"):
                    self.fault(
                        f"ranges.{name}",
                        repr(kind),
                        "defined (outside is an error) or recommended (outside is a warning)",
                    )
                elif (interval := self.interval(f"ranges.{name}.{kind}", text, quantity.unit)) is not None:
                    rows.append(Range(quantity, interval, kind))
        return tuple(rows)


def _bound(text: str, unit: str) -> float:
    """A bound in SI; raises UnitError."""
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
