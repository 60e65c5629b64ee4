"""Axes of a sweep's picture: varied values in the units given, and as many as a person can see."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.output.plots.unit_prefixes import Scale, scale_of
from hertzwerk.runtime.system.arrays import Array

SAME_RATIO = 1e-6  # relative: values of such equal ratios are on a logarithmic scale
LEAST_SPAN = 4.0  # largest over smallest value, from which they are
PLACES, CELLS, DOTS = (
    2000,
    350,
    20_000,
)  # that are distinguished along a curve, along a side of a map, and of scattered dots


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


def extremes(values: Array, places: int) -> NDArray[np.intp]:
    """Return where a curve (n,) is drawn: everywhere, or at the extremes of each of so many parts."""
    if len(values) <= 2 * places:
        return np.arange(len(values))
    size = -(-len(values) // places)
    parts = np.pad(values, (0, -len(values) % size), constant_values=np.nan).reshape(-1, size)
    begin = size * np.arange(len(parts))
    least = begin + np.where(np.isnan(parts), np.inf, parts).argmin(axis=1)
    largest = begin + np.where(np.isnan(parts), -np.inf, parts).argmax(axis=1)
    return np.unique([least, largest])


def some(values: Array, count: int) -> NDArray[np.intp]:
    """Return where so many of the values (n,) are, spread evenly, the least and the largest among them."""
    if len(values) <= count:
        return np.arange(len(values))
    known = np.flatnonzero(np.isfinite(values))
    ends = known[[values[known].argmin(), values[known].argmax()]] if len(known) else known
    return np.unique([*np.linspace(0, len(values) - 1, count).astype(int), *ends])


def coarse(values: Array, cells: int) -> Array:
    """Return a map (n, m) with so many cells a side at most, each with its value farthest from the median."""
    (down, across) = (-(-n // cells) for n in values.shape)
    if down == across == 1:
        return values
    padded = np.pad(
        values, [(0, -n % k) for n, k in zip(values.shape, (down, across), strict=True)], constant_values=np.nan
    )
    parts = (
        padded.reshape(len(padded) // down, down, -1, across)
        .swapaxes(1, 2)
        .reshape(len(padded) // down, -1, down * across)
    )
    apart = np.abs(parts - np.nanmedian(values))
    place = np.where(np.isnan(apart), -1.0, apart).argmax(axis=2)
    return np.take_along_axis(parts, place[:, :, None], axis=2)[:, :, 0]


def coarse_edges(edges: Array, cells: int) -> Array:
    """Return the edges of the cells of such a map along one side, of those of all of its values."""
    step = -(-(len(edges) - 1) // cells)
    return np.append(edges[:-1:step], edges[-1])


def has_equal_ratios(values: Array) -> bool:
    """Return whether values span LEAST_SPAN in equal ratios."""
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
