"""Identifiability: singular values of the scaled Jacobian, and unidentifiable combinations."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hertzwerk.runtime.engine.model.free_quantities import Free
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
        covariance: Array = (v / s**2) @ v.T
        return covariance

    @property
    def correlation(self) -> Array:
        """Correlation of the estimates (k, k); nan beside one of an unidentifiable combination."""
        covariance = self.covariance
        sizes = np.array([math.nan if self.concerned(j) else math.sqrt(v) for j, v in enumerate(np.diag(covariance))])
        correlation: Array = covariance / np.outer(sizes, sizes)
        return correlation

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
