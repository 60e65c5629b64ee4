"""Arguments that `hertzwerk propagate` and `hertzwerk minimise` share, of options or of a file."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault, refuse, shown, unknown
from hertzwerk.derive.common.toml_file import read_toml
from hertzwerk.runtime.cli.target_options import Variation, assignments, beside, run_settings
from hertzwerk.runtime.system.digests import record_text

if TYPE_CHECKING:
    from hertzwerk.runtime.studies.minimisation.minimum import Minimum
    from hertzwerk.runtime.studies.uncertainty.propagation_result import Propagated


def definition(
    target: str,
    options: Mapping[str, Any],
    own: Callable[[list[Fault]], dict[str, Any]],
    function: Callable[..., Any],
    required: tuple[str, ...],
) -> dict[str, Any]:
    """Return the arguments of a function, of a TOML file or of options; raises InputError.

    own    returns the arguments of options that the command has alone; malformed ones are appended to its list
    """
    faults: list[Fault] = []
    if target.endswith(".toml"):
        refuse(target, beside(target, "the whole definition there", "target", "out", "file", "as_json"))
        arguments = read_definition(Path(target), function, required)
        from hertzwerk.runtime.loading import engine_model

        variation = {name: arguments.pop(name) for name in ("without", "laws", "coordinates") if name in arguments}
        return {"target": engine_model(arguments.pop("target"), **variation), **arguments}
    arguments = own(faults)
    varied = Variation.taken(target, dict(options))
    model = varied.model(faults)
    arguments |= _of_run(varied, options, faults)
    refuse(target, faults)
    return {"target": model, **arguments}


def _of_run(varied: Variation, options: Mapping[str, Any], faults: list[Fault]) -> dict[str, Any]:
    """Return the arguments of the runs, by default the scenario's."""
    arguments = {"parameters": varied.values(faults), "inputs": assignments("--input", varied.inputs, faults) or None}
    return {**arguments, **run_settings(varied.target, **options)}


def named(option: str, texts: Sequence[str], sign: str, faults: list[Fault]) -> dict[str, str]:
    """Parse texts FORMULA SIGN VALUE, the sign kept with the value; malformed ones are faults."""
    values = {}
    for text in texts:
        place = min((text.index(part) for part in sign.split() if part in text), default=0)
        if not place or text[:place].strip() in values:
            faults.append(
                Fault(option, repr(text), f"a formula and its bound, once: FORMULA {' or '.join(sign.split())} VALUE")
            )
        else:
            values[text[:place].strip()] = text[place:]
    return values


def keep(result: Propagated | Minimum, folder: Path, name: str, missing: list[str]) -> tuple[Path, list[str]]:
    """Write the record and the picture of a result into a folder; return it and its files.

    What could not be made is appended to `missing`.
    """
    from hertzwerk.runtime.cli.target_options import command_line
    from hertzwerk.runtime.engine.solution.solution import write
    from hertzwerk.runtime.system.result_folder import failures_of
    from hertzwerk.runtime.system.versions import versions

    content = {**result.record(), "command": command_line(), "versions": versions()}
    folder.mkdir(parents=True, exist_ok=True)
    write(folder / f"{name}.json", record_text(content).encode(), overwrite=True)
    missing += failures_of(f"{name}.png", lambda: result.plot().savefig(folder / f"{name}.png"))
    return folder, [f"{name}.json", *([] if missing else [f"{name}.png"])]


# -- files that define a propagation or a minimisation: TOML with the keys of the function -----------------------------


OF_SCENE = ("without", "laws", "coordinates")
NOT_IN_FILES = ("functions", "compiled", "workers", "client", "out", "widen", "progress")


def read_definition(path: Path, function: Callable[..., Any], required: tuple[str, ...]) -> dict[str, Any]:
    """Return the arguments of a function, and the target with its variation, that a file states.

    Files are named relative to its folder. Raises InputError for keys that are unknown or missing; what values mean is
    checked by the function.
    """
    from hertzwerk.runtime.studies.sweeps.sweep_file import located_arguments  # imports pydantic

    content = read_toml(path, ", ".join(required))
    known = (*OF_SCENE, *(name for name in signature(function).parameters if name not in NOT_IN_FILES))
    faults = [unknown("key", name, known) for name in content if name not in known]
    faults += [Fault(name, "none", f"a file with {', '.join(required)}") for name in required if name not in content]
    target = content.get("target", "")
    if not isinstance(target, str):
        faults.append(Fault("target", shown(target), "the name of a scene, or its file"))
    refuse(str(path), faults)
    return located_arguments({**content, "target": target}, path.parent)
