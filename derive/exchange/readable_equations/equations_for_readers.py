"""Derive the equations of a scene for readers.

They are the equations of the program from which the generated module is made, before they are solved for the
accelerations. Every effect's parameters carry a mark through the derivation, which shows the effects that an equation
depends on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import sympy as sp

from hertzwerk.derive.audit.audit import audit_laws, audit_program, refuse_inconsistent
from hertzwerk.derive.declare.scene.scene import Scene
from hertzwerk.derive.equations.derivation import derive, program_with_motion
from hertzwerk.derive.equations.module.module_tables import meanings_of
from hertzwerk.derive.exchange.readable_equations.attribution import Attribution, Marked, marked, sources
from hertzwerk.derive.exchange.readable_equations.drafts import (
    ENERGY,
    KINEMATICS,
    LEDGER,
    MOTION,
    OUTPUTS,
    START,
    Draft,
    Drafts,
    Part,
    multiplier,
)
from hertzwerk.derive.exchange.readable_equations.readable_record import (
    EffectEntry,
    Equation,
    Readable,
    Section,
    Symbol,
    Term,
)
from hertzwerk.derive.exchange.readable_equations.substitution import Substitution
from hertzwerk.derive.exchange.readable_equations.symbols import Names, contact_title
from hertzwerk.derive.expressions.algebra.notation import latex_of, text_of, tidy
from hertzwerk.derive.program.program import Program, symbols_in

LINE = 19  # most symbols of a sum on one line
INTEGRAL = 40  # a stored energy of more symbols is shown as an integral
_NOTES = {
    MOTION: "Inertia on the left; its bias is what speeds and drives bring at zero accelerations. Generalised forces on the right, effect by effect.",
    LEDGER: "Quadratures: energy plus what is dissipated minus what is put in stays constant.",
}
_RANKS = {"kg": 1, "kg m^2": 1, "m/s^2": 2, "m": 3, "1/s": 4, "m/s": 5}


def equations_of(scene: Scene) -> Readable:
    """Equations of a scene. Raises InputError for inconsistent units, and for an effect in no equation."""
    refuse_inconsistent(scene, audit_laws(scene))
    marks = marked(scene)
    program = program_with_motion(marks.scene)
    units, findings = audit_program(program)
    if findings:
        derive(scene)  # raises, in terms of the scene without marks
    return _Reader(scene, marks, program, units).readable()


class _Reader:
    """Converts the program of one scene to a record of equations."""

    def __init__(self, scene: Scene, marks: Marked, program: Program, units: dict[sp.Symbol, str]) -> None:
        self.scene, self.marks, self.program, self.tape = scene, marks, program, program.tape
        for begin, *factors in self.tape.pieces.values():  # to readers an input is a symbol, not its pieces
            value = next(symbol for symbol, e in self.tape.assignments.items() if e.has(factors[0]))
            del self.tape.assignments[value], self.tape.inputs[begin]
            self.tape.inputs[value] = "input"
        self.units = units | _port_units(program)
        self.names = Names(program, units, meanings_of(scene))
        self.pairs = tuple(name for name, _ in program.tables["PAIRS"])
        self.forms = Substitution(self.tape, self.names, self.pairs, marks.effect_of)
        self.forms.units |= self.units
        self.open: tuple[sp.Symbol, ...] = ()  # symbols that are neither defined nor input

    def readable(self) -> Readable:
        """Make the record."""
        results = Drafts(self.program, self.names)
        unordered = self.forms.complete(results.all(), results.added)
        self.units |= self.forms.units
        titles = self._titles(unordered)
        drafts = [draft for title in titles for draft in unordered if draft.section == title]
        attribution = Attribution(self.scene, self.marks, self.forms.of)
        for draft in drafts:
            attribution.split_by_effect(draft)
        entered = [attribution.of(draft, drafts) for draft in drafts]
        shown = {s for draft in drafts for s in (*draft.symbols(), draft.symbol)}
        self.open = self._open(drafts)
        known = (*self.tape.inputs, *self.forms.of, *self.open)
        self.names.assign(s for s in known if s in shown or self._is_port(s))
        made = enumerate(zip(drafts, entered, strict=True), start=1)
        equations = [self._equation(number, draft, effects) for number, (draft, effects) in made]
        of_title = zip(drafts, equations, strict=True)
        sections: dict[str, list[Equation]] = {title: [] for title in titles}
        for draft, equation in of_title:
            sections[draft.section].append(equation)
        return Readable(
            self.scene.name,
            self.scene.summary,
            tuple(
                EffectEntry(
                    effect.name, effect.text, source, tuple(e.number for e in equations if effect.name in e.effects)
                )
                for effect, source in sources(self.scene)
            ),
            tuple(self._states(shown)),
            tuple(
                Symbol(p.name, self.names.latex[p], p.unit, self.names.meaning(p), f"{p.default:g}")
                for p in self.scene.parameters.values()
            ),
            tuple(Section(title, self._note(title), tuple(of)) for title, of in sections.items()),
        )

    def _titles(self, drafts: list[Draft]) -> list[str]:
        """Titles in order: kinematics, motion, contacts, others, energy ledger, energy, outputs, start."""
        first = [KINEMATICS, MOTION, *map(contact_title, self.pairs)]
        last = [LEDGER, ENERGY, OUTPUTS, START]
        present = list(dict.fromkeys(draft.section for draft in drafts))
        others = [title for title in present if title not in (*first, *last)]
        return [title for title in (*first, *others, *last) if title in present]

    def _note(self, title: str) -> str:
        return "\n".join(self._laws(title)) or _NOTES.get(title, "")

    def _laws(self, title: str) -> Iterator[str]:
        for effect in self.scene.effects:
            if title == effect.section:
                for bound in effect.laws:
                    yield f"- `{effect.name}`: {bound.law.title}. {bound.law.source}, grade {bound.law.grade}."
                if effect.unchecked:
                    yield f"- `{effect.name}` is UNCHECKED: its units are inconsistent."

    def _open(self, drafts: list[Draft]) -> tuple[sp.Symbol, ...]:
        """Symbols that are neither defined nor input, such as the static friction of a sticking contact."""
        defined = {draft.symbol for draft in drafts} | set(self.tape.inputs)
        return tuple(dict.fromkeys(s for draft in drafts for s in draft.symbols() if s not in defined))

    # -- symbols ---------------------------------------------------------------------------------------------------

    def _is_port(self, symbol: sp.Symbol) -> bool:
        """Whether a symbol is listed even if no equation contains it."""
        return self.tape.inputs.get(symbol) in ("p", "q", "u") and symbol not in self.marks.effect_of

    def _states(self, shown: set[Any]) -> Iterator[Symbol]:
        for group in ("t", "q", "u", "a", "z", "m", "reactions"):
            for symbol, of in self.tape.inputs.items():
                if of == group and (symbol in shown or self._is_port(symbol)):
                    yield Symbol(symbol.name, self.names.latex[symbol], self.units[symbol], self.names.meaning(symbol))

        accelerations = next(function for function in self.program.functions if function.name == "accelerations")
        held = next((r for r in accelerations.results if r.name == "multipliers"), None)
        units = {} if held is None else {multiplier(label): u for label, u in zip(held.labels, held.units, strict=True)}
        for symbol in self.open:
            unit, meaning = units.get(symbol, "N"), self.names.meaning(symbol)
            yield Symbol(symbol.name, self.names.latex[symbol], unit, meaning)

    # -- equations -------------------------------------------------------------------------------------------------

    def _equation(self, number: int, draft: Draft, effects: tuple[str, ...]) -> Equation:
        if draft.parts:
            return self._row(number, draft, effects)
        left = draft.left or self.names.latex[draft.symbol]
        expression, size = self.marks.plain(draft.expression), self.forms.size(draft.expression)
        text, latex = f"{draft.name} = {text_of(expression)}", f"{left} = {self._latex(expression)}"
        if draft.name.endswith("_stored_energy") and size > INTEGRAL:
            text, latex = self._integral(draft, left)
        elif size > LINE and expression.is_Add:
            first, *others = self._lines(expression)
            latex = _aligned([f"{left} &= {first}", *(rf"&\quad {line}" for line in others)])
        return Equation(number, draft.name, latex, text, draft.unit, draft.meaning, effects, expression)

    def _integral(self, draft: Draft, left: str) -> tuple[str, str]:
        """A stored energy as the integral of the force, where the program uses quadrature."""
        symbols = {symbol.name: symbol for symbol in self.forms.of}
        force, depth = (symbols[draft.name.replace("stored_energy", w)] for w in ("elastic_force", "penetration"))
        of, upto = self.names.latex[force], self.names.latex[depth]
        text = f"{draft.name} = integral of {force.name} over {depth.name} from 0"
        return text, rf"{left} = \int_{{0}}^{{{upto}}} {of}\,\mathrm{{d}}{upto}"

    def _lines(self, total: Any) -> Iterator[str]:
        """Break a sum into lines of at most `LINE` symbols."""
        line: Any = None
        shown = False
        for term in sp.Add.make_args(total):
            if line is not None and self.forms.size(line + term) > LINE:
                yield _signed(self._latex(line), first=not shown)
                line, shown = None, True
            line = term if line is None else line + term
        yield _signed(self._latex(line), first=not shown)

    def _row(self, number: int, draft: Draft, effects: tuple[str, ...]) -> Equation:
        terms = [self._term(part) for part in draft.parts]
        lines = []
        for left in (True, False):
            start = "& " if left else "&= "
            for i, term in enumerate(t for t in terms if t.left is left):
                lines.append(f"{start}{_signed(term.latex, first=i == 0)} && \\text{{{_escaped(term.meaning)}}}")
                start = r"&\quad "
        if all(term.left for term in terms):
            lines.append("&= 0")
        sides = (" + ".join(f"({t.text})" for t in terms if t.left is left) or "0" for left in (True, False))
        text, latex = " = ".join(sides), _aligned(lines)
        return Equation(number, draft.name, latex, text, draft.unit, draft.meaning, effects, None, tuple(terms))

    def _term(self, part: Part) -> Term:
        """A term; for inertia the coefficient comes before the acceleration."""
        expression = self.marks.plain(part.expression)
        latex = self._latex(expression)
        if part.factor is not None:
            coefficient = rf"\left({latex}\right)" if tidy(expression).is_Add else latex
            latex = {"1": "", "-1": "-"}.get(latex, coefficient)
            latex = f"{latex} {self.names.latex[part.factor]}".strip()
            expression = expression * part.factor
        return Term(part.left, part.meaning, part.effect, latex, text_of(expression), expression)

    def _latex(self, plain: Any) -> str:
        """LaTeX, with factors of a product in the usual order: forces, masses, lengths, rates."""
        ranked = {s: sp.Symbol(f"{self._rank(s)} {s.name}", real=True) for s in symbols_in(plain)}
        return latex_of(plain.xreplace(ranked), {ranked[s]: self.names.latex[s] for s in ranked})

    def _rank(self, symbol: sp.Symbol) -> int:
        unit, group = self.units.get(symbol, ""), self.tape.inputs.get(symbol, "")
        if group not in ("", "p"):
            return 9 if group == "t" else 8
        return 0 if unit.startswith(("N", "J", "Pa")) else _RANKS.get(unit, 6)


def _port_units(program: Program) -> dict[sp.Symbol, str]:
    """Units of inputs as their ports state them: an angle in rad, a torque in N m."""
    accelerations = next(function for function in program.functions if function.name == "accelerations")
    results = {result.name: result.units for result in accelerations.results}
    stated: dict[str, Iterable[str]] = {
        "q": [unit for _, unit in program.tables["COORDINATES"]],
        "u": [unit for _, unit in program.tables["SPEEDS"]],
        "a": results["a"],
        "reactions": results.get("reactions", ()),
    }
    table: dict[sp.Symbol, str] = {}
    for group, units in stated.items():
        table |= zip((s for s, of in program.tape.inputs.items() if of == group), units, strict=True)
    return table


def _signed(latex: str, *, first: bool) -> str:
    return latex if first or latex.startswith("-") else f"+ {latex}"


def _aligned(lines: Iterable[str]) -> str:
    body = " \\\\\n".join(lines)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _escaped(text: str) -> str:
    return text.replace("_", r"\_")
