"""Histories of a run as an instrument sees them, at any times within it.

A run is integrated between its steps, by Gauss's rule on every piece between steps and cells, and a filter works on
the means over equal cells: however short an impact is, its impulse is in them, and nothing aliases.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.solution import Solution
    from hertzwerk.runtime.studies.comparison.instrument import Instrument

Array = NDArray[np.float64]

NODES, WEIGHTS = np.polynomial.legendre.leggauss(3)
BLOCK = 50_000  # pieces evaluated at once
MOST = 5_000_000  # cells of a run


class SeenRun:
    """Histories of a run behind an instrument (None: as they are), known from `start` to `end` [s].

    t, values    centres (m,) of cells `spacing` [s] long, and what is seen there, shape (m, names)
    """

    def __init__(self, run: Solution, names: Sequence[str], instrument: Instrument | None, spacing: float) -> None:
        self._run, self._names, self._instrument = run, tuple(names), instrument
        self.spacing = spacing if instrument is None else instrument.spacing
        settling = 0.0 if instrument is None else instrument.settling
        ends = settling if instrument is not None and instrument.zero_phase else 0.0
        self.start, self.end = float(run.t[0]) + settling, float(run.t[-1]) - ends
        count = int((run.t[-1] - run.t[0]) / self.spacing)
        if count > MOST:
            found = f"a run of {run.t[-1]:g} s, that takes {count:.3g} samples behind this instrument"
            raise InputError("bandwidth", [Fault("bandwidth", found, f"at most {MOST:.3g}", "a shorter run")])
        edges = run.t[0] + self.spacing * np.arange(count + 1)
        self.t: Array = (edges[:-1] + edges[1:]) / 2
        self._edges: Array = edges

    @cached_property
    def values(self) -> Array:
        """Means over the cells behind the instrument, shape (m, names)."""
        means, instrument = self._means(self._edges), self._instrument
        if instrument is not None and len(means) > 3 * (2 * instrument.order + 1):
            return instrument.filtered(means, self.spacing)
        return means

    def at(self, times: Array) -> Array:
        """Return what is seen at times [s] from `start` to `end`, shape (n, names)."""
        if self._instrument is None:
            history = self._run.at(times)
            return np.column_stack([history[name] for name in self._names])
        return np.asarray(self._spline(times))

    @cached_property
    def _spline(self) -> Callable[[Array], Array]:
        from scipy.interpolate import CubicSpline  # slow to import

        return CubicSpline(self.t, self.values)  # type: ignore[no-any-return]

    def _means(self, edges: Array) -> Array:
        """Return the means over cells between edges (m + 1,), shape (m, names)."""
        steps = self._run.t[(self._run.t > edges[0]) & (self._run.t < edges[-1])]
        nodes = np.unique(np.concatenate([edges, steps]))
        sums = np.zeros((len(edges) - 1, len(self._names)))
        for first in range(0, len(nodes) - 1, BLOCK):
            left, right = nodes[first : first + BLOCK + 1][:-1], nodes[first + 1 : first + BLOCK + 1]
            half = (right - left) / 2
            history = self._run.at(((left + half)[:, None] + half[:, None] * NODES).ravel())
            cell = np.searchsorted(edges, left, side="right") - 1
            for k, name in enumerate(self._names):
                parts = half * (history[name].reshape(-1, len(NODES)) @ WEIGHTS)
                sums[:, k] += np.bincount(cell, parts, len(sums))
        return sums / np.diff(edges)[:, None]
