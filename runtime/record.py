"""A run on disk and as JSON: one new folder with the data, what produced it, and the plots."""

from __future__ import annotations

import json
import math
import platform
from collections.abc import Callable
from dataclasses import asdict
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.faults import Fault, InputError
from hertzwerk.runtime.scratch import scratch_folder

if TYPE_CHECKING:
    from hertzwerk.runtime.solution import Solution


def summary(solution: Solution, *, averages: bool = False) -> dict[str, Any]:
    """What `run --json` prints: plain numbers in SI, null for what does not exist; averages where they are asked for."""
    statistics, error = solution.statistics, solution.error
    return {
        "scene": solution.model.name,
        "outcome": solution.outcome.name,
        "t_end": solution.t_end,
        "duration": solution.duration,
        "accuracy": solution.accuracy,
        "tolerance": solution.tolerance,
        "method": solution.method,
        "compiled": solution.compiled,
        "steps": statistics.steps,
        "rejected": statistics.rejected,
        "rhs_evaluations": statistics.rhs_evaluations,
        "wall_s": statistics.wall_s,
        "impacts": [
            {"contact": i.contact, "t": i.t, "speed": i.speed, "peak_force": i.peak_force, "duration": i.duration}
            for i in solution.impacts
        ],
        "final": solution.final,
        "energy_residual": solution.energy_residual,
        "error_estimate": error and error.end,
        "horizon": error and error.horizon,
        "growth": error and error.growth,
        "decade_cost": error and error.decade_cost,
        "warnings": list(solution.warnings),
        "advice": list(solution.advice),
        **({"averages": [asdict(average) for average in solution.averages()]} if averages else {}),
    }


def record(solution: Solution, *, averages: bool = False) -> dict[str, Any]:
    """What `run.json` keeps: the summary, and everything needed to run the same again."""
    model = solution.model
    return {
        **summary(solution, averages=averages),
        "outcome_message": solution.outcome.message,
        "remedy": solution.outcome.remedy,
        "source": model.module.SOURCE,
        "effects": [{"name": name, "kind": kind, "text": text} for name, kind, text in model.module.EFFECTS],
        "unchecked": [{"effect": effect, "reason": reason} for effect, reason in model.module.UNCHECKED],
        "parameters": {name: {"value": value, "unit": unit} for name, (value, unit) in solution.parameters.items()},
        "initial": solution.initial,
        "rows": len(solution.t),
        "statistics": asdict(solution.statistics),
        "error": solution.error and solution.error.numbers,
        "choices": [asdict(choice) for choice in solution.choices],
        "versions": versions(),
    }


def versions() -> dict[str, str]:
    """Versions of what computed a run."""
    return {**{name: _version(name) for name in ("hertzwerk", "casadi", "numpy")}, "python": platform.python_version()}


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:  # run from the source tree
        return "not installed"


def json_text(content: dict[str, Any]) -> str:
    """JSON by the standard: what is not finite is null."""
    return json.dumps(_finite(content), indent=2, allow_nan=False)


def destination_fault(out: Path) -> Fault | None:
    """Why a run cannot be written to a folder, or None."""
    if out.is_dir() and any(out.iterdir()):
        return Fault(
            "--out", f"{out}, which has other content", "a new or an empty folder", "a run never overwrites another"
        )
    if out.exists() and not out.is_dir():
        return Fault("--out", f"{out}, which is a file", "a new or an empty folder")
    return None


def write(solution: Solution, out: Path | None, *, plots: bool, averages: bool = False) -> tuple[Path, list[str]]:
    """Write a run to `out`, or to the next free runs/<scene>-NNN; returns the folder and its files. All of it appears at once, or nothing."""
    return new_folder(
        solution.model.name, out, lambda folder: _write_files(solution, folder, plots=plots, averages=averages)
    )


def new_folder(name: str, out: Path | None, fill: Callable[[Path], list[str]]) -> tuple[Path, list[str]]:
    """Fill the new folder `out`, or the next free runs/<name>-NNN; returns it and its files. All of it appears at once, or nothing."""
    parent = out.parent if out is not None else Path("runs")
    parent.mkdir(parents=True, exist_ok=True)
    with scratch_folder(parent) as temporary:
        files = fill(temporary)
        return _publish(temporary, out, parent / name), files


def _write_files(solution: Solution, folder: Path, *, plots: bool, averages: bool) -> list[str]:
    solution.to_csv(folder / "states.csv")
    solution.save(folder / "states.npz")
    (folder / "run.json").write_text(json_text(record(solution, averages=averages)) + "\n", encoding="utf-8")
    files = ["states.csv", "states.npz", "run.json"]
    if plots:
        from hertzwerk.runtime import plot
        from hertzwerk.runtime.draw import picture

        picture.of_run(solution).savefig(folder / "mechanism.png", dpi="figure")
        files += ["mechanism.png", *plot.save_all(solution, folder)]
    return files


def _publish(temporary: Path, out: Path | None, stem: Path) -> Path:
    """Give the finished folder its name; a rename onto a folder with content fails, so two runs never mix."""
    if out is not None:
        try:
            return temporary.rename(out)
        except OSError as error:
            raise InputError("run", [Fault("--out", str(error), "a new or an empty folder")]) from error
    number = 1
    while True:
        path = stem.with_name(f"{stem.name}-{number:03d}")
        try:
            if not path.exists():
                return temporary.rename(path)
        except FileExistsError:
            pass  # another run took the number meanwhile
        except OSError:
            if not path.exists():
                raise
        number += 1


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
