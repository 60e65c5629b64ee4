"""Substitute trivial intermediate results, and keep those that readers look for or that are long."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from hertzwerk.derive.exchange.readable_equations.drafts import KINEMATICS, Draft
from hertzwerk.derive.exchange.readable_equations.symbols import Names
from hertzwerk.derive.exchange.readable_equations.trigonometry import contract_products
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.program.program import Tape, symbols_in

SMALL = 4  # most symbols of an intermediate result that is substituted wherever it is used
SINGLE = 12  # and of one that is used once
FLAT = 24  # and of an expression in landmarks and inputs alone
WIDEST = 60  # most symbols of a sum whose sines and cosines are contract_products


class Substitution:
    """Intermediate results as functions of inputs and of the results that keep their names.

    `landmarks` are the results that keep their names because readers look for them: quantities defined by the drafts,
    quantities of contacts and laws, angles of sines and cosines. `marks` are numbers that are not shown.
    """

    def __init__(self, tape: Tape, names: Names, pairs: Iterable[str], marks: Iterable[sp.Symbol]) -> None:
        self._tape, self._names, self._pairs = tape, names, tuple(pairs)
        self._marks = frozenset(marks)
        self.of: dict[sp.Symbol, Any] = {}
        self.units: dict[sp.Symbol, str] = {}
        self._inlined: dict[sp.Symbol, Any] = {}
        self._landmarks: set[sp.Symbol] = set()
        self._known: dict[Any, Any] = {}  # form -> landmark

    def size(self, expression: Any) -> int:
        """Count the symbols a reader sees."""
        if expression.is_Symbol:
            return int(expression not in self._marks)
        if isinstance(expression, sp.sin | sp.cos) and (
            expression.args[0].is_Symbol or (-expression.args[0]).is_Symbol
        ):
            return 1
        return sum(map(self.size, expression.args))

    def complete(self, roots: list[Draft], added: dict[sp.Symbol, Any]) -> list[Draft]:
        """Write out the roots and define all they name, in the order of the derivation."""
        self._work_out(roots, added)
        for draft in roots:
            if draft.symbol is not None:
                draft.expression = self.of[draft.symbol]
            elif draft.expression is not None:
                draft.expression = self._whole(draft.expression)
            for part in draft.parts:
                terms = sp.Add.make_args(self._final(part.expression))
                part.expression = sp.Add(*map(self._final, terms))
        drafts = self._with_definitions(roots)
        place = {symbol: i for i, symbol in enumerate(self.of)}
        at = {id(draft): i for i, draft in enumerate(drafts)}
        return sorted(drafts, key=lambda d: (d.symbol is None, place.get(d.symbol, 0), at[id(d)]))

    # -- writing out -----------------------------------------------------------------------------------------------

    def _work_out(self, roots: list[Draft], added: dict[sp.Symbol, Any]) -> None:
        assignments = self._tape.assignments
        wanted = [*(e for draft in roots for e in draft.expressions()), *added.values()]
        order = self._needed(wanted)
        uses: dict[sp.Symbol, int] = {}
        for expression in (*(assignments[s] for s in order), *wanted):
            for symbol in symbols_in(expression):
                uses[symbol] = uses.get(symbol, 0) + 1
        requested = {draft.symbol for draft in roots if draft.symbol is not None}
        angles = {f.args[0] for s in order for f in assignments[s].atoms(sp.sin, sp.cos) if f.args[0].is_Symbol}
        self.units |= dict.fromkeys(angles, "rad")
        self._landmarks = requested | angles | {symbol for symbol in order if self._names.is_landmark(symbol)}
        penetrations = self._penetrations(order)
        for symbol in order:
            form = self._flat(self._contracted(assignments[symbol].xreplace(self._inlined)))
            self.of[symbol] = form
            if form.has(Where):
                self._landmarks.add(symbol)  # branches are long: written once, and not within each other
            size, keep = self.size(form), symbol in self._landmarks
            if form in self._known or (form in self._landmarks and symbol not in requested):
                self._inlined[symbol] = self._known.get(form, form)  # equal to a named result
            elif not keep and (size <= SMALL or (size <= SINGLE and uses.get(symbol, 0) == 1)):
                self._inlined[symbol] = form
            elif keep and not form.is_Atom:
                self._known[form] = symbol
                if form.is_Add:
                    self._known[-form] = -symbol
            if symbol in penetrations:
                depth = penetrations[symbol]
                self.of[depth], self.units[depth] = -symbol, "m"
                self._inlined[symbol] = -depth  # from here on
                self._landmarks.add(depth)
        self.of |= {symbol: self._final(form) for symbol, form in added.items()}
        self._landmarks |= set(added)

    def _needed(self, expressions: Iterable[Any]) -> list[sp.Symbol]:
        """Assignments that expressions depend on, in the order of the tape."""
        assignments, needed = self._tape.assignments, set()
        pending = [symbol for expression in expressions for symbol in symbols_in(expression)]
        while pending:
            symbol = pending.pop()
            if symbol in assignments and symbol not in needed:
                needed.add(symbol)
                pending.extend(symbols_in(assignments[symbol]))
        return [symbol for symbol in assignments if symbol in needed]

    def _penetrations(self, order: list[sp.Symbol]) -> dict[sp.Symbol, sp.Symbol]:
        """Gap -> penetration, for pairs whose penetration is minus the gap and has no name in the program."""
        named = {symbol.name: symbol for symbol in order}
        return {
            named[f"{pair}_gap"]: sp.Symbol(f"{pair}_penetration", real=True)
            for pair in self._pairs
            if f"{pair}_gap" in named and f"{pair}_penetration" not in named
        }

    def _flat(self, expression: Any) -> Any:
        """The expression as a function of landmarks and inputs alone, if it stays small."""
        flat = expression
        while named := [s for s in symbols_in(flat) if s in self.of and s not in self._landmarks]:
            flat = self._contracted(flat.xreplace({s: self._inlined.get(s, self.of[s]) for s in named}))
            if self.size(flat) > WIDEST:
                return expression
        return flat if self.size(flat) <= max(FLAT, self.size(expression)) else expression

    def _final(self, expression: Any) -> Any:
        """An expression as a function of the results that keep their names."""
        return self._flat(self._contracted(sp.sympify(expression).xreplace(self._inlined)))

    def _whole(self, expression: Any) -> Any:
        """As `_final`, but an expression that is a single intermediate result is always written out."""
        if expression in self.of and expression not in self._landmarks:
            return self._flat(self._inlined.get(expression, self.of[expression]))
        return self._final(expression)

    def _contracted(self, expression: Any) -> Any:
        if self.size(expression) <= WIDEST:
            expression = self._of_unit_length(contract_products(expression, self._angle))
        return expression.xreplace(self._known)

    def _angle(self, total: Any) -> Any:
        """A sum of angles by the fewest symbols."""
        written = total
        while any(symbol in self.of for symbol in symbols_in(written)):
            written = sp.expand(written.xreplace(self.of))
        return min((total, written), key=self.size)

    def _of_unit_length(self, expression: Any) -> Any:
        """Simplify with n_x^2 + n_y^2 + n_z^2 = 1 of a normal n, where that is shorter."""
        for pair in self._pairs:
            names = {f"{pair}_normal_{axis}" for axis in "xyz"}
            normal = [symbol for symbol in self.of if symbol.name in names]
            if not normal or normal[0] not in symbols_in(expression):
                continue
            first, *others = (component**2 for component in normal)
            one = sp.expand(sp.expand(expression).xreplace({first: 1 - sp.Add(*others)}))
            factors = sp.Mul.make_args(sp.factor_terms(one, sign=False))
            shorter = sp.Mul(*(sp.collect(factor, normal) if factor.is_Add else factor for factor in factors))
            if self.size(shorter) < self.size(expression):
                expression = shorter
        return expression

    # -- definitions -----------------------------------------------------------------------------------------------

    def _with_definitions(self, roots: list[Draft]) -> list[Draft]:
        """The roots, and definitions of all intermediate results they use, each in a section.

        A result is defined with its pair, in the section of its only user, or in the kinematics.
        """
        drafts = list(roots)
        defined = {draft.symbol for draft in roots}
        for symbol in reversed(list(self.of)):
            users = [draft for draft in drafts if symbol in draft.symbols()]
            if symbol in defined or not users:
                continue
            own = self._names.title_of(symbol)
            sections = {draft.section for draft in users}
            shared = len(sections) > 1 or self.units.get(symbol) == "rad"
            section = own or (KINEMATICS if shared else users[0].section)
            unit, meaning = self.units.get(symbol, ""), self._names.meaning(symbol)
            drafts.append(Draft(section, symbol.name, unit, meaning, self.of[symbol], symbol))
        return drafts
