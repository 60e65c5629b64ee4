"""Integrators of the slider-crank with clearance at equal error, against the quadruple-precision reference.

The error of a run scatters by a factor of about three around a line over the tolerance, for its impacts amplify every rounding; one tolerance
alone may be lucky. So every side has the error of a tolerance smoothed, by the median over half a decade of tolerances to each side, and takes the
loosest tolerance from which on the smoothed error keeps to the target, between two tolerances by interpolation of the logarithms.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from statistics import median

import numpy as np
from benchmarks.ratios import Measurement, decades

from reference.slider_crank import SliderCrank, reference

ERROR_AT = 0.010  # s
DURATION = 0.024  # s, two revolutions: what is timed
TARGETS = (2e-3, 5e-5, 1e-6)
STEPS = 8  # tolerances to a decade


@dataclass(frozen=True)
class Contender:
    """An integrator of the mechanism.

    state: (duration, tolerance) -> (theta, x, theta', x') at the end; raises ArithmeticError where it fails
    time: tolerance -> the measurement of two revolutions
    """

    name: str
    friction: bool
    state: Callable[[float, float], Sequence[float]]
    time: Callable[[float], Measurement]
    tolerances: Sequence[float] = decades(2, 12, STEPS)

    @cached_property
    def errors(self) -> tuple[float, ...]:
        """Error of each tolerance; infinite where the integrator fails."""
        return tuple(self._error(tolerance) for tolerance in self.tolerances)

    def _error(self, tolerance: float) -> float:
        try:
            return reference(self.friction).error(ERROR_AT, tuple(self.state(ERROR_AT, tolerance)))
        except ArithmeticError:
            return np.inf

    def tolerance_for(self, target: float) -> float | None:
        """Tolerance whose smoothed error is the target; None if no tolerance keeps to it."""
        per_decade = round(1 / np.log10(self.tolerances[0] / self.tolerances[1]))
        return crossing(self.tolerances, self.errors, target, reach=per_decade // 2)


def crossing(tolerances: Sequence[float], errors: Sequence[float], target: float, reach: int) -> float | None:
    """Where errors, smoothed by the median over `reach` neighbours to each side, rise through the target for the last time, from tight to loose."""
    smooth = []
    for i in range(len(errors)):
        side = min(reach, i, len(errors) - 1 - i)  # symmetric: the median of a slope is its middle
        smooth.append(median(errors[i - side : i + side + 1]))
    above = [i for i, error in enumerate(smooth) if not error <= target]
    if not above:
        return tolerances[0]
    i = above[-1]
    if i + 1 == len(smooth):
        return None
    outer, inner = smooth[i], smooth[i + 1]
    part = np.log(target / inner) / np.log(outer / inner) if np.isfinite(outer) else 0.0
    return float(tolerances[i + 1] * (tolerances[i] / tolerances[i + 1]) ** part)


def absolute(t: float, state: Sequence[float]) -> tuple[float, float, float, float]:
    """From the crank pin's relative angle and speed, as generated models have them, to the rod's absolute ones."""
    angle, travel, turning, speed = state
    w = SliderCrank().w
    return angle + w * t, travel, turning + w, speed
