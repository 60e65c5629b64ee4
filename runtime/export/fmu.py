"""Functional mock-up unit of a scene: the C library behind the functions of FMI 2.0 or 3.0."""

from __future__ import annotations

import hashlib
import io
import platform
import sys
import tempfile
import uuid
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.accuracy.ladder import LEAST
from hertzwerk.runtime.export.c_library import level, library, number, template
from hertzwerk.runtime.export.exported import contents, name_faults
from hertzwerk.runtime.export.model_description import build_description, description
from hertzwerk.runtime.host.folder import new_file_faults
from hertzwerk.runtime.host.scratch import scratch_folder, write_atomically
from hertzwerk.runtime.integrate.loop.compiled import NoCompilerError, compile_files

if TYPE_CHECKING:
    from hertzwerk.runtime.export.export_request import Asked
    from hertzwerk.runtime.export.exported import Contents

FLAGS = ("-std=c99", "-ffp-contract=off", "-fvisibility=hidden", "-fPIC")
TIGHTER = 1e-2  # of the tolerance: that of the two runs whose difference is a directional derivative


def faults(file: Path) -> list[Fault]:
    """Return the faults of a file to be written."""
    found = new_file_faults("--fmu", file, "a unit is never overwritten: name another")
    if file.suffix != ".fmu":
        found.append(Fault("--fmu", str(file), "a file whose name ends in .fmu"))
    return found + name_faults("--fmu", file.stem)


def write(asked: Asked, file: Path) -> str:
    """Write the unit of a scene into a new file; return what it is. Raises InputError."""
    found = contents(asked)
    repeated = sorted({row.name for row in found.parameters} & {row.name for row in (*found.states, *found.outputs)})
    if repeated:
        fault = Fault("names", f"{', '.join(repeated)} twice", "parameters and histories of different names")
        raise InputError("export", [fault])
    parts, binary = unit(found, file.stem, asked.fmi)
    write_atomically(file, archive(parts))
    return f"{file} (FMI {asked.fmi}.0 for co-simulation, {binary})"


def unit(found: Contents, name: str, fmi: int) -> tuple[dict[str, bytes], str]:
    """Return the files of a unit by their places in it, and what its binary is for."""
    texts = library(found, name)
    token = str(uuid.UUID(hashlib.sha256(texts[f"{name}.c"].encode()).hexdigest()[:32]))
    tight = max(TIGHTER * found.tolerance, LEAST)
    words = {
        **{"n": name, "N": name.upper(), "name": name, "fmi": str(fmi), "token": token},
        **{"duration": number(found.seconds), "derivative_tolerance": number(tight)},
        "derivative_step": number(tight ** (1 / 3)),  # its square and the tolerance over it are alike
    }
    standard = template(f"fmi{fmi}.c", words)
    sources = {
        f"{name}.h": texts[f"{name}.h"],
        f"{name}.c": texts[f"{name}.c"],
        "fmu.c": template("fmu.c", {"standard": standard, **words}),
    }
    parts = {"modelDescription.xml": description(found, name, token, fmi)}
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
