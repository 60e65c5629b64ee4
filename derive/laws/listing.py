"""The catalogue as text: a table for readers (README.md) and a stub for editors (`__init__.pyi`)."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator

from hertzwerk.derive.laws.catalogue import LAWS
from hertzwerk.derive.laws.formulas.stiffness import MATERIALS
from hertzwerk.derive.laws.law import (
    FORMS,
    GRADES,
    YIELD_STRENGTH,
    DampingLaw,
    FrictionLaw,
    Law,
    PlasticLaw,
    Quantity,
    d_m,
)

_HEADINGS = {
    "stiffness": "Stiffness laws: the elastic normal force F(d)",
    "damping": "Damping laws: the dissipative part of the normal force",
    "friction": "Friction laws: the force against sliding",
    "film": "Film laws: the oil between a pin and its bush, or before a sphere",
}
_NOT_CONSISTENT = {
    "inconsistent": "its units are inconsistent",
    "outside_si": "its constants hide units",
}


def markdown() -> str:
    """The catalogue as Markdown, one table per kind of law."""
    return "\n".join(_markdown()) + "\n"


def _markdown() -> Iterator[str]:
    yield from textwrap.dedent("""\
        # Contact laws

        `hertzwerk laws --markdown` writes this page; a test fails where it is out of date. Call a law with its parameters, in order or by name, in
        their units: `laws.flores(e)`, `laws.power(K, n=1.5)`. A `Material` stands for Young's modulus and Poisson's ratio together:
        `laws.hertz_point(steel, steel)`. The pair supplies all other quantities: penetration, speeds, radii, lengths, masses.

        `hertzwerk laws NAME` prints the sheet of a law: formula, units, ranges and cost. `help(laws.NAME)` lists its parameters.
        `hertzwerk study restitution` tests every damping law in one free impact, by simulation and, where there is one, in closed form. Both agree
        to 2e-12. `exact`, `tsuji` (with K d^1.5) and `kelvin_voigt` (with K d) return the stated restitution. `lankarani_nikravesh` is off
        by up to 0.05 in its recommended range and never returns less than 0.663.

        | grade | meaning |
        |---|---|""").splitlines()
    yield from (f"| {grade} | {meaning} |" for grade, meaning in GRADES.items())
    for kind, heading in _HEADINGS.items():
        laws = [law for law in LAWS.values() if law.kind == kind]
        yield from ("", f"## {heading}", "", "| law | title | for | grade | source |", "|---|---|---|---|---|")
        yield from (_row(law) for law in laws)


def _row(law: Law) -> str:
    remarks = [law.title, *filter(None, [_NOT_CONSISTENT.get(law.verdict), law.repair and f"repaired: `{law.repair}`"])]
    called = f"`{law.name}({', '.join(symbol.name for symbol in law.parameters)})`"
    cells = (called, "; ".join(remarks), made_for(law), law.grade, law.source)
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def made_for(law: Law) -> str:
    """Pairs, or form of contact, that a law is made for."""
    forms = "any" if set(law.forms) == set(FORMS) else " or ".join(law.forms)
    return ", ".join(law.pairs) or f"{forms} contact"


def remembered(law: Law) -> Iterator[Quantity]:
    """Yield what a law remembers of its contact, such as v0, the approach speed."""
    if isinstance(law, DampingLaw):
        yield from law.memory
    elif isinstance(law, PlasticLaw):
        yield d_m
    elif isinstance(law, FrictionLaw):
        yield from (symbol for symbol, *_ in law.memory)


def stub() -> str:
    """Text of `__init__.pyi`: a class per kind and list of parameters, and every documented law."""
    kinds = sorted({type(law).__name__ for law in LAWS.values()})
    classes: dict[str, list[str]] = {}
    for law in LAWS.values():
        classes.setdefault(_class_of(law), list(_class(law)))
    variables = [line for name, law in sorted(LAWS.items()) for line in _variable(name, law)]
    head = [
        '"""Contact laws, for type checkers and editors. Written by `hertzwerk laws --stub`; do not edit."""',
        "",
        "from typing import overload",
        "",
        "from hertzwerk.derive.expressions.parameter import Scalar",
        "from hertzwerk.derive.laws.catalogue import LAWS as LAWS",
        f"from hertzwerk.derive.laws.law import BoundLaw, {', '.join(kinds)}",
        "from hertzwerk.derive.laws.material import Material",
        "",
    ]
    return "\n".join([*head, *(line for lines in classes.values() for line in lines), *variables]) + "\n"


def _class_of(law: Law) -> str:
    return "_".join(["", type(law).__name__, *(symbol.name for symbol in law.parameters)])


def _class(law: Law) -> Iterator[str]:
    yield f"class {_class_of(law)}({type(law).__name__}):"
    values = dict(law.defaults)
    taken = [f"{p.name}: Scalar{' = ...' if p in values else ''}" for p in law.parameters]
    of_materials = law.parameters[: len(MATERIALS)] == MATERIALS
    other = [f"{YIELD_STRENGTH}: Scalar = ..." if name == f"{YIELD_STRENGTH}: Scalar" else name for name in taken]
    ways = [["first: Material", "second: Material", "/", *other[len(MATERIALS) :]], taken] if of_materials else [taken]
    for way in ways:
        yield from ["    @overload"] if of_materials else []
        yield f"    def __call__({', '.join(['self', *way])}) -> BoundLaw: ..."
    yield ""


def _variable(name: str, law: Law) -> Iterator[str]:
    lines = [part for line in (law.__doc__ or "").splitlines() for part in textwrap.wrap(line, 140) or [""]]
    yield f"{name}: {_class_of(law)}"
    yield f'"""{lines[0]}'
    yield from lines[1:]
    yield '"""'
