"""Results of many runs: a row each, and their table by column."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from hertzwerk.runtime.model.binding import Value
from hertzwerk.runtime.model.model import Model
from hertzwerk.runtime.solution.solution import Statistics, write

NUMBERS = ("impacts", "peak_force", "energy_residual", "error_estimate", "steps", "rhs_evaluations", "wall_s")
TEXTS = ("outcome", "message", "warnings")
_UNITS = {"peak_force": "N", "wall_s": "s"}


@dataclass(frozen=True)
class Row:
    """One run: `given` values as given, `values` in SI; `final`: every state at the end.

    Where there is no run, `outcome` is "bad_input", "failed" (by an error of ours) or "lost" (its process died), with
    the reason in `message`.
    """

    index: int
    given: Mapping[str, Value]
    outcome: str
    message: str = ""
    values: Mapping[str, float] = field(default_factory=dict)
    impacts: int = 0
    peak_force: float = math.nan
    energy_residual: float | None = None
    error_estimate: float | None = None  # at the end; see `ErrorEstimate`
    final: Mapping[str, float] = field(default_factory=dict)
    outputs: Mapping[str, float] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    statistics: Statistics | None = None

    def __getitem__(self, name: str) -> float | str:
        """Return the entry of a column."""
        if name in TEXTS:
            return "; ".join(self.warnings) if name == "warnings" else str(getattr(self, name))
        if name.startswith("final."):
            return self.final.get(name.removeprefix("final."), math.nan)
        for known in (self.outputs, self.values):
            if name in known:
                return known[name]
        if self.statistics is None or name not in NUMBERS:
            return math.nan
        value = getattr(self.statistics if hasattr(self.statistics, name) else self, name)
        return math.nan if value is None else float(value)


@dataclass(frozen=True)
class Sweep:
    """Rows in the given order; `sweep["peak_force"]` is a column, in SI, `sweep.names` lists all.

    interrupted    whether Ctrl-C ended it: the rows are those that were done
    """

    model: Model
    rows: tuple[Row, ...]
    output_names: tuple[str, ...]
    interrupted: bool
    workers: int
    compiled: bool
    wall_s: float

    def __len__(self) -> int:
        return len(self.rows)

    def __iter__(self) -> Iterator[Row]:
        return iter(self.rows)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all columns: varied values, results, final states."""
        given = dict.fromkeys(name for row in self.rows for name in row.given if name in ports(self.model))
        states = (*self.model.coordinates, *self.model.speeds, *self.model.memory)
        final = (f"final.{name}" for name in states)
        return (*given, "outcome", *NUMBERS, *self.output_names, *final, "message", "warnings")

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.names:
            raise KeyError(f"no column {name!r}; there are {', '.join(self.names)}")
        return np.array([row[name] for row in self.rows], dtype=None if name in TEXTS else float)

    def unit(self, name: str) -> str:
        """Return the SI unit text of a column; "" if it has none."""
        return _UNITS.get(name) or ports(self.model).get(name.removeprefix("final."), "")

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write a line per row, headed `name [unit]`, SI; raises FileExistsError."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["row", *(f"{name} [{self.unit(name)}]" if self.unit(name) else name for name in self.names)])
        for row in self.rows:
            entries = (row[name] for name in self.names)
            table.writerow([row.index, *(e if isinstance(e, str) else format(e, ".17g") for e in entries)])
        return write(Path(path), text.getvalue().encode(), overwrite=overwrite)

    def __str__(self) -> str:
        finished = sum(row.outcome == "finished" for row in self.rows)
        text = f"{len(self.rows)} runs, {finished} finished, in {self.wall_s:.3g} s on {self.workers} cores"
        return f"{text}; interrupted" if self.interrupted else text


def ports(model: Model) -> dict[str, str]:
    """Return the unit text of every parameter and state that a set may name."""
    return {**{name: port.unit for name, port in model.parameters.items()}, **model.joints.units, **model.units}
