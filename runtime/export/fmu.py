"""Functional mock-up unit of a scene: the C library behind FMI 2.0 or 3.0, and its description."""

from __future__ import annotations

import hashlib
import io
import platform
import sys
import tempfile
import uuid
import zipfile
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.units import Unit, parse_unit
from hertzwerk.runtime.engine.accuracy.error_estimate import LEAST
from hertzwerk.runtime.engine.integration.loop.c_compilation import NoCompilerError, compile_files
from hertzwerk.runtime.export.c_library import level, library, number, template
from hertzwerk.runtime.export.export_contents import Contents, ExportRequest, Row, contents, name_faults
from hertzwerk.runtime.system.atomic_files import scratch_folder, write_atomically
from hertzwerk.runtime.system.result_folder import new_file_faults
from hertzwerk.runtime.system.versions import versions

BASES = ("kg", "m", "s", "K", "A")
CATEGORIES = {"logStatusError": "errors", "logEvents": "impacts"}
DISCRETE = ("mode", "slip", "approach_speed", "slip_1", "slip_2")  # last parts of names whose histories jump
Attributes = dict[str, str]

FLAGS = ("-std=c99", "-ffp-contract=off", "-fvisibility=hidden", "-fPIC")
TIGHTER = 1e-2  # of the tolerance: that of the two runs whose difference is a directional derivative


def description(export: Contents, name: str, token: str, fmi: int) -> str:
    """Return the description of a unit whose code is called `name`."""
    root = ElementTree.Element("fmiModelDescription", _head(export, name, token, fmi))
    unit = ElementTree.SubElement(root, "CoSimulation", _abilities(export, name, fmi))
    if fmi == 2:
        files = ElementTree.SubElement(unit, "SourceFiles")
        for file in (f"{name}.c", "fmu.c"):
            ElementTree.SubElement(files, "File", name=file)
    variables = list(_variables(export, fmi))
    units = ElementTree.SubElement(root, "UnitDefinitions")
    for text in dict.fromkeys(row.unit for _, _, row in variables if row.unit != "1"):
        _define(ElementTree.SubElement(units, "Unit", name=text), text, variables)
    categories = ElementTree.SubElement(root, "LogCategories")
    for category, meaning in CATEGORIES.items():
        ElementTree.SubElement(categories, "Category", name=category, description=meaning)
    experiment = {"startTime": "0", "stopTime": repr(export.seconds), "tolerance": repr(export.tolerance)}
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


def _head(export: Contents, name: str, token: str, fmi: int) -> Attributes:
    summary = export.model.module.SUMMARY
    return {
        "fmiVersion": f"{fmi}.0",
        "modelName": export.model.name,
        "guid" if fmi == 2 else "instantiationToken": token,
        "description": summary,
        "generationTool": f"hertzwerk {versions()['hertzwerk']}",
        "variableNamingConvention": "flat",
    }


def _abilities(export: Contents, name: str, fmi: int) -> Attributes:
    derivatives = "true" if export.inputs else "false"
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


def _variables(export: Contents, fmi: int) -> Iterator[tuple[Attributes, bool, Row]]:
    """Yield (attributes, whether it has a start, row) of every variable by its value reference."""
    from hertzwerk.runtime.export.export_contents import Row

    fixed = {"causality": "parameter", "variability": "fixed", "initial": "exact"}
    attributes = {"causality": "input", "variability": "continuous", **({"initial": "exact"} if fmi == 3 else {})}
    yield {"causality": "independent", "variability": "continuous"}, False, Row("time", "s", 0.0, "time")
    for row in export.parameters:
        yield fixed, True, row
    for row in export.starts:
        yield fixed, True, row._replace(name=f"start.{row.name}")
    for row in (*export.states, *export.outputs):
        jumps = row.name.rpartition(".")[2] in DISCRETE
        varies = "discrete" if jumps else "continuous"
        yield {"causality": "output", "variability": varies, "initial": "calculated"}, False, row
    for row in export.inputs:
        yield attributes, True, row
    for row in export.inputs:
        yield (
            attributes,
            True,
            Row(f"{row.name}.rate", f"{row.unit}/s", 0.0, f"rate of {row.name}, with which it goes on"),
        )


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
    attributes = {base: str(exponent) for base, exponent in zip(BASES, exponents, strict=True) if exponent}
    return {**attributes, **({"rad": str(unit.angle)} if unit.angle else {})}


def faults(file: Path) -> list[Fault]:
    """Return the faults of a file to be written."""
    wrong = new_file_faults("--fmu", file, "a unit is never overwritten: name another")
    if file.suffix != ".fmu":
        wrong.append(Fault("--fmu", str(file), "a file whose name ends in .fmu"))
    return wrong + name_faults("--fmu", file.stem)


def write(request: ExportRequest, file: Path) -> str:
    """Write the unit of a scene into a new file; return what it is. Raises InputError."""
    export = contents(request)
    repeated = sorted({row.name for row in export.parameters} & {row.name for row in (*export.states, *export.outputs)})
    if repeated:
        fault = Fault("names", f"{', '.join(repeated)} twice", "parameters and histories of different names")
        raise InputError("export", [fault])
    parts, binary = unit(export, file.stem, request.fmi)
    write_atomically(file, archive(parts))
    return f"{file} (FMI {request.fmi}.0 for co-simulation, {binary})"


def unit(export: Contents, name: str, fmi: int) -> tuple[dict[str, bytes], str]:
    """Return the files of a unit by their places in it, and what its binary is for."""
    texts = library(export, name)
    token = str(uuid.UUID(hashlib.sha256(texts[f"{name}.c"].encode()).hexdigest()[:32]))
    tight = max(TIGHTER * export.tolerance, LEAST)
    words = {
        **{"n": name, "N": name.upper(), "name": name, "fmi": str(fmi), "token": token},
        **{"duration": number(export.seconds), "derivative_tolerance": number(tight)},
        "derivative_step": number(tight ** (1 / 3)),  # its square and the tolerance over it are alike
    }
    standard = template(f"fmi{fmi}.c", words)
    sources = {
        f"{name}.h": texts[f"{name}.h"],
        f"{name}.c": texts[f"{name}.c"],
        "fmu.c": template("fmu.c", {"standard": standard, **words}),
    }
    parts = {"modelDescription.xml": description(export, name, token, fmi)}
    parts |= {f"sources/{file}": text for file, text in sources.items()}
    if fmi == 3:
        parts["sources/buildDescription.xml"] = build_description(name)
    files = {place: text.encode() for place, text in parts.items()}
    place, ending = _platform(fmi)
    try:
        files[f"binaries/{place}/{name}{ending}"] = _binary(sources, name)
    except NoCompilerError as error:
        return files, f"sources alone: {error}"
    return files, f"sources and a binary for {place}"


def archive(parts: dict[str, bytes]) -> bytes:
    """Return files as a zip archive that depends on nothing else."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as made:
        for place, data in parts.items():
            about = zipfile.ZipInfo(place, (1980, 1, 1, 0, 0, 0))
            about.external_attr, about.compress_type = 0o644 << 16, zipfile.ZIP_DEFLATED
            made.writestr(about, data)
    return content.getvalue()


def _binary(sources: dict[str, str], name: str) -> bytes:
    """Return the shared library of sources; raises NoCompilerError."""
    with scratch_folder(Path(tempfile.gettempdir())) as folder:
        for file, text in sources.items():
            (folder / file).write_text(text, encoding="utf-8")
        levels = dict.fromkeys((folder / f"{name}.c", folder / "fmu.c"), level(sources[f"{name}.c"]))
        return compile_files(FLAGS, levels, folder / f"{name}.so").read_bytes()


def _platform(fmi: int) -> tuple[str, str]:
    """Return the folder and the ending of a binary for this platform."""
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(platform.machine().lower(), platform.machine().lower())
    system, ending = {"win32": ("windows", ".dll"), "darwin": ("darwin", ".dylib")}.get(sys.platform, ("linux", ".so"))
    if fmi == 2:
        short = {"windows": "win", "linux": "linux", "darwin": "darwin"}[system]
        return (f"{short}64" if machine == "x86_64" else f"{machine}-{system}"), ending
    return f"{machine}-{system}", ending
