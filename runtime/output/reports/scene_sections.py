"""Sections on a scene: what it calls for, its parameters, its equations."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from hertzwerk.derive.common import mathml
from hertzwerk.derive.common.markup import Markup, joined, tag
from hertzwerk.runtime.output.reports.html_page import Cell, Section, bullets, guarded, paragraphs, table, unit_markup
from hertzwerk.runtime.output.reports.inline_svg import picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.derive.exchange.readable_equations.readable_record import Equation, Readable
    from hertzwerk.runtime.engine.model.model import EngineModel


def readable_of(model: EngineModel) -> tuple[Readable | None, str]:
    """Return the equations of a model for people; else None, and why there are none."""
    if model.declaration is None:
        return None, f"A saved run does not contain its scene; load({model.name!r}).equations() shows them."
    try:
        return model.equations(), ""
    except Exception as error:  # the rest of the page does not depend on them
        return None, f"The equations could not be derived: {type(error).__name__}: {error}"


def drawn(draw: Callable[[], Figure], name: str, label: str) -> Markup:
    """Return a figure, or the reason why it could not be drawn."""
    from hertzwerk.runtime.output.plots.save_figure import svg_of

    return guarded(f"The picture {name}", lambda: picture(svg_of(draw()), f"picture-{name}", label, label))


def effects(model: EngineModel, readable: Readable | None) -> Section:
    """Effects of a scene with their laws; sources where the equations are at hand."""
    refused = dict(model.module.UNCHECKED)
    sources = {} if readable is None else {effect.name: effect.source for effect in readable.effects}
    rows: list[list[Cell]] = [
        [name, kind, text, *([sources.get(name, "")] if sources else []), *([refused.get(name, "")] if refused else [])]
        for name, kind, text in model.module.EFFECTS
    ]
    columns = [
        "effect",
        "kind",
        "what it is",
        *(["source"] if sources else []),
        *(["unchecked because"] if refused else []),
    ]
    return Section("Effects", table(columns, rows))


def parameters(model: EngineModel, values: Mapping[str, tuple[float, str]], readable: Readable | None) -> Section:
    """Values of all parameters; those that are not the model's own stand out, with its value beside."""
    own = {name: (port.default, port.unit) for name, port in model.parameters.items()}
    symbols = {} if readable is None else {symbol.name: _symbol(symbol.latex) for symbol in readable.parameters}
    changed = [i for i, (name, value) in enumerate(values.items()) if value != own.get(name)]
    rows: list[list[Cell]] = []
    for i, (name, (value, unit)) in enumerate(values.items()):
        before = own.get(name)
        before_text = (
            "" if i not in changed or before is None else joined([f"{before[0]:.6g} ", unit_markup(before[1])])
        )
        meaning = model.parameters[name].meaning if name in model.parameters else ""
        rows.append([name, float(value), unit_markup(unit), *([before_text] if changed else []), meaning])
        rows[-1][1:1] = [symbols.get(name, "")] if symbols else []
    columns = ["parameter", *(["symbol"] if symbols else []), "value", "unit"]
    columns += [*(["the model's own"] if changed else []), "meaning"]
    count = f"{len(changed)} of {len(values)} differ from the model's own." if changed else "All are the model's own."
    shown = table(columns, rows, marked=changed, digits=9)
    return Section("Parameters", joined([paragraphs([count]), shown]))


def equations(readable: Readable | None, why: str) -> Section:
    """Equations of motion, contact by contact; without them the reason."""
    if readable is None:
        return Section("Equations", paragraphs([why], "note"))
    states = table(
        ("symbol", "name", "unit", "meaning"),
        [[_symbol(s.latex), s.name, unit_markup(s.unit), s.meaning] for s in readable.states],
    )
    parts: list[Markup] = [tag("h3", "Coordinates, speeds, memory"), states]
    for section in readable.sections:
        parts += [tag("h3", section.title), _note(section.note), *map(_equation, section.equations)]
    return Section("Equations", joined(parts))


def _note(text: str) -> Markup:
    """Return the note of a section, a sentence or a list in Markdown."""
    lines = [line.removeprefix("- ").replace("`", "") for line in text.splitlines() if line]
    return bullets(lines) if text.startswith("- ") else paragraphs(lines, "note")


def _symbol(latex: str) -> Markup:
    return guarded("The symbol", lambda: mathml.inline(latex))


def _equation(equation: Equation) -> Markup:
    unit = unit_markup(equation.unit)
    meaning = joined([equation.meaning or equation.name, *([" [", unit, "]"] if unit else [])])
    return tag(
        "div",
        tag("span", f"({equation.number})", class_="number"),
        tag("div", *_lines(equation)),
        tag("span", meaning, class_="meaning"),
        class_="equation",
    )


def _lines(equation: Equation) -> Iterator[Markup]:
    """Yield the lines of an equation; its text where the reader of LaTeX does not know something."""
    try:
        lines = mathml.lines_of(equation.latex)
    except ValueError:
        yield tag("pre", equation.text)
        return
    for line, remark in lines:
        yield tag("div", tag("span", line), tag("span", remark, class_="remark"), class_="line")
