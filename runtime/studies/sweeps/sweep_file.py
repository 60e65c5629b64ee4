"""Sweep files: the definition of a sweep in TOML, with the keys of `sweep`, to be kept.

target = "slider_crank"
duration = "200 rev"
outputs = ["slider_pin.peak_force", "slider_pin.impact_rate"]
[over]
clearance = "0.05..0.5 mm:10"
restitution = [0.5, 0.7, 0.9]
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.file_schema import form_faults
from hertzwerk.derive.common.toml_file import read_toml
from hertzwerk.runtime.engine.inputs.input_values import INPUTS, located
from hertzwerk.runtime.engine.inputs.inputs_by_row import located_choices
from hertzwerk.runtime.engine.model.build import located_laws, located_target
from hertzwerk.runtime.engine.run.run_request import METHOD, Accuracy
from hertzwerk.runtime.studies.sweeps.parameter_sweep import sweep

Quantity = str | float


class SweepFile(BaseModel):
    """Arguments of `sweep` that a file may state; what they mean is checked there."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    target: str = Field(description="the name of a scene, or its file")
    over: dict[str, Quantity | list[Quantity] | dict[str, Quantity]] = Field(
        description='values by name, such as clearance = "0.05..0.5 mm:10" or restitution = [0.5, 0.7]'
    )
    zip: bool = False
    sample: int | None = None
    sampler: str = "latin"
    seed: int = 0
    parameters: dict[str, Quantity] = Field({}, description='values by name, such as radius = "20 mm"')
    initial: dict[str, Quantity] = Field({}, description='initial states by name, such as travel = "1 m"')
    inputs: dict[str, Quantity] = Field({}, description=INPUTS)
    without: list[str] = []
    laws: dict[str, str] = Field({}, description='laws by the names of effects, such as floor = "flores"')
    coordinates: str | None = None
    outputs: list[str] = []
    section: str | None = None
    after: Quantity | None = None
    grid: str | int | None = None
    histories: list[str] = []
    continued: str | None = None
    duration: Quantity = Field(description='a time or revolutions, such as "24 ms" or "200 rev"')
    accuracy: Accuracy | None = None
    tolerance: float | None = None
    method: str = METHOD
    max_steps: int | None = None
    max_events: int | None = None
    wall_time: float | None = None


def read_sweep(path: Path) -> dict[str, Any]:
    """Return the arguments of `sweep` that a file states; raises InputError with every fault.

    The files of scene, inputs and laws are named relative to the folder of the file.
    """
    content = read_toml(path, "target, over, duration and outputs")
    try:
        entries = SweepFile.model_validate(content)
    except ValidationError as error:
        faults = form_faults(error, SweepFile)
        faulty = {fault.where for fault in faults}
        raise InputError(str(path), [*faults, *_meaning_faults(path, content, faulty)]) from error
    return located_arguments(dict(entries), path.parent)


def located_arguments(arguments: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """Return the arguments of a study with the files of scene, inputs and laws as seen from a folder."""
    kinds = {"inputs": located, "laws": located_laws, "over": located_choices}
    moved = {
        key: {name: move(value, folder) for name, value in arguments[key].items()}
        for key, move in kinds.items()
        if isinstance(arguments.get(key), Mapping)
    }
    return {**arguments, **moved, "target": located_target(arguments["target"], folder)}


def _meaning_faults(path: Path, content: dict[str, Any], faulty: set[str]) -> list[Fault]:
    """Return the faults that `sweep` finds in the entries whose form is right."""
    right: dict[str, Any] = {}
    heads = {place.partition(".")[0] for place in faulty}
    for key, value in content.items():
        if isinstance(value, dict) and key not in faulty:
            right[key] = {name: x for name, x in value.items() if f"{key}.{name}" not in faulty}
        elif key not in heads:
            right[key] = value
    if "target" not in right:
        return []
    nobody = {"workers": 0}  # a fault: nothing is computed
    try:
        sweep(**located_arguments({"over": {}, **right, **nobody}, path.parent))
    except InputError as error:
        known = {*nobody, *heads}
        return [fault for fault in error.faults if fault.where not in known]
    raise AssertionError("a sweep without workers")
