"""Record of a scene's equations: symbols, numbered equations, effects; as Markdown, LaTeX and values."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from hertzwerk.derive.common.faults import among, shown, similar


@dataclass(frozen=True)
class Symbol:
    """One symbol; `value` is a parameter's default in its unit, "" for other symbols."""

    name: str
    latex: str
    unit: str
    meaning: str
    value: str = ""


@dataclass(frozen=True)
class Term:
    """One term of an equation of motion, on the `left` or the right of the equals sign.

    `effect` is the effect it comes from, "" for inertia.
    """

    left: bool
    meaning: str
    effect: str
    latex: str
    text: str
    expression: Any


@dataclass(frozen=True)
class Equation:
    """One equation: `name` = `expression`, or an equation of motion, given by its `terms`.

    `expression` is a SymPy expression of the symbols of the record, None for an equation of motion and where the
    equation is shown as an integral.
    """

    number: int
    name: str
    latex: str
    text: str
    unit: str
    meaning: str
    effects: tuple[str, ...]
    expression: Any = None
    terms: tuple[Term, ...] = ()

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle {self.latex}$"

    def markdown(self) -> str:
        """The meaning and unit in one line, then the equation."""
        unit = "" if self.unit in ("", "1") else f" [{self.unit}]"
        return f"({self.number}) {_escaped(self.meaning or self.name)}{unit}\n\n$${self.latex}$$\n"

    def record(self) -> dict[str, Any]:
        """The equation as plain values."""
        return {
            **{name: getattr(self, name) for name in ("number", "name", "latex", "text", "unit", "meaning")},
            "effects": list(self.effects),
            **({"terms": [_plain(term) for term in self.terms]} if self.terms else {}),
        }


@dataclass(frozen=True)
class Section:
    """A group of equations under one title."""

    title: str
    note: str
    equations: tuple[Equation, ...]


@dataclass(frozen=True)
class EffectEntry:
    """One effect of the scene, with its law and source, and the numbers of the equations it enters."""

    name: str
    text: str
    source: str
    enters: tuple[int, ...]


@dataclass(frozen=True)
class Readable:
    """The equations of one scene."""

    name: str
    summary: str
    effects: tuple[EffectEntry, ...]
    states: tuple[Symbol, ...]
    parameters: tuple[Symbol, ...]
    sections: tuple[Section, ...]

    @property
    def equations(self) -> tuple[Equation, ...]:
        """All equations, by number."""
        return tuple(equation for section in self.sections for equation in section.equations)

    def __getitem__(self, key: int | str) -> Equation:
        """An equation by its number or name; raises KeyError, with what there is, for any other."""
        equations = self.equations
        equation = next((each for each in equations if among(key, each.number, each.name)), None)
        if equation is None:
            names = [each.name for each in equations if each.name]
            hint = (similar(key, names) if isinstance(key, str) else "") or f"names are {', '.join(names)}"
            raise KeyError(f"no equation {shown(key)}; numbers are 1 to {len(equations)}, {hint}")
        return equation

    def _repr_markdown_(self) -> str:
        return self.markdown()

    def __str__(self) -> str:
        return self.markdown()

    def markdown(self) -> str:
        """The record as Markdown, with LaTeX between dollar signs."""
        return "\n".join(self._lines())

    def latex(self) -> str:
        """The record as a LaTeX document."""
        return "\n".join(self._latex_lines())

    def _latex_lines(self) -> Iterator[str]:
        yield from (
            r"\documentclass{article}",
            r"\usepackage{amsmath,amssymb,longtable}",
            r"\allowdisplaybreaks",
            r"\begin{document}",
        )
        yield rf"\section*{{{_in_latex(self.name)}}}"
        yield f"{_in_latex(self.summary[:1].upper() + self.summary[1:])}." if self.summary else ""
        for title, symbols in (("Coordinates, speeds, memory", self.states), ("Parameters", self.parameters)):
            yield rf"\subsection*{{{title}}}"
            yield r"\begin{longtable}{llll}"
            yield from (
                f"${s.latex}$ & {s.value} & {_in_latex(s.unit)} & {_in_latex(s.meaning or s.name)} \\\\"
                for s in symbols
            )
            yield r"\end{longtable}"
        for section in self.sections:
            yield rf"\subsection*{{{_in_latex(section.title)}}}"
            for equation in section.equations:
                unit = "" if equation.unit in ("", "1") else f" [{equation.unit}]"
                yield _in_latex(f"{equation.meaning or equation.name}{unit}")
                yield f"\\[\n{equation.latex} \\tag{{{equation.number}}}\n\\]"
        yield r"\end{document}"

    def record(self) -> dict[str, Any]:
        """The record as plain values for JSON."""
        return {
            "name": self.name,
            "summary": self.summary,
            "effects": [{**vars(effect), "enters": list(effect.enters)} for effect in self.effects],
            "states": [_plain(symbol, "value") for symbol in self.states],
            "parameters": [_plain(symbol) for symbol in self.parameters],
            "sections": [
                {"title": s.title, "note": s.note, "equations": [e.record() for e in s.equations]}
                for s in self.sections
            ],
        }

    def _lines(self) -> Iterator[str]:
        yield f"# {self.name}\n"
        yield f"{_escaped(self.summary[:1].upper() + self.summary[1:])}.\n" if self.summary else ""
        yield "## Effects\n"
        yield from _table(
            ("effect", "what it is", "enters equations"),
            [(f"`{e.name}`", _escaped(e.text), _ranges(e.enters)) for e in self.effects],
        )
        yield "## Coordinates, speeds, memory\n"
        states = [(f"${s.latex}$", f"`{s.name}`", s.unit, _escaped(s.meaning)) for s in self.states]
        yield from _table(("symbol", "name", "unit", "meaning"), states)
        yield "## Parameters\n"
        rows = [(f"${s.latex}$", f"`{s.name}`", s.value, s.unit, _escaped(s.meaning)) for s in self.parameters]
        yield from _table(("symbol", "name", "default", "unit", "meaning"), rows)
        for section in self.sections:
            yield f"## {section.title}\n"
            if section.note:
                yield f"{section.note}\n"
            yield from (equation.markdown() for equation in section.equations)


def _ranges(numbers: tuple[int, ...]) -> str:
    """Numbers as text, consecutive ones as ranges: 1, 3-7."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return ", ".join(f"{first}" if first == last else f"{first}-{last}" for first, last in runs)


def _escaped(text: str) -> str:
    """Text escaped for Markdown: no markup, mathematics or HTML; `_` within words is none."""
    text = " ".join(text.split()).replace("&", "&amp;").replace("<", "&lt;")
    return re.sub(r"([\\`$]|(?<=\S)\*(?=\S))", r"\\\1", text)


_SPECIAL = {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}"} | {
    c: f"\\{c}" for c in "&%$#_{}"
}


def _in_latex(text: str) -> str:
    """Text escaped for LaTeX."""
    return "".join(_SPECIAL.get(character, character) for character in text)


def _plain(record: Any, *without: str) -> dict[str, Any]:
    return {name: value for name, value in vars(record).items() if name not in ("expression", *without)}


def _table(columns: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> Iterator[str]:
    yield f"| {' | '.join(columns)} |"
    yield f"|{'---|' * len(columns)}"
    yield from (f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in row)} |" for row in rows)
    yield ""
