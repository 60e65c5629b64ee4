"""Growth of errors along a run, and how long a trajectory therefore stays valid.

Errors of a few runs against a reference are a system's response to small disturbances: while small they all grow by
the same factors, estimated from all runs. The factor of each interval shows where they grow: at impacts, at unstable
positions. The trend over the whole run is exponential (errors double in a fixed time), a power (they double when the
time does), or none: friction also removes errors.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.engine.accuracy.error_estimate import VALID

Array = NDArray[np.float64]

INTERVALS = 12  # of a run
SAMPLES = 20  # of a growth that is known, in each
FEWEST = 4  # intervals that show growth, or none
ABOVE = 3.0  # times the floor: larger errors are the run's own, not the reference's
SATURATED = 0.1  # in the scales: larger errors no longer grow linearly
SURE = 2.0  # standard errors by which a growth differs from none
NOTICED = 2.0  # growth over the whole run by less than this factor is none


@dataclass(frozen=True)
class Growth:
    """Growth law of a run's error.

    kind        "exponential": e^(rate t); "power": t^exponent; "none": no growth, or decay; "unknown": all errors lie at the floor
    rate        [1/s], of the best exponential; negative where errors decay
    deviation   its standard error [1/s]
    exponent    of the best power of time
    edges       of the intervals [s], shape (intervals + 1,)
    factors     from each interval to the next; nan where no run shows one
    """

    kind: Literal["exponential", "power", "none", "unknown"]
    rate: float
    deviation: float
    exponent: float
    edges: tuple[float, ...]
    factors: tuple[float, ...]

    @property
    def end(self) -> float:
        """End of the intervals [s]."""
        return self.edges[-1]

    @property
    def intermittent(self) -> bool:
        """Return whether a quarter of the intervals causes more than the whole growth.

        The others then reverse some of it or add nothing.
        """
        known = sorted((math.log(f) for f in self.factors if math.isfinite(f) and f > 0), reverse=True)
        most = known[: max(1, len(known) // 4)]
        return len(known) >= FEWEST and sum(most) > max(sum(known), math.log(NOTICED))

    def reaches(self, error: float, limit: float = VALID) -> float:
        """Return the time [s] at which an error, given at the run's end, reaches the limit.

        Infinite where errors do not grow, nan where that is unknown.
        """
        if self.kind == "unknown":
            return math.nan
        if self.kind == "none" or error <= 0:
            return math.inf
        if self.kind == "exponential":
            return self.end + math.log(limit / error) / self.rate
        return float(np.exp(min(math.log(self.end) + math.log(limit / error) / self.exponent, 700.0)))

    @property
    def gained(self) -> float:
        """Return the time [s] by which ten times more accuracy extends a horizon at the end of the run.

        Infinite where errors do not grow, nan where that is unknown.
        """
        return self.reaches(VALID / 10) - self.end


def growth(t: Array, errors: Sequence[Array], floors: Sequence[Array]) -> Growth:
    """Fit the growth of errors of several runs, each (n,), over t [s], which begins with the run.

    floors (n,): level of each below which an error means nothing. An interval counts for a run from where its error
    first exceeds the floor; later errors below it count as the floor. Saturated errors and all after them are left
    out.
    """
    edges = np.linspace(t[0], t[-1], INTERVALS + 1)
    index = np.clip(np.searchsorted(edges, t, side="right") - 1, 0, INTERVALS - 1)
    pairs = zip(errors, floors, strict=True)
    levels = np.array([_levels(error, floor, index) for error, floor in pairs]).reshape(len(errors), INTERVALS)
    steps = np.diff(levels, axis=1)
    known = np.any(np.isfinite(steps), axis=0)
    steps = np.array([np.median(s[np.isfinite(s)]) if k else np.nan for s, k in zip(steps.T, known, strict=True)])
    return _law(edges, steps)


def growth_law(t: Array, growth: Array) -> Growth:
    """Fit the law of a growth whose logarithm (n,) over t [s] is known, as that of a small change."""
    edges = np.linspace(t[0], t[-1], INTERVALS + 1)
    with np.errstate(invalid="ignore"):
        levels = np.median(np.interp(_within(edges), t, growth), axis=1)
        steps = np.diff(levels)
    return _law(edges, np.where(np.isfinite(steps), steps, np.nan))


def _within(edges: Array) -> Array:
    """Return times (intervals, samples) within intervals."""
    parts = (np.arange(SAMPLES) + 0.5) / SAMPLES
    return edges[:-1, None] + np.diff(edges)[:, None] * parts


def _law(edges: Array, steps: Array) -> Growth:
    """Fit the law of a growth by the logarithms (intervals - 1,) of its factors; nan where unknown."""
    known = np.isfinite(steps)
    edge = tuple(float(x) for x in edges)
    factors = tuple(float(x) for x in np.exp(steps))
    first, last = _longest(known)
    if last - first + 1 < FEWEST:
        return Growth("unknown", math.nan, math.nan, math.nan, edge, factors)
    level = np.concatenate([[0.0], np.cumsum(steps[first:last])])
    middle = (edges[:-1] + edges[1:])[first : last + 1] / 2 - edges[0]
    rate, deviation, miss = _line(middle, level)
    exponent, spread, miss_of_power = _line(np.log(middle), level)
    span = float(middle[-1] - middle[0])
    if miss <= miss_of_power:
        grows, kind = rate > SURE * deviation, "exponential"
    else:
        grows, kind = exponent > SURE * spread, "power"
    if not (grows and rate * span > math.log(NOTICED)):
        kind = "none"
    return Growth(kind, rate, deviation, exponent, edge, factors)  # type: ignore[arg-type]


def crossing(t: Array, error: Array, limit: float = VALID) -> float:
    """Return the time [s] at which an error (n,) over t leaves a limit; infinite if it never does.

    Interpolated between samples in the error's logarithm.
    """
    over = np.flatnonzero(~(error <= limit))
    if not len(over):
        return math.inf
    i = int(over[0])
    if i == 0:
        return float(t[0])
    before, after = float(error[i - 1]), float(error[i])
    part = math.log(limit / before) / math.log(after / before) if before > 0 and math.isfinite(after) else 0.0
    return float(t[i - 1] + part * (t[i] - t[i - 1]))


def _levels(error: Array, floor: Array, index: NDArray[np.intp]) -> Array:
    """Return the logarithm of the typical error of each interval.

    nan before the error exceeds the floor, and from where it saturates.
    """
    levels = np.full(INTERVALS, np.nan)
    risen = False
    for k in range(INTERVALS):
        here = index == k
        if not np.any(here):
            continue
        typical, least = float(np.median(error[here])), ABOVE * float(np.median(floor[here]))
        if not typical <= SATURATED:
            break
        risen = risen or typical > least
        if risen and max(typical, least) > 0:
            levels[k] = math.log(max(typical, least))
    return levels


def _longest(known: NDArray[np.bool_]) -> tuple[int, int]:
    """Return the longest run of true entries: first, last (exclusive)."""
    ends = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]])))
    stretches = [(int(a), int(b)) for a, b in zip(ends[::2], ends[1::2], strict=True)]
    return max(stretches, key=lambda s: s[1] - s[0], default=(0, 0))


def _line(x: Array, y: Array) -> tuple[float, float, float]:
    """Fit a straight line; return its slope, the slope's standard error, the sum of squared residuals."""
    dx, dy = x - np.mean(x), y - np.mean(y)
    square = float(dx @ dx)
    slope = float(dx @ dy) / square
    miss = float(np.sum((dy - slope * dx) ** 2))
    return slope, math.sqrt(miss / (len(x) - 2) / square), miss
