"""Definition of a sweep as plain data: what a store keeps, what is compared, and the key of every row.

Two rows have one key if nothing that could change their numbers differs: the generated text, that of readings, the
parameters and the start in SI, the settings, the outputs with the code of own functions, and the versions.
"""

from __future__ import annotations

import hashlib
import json
import shlex
from array import array
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from importlib import metadata, resources
from pathlib import Path
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError, refuse, shown
from hertzwerk.derive.common.units import UnitError
from hertzwerk.runtime.engine.inputs.inputs_by_row import Choices, Labels
from hertzwerk.runtime.engine.model.binding import Value, read, read_parameters, read_state
from hertzwerk.runtime.engine.model.build import derive_digest, file_of, law_files, located_target
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.ranges import Range, RangeValues, ValueWithUnit
from hertzwerk.runtime.engine.model.signal import digest_of
from hertzwerk.runtime.engine.run.run_request import read_duration
from hertzwerk.runtime.engine.start.start_values import split_values
from hertzwerk.runtime.studies.sweeps.points.design_points import Design, read_design
from hertzwerk.runtime.system.digests import is_sealed

COMPUTING = ("engine", "studies/sweeps")  # what numbers depend on
ARGUMENTS = (  # of `sweep`, and names in a definition
    *(
        "target",
        "over",
        "parameters",
        "inputs",
        "without",
        "laws",
        "coordinates",
        "zip",
        "sample",
        "sampler",
        "seed",
        "outputs",
    ),
    *("section", "after", "grid", "histories", "continued"),
    *("duration", "accuracy", "tolerance", "method", "max_steps", "max_events", "wall_time"),
)
FOLLOW = ("columns", "varied", "arrays", "points", "target_file", "digest")  # from the rest, or of no numbers
DEFINITION = "definition.json"
_NUMBER, _NONE = (str, int, float), type(None)
ENTRIES: dict[str, type | tuple[type, ...]] = {  # of a definition, and their types
    **dict.fromkeys(("scene", "sampler", "method", "text", "readings", "signals", "digest"), str),
    **dict.fromkeys(("laws", "law_files", "over", "inputs", "parameters", "functions"), dict),
    **dict.fromkeys(("versions", "columns", "arrays", "choices"), dict),
    **dict.fromkeys(("without", "outputs", "histories", "varied"), list),
    **dict.fromkeys(("seed", "points"), int),
    **dict.fromkeys(("target", "target_file", "coordinates", "section", "continued"), (str, _NONE)),
    **dict.fromkeys(("after", "grid", "duration", "accuracy", "tolerance", "wall_time"), (*_NUMBER, _NONE)),
    "zip": bool,
    **dict.fromkeys(("sample", "max_steps", "max_events"), (int, _NONE)),
}
LIBRARIES = ("hertzwerk", "casadi", "numpy", "scipy")
WIDEN = "widen=True, or --widen, keeps the rows that are the same and computes the others; or take another folder"


@cache
def versions() -> dict[str, str]:
    """Return the versions of everything that computes, and the digest of our own code."""
    with resources.as_file(resources.files("hertzwerk.runtime")) as folder:
        code = "".join(derive_digest(folder / room) for room in COMPUTING)
    return {
        **{name: metadata.version(name) for name in LIBRARIES},
        "code": hashlib.sha256(code.encode()).hexdigest()[:16],
    }


def target_of(target: object, model: EngineModel) -> dict[str, Any]:
    """Return the scene of a model and its variation as plain data; no target where it was made in Python."""
    origin = model.declaration
    laws = {} if origin is None else dict(origin.laws)
    named = target if isinstance(target, str | Path) or origin is None else origin.target
    place = located_target(named, Path.cwd()) if isinstance(named, str | Path) else named
    return {
        "target": place if isinstance(place, str) else None,
        "target_file": _file_digest(place),
        "without": [] if origin is None else list(origin.without),
        "laws": laws,
        "law_files": law_files(laws),
        "coordinates": None if origin is None else origin.coordinates,
    }


def _file_digest(target: object) -> str | None:
    """Return the digest of the file that a target names, None where it names none."""
    file = file_of(target) if isinstance(target, str) else None
    if file is None:
        return None
    try:
        return hashlib.sha256(file.read_bytes()).hexdigest()
    except OSError:
        return None


def as_text(value: Any) -> str:
    """Return a value with its unit as text that reads back exactly."""
    try:
        number, _, unit = read(value)
    except UnitError:
        return value if isinstance(value, str) else shown(value)  # of a row that says so
    return f"{number!r}" if unit == "1" else f"{number!r} {unit}"


def number_and_unit(value: Value) -> Value:
    """Return a number and its unit, or what cannot be read as it is: its rows will say so."""
    try:
        number, _, unit = read(value)
    except UnitError:
        return value
    return number, unit


def axes_of(design: Design, choices: Choices) -> dict[str, str | Mapping[str, str | None]]:
    """Return the axes of a design as text that reads back exactly.

    Of choices by label; None for one made in Python.
    """
    return {
        name: choices.texts[name] if isinstance(axis, Labels) else _axis(axis) for name, axis in design.axes.items()
    }


def design_of(definition: Mapping[str, Any]) -> Design:
    """Return the design of a definition, as it was when that was written."""
    over = {name: axis for name, axis in definition["over"].items() if isinstance(axis, str)}
    how = {name: definition[name] for name in ("zip", "sample", "sampler", "seed")}
    design = read_design(over, **how, faults=[])
    axes = {name: design.axes[name] if name in over else Labels(axis) for name, axis in definition["over"].items()}
    return replace(
        design, axes=axes, fixed={name: number_and_unit(text) for name, text in definition["parameters"].items()}, **how
    )


def _axis(axis: tuple[ValueWithUnit, ...] | RangeValues | Range) -> str:
    if not isinstance(axis, tuple):
        return str(axis)
    shared = len({unit for _, unit in axis}) == 1
    return ", ".join(
        [*(repr(value) if shared else as_text((value, unit)) for value, unit in axis[:-1]), as_text(axis[-1])]
    )


def differences(before: Mapping[str, Any], now: Mapping[str, Any]) -> list[Fault]:
    """Return a fault for everything in which a definition differs from that of a store."""
    had, current = (
        {name: value for name, value in _flat(part) if name.partition(".")[0] not in FOLLOW} for part in (before, now)
    )
    return [
        Fault(name, _summary(current.get(name)), f"{_summary(had.get(name))}, as of the sweep there", WIDEN)
        for name in {**had, **current}
        if had.get(name) != current.get(name)
    ]


def _flat(part: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Any]]:
    for name, value in part.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{before}{name}.")
        else:
            yield f"{before}{name}", value


def _summary(value: Any) -> str:
    """Return a value as a message shows it; of many values their number and ends."""
    if isinstance(value, str) and value.count(", ") > 3:
        first, *_, last = values = value.split(", ")
        return f"{len(values)} values, {first} to {last}"
    return "none" if value is None else shown(value)


class Keys:
    """Keys of rows by their values; `about`: what is the same for all, plain data."""

    def __init__(
        self, model: EngineModel, settings: Mapping[str, Any], about: Mapping[str, Any], choices: Choices
    ) -> None:
        self._model, self._duration, self._choices = model, settings["duration"], choices
        others = {**about, **{name: value for name, value in settings.items() if name != "duration"}}
        self._same = hashlib.sha256(f"{sorted(others.items())!r}\n".encode())

    def of(self, values: Mapping[str, Value]) -> str:
        """Return the key of a row."""
        whole = self._same.copy()
        try:
            of_row, rest = self._choices.of(self._model, values)
        except InputError:
            whole.update(repr(sorted(map(repr, values.items()))).encode())
        else:
            signals = () if of_row is self._model else (digest_of(of_row.signals),)
            whole.update(repr((*_numbers(of_row, rest, self._duration), *signals)).encode())
        return whole.hexdigest()[:32]


def _numbers(model: EngineModel, values: Mapping[str, Value], duration: Any) -> Sequence[Any]:
    """Return everything a run of these values depends on in SI, or as given where that cannot be read."""
    parameters, initial = split_values(model, values)
    faults: list[Fault] = []
    reading = read_parameters(model.declared, parameters)
    seconds = read_duration(model, parameters, duration, faults)
    start = {name: read_state(name, model.joints.units[name], value) for name, value in sorted(initial.items())}
    if reading.faults or faults or any(fault is not None for _, fault in start.values()):
        return sorted(map(repr, values.items()))
    return (
        array("d", reading.si.values()).tobytes(),
        [(name, si.hex()) for name, (si, _) in start.items()],
        seconds.hex(),
    )


def arguments_of(definition: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """Return the arguments of `sweep` that go on with a definition.

    Raises InputError for one of Python, and where the file of its scene is another now: nobody has named that.
    """
    faults = []
    way_out = f"go on in Python, by the same call: sweep(..., out={str(folder)!r})"
    if definition["functions"]:
        actual = f"functions of its own: {', '.join(definition['functions'])}"
        faults.append(Fault(str(folder), actual, "outputs by name", way_out))
    made = [name for name, text in definition["inputs"].items() if text is None]
    axes = {name: axis.values() for name, axis in definition["over"].items() if isinstance(axis, Mapping)}
    made += [name for name, texts in axes.items() if None in texts]
    if made:
        faults.append(
            Fault(str(folder), f"inputs made in Python: {', '.join(made)}", "values or columns of files", way_out)
        )
    if definition["target"] is None:
        faults.append(Fault(str(folder), "a scene made in Python", "the name of a scene, or its file", way_out))
    elif _file_digest(definition["target"]) != definition["target_file"]:
        expected = "the file as the sweep executed it"
        changed = f"hertzwerk sweep {shlex.quote(definition['target'])} ... --out {shlex.quote(str(folder))} --widen"
        way_out = f"restore it, or accept it: {changed}, with the whole definition, executes it and keeps the rows that are the same"
        faults.append(Fault(definition["target"], "changed or missing content: it is not executed", expected, way_out))
    refuse("sweep", faults)
    return {name: definition[name] for name in ARGUMENTS}


# -- its file ----------------------------------------------------------------------------------------------------------


def read_definition(folder: Path) -> dict[str, Any] | None:
    """Return the definition in a folder with its digest, None where there is none.

    Raises InputError with every fault of one that is not as it was written.
    """
    file = folder / DEFINITION
    way_out = (
        f"the call that began it, with its whole definition and widen=True (hertzwerk sweep TARGET ... --out {shlex.quote(str(folder))} --widen), "
        "writes it anew and keeps the rows"
    )
    try:
        if not file.is_file():
            return None
        definition = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise InputError("sweep", [Fault(str(file), str(error), "a definition as a sweep wrote it", way_out)]) from None
    if not isinstance(definition, dict):
        raise InputError("sweep", [Fault(str(file), shown(definition), "a definition as a sweep wrote it", way_out)])
    faults = []
    for name, kinds in ENTRIES.items():
        if name not in definition:
            faults.append(Fault(f"{file}: {name}", "no entry", "one, as the sweep wrote it", way_out))
        elif not isinstance(definition[name], kinds):
            faults.append(Fault(f"{file}: {name}", shown(definition[name]), "the entry as the sweep wrote it", way_out))
    extra = [name for name in definition if name not in ENTRIES]
    faults += [Fault(f"{file}: {name}", "an entry", "none of this name", way_out) for name in extra]
    if not faults and not is_sealed(definition):
        faults.append(
            Fault(str(file), "entries that do not fit its digest", "a definition as a sweep wrote it", way_out)
        )
    refuse("sweep", faults)
    return definition
