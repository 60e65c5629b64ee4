"""`hertzwerk report`: one self-contained HTML page of a run, a sweep, a study or a scene."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault, InputError, refuse, unknown
from hertzwerk.runtime.cli.target_options import assignments
from hertzwerk.runtime.cli.terminal import GOOD, Progress, line, reports_bad_input
from hertzwerk.runtime.system.digests import read_sealed

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.output.reports.html_page import Cell, Origin
    from hertzwerk.runtime.simulation import Solution


@click.command(epilog="Example: hertzwerk report runs/slider_crank-001")
@click.argument("target", metavar="FOLDER|FILE|TARGET")
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    help="HTML file to write (default: report.html in FOLDER, or beside FILE).",
)
@click.option("--scene", metavar="FILE", help="Python file of the run's scene, which is executed, for its equations.")
@click.option("--overwrite", is_flag=True, help="Replace an existing file.")
@reports_bad_input
def report(target: str, out: Path | None, scene: str | None, overwrite: bool) -> int:
    """Write an HTML page of a run, sweep, study or scene.

    The page holds numbers, warnings, pictures, equations and origin, and needs no other file. FOLDER is one that
    `hertzwerk run`, `sweep`, `study`, `fit`, `propagate` or `minimise` wrote, FILE one of `Solution.save`, TARGET a
    built-in scene or a Python file that defines `scene`, which is executed.
    """
    from hertzwerk.runtime.system.result_folder import new_file_faults

    place = Path(target)
    path = out or (place / "report.html" if place.is_dir() else Path(f"{place.stem}.html"))
    refuse("report", new_file_faults("--out", path, "name another, or add --overwrite", overwrite=overwrite))
    with Progress(f"report of {target}") as progress:
        progress.stage("making the page")
        from hertzwerk.runtime.engine.solution.solution import write

        page = page_of(place, target, scene).encode()
    line("written", str(write(path, page, overwrite=overwrite)))
    return GOOD


# -- subjects: folders of runs, sweeps, studies and fits, saved runs, scenes ---------------------------------------------


def page_of(place: Path, target: str, scene: str | None) -> str:
    """Return the page of what a path or name stands for; raises InputError."""
    if place.is_dir():
        kinds: dict[str, Callable[[Path, str | None], str]] = {
            "run.json": _of_run_folder,
            "study.json": partial(_of_record, "study", "study"),
            "fit.json": partial(_of_record, "fit", "fit"),
            "propagation.json": partial(_of_record, "propagation", "propagate"),
            "minimum.json": partial(_of_record, "minimum", "minimise"),
            "definition.json": _of_sweep,
        }
        for file, make in kinds.items():
            if (place / file).is_file():
                if scene is not None and make is not _of_run_folder:
                    raise InputError("report", [Fault("--scene", scene, "none: only a run has one")])
                return make(place, scene)
        expected = "a folder that `hertzwerk run`, `sweep`, `study`, `fit`, `propagate` or `minimise` wrote"
        raise InputError("report", [Fault("RUN", f"{place}, a folder without {', '.join(kinds)}", expected)])
    if place.suffix == ".npz":
        return _of_run(place, {}, scene)
    from hertzwerk.runtime.engine.model.build import built_in_scenes
    from hertzwerk.runtime.loading import engine_model
    from hertzwerk.runtime.output.reports.model_report import model_page

    scenes = built_in_scenes()
    if not (
        place.exists() or place.suffix or ":" in target or target in scenes
    ):  # files and modules have errors of their own
        raise InputError("report", [unknown("folder or scene", target, scenes, "a saved run or a Python file")])

    if scene is not None:
        raise InputError("report", [Fault("--scene", scene, "none: TARGET is a scene itself")])
    return model_page(engine_model(target))


def _of_run_folder(folder: Path, scene: str | None) -> str:
    return _of_run(folder / "states.npz", _record(folder / "run.json"), scene)


def _of_record(name: str, command: str, folder: Path, _: str | None) -> str:
    from hertzwerk.runtime.output.reports import record_pages

    record = _record(folder / f"{name}.json")
    make: Callable[[Mapping[str, Any], Path, Origin], str] = getattr(record_pages, f"{name}_page")
    try:
        return make(record, folder, _origin(record, str(record.get("command", f"hertzwerk {command}"))))
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        actual = f"{folder / name}.json: {type(error).__name__}: {error}"
        raise InputError("report", [Fault("RUN", actual, f"a record that `hertzwerk {command}` wrote")]) from error


def _of_sweep(folder: Path, _: str | None) -> str:
    from hertzwerk.derive.common.units import parse_unit
    from hertzwerk.runtime.output.reports.sweep_report import MOST, sweep_page
    from hertzwerk.runtime.studies.sweeps.points.sweep_definition import FOLLOW, read_definition
    from hertzwerk.runtime.studies.sweeps.sweep_table import Sweep, form_of

    sweep, definition = Sweep.load(folder), read_definition(folder) or {}
    columns, rows = sweep.in_stated_units(MOST)
    settings = {name: value for name, value in definition.items() if name not in (*FOLLOW, "versions")}
    command = str(definition.get("command", f"hertzwerk sweep --resume {shlex.quote(str(folder))}"))
    origin = _origin(definition, command)
    whole = str(folder / "table.csv")
    summary = sweep.summary
    numbers = {form: str(i) for i, form in enumerate(summary.warnings, 1)}
    column = sweep.names.index("warnings")
    for row, entries in zip(sweep, rows, strict=False):
        entries[column] = ", ".join(sorted({numbers[form_of(text)] for text in row.warnings}, key=int))
    factors = {name: parse_unit(unit).to_si(1.0) for name, unit in sweep.stated_units.items()}
    ranges: list[list[Cell]] = [
        [
            name,
            columns[name],
            *(x / factors.get(name, 1.0) for x in (each.least, each.median, each.largest)),
            each.count,
        ]
        for name, each in summary.spreads.items()
        if each.count
    ]
    warnings = list(map(str, summary.warnings.values()))
    counts = sweep.counts()
    return sweep_page(
        sweep.scene, sweep.outcome, columns, rows, counts, ranges, warnings, settings, origin, whole, sweep.plot
    )


def _origin(content: Mapping[str, Any], command: str) -> Origin:
    """Return the origin that a record states."""
    from hertzwerk.runtime.output.reports.html_page import Origin

    versions = {str(name): str(version) for name, version in (content.get("versions") or {}).items()}
    return Origin(command, versions or None)


def _record(path: Path) -> dict[str, Any]:
    """Return the content of a record; raises InputError."""
    try:
        return read_sealed(path)
    except (OSError, ValueError) as error:
        raise InputError("report", [Fault("RUN", f"{path}: {error}", "the record as the command wrote it")]) from error


def _of_run(states: Path, content: Mapping[str, Any], scene: str | None) -> str:
    from hertzwerk.runtime.output.reports.run_report import call_of, run_page
    from hertzwerk.runtime.simulation import Solution

    run = Solution.load(states)
    request = content.get("request") or {}
    model = _declared(run, request, scene)
    origin = _origin(content, str(request.get("command") or call_of(run)))
    return run_page(run, model=model, origin=origin, whole=str(states), sensitivities=content.get("sensitivities"))


def _declared(run: Solution, request: Mapping[str, Any], scene: str | None) -> EngineModel | None:
    """Return the model of a saved run: of a built-in scene, or of a file that is named to be executed.

    None where it is neither, or derives to other tables than those of the run.
    """
    from hertzwerk.runtime.engine.model.build import built_in_scenes
    from hertzwerk.runtime.engine.solution.solution import SAVED
    from hertzwerk.runtime.loading import engine_model

    target = scene or str(request.get("target", run.engine.model.name))
    if scene is None and target not in built_in_scenes():
        return None
    model = engine_model(
        target,
        without=tuple(request.get("without", ())),
        laws=assignments("--law", request.get("laws", ()), []),
        coordinates=request.get("coordinates"),
    )
    if all(getattr(model.module, name) == getattr(run.engine.model.module, name) for name in SAVED if name != "SOURCE"):
        return model
    if scene is None:
        return None
    raise InputError("report", [Fault("--scene", f"{scene}, which derives to another model", "the scene of the run")])
