"""Description of a functional mock-up unit: modelDescription.xml of FMI 2.0 and 3.0."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING
from xml.etree import ElementTree

from hertzwerk.derive.units import Unit, parse_unit
from hertzwerk.runtime.host.versions import versions

if TYPE_CHECKING:
    from hertzwerk.runtime.export.exported import Contents, Row

BASES = ("kg", "m", "s", "K", "A")
CATEGORIES = {"logStatusError": "errors", "logEvents": "impacts"}
DISCRETE = ("mode", "slip", "approach_speed", "slip_1", "slip_2")  # last parts of names whose histories jump
Attributes = dict[str, str]


def description(found: Contents, name: str, token: str, fmi: int) -> str:
    """Return the description of a unit whose code is called `name`."""
    root = ElementTree.Element("fmiModelDescription", _head(found, name, token, fmi))
    unit = ElementTree.SubElement(root, "CoSimulation", _abilities(found, name, fmi))
    if fmi == 2:
        files = ElementTree.SubElement(unit, "SourceFiles")
        for file in (f"{name}.c", "fmu.c"):
            ElementTree.SubElement(files, "File", name=file)
    variables = list(_variables(found, fmi))
    units = ElementTree.SubElement(root, "UnitDefinitions")
    for text in dict.fromkeys(row.unit for _, _, row in variables if row.unit != "1"):
        _define(ElementTree.SubElement(units, "Unit", name=text), text, variables)
    categories = ElementTree.SubElement(root, "LogCategories")
    for category, meaning in CATEGORIES.items():
        ElementTree.SubElement(categories, "Category", name=category, description=meaning)
    experiment = {"startTime": "0", "stopTime": repr(found.seconds), "tolerance": repr(found.tolerance)}
    ElementTree.SubElement(root, "DefaultExperiment", experiment)
    listed = ElementTree.SubElement(root, "ModelVariables")
    for reference, (how, start, row) in enumerate(variables):
        about = {"name": row.name, "valueReference": str(reference), "description": row.meaning, **how}
        of_value = {} if row.unit == "1" else {"unit": row.unit}
        of_value |= {} if not row.shown else {"displayUnit": row.shown}
        of_value |= {"start": repr(row.value)} if start else {}
        if fmi == 2:
            ElementTree.SubElement(ElementTree.SubElement(listed, "ScalarVariable", about), "Real", of_value)
        else:
            ElementTree.SubElement(listed, "Float64", {**about, **of_value})
    structure = ElementTree.SubElement(root, "ModelStructure")
    outputs = [i for i, (how, _, _) in enumerate(variables) if how["causality"] == "output"]
    if fmi == 2:
        for part in ("Outputs", "InitialUnknowns"):
            of_part = ElementTree.SubElement(structure, part)
            for i in outputs:
                ElementTree.SubElement(of_part, "Unknown", index=str(i + 1))
    else:
        for part in ("Output", "InitialUnknown"):
            for i in outputs:
                ElementTree.SubElement(structure, part, valueReference=str(i))
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def build_description(name: str) -> str:
    """Return buildDescription.xml of the sources of a unit of FMI 3.0."""
    root = ElementTree.Element("fmiBuildDescription", fmiVersion="3.0")
    built = ElementTree.SubElement(root, "BuildConfiguration", modelIdentifier=name)
    sources = ElementTree.SubElement(built, "SourceFileSet", language="C99", compilerOptions="-ffp-contract=off")
    for file in (f"{name}.c", "fmu.c"):
        ElementTree.SubElement(sources, "SourceFile", name=file)
    ElementTree.SubElement(sources, "PreprocessorDefinition", name="FMI", value="3")
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def _head(found: Contents, name: str, token: str, fmi: int) -> Attributes:
    summary = found.model.module.SUMMARY
    return {
        "fmiVersion": f"{fmi}.0",
        "modelName": found.model.name,
        "guid" if fmi == 2 else "instantiationToken": token,
        "description": summary,
        "generationTool": f"hertzwerk {versions()['hertzwerk']}",
        "variableNamingConvention": "flat",
    }


def _abilities(found: Contents, name: str, fmi: int) -> Attributes:
    derivatives = "true" if found.inputs else "false"
    common = {"modelIdentifier": name, "canHandleVariableCommunicationStepSize": "true"}
    if fmi == 2:
        return {
            **common,
            "canInterpolateInputs": derivatives,
            "canNotUseMemoryManagementFunctions": "true",
            "canGetAndSetFMUstate": "true",
            "canSerializeFMUstate": "true",
            "providesDirectionalDerivative": derivatives,
        }
    return {
        **common,
        "canGetAndSetFMUState": "true",
        "canSerializeFMUState": "true",
        "providesDirectionalDerivatives": derivatives,
    }


def _variables(found: Contents, fmi: int) -> Iterator[tuple[Attributes, bool, Row]]:
    """Yield (attributes, whether it has a start, row) of every variable by its value reference."""
    from hertzwerk.runtime.export.exported import Row

    fixed = {"causality": "parameter", "variability": "fixed", "initial": "exact"}
    given = {"causality": "input", "variability": "continuous", **({"initial": "exact"} if fmi == 3 else {})}
    yield {"causality": "independent", "variability": "continuous"}, False, Row("time", "s", 0.0, "time")
    for row in found.parameters:
        yield fixed, True, row
    for row in found.starts:
        yield fixed, True, row._replace(name=f"start.{row.name}")
    for row in (*found.states, *found.outputs):
        jumps = row.name.rpartition(".")[2] in DISCRETE
        varies = "discrete" if jumps else "continuous"
        yield {"causality": "output", "variability": varies, "initial": "calculated"}, False, row
    for row in found.inputs:
        yield given, True, row
    for row in found.inputs:
        yield (
            given,
            True,
            Row(f"{row.name}.rate", per_second(row.unit), 0.0, f"rate of {row.name}, with which it goes on"),
        )


def per_second(unit: str) -> str:
    """Return the unit of a rate."""
    return f"{unit}/s"


def _define(element: ElementTree.Element, text: str, variables: list[tuple[Attributes, bool, Row]]) -> None:
    """Add the exponents of a unit, where they are whole, and the units that its values were declared in."""
    unit = parse_unit(text)
    whole = _whole(unit)
    if whole is not None:
        ElementTree.SubElement(element, "BaseUnit", whole)
    for shown in dict.fromkeys(row.shown for _, _, row in variables if row.unit == text and row.shown):
        ElementTree.SubElement(element, "DisplayUnit", name=shown, factor=repr(1 / parse_unit(shown).factor))


def _whole(unit: Unit) -> Attributes | None:
    """Return the exponents of a unit as attributes; None where one is no whole number."""
    exponents = [exponent.constant for exponent in unit.exponents]
    if unit.free_names or any(exponent.denominator != 1 for exponent in (*exponents, unit.angle)):
        return None
    found = {base: str(exponent) for base, exponent in zip(BASES, exponents, strict=True) if exponent}
    return {**found, **({"rad": str(unit.angle)} if unit.angle else {})}
