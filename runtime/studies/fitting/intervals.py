"""Identifiability and confidence intervals of fitted quantities."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.engine.model.free_quantities import Free
from hertzwerk.runtime.studies.fitting.least_squares import Estimate, Search
from hertzwerk.runtime.system.arrays import Array

IDENTIFIED = (
    1.0  # singular value: below, one standard deviation of the combination is more than the scale of the search
)
RANK = 1e-7  # of the largest singular value: below, derivatives are no more than rounding
PART = 0.1  # of a combination: quantities that take a smaller part are not named


@dataclass(frozen=True)
class Identified:
    """Directions on the scale of the search, half a range or a factor of e, the best identified first.

    singular_values    (k,), each 1 over the standard deviation of its direction, a column of directions (k, k)
    identified         (k,) whether the data identify it
    """

    free: tuple[Free, ...]
    singular_values: Array
    directions: Array
    identified: NDArray[np.bool_]

    @property
    def covariance(self) -> Array:
        """Covariance of the places on the scale of the search, of what is identified (k, k)."""
        v, s = self.directions[:, self.identified], self.singular_values[self.identified]
        return (v / s**2) @ v.T

    @property
    def correlation(self) -> Array:
        """Correlation of the estimates (k, k); nan beside one of an unidentifiable combination."""
        covariance = self.covariance
        sizes = np.array([math.nan if self.concerned(j) else math.sqrt(v) for j, v in enumerate(np.diag(covariance))])
        return covariance / np.outer(sizes, sizes)

    def concerned(self, j: int) -> bool:
        """Return whether a quantity takes part in an unidentifiable combination."""
        return bool(np.any(np.abs(self.directions[j, ~self.identified]) > PART))

    def unidentified(self, values: Sequence[float], quantities: int) -> list[str]:
        """Return the combinations that the data do not identify, in words.

        Those of nuisance alone, after the first `quantities` of what is free, are left out.
        """
        return [
            self._combination(int(k), values)
            for k in np.flatnonzero(~self.identified)
            if np.max(np.abs(self.directions[:quantities, k])) > PART
        ]

    def _combination(self, k: int, values: Sequence[float]) -> str:
        direction = self.directions[:, k]
        direction = direction * np.sign(direction[np.argmax(np.abs(direction))])
        step = math.log(2) / float(np.max(np.abs(direction)))
        parts = []
        for free, along in zip(self.free, direction, strict=True):
            if abs(along) <= PART:
                continue
            unit = "" if free.unit == "1" else f" {free.unit}"
            parts.append(
                f"{free.name} times {math.exp(along * step):.3g}"
                if free.log
                else f"{free.name} {along * step * free.scale:+.3g}{unit}"
            )
        effect = self.singular_values[k] * step
        return (
            f"{' with '.join(parts)} changes what is measured by {effect:.2g} standard deviations of its noise in all"
        )


def identified(jacobian: Array, free: Sequence[Free]) -> Identified:
    """Return what a Jacobian (n, k) of residuals over the noise, on the scale of the search, identifies."""
    k = len(free)
    padded = np.vstack([jacobian, np.zeros((max(k - len(jacobian), 0), k))])
    _, s, turned = np.linalg.svd(padded, full_matrices=False)
    determined = (s >= IDENTIFIED) & (s > RANK * (s[0] if len(s) else 0.0))
    return Identified(tuple(free), s, turned.T, determined)


# ----------------------------------------------------------------------------------------------------------------------


LEVEL = 0.95
NEAR = 1e-6  # of a range: an estimate so close to an end is at it
BAD = 0.25  # of the scale of the search: standard deviations above are no matter of curvature alone
FIRST = 0.1  # of the scale of the search: farthest that the end of a profile is sought at first
SAME = 0.01  # of an interval: how well its ends by a profile are known
EVALUATIONS = 12  # most points of a profile on one side


@dataclass(frozen=True)
class Interval:
    """Confidence interval low..high [SI] at 95 %, and how it was obtained.

    open_low, open_high    the data do not end it there: it ends with the range that was searched
    """

    low: float
    high: float
    how: str
    open_low: bool = False
    open_high: bool = False


def intervals(
    search: Search, estimate: Estimate, known: Identified, profile: bool | str
) -> tuple[list[Interval], list[str]]:
    """Return the interval of everything free, in the order of x, and what to heed.

    profile    "auto": of what is badly identified, at an end of its range, or in an unidentifiable combination; True: of all
    """
    from scipy.stats import norm, t  # slow to import

    warnings: list[str] = []
    stated, freedom = not np.any(np.isnan(search.stated[estimate.used])), len(estimate.residuals) - len(estimate.x)
    quantile = float(norm.ppf((1 + LEVEL) / 2) if stated else t.ppf((1 + LEVEL) / 2, max(freedom, 1)))
    errors = np.sqrt(np.diag(known.covariance))
    noise = "the stated noise" if stated else "the noise seen in the residuals"
    made = []
    for j, free in enumerate(search.forward.searched):
        x, low, high = float(estimate.x[j]), float(search.low[j]), float(search.high[j])
        half = quantile * float(errors[j])
        ends = x - half, x + half
        bad = known.concerned(j) or errors[j] > BAD or ends[0] < low or ends[1] > high or not errors[j] > 0
        quantity = j < len(search.forward.free)
        if (profile is True and quantity) or (profile == "auto" and bad and quantity):
            made.append(_profile(search, estimate, j, half, quantile**2, noise, warnings))
            continue
        how = f"linear: curvature of the least squares at the best fit, {noise}"
        if known.concerned(j) or not errors[j] > 0:
            how, ends = "none: it is in a combination that the data do not identify", (low, high)
        made.append(
            Interval(
                free.outer(max(ends[0], low)),
                free.outer(min(ends[1], high)),
                how,
                ends[0] <= low,
                ends[1] >= high,
            )
        )
    return made, warnings


def _profile(
    search: Search, estimate: Estimate, j: int, half: float, rise: float, noise: str, warnings: list[str]
) -> Interval:
    """Return where the least squares, all else fitted anew, rise by the quantile of chi-squared.

    half    width by curvature, to either side: where the end is sought first
    """
    free = search.forward.searched[j]
    ends, is_open = [], []
    for bound in (float(search.low[j]), float(search.high[j])):
        place, opened = _end(search, estimate, j, bound, half, rise, warnings)
        ends.append(free.outer(place))
        is_open.append(opened)
    how = f"profile likelihood: the least squares, all else fitted anew, rise by {rise:.3g}, {noise}"
    return Interval(min(ends), max(ends), how, is_open[0], is_open[1])


def _end(
    search: Search, estimate: Estimate, j: int, bound: float, half: float, rise: float, warnings: list[str]
) -> tuple[float, bool]:
    from scipy.optimize import brentq  # slow to import

    x = float(estimate.x[j])
    if abs(bound - x) <= NEAR * (search.high[j] - search.low[j]):
        return bound, True
    warm = {x: estimate.x}

    def excess(place: float) -> float:
        nearest = min(warm, key=lambda other: abs(other - place))
        start = warm[nearest].copy()
        start[j] = place
        least = search.least(start, estimate.used, estimate.sigma, fixed=j)
        warm[place] = least.x
        if least.cost < estimate.cost - 0.01 * rise:
            name = search.forward.searched[j].name
            warnings.append(f"a better fit was met on the profile of {name}: more starts")
        return math.sqrt(max(least.cost - estimate.cost, 0.0)) - math.sqrt(rise)

    near, step = x, min(half, FIRST) if half > 0 else FIRST
    while True:
        far = bound if step >= abs(bound - x) else x + math.copysign(step, bound - x)
        above = excess(far)
        if abs(above) <= SAME * math.sqrt(rise):
            return far, False
        if above > 0:
            break
        if far == bound:
            return bound, True
        near, step = far, 3 * step
    below = -math.sqrt(rise) if near == x else excess(near)
    if below >= 0:
        return near, False
    tolerance = SAME * abs(far - x)
    place = brentq(
        lambda p: -math.sqrt(rise) if p == x else excess(p), near, far, xtol=tolerance, maxiter=EVALUATIONS, disp=False
    )
    return float(place), False
