"""Arrays of rows: compressed in memory and in a store, by row and name, as CSV and JSON."""

from __future__ import annotations

import csv
import io
import json
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.runtime.solution.solution import write

if TYPE_CHECKING:
    from hertzwerk.runtime.sweeps.sweep_table import Row, Sweep

FORMAT = "<f8"


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


class Arrays:
    """Histories of every row at times of its own; `arrays["guide.travel"]`: an array (points,) for each, SI.

    name    "section" or "histories"
    units    unit text by name, "t" the first
    """

    def __init__(self, sweep: Sweep, name: str) -> None:
        self.name, self.units = name, sweep.arrays[name]
        self._sweep = sweep

    def __repr__(self) -> str:
        return f"<{self.name} of {self._sweep.scene}: {self.points:,} points in {len(self):,} rows of {', '.join(self.units)}>"

    @property
    def points(self) -> int:
        """Number of points of all rows."""
        return sum(row.arrays[self.name].shape[0] for row in self._sweep if self.name in row.arrays)

    def __len__(self) -> int:
        return len(self._sweep)

    def __iter__(self) -> Iterator[dict[str, np.ndarray]]:
        return map(self.of, self._sweep)

    def __getitem__(self, name: str) -> list[np.ndarray]:
        if name not in self.units:
            raise KeyError(f"no array {name!r}; there are {', '.join(self.units)}")
        column = list(self.units).index(name)
        return [self._table(row)[:, column] for row in self._sweep]

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
        text = io.StringIO()
        varied = {name: self._sweep.unit(name) for name in self._sweep.varied}
        heads = (f"{name} [{unit}]" if unit else name for name, unit in (*varied.items(), *self.units.items()))
        csv.writer(text, lineterminator="\n").writerow(["row", *heads])
        for row in self._sweep:
            before = ",".join([str(row.index), *(format(row[name], ".17g") for name in varied)])
            np.savetxt(text, self._table(row), delimiter=",", fmt=f"{before},%.17g" + ",%.17g" * (len(self.units) - 1))
        return write(Path(path), text.getvalue().encode(), overwrite=overwrite)

    def csv_size(self) -> int:
        """Estimate the size [bytes] of the file that `to_csv` would write."""
        return self.points * NUMBER * (1 + len(self._sweep.varied) + len(self.units))

    def to_json(self, path: str | Path, *, overwrite: bool = False) -> Path:
        """Write scene, units, and the values and arrays of every row as JSON; raises FileExistsError."""
        return write(Path(path), (json.dumps(self.record()) + "\n").encode(), overwrite=overwrite)

    def record(self) -> dict[str, Any]:
        """Return everything as plain data, null for what is no number."""
        sweep = self._sweep
        return {
            "scene": sweep.scene,
            "kind": self.name,
            "units": {**{name: sweep.unit(name) for name in sweep.varied}, **self.units},
            "rows": [
                {
                    "row": row.index,
                    "outcome": row.outcome,
                    "values": _nulled({name: float(row[name]) for name in sweep.varied}),
                    "arrays": {name: _listed(array) for name, array in self.of(row).items()},
                }
                for row in sweep
            ],
        }


NUMBER = 20  # bytes of one in CSV, about


def _listed(array: np.ndarray) -> list[float | None]:
    return [x if np.isfinite(x) else None for x in array.tolist()]


def _nulled(values: Mapping[str, float]) -> dict[str, float | None]:
    return {name: value if np.isfinite(value) else None for name, value in values.items()}
