"""Row of a sweep, and its arrays as they are kept: compressed, in memory and in a store."""

from __future__ import annotations

import math
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from hertzwerk.runtime.engine.model.binding import Value

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
