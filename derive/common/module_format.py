"""Format of generated modules: the tables that each has, and the digest of its text.

A digest finds what was altered by mistake; it is no signature. Nothing is executed here.
"""

from __future__ import annotations

import hashlib
import json
import re
import shlex
from pathlib import Path
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError

FORMAT = "hertzwerk module 1"
"""Format that modules state. A change of the tables, or of what functions take and return, is another one."""

EMPTY: dict[str, tuple[Any, ...] | None] = {
    **dict.fromkeys(("EFFECTS", "UNCHECKED", "CONTRADICTIONS", "ADVICE", "PARAMETERS", "LIMITS", "SUM_LIMITS"), ()),
    **dict.fromkeys(
        ("INPUTS", "SMOOTH_INPUTS", "COORDINATES", "QUATERNIONS", "SPEEDS", "MEMORY", "LATCHES", "PAIRS"), ()
    ),
    **dict.fromkeys(("EVENTS", "LOADS", "FED", "RUBBING", "GUIDES", "SLIPS", "RELEASES", "DISSIPATED"), ()),
    **dict.fromkeys(("CONSTRAINTS", "ROLLING", "SEATED", "BRISTLES", "OUTPUTS", "SPEED_LIMITED", "BODIES"), ()),
    **dict.fromkeys(("LANDMARKS", "FAMILIES", "CONSTANTS", "OPERATIONS"), ()),
    **dict.fromkeys(("GIVEN", "JOINT_COORDINATES", "JOINT_SPEEDS", "JOINT_QUATERNIONS", "JOINT_CONSTRAINTS"), None),
}
"""All tables of a module as they are without rows: None where an empty one has a meaning of its own."""

_MARK = re.compile(r'\A"""[^\n]*\n\nDo not edit; regenerate with `hertzwerk derive |^FORMAT = "hertzwerk module ', re.M)
_COORDINATES = re.compile(r"^Do not edit; regenerate with `hertzwerk derive .* --coordinates (\w+)`\.$", re.M)
_DIGEST = re.compile(r'^DIGEST = "(\w*)"$', re.M)
_STATED = r'^{} = ("(?:[^"\\\n]|\\.)*")$'


def sealed(text: str) -> str:
    """Return the text of a module with its digest in place of the one that it has, which may be empty."""
    return _DIGEST.sub(f'DIGEST = "{_digest(text)}"', text, count=1)


def is_generated(text: str) -> bool:
    """Return whether a text is that of a generated module, of whatever format."""
    return _MARK.search(text) is not None


def target_of(source: str, name: str) -> str:
    """Return the target that names the scene of a module, by its file as SOURCE states it."""
    return name if source.startswith("derive/") else source or "FILE"


def command(source: str, name: str, coordinates: str | None = None) -> str:
    """Return the command that generates the module of a scene, by its file as SOURCE states it.

    coordinates    other ones than those of the scene
    """
    option = "" if coordinates is None else f" --coordinates {coordinates}"
    return f"hertzwerk derive {target_of(source, name)}{option}"


def stated_coordinates(text: str) -> str | None:
    """Return the coordinates that the command in a module's header has, None where it has none."""
    match = _COORDINATES.search(text)
    return match[1] if match else None


def without_scene(where: str, source: str, name: str) -> InputError:
    """Return the error of what needs the scene of a model that has none; `source` as its SOURCE states it."""
    actual = "a model without its scene, as a generated module or a saved run is"
    target = target_of(source, name)
    remedy = f"load({target!r}) has it; hertzwerk derive {target} --show prints its equations"
    return InputError(name, [Fault(where, actual, f"the scene itself, of {source or 'its file'}", remedy)])


def generated_text(path: Path) -> str | None:
    """Return the text of the generated module in a file, None for any other file."""
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return None
    return text if is_generated(text) else None


def refuse_generated(path: Path) -> None:
    """Raise InputError for the file of a generated module, where a scene is needed."""
    if (text := generated_text(path)) is not None:
        raise without_scene(str(path), stated(text, "SOURCE"), stated(text, "NAME") or path.stem)


def require_intact(text: str, name: str, path: Path | None = None) -> None:
    """Raise InputError for the text of a module of another format, or with another digest than it states.

    path    its file, where it has one
    """
    its_format = stated(text, "FORMAT")
    seal = _DIGEST.search(text)
    if its_format != FORMAT:
        said, expected = (
            f"a module in the format {its_format!r}" if its_format else "a module without a format",
            repr(FORMAT),
        )
    elif seal is None or seal[1] != _digest(text):
        said, expected = "a text that does not fit its digest", "the module as hertzwerk wrote it"
    else:
        return
    source = stated(text, "SOURCE")
    scene_file, colon, scene = source.partition(":")
    folders = [] if path is None else [path.parent, path.parent.parent, *sorted(path.parent.parent.glob("*/"))]
    places = [folder / scene_file for folder in folders]
    file = next((place for place in places if place.is_file() and generated_text(place) is None), None)
    target = f"{shlex.quote(str(file))}{colon}{scene}" if file else source
    again = command(target, stated(text, "NAME") or name, stated_coordinates(text))
    where = "" if path is None or file == places[0] else f" --out {shlex.quote(str(path.parent))}"
    raise InputError(str(path or name), [Fault(str(path or name), said, expected, f"generate it anew: {again}{where}")])


def stated(text: str, name: str) -> str:
    """Return a text that a module states by its name, such as SUMMARY; "" where it states none."""
    match = re.search(_STATED.format(name), text, re.M)
    return str(json.loads(match[1])) if match else ""


def _digest(text: str) -> str:
    return hashlib.sha256(_DIGEST.sub('DIGEST = ""', text, count=1).encode()).hexdigest()[:32]
