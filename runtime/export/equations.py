"""Equations of a scene as texts: LaTeX, a page of MathML, and a file of Python for SymPy."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hertzwerk.runtime.export.export_request import Asked


def latex(asked: Asked, _: Path) -> str:
    """Return the equations as a LaTeX document; raises InputError."""
    return asked.model.equations().latex()


def mathml(asked: Asked, _: Path) -> str:
    """Return the equations as an HTML page of MathML that fetches nothing; raises InputError."""
    from hertzwerk.derive.html.markup import Markup
    from hertzwerk.runtime.host.versions import versions
    from hertzwerk.runtime.report import html_page, scene_sections

    model, readable = asked.model, asked.model.equations()
    own = dict(asked.model.bind(asked.parameters).values)
    sections = [
        scene_sections.parameters(model, own, readable),
        scene_sections.effects(model, readable),
        scene_sections.equations(readable, ""),
    ]
    origin = html_page.Origin(f"hertzwerk export {model.name} --mathml", versions())
    return html_page.page("equations", model.name, model.module.SUMMARY, Markup(""), sections, origin)


def sympy(asked: Asked, _: Path) -> str:
    """Return a file of Python that makes the equations with SymPy; raises InputError."""
    return asked.model.sympy_file(asked.model.bind(asked.parameters).values)
