"""Files that define a propagation or a minimisation: TOML with the keys of the function.

target = "slider_crank"
duration = "2 ms"
tolerance = 1e-7
outputs = ["slider_pin.peak_force"]
[uncertain]
clearance = "Normal(0.5 mm, 0.02 mm)"
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from inspect import signature
from pathlib import Path
from typing import Any

from hertzwerk.derive.common.faults import Fault, refuse, shown, unknown
from hertzwerk.derive.common.toml_file import read_toml
from hertzwerk.runtime.engine.inputs.input_values import located
from hertzwerk.runtime.engine.model.build import located_target

OF_SCENE = ("without", "laws", "coordinates")
NOT_IN_FILES = ("functions", "compiled", "workers", "client", "out", "widen", "progress")


def read_definition(path: Path, function: Callable[..., Any], required: tuple[str, ...]) -> dict[str, Any]:
    """Return the arguments of a function, and the target with its variation, that a file states.

    Files are named relative to its folder. Raises InputError for keys that are unknown or missing; what values mean is
    checked by the function.
    """
    content = read_toml(path, ", ".join(required))
    known = (*OF_SCENE, *(name for name in signature(function).parameters if name not in NOT_IN_FILES))
    faults = [unknown("key", name, known) for name in content if name not in known]
    faults += [Fault(name, "none", f"a file with {', '.join(required)}") for name in required if name not in content]
    target = content.get("target", "")
    if not isinstance(target, str):
        faults.append(Fault("target", shown(target), "the name of a scene, or its file"))
    refuse(str(path), faults)
    content["target"] = located_target(target, path.parent)
    if isinstance(inputs := content.get("inputs"), Mapping):
        content["inputs"] = {n: located(x, path.parent) if isinstance(x, str) else x for n, x in inputs.items()}
    return content
