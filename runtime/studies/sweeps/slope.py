"""Slope of an output over the rows of a sweep: by regression, where no run has a derivative."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

CONFIDENCE = 0.95
CURVED = 6  # different values from which a parabola is fitted, else a line
FREE = 3  # least rows beyond the coefficients


@dataclass(frozen=True)
class Slope:
    """Derivative of an output at a value, with its 95 % interval value +- half_width, in `unit`, SI.

    at      where; rows    how many it comes from; how    by what
    """

    name: str
    unit: str
    value: float
    half_width: float
    at: float
    rows: int
    how: str

    def __str__(self) -> str:
        return (
            f"{self.name} = {self.value:.4g} +- {self.half_width:.2g} {self.unit}; {self.how} over {self.rows:,} rows"
        )


def slope_of(
    name: str, unit: str, x: np.ndarray, y: np.ndarray, others: Sequence[np.ndarray] = (), at: float | None = None
) -> Slope:
    """Return the derivative of y (n,) by x (n,) by least squares; raises ValueError for too few rows.

    others    further numbers (n,) that y depends on, linearly

    Student's t from the scatter of the rows about the curve: what the curve misses widens the interval.
    """
    others = [other for other in others if np.ptp(other) > 0]
    curved = len(np.unique(x)) >= CURVED
    coefficients = 2 + curved + len(others)
    if len(np.unique(x)) < 2 or len(x) < coefficients + FREE:
        raise ValueError(f"{len(x)} rows with {len(np.unique(x))} values, at least {coefficients + FREE} with several")
    middle, half = (x.max() + x.min()) / 2, np.ptp(x) / 2
    at = middle if at is None else at
    z, there = (x - middle) / half, (at - middle) / half
    design = np.column_stack(
        [np.ones(len(x)), z, *([z**2] if curved else []), *((o - o.mean()) / np.ptp(o) for o in others)]
    )
    direction = np.zeros(coefficients)
    direction[1] = 1 / half
    if curved:
        direction[2] = 2 * there / half
    best, *_ = np.linalg.lstsq(design, y, rcond=None)
    left, freedom = y - design @ best, len(y) - coefficients
    variance = float(left @ left) / freedom * float(direction @ np.linalg.pinv(design.T @ design) @ direction)
    return Slope(
        name=name,
        unit=unit,
        value=float(direction @ best),
        half_width=_student(freedom) * math.sqrt(variance),
        at=float(at),
        rows=len(x),
        how=f"95 % interval by Student's t, of a {'parabola' if curved else 'line'} fitted",
    )


def _student(freedom: int) -> float:
    from scipy.special import stdtrit  # slow to import

    return float(stdtrit(freedom, (1 + CONFIDENCE) / 2))
