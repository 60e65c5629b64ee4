"""Arguments that `hertzwerk propagate` and `hertzwerk minimise` share, of options or of a file."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.faults import Fault, refuse
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
) -> dict[str, Any]:
    """Return the arguments of a function, of a TOML file or of options; raises InputError.

    own    returns the arguments of options that the command has alone; malformed ones are appended to its list
    """
    faults: list[Fault] = []
    if target.endswith(".toml"):
        refuse(target, beside(target, "the whole definition there", "target", "out", "file", "as_json"))
        from hertzwerk.runtime.studies.sweeps.definition_file import read_definition_file  # imports pydantic

        return read_definition_file(Path(target), function)
    arguments = own(faults)
    varied = Variation.taken(target, dict(options))
    model = varied.model(faults)
    arguments |= {"parameters": varied.values(faults), "inputs": assignments("--input", varied.inputs, faults) or None}
    arguments |= run_settings(varied.target, **options)
    refuse(target, faults)
    return {"target": model, **arguments}


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
