"""Series over time as signals of an input: samples, and functions of time, which are sampled.

A run cannot call a Python function within its steps, which are compiled; called between them its value would be held,
an error of first order. So it is sampled before: each piece interpolates six values and is compared with the function
at others. Where a piece has shrunk to nothing the function jumps: the pieces beside it end there, to rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Literal

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.derive.common.identifiers import unit_faults
from hertzwerk.derive.common.units import Unit, parse_unit
from hertzwerk.runtime.engine.model.signal import DEGREE, Signal

BETWEEN = ("linear", "held", "cubic")


@dataclass(frozen=True, eq=False)
class Samples:
    """Values of an input at increasing times, in `units` of a time and of a value.

    between    "linear": straight from sample to sample; "held": each value holds until the next sample, where it jumps, the last one for as
               long as the one before; "cubic": the spline through them with two continuous derivatives (not-a-knot)
    source     where they are from, for people
    """

    times: Any
    values: Any
    units: tuple[str, str]
    between: Literal["linear", "held", "cubic"] = "linear"
    source: str = ""

    def signal(self) -> Signal:
        """Return the signal of samples without faults."""
        t, v = (
            np.array([unit.to_si(float(x)) for x in part]) for unit, part in zip(self._units, self._arrays, strict=True)
        )
        text = f"{self.source or 'samples'}: {len(t)} values, {self.between}"
        if self.between == "held":
            changes = np.concatenate([[True], v[1:] != v[:-1]])  # one that stays ends no step
            begins, coefficients, end = t[changes], _raised(v[changes, None]), t[-1] + (t[-1] - t[-2])
            smooth = -1
        elif self.between == "linear" or len(t) < 3:
            begins, coefficients, end = t[:-1], _raised(np.column_stack([v[:-1], np.diff(v) / np.diff(t)])), t[-1]
            smooth = 0
        else:
            from scipy.interpolate import CubicSpline

            begins, coefficients, end = t[:-1], _raised(CubicSpline(t, v).c[::-1].T), t[-1]
            smooth = 2
        return Signal(begins, coefficients, float(end), text, smooth if len(begins) > 1 else DEGREE)

    @property
    def _arrays(self) -> tuple[np.ndarray, np.ndarray]:
        return np.asarray(self.times, dtype=float), np.asarray(self.values, dtype=float)

    @property
    def _units(self) -> tuple[Unit, Unit]:
        time, value = map(parse_unit, self.units)
        return time, value

    def faults(self, where: str) -> Iterator[Fault]:
        """Yield the faults of the samples; their reader checks the unit."""
        if self.between not in BETWEEN:
            yield Fault(where, f"between {shown(self.between)}", f"one of {', '.join(BETWEEN)}")
        if not isinstance(self.units, tuple | list) or len(self.units) != 2:
            yield Fault(where, f"units {shown(self.units)}", 'two, of a time and of a value, such as ("ms", "N m")')
        for unit in self.units if isinstance(self.units, tuple | list) else ():
            yield from unit_faults(where, unit)
        try:
            t, v = self._arrays
        except (TypeError, ValueError):
            yield Fault(where, f"{shown(self.times)} and {shown(self.values)}", "an array of times and one of values")
            return
        if t.ndim != 1 or t.shape != v.shape or t.size < 2:
            yield Fault(
                where, f"times of shape {t.shape} and values of shape {v.shape}", "as many values as times, two or more"
            )
            return
        for kind, array in (("time", t), ("value", v)):
            strange = np.flatnonzero(~np.isfinite(array))
            if strange.size:
                actual = f"the {kind} {array[strange[0]]} in place {strange[0] + 1}"
                yield Fault(where, actual, "finite numbers", "omit missing samples")
                return
        falls = np.flatnonzero(np.diff(t) <= 0)
        if falls.size:
            k = int(falls[0])
            actual = f"the time {t[k + 1]:g} after {t[k]:g} in place {k + 2}, and {falls.size - 1} more like it"
            yield Fault(
                where, actual, "times that increase", "sort the samples by time; omit one of two at the same time"
            )


def _raised(coefficients: np.ndarray) -> np.ndarray:
    """Return coefficients (n, few) as those of the degree of all pieces, (n, 6)."""
    whole = np.zeros((len(coefficients), DEGREE + 1))
    whole[:, : coefficients.shape[1]] = coefficients
    return whole


# -- functions of time, sampled ------------------------------------------------------------------------------------------

ACCURACY = 1e-10  # of the largest value: largest difference from the function, at the points where they are compared
FIRST = 64  # pieces before any is halved: what is shorter than a hundredth of the run may go unseen
MOST = 200_000  # pieces that are tried
JUMP = 1e-13  # of the run: length of a piece that is a jump
ADJACENT = 16  # most such pieces side by side: more are noise
SHRUNK = 1e-5  # of the run: shorter pieces than this are about a kink
LEFT_OPEN = (
    4 * DEGREE**2,
    4 * DEGREE**2 * (DEGREE**2 - 1) / 3,
)  # Markov: derivatives at the ends of twice both errors, 2/h at a time
SAME = 1e-6  # of the largest derivative
NODES = (1 - np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)) / 2
WITHIN = np.array([0.003, 0.04, 0.19, 0.27, 0.42, 0.58, 0.77, 0.83, 0.96, 0.997])
INVERSE = np.linalg.inv(np.vander(NODES, increasing=True))
POWERS = np.vander(WITHIN, DEGREE + 1, increasing=True)


class Unresolved(Exception):
    """A function that cannot be sampled, with what was found of it and the way out."""

    def __init__(self, problem: str, remedy: str) -> None:
        super().__init__(problem)
        self.found, self.remedy = problem, remedy


def sampled(function: Callable[[float], float], seconds: float, text: str) -> Signal:
    """Return a function [SI] of the time [s] as a signal from 0 to `seconds`; raises Unresolved."""
    sampler = _Sampler(function, seconds)
    begins, rows, jumps = sampler.pieces(0.0, seconds)
    if jumps:  # anew from jump to jump, so that no piece is short for one
        spans = zip([0.0, *(b for _, b in jumps)], [*(a for a, _ in jumps), seconds], strict=True)
        parts = [sampler.pieces(a, b) for a, b in spans if b > a]
        begins, rows = [x for part in parts for x in part[0]], [x for part in parts for x in part[1]]
        for _, _, others in parts:
            if others:
                raise sampler.unresolved(*others[0])
    times, coefficients = np.array(begins), np.array(rows)
    smooth = -1 if jumps else _smooth(times, coefficients, seconds)
    return Signal(times, coefficients, seconds, f"{text}, sampled in {len(rows)} pieces", smooth)


def _smooth(begins: np.ndarray, rows: np.ndarray, seconds: float) -> int:
    """Return how many derivatives are continuous, 2 at most, as far as pieces show.

    Pieces shrink to a kink that lies within one; at one that lies between two the derivatives differ by more than what
    an interpolation to ACCURACY leaves open.
    """
    lengths = np.diff(np.append(begins, seconds))
    if lengths.min() < SHRUNK * seconds:
        return 0
    size = float(np.max(np.abs(rows[:, 0])))
    for order in (1, 2):
        since = lengths[:-1, None] ** np.arange(DEGREE + 1 - order)
        factors = np.array([math.perm(k, order) for k in range(order, DEGREE + 1)])
        before = np.sum(rows[:-1, order:] * factors * since, axis=1)
        open_by = LEFT_OPEN[order - 1] * ACCURACY * size / np.minimum(lengths[:-1], lengths[1:]) ** order
        largest = math.factorial(order) * float(np.max(np.abs(rows[:, order])))
        if np.any(np.abs(math.factorial(order) * rows[1:, order] - before) > open_by + SAME * largest):
            return order - 1
    return 2


class _Sampler:
    """Function that is sampled, the largest value seen, and how many pieces were tried."""

    def __init__(self, function: Callable[[float], float], seconds: float) -> None:
        self._function, self._seconds, self._tried = function, seconds, 0
        self._size = float(np.max(np.abs(self._at(np.linspace(0.0, seconds, FIRST + 1)))))

    def pieces(self, start: float, end: float) -> tuple[list[float], list[np.ndarray], list[tuple[float, float]]]:
        """Return begins and coefficients of the pieces from start to end, and the spans that hold a jump."""
        count = max(int(np.ceil(FIRST * (end - start) / self._seconds)), 1)
        grid = np.linspace(start, end, count + 1)
        waiting = list(pairwise(grid))[::-1]
        begins: list[float] = []
        rows: list[np.ndarray] = []
        jumps: list[tuple[float, float]] = []
        while waiting:
            a, b = map(float, waiting.pop())
            h, self._tried = b - a, self._tried + 1
            if self._tried > MOST:
                raise self.unresolved(a, b)
            values, between = self._at(a + h * NODES), self._at(a + h * WITHIN)
            self._size = max(self._size, float(np.max(np.abs(values))))
            scaled = INVERSE @ values
            if np.max(np.abs(POWERS @ scaled - between)) <= ACCURACY * self._size:
                begins.append(a)
                rows.append(scaled / h ** np.arange(DEGREE + 1))
            elif h > JUMP * self._seconds:
                waiting += [((a + b) / 2, b), (a, (a + b) / 2)]
            elif jumps and a - jumps[-1][1] <= JUMP * self._seconds:
                jumps[-1] = (jumps[-1][0], b)
                if b - jumps[-1][0] > ADJACENT * JUMP * self._seconds:
                    raise self.unresolved(a, b)
            else:
                jumps.append((a, b))
        return begins, rows, jumps

    def unresolved(self, a: float, b: float) -> Unresolved:
        """Return the error of a span in which pieces, however short, miss the function."""
        return Unresolved(f"a function that pieces of {b - a:.2g} s do not resolve at t = {a:g} s",
                          'supply a noisy or often jumping input as samples: Samples(times, values, units, "held")')  # fmt: skip

    def _at(self, times: np.ndarray) -> np.ndarray:
        return np.array([_value(self._function, float(t)) for t in times])


def _value(function: Callable[[float], float], t: float) -> float:
    try:
        value = float(function(t))
    except Exception as error:
        raise Unresolved(
            f"{type(error).__name__} at t = {t:g} s: {error}", "it is called with the time in seconds"
        ) from error
    if not np.isfinite(value):
        raise Unresolved(f"{value} at t = {t:g} s", "it must be finite over the whole run")
    return value


def fault_of(where: str, error: Unresolved, unit: str) -> Fault:
    """Return the fault of a function that could not be sampled."""
    return Fault(
        where, shown(error.found)[1:-1], f"a function of the time [s] that returns the value [{unit}]", error.remedy
    )
