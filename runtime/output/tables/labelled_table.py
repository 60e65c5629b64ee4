"""Tables of named columns with units and meanings, which runs and sweeps hand on to other programs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

EXTRA = "data"  # what other programs' objects need


@dataclass(frozen=True)
class Column:
    """Values (rows,) and their meaning; `unit` is in SI, "" of a plain number, None of texts."""

    values: np.ndarray
    unit: str | None
    meaning: str = ""

    @property
    def about(self) -> dict[str, str]:
        """Unit and meaning by the names that netCDF has for them, those that there are."""
        units = {} if self.unit is None else {"units": self.unit or "1"}
        return {**units, **({"long_name": self.meaning} if self.meaning else {})}


@dataclass(frozen=True)
class Points:
    """Points that every row has of its own, such as a section: of each row an array (points, names).

    units    SI unit text by name, of which the first is the time
    """

    units: Mapping[str, str]
    rows: Sequence[np.ndarray]


@dataclass(frozen=True)
class LabelledTable:
    """Columns by name over an index.

    index    name of the column that numbers or times the rows
    coordinates    names of columns that say where a row stands: what was varied
    grid    values of the coordinates where the rows are all their combinations, the last fastest, and the index is
            the place among those; empty where they are not
    about    what is the same for all rows, by name
    points    points of the rows by what they are of
    """

    index: str
    columns: Mapping[str, Column]
    about: Mapping[str, str | float]
    coordinates: tuple[str, ...] = ()
    grid: Mapping[str, np.ndarray] = field(default_factory=dict)
    points: Mapping[str, Points] = field(default_factory=dict)

    @property
    def data(self) -> dict[str, Column]:
        """Columns but for the index."""
        return {name: column for name, column in self.columns.items() if name != self.index}
