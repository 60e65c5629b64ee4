"""Signals: values of inputs over time, as polynomials piece by piece, and when each piece begins."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from hertzwerk.runtime.system.lazy import cached_property

DEGREE = 5  # of the pieces, as generated modules have them
WIDTH = DEGREE + 2  # entries of c for each input: when its piece begins [s], and the coefficients of rising powers


@dataclass(frozen=True, eq=False)
class Signal:
    """Value of an input over time, SI: from begins[i] on the sum of coefficients[i, k] (t - begins[i])^k.

    begins, coefficients    shapes (n,) and (n, 6); a piece holds until the next begins, from its first instant on
    end    [s], up to which it is known; inf for a constant
    text    what it was made of, for people
    smooth    derivatives that are continuous from piece to piece, -1 where the value itself may jump
    """

    begins: np.ndarray
    coefficients: np.ndarray
    end: float
    text: str
    smooth: int = -1

    @cached_property
    def digest(self) -> str:
        """Digest of the values."""
        data = (self.begins, self.coefficients, np.array([self.end]))
        return hashlib.sha256(b"".join(np.ascontiguousarray(part, dtype=float).tobytes() for part in data)).hexdigest()

    def pieces(self, times: np.ndarray) -> np.ndarray:
        """Return the piece that holds from each time on, shape (n, WIDTH)."""
        index = np.maximum(np.searchsorted(self.begins, times, side="right") - 1, 0)
        return np.column_stack([self.begins[index], self.coefficients[index]])

    def scaled(self, factor: float) -> Signal:
        """Return the signal times a factor."""
        return Signal(self.begins, factor * self.coefficients, self.end, f"{factor:g} x {self.text}", self.smooth)

    def __call__(self, times: np.ndarray) -> np.ndarray:
        """Return the values at times [s]; where it jumps those after the jump."""
        begin, *factors = self.pieces(np.asarray(times, dtype=float)).T
        since, value = times - begin, np.zeros(len(begin))
        for factor in reversed(factors):
            value = factor + since * value
        return value


def constant(value: float, text: str) -> Signal:
    """Return the signal that has one value [SI] for ever."""
    return Signal(np.zeros(1), np.array([[value, *[0.0] * DEGREE]]), np.inf, text, DEGREE)


class Schedule:
    """Pieces of all inputs of a run in their order, and the times at which steps end because a piece does.

    stops    [s], shape (n,): when the pieces of a row begin; pieces: shape (n, inputs WIDTH)
    """

    def __init__(self, signals: Sequence[Signal]) -> None:
        self.stops = np.unique(np.concatenate([np.zeros(1), *(s.begins[s.begins > 0] for s in signals)]))
        self.pieces = np.hstack([signal.pieces(self.stops) for signal in signals])

    def place(self, t: float) -> int:
        """Return the row of the pieces that hold from a time [s] on."""
        return max(int(np.searchsorted(self.stops, t, side="right")) - 1, 0)

    def stop(self, place: int, t_end: float) -> float:
        """Return when steps under the pieces of a row end [s]."""
        return min(float(self.stops[place + 1]), t_end) if place + 1 < len(self.stops) else t_end


def digest_of(signals: Mapping[str, Signal]) -> str:
    """Digest of the values of all inputs; empty without any."""
    parts = [f"{name} {signals[name].digest} " for name in sorted(signals)]
    return hashlib.sha256("".join(parts).encode()).hexdigest() if parts else ""
