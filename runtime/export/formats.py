"""Formats that `hertzwerk export` writes: a row of a table each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from hertzwerk.derive.common.faults import Fault
    from hertzwerk.runtime.export.export_contents import ExportRequest


def _latex(request: ExportRequest, _: Path) -> str:
    """Return the equations as a LaTeX document; raises InputError."""
    return request.model.equations().latex()


def _mathml(request: ExportRequest, _: Path) -> str:
    """Return the equations as an HTML page of MathML that fetches nothing; raises InputError."""
    from hertzwerk.derive.common.markup import Markup
    from hertzwerk.runtime.output.reports import html_page, scene_sections
    from hertzwerk.runtime.system.versions import versions

    model, readable = request.model, request.model.equations()
    own = dict(request.model.bind(request.parameters).values)
    sections = [
        scene_sections.parameters(model, own, readable),
        scene_sections.effects(model, readable),
        scene_sections.equations(readable, ""),
    ]
    origin = html_page.Origin(f"hertzwerk export {model.name} --mathml", versions())
    return html_page.page("equations", model.name, model.module.SUMMARY, Markup(""), sections, origin)


def _sympy(request: ExportRequest, _: Path) -> str:
    """Return a file of Python that makes the equations with SymPy; raises InputError."""
    return request.model.sympy_file(request.model.bind(request.parameters).values)


@dataclass(frozen=True)
class Format:
    """Format of an export.

    option    of the command line
    place     word for where it is written to: "DIR", "FILE"; empty where it is a text that is printed
    meaning   for --help
    write     writes it, or returns the text; returns what to report. Raises InputError
    faults    of the place and of the request, found before anything is computed
    """

    option: str
    place: str
    meaning: str
    write: Callable[[ExportRequest, Path], str]
    faults: Callable[[Path], list[Fault]] = lambda _: []

    @property
    def name(self) -> str:
        """Name of the option in Python."""
        return self.option.removeprefix("--")


def _c_library(request: ExportRequest, folder: Path) -> str:
    from hertzwerk.runtime.export import c_library

    return c_library.write(request, folder)


def _fmu(request: ExportRequest, file: Path) -> str:
    from hertzwerk.runtime.export import fmu

    return fmu.write(request, file)


def _new_fmu(file: Path) -> list[Fault]:
    from hertzwerk.runtime.export import fmu

    return fmu.faults(file)


def _new_folder(folder: Path) -> list[Fault]:
    from hertzwerk.runtime.system.result_folder import destination_fault

    fault = destination_fault(folder)
    return [] if fault is None else [replace(fault, where="--c", remedy="an export never overwrites: name another")]


FORMATS = (
    Format("--c", "DIR", "C99 library: header, source, CMakeLists.txt and an example.", _c_library, _new_folder),
    Format(
        "--fmu", "FILE", "functional mock-up unit for co-simulation, NAME.fmu: sources and a binary.", _fmu, _new_fmu
    ),
    Format("--latex", "", "Print the equations as a LaTeX document.", _latex),
    Format("--mathml", "", "Print the equations as an HTML page of MathML.", _mathml),
    Format("--sympy", "", "Print the equations as a Python file that builds them with SymPy.", _sympy),
)
