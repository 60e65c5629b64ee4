"""Histories of a run as an instrument sees them, at any times within it.

A run is integrated between its steps, by Gauss's rule on every piece between steps and cells, and a filter works on
the means over equal cells: however short an impact is, its impulse is in them, and nothing aliases.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.polynomial.chebyshev import chebpts1, chebval, chebvander
from numpy.typing import NDArray

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.solution.solution import EngineSolution


NODES, WEIGHTS = np.polynomial.legendre.leggauss(3)
BLOCK = 50_000  # pieces evaluated at once
MOST = 5_000_000  # cells of a run
POINTS = chebpts1(12)  # in a step, -1..1: polynomials through them are taken in place of
FEW = 3 * len(POINTS)  # times in a step and more
COEFFICIENTS = np.linalg.inv(
    chebvander(POINTS, len(POINTS) - 1)
).T  # of Chebyshev polynomials, from values at the points
SMOOTH = 1e-10  # of the largest value: last coefficients of a polynomial that is used


class FilteredRun:
    """Histories of a run behind an instrument (None: as they are), known from `start` to `end` [s].

    t, values    centres (m,) of cells `spacing` [s] long, and what is seen there, shape (m, names)
    """

    def __init__(
        self, run: EngineSolution, names: Sequence[str], instrument: Instrument | None, spacing: float
    ) -> None:
        self._run, self._names, self._instrument = run, tuple(names), instrument
        self.spacing = spacing if instrument is None else instrument.spacing
        settling = 0.0 if instrument is None else instrument.settling
        ends = settling if instrument is not None and instrument.zero_phase else 0.0
        self.start, self.end = float(run.t[0]) + settling, float(run.t[-1]) - ends
        count = int((run.t[-1] - run.t[0]) / self.spacing)
        if count > MOST:
            actual = f"a run of {run.t[-1]:g} s, that takes {count:.3g} samples behind this instrument"
            raise InputError("bandwidth", [Fault("bandwidth", actual, f"at most {MOST:.3g}", "a shorter run")])
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
        if self._instrument is not None:
            return np.asarray(self._spline(times))
        step = np.searchsorted(self._run.t, times, side="right") - 1
        used, of = np.flatnonzero(np.bincount(step)), np.cumsum(np.bincount(step) > 0)[step] - 1
        values = np.empty((len(times), len(self._names)))
        rough = np.ones(len(times), dtype=bool)
        if len(times) > FEW * len(used):
            values, rough = self._between(times, used, of)
        if np.any(rough):
            history = self._run.at(times[rough])
            values[rough] = np.column_stack([history[name] for name in self._names])
        return values

    def _between(self, times: Array, used: NDArray[np.intp], of: NDArray[np.intp]) -> tuple[Array, NDArray[np.bool_]]:
        """Return what polynomials through points within steps have at times, and where they are too rough.

        used    steps (k,) that times lie in, and of which time each: `of` (n,)
        """
        begin = self._run.t[used]
        length = self._run.t[np.minimum(used + 1, len(self._run.t) - 1)] - begin
        history = self._run.at((begin[:, None] + length[:, None] * (1 + POINTS) / 2).ravel())
        where = 2 * (times - begin[of]) / np.where(length > 0, length, 1)[of] - 1
        values, rough = np.empty((len(times), len(self._names))), np.zeros(len(times), dtype=bool)
        for k, name in enumerate(self._names):
            parts = history[name].reshape(-1, len(POINTS)) @ COEFFICIENTS
            values[:, k] = chebval(where, parts.T[:, of], tensor=False)
            rough |= (np.abs(parts[:, -2:]).max(axis=1) > SMOOTH * np.abs(parts).max())[of]
        return values, rough

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


# -- instrument ----------------------------------------------------------------------------------------------------------

FORGOTTEN = 1e-3  # part of a start that the filter still remembers after `settling`
PER_PERIOD = 50  # samples of a run in a period of the cut-off frequency: cell means dim it by 0.07 % there
ORDERS = (1, 12)


@dataclass(frozen=True)
class Instrument:
    """Butterworth low-pass: cut-off frequency [1/s], order; forwards alone (causal) or both ways.

    Causal, as amplifiers and filters before a converter are, it is 3 dB down at the cut-off and delays. Forwards and
    backwards, as recorded data are often smoothed, it has no phase, twice the order, and is 6 dB down there.
    """

    cut_off: float
    order: int = 4
    zero_phase: bool = False

    @property
    def spacing(self) -> float:
        """Spacing [s] at which a run is sampled for this filter."""
        return 1 / (PER_PERIOD * self.cut_off)

    @property
    def settling(self) -> float:
        """Time [s] after which a start is forgotten, by the slowest pole."""
        return -math.log(FORGOTTEN) / (2 * math.pi * self.cut_off * math.sin(math.pi / (2 * self.order)))

    def filtered(self, values: Array, spacing: float) -> Array:
        """Return samples (n, signals) at a spacing [s] after the filter; before them they were as the first."""
        from scipy import signal  # slow to import

        sections = signal.butter(self.order, self.cut_off, fs=1 / spacing, output="sos")
        if self.zero_phase:
            return np.asarray(signal.sosfiltfilt(sections, values, axis=0))
        still = signal.sosfilt_zi(sections)[..., None] * values[:1]
        return np.asarray(signal.sosfilt(sections, values, axis=0, zi=still)[0])

    def __str__(self) -> str:
        size, unit = next((f, u) for f, u in ((1e6, "MHz"), (1e3, "kHz"), (1.0, "Hz")) if self.cut_off >= f or f == 1)
        ways = "forwards and backwards, 6 dB down" if self.zero_phase else "causal, 3 dB down"
        return f"Butterworth low-pass of order {self.order}, {ways} at {self.cut_off / size:.4g} {unit}"
