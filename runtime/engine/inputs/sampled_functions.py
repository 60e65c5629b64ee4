"""Functions of time as signals: quintics through their values, on spans halved until they agree.

A run cannot call a Python function within its steps, which are compiled; called between them its value would be held,
an error of first order. So it is sampled before: each piece interpolates six values and is compared with the function
at others. Where a piece has shrunk to nothing the function jumps: the pieces beside it end there, to rounding.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from hertzwerk.derive.common.faults import Fault, shown
from hertzwerk.runtime.engine.model.signal import DEGREE, Signal

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
BETWEEN = np.array([0.003, 0.04, 0.19, 0.27, 0.42, 0.58, 0.77, 0.83, 0.96, 0.997])
INVERSE = np.linalg.inv(np.vander(NODES, increasing=True))
POWERS = np.vander(BETWEEN, DEGREE + 1, increasing=True)


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
            values, between = self._at(a + h * NODES), self._at(a + h * BETWEEN)
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
