"""Row of a sweep, and its arrays as they are kept: compressed, in memory, in a store, as CSV and JSON."""

from __future__ import annotations

import csv
import io
import json
import math
import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from hertzwerk.runtime.engine.model.binding import Value
from hertzwerk.runtime.engine.solution.solution import write
from hertzwerk.runtime.system.digests import finite

FORMAT = "<f8"
TEXTS = ("outcome", "message", "warnings")
LOST = "lost"  # outcome of a row whose process died


@dataclass(frozen=True)
class Packed:
    """Array of float64, compressed by zlib: equal where the arrays are, bit by bit."""

    shape: tuple[int, ...]
    data: bytes

    @classmethod
    def of(cls, array: np.ndarray) -> Packed:
        """Compress an array."""
        content = np.ascontiguousarray(array, dtype=FORMAT).tobytes()
        return cls(tuple(array.shape), zlib.compress(content))

    @property
    def array(self) -> np.ndarray:
        """The array."""
        return np.frombuffer(zlib.decompress(self.data), dtype=FORMAT).reshape(self.shape)


@dataclass(frozen=True)
class Row:
    """One run: `stated` values as given, `values` in SI, `outputs` by column; wall_s: integration [s].

    arrays    points as (points, names) by what they are of: "section", "histories"

    Where there is no run, `outcome` is "bad_input", "failed" (by an error of ours) or "lost" (its process died), with
    the reason in `message`.
    """

    index: int
    stated: Mapping[str, Value]
    outcome: str
    message: str = ""
    values: Mapping[str, float] = field(default_factory=dict)
    outputs: Mapping[str, float] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()
    wall_s: float = math.nan
    arrays: Mapping[str, Packed] = field(default_factory=dict)

    def __getitem__(self, name: str) -> float | str:
        """Return the entry of a column."""
        if name in TEXTS:
            return "; ".join(self.warnings) if name == "warnings" else str(getattr(self, name))
        if name == "wall_s":
            return self.wall_s
        entry = self.outputs.get(name, self.values.get(name))
        if entry is None:
            label = self.stated.get(name)
            return label if isinstance(label, str) else math.nan
        return entry

    @property
    def final(self) -> dict[str, float]:
        """States at the end, of those that are columns."""
        return {name[6:]: value for name, value in self.outputs.items() if name.startswith("final.")}


class Arrays:
    """Histories of every row at times of its own; `arrays["guide.travel"]` has an array (points,) each.

    name    "section" or "histories"
    units    SI unit text by name, "t" the first
    varied    SI unit text of what was varied
    """

    def __init__(
        self, name: str, scene: str, units: Mapping[str, str], varied: Mapping[str, str], rows: Sequence[Row]
    ) -> None:
        self.name, self.scene, self.units, self.varied = name, scene, units, varied
        self._rows = rows

    def __repr__(self) -> str:
        return f"<{self.name} of {self.scene}: {self.points:,} points in {len(self):,} rows of {', '.join(self.units)}>"

    @property
    def points(self) -> int:
        """Number of points of all rows."""
        return sum(row.arrays[self.name].shape[0] for row in self._rows if self.name in row.arrays)

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[dict[str, np.ndarray]]:
        return map(self.of, self._rows)

    def __getitem__(self, name: str) -> list[np.ndarray]:
        if name not in self.units:
            raise KeyError(f"no array {name!r}; there are {', '.join(self.units)}")
        column = list(self.units).index(name)
        return [self._table(row)[:, column] for row in self._rows]

    def of(self, row: Row) -> dict[str, np.ndarray]:
        """Return the arrays (points,) of a row by name; of a row without a run they are empty."""
        return dict(zip(self.units, self._table(row).T, strict=True))

    def _table(self, row: Row) -> np.ndarray:
        """Return the points of a row as (points, names)."""
        packed = row.arrays.get(self.name)
        return np.zeros((0, len(self.units))) if packed is None else packed.array

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write a line per point with number and varied values of its row, headed `name [unit]`, SI.

        Raises FileExistsError.
        """
        return write(path, self._csv(), overwrite=overwrite)

    def _csv(self) -> Iterator[bytes]:
        """Yield the lines, those of a row at a time."""
        text = io.StringIO()
        columns = (*self.varied.items(), *self.units.items())
        heads = (f"{name} [{unit}]" if unit else name for name, unit in columns)
        csv.writer(text, lineterminator="\n").writerow(["row", *heads])
        yield text.getvalue().encode()
        for row in self._rows:
            line, lines = io.StringIO(), io.StringIO()
            entries = (row[name] for name in self.varied)
            fields = [row.index, *(e if isinstance(e, str) else format(e, ".17g") for e in entries)]
            csv.writer(line, lineterminator=",").writerow(fields)
            np.savetxt(lines, self._table(row), delimiter=",", fmt="%.17g")
            yield "".join(f"{line.getvalue()}{each}\n" for each in lines.getvalue().splitlines()).encode()

    def csv_size(self) -> int:
        """Estimate the size [bytes] of the file that `to_csv` would write."""
        return self.points * NUMBER * (1 + len(self.varied) + len(self.units))

    def to_json(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write scene, units, and the values and arrays of every row as JSON; raises FileExistsError."""
        return write(path, (json.dumps(self.record()) + "\n").encode(), overwrite=overwrite)

    def record(self) -> dict[str, Any]:
        """Return everything as plain data, null for what is no number."""
        return {
            "scene": self.scene,
            "kind": self.name,
            "units": {**self.varied, **self.units},
            "rows": [
                {
                    "row": row.index,
                    "outcome": row.outcome,
                    "values": finite({name: row[name] for name in self.varied}),
                    "arrays": {name: finite(array.tolist()) for name, array in self.of(row).items()},
                }
                for row in self._rows
            ],
        }


NUMBER = 20  # bytes of one in CSV, about
