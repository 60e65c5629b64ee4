"""Definitions in TOML: files with the arguments of `sweep`, `propagate` or `minimise`, to be kept.

target = "slider_crank"
duration = "200 rev"
outputs = ["slider_pin.peak_force", "slider_pin.impact_rate"]
[over]
clearance = "0.05..0.5 mm:10"
restitution = [0.5, 0.7, 0.9]
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from inspect import Parameter, signature
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError, create_model

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.derive.common.file_schema import form_faults
from hertzwerk.derive.common.toml_file import read_toml
from hertzwerk.runtime.engine.inputs.input_values import INPUTS, located
from hertzwerk.runtime.engine.inputs.inputs_by_row import located_choices
from hertzwerk.runtime.engine.model.build import located_laws, located_target
from hertzwerk.runtime.engine.run.run_request import Accuracy
from hertzwerk.runtime.loading import engine_model

Quantity = str | float
Values = dict[str, Quantity]
ENTRIES: dict[str, Any] = {  # types of the arguments that a file may state; what they mean is checked by the function
    "target": Annotated[str, Field(description="the name of a scene, or its file")],
    "over": Annotated[
        dict[str, Quantity | list[Quantity] | Values],
        Field(description='values by name, such as clearance = "0.05..0.5 mm:10" or restitution = [0.5, 0.7]'),
    ],
    "uncertain": Annotated[
        dict[str, str], Field(description='distributions by name, such as clearance = "Normal(0.5 mm, 0.02 mm)"')
    ],
    "objective": Annotated[str, Field(description='an output, or a formula, such as "slider_pin.peak_force"')],
    "duration": Annotated[Quantity, Field(description='a time or revolutions, such as "24 ms" or "200 rev"')],
    "parameters": Annotated[Values, Field(description='values by name, such as radius = "20 mm"')],
    "initial": Annotated[Values, Field(description='initial states by name, such as travel = "1 m"')],
    "start": Annotated[Values, Field(description='values by name, such as clearance = "0.2 mm"')],
    "inputs": Annotated[Values, Field(description=INPUTS)],
    "laws": Annotated[dict[str, str], Field(description='laws by the names of effects, such as floor = "flores"')],
    "constraints": Annotated[dict[str, str], Field(description='bounds by output, such as peak_force = "<= 5 kN"')],
    "correlation": Annotated[
        dict[str, float], Field(description='numbers by two names: "clearance, restitution" = -0.8')
    ],
    **dict.fromkeys(("without", "outputs", "histories"), list[str]),
    **dict.fromkeys(("coordinates", "section", "continued", "sampler", "method"), str),
    **dict.fromkeys(("sample", "seed", "starts", "max_steps", "max_events", "max_runs"), int),
    **dict.fromkeys(("tolerance", "wall_time", "precision"), float),
    **dict.fromkeys(("zip", "indices"), bool),
    "accuracy": Accuracy,
    "after": Quantity,
    "grid": str | int,
}
OF_MINIMISE: dict[str, Any] = {"over": dict[str, Quantity | list[Quantity]] | list[str]}
OF_SCENE = ("without", "laws", "coordinates")
IDLE = {"sweep": "workers", "propagate": "sample", "minimise": "max_runs"}  # 0 of them is a fault: nothing is computed


def form_of(function: Callable[..., Any]) -> type[BaseModel]:
    """Return the form of a file with the arguments of a function, and the variation of its target."""
    entries = {**ENTRIES, **(OF_MINIMISE if function.__name__ == "minimise" else {})}
    defaults = {name: argument.default for name, argument in signature(function).parameters.items()}
    needed = {name for name, default in defaults.items() if default is Parameter.empty} | {"duration"}
    fields: dict[str, Any] = {
        name: (entries[name], ... if name in needed else default)
        for name, default in {**dict.fromkeys(OF_SCENE), **defaults}.items()
        if name in entries
    }
    strict = ConfigDict(extra="forbid", frozen=True, strict=True)
    return create_model(function.__name__, __config__=strict, __doc__=f"Arguments of `{function.__name__}`.", **fields)


def read_definition_file(path: Path, function: Callable[..., Any]) -> dict[str, Any]:
    """Return the arguments of a function that a file states; raises InputError with every fault.

    The files of scene, inputs and laws are named relative to the folder of the file.
    """
    form = form_of(function)
    needed = [name for name, field in form.model_fields.items() if field.is_required()]
    content = read_toml(path, ", ".join(needed))
    try:
        entries = form.model_validate(content)
    except ValidationError as error:
        faults = form_faults(error, form)
        missing = {name: {} if name != "objective" else "" for name in needed if name not in ("target", "duration")}
        faulty = {fault.where for fault in faults}
        raise InputError(str(path), [*faults, *_meaning_faults(path, function, missing, content, faulty)]) from error
    return _from(path.parent, function, {name: getattr(entries, name) for name in content})


def _from(folder: Path, function: Callable[..., Any], stated: Mapping[str, Any]) -> dict[str, Any]:
    """Return arguments with the files of scene, inputs and laws as seen from a folder; raises InputError."""
    kinds = {"inputs": located, "laws": located_laws, "over": located_choices}
    moved = {
        key: {name: move(value, folder) for name, value in stated[key].items()}
        for key, move in kinds.items()
        if isinstance(stated.get(key), Mapping)
    }
    arguments = {**stated, **moved, "target": located_target(stated["target"], folder)}
    if "laws" not in signature(function).parameters:
        variation = {name: arguments.pop(name) for name in OF_SCENE if name in arguments}
        arguments["target"] = engine_model(arguments["target"], **variation)
    return arguments


def _meaning_faults(
    path: Path, function: Callable[..., Any], missing: Mapping[str, Any], content: Mapping[str, Any], faulty: set[str]
) -> list[Fault]:
    """Return the faults that a function finds in the entries whose form is right."""
    right: dict[str, Any] = {}
    heads = {place.partition(".")[0] for place in faulty}
    for key, value in content.items():
        if isinstance(value, dict) and key not in faulty:
            right[key] = {name: x for name, x in value.items() if f"{key}.{name}" not in faulty}
        elif key not in heads:
            right[key] = value
    if "target" not in right:
        return []
    idle = IDLE[function.__name__]
    try:
        function(**{**_from(path.parent, function, {**missing, **right}), idle: 0})
    except InputError as error:
        return [fault for fault in error.faults if fault.where not in {idle, *heads}]
    raise AssertionError("a call with nothing to compute")
