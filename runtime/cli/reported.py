"""Subjects of `hertzwerk report`: saved runs with the scenes they came from, scenes themselves."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.cli.target import assignments

if TYPE_CHECKING:
    from hertzwerk.runtime.loading import Model
    from hertzwerk.runtime.simulation import Solution


def page_of(place: Path, target: str, scene: str | None) -> str:
    """Return the page of what a path or name stands for; raises InputError."""
    if place.is_dir():
        if (place / "run.json").is_file():
            return _of_run(place / "states.npz", _told(place / "run.json"), scene)
        found, expected = f"{place}, a folder without run.json", "a folder that `hertzwerk run` wrote"
        raise InputError("report", [Fault("RUN", found, expected)])
    if place.suffix == ".npz":
        return _of_run(place, {}, scene)
    from hertzwerk.runtime.loading import load
    from hertzwerk.runtime.report.model_report import model_page

    if scene is not None:
        raise InputError("report", [Fault("--scene", scene, "none: TARGET is a scene itself")])
    return model_page(load(target))


def _told(path: Path) -> dict[str, Any]:
    """Return the content of a record; raises InputError."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        if isinstance(content, dict):
            return content
        found = f"{path}: {type(content).__name__}"
    except (OSError, ValueError) as error:
        found = f"{path}: {error}"
    raise InputError("report", [Fault("RUN", found, "the record that the command wrote")])


def _of_run(states: Path, told: Mapping[str, Any], scene: str | None) -> str:
    from hertzwerk.runtime.report.html_page import Origin
    from hertzwerk.runtime.report.run_report import call_of, run_page
    from hertzwerk.runtime.simulation import Solution

    run = Solution.load(states)
    request = told.get("request") or {}
    model = _declared(run, request, scene)
    versions = {str(name): str(version) for name, version in (told.get("versions") or {}).items()}
    command = str(request.get("command") or call_of(run))
    return run_page(run, model=model, origin=Origin(command, versions or None), whole=str(states))


def _declared(run: Solution, request: Mapping[str, Any], scene: str | None) -> Model | None:
    """Return the model of a saved run: of a built-in scene, or of a file that is named to be executed.

    None where it is neither, or derives to other tables than those of the run.
    """
    from hertzwerk.runtime.loading import load
    from hertzwerk.runtime.model.build import built_in_scenes

    target = scene or str(request.get("target", run.model.name))
    if scene is None and target not in built_in_scenes():
        return None
    model = load(
        target,
        without=tuple(request.get("without", ())),
        laws=assignments("--law", request.get("laws", ()), []),
        coordinates=request.get("coordinates"),
    )
    tables = {name: table for name, table in vars(run.model.module).items() if name.isupper()}
    if all(getattr(model.module, name, None) == table for name, table in tables.items() if name != "SOURCE"):
        return model
    if scene is None:
        return None
    raise InputError("report", [Fault("--scene", f"{scene}, which derives to another model", "the scene of the run")])
