"""Table of a sweep as its pictures see it: values in the units they were given in."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.pictures.prefixes import Scale, scale_of

Array = NDArray[np.float64]

SAME_RATIO = 1e-6  # relative: values of such equal ratios are on a logarithmic scale
LEAST_SPAN = 4.0  # largest over smallest value, from which they are


class ArraysByRow(Protocol):
    """Arrays of every row by name."""

    @property
    def units(self) -> Mapping[str, str]:
        """SI unit text by name, the time first."""

    def __getitem__(self, name: str) -> list[np.ndarray]: ...


class SweptTable(Protocol):
    """Table of a sweep, by column."""

    @property
    def scene(self) -> str:
        """Name of the scene."""

    @property
    def rows(self) -> Sequence[Any]:
        """Rows, with the values that were `given` and the `outcome`."""

    @property
    def columns(self) -> Mapping[str, str]:
        """SI unit text by name."""

    @property
    def varied(self) -> Sequence[str]:
        """Columns that were varied."""

    @property
    def axes(self) -> Mapping[str, Sequence[float | str]]:
        """Values of what was varied where all combinations were run, else empty."""

    @property
    def arrays(self) -> Mapping[str, Mapping[str, str]]:
        """Unit text of arrays by what they are of."""

    @property
    def place(self) -> str:
        """Where arrays were kept."""

    def arrays_of(self, name: str) -> ArraysByRow:
        """Return the arrays of what they are of."""

    def __getitem__(self, name: str) -> np.ndarray: ...


@dataclass(frozen=True)
class Varied:
    """Values (rows,) of one name in the unit they are shown in; `log`: they have equal ratios.

    labels    of an input whose rows choose by label: `values` are places among them
    """

    name: str
    unit: str
    values: Array
    log: bool
    labels: tuple[str, ...] = ()

    @property
    def distinct(self) -> Array:
        """Values without repetition, in order."""
        return np.unique(self.values[np.isfinite(self.values)])

    @property
    def label(self) -> str:
        """Text beside an axis."""
        return labelled(self.name, self.unit)

    def text(self, value: float) -> str:
        """Return one value with its unit."""
        if self.labels:
            return f"{self.name} = {self.labels[int(value)]}"
        return f"{self.name} = {value:.6g} {self.unit}".rstrip()


def varied(table: SweptTable, name: str) -> Varied:
    """Return the values of a name in the unit they were given in, else in one that fits."""
    column = table[name]
    if column.dtype.kind == "U":
        labels = tuple(dict.fromkeys(column.tolist()))
        return Varied(name, "", np.array([float(labels.index(label)) for label in column]), log=False, labels=labels)
    given = [row.given.get(name) for row in table.rows]
    units = {value[1] for value in given if isinstance(value, tuple)}
    if len(units) == 1 and all(isinstance(value, tuple) for value in given):
        (unit,), values = units, np.array([float(value[0]) for value in given])
        unit = "" if unit == "1" else unit
    else:
        scale = shown_in(table.columns[name], table[name])
        unit, values = scale.unit, scale(table[name])
    return Varied(name, unit, values, _has_equal_ratios(values))


def _has_equal_ratios(values: Array) -> bool:
    distinct = np.unique(values[np.isfinite(values)])
    if len(distinct) < 3 or distinct[0] <= 0 or distinct[-1] < LEAST_SPAN * distinct[0]:
        return False
    steps = np.diff(np.log(distinct))
    return bool(np.ptp(steps) <= SAME_RATIO * steps.max())


def shown_in(unit: str, values: Array) -> Scale:
    """Return the unit to show values in; 1 for numbers."""
    finite = np.asarray(values, dtype=float)
    finite = finite[np.isfinite(finite)]
    return scale_of(unit, finite if len(finite) else np.zeros(1))


def labelled(name: str, unit: str) -> str:
    """Return a name with its unit."""
    return f"{name} [{unit}]" if unit else name
