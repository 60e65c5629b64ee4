"""Ratios of medians that were measured side by side, and how they are printed."""

from __future__ import annotations

import gc
import time
from collections.abc import Callable, Sequence
from statistics import median
from typing import NamedTuple

REPEATS = 7

Measurement = Callable[[], float]  # makes one measurement and returns its result [s]


class Ratio(NamedTuple):
    """One line of the report: two medians, of times [s] or of `unit`, and what their ratio should be."""

    what: str
    first: float
    second: float
    wanted: str = ""  # such as "<= 5"
    note: str = ""
    unit: str = "s"

    def __str__(self) -> str:
        ratio = self.first / self.second
        written = seconds if self.unit == "s" else lambda number: f"{number:,.0f} {self.unit}"
        both = f"{written(self.first):>11} / {written(self.second):>11}"
        return f"  {self.what:<66} {ratio:>8.2f}  {self.wanted:>6}  {self.verdict:<6}  {both}  {self.note}".rstrip()

    @property
    def verdict(self) -> str:
        """Whether the ratio is as wanted; empty where nothing is."""
        if not self.wanted:
            return ""
        sign, bound = self.wanted.split()
        ratio = self.first / self.second
        return "kept" if (ratio <= float(bound) if sign == "<=" else ratio >= float(bound)) else "MISSED"


def seconds(time: float) -> str:
    """A time in a unit that suits it."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if time >= size:
            return f"{time / size:.3g} {unit}"
    return f"{time * 1e9:.3g} ns"


def timed(action: Callable[[], object]) -> Measurement:
    """The measurement of one call of an action."""

    def measure() -> float:
        gc.collect()
        begin = time.perf_counter()
        action()
        return time.perf_counter() - begin

    return measure


def hot(action: Callable[[], object], calls: int = 25, warm: int = 5) -> Measurement:
    """The measurement of an action that is called over and over: the median of several calls after some that do not count.

    Processor time of this thread, as the hand-written programs take it: what else the machine does counts on neither side.
    """

    def measure() -> float:
        gc.collect()
        for _ in range(warm):
            action()
        found = []
        for _ in range(calls):
            begin = time.thread_time()
            action()
            found.append(time.thread_time() - begin)
        return median(found)

    return measure


def medians(*measurements: Measurement, repeats: int = REPEATS) -> list[float]:
    """Median of each measurement [s], taken in turn so that a busy moment hits all."""
    rounds = [[measure() for measure in measurements] for _ in range(repeats)]
    return [median(column) for column in zip(*rounds, strict=True)]


def decades(first: int, last: int, steps: int) -> Sequence[float]:
    """Tolerances 10^-first, ..., 10^-last, so many to a decade."""
    return tuple(10 ** (-k / steps) for k in range(first * steps, last * steps + 1))
