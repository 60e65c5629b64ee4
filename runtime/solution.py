"""What a run returns: outcome, histories by name, impacts, statistics, energy ledger; to CSV, to and from npz, and between its rows."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from hertzwerk.runtime.cache import write_atomically
from hertzwerk.runtime.history import History
from hertzwerk.runtime.impacts import Impact, find
from hertzwerk.runtime.integrate.choose import Choice, choices
from hertzwerk.runtime.model import Model
from hertzwerk.runtime.outcome import Outcome

__all__ = ["History", "Impact", "Solution", "Statistics"]


@dataclass(frozen=True)
class Statistics:
    """What a run cost: accepted steps, steps rejected for their error, steps retaken to land on an event, evaluations of the right-hand side,
    contacts begun (events); wall_s the integration, build_s everything before it (reading input, building the functions), compile_s what was
    compiled on the way [s]."""

    steps: int
    rejected: int
    retaken: int
    rhs_evaluations: int
    events: int
    wall_s: float
    build_s: float
    compile_s: float = 0.0


@dataclass(frozen=True)
class Solution:
    """A run. `run["guide.travel"]` is a history over `run.t`, in SI; `run.names` lists what there is."""

    history: History = field(repr=False)
    outcome: Outcome
    duration: float
    accuracy: float
    method: str
    compiled: bool
    parameters: Mapping[str, tuple[float, str]] = field(repr=False)
    statistics: Statistics
    warnings: tuple[str, ...]

    @property
    def model(self) -> Model:
        """The model that was run."""
        return self.history.model

    @property
    def t(self) -> np.ndarray:
        """Times of the accepted steps [s], shape (rows,)."""
        return self.history.t

    @property
    def states(self) -> tuple[str, ...]:
        """Names of the integrated states: coordinates, speeds, memory."""
        return (*self.model.coordinates, *self.model.speeds, *self.model.memory)

    @property
    def names(self) -> tuple[str, ...]:
        """Every name that `run[name]` has."""
        return self.history.names

    @property
    def choices(self) -> tuple[Choice, ...]:
        """What `method="auto"` chose, when and why; of any other method nothing."""
        return choices(self.history) if self.method == "auto" else ()

    def __getitem__(self, name: str) -> np.ndarray:
        return self.history[name]

    def at(self, times: Sequence[float] | np.ndarray) -> History:
        """Histories at any times [s] of the run, by a part of the step that covers each: of the method's order, under that step's modes."""
        return self.history.at(np.asarray(times, dtype=float))

    @property
    def final(self) -> dict[str, float]:
        """Every state at the end, SI."""
        return {name: float(self[name][-1]) for name in self.states}

    @cached_property
    def impacts(self) -> tuple[Impact, ...]:
        """Every contact in the order of its onset."""
        return find(self.history)

    @cached_property
    def energy_residual(self) -> float | None:
        """Largest |energy - initial energy + dissipated - input| of the run over the largest of these four magnitudes.

        None without a ledger, and where a run that came to no good end holds an energy that is not finite.
        """
        if not self.model.has_ledger:
            return None
        dissipated, supplied = (
            np.sum([self[name] for name in self.model.memory if name.endswith(end)], axis=0) + np.zeros(len(self.t))
            for end in (".dissipated", ".input")
        )
        energy = self["energy"]
        if not all(np.all(np.isfinite(part)) for part in (energy, dissipated, supplied)):
            return None
        magnitude = max(float(np.max(np.abs(part))) for part in (energy, dissipated, supplied))
        error = np.abs(energy - energy[0] + (dissipated - dissipated[0]) - (supplied - supplied[0]))
        return float(np.max(error)) / magnitude if magnitude > 0 else float(np.max(error))

    def __str__(self) -> str:
        statistics, count = self.statistics, len(self.impacts)
        parts = [
            f"{self.t[-1] * 1e3:g} ms in {statistics.steps:,} steps",
            f"{count:,} impact{'s' if count != 1 else ''}",
        ]
        if self.energy_residual is not None:
            parts.append(f"energy closed to {self.energy_residual:.1g}")
        text = f"{self.outcome.name}: {', '.join([*parts, f'{statistics.wall_s * 1e3:.3g} ms'])}"
        return text if self.outcome.finished else f"{text}\n{self.outcome.message}; {self.outcome.remedy}"

    def plot(self, *names: str, **options: Any) -> Any:
        """A figure of this run; see `hertzwerk.runtime.plot.plot`."""
        from hertzwerk.runtime import plot

        return plot.plot(self, *names, **options)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write every history as a column, headed `name [unit]`, rows at `run.t`, SI; raises FileExistsError."""
        columns = ["t", *self.names]
        units = self.history.units
        table = np.column_stack([self.t, *(self[name] for name in self.names)])
        text = io.StringIO()
        text.write(",".join(f"{name} [{units[name]}]" for name in columns) + "\n")
        np.savetxt(text, table, delimiter=",", fmt="%.17g")
        return write(Path(path), text.getvalue().encode(), overwrite=overwrite)

    def save(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write the whole run as npz, to be read by `Solution.load` or NumPy; raises FileExistsError."""
        module = self.model.module
        about = {
            "scene": {name: getattr(module, name) for name in _TABLES if hasattr(module, name)},
            "ledger": self.model.has_ledger,
            "outcome": asdict(self.outcome),
            "statistics": asdict(self.statistics),
            "parameters": dict(self.parameters),
            "warnings": self.warnings,
            **{name: getattr(self, name) for name in ("duration", "accuracy", "method", "compiled")},
            "energy_residual": self.energy_residual,
            "impacts": [asdict(impact) for impact in self.impacts],
        }
        content = io.BytesIO()
        histories: dict[str, Any] = {name: self[name] for name in ("t", *self.names)}
        np.savez_compressed(content, about=json.dumps(about), **histories)
        return write(Path(path), content.getvalue(), overwrite=overwrite)

    @classmethod
    def load(cls, path: str | Path) -> Solution:
        """A saved run: its histories, impacts and numbers. It holds no functions: `at` asks for a new run."""
        with np.load(Path(path), allow_pickle=False) as file:
            about = json.loads(str(file["about"]))
            histories = {name: file[name] for name in file.files if name != "about"}
        module = ModuleType(f"saved_{about['scene']['NAME']}")
        for name, table in about["scene"].items():
            setattr(module, name, _tuples(table))
        if about["ledger"]:
            module.ledger = None  # type: ignore[attr-defined]
        solution = cls(
            history=History.stored(Model(module), histories),
            outcome=Outcome(**about["outcome"]),
            duration=about["duration"],
            accuracy=about["accuracy"],
            method=about["method"],
            compiled=about["compiled"],
            parameters={name: (value, unit) for name, (value, unit) in about["parameters"].items()},
            statistics=Statistics(**about["statistics"]),
            warnings=tuple(about["warnings"]),
        )
        solution.__dict__["impacts"] = tuple(Impact(**impact) for impact in about["impacts"])
        solution.__dict__["energy_residual"] = about["energy_residual"]
        return solution


_TABLES = (
    *("NAME", "SOURCE", "SUMMARY", "EFFECTS", "UNCHECKED", "PARAMETERS", "LIMITS", "COORDINATES", "SPEEDS", "MEMORY"),
    *("LATCHES", "PAIRS", "DISSIPATED", "OUTPUTS", "CONSTANTS", "BODIES", "OPERATIONS", "QUATERNIONS"),
)


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def write(path: Path, content: bytes, *, overwrite: bool) -> Path:
    """Write a file whole; raises FileExistsError where there is one already and `overwrite` is not said."""
    if path.exists() and not overwrite:
        raise FileExistsError(f"{path} exists; name another file, or say overwrite=True")
    write_atomically(path, content)
    return path
